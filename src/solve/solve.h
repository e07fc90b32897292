// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solve.h
/// Right-hand sides, corrections of v₊ and λ, and their residuals. A solution is refined while its
/// residual requires it and each correction reduces the residual to a quarter.

#include "context/context.h"

namespace hawser::solve {

/// Run stage 6: write the blocks of the matrix, factor, solve and refine v₊ and λ.
[[nodiscard]] Status factor_and_solve(context::StepContext& ctx) noexcept;

/// Write the blocks, factor and solve once, without refinement: one iteration of Newton's method.
/// @param first  True to start from v₊ = 0, otherwise from the current v₊ and λ.
[[nodiscard]] Status newton_solve(context::StepContext& ctx, bool first, bool whole) noexcept;

/// Run one more iteration from the current v₊ and λ with the current factorisation.
void continue_with_factor(context::StepContext& ctx) noexcept;

/// Refine the result of newton_solve() and measure its residual.
[[nodiscard]] Status refine(context::StepContext& ctx) noexcept;

/// Call refine() if the residual is above solution_tolerance.
/// @param measured  True if the residual is in the statistics; otherwise it is measured first.
[[nodiscard]] Status settle_iterations(context::StepContext& ctx, bool measured) noexcept;

/// Measure the residuals of the current v₊ and λ. This is required for solutions found without the
/// matrix.
[[nodiscard]] Status measure(context::StepContext& ctx) noexcept;

}  // namespace hawser::solve
