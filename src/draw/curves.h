// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file curves.h
/// Draw curves over the time of a recording whose run may have gone back.

#include "draw/axes.h"
#include "record/series.h"

#include <vector>

namespace hawser::draw {

/// Return the continuous parts of a curve as points, thinned to the resolution of the picture.
/// @param factor  Conversion from the unit of the values to that of the axis.
[[nodiscard]] std::vector<std::vector<Point>> curve_parts(const Axes& axes,
                                                          const record::Series& series,
                                                          const std::vector<double>& values,
                                                          double factor);

}  // namespace hawser::draw
