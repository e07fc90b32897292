// SPDX-License-Identifier: Apache-2.0
#include "draw/raster.h"

#include "draw/coverage.h"
#include "draw/font.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::draw {

namespace {

constexpr double kBoldWidth = 0.045;  // Stroke around bold glyphs [em].
constexpr double kHaloWidth = 0.28;   // Outline of text with a halo [em].

std::vector<Polyline> scaled(const std::vector<Polyline>& lines, double s) {
    std::vector<Polyline> out = lines;
    for (Polyline& line : out)
        for (Point& p : line) p = {p.x * s, p.y * s};
    return out;
}

// Return the outlines of the letters of a line of text [pixels].
std::vector<Polyline> outlines(const Text& text, double scale) {
    const double em = text.size * scale;
    double pen = 0.0;
    if (text.anchor != Anchor::start)
        pen = -text_width(text.text, text.size, text.bold) * scale *
              (text.anchor == Anchor::end ? 1.0 : 0.5);
    const double turn = text.turn * std::numbers::pi / 180.0;
    const double c = std::cos(turn), s = std::sin(turn);
    std::vector<Polyline> out;
    for (const char32_t code : decode_utf8(text.text)) {
        const Glyph& g = glyph(code);
        for (const Polyline& contour : g.contours) {
            Polyline placed;
            placed.reserve(contour.size());
            for (const Point p : contour) {
                const double x = pen + p.x * em, y = -p.y * em;
                placed.push_back(
                    {text.at.x * scale + c * x - s * y, text.at.y * scale + s * x + c * y});
            }
            out.push_back(std::move(placed));
        }
        pen += (g.advance + (text.bold ? 0.02 : 0.0)) * em;
    }
    return out;
}

void close_all(std::vector<Polyline>& lines) {
    for (Polyline& line : lines)
        if (!line.empty()) line.push_back(line.front());
}

struct Painter {
    Image& image;
    double scale;
    int x0 = 0, y0 = 0, x1 = image.width, y1 = image.height;  // Clip rectangle [pixels].

    void operator()(const Clip& clip) {
        const Box all{0.0, 0.0, image.width / scale, image.height / scale};
        const Box b = clip.box.value_or(all);
        x0 = std::max(0, static_cast<int>(std::lround(b.x * scale)));
        y0 = std::max(0, static_cast<int>(std::lround(b.y * scale)));
        x1 = std::min(image.width, static_cast<int>(std::lround(b.right() * scale)));
        y1 = std::min(image.height, static_cast<int>(std::lround(b.bottom() * scale)));
    }

    void blend(const Coverage& c, Color color, double strength = 1.0) const {
        const double alpha = strength * color.a / 255.0;
        const std::uint8_t rgb[3] = {color.r, color.g, color.b};
        for (int y = std::max(0, y0 - c.y); y < std::min(c.height, y1 - c.y); ++y) {
            const float* row = c.value.data() + static_cast<std::ptrdiff_t>(y) * c.width;
            std::uint8_t* out =
                image.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(c.y + y) * image.width + c.x);
            const int first = std::max(0, x0 - c.x), last = std::min(c.width, x1 - c.x);
            out += 3 * static_cast<std::ptrdiff_t>(first);
            for (int x = first; x < last; ++x, out += 3) {
                const double a = alpha * std::min(1.0f, row[x]);
                if (a <= 0.0) continue;
                for (int k = 0; k < 3; ++k)
                    out[k] = static_cast<std::uint8_t>(
                        std::lround(out[k] + a * (rgb[k] - static_cast<double>(out[k]))));
            }
        }
    }

    void stroke(const std::vector<Polyline>& lines, double width, Color color) const {
        // A line thinner than a pixel is drawn with one pixel and lower strength.
        const double strength = std::min(1.0, width);
        blend(cover_stroke(lines, std::max(1.0, width), image.width, image.height), color,
              strength);
    }

    void operator()(const Path& path) const {
        if (path.points.empty()) return;
        if (path.fill.a != 0 && path.points.size() > 2)
            blend(cover_polygons(scaled({path.points}, scale), image.width, image.height),
                  path.fill);
        if (path.width > 0.0 && path.stroke.a != 0) {
            Polyline line = path.points;
            if (path.closed) line.push_back(line.front());
            stroke(scaled(cut_dashes(line, path.dash), scale), path.width * scale, path.stroke);
        }
    }

    void operator()(const Cells& cells) const {
        for (const Box& b : cells.boxes)
            blend(cover_polygons(scaled({{{b.x, b.y},
                                          {b.right(), b.y},
                                          {b.right(), b.bottom()},
                                          {b.x, b.bottom()}}},
                                        scale),
                                 image.width, image.height),
                  cells.fill);
    }

    void operator()(const Text& text) const {
        const std::vector<Polyline> fill = outlines(text, scale);
        std::vector<Polyline> edge = fill;
        close_all(edge);
        if (text.halo) stroke(edge, kHaloWidth * text.size * scale, kWhite);
        blend(cover_polygons(fill, image.width, image.height), text.color);
        if (text.bold) stroke(edge, kBoldWidth * text.size * scale, text.color);
    }
};

}  // namespace

Image rasterise(const Drawing& drawing, double scale) {
    Image image;
    image.width = static_cast<int>(std::ceil(drawing.width * scale));
    image.height = static_cast<int>(std::ceil(drawing.height * scale));
    image.rgb.assign(
        3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 255);
    Painter painter{image, scale};
    for (const Shape& shape : drawing.shapes) std::visit(painter, shape);
    return image;
}

}  // namespace hawser::draw
