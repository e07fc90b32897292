// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file curves.h
/// Curves over the time of a recording, whose runs may have gone back.

#include "draw/axes.h"
#include "record/series.h"

#include <vector>

namespace hawser::draw {

/// Points of the lines that make up a curve, thinned each (record::stretches()).
/// @param factor  From the unit of the values to that of the axis.
[[nodiscard]] std::vector<std::vector<Point>> curve_parts(const Axes& axes,
                                                          const record::Series& series,
                                                          const std::vector<double>& values,
                                                          double factor);

}  // namespace hawser::draw
