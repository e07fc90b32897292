// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file foreign.h
/// METIS, Scotch and AMD of SuiteSparse on a body graph. A library that is not in this build gives
/// an empty result.

#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::bench {

/// A graph in the form of a library, prepared outside all timing.
struct ForeignGraph {
    explicit ForeignGraph(const factor::Pattern& pattern);
    std::vector<int> start, adjacent, weight;  ///< Weight: scalars of each node.
    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(weight.size()); }
};

/// Return the part of each node. @param weight  Weight of each node; ForeignGraph::weight or
/// others.
[[nodiscard]] std::vector<std::int32_t> metis_parts(ForeignGraph& graph, std::vector<int>& weight,
                                                    int parts);
[[nodiscard]] std::vector<std::int32_t> scotch_parts(ForeignGraph& graph, int parts);
/// Compute the elimination order: order[k] = node.
[[nodiscard]] std::vector<std::int32_t> metis_order(ForeignGraph& graph);
[[nodiscard]] std::vector<std::int32_t> scotch_order(ForeignGraph& graph);

/// Compute vertex separators from a partition without: greedily, take the node that covers most cut
/// edges per scalar, until all are covered. `parts` gets graph::kSeparator.
void cover_cuts(const factor::Pattern& pattern, std::vector<std::int32_t>& parts);

/// Compute approximate minimum degree with nodes of kSeparator last (CAMD; without it AMD and a
/// stable partition).
[[nodiscard]] std::vector<std::int32_t> order_parts(const factor::Pattern& pattern,
                                                    const std::vector<std::int32_t>& parts);

}  // namespace hawser::bench
