// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drawing.h
/// A picture as a list of shapes, which becomes an SVG (svg.h) or a PNG (raster.h, png.h).
///
/// Both writers read the same list, so the two files show the same picture. Coordinates are
/// in points of 1/96 inch: x to the right, y downwards, the origin at the top left.

#include "draw/point.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hawser::draw {

struct Color {
    std::uint8_t r = 0, g = 0, b = 0;
    std::uint8_t a = 255;  ///< 0 = invisible, 255 = opaque.
    [[nodiscard]] constexpr Color with_alpha(int alpha) const noexcept {
        return {r, g, b, static_cast<std::uint8_t>(alpha)};
    }
};

inline constexpr Color kNoColor{0, 0, 0, 0};
inline constexpr Color kInk{32, 36, 42, 255};     ///< Text and frames.
inline constexpr Color kSoft{96, 104, 114, 255};  ///< Secondary text.
inline constexpr Color kGrid{226, 230, 235, 255};
inline constexpr Color kWhite{255, 255, 255, 255};

/// A line through points, or a polygon when closed. Joints and ends are round.
struct Path {
    std::vector<Point> points;
    Color stroke = kInk;
    double width = 1.0;  ///< Of the stroke; 0 = no stroke.
    Color fill = kNoColor;
    bool closed = false;
    std::vector<double> dash{};  ///< Lengths drawn and skipped in turn; empty = solid.
};

/// Many boxes of one colour, without outline.
struct Cells {
    std::vector<Box> boxes;
    Color fill = kInk;
};

enum class Anchor : std::uint8_t { start, middle, end };

/// One line of text, UTF-8.
struct Text {
    Point at;  ///< On the base line; which point of the text it is: `anchor`.
    std::string text;
    double size = 12.0;  ///< Em.
    Anchor anchor = Anchor::start;
    double turn = 0.0;  ///< Rotation about `at`, clockwise [deg].
    bool bold = false;
    Color color = kInk;
    bool halo = false;  ///< Outlined in white, readable on top of lines.
};

/// Limits what is painted from here on to a box; without a box, to the whole picture.
struct Clip {
    std::optional<Box> box{};
};

using Shape = std::variant<Path, Cells, Text, Clip>;

/// A picture. Shapes are painted in order.
struct Drawing {
    double width = 1200.0, height = 800.0;
    std::string title{};        ///< SVG <title>: what it shows.
    std::string description{};  ///< SVG <desc>: parameters.
    std::vector<Shape> shapes{};

    void add(Shape shape);
    void line(Point a, Point b, Color color, double width_ = 1.0, std::vector<double> dash = {}) {
        add(Path{.points = {a, b}, .stroke = color, .width = width_, .dash = std::move(dash)});
    }
    void box(const Box& b, Color fill, Color stroke = kNoColor, double width_ = 1.0);
    void text(Point at, std::string text, double size, Anchor anchor = Anchor::start,
              Color color = kInk, bool bold = false);
};

/// Width of a line of text [points] in the typeface of the PNG pictures.
[[nodiscard]] double text_width(const std::string& text, double size, bool bold = false);

/// Code points of UTF-8 text; malformed bytes become U+FFFD.
[[nodiscard]] std::vector<char32_t> decode_utf8(const std::string& text);

}  // namespace hawser::draw
