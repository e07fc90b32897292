// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drives.h
/// Parts of stage 8 that concern motors, driven lengths and winches.

#include "stepper/context.h"

namespace hawser::stepper {

/// Work done in the step by motors, by rigid rows that an input drives and by bodies with a
/// prescribed velocity [J], see Energy::driven. Before the velocities are overwritten.
[[nodiscard]] double drive_work(StepContext& ctx) noexcept;

/// Energy that rows took in the step [J], see Energy::damped: what their impulses took from the
/// motion less what elastic rows hold more than before. Before velocities are overwritten.
[[nodiscard]] double row_losses(StepContext& ctx) noexcept;
/// Share of interactions [begin, end) of a strip. A solution's norms are taken with it, while rows
/// are in the cache (StepContext::losses_known).
[[nodiscard]] double losses_between(StepContext& ctx, const assembly::View& v, std::int32_t begin,
                                    std::int32_t end) noexcept;

/// What the rows of a cut interaction took, with the mean of its sides' impulses (stepper/cuts.h)
/// [J].
[[nodiscard]] double cut_losses(StepContext& ctx, std::int32_t id) noexcept;

/// What a line holds at the half-step position after the step [J]: lost when it parts.
[[nodiscard]] double held_by_line(StepContext& ctx, std::int32_t id) noexcept;

/// Bodies with a prescribed velocity: exactly, a turn by h|ω| about ω.
void move_carriers(StepContext& ctx) noexcept;

/// The stiffness of a line on a drum is EA over the length that is paid out: take it anew from the
/// drums' coordinates. The strain energy that goes onto or comes off the drum is counted as driven.
void follow_winches(StepContext& ctx) noexcept;

/// Log motors whose force has come to an end of its range.
void report_saturation(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
