// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coverage.h
/// Compute the fraction of each pixel that a stroke or a polygon covers.

#include "draw/drawing.h"

#include <vector>

namespace hawser::draw {

/// Coverage 0-1 of the pixels in a window of the picture.
struct Coverage {
    int x = 0, y = 0, width = 0, height = 0;  ///< Window [pixels].
    std::vector<float> value;                 ///< Rows from the top.
};

using Polyline = std::vector<Point>;

/// Return the coverage of a stroke with round joints and ends. Coordinates in pixels.
/// @param limit_x,limit_y Size of the picture; nothing outside is computed.
[[nodiscard]] Coverage cover_stroke(const std::vector<Polyline>& lines, double width, int limit_x,
                                    int limit_y);

/// Return the coverage of polygons by the nonzero rule. Coordinates in pixels.
[[nodiscard]] Coverage cover_polygons(const std::vector<Polyline>& contours, int limit_x,
                                      int limit_y);

/// Divide a line into its dashes.
[[nodiscard]] std::vector<Polyline> cut_dashes(const Polyline& line,
                                               const std::vector<double>& dash);

}  // namespace hawser::draw
