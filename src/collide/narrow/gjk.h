// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gjk.h
/// Distance of two separate convex cores (E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast
/// procedure for computing the distance between complex objects in three-dimensional space", IEEE
/// J. Robotics and Automation 4, 1988).

#include "collide/narrow/convex.h"

namespace hawser::collide::narrow {

struct GjkResult {
    bool separated;   ///< False if the cores overlap or are nearer than 1e-10 of their size.
    V3 n;             ///< Unit normal from a to b; valid if apart.
    double distance;  ///< Distance of the cores [m]; a lower bound if it exceeds `enough`.
};

/// Compute the distance of two cores. Stops early if the distance exceeds `enough` [m].
GjkResult gjk(const Convex& a, const Convex& b, double enough);

}  // namespace hawser::collide::narrow
