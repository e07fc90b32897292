// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file limits.h
/// What a step leaves out to end in time (WorldDef::budget), as the step meets it: nothing else of
/// this room is included elsewhere. Which
/// interfaces between groups are coupled compliantly is decided before the step is solved
/// (cut_levels.h), how many iterations friction gets while it is (budget.h). A step without a
/// budget, and without orders to repeat one that had it (Degradation), is solved whole.

#include "context/context.h"

namespace hawser::stepper {

/// The solver begins: no lap is done.
void begin_laps(Work& work) noexcept;
/// What levels of cuts there are, in the first step in which forces are known.
[[nodiscard]] Status prepare_levels(StepContext& ctx) noexcept;
/// Choose the cuts of this step; without a budget only those that ask for themselves are there.
[[nodiscard]] Status choose_cuts(StepContext& ctx) noexcept;
/// Set the limits of time or work for the solve that begins now.
void begin_budget(StepContext& ctx) noexcept;
/// Learn rates from the times of the step, and tell what it left out.
void end_budget(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
