// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file font.h
/// The typeface of PNG pictures: outlines of Roboto Regular, kept in font_table.inc.

#include "draw/point.h"

#include <vector>

namespace hawser::draw {

/// A glyph as polygons in em, y upwards from the base line; filled by the nonzero rule.
struct Glyph {
    double advance = 0.5;  ///< [em].
    std::vector<std::vector<Point>> contours;
};

/// @return The glyph of a code point; a hollow box where the typeface has none.
[[nodiscard]] const Glyph& glyph(char32_t code);

}  // namespace hawser::draw
