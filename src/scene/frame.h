// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file frame.h
/// Transform points, directions and velocities from the axes of a template to those of the world.

#include <hawser/math.h>

namespace hawser::scene {

/// Position, orientation and velocity in the world of the coordinates of a template.
struct Frame {
    Vec3 position{0.0, 0.0, 0.0};
    Quat orientation = Quat::Identity();
    Vec3 velocity{0.0, 0.0, 0.0};
    Vec3 angular_velocity{0.0, 0.0, 0.0};

    [[nodiscard]] Vec3 point(const Vec3& local) const { return position + orientation * local; }
    [[nodiscard]] Vec3 direction(const Vec3& local) const { return orientation * local; }
    /// Return the velocity of the frame at a world point.
    [[nodiscard]] Vec3 velocity_at(const Vec3& world) const {
        return velocity + angular_velocity.cross(world - position);
    }
};

}  // namespace hawser::scene
