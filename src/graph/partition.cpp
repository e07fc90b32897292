// SPDX-License-Identifier: Apache-2.0
#include "graph/partition.h"

#include <algorithm>
#include <numeric>

namespace hawser::graph {

double Partition::imbalance() const noexcept {
    std::int64_t sum = 0, most = 0;
    for (const std::int64_t c : cost) {
        sum += c;
        most = std::max(most, c);
    }
    return sum > 0 ? static_cast<double>(most) * static_cast<double>(cost.size()) /
                         static_cast<double>(sum)
                   : 1.0;
}

void distribute(std::span<const std::int64_t> cost, std::span<std::int32_t> lane,
                std::span<std::int64_t> load, std::vector<std::int32_t>& order) {
    order.resize(cost.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return cost[at(a)] != cost[at(b)] ? cost[at(a)] > cost[at(b)] : a < b;
    });
    for (const std::int32_t item : order) {
        const auto least = std::min_element(load.begin(), load.end());
        *least += cost[at(item)];
        lane[at(item)] = static_cast<std::int32_t>(least - load.begin());
    }
}

void Partitioner::read(const Hypergraph& g) {
    graph = g;
    neighbours.build(graph);
    cost.build(graph, neighbours);
    units.build(graph, neighbours);
    lineup.build(graph, neighbours, cost, units);
}

}  // namespace hawser::graph
