// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// Contract the graph: the interior of each wire becomes one unit.
///
/// A *hub* has many neighbours (a hull, a drum). A *wire* is a sequence of other nodes. Each node
/// of a wire has no neighbours except hubs and nodes at most two positions away in the sequence.
/// Every other node is a separate unit. Scenes of ships and cables have about ten times fewer
/// units than nodes.

#include "graph/hypergraph.h"
#include "graph/neighbours.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

/// Largest number of neighbours of a node that is no hub.
inline constexpr std::int32_t kHubDegree = 16;
/// Reach of bending: it couples a node to the next but one.
inline constexpr std::int32_t kBendingReach = 2;
inline constexpr std::int32_t kShortestWire = 4;  ///< Least number of nodes of a wire.
inline constexpr std::int32_t kMaxContractedNodes =
    3;  ///< Largest number of nodes contracted outside wires.

class Units {
  public:
    void build(const Hypergraph& graph, const Neighbours& neighbours);

    [[nodiscard]] std::int32_t count() const noexcept {
        return static_cast<std::int32_t>(begin.size()) - 1;
    }
    [[nodiscard]] std::span<const std::int32_t> nodes_of(std::int32_t u) const noexcept {
        return {nodes.data() + begin[at(u)], nodes.data() + begin[at(u) + 1]};
    }

    std::vector<std::int32_t> unit;   ///< Unit of each node; −1: does not move.
    std::vector<std::int32_t> nodes;  ///< Nodes, unit by unit; those of a wire in its order.
    std::vector<std::int32_t> begin;  ///< Offsets of the units in `nodes`, units + 1 entries.
    std::vector<std::uint8_t> hub;    ///< 1 for each node that is a hub.
    std::int32_t wires = 0;           ///< Number of wires. Units 0 … wires − 1 are wires.

  private:
    void classify_nodes(const Hypergraph& graph, const Neighbours& neighbours);
    [[nodiscard]] std::int32_t end_sequence(std::int32_t size);
    void find_consecutive_wires(const Hypergraph& graph);
    void find_ends(const Neighbours& neighbours);
    void walk_wire(const Hypergraph& graph, const Neighbours& neighbours, std::int32_t end);
    [[nodiscard]] std::int32_t next_open_neighbour(const Neighbours& neighbours,
                                                   std::int32_t v) const noexcept;
    void remove_nodes_beside_wires(const Neighbours& neighbours);
    void close() noexcept;
    void add_free_nodes(const Hypergraph& graph);

    // By node: 1 if it may belong to a wire and is in none yet, else 0; number of such neighbours.
    std::vector<std::int32_t> open_, like_;
    std::vector<std::uint8_t>
        /// By node: bit 1 if it is a neighbour of the next node, bit 2 if of the next but one.
        bends_;
    /// Open nodes by their number of open neighbours, at most 2 kBendingReach.
    std::array<std::vector<std::int32_t>, 2 * kBendingReach + 1> end_;
    std::vector<std::int32_t> walked_;  ///< Sequences of nodes, before remove_nodes_beside_wires().
    std::vector<std::int32_t> from_;    ///< Offsets of the sequences in walked_.
    std::vector<std::int32_t> walk_index_;   ///< By node: 1 + index in walked_, 0: none.
    std::vector<std::int32_t> walk_;         ///< Sequence of each position, as stored in place_.
    std::vector<std::int32_t> leaves_wire_;  ///< By node: 1 if it may not stay in its sequence.
};

}  // namespace hawser::graph
