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
}

void Lineup::put(std::int32_t unit) noexcept {
    const std::int32_t b = bucket(unit);
    next_[at(unit)] = -1;
    previous_[at(unit)] = tail_[at(b)];
    (tail_[at(b)] < 0 ? head_[at(b)] : next_[at(tail_[at(b)])]) = unit;
    tail_[at(b)] = unit;
    listed_[at(unit)] = 1;
    lowest_ = std::min(lowest_, b);
}

void Lineup::take(std::int32_t unit) noexcept {
    const std::int32_t b = bucket(unit), p = previous_[at(unit)], n = next_[at(unit)];
    (p < 0 ? head_[at(b)] : next_[at(p)]) = n;
    (n < 0 ? tail_[at(b)] : previous_[at(n)]) = p;
    listed_[at(unit)] = 0;
}

/// Make a unit a candidate: its key is what its untouched neighbours add to the frontier.
void Lineup::offer(std::int32_t unit) {
    std::int32_t key = 0;
    for (std::int32_t k = start_[at(unit)]; k < start_[at(unit) + 1]; ++k) {
        const std::int32_t u = adjacent_[at(k)];
        if (state_[at(u)] <= candidate) key += weight_[at(u)];
    }
    key_[at(unit)] = key;
    state_[at(unit)] = candidate;
    put(unit);
}

/// A unit joins the frontier; its neighbours become candidates, cheaper by it.
void Lineup::touch(std::int32_t unit) {
    if (state_[at(unit)] == untouched) offer(unit);
    state_[at(unit)] = touched;
    take(unit);
    key_[at(unit)] -= weight_[at(unit)];
    put(unit);
    for (std::int32_t k = start_[at(unit)]; k < start_[at(unit) + 1]; ++k) {
        const std::int32_t u = adjacent_[at(k)];
        if (state_[at(u)] == placed) continue;
        if (state_[at(u)] == untouched) {
            offer(u);
            continue;
        }
        take(u);
        key_[at(u)] -= weight_[at(unit)];
        put(u);
    }
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
    offer(start);
    for (;;) {
        while (lowest_ < kBuckets && head_[at(lowest_)] < 0) ++lowest_;
        if (lowest_ == kBuckets) return;
        const std::int32_t unit = head_[at(lowest_)];
        if (state_[at(unit)] != touched) touch(unit);
        take(unit);
        state_[at(unit)] = placed;
        append(neighbours, units, unit);
        for (std::int32_t k = start_[at(unit)]; k < start_[at(unit) + 1]; ++k)
            if (state_[at(adjacent_[at(k)])] <= candidate) touch(adjacent_[at(k)]);
    }
}

void Lineup::build(const Hypergraph& graph, const Neighbours& neighbours, const Cost& cost,
                   const Units& units) {
    connect(graph, neighbours, units);
    const auto count = at(units.count());
    key_.assign(count, 0);
    next_.resize(count);
    previous_.resize(count);
    state_.assign(count, untouched);
    listed_.assign(count, 0);
    head_.fill(-1);
    tail_.fill(-1);
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
