// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bridges.h
/// Which edges of a multigraph lie on a closed loop: all but its bridges. One depth-first search
/// with the earliest node that each subtree reaches back to (R. E. Tarjan, "A note on finding the
/// bridges of a graph", 1974); O(nodes + edges).

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hawser::graph {

/// @param nodes  Count. @param edges  Pairs of nodes; repeated ones are loops, and so is an edge
/// from a node to itself. @return by edge: 1 on a closed loop, else 0. @throws std::bad_alloc.
[[nodiscard]] std::vector<std::uint8_t> edges_on_loops(
    std::int32_t nodes, std::span<const std::pair<std::int32_t, std::int32_t>> edges);

}  // namespace hawser::graph
