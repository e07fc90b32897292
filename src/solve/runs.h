// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file runs.h
/// Statuses of a run: the consecutive turning points of a line and the parts between them.
///
/// If points switch one by one by the tensions of a solution (bounds.h), the next point responds a
/// factorisation later: 64 points need 64 factorisations. The interior of a run has almost no mass,
/// so a run is a small separate problem if its ends respond like their bodies. With λ_i of part i,
/// w_j of point j, W_i the mobility of the other bodies of part i, and v₊ the current solution,
/// ```
///     (W_i + Σ_i) λ_i + Σ_j G_ij w_j = c_i − G v₊ + W_i λ_i(v₊)
///     w_j = α_j + p_j λ_{j−1} + q_j λ_j       sticking point: by its spring;
///                                             sliding point: only the force of its bound
/// ```
/// This is tridiagonal in λ. Its active set is iterated to the end; an iteration costs O(n). The
/// result is the statuses for the next factorisation of the whole system. If the solution of the
/// whole system contradicts a status, the rule of bounds.h decides.

#include "context/context.h"

#include <cstdint>

namespace hawser::solve {

/// Reserve memory for the runs of turning points in the model.
/// @throws std::bad_alloc.
void reserve_runs(const context::Model& model, context::Newton& newton);

/// Store which turning points slide and which parts are taut in the current solution, before rows
/// are switched.
void note_runs(context::Model& model) noexcept;

/// Return the largest tension impulse in the parts of a run [N s].
/// @param friction  Friction of one of its turning points.
[[nodiscard]] double largest_in_run(const context::Model& model, std::int32_t friction) noexcept;

/// Determine the sliding turning points and taut parts of each run after rows have switched. Each
/// run is solved as a separate small problem.
void settle_runs(context::Model& model, context::Newton& newton) noexcept;

}  // namespace hawser::solve
