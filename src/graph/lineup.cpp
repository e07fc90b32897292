// SPDX-License-Identifier: Apache-2.0
#include "graph/lineup.h"

#include <algorithm>

namespace hawser::graph {

void Lineup::connect(const Hypergraph& graph, const Neighbours& neighbours, const Units& units) {
    const std::int32_t count = units.count();
    start_.assign(1, 0);
    start_.reserve(at(count) + 1);
    adjacent_.clear();
    adjacent_.reserve(neighbours.adjacent.size());
    weight_.resize(at(count));
    mark_.assign(at(count), -1);
    for (std::int32_t u = 0; u < count; ++u) {
        mark_[at(u)] = u;
        for (const std::int32_t v : units.nodes_of(u))
            for (const Neighbour w : neighbours.of(v)) {
                const std::int32_t other = units.unit[at(w.node())];
                if (mark_[at(other)] == u) continue;
                mark_[at(other)] = u;
                adjacent_.push_back(other);
            }
        start_.push_back(static_cast<std::int32_t>(adjacent_.size()));
        const std::int32_t size = graph.size[at(units.nodes[at(units.begin[at(u)])])];
        weight_[at(u)] = u < units.wires ? kReach * size : size;
    }
    // Of a unit that nothing has touched: all that its neighbours would add to the frontier.
    key_.assign(at(count), 0);
    for (std::int32_t u = 0; u < count; ++u)
        for (std::int32_t k = start_[at(u)]; k < start_[at(u) + 1]; ++k)
            key_[at(u)] += weight_[at(adjacent_[at(k)])];
}

/// List a candidate under its present key; what it was listed under before is passed over later.
void Lineup::list(std::int32_t unit) {
    const std::int32_t b = bucket(unit);
    entries_.push_back({unit, head_[at(b)]});
    head_[at(b)] = static_cast<std::int32_t>(entries_.size()) - 1;
    lowest_ = std::min(lowest_, b);
}

/// A unit joins the frontier; its neighbours become candidates, cheaper by it.
void Lineup::touch(std::int32_t unit) {
    state_[at(unit)] = touched;
    const std::int32_t weight = weight_[at(unit)];
    key_[at(unit)] -= weight;
    list(unit);
    for (std::int32_t k = start_[at(unit)]; k < start_[at(unit) + 1]; ++k) {
        const std::int32_t u = adjacent_[at(k)];
        key_[at(u)] -= weight;
        if (state_[at(u)] != placed) list(u);
    }
}

/// The candidate that enlarges the frontier least, −1: none.
std::int32_t Lineup::cheapest() noexcept {
    for (; lowest_ < kBuckets; ++lowest_)
        while (head_[at(lowest_)] >= 0) {
            const Entry e = entries_[at(head_[at(lowest_)])];
            head_[at(lowest_)] = e.next;
            if (state_[at(e.unit)] != placed && bucket(e.unit) == lowest_) return e.unit;
        }
    return -1;
}

/// Neighbours of an end of a wire outside it: those in the line count double.
std::int32_t Lineup::outside(const Neighbours& neighbours, const Units& units,
                             std::int32_t node) const noexcept {
    std::int32_t sum = 0;
    for (const Neighbour u : neighbours.of(node))
        if (units.unit[at(u.node())] != units.unit[at(node)])
            sum += place[at(u.node())] >= 0 ? 2 : -1;
    return sum;
}

void Lineup::append(const Neighbours& neighbours, const Units& units, std::int32_t unit) {
    const auto nodes = units.nodes_of(unit);
    const bool turned = unit < units.wires && outside(neighbours, units, nodes.back()) >
                                                  outside(neighbours, units, nodes.front());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::int32_t v = nodes[turned ? nodes.size() - 1 - i : i];
        place[at(v)] = static_cast<std::int32_t>(order.size());
        order.push_back(v);
    }
}

void Lineup::grow(const Neighbours& neighbours, const Units& units, std::int32_t start) {
    list(start);
    for (std::int32_t unit = cheapest(); unit >= 0; unit = cheapest()) {
        if (state_[at(unit)] == untouched) touch(unit);
        state_[at(unit)] = placed;
        append(neighbours, units, unit);
        for (std::int32_t k = start_[at(unit)]; k < start_[at(unit) + 1]; ++k)
            if (state_[at(adjacent_[at(k)])] == untouched) touch(adjacent_[at(k)]);
    }
}

void Lineup::build(const Hypergraph& graph, const Neighbours& neighbours, const Cost& cost,
                   const Units& units) {
    connect(graph, neighbours, units);
    const auto count = at(units.count());
    state_.assign(count, untouched);
    head_.fill(-1);
    entries_.clear();
    entries_.reserve(adjacent_.size() + 2 * count);
    place.assign(graph.size.size(), -1);
    order.clear();
    order.reserve(graph.size.size());
    island_begin.assign(1, 0);
    for (std::int32_t i = 0; i < cost.islands(); ++i) {
        lowest_ = 0;
        // Farthest from the heaviest node: the free end of a cable, the corner of a net.
        grow(neighbours, units, units.unit[at(cost.order[at(cost.begin[at(i) + 1] - 1)])]);
        island_begin.push_back(static_cast<std::int32_t>(order.size()));
    }
}

}  // namespace hawser::graph
