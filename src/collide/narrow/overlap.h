// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file overlap.h
/// Corners of the overlap of two facing parts, seen along a normal.

#include "collide/narrow/points.h"

namespace hawser::collide::narrow {

/// Adds contacts of the cores (no rounding) at the corners of the overlap of `a` and `b` seen along
/// `n`. Points within `snap` [m] of an edge count as on it, so that aligned boxes keep the names of
/// their contacts. A point that meets anything lies `separation` from it.
void overlap(const Poly& a, const Poly& b, const V3& n, double separation, double snap,
             Points& out);

}  // namespace hawser::collide::narrow
