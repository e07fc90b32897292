// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file polish.h
/// From a normal near that of two convex cores to the one itself.

#include "collide/narrow/convex.h"

namespace hawser::collide::narrow {

struct Separation {
    V3 n;      ///< Unit, from a to b.
    double s;  ///< Signed distance of the cores [m].
};

/// Signed distance of two cores along a unit normal n, s(n) [m]; negative: they overlap.
double separation_along(const Convex& a, const Convex& b, const V3& n);

/// The largest s(n) near a good guess: over the normals of faces near it, normals perpendicular
/// to edges near it, and, on curved cores, Newton's method on the sphere. It never gets worse,
/// and stops at `most`, a known upper bound [m].
Separation polish(const Convex& a, const Convex& b, const V3& guess, double most);

}  // namespace hawser::collide::narrow
