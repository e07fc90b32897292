// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drives.h
/// Work of motors, driven lengths and winches in stage 8.

#include "context/context.h"

#include <cstdint>
#include <span>

namespace hawser::solve {

/// Work in a step [J], see Energy.
struct DriveWork {
    /// Work of motors, rigid rows driven by inputs, and prescribed velocities.
    double driven = 0.0;
    double friction = 0.0;  ///< Energy dissipated by friction in joints, slides and drums.
    double stopped = 0.0;   ///< Energy dissipated by stops of slides (wire/guide_system.h).
};
/// Compute the work of drives. Call before the velocities are overwritten.
[[nodiscard]] DriveWork drive_work(context::Model& model) noexcept;

/// Return the sum over drives of their impulses times the change of their velocities in the step
/// [J]. Call before the velocities are overwritten.
[[nodiscard]] double drive_gain(context::Model& model) noexcept;

/// Return the sum over springs and lines of their impulses times the change of their velocities
/// [J].
/// @param springs  Interactions to include.
[[nodiscard]] double spring_gain(context::Model& model,
                                 std::span<const std::int32_t> springs) noexcept;

/// Return Σ h² ġ²/ε of springs [J], with ġ including prescribed velocities.
[[nodiscard]] double spring_travel_energy(context::Model& model,
                                          std::span<const std::int32_t> springs) noexcept;

/// Move bodies with a prescribed velocity exactly: a rotation by h|ω| about ω.
void move_carriers(context::Model& model) noexcept;

/// Update the stiffness of lines on drums, EA over the length paid out, from the drums'
/// coordinates. Elastic energy that moves onto or off the drum with the wire counts as driven work.
void follow_winches(context::Model& model, context::State& state) noexcept;

/// Report motors whose force has reached an end of its range.
void report_saturation(context::StepContext& ctx) noexcept;

}  // namespace hawser::solve
