// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file polish.h
/// Refinement of an approximate normal of two convex cores.

#include "collide/narrow/convex.h"

namespace hawser::collide::narrow {

struct Separation {
    V3 n;      ///< Unit normal from a to b.
    double s;  ///< Signed distance of the cores [m].
};

/// Return the signed distance s(n) of two cores along a unit normal n [m]; negative: they overlap.
double separation_along(const Convex& a, const Convex& b, const V3& n);

/// Improve a guess of the contact normal: find the normal with the largest separation s(n) near it.
/// Candidates are normals of faces near the guess and normals perpendicular to edges near it. On
/// curved cores Newton's method on the sphere is used. The result is at least as good as the guess.
/// @param most  Upper bound [m]; the search stops there.
Separation polish(const Convex& a, const Convex& b, const V3& guess, double most);

}  // namespace hawser::collide::narrow
