// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file elimination.h
/// What an order of elimination costs: entries of L, flops, and the longest path, exactly.

#include <hawser/inspect.h>

#include <cstdint>
#include <vector>

namespace hawser::report {

struct EliminationCounts {
    std::int64_t nnz = 0;    ///< Scalars of L, diagonal included, without zeros of merged fronts.
    std::int64_t flops = 0;  ///< Multiply and add counted apart.
    std::int64_t path = 0;   ///< Flops on the longest path from a leaf to a root.
};

/// Block by block: struct(v) = neighbours of v after it and struct of its children, less v (Liu,
/// "The role of elimination trees in sparse factorization", 1990).
/// @param order  order[k] = node of the view eliminated k-th.
[[nodiscard]] EliminationCounts count_elimination(const SystemView& view,
                                                  const std::vector<std::int32_t>& order);

}  // namespace hawser::report
