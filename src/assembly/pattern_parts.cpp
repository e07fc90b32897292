// SPDX-License-Identifier: Apache-2.0
#include "assembly/pattern_parts.h"

#include "assembly/part_cost.h"
#include "base/index.h"
#include "graph/partition.h"

#include <algorithm>
#include <utility>

namespace hawser::assembly {
std::vector<std::int32_t> pattern_parts(const factor::Pattern& pattern,
                                        const factor::Symbolic* known, int parts) {
    const std::int32_t n = pattern.nodes();
    // A negative node is a hyperedge that joins its positive neighbours; as a node it is fixed.
    std::vector<std::uint8_t> size(at(n));
    std::vector<std::int32_t> begin{0}, members;
    for (std::int32_t v = 0; v < n; ++v) {
        const bool positive = pattern.sign[at(v)] > 0;
        size[at(v)] = static_cast<std::uint8_t>(positive ? pattern.size[at(v)] : 0);
        for (const std::int32_t u : pattern.neighbours(v)) {
            if (pattern.sign[at(u)] < 0) continue;
            if (!positive) members.push_back(u);
            if (!positive || u > v) continue;
            members.insert(members.end(), {u, v});
            begin.push_back(static_cast<std::int32_t>(members.size()));
        }
        if (!positive) begin.push_back(static_cast<std::int32_t>(members.size()));
    }
    std::vector<std::int64_t> cost;
    if (known != nullptr) {
        cost = node_flops(pattern, *known);
        for (std::int32_t v = 0; v < n; ++v) {
            if (pattern.sign[at(v)] > 0) continue;
            std::int32_t first = -1;  // rows follow the body that is eliminated first
            for (const std::int32_t u : pattern.neighbours(v))
                if (pattern.sign[at(u)] > 0 &&
                    (first < 0 || known->position[at(u)] < known->position[at(first)]))
                    first = u;
            if (first >= 0) cost[at(first)] += cost[at(v)];
        }
    }
    graph::Partitioner partitioner;
    graph::Partition partition;
    partitioner.read({size, begin, members, {}, {}, {}, cost});
    partitioner.separate({parts}, partition);
    // Negative nodes with an edge between each other stay in the separator. No mechanical system
    // has them.
    for (std::int32_t v = 0; v < n; ++v) {
        if (pattern.sign[at(v)] > 0) continue;
        std::int32_t part = graph::kSeparator;
        bool alone = true;
        for (const std::int32_t u : pattern.neighbours(v)) {
            if (pattern.sign[at(u)] > 0)
                part = std::max(part, partition.part[at(u)]);
            else
                alone = false;
        }
        partition.part[at(v)] = alone ? part : graph::kSeparator;
    }
    return std::move(partition.part);
}

}  // namespace hawser::assembly
