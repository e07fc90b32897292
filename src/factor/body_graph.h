// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file body_graph.h
/// Which bodies couple, directly or through rows, and the wires among them.

#include "factor/pattern.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// Adjacency of positive nodes; two are neighbours when an edge or a negative node joins them.
struct BodyGraph {
    std::vector<std::int32_t> start, adjacent;
    [[nodiscard]] std::span<const std::int32_t> neighbours(std::int32_t node) const noexcept {
        const auto n = static_cast<std::size_t>(node);
        return {adjacent.data() + start[n], adjacent.data() + start[n + 1]};
    }
};

[[nodiscard]] BodyGraph body_graph(const Pattern& pattern);

/// Sequences of bodies of one size in which each couples only to the next one or two, and to
/// bodies that are in no wire. Bodies of two wires never couple.
struct Wires {
    std::vector<std::int32_t> bodies;    ///< Nodes of all wires.
    std::vector<std::int32_t> begin{0};  ///< wires + 1 offsets into bodies.
    std::vector<std::int32_t> place;     ///< By node: index in bodies, −1 if in no wire.
};

/// Walk along nodes of small degree; nodes with many neighbours (hulls, drums, junctions) stay
/// outside, as does every node beside another wire.
[[nodiscard]] Wires find_wires(const Pattern& pattern, const BodyGraph& graph);

}  // namespace hawser::factor
