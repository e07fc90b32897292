// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// Contraction: the insides of wires become one unit each.
///
/// A *hub* has many neighbours (a hull, a drum). A *wire* is a sequence of other nodes in which
/// each has no neighbours but hubs and those at most two places away in it. All else is a unit by
/// itself. In scenes of ships and cables units are some ten times fewer than nodes.

#include "graph/hypergraph.h"
#include "graph/neighbours.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

inline constexpr std::int32_t kHubDegree = 16;    ///< More neighbours than this make a hub.
inline constexpr std::int32_t kReach = 2;         ///< Bending couples a node to the next but one.
inline constexpr std::int32_t kShortestWire = 4;  ///< Nodes.
inline constexpr std::int32_t kLump = 3;          ///< Nodes at most that are contracted elsewhere.

class Units {
  public:
    void build(const Hypergraph& graph, const Neighbours& neighbours);

    [[nodiscard]] std::int32_t count() const noexcept {
        return static_cast<std::int32_t>(begin.size()) - 1;
    }
    [[nodiscard]] std::span<const std::int32_t> nodes_of(std::int32_t u) const noexcept {
        return {nodes.data() + begin[at(u)], nodes.data() + begin[at(u) + 1]};
    }

    std::vector<std::int32_t> unit;   ///< By node; −1: does not move.
    std::vector<std::int32_t> nodes;  ///< Unit by unit; those of a wire in its order.
    std::vector<std::int32_t> begin;  ///< units + 1 offsets into nodes.
    std::vector<std::uint8_t> hub;    ///< By node.
    std::int32_t wires = 0;           ///< Units 0 … wires − 1 are wires.

  private:
    void classify(const Hypergraph& graph, const Neighbours& neighbours);
    [[nodiscard]] std::int32_t end_sequence(std::int32_t size);
    void follow_numbers(const Hypergraph& graph);
    void find_ends(const Neighbours& neighbours);
    void walk(const Hypergraph& graph, const Neighbours& neighbours, std::int32_t end);
    [[nodiscard]] std::int32_t next(const Neighbours& neighbours, std::int32_t v) const noexcept;
    void keep_whole(const Neighbours& neighbours);
    void close() noexcept;
    void add_lumps(const Hypergraph& graph);

    // By node: may be in a wire and is in none yet (1 or 0); neighbours that may be.
    std::vector<std::int32_t> open_, like_;
    std::vector<std::uint8_t>
        bends_;  ///< By node: 1, 2: a neighbour of the next, of the next but one.
    /// Nodes that may be in a wire by neighbours of their kind, at most 2 kReach.
    std::array<std::vector<std::int32_t>, 2 * kReach + 1> end_;
    std::vector<std::int32_t> walked_;  ///< Sequences of nodes, before keep_whole().
    std::vector<std::int32_t> from_;    ///< Where they begin.
    std::vector<std::int32_t> place_;   ///< By node: 1 + index in walked_, 0: none.
    std::vector<std::int32_t> walk_;    ///< By place: its sequence.
    std::vector<std::int32_t> apart_;   ///< By node: 1: it may not stay in its sequence.
};

}  // namespace hawser::graph
