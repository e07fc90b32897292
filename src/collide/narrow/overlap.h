// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file overlap.h
/// Corners of the overlap of two facing parts, seen along a normal.

#include "collide/narrow/points.h"

namespace hawser::collide::narrow {

/// Add contacts of the cores (without rounding) at the corners of the overlap of `a` and `b`,
/// projected along `n`. Points within `snap` [m] of an edge count as on the edge, so that aligned
/// boxes keep the features of their contacts. @param separation  Gap of points that touch [m].
void overlap(const Poly& a, const Poly& b, const V3& n, double separation, double snap,
             Points& out);

}  // namespace hawser::collide::narrow
