// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contact_side.h
/// Distribute the force on one side of a contact to its bodies, from shapes and poses alone.

#include <hawser/hawser.h>

#include <cmath>
#include <span>

namespace hawser::verify {

struct ContactSide {
    int count = 1;
    BodyId body[2];
    double fraction[2] = {1.0, 0.0};
    /// Arm from the centre of each body to the point of its part of the force [m]; 0 for nodes,
    /// which have no arms.
    Vec3 arm[2] = {Vec3::Zero(), Vec3::Zero()};
    double length = HUGE_VAL;  ///< Length over which two bodies share the force [m].
};

/// Return the side of a contact. @param on_axis  Point of the contact on the axis of a segment,
/// world frame [m]. @param point  Point of the contact [m]. @param pose  Poses of all bodies, by
/// index.
[[nodiscard]] ContactSide contact_side(const World& world, ShapeId shape, const Vec3& on_axis,
                                       const Vec3& point, std::span<const Pose> pose);

}  // namespace hawser::verify
