// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file interaction_forces.h
/// Compute the effects of interactions on their bodies from definitions, poses and row forces, for
/// certificate.h. Each kind is a few forces at points and torques, written from the catalogue of
/// its rows (docs/scenes_reference.md). This code uses no Jacobian and no part of the solver.

#include <hawser/hawser.h>

#include "verify/attached.h"

#include <array>
#include <span>

namespace hawser::verify {

/// Force [N] at the centre of mass and torque [N m] about it, world frame, or impulses. For a
/// scalar body: force.x().
struct Wrench {
    Vec3 force{0.0, 0.0, 0.0};
    Vec3 torque{0.0, 0.0, 0.0};
};

struct Wrenches {
    std::array<Wrench, kMaxInteractionBodies>
        on{};  ///< Wrenches in the order of the interaction's bodies.
    /// False if the kind is not covered, or if rounding decides on the directions of the rows. The
    /// latter is a bend of a line whose two smallest direction cosines are equal.
    bool is_known = true;
};

/// Return the wrenches that forces of the rows exert on the bodies. @param force  By row [N or N
/// m].
[[nodiscard]] Wrenches row_wrenches(const World& world, InteractionId id,
                                    std::span<const Pose> pose, std::span<const double> force);

/// Return the impulses [N s, N m s] of the geometric stiffness and of the damping of joints
/// (docs/theory/stiffness.md). They belong to the step from velocities `before` to the present
/// ones.
/// @param earlier  Velocities one step earlier than `before`. @param last  Forces of the rows in
/// that step. @param damped_steps_before  WorldWires::damped_steps() before the present step.
[[nodiscard]] Wrenches stiffness_wrenches(const World& world, InteractionId id,
                                          std::span<const Pose> pose, std::span<const Twist> before,
                                          std::span<const Twist> earlier,
                                          std::span<const double> last, int damped_steps_before);

/// Return the mass of an element that moves as a straight piece between two nodes (its parameter
/// `mass`); 0 for other interactions [kg].
[[nodiscard]] double piece_mass(const World& world, InteractionId id);

/// Allowed forces of the first row of an interaction [N or N m].
struct ForceRange {
    double low = 0.0, high = 0.0;
    bool bounded = false;
    bool friction = false;
};
/// Return the allowed force range of an interaction, with the present loads of friction. @param
/// pose  Poses at the start of the step.
[[nodiscard]] ForceRange force_range(const World& world, InteractionId id,
                                     std::span<const Pose> pose);

/// Return a parameter of an interaction with its present input value.
[[nodiscard]] double parameter(const World& world, InteractionId id, std::string_view name);

}  // namespace hawser::verify
