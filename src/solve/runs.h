// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file runs.h
/// Which places of a run slide, and which of its parts are taut: the places that a line runs over
/// one after another, and the parts between them.
///
/// Where the places of a run are asked one by one, by the tensions that a solution has (bounds.h),
/// what one of them does is seen by the next one a factorisation later: 64 places take 64. But what
/// is between the ends of a run has next to no mass, and is a small problem of its own once the
/// ends are known to give way like their bodies do: with λ_i of part i, w_j of place j, W_i the
/// mobility of what else part i pulls at, and v₊ the solution at hand,
/// ```
///     (W_i + Σ_i) λ_i + Σ_j G_ij w_j = c_i − G v₊ + W_i λ_i(v₊)
///     w_j = α_j + p_j λ_{j−1} + q_j λ_j       of a place that holds: its spring, and that slides:
///                                             no force beside its bound
/// ```
/// which is tridiagonal in λ. Its active set is iterated to the end, at the cost of n numbers each
/// time, and is what the whole system is factored with next. That decides nothing: where the whole
/// system contradicts what is found here, its own rule holds.

#include "context/context.h"

#include <cstdint>

namespace hawser::stepper {

/// Room for the runs there are. @throws std::bad_alloc.
void reserve_runs(const Model& model, Newton& newton);

/// Statuses of runs as the solution at hand was found with. Before others are switched.
void note_runs(Model& model) noexcept;

/// Largest impulse of the parts of a run [N s]. @param friction  Of one of its places.
[[nodiscard]] double largest_in_run(const Model& model, std::int32_t friction) noexcept;

/// Statuses of runs as their own problem has them. After others were switched.
void settle_runs(Model& model, Newton& newton) noexcept;

}  // namespace hawser::stepper
