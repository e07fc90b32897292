// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file interaction_forces.h
/// What interactions do to their bodies, from definitions, poses and the forces of their rows, for
/// certificate.h. Each kind is a few forces at points and torques, written down from what the
/// catalogue says about its rows (docs/scenes_reference.md); no Jacobian, and nothing of the
/// solver.

#include <hawser/hawser.h>

#include "verify/attached.h"

#include <array>
#include <span>

namespace hawser::verify {

/// Force [N] at the centre of mass and torque [N m] about it, world frame, or impulses. Of a
/// scalar body: force.x().
struct Wrench {
    Vec3 force{0.0, 0.0, 0.0};
    Vec3 torque{0.0, 0.0, 0.0};
};

struct Wrenches {
    std::array<Wrench, kMaxInteractionBodies> on{};  ///< In the order of the interaction's bodies.
    /// False: the kind is not covered, or rounding decides how the rows lie (bend of a line whose
    /// two smallest direction cosines are equal).
    bool known = true;
};

/// Of the rows with these forces [N or N m].
[[nodiscard]] Wrenches row_wrenches(const World& world, InteractionId id,
                                    std::span<const Pose> pose, std::span<const double> force);

/// Impulses [N s, N m s] of the geometric stiffness and the damping of joints (docs/methods.md, 4)
/// in the step that led from velocities `before` to those at hand. @param earlier  Velocities
/// before the step before that one. @param last  Forces of the rows in it. @param alert
/// World::wire_alert() before the step that led here.
[[nodiscard]] Wrenches stiffness_wrenches(const World& world, InteractionId id,
                                          std::span<const Pose> pose, std::span<const Twist> before,
                                          std::span<const Twist> earlier,
                                          std::span<const double> last, int alert);

/// Mass of an element that moves as a straight piece between two lumps (its parameter `mass`), 0 of
/// all else [kg].
[[nodiscard]] double piece_mass(const World& world, InteractionId id);

/// Forces that the first row of an interaction may have [N or N m].
struct ForceRange {
    double low = 0.0, high = 0.0;
    bool bounded = false;
    bool friction = false;
};
/// With the loads of friction as they are at hand. @param pose  Where the step began.
[[nodiscard]] ForceRange force_range(const World& world, InteractionId id,
                                     std::span<const Pose> pose);

/// Parameters of an interaction as inputs have set them.
[[nodiscard]] double parameter(const World& world, InteractionId id, std::string_view name);

}  // namespace hawser::verify
