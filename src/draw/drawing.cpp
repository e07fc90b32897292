// SPDX-License-Identifier: Apache-2.0
#include "draw/drawing.h"

#include "draw/font.h"

namespace hawser::draw {

void Drawing::add(Shape shape) { shapes.push_back(std::move(shape)); }

void Drawing::box(const Box& b, Color fill, Color stroke, double width_) {
    add(Path{.points = {{b.x, b.y}, {b.right(), b.y}, {b.right(), b.bottom()}, {b.x, b.bottom()}},
             .stroke = stroke,
             .width = stroke.a == 0 ? 0.0 : width_,
             .fill = fill,
             .closed = true});
}

void Drawing::text(Point at, std::string text, double size, Anchor anchor, Color color, bool bold) {
    add(Text{.at = at,
             .text = std::move(text),
             .size = size,
             .anchor = anchor,
             .bold = bold,
             .color = color});
}

std::vector<char32_t> decode_utf8(const std::string& text) {
    std::vector<char32_t> out;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const int more = lead < 0x80   ? 0
                         : lead < 0xC2 ? -1
                         : lead < 0xE0 ? 1
                         : lead < 0xF0 ? 2
                         : lead < 0xF5 ? 3
                                       : -1;
        char32_t code = more == 0 ? lead : lead & (0x3Fu >> (more < 0 ? 0 : more));
        bool good = more >= 0 && i + static_cast<std::size_t>(more) < text.size();
        for (int k = 1; good && k <= more; ++k) {
            const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
            good = (next & 0xC0) == 0x80;
            code = (code << 6) | (next & 0x3Fu);
        }
        out.push_back(good ? code : U'\uFFFD');
        i += good ? static_cast<std::size_t>(more) + 1 : 1;
    }
    return out;
}

double text_width(const std::string& text, double size, bool bold) {
    double width = 0.0;
    for (const char32_t code : decode_utf8(text))
        width += glyph(code).advance + (bold ? 0.02 : 0.0);
    return width * size;
}

}  // namespace hawser::draw
