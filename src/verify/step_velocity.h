// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file step_velocity.h
/// Velocity that a step was solved for, where it went on to close joints.
///
/// Joints that a step cannot complete are closed by moving poses alone (docs/methods.md, 2), with
/// which angular velocities turn. A body turns about its angular velocity, so that in the body's
/// own frame that is the same before and after the step: from there it is taken back to where the
/// step's equations stand.
/// ```
///     ω = q₀ q₁⁻¹ ω₁        q₀, q₁ orientations before and after the step, ω₁ as it is now
/// ```

#include <hawser/hawser.h>

namespace hawser::verify {

/// @param before  Pose of the body before the step. @return world frame [m/s, rad/s].
[[nodiscard]] inline Twist step_velocity(const World& world, BodyId id, const Pose& before) {
    Twist now = world.velocity(id);
    if (world.body_def(id).kind != BodyKind::rigid) return now;
    const Vec3 back = before.orientation * (world.pose(id).orientation.conjugate() * now.angular);
    constexpr double kTurned = 1e-11;  // above what rounding makes of orientations in a step
    if ((back - now.angular).norm() > kTurned * now.angular.norm()) now.angular = back;
    return now;
}

}  // namespace hawser::verify
