// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file touch.h
/// From a pair of shapes to its contact points.

#include "collide/contacts.h"
#include "collide/placing.h"

namespace hawser::collide {

/// Points of one pair that are kept, of those whose normals agree.
inline constexpr int kMaxPoints = 4;

/// Reduce a manifold. Points whose normals agree to 18° belong together, and of such at most
/// `kMaxPoints` are kept: the deepest one, the one farthest from it, then those that add most to
/// the area held (after R. Bullet's persistent manifold): they carry the same resultant and the
/// same moments as all. The order of features stays.
void reduce(Manifold& manifold) noexcept;

/// Contacts of two shapes that are closer than `margin`, or will be within a step of h at the
/// present velocities: gap < margin + h max(0, −relative normal velocity). These are the
/// speculative contacts by which fast and thin things do not pass through each other; a contact
/// that the step then does not close carries no force. `previous`, `surface` are left to the
/// caller.
/// @param of_one_host  See Filter: a segment held by a body does not touch what of that body is
/// where it is held, or nearer to the hold than the sphere around it, nor another segment beside
/// both holds. @return how many, at most kMaxManifold.
int touch(const Shape& a, const Placed& pa, const Shape& b, const Placed& pb, double h,
          double margin, bool of_one_host, Contact* out) noexcept;

}  // namespace hawser::collide
