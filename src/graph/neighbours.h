// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file neighbours.h
/// Which moving nodes share an edge.
///
/// Two moving members that follow each other in an edge are *near*; those farther apart in it (the
/// ends of a bending triple) are neighbours for a separator, but close no loop of their own.
///
/// Beside the lists by node there is one of all pairs: most passes over a graph need no nodes, and
/// a loop over pairs does not end after a few turns that nothing foretells.

#include "graph/hypergraph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

struct Pair {
    std::int32_t a, b;  ///< a < b.
};

/// f(pair) for all pairs, four of them from far apart in each turn: those that stand side by side
/// share a node, and what f keeps of it would come back from memory too late for the next one.
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
    /// @cost O(members); no memory once it has held a graph of this size.
    void build(const Hypergraph& graph);

    /// All neighbours, near ones first, each once.
    [[nodiscard]] std::span<const std::int32_t> of(std::int32_t node) const noexcept {
        return {adjacent.data() + start[at(node)], adjacent.data() + end[at(node)]};
    }
    [[nodiscard]] std::span<const std::int32_t> near(std::int32_t node) const noexcept {
        return {adjacent.data() + start[at(node)], adjacent.data() + middle[at(node)]};
    }
    /// All pairs of neighbours, near ones first, each once.
    [[nodiscard]] std::span<const Pair> pairs() const noexcept { return {pair_.data(), pairs_}; }
    [[nodiscard]] std::span<const Pair> near_pairs() const noexcept {
        return {pair_.data(), near_pairs_};
    }
    [[nodiscard]] std::span<const Pair> far_pairs() const noexcept {
        return pairs().subspan(near_pairs_);
    }
    [[nodiscard]] std::int32_t degree(std::int32_t node) const noexcept {
        return end[at(node)] - start[at(node)];
    }

    std::vector<std::int32_t> start, middle, end;  ///< By node: ranges of `adjacent`, one after
                                                   ///< the other.
    std::vector<std::int32_t> adjacent;            ///< Those in use come first.
    std::vector<std::int32_t> edges;               ///< By node: edges that it is a member of.

  private:
    void fill(const Hypergraph& graph);
    void link_all(std::span<const std::int32_t> members);
    void list_pairs();

    std::vector<std::int64_t> count_;  ///< Edges, and above them members of these beside the node.
    std::vector<std::int32_t> tail_, mark_, moving_;
    std::vector<Pair> pair_;  ///< Those in use: near_pairs_, pairs_.
    std::size_t near_pairs_ = 0, pairs_ = 0;
};

}  // namespace hawser::graph
