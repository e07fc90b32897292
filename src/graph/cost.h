// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cost.h
/// Estimate the cost of an island before anything is factored.
///
/// The paper (Lacoursière, Nordfeldth, Linde, "A partitioning method for parallelization of large
/// systems in realtime") uses c = Σ_b n_b² + Σ_i l_i. Here n_b is the number of interactions of
/// body b, and l_i are lengths of the loops that a spanning tree leaves. The tree is that of a
/// breadth-first search from the heaviest node. Every other pair of near nodes closes one loop of
/// depth(u) + depth(v) − 2 depth(lca) + 1 nodes. Lowest common ancestors are found by jump pointers
/// in O(log n) for each loop (Myers, "An applicative random-access stack", 1983).
///
/// Both sums are distributed to nodes: node b has n_b² and 1 for each loop through it. `node` is
/// the cost in flops. Eliminating a node of s scalars with d remaining neighbours costs s³(1/3 + d
/// + d²). This is 7/3 s³ on a tree, and 4 s³ more for the second neighbour that a loop adds. A hub
/// is eliminated after its neighbours, so only its first 16 edges and 8 loops count.

#include "graph/hypergraph.h"
#include "graph/neighbours.h"

#include <cstdint>
#include <vector>

namespace hawser::graph {

class Cost {
  public:
    /// Compute all arrays of this class. @cost O(nodes + neighbours + loops log nodes). Allocates
    /// nothing if a graph of this size was built before.
    void build(const Hypergraph& graph, const Neighbours& neighbours);
    /// Find islands and set `node` from the costs of the graph. `loops` and `paper` are not
    /// computed.
    void find_islands(const Hypergraph& graph, const Neighbours& neighbours);

    std::vector<std::int32_t> island;  ///< Island of each node, −1: does not move.
    std::vector<std::int32_t> order;   ///< Moving nodes, island by island, in breadth-first order.
    std::vector<std::int32_t> begin;   ///< Offsets of the islands in `order`, islands + 1 entries.
    std::vector<std::int32_t> loops;   ///< Number of loops through each node.
    std::vector<std::int64_t> node;    ///< Cost of each node by this model [flops].
    std::vector<std::int64_t> paper;   ///< Cost c of each island.

    [[nodiscard]] std::int32_t islands() const noexcept {
        return static_cast<std::int32_t>(begin.size()) - 1;
    }

  private:
    struct Loop {
        std::int32_t u, v;
    };

    void search(const Neighbours& neighbours, std::int32_t root);
    void search_all(const Hypergraph& graph, const Neighbours& neighbours);
    void find_loops(const Neighbours& neighbours);
    void close_loops() noexcept;
    void copy_costs(const Hypergraph& graph);
    [[nodiscard]] std::int32_t common_ancestor(std::int32_t u, std::int32_t v) const noexcept;

    // By rank, the index in `order`. A parent has a lower rank than its children.
    std::vector<std::int32_t> parent_, jump_, depth_, through_;
    std::vector<std::int32_t> rank_;  ///< Rank of each node.
    std::vector<Loop> loop_;          ///< Ranks of the pairs of nodes that the tree leaves out.
    std::size_t loop_count_ = 0;      ///< Number of entries of loop_ in use.
    std::int32_t found_ = 0;          ///< Number of nodes in `order`.
};

}  // namespace hawser::graph
