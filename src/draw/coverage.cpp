// SPDX-License-Identifier: Apache-2.0
#include "draw/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::draw {

namespace {

Coverage window(const std::vector<Polyline>& lines, double margin, int limit_x, int limit_y) {
    double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;
    for (const Polyline& line : lines) {
        for (const Point p : line) {
            if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {};
            x0 = std::min(x0, p.x);
            x1 = std::max(x1, p.x);
            y0 = std::min(y0, p.y);
            y1 = std::max(y1, p.y);
        }
    }
    const auto clip = [](double v, int limit) {
        return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(limit)));
    };
    Coverage c;
    if (!(x0 <= x1)) return c;
    c.x = clip(std::floor(x0 - margin), limit_x);
    c.y = clip(std::floor(y0 - margin), limit_y);
    c.width = clip(std::ceil(x1 + margin), limit_x) - c.x;
    c.height = clip(std::ceil(y1 + margin), limit_y) - c.y;
    if (c.width <= 0 || c.height <= 0) return {};
    c.value.assign(static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height), 0.0f);
    return c;
}

// Add the coverage of one straight piece: 1 inside, falling to 0 over one pixel around the edge.
void cover_segment(Coverage& c, Point a, Point b, double half) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double length2 = dx * dx + dy * dy;
    const double reach = half + 1.0;
    // Clamp before the conversion: coordinates far outside the picture exceed the range of int.
    const auto row_of = [&](double y) {
        return static_cast<int>(std::clamp(y, c.y - 1.0, static_cast<double>(c.y + c.height)));
    };
    const auto column_of = [&](double x) {
        return static_cast<int>(std::clamp(x, c.x - 1.0, static_cast<double>(c.x + c.width)));
    };
    const int y_first = std::max(c.y, row_of(std::floor(std::min(a.y, b.y) - reach)));
    const int y_last = std::min(c.y + c.height - 1, row_of(std::ceil(std::max(a.y, b.y) + reach)));
    for (int y = y_first; y <= y_last; ++y) {
        const double py = y + 0.5;
        double from = std::min(a.x, b.x) - reach, to = std::max(a.x, b.x) + reach;
        if (std::abs(dy) > 1e-6) {
            // Only the part of the row near the infinite line can be covered.
            const double across = reach * std::sqrt(length2) / std::abs(dy);
            const double at = a.x + (py - a.y) / dy * dx;
            from = std::max(from, at - across);
            to = std::min(to, at + across);
        }
        const int x_first = std::max(c.x, column_of(std::floor(from)));
        const int x_last = std::min(c.x + c.width - 1, column_of(std::ceil(to)));
        float* row = c.value.data() + static_cast<std::ptrdiff_t>(y - c.y) * c.width;
        for (int x = x_first; x <= x_last; ++x) {
            const double rx = x + 0.5 - a.x, ry = py - a.y;
            const double t =
                length2 > 0.0 ? std::clamp((rx * dx + ry * dy) / length2, 0.0, 1.0) : 0.0;
            const double distance = std::hypot(rx - t * dx, ry - t * dy);
            const double cover = std::clamp(half + 0.5 - distance, 0.0, 1.0);
            row[x - c.x] = std::max(row[x - c.x], static_cast<float>(cover));
        }
    }
}

constexpr int kSubLines = 4;

struct Crossing {
    double x;
    int direction;
};

// Add the horizontal run [from, to) of one sub-line to a pixel row. Partially covered pixels count
// by their fraction.
void add_run(float* row, int x0, int width, double from, double to) {
    from = std::clamp(from - x0, 0.0, static_cast<double>(width));
    to = std::clamp(to - x0, 0.0, static_cast<double>(width));
    if (to <= from) return;
    const int first = static_cast<int>(from);
    const int last = std::min(width - 1, static_cast<int>(to));
    for (int x = first; x <= last; ++x) {
        const double fraction = std::min(to, x + 1.0) - std::max(from, static_cast<double>(x));
        row[x] += static_cast<float>(fraction / kSubLines);
    }
}

void add_crossings(const Polyline& contour, double y, std::vector<Crossing>& out) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const Point a = contour[i];
        const Point b = contour[(i + 1) % contour.size()];
        if ((a.y <= y) == (b.y <= y)) continue;
        out.push_back({a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1});
    }
}

}  // namespace

Coverage cover_stroke(const std::vector<Polyline>& lines, double width, int limit_x, int limit_y) {
    const double half = 0.5 * width;
    Coverage c = window(lines, half + 1.0, limit_x, limit_y);
    if (c.value.empty()) return c;
    for (const Polyline& line : lines) {
        if (line.size() == 1) cover_segment(c, line[0], line[0], half);
        for (std::size_t i = 1; i < line.size(); ++i) cover_segment(c, line[i - 1], line[i], half);
    }
    return c;
}

Coverage cover_polygons(const std::vector<Polyline>& contours, int limit_x, int limit_y) {
    Coverage c = window(contours, 1.0, limit_x, limit_y);
    std::vector<Crossing> crossings;
    for (int sub = 0; sub < c.height * kSubLines; ++sub) {
        crossings.clear();
        const double y = c.y + (sub + 0.5) / kSubLines;
        for (const Polyline& contour : contours) add_crossings(contour, y, crossings);
        std::sort(crossings.begin(), crossings.end(),
                  [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
        float* row = c.value.data() + static_cast<std::ptrdiff_t>(sub / kSubLines) * c.width;
        int winding = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            winding += crossings[i].direction;
            if (winding != 0) add_run(row, c.x, c.width, crossings[i].x, crossings[i + 1].x);
        }
    }
    return c;
}

std::vector<Polyline> cut_dashes(const Polyline& line, const std::vector<double>& dash) {
    double period = 0.0;
    for (const double d : dash) period += std::max(0.0, d);
    // Limit for very long lines, which would need too many dashes to be visible.
    constexpr double kMaxPeriods = 1e5;
    double length_all = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length_all += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    if (line.size() < 2 || !(period > 0.0) || !(length_all < kMaxPeriods * period)) return {line};
    std::vector<Polyline> out;
    std::size_t which = 0;
    double left = dash[0];
    Polyline now{line[0]};
    for (std::size_t i = 1; i < line.size(); ++i) {
        Point a = line[i - 1];
        const Point b = line[i];
        double length = std::hypot(b.x - a.x, b.y - a.y);
        while (length > left) {
            a = {a.x + (b.x - a.x) * left / length, a.y + (b.y - a.y) * left / length};
            length -= left;
            if (which % 2 == 0) {
                now.push_back(a);
                out.push_back(std::move(now));
            }
            now = {a};
            which = (which + 1) % dash.size();
            left = std::max(dash[which], 1e-3);  // A zero length must not stop the loop.
        }
        left -= length;
        now.push_back(b);
    }
    if (which % 2 == 0) out.push_back(std::move(now));
    return out;
}

}  // namespace hawser::draw
