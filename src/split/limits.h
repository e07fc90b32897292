// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file limits.h
/// Reduce the work of a step to meet its budget (WorldDef::budget). Other folders include only this
/// header of `split/`.
///
/// Interfaces between groups that are coupled compliantly are chosen before the solve
/// (cut_levels.h). The number of friction iterations is chosen during the solve (budget.h). A step
/// is solved completely if it has no budget and no orders to repeat a reduced step (Degradation).

#include "context/context.h"

namespace hawser::split {

/// Start the measurement of the intervals of the step (laps) when the solver starts.
void begin_laps(context::Work& work) noexcept;
/// Find the sets of interfaces that a deadline may cut (levels). This requires forces, and is done
/// in the first step after they are known.
[[nodiscard]] Status prepare_levels(context::StepContext& ctx) noexcept;
/// Choose the active cuts of this step. Without a budget only cuts are active that do not depend on
/// deadlines.
[[nodiscard]] Status choose_cuts(context::StepContext& ctx) noexcept;
/// Set the limits of time or work for the solve that follows.
void begin_budget(context::StepContext& ctx) noexcept;
/// Update the predicted solver time per unit of work from the measured times of the step. Store
/// the omitted work in StepStats.
void end_budget(context::StepContext& ctx) noexcept;

}  // namespace hawser::split
