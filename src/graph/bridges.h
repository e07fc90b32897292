// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bridges.h
/// Find the edges of a multigraph that lie on a closed loop, which are all edges except its
/// bridges. One depth-first search computes the earliest node that each subtree reaches back to.
/// Source: R. E. Tarjan, "A note on finding the bridges of a graph", 1974. Cost O(nodes + edges).

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace hawser::graph {

/// Finder of edges on loops. Its buffers are reused: a second graph of about equal size needs no
/// allocation.
class LoopFinder {
  public:
    /// Find the edges on loops like edges_on_loops(). The result is valid until the next call.
    /// @throws std::bad_alloc.
    std::span<const std::uint8_t> find(
        std::int32_t nodes, std::span<const std::pair<std::int32_t, std::int32_t>> edges);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Visit {
        /// Node, and the edge by which it was reached; edge −1 at the root.
        std::int32_t node, edge;
    };
    void begin_visit(std::int32_t node, std::int32_t edge);
    void search(std::int32_t root);

    std::span<const std::pair<std::int32_t, std::int32_t>> edges_;
    /// Edges at each node: offsets, edge indices, next edge to visit.
    std::vector<std::int32_t> begin_, ends_, next_;
    std::vector<std::int32_t> visit_time_, low_link_;
    std::vector<std::uint8_t> on_loop_;
    std::vector<Visit> path_;
    std::int32_t time_ = 0;
};

/// Return for each edge 1 if it lies on a closed loop, else 0.
/// @param nodes  Number of nodes.
/// @param edges  Pairs of nodes. Repeated pairs form a loop, and so does an edge from a node to
/// itself.
/// @throws std::bad_alloc.
[[nodiscard]] std::vector<std::uint8_t> edges_on_loops(
    std::int32_t nodes, std::span<const std::pair<std::int32_t, std::int32_t>> edges);

}  // namespace hawser::graph
