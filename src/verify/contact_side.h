// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contact_side.h
/// The bodies that feel one side of a contact, from shapes and poses alone.

#include <hawser/hawser.h>

#include <cmath>
#include <span>

namespace hawser::verify {

struct ContactSide {
    int count = 1;
    BodyId body[2];
    double share[2] = {1.0, 0.0};
    /// From the centre of each to where it feels its share [m]; 0 of lumps, which have no levers.
    Vec3 arm[2] = {Vec3::Zero(), Vec3::Zero()};
    double length = HUGE_VAL;  ///< Over which two bodies share [m].
};

/// @param on_axis  The contact's place on the axis of a segment, world frame [m].
/// @param point  The contact's point [m]. @param pose  Of all bodies, by index.
[[nodiscard]] ContactSide contact_side(const World& world, ShapeId shape, const Vec3& on_axis,
                                       const Vec3& point, std::span<const Pose> pose);

}  // namespace hawser::verify
