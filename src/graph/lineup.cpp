// SPDX-License-Identifier: Apache-2.0
#include "graph/lineup.h"

#include <algorithm>
#include <numeric>

namespace hawser::graph {

/// Build the graph of units and the initial key of each unit. The key is the number of scalars that
/// its neighbours would add to the frontier.
void Lineup::connect(const Hypergraph& graph, const Neighbours& neighbours, const Units& units) {
    count_ = units.count();
    const std::size_t count = at(count_);
    start_.resize(count + 1);
    if (adjacent_.size() <= neighbours.adjacent.size())
        adjacent_.resize(neighbours.adjacent.size() + 1);
    weight_.resize(count);
    key_.resize(count);
    mark_.assign(count, -1);
    const std::uint8_t* size = graph.size.data();
    const std::int32_t *nodes = units.nodes.data(), *begin = units.begin.data();
    for (std::int32_t u = 0; u < count_; ++u)
        weight_[at(u)] = size[nodes[begin[u]]] * std::min(kBendingReach, begin[u + 1] - begin[u]);
    const std::int32_t *first = neighbours.start.data(), *last = neighbours.end.data();
    const std::int32_t *adjacent = neighbours.adjacent.data(), *unit = units.unit.data();
    const std::int32_t* weight = weight_.data();
    std::int32_t *to = adjacent_.data(), *mark = mark_.data();
    std::int32_t found = 0;
    for (std::int32_t u = 0; u < count_; ++u) {
        start_[at(u)] = found;
        mark[u] = u;
        std::int32_t sum = 0;
        for (std::int32_t i = begin[u]; i < begin[u + 1]; ++i) {
            // Consecutive node indices have their neighbours in one range.
            const std::int32_t from = first[nodes[i]];
            while (i + 1 < begin[u + 1] && nodes[i + 1] == nodes[i] + 1) ++i;
            const std::int32_t end = last[nodes[i]];
            for (std::int32_t k = from; k < end; ++k) {
                const std::int32_t other = unit[adjacent[k]];
                const std::int32_t fresh = mark[other] != u ? 1 : 0;
                mark[other] = u;
                to[found] = other;
                found += fresh;
                sum += weight[other] & -fresh;
            }
        }
        key_[at(u)] = sum;
    }
    start_[count] = found;
}

/// Move a candidate from its current bucket list to the front of another one.
void Lineup::list(std::int32_t unit, std::int32_t bucket) noexcept {
    std::int32_t *next = next_.data(), *previous = previous_.data();
    next[previous[unit]] = next[unit];
    previous[next[unit]] = previous[unit];
    const std::int32_t head = count_ + bucket, second = next[head];
    next[unit] = second;
    previous[unit] = head;
    previous[second] = unit;
    next[head] = unit;
    lowest_bucket_ = std::min(lowest_bucket_, bucket);
}

/// Add a unit to the frontier. Its neighbours become candidates and their keys decrease by its
/// weight.
void Lineup::add_to_frontier(std::int32_t unit) noexcept {
    state_[at(unit)] = touched;
    const std::int32_t weight = weight_[at(unit)];
    key_[at(unit)] -= weight;
    list(unit, bucket(key_[at(unit)]));
    for (std::int32_t k = start_[at(unit)]; k < start_[at(unit) + 1]; ++k) {
        const std::int32_t u = adjacent_[at(k)];
        key_[at(u)] -= weight;
        const std::int32_t slot = bucket(key_[at(u)]);
        list(u, state_[at(u)] == placed ? kKeyBuckets : slot);
    }
}

/// Return the candidate that enlarges the frontier least, −1: none.
std::int32_t Lineup::cheapest_candidate() noexcept {
    for (; lowest_bucket_ < kKeyBuckets; ++lowest_bucket_) {
        const std::int32_t unit = next_[at(count_ + lowest_bucket_)];
        if (unit < count_) return unit;
    }
    return -1;
}

/// Return a score of the neighbours of a wire's end node outside the wire: 2 for each neighbour
/// that already has a position in the order, −1 for each other one.
std::int32_t Lineup::outside_score(const Neighbours& neighbours, const Units& units,
                                   std::int32_t node) const noexcept {
    std::int32_t sum = 0;
    for (const std::int32_t u : neighbours.of(node))
        if (units.unit[at(u)] != units.unit[at(node)]) sum += place[at(u)] >= 0 ? 2 : -1;
    return sum;
}

void Lineup::append(const Neighbours& neighbours, const Units& units, std::int32_t unit) {
    const auto nodes = units.nodes_of(unit);
    const bool turned = unit < units.wires && outside_score(neighbours, units, nodes.back()) >
                                                  outside_score(neighbours, units, nodes.front());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::int32_t v = nodes[turned ? nodes.size() - 1 - i : i];
        place[at(v)] = static_cast<std::int32_t>(order.size());
        order.push_back(v);
    }
}

void Lineup::order_island(const Neighbours& neighbours, const Units& units, std::int32_t start) {
    list(start, bucket(key_[at(start)]));
    for (std::int32_t unit = cheapest_candidate(); unit >= 0; unit = cheapest_candidate()) {
        if (state_[at(unit)] == untouched) add_to_frontier(unit);
        state_[at(unit)] = placed;
        list(unit, kKeyBuckets);
        append(neighbours, units, unit);
        for (std::int32_t k = start_[at(unit)]; k < start_[at(unit) + 1]; ++k)
            if (state_[at(adjacent_[at(k)])] == untouched) add_to_frontier(adjacent_[at(k)]);
    }
}

void Lineup::build(const Hypergraph& graph, const Neighbours& neighbours, const Cost& cost,
                   const Units& units) {
    connect(graph, neighbours, units);
    state_.assign(at(count_), untouched);
    // Make each unit a ring of its own, which means it is in no list.
    next_.resize(at(count_ + kKeyBuckets) + 1);
    std::iota(next_.begin(), next_.end(), 0);
    previous_ = next_;
    place.assign(graph.size.size(), -1);
    order.clear();
    order.reserve(graph.size.size());
    island_begin.assign(1, 0);
    for (std::int32_t i = 0; i < cost.islands(); ++i) {
        lowest_bucket_ = 0;
        // Start at the node farthest from the heaviest one: the free end of a cable, the corner of
        // a net.
        order_island(neighbours, units, units.unit[at(cost.order[at(cost.begin[at(i) + 1] - 1)])]);
        island_begin.push_back(static_cast<std::int32_t>(order.size()));
    }
}

}  // namespace hawser::graph
