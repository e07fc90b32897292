// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file active_set.h
/// Repeated solution until rows at their bounds are consistent with the solution (bounds.h). Used
/// in worlds without contacts, and by methods that solve for contacts separately. All requesting
/// rows switch at first, then only the first one (K. G. Murty's least index rule, which
/// terminates).

#include "context/context.h"

namespace hawser::solve {

/// Call switch_bounds() for the current solution λ, v₊.
/// @return true if another solve is needed.
[[nodiscard]] bool update_active_set(context::Model& model, context::Work& work, int pass) noexcept;

/// Repeat the solution with contacts until the bounds of friction match its loads. Call after
/// refinement: iterations before it were not refined, so a bound that is a small fraction of its
/// load may have the error of their residual.
[[nodiscard]] Status follow_loads(context::StepContext& ctx) noexcept;

/// Repeat the solution of a world without contacts until the rows are consistent with their bounds.
/// stats.flips_left counts the statuses that still change at the end.
[[nodiscard]] Status settle_bounds(context::StepContext& ctx) noexcept;

}  // namespace hawser::solve
