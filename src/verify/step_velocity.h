// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file step_velocity.h
/// Velocity that a step solved for, without the later closing of joints.
///
/// Joints that a step cannot close by iteration are closed by moving poses alone
/// (docs/theory/joints.md), which rotates angular velocities. A body turns about its angular
/// velocity. In the body's own frame it is therefore equal before and after the step. From that
/// frame it is transformed to the orientation of the step's equations.
/// ```
///     ω = q₀ q₁⁻¹ ω₁        q₀, q₁ orientations before and after the step, ω₁ as it is now
/// ```

#include <hawser/hawser.h>

namespace hawser::verify {

/// Return the velocity of a body in the step, in the world frame [m/s, rad/s]. @param before  Pose
/// of the body before the step.
[[nodiscard]] inline Twist step_velocity(const World& world, BodyId id, const Pose& before) {
    Twist now = world.velocity(id);
    if (world.body_def(id).kind != BodyKind::rigid) return now;
    const Vec3 back = before.orientation * (world.pose(id).orientation.conjugate() * now.angular);
    constexpr double kTurned = 1e-11;  // above the rounding of orientations in a step
    if ((back - now.angular).norm() > kTurned * now.angular.norm()) now.angular = back;
    return now;
}

}  // namespace hawser::verify
