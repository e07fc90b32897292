// SPDX-License-Identifier: Apache-2.0
#include "draw/axes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::draw {

namespace {

constexpr double kNumberSize = 12.0;
constexpr double kLabelSize = 13.0;

}  // namespace

void Axes::draw(Drawing& drawing) const {
    const std::vector<double> xs = ticks(x, x_ticks), ys = ticks(y, y_ticks);
    const double x_step = xs.size() > 1 ? xs[1] - xs[0] : std::abs(x.span());
    const double y_step = ys.size() > 1 ? ys[1] - ys[0] : std::abs(y.span());
    for (const double v : xs) {
        const double px = at(v, y.low).x;
        drawing.line({px, frame.y}, {px, frame.bottom()}, kGrid);
        drawing.line({px, frame.bottom()}, {px, frame.bottom() + 5}, kSoft);
        if (x_numbers)
            drawing.text({px, frame.bottom() + 19}, tick_label(v, x_step), kNumberSize,
                         Anchor::middle, kSoft);
    }
    double widest = 0.0;
    for (const double v : ys) {
        const double py = at(x.low, v).y;
        drawing.line({frame.x, py}, {frame.right(), py}, kGrid);
        drawing.line({frame.x - 5, py}, {frame.x, py}, kSoft);
        const std::string label = tick_label(v, y_step);
        widest = std::max(widest, text_width(label, kNumberSize));
        drawing.text({frame.x - 9, py + 4.3}, label, kNumberSize, Anchor::end, kSoft);
    }
    drawing.box(frame, kNoColor, Color{150, 157, 166, 255}, 1.2);
    if (!x_label.empty())
        drawing.text({frame.x + 0.5 * frame.width, frame.bottom() + 40}, x_label, kLabelSize,
                     Anchor::middle);
    if (!y_label.empty())
        drawing.add(Text{.at = {frame.x - 20 - widest, frame.y + 0.5 * frame.height},
                         .text = y_label,
                         .size = kLabelSize,
                         .anchor = Anchor::middle,
                         .turn = -90.0});
    if (!title.empty())
        drawing.text({frame.x, frame.y - 9}, title, 14.5, Anchor::start, kInk, true);
}

std::vector<Point> thinned(const Axes& axes, std::span<const double> x, std::span<const double> y) {
    std::vector<Point> out;
    const std::size_t n = std::min(x.size(), y.size());
    // Half a point is one pixel column at the usual scale of 2.
    const auto column = [&](std::size_t i) { return std::floor(2.0 * axes.at(x[i], 0.0).x); };
    for (std::size_t i = 0; i < n;) {
        std::size_t low = i, high = i, last = i;
        for (; last < n && column(last) == column(i); ++last) {
            if (y[last] < y[low]) low = last;
            if (y[last] > y[high]) high = last;
        }
        std::array<std::size_t, 4> keep{i, std::min(low, high), std::max(low, high), last - 1};
        for (std::size_t k = 0; k < keep.size(); ++k)
            if (std::isfinite(y[keep[k]]) && (k == 0 || keep[k] > keep[k - 1]))
                out.push_back(axes.at(x[keep[k]], y[keep[k]]));
        i = last;
    }
    return out;
}

Color curve_color(std::size_t index) {
    static constexpr std::array<Color, 9> kColors{{{0, 114, 178, 255},
                                                   {213, 94, 0, 255},
                                                   {0, 158, 115, 255},
                                                   {204, 121, 167, 255},
                                                   {86, 180, 233, 255},
                                                   {230, 159, 0, 255},
                                                   {90, 70, 160, 255},
                                                   {120, 120, 120, 255},
                                                   {140, 30, 50, 255}}};
    return kColors[index % kColors.size()];
}

Color scale_color(double t) {
    // Colours close to the "plasma" map without its yellow end.
    static constexpr std::array<Color, 6> kColorMapPoints{{{20, 40, 140, 255},
                                                           {90, 10, 165, 255},
                                                           {160, 25, 155, 255},
                                                           {210, 60, 110, 255},
                                                           {240, 110, 60, 255},
                                                           {248, 165, 35, 255}}};
    const double s =
        std::isfinite(t) ? std::clamp(t, 0.0, 1.0) * (kColorMapPoints.size() - 1.0) : 0.0;
    const std::size_t i =
        std::min<std::size_t>(static_cast<std::size_t>(s), kColorMapPoints.size() - 2);
    const double f = s - static_cast<double>(i);
    const auto mix = [f](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(a + f * (b - a)));
    };
    const Color a = kColorMapPoints[i], b = kColorMapPoints[i + 1];
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255};
}

double draw_legend(Drawing& drawing, Point at, std::span<const LegendEntry> entries) {
    double y = at.y;
    for (const LegendEntry& entry : entries) {
        drawing.line({at.x, y - 4.5}, {at.x + 26, y - 4.5}, entry.color, 3.0, entry.dash);
        drawing.text({at.x + 34, y}, entry.name, 13.0);
        y += 16.0;
        if (!entry.note.empty()) {
            drawing.text({at.x + 34, y}, entry.note, 11.0, Anchor::start, kSoft);
            y += 15.0;
        }
        y += 5.0;
    }
    return y - at.y;
}

void draw_color_bar(Drawing& drawing, const Box& box, Range range, const std::string& label) {
    constexpr int kLegendBands = 128;
    for (int i = 0; i < kLegendBands; ++i) {
        const double h = box.height / kLegendBands;
        // Bands overlap slightly to avoid hairlines between them.
        drawing.box({box.x, box.bottom() - (i + 1) * h, box.width, h + (i > 0 ? 0.5 : 0.0)},
                    scale_color((i + 0.5) / kLegendBands));
    }
    drawing.box(box, kNoColor, kSoft);
    const std::vector<double> values = ticks(range, 6);
    const double step = values.size() > 1 ? values[1] - values[0] : range.span();
    for (const double v : values) {
        const double y = box.bottom() - (v - range.low) / range.span() * box.height;
        drawing.line({box.right(), y}, {box.right() + 5, y}, kSoft);
        drawing.text({box.right() + 9, y + 4.3}, tick_label(v, step), kNumberSize, Anchor::start,
                     kSoft);
    }
    drawing.text({box.x, box.y - 12}, label, kLabelSize);
}

void draw_heading(Drawing& drawing, const std::string& title, const std::string& parameters) {
    drawing.title = title;
    drawing.description = parameters;
    drawing.text({28, 38}, title, 22.0, Anchor::start, kInk, true);
    // Long parameter lines shrink to the width of the picture.
    const double size =
        std::min(12.5, 12.5 * (drawing.width - 56) / std::max(1.0, text_width(parameters, 12.5)));
    drawing.text({28, 60}, parameters, size, Anchor::start, kSoft);
}

}  // namespace hawser::draw
