// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file raster.h
/// Paint a drawing into pixels with anti-aliasing.
///
/// Strokes: the coverage of a pixel follows from its distance to the nearest piece of the line.
/// Pieces that overlap at joints therefore do not darken them. Fills: exact horizontal coverage on
/// 4 sub-lines per pixel row, nonzero winding rule. Text: outlines of font.h.

#include "draw/drawing.h"

#include <cstdint>
#include <vector>

namespace hawser::draw {

/// Opaque picture, 3 bytes (red, green, blue) per pixel, rows from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// Paint a drawing into an image. @param scale  Pixels per point; 2 is sharp on dense screens and
/// in print.
[[nodiscard]] Image rasterise(const Drawing& drawing, double scale = 2.0);

}  // namespace hawser::draw
