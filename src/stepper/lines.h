// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lines.h
/// Lines that only pull, and joints at the end of their range, in the Newton method for contacts.
///
/// Such a row has λ = P(λ + ρ r), with r = c − G v − Σλ, ρ = 1/(W + Σ), W its entry of G M⁻¹ Gᵀ,
/// and P the projection onto λ ≤ 0 (or ≥ 0). It is active where λ + ρ r has the right sign. Both λ
/// and r go straight along a Newton step, so these rows have their part in choosing its length.

#include "stepper/context.h"

namespace hawser::stepper {

/// Room for the rows there are. @throws std::bad_alloc.
void reserve_lines(StepContext& ctx);
/// λ and r where a step ends.
void take_lines(StepContext& ctx) noexcept;
/// A share t of the way is where the next step begins.
void keep_lines(StepContext& ctx, double t) noexcept;
/// Σ (W + Σ) (λ − P)² a share t of the way [J].
[[nodiscard]] double lines_merit(const StepContext& ctx, double t) noexcept;
/// Switch rows by what they ask for where the next step begins. @return how many.
[[nodiscard]] std::int32_t switch_lines(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
