// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gjk.h
/// Distance of two convex cores that are apart (E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A
/// fast procedure for computing the distance between complex objects in three-dimensional space",
/// IEEE J. Robotics and Automation 4, 1988).

#include "collide/narrow/convex.h"

namespace hawser::collide::narrow {

struct GjkResult {
    bool apart;       ///< False: they overlap, or are nearer than 1e-10 of their size.
    V3 n;             ///< Unit, from a to b; valid when apart.
    double distance;  ///< Of the cores [m]; a lower bound when it exceeds `enough`.
};

/// Stops early once the distance is known to exceed `enough` [m].
GjkResult gjk(const Convex& a, const Convex& b, double enough);

}  // namespace hawser::collide::narrow
