// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file frame.h
/// Coordinates of a template: points, directions and velocities from its own axes to the world's.

#include <hawser/math.h>

namespace hawser::scene {

/// Where a template's own coordinates lie in the world, and how that place moves.
struct Frame {
    Vec3 position{0.0, 0.0, 0.0};
    Quat orientation = Quat::Identity();
    Vec3 velocity{0.0, 0.0, 0.0};
    Vec3 angular_velocity{0.0, 0.0, 0.0};

    [[nodiscard]] Vec3 point(const Vec3& local) const { return position + orientation * local; }
    [[nodiscard]] Vec3 direction(const Vec3& local) const { return orientation * local; }
    /// Velocity of the frame at a world point.
    [[nodiscard]] Vec3 velocity_at(const Vec3& world) const {
        return velocity + angular_velocity.cross(world - position);
    }
};

}  // namespace hawser::scene
