// SPDX-License-Identifier: Apache-2.0
#include "draw/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hawser::draw {

namespace {

// Format a coordinate. Hundredths of a point are finer than any screen; whole numbers have no
// decimals.
std::string coordinate(double value) {
    if (!std::isfinite(value)) return "0";
    constexpr double kMaxCoordinate =
        1e7;  // Larger coordinates are not visible, and readers use floats.
    std::string text = fmt::format("{:.2f}", std::clamp(value, -kMaxCoordinate, kMaxCoordinate));
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string paint(const char* attribute, Color c) {
    if (c.a == 0) return fmt::format(" {}=\"none\"", attribute);
    std::string out = fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", attribute, c.r, c.g, c.b);
    if (c.a != 255) out += fmt::format(" {}-opacity=\"{:.3f}\"", attribute, c.a / 255.0);
    return out;
}

struct Writer {
    std::string& out;
    bool clipped = false;

    // Begin or end a clip. An inner <svg> shows nothing outside its own box.
    void operator()(const Clip& clip) {
        if (clipped) out += "</svg>\n";
        clipped = clip.box.has_value();
        if (clipped)
            out += fmt::format(
                "<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" "
                "viewBox=\"{0} {1} {2} {3}\">\n",
                coordinate(clip.box->x), coordinate(clip.box->y), coordinate(clip.box->width),
                coordinate(clip.box->height));
    }

    void operator()(const Path& path) const {
        if (path.points.empty()) return;
        out += "<path d=\"";
        char verb = 'M';
        for (const Point p : path.points) {
            fmt::format_to(std::back_inserter(out), "{}{} {}", verb, coordinate(p.x),
                           coordinate(p.y));
            verb = 'L';
        }
        out += path.closed ? "Z\"" : "\"";
        out += paint("fill", path.fill);
        if (path.width > 0.0 && path.stroke.a != 0) {
            out += paint("stroke", path.stroke);
            out += fmt::format(" stroke-width=\"{}\"", coordinate(path.width));
            if (!path.dash.empty()) {
                out += " stroke-dasharray=\"";
                for (std::size_t i = 0; i < path.dash.size(); ++i)
                    out += (i == 0 ? "" : " ") + coordinate(path.dash[i]);
                out += "\"";
            }
        }
        out += "/>\n";
    }

    void operator()(const Cells& cells) const {
        if (cells.boxes.empty()) return;
        out += "<path d=\"";
        for (const Box& b : cells.boxes)
            fmt::format_to(std::back_inserter(out), "M{} {}h{}v{}h{}z", coordinate(b.x),
                           coordinate(b.y), coordinate(b.width), coordinate(b.height),
                           coordinate(-b.width));
        out += "\"" + paint("fill", cells.fill) + "/>\n";
    }

    void operator()(const Text& text) const {
        static constexpr const char* kAnchorNames[] = {"start", "middle", "end"};
        out += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"", coordinate(text.at.x),
                           coordinate(text.at.y), coordinate(text.size));
        if (text.anchor != Anchor::start)
            out += fmt::format(" text-anchor=\"{}\"", kAnchorNames[static_cast<int>(text.anchor)]);
        if (text.bold) out += " font-weight=\"bold\"";
        if (text.turn != 0.0)
            out += fmt::format(" transform=\"rotate({} {} {})\"", coordinate(text.turn),
                               coordinate(text.at.x), coordinate(text.at.y));
        out += paint("fill", text.color);
        if (text.halo)
            out += fmt::format(" stroke=\"#ffffff\" stroke-width=\"{}\" paint-order=\"stroke\"",
                               coordinate(0.28 * text.size));
        out += ">" + escape_xml(text.text) + "</text>\n";
    }
};

}  // namespace

std::string escape_xml(const std::string& text) {
    std::string out;
    for (const char32_t code : decode_utf8(text)) {
        switch (code) {
            case U'&':
                out += "&amp;";
                break;
            case U'<':
                out += "&lt;";
                break;
            case U'>':
                out += "&gt;";
                break;
            case U'"':
                out += "&quot;";
                break;
            case U'\'':
                out += "&#39;";
                break;
            default:
                // XML 1.0 cannot represent most control characters.
                if (code < 0x20 && code != U'\t')
                    out += ' ';
                else if (code < 0x7F)
                    out += static_cast<char>(code);
                else if (code != 0xFFFE && code != 0xFFFF && (code < 0xD800 || code > 0xDFFF))
                    out += fmt::format("&#{};", static_cast<std::uint32_t>(code));
        }
    }
    return out;
}

std::string to_svg(const Drawing& drawing) {
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out += fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"Roboto, Helvetica, Arial, sans-serif\" "
        "stroke-linejoin=\"round\" stroke-linecap=\"round\">\n",
        coordinate(drawing.width), coordinate(drawing.height));
    out += "<title>" + escape_xml(drawing.title) + "</title>\n";
    out += "<desc>" + escape_xml(drawing.description) + "</desc>\n";
    out += fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n",
                       coordinate(drawing.width), coordinate(drawing.height));
    Writer writer{out};
    for (const Shape& shape : drawing.shapes) std::visit(writer, shape);
    writer(Clip{});
    return out + "</svg>\n";
}

}  // namespace hawser::draw
