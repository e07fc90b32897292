// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file part_cost.h
/// Exact flops of a cached analysis, shared out to bodies.

#include "assembly/system.h"

#include <cstdint>
#include <vector>

namespace hawser::assembly {

/// By body: flops of eliminating its pivots, in fronts as they are (zeros of merged fronts
/// included), and of the kept interactions that come right after it. Bodies without a node have 0.
[[nodiscard]] std::vector<std::int64_t> body_flops(const System& system, int bodies);

/// By node of the pattern: flops of its own pivots.
[[nodiscard]] std::vector<std::int64_t> node_flops(const factor::Pattern& pattern,
                                                   const factor::Symbolic& symbolic);

}  // namespace hawser::assembly
