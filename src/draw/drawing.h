// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drawing.h
/// Represent a picture as a list of shapes, for output as SVG (svg.h) or PNG (raster.h, png.h).
///
/// Both writers read the same list, so both files show the same picture. Coordinates are in points
/// of 1/96 inch: x to the right, y downwards, the origin at the top left.

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
    std::uint8_t a = 255;  ///< Opacity: 0 = invisible, 255 = opaque.
    [[nodiscard]] constexpr Color with_alpha(int alpha) const noexcept {
        return {r, g, b, static_cast<std::uint8_t>(alpha)};
    }
};

inline constexpr Color kNoColor{0, 0, 0, 0};
inline constexpr Color kInk{32, 36, 42, 255};     ///< Text and frames.
inline constexpr Color kSoft{96, 104, 114, 255};  ///< Secondary text.
inline constexpr Color kGrid{226, 230, 235, 255};
inline constexpr Color kWhite{255, 255, 255, 255};

/// Line through points, or polygon if closed. Joints and ends are round.
struct Path {
    std::vector<Point> points;
    Color stroke = kInk;
    double width = 1.0;  ///< Width of the stroke [points]; 0 = no stroke.
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
    Point at;  ///< Reference point on the base line; `anchor` defines its position in the text.
    std::string text;
    double size = 12.0;  ///< Em size [points].
    Anchor anchor = Anchor::start;
    double turn = 0.0;  ///< Rotation about `at`, clockwise [deg].
    bool bold = false;
    Color color = kInk;
    bool halo = false;  ///< Outlined in white, readable on top of lines.
};

/// Limit of painting: later shapes are clipped to a box, or to the whole picture without a box.
struct Clip {
    std::optional<Box> box{};
};

using Shape = std::variant<Path, Cells, Text, Clip>;

/// Picture with shapes painted in order.
struct Drawing {
    double width = 1200.0, height = 800.0;
    std::string title{};        ///< SVG <title>: subject of the picture.
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

/// Return the width of a line of text [points] in the typeface of the PNG pictures.
[[nodiscard]] double text_width(const std::string& text, double size, bool bold = false);

/// Decode UTF-8 text to code points; malformed bytes become U+FFFD.
[[nodiscard]] std::vector<char32_t> decode_utf8(const std::string& text);

}  // namespace hawser::draw
