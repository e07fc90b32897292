// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file active_set.h
/// Rows at their bounds, solved again until they agree with them (bounds.h): in worlds without
/// contacts, and by methods that solve for contacts separately. All rows that ask for it switch at
/// first, then the first one only (K. G. Murty's least index rule, which ends).

#include "context/context.h"

namespace hawser::stepper {

/// switch_bounds() for a solution λ, v₊ as it stands. @return whether to solve again.
[[nodiscard]] bool update_active_set(Model& model, Work& work, int pass) noexcept;

/// Of a solution with contacts that has been refined: solve again while bounds are off the loads
/// that they follow. The iterations that led there were not refined, and a bound that is a small
/// share of its load may be off by what they left.
[[nodiscard]] Status follow_loads(StepContext& ctx) noexcept;

/// Solve again until the rows of a world without contacts agree with their bounds. Statuses that
/// still change in the end are counted in stats.flips_left.
[[nodiscard]] Status settle_bounds(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
