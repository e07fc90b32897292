// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solve.h
/// Right-hand sides, corrections of v₊ and λ, and their residuals. A solution is refined while its
/// residual asks for it and a correction quarters it.

#include "context/context.h"

namespace hawser::stepper {

/// Stage 6. Write the blocks of the matrix, factor, solve, refine: v₊ and λ.
[[nodiscard]] Status factor_and_solve(StepContext& ctx) noexcept;

/// Write the blocks, factor and solve once, without refinement: one iteration of a Newton method.
/// `first`: from v₊ = 0, else from v₊ and λ as they are.
[[nodiscard]] Status newton_solve(StepContext& ctx, bool first, bool whole) noexcept;

/// One more iteration from v₊ and λ as they are, with the factorisation at hand.
void continue_with_factor(StepContext& ctx) noexcept;

/// Refine what newton_solve() found, and measure it.
[[nodiscard]] Status refine(StepContext& ctx) noexcept;

/// refine() where the residual is above solution_tolerance. `measured`: the residual is in the
/// statistics, else it is measured first.
[[nodiscard]] Status settle_rounds(StepContext& ctx, bool measured) noexcept;

/// Measure v₊, λ and row residuals as they stand, found without the matrix.
[[nodiscard]] Status measure(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
