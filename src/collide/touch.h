// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file touch.h
/// Contact points of a pair of shapes.

#include "collide/contacts.h"
#include "collide/placing.h"

namespace hawser::collide {

/// Maximum number of points kept per pair and normal.
inline constexpr int kMaxPoints = 4;

/// Reduce a manifold. Points whose normals agree to 18° form a group, of which at most `kMaxPoints`
/// are kept. The deepest point is kept, then the point furthest from it, then the points that add
/// most to the enclosed area. (Like the persistent manifold of Bullet.) They carry the same
/// resultant and the same moments as all points. The order of features is preserved.
void reduce(Manifold& manifold) noexcept;

/// Compute the contacts of two shapes that are closer than `margin`, or will be within a step of h
/// at the present velocities. Condition: gap < margin + h max(0, −relative normal velocity). These
/// speculative contacts prevent fast and thin shapes from passing through each other. If the step
/// does not close such a contact, it carries no force. The caller sets `previous` and `surface`.
/// @param share_host  See Filter. A segment held by a body does not touch that body at the hold,
/// or nearer to the hold than the sphere around the shape. It touches no other segment near both
/// holds. @return number of contacts, at most kMaxManifold.
int touch(const Shape& a, const Placed& pa, const Shape& b, const Placed& pb, double h,
          double margin, bool share_host, Contact* out) noexcept;

}  // namespace hawser::collide
