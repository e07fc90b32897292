// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file capstan_run.h
/// Sliding points and taut parts of one run of a line, with the rest of the world fixed.
/// ```
///     part 0 ── point 0 ── part 1 ── point 1 ── … ── point n−1 ── part n
/// ```
/// A part i has the impulse λ_i, a point k the speed w_k along the line. At a sticking point, w_k
/// follows from the adjacent impulses by the spring of the point; at a sliding point it follows
/// from the bound. Substituted into the rows of the parts this gives a tridiagonal system of n + 1
/// impulses, which is solved by elimination. All inconsistent statuses switch at once, in later
/// iterations only one at a time.

#include "context/newton_data.h"

#include <cstddef>

namespace hawser::solve {

/// Find the sliding turning points and the taut parts of a run. Alternately solve the run and
/// change inconsistent statuses. At the limit of iterations the statuses may be inconsistent, but
/// less than those of the rejected solution.
/// @param n  Number of turning points; there is one more part.
/// @return true if the statuses differ from the initial ones.
bool find_statuses(std::size_t n, context::RunPoint* place, context::RunPart* part) noexcept;

}  // namespace hawser::solve
