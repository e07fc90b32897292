// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file neighbours.h
/// List the moving nodes that share an edge.
///
/// Two moving members that follow each other in an edge are *near*. Other pairs of an edge (the
/// ends of a bending triple) are *far*. Far pairs are neighbours for a separator, but do not close
/// a loop.
///
/// A second list holds all pairs. Most passes over a graph need only pairs, and one long loop over
/// pairs avoids the mispredicted ends of many short loops.

#include "graph/hypergraph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

struct Pair {
    std::int32_t a, b;  ///< a < b.
};

/// Call f(pair) for all pairs, four distant ones in each iteration. Adjacent pairs share a node, so
/// processing them in sequence would stall on the store of f for the previous pair.
template <class F>
void for_each_pair(std::span<const Pair> pairs, F f) {
    const std::size_t quarter = pairs.size() / 4;
    const Pair* p = pairs.data();
    for (std::size_t i = 0; i < quarter; ++i, ++p) {
        f(p[0]);
        f(p[quarter]);
        f(p[2 * quarter]);
        f(p[3 * quarter]);
    }
    for (const Pair rest : pairs.subspan(4 * quarter)) f(rest);
}

class Neighbours {
  public:
    /// Build all lists. @cost O(members). Allocates nothing if a graph of this size was built
    /// before.
    void build(const Hypergraph& graph);

    /// Return all neighbours of a node, near ones first, without duplicates.
    [[nodiscard]] std::span<const std::int32_t> of(std::int32_t node) const noexcept {
        return {adjacent.data() + start[at(node)], adjacent.data() + end[at(node)]};
    }
    [[nodiscard]] std::span<const std::int32_t> near_neighbours(std::int32_t node) const noexcept {
        return {adjacent.data() + start[at(node)], adjacent.data() + middle[at(node)]};
    }
    /// Return all pairs of neighbours, near ones first, without duplicates.
    [[nodiscard]] std::span<const Pair> pairs() const noexcept { return {pair_.data(), pairs_}; }
    [[nodiscard]] std::span<const Pair> near_pairs() const noexcept {
        return {pair_.data(), near_pairs_};
    }
    [[nodiscard]] std::span<const Pair> distant_pairs() const noexcept {
        return pairs().subspan(near_pairs_);
    }
    [[nodiscard]] std::int32_t degree(std::int32_t node) const noexcept {
        return end[at(node)] - start[at(node)];
    }

    /// Range of each node in `adjacent`: near neighbours [start, middle), far neighbours [middle,
    /// end).
    std::vector<std::int32_t> start, middle, end;
    std::vector<std::int32_t> adjacent;  ///< Neighbours of all nodes; entries in use come first.
    std::vector<std::int32_t> edges;     ///< Number of edges of each node.

  private:
    void fill(const Hypergraph& graph);
    void link_all(std::span<const std::int32_t> members);
    void list_pairs();

    /// Low 32 bits: number of edges; high bits: number of other members of these edges.
    std::vector<std::int64_t> count_;
    std::vector<std::int32_t> tail_, mark_, moving_;
    std::vector<Pair> pair_;  ///< Pairs; near_pairs_ and pairs_ count the entries in use.
    std::size_t near_pairs_ = 0, pairs_ = 0;
};

}  // namespace hawser::graph
