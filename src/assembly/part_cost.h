// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file part_cost.h
/// Exact flops of an analysis, distributed to bodies.

#include "assembly/system.h"

#include <cstdint>
#include <vector>

namespace hawser::assembly {

/// Return, for each body, the flops of eliminating its pivots in the present fronts, including the
/// zeros of merged fronts. Kept interactions directly after a body are included. Bodies without a
/// node have 0.
[[nodiscard]] std::vector<std::int64_t> body_flops(const System& system, int bodies);

/// Return the flops of eliminating the pivots of each node of the pattern.
[[nodiscard]] std::vector<std::int64_t> node_flops(const factor::Pattern& pattern,
                                                   const factor::Symbolic& symbolic);

}  // namespace hawser::assembly
