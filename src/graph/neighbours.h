// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file neighbours.h
/// Which moving nodes share an edge.
///
/// Two moving members that follow each other in an edge are *near*; those farther apart in it (the
/// ends of a bending triple) are neighbours for a separator, but close no loop of their own.

#include "graph/hypergraph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

struct Neighbour {
    std::int32_t value;  ///< Twice the node, plus one if not near.
    [[nodiscard]] std::int32_t node() const noexcept { return value >> 1; }
    [[nodiscard]] bool near() const noexcept { return (value & 1) == 0; }
};

class Neighbours {
  public:
    /// @cost O(members); no memory once it has held a graph of this size.
    void build(const Hypergraph& graph);

    [[nodiscard]] std::span<const Neighbour> of(std::int32_t node) const noexcept {
        return {adjacent.data() + start[at(node)], adjacent.data() + end[at(node)]};
    }
    [[nodiscard]] std::int32_t degree(std::int32_t node) const noexcept {
        return end[at(node)] - start[at(node)];
    }

    std::vector<std::int32_t> start, end;  ///< By node: its range of `adjacent`.
    std::vector<Neighbour> adjacent;       ///< Each neighbour once; gaps between ranges.
    std::vector<std::int32_t> edges;       ///< By node: edges that it is a member of.

  private:
    std::vector<std::int32_t> mark_;
};

}  // namespace hawser::graph
