// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lineup.h
/// Order all units in a sequence such that few nodes have neighbours across any position.
///
/// The *frontier* at a position is the set of later nodes that have earlier neighbours. Without
/// these nodes the sequence would consist of two independent pieces. The next unit is the one of
/// the frontier and its neighbours that enlarges the frontier least. Sources: King, "An automatic
/// reordering scheme for simultaneous equations derived from network systems", 1970; candidates as
/// in Sloan's method, 1986.
///
/// A wire between two hubs of the frontier adds nothing to it, so wires precede the hubs at their
/// ends. In case of ties the unit whose cost changed last comes first. Units are those of
/// wires.h, so the cost is only about 0.1 µs for each node.

#include "graph/cost.h"
#include "graph/hypergraph.h"
#include "graph/neighbours.h"
#include "graph/wires.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hawser::graph {

class Lineup {
  public:
    void build(const Hypergraph& graph, const Neighbours& neighbours, const Cost& cost,
               const Units& units);

    std::vector<std::int32_t> order;  ///< Moving nodes, island by island.
    std::vector<std::int32_t> place;  ///< Index in `order` of each node, −1: does not move.
    /// Offsets of the islands in `order`, islands + 1 entries.
    std::vector<std::int32_t> island_begin;

  private:
    static constexpr std::int32_t kLowestKey = -64, kKeyBuckets = 512;
    enum State : std::int32_t { untouched, touched, placed };

    void connect(const Hypergraph& graph, const Neighbours& neighbours, const Units& units);
    void order_island(const Neighbours& neighbours, const Units& units, std::int32_t start);
    void append(const Neighbours& neighbours, const Units& units, std::int32_t unit);
    void add_to_frontier(std::int32_t unit) noexcept;
    void list(std::int32_t unit, std::int32_t bucket) noexcept;
    [[nodiscard]] std::int32_t cheapest_candidate() noexcept;
    [[nodiscard]] static std::int32_t bucket(std::int32_t key) noexcept {
        return std::clamp(key - kLowestKey, 0, kKeyBuckets - 1);
    }
    [[nodiscard]] std::int32_t outside_score(const Neighbours& neighbours, const Units& units,
                                             std::int32_t node) const noexcept;

    // Graph of units: offsets, neighbours, weights, marks.
    std::vector<std::int32_t> start_, adjacent_, weight_, mark_;
    // Candidates, sorted by the number of scalars that they add to the frontier. Each bucket is a
    // ring of units, newest first. Its head is entry count_ + bucket. The last bucket holds units
    // that need no list any more.
    std::vector<std::int32_t> key_;
    std::vector<State> state_;
    std::vector<std::int32_t> next_, previous_;
    std::int32_t count_ = 0, lowest_bucket_ = 0;
};

}  // namespace hawser::graph
