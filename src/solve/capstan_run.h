// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file capstan_run.h
/// Which places of one run of a line slide, and which of its parts pull, with the rest of the world
/// as it is.
/// ```
///     part 0 ── place 0 ── part 1 ── place 1 ── … ── place n−1 ── part n
/// ```
/// A part i has the impulse λ_i, a place k the speed w_k along the line. Of a place that holds w_k
/// follows from the impulses beside it by its spring, of one that slides from its bound; put into
/// the rows of the parts they leave a tridiagonal system of n + 1 impulses, which is solved by
/// elimination. Statuses that the solution contradicts switch all together, later one by one.

#include "context/newton_data.h"

#include <cstddef>

namespace hawser::stepper {

/// Find which places slide and which parts pull: solve the run and change the statuses that the
/// solution contradicts, in turns. At the bound of turns they need not agree with each other, but
/// are closer to it than those of the solution that was refused.
/// @return whether they are others than those.
/// @param n  Places; of the parts there is one more.
bool find_statuses(std::size_t n, RunPlace* place, RunPart* part) noexcept;

}  // namespace hawser::stepper
