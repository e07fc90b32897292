// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file runs.h
/// Statuses of a run: the consecutive places that a line runs over and the parts between them.
///
/// If single places switch by the tensions of a solution (bounds.h), the next place responds a
/// factorisation later: 64 places take 64 factorisations. But the interior of a run has almost no
/// mass. It is a small problem of its own, if the ends respond like their bodies. With λ_i of part
/// i, w_j of place j, W_i the mobility of the other bodies of part i, and v₊ the current solution,
/// ```
///     (W_i + Σ_i) λ_i + Σ_j G_ij w_j = c_i − G v₊ + W_i λ_i(v₊)
///     w_j = α_j + p_j λ_{j−1} + q_j λ_j       of a place that holds: its spring, and that slides:
///                                             no force beside its bound
/// ```
/// This is tridiagonal in λ. Its active set is iterated to the end, at a cost of n numbers per
/// iteration, and gives the statuses for the next factorisation of the whole system. If the whole
/// system contradicts a status, its own rule decides.

#include "context/context.h"

#include <cstdint>

namespace hawser::solve {

/// Reserve memory for the existing runs.
/// @throws std::bad_alloc.
void reserve_runs(const context::Model& model, context::Newton& newton);

/// Store the statuses of runs in the current solution, before rows are switched.
void note_runs(context::Model& model) noexcept;

/// Return the largest impulse of the parts of a run [N s].
/// @param friction  Friction of one of its turning points.
[[nodiscard]] double largest_in_run(const context::Model& model, std::int32_t friction) noexcept;

/// Set the statuses of runs after rows have switched. Each run is solved separately for this.
void settle_runs(context::Model& model, context::Newton& newton) noexcept;

}  // namespace hawser::solve
