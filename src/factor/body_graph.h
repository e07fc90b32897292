// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file body_graph.h
/// Adjacency of bodies, direct or through rows, and the wires among them.

#include "factor/pattern.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// Adjacency of positive nodes. Two nodes are neighbours if an edge or a negative node joins them.
/// A view, which refers to the pattern itself if the pattern has no negative nodes.
struct BodyGraph {
    const std::int32_t *start, *adjacent;
    [[nodiscard]] std::span<const std::int32_t> neighbours(std::int32_t node) const noexcept {
        return {adjacent + start[node], adjacent + start[node + 1]};
    }
};

/// Sequences of bodies of one size. Each body couples only to the next one or two, and to bodies
/// outside all wires. Bodies of two wires never couple.
struct Wires {
    std::vector<std::int32_t> bodies;    ///< Nodes of all wires.
    std::vector<std::int32_t> begin{0};  ///< wires + 1 offsets into bodies.
    std::vector<std::int32_t> place;     ///< By node: index in bodies, −1 if in no wire.
};

/// Finds wires. A second search in a pattern of similar size allocates nothing.
class WireFinder {
  public:
    /// Return the adjacency of bodies. Valid until the next call while the pattern lives.
    [[nodiscard]] BodyGraph graph(const Pattern& pattern);

    /// Find wires by walks along nodes of small degree. Nodes with many neighbours (hulls, drums,
    /// junctions) and nodes beside another wire stay outside. Valid until the next call.
    [[nodiscard]] const Wires& find(const Pattern& pattern, const BodyGraph& graph);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void compute_prefix_sums(const BodyGraph& graph, std::size_t nodes,
                             const std::vector<std::uint8_t>& of);
    void find_wire_like(const Pattern& pattern, const BodyGraph& graph);
    void sort_by_degree(const BodyGraph& graph);
    void walk_wire(const Pattern& pattern, const BodyGraph& graph, std::int32_t seed);
    [[nodiscard]] std::int32_t only_unvisited_neighbour(const BodyGraph& graph, std::int32_t node,
                                                        std::int32_t& smallest) const noexcept;
    [[nodiscard]] std::int32_t next_wire_body(const Pattern& pattern, const BodyGraph& graph,
                                              std::int32_t before, std::int32_t now) const noexcept;
    void remove_touching_bodies(const BodyGraph& graph);

    std::vector<std::int32_t> start_, neighbours_, mark_, sum_;
    std::vector<std::uint8_t> hub_;
    std::vector<std::uint8_t> like_;        ///< May lie in a wire and no walk has visited it.
    std::vector<std::uint8_t> degree_;      ///< Number of neighbours that may lie in a wire.
    std::vector<std::int32_t> candidates_;  ///< Sorted by degree, then by index.
    std::vector<std::int32_t> walked_bodies_, walk_begin_;
    Wires wires_;
};

}  // namespace hawser::factor
