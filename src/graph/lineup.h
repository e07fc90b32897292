// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lineup.h
/// All units in one line, so that few nodes reach across any place of it.
///
/// The *frontier* behind a place are the nodes after it with neighbours before it; without them
/// the line falls apart there. The next unit is that which enlarges the frontier least, among the
/// frontier and its neighbours (King, "An automatic reordering scheme for simultaneous equations
/// derived from network systems", 1970; candidates as in Sloan's method, 1986): a wire between
/// two hubs that are waiting costs nothing, so wires come before the hubs that hold them. Ties
/// go to the unit that was touched last. Units are as wires.h makes them, which is what
/// makes this quick: about a tenth of a microsecond a node.

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

    std::vector<std::int32_t> order;         ///< Moving nodes, island by island.
    std::vector<std::int32_t> place;         ///< By node: index in order, −1: does not move.
    std::vector<std::int32_t> island_begin;  ///< islands + 1 offsets into order.

  private:
    static constexpr std::int32_t kLow = -64, kBuckets = 512;
    enum State : std::int32_t { untouched, touched, placed };

    void connect(const Hypergraph& graph, const Neighbours& neighbours, const Units& units);
    void grow(const Neighbours& neighbours, const Units& units, std::int32_t start);
    void append(const Neighbours& neighbours, const Units& units, std::int32_t unit);
    void touch(std::int32_t unit) noexcept;
    void list(std::int32_t unit, std::int32_t bucket) noexcept;
    [[nodiscard]] std::int32_t cheapest() noexcept;
    [[nodiscard]] static std::int32_t bucket(std::int32_t key) noexcept {
        return std::clamp(key - kLow, 0, kBuckets - 1);
    }
    [[nodiscard]] std::int32_t outside(const Neighbours& neighbours, const Units& units,
                                       std::int32_t node) const noexcept;

    // Units and their neighbours.
    std::vector<std::int32_t> start_, adjacent_, weight_, mark_;
    // Candidates by how much they enlarge the frontier: rings of units, newest first, each through
    // the head of its bucket, which is number count_ + bucket. The last one is for units that need
    // no list any more.
    std::vector<std::int32_t> key_;
    std::vector<State> state_;
    std::vector<std::int32_t> next_, previous_;
    std::int32_t count_ = 0, lowest_ = 0;
};

}  // namespace hawser::graph
