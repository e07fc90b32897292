// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cost.h
/// What an island costs, before anything is factored.
///
/// The paper (Lacoursière, Nordfeldth, Linde, "A partitioning method for parallelization of large
/// systems in realtime") takes c = Σ_b n_b² + Σ_i l_i: n_b interactions of body b, l_i lengths of
/// the loops that a spanning tree leaves. Here the tree is that of a breadth-first search from the
/// heaviest node; every further pair of near nodes closes one loop, of depth(u) + depth(v) −
/// 2 depth(lca) + 1 nodes. Lowest common ancestors come from jump pointers (Myers, "An applicative
/// random-access stack", 1983), in O(log n) a loop.
///
/// Both sums fall to nodes: b has n_b² and one for each loop through it. `node` is the same in
/// flops: eliminating a node of s scalars with d neighbours left costs s³(1/3 + d + d²), which is
/// 7/3 s³ on a tree and 4 s³ more for the second neighbour that a loop brings. Of a hub, which is
/// eliminated when what meets in it has gone, the first 16 edges and 8 loops count.

#include "graph/hypergraph.h"
#include "graph/neighbours.h"

#include <cstdint>
#include <vector>

namespace hawser::graph {

class Cost {
  public:
    /// @cost O(nodes + neighbours + loops log nodes). No memory in a graph of a size seen before.
    void build(const Hypergraph& graph, const Neighbours& neighbours);
    /// Islands and `node` alone, where the graph brings costs: no loops, no c.
    void find_islands(const Hypergraph& graph, const Neighbours& neighbours);

    std::vector<std::int32_t> island;  ///< By node, −1: does not move.
    std::vector<std::int32_t> order;   ///< Moving nodes, island by island, breadth first.
    std::vector<std::int32_t> begin;   ///< islands + 1 offsets into order.
    std::vector<std::int32_t> loops;   ///< By node: loops through it.
    std::vector<std::int64_t> node;    ///< By node: flops by this model.
    std::vector<std::int64_t> paper;   ///< By island: c.

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
    void take_costs(const Hypergraph& graph);
    [[nodiscard]] std::int32_t meet(std::int32_t u, std::int32_t v) const noexcept;

    // By rank, which is the place in order: those of parents are lower.
    std::vector<std::int32_t> parent_, jump_, depth_, through_;
    std::vector<std::int32_t> rank_;  ///< By node.
    std::vector<Loop> loop_;          ///< Ranks of the pairs that the tree leaves.
    std::size_t loops_found_ = 0;     ///< Those of loop_ in use.
    std::int32_t found_ = 0;          ///< Nodes in order.
};

}  // namespace hawser::graph
