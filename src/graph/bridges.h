// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bridges.h
/// Which edges of a multigraph lie on a closed loop: all but its bridges. One depth-first search
/// with the earliest node that each subtree reaches back to (R. E. Tarjan, "A note on finding the
/// bridges of a graph", 1974); O(nodes + edges).

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hawser::graph {

/// Finds them; a used one needs no memory for a graph of about the same size.
class LoopFinder {
  public:
    /// As edges_on_loops(); valid until the next call. @throws std::bad_alloc.
    std::span<const std::uint8_t> find(
        std::int32_t nodes, std::span<const std::pair<std::int32_t, std::int32_t>> edges);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Visit {
        std::int32_t node, edge;  ///< By which it was reached; −1: the root.
    };
    void discover(std::int32_t node, std::int32_t edge);
    void search(std::int32_t root);

    std::span<const std::pair<std::int32_t, std::int32_t>> edges_;
    std::vector<std::int32_t> begin_, ends_, next_;  ///< Edges at each node.
    std::vector<std::int32_t> found_, low_;
    std::vector<std::uint8_t> looped_;
    std::vector<Visit> path_;
    std::int32_t time_ = 0;
};

/// @param nodes  Count. @param edges  Pairs of nodes; repeated ones are loops, and so is an edge
/// from a node to itself. @return by edge: 1 on a closed loop, else 0. @throws std::bad_alloc.
[[nodiscard]] std::vector<std::uint8_t> edges_on_loops(
    std::int32_t nodes, std::span<const std::pair<std::int32_t, std::int32_t>> edges);

}  // namespace hawser::graph
