// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file elimination.h
/// Compute the exact cost of an elimination order: entries of L, flops, and the longest path.

#include <hawser/inspect.h>

#include <cstdint>
#include <vector>

namespace hawser::report {

struct EliminationCounts {
    std::int64_t nnz =
        0;  ///< Scalars of L, including the diagonal, without the zeros of merged fronts.
    std::int64_t flops = 0;  ///< Number of flops; multiply and add count as two.
    std::int64_t path = 0;   ///< Flops on the longest path from a leaf to a root.
};

/// Count entries and flops block by block: struct(v) is the union of the later neighbours of v and
/// struct of its children, without v. Source: Liu, "The role of elimination trees in sparse
/// factorization", 1990. @param order order[k] = node of the view eliminated k-th.
[[nodiscard]] EliminationCounts count_elimination(const SystemView& view,
                                                  const std::vector<std::int32_t>& order);

}  // namespace hawser::report
