// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pairs.h
/// One collision function per pair of kinds, in the order of the names; see Collide.

#include "collide/geometry.h"

namespace hawser::collide::narrow {

#define HAWSER_PAIR(name)                                                                     \
    void name(const Geometry& a, const Placement& pa, const Geometry& b, const Placement& pb, \
              double margin, Manifold& out) noexcept

HAWSER_PAIR(sphere_sphere);
HAWSER_PAIR(sphere_capsule);
HAWSER_PAIR(sphere_box);
HAWSER_PAIR(sphere_cylinder);
HAWSER_PAIR(sphere_plane);
HAWSER_PAIR(capsule_capsule);
HAWSER_PAIR(capsule_box);
HAWSER_PAIR(capsule_plane);
HAWSER_PAIR(box_box);
HAWSER_PAIR(convex_plane);   ///< Box, cylinder or hull.
HAWSER_PAIR(convex_convex);  ///< Two of capsule, box, cylinder and hull, or a sphere with a hull.
HAWSER_PAIR(convex_mesh);
HAWSER_PAIR(convex_heightfield);
HAWSER_PAIR(nothing);

}  // namespace hawser::collide::narrow
