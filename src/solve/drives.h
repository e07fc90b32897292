// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drives.h
/// Parts of stage 8 that concern motors, driven lengths and winches.

#include "context/context.h"

#include <cstdint>
#include <span>

namespace hawser::stepper {

/// In a step [J], see Energy.
struct DriveWork {
    double driven = 0.0;    ///< By motors, rigid rows that an input drives, prescribed velocities.
    double friction = 0.0;  ///< Taken by friction in joints, slides and drums.
    double stopped = 0.0;   ///< Taken where a slide is held against running on (wire/guide.h).
};
/// Compute them before the velocities are overwritten.
[[nodiscard]] DriveWork drive_work(Model& model) noexcept;

/// Impulses of the same over the step, times by how much the velocities at them change in it [J].
/// Before the velocities are overwritten.
[[nodiscard]] double drive_gain(Model& model) noexcept;

/// The same of springs and lines. @param springs  Interactions.
[[nodiscard]] double spring_gain(Model& model, std::span<const std::int32_t> springs) noexcept;

/// Σ h² ġ²/ε of springs, bodies with a prescribed velocity included [J].
[[nodiscard]] double spring_way(Model& model, std::span<const std::int32_t> springs) noexcept;

/// Bodies with a prescribed velocity: exactly, a turn by h|ω| about ω.
void move_carriers(Model& model) noexcept;

/// The stiffness of a line on a drum is EA over the length that is paid out: take it anew from the
/// drums' coordinates. The strain energy that goes onto or comes off the drum is counted as driven.
void follow_winches(Model& model, State& state) noexcept;

/// Log motors whose force has come to an end of its range.
void report_saturation(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
