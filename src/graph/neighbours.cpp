// SPDX-License-Identifier: Apache-2.0
#include "graph/neighbours.h"

namespace hawser::graph {

void Neighbours::build(const Hypergraph& graph) {
    const std::size_t n = graph.size.size();
    start.assign(n + 1, 0);
    end.resize(n);
    edges.assign(n, 0);
    const std::int32_t count = graph.edges();
    for (std::int32_t e = 0; e < count; ++e) {
        const auto members = graph.edge(e);
        const auto others = static_cast<std::int32_t>(members.size()) - 1;
        for (const std::int32_t b : members) {
            ++edges[at(b)];
            start[at(b) + 1] += others;
        }
    }
    for (std::size_t b = 0; b < n; ++b) {
        start[b + 1] += start[b];
        end[b] = start[b];
    }
    adjacent.resize(at(start[n]));
    for (std::int32_t e = 0; e < count; ++e) {
        const auto members = graph.edge(e);
        std::int32_t i = 0;  // among members that move
        for (const std::int32_t a : members) {
            if (graph.size[at(a)] == 0) continue;
            std::int32_t j = 0;
            for (const std::int32_t b : members) {
                if (graph.size[at(b)] == 0) continue;
                if (a != b)
                    adjacent[at(end[at(a)]++)] = {2 * b + (i - j == 1 || j - i == 1 ? 0 : 1)};
                ++j;
            }
            ++i;
        }
    }
    // Each neighbour once, and near if any edge says so.
    mark_.assign(n, -1);
    for (std::size_t b = 0; b < n; ++b) {
        std::int32_t to = start[b];
        for (std::int32_t k = start[b]; k < end[b]; ++k) {
            const Neighbour u = adjacent[at(k)];
            std::int32_t& place = mark_[at(u.node())];
            if (place < start[b]) {
                place = to;
                adjacent[at(to++)] = u;
            } else if (u.near()) {
                adjacent[at(place)] = u;
            }
        }
        end[b] = to;
    }
}

}  // namespace hawser::graph
