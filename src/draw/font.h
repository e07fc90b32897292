// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file font.h
/// Provide the typeface of PNG pictures: outlines of Roboto Regular from font_table.inc.

#include "draw/point.h"

#include <vector>

namespace hawser::draw {

/// Glyph as polygons in em, y upwards from the base line; filled by the nonzero rule.
struct Glyph {
    double advance = 0.5;  ///< Advance width [em].
    std::vector<std::vector<Point>> contours;
};

/// Return the glyph of a code point; a hollow box if the typeface lacks it.
[[nodiscard]] const Glyph& glyph(char32_t code);

}  // namespace hawser::draw
