// SPDX-License-Identifier: Apache-2.0
#include "report/elimination.h"

#include "base/index.h"

#include <algorithm>
#include <cstddef>

namespace hawser::report {

EliminationCounts count_elimination(const SystemView& view,
                                    const std::vector<std::int32_t>& order) {
    const std::size_t n = view.nodes.size();
    std::vector<std::int32_t> position(n), mark(n, -1), head(n, -1), next(n, -1);
    for (std::size_t k = 0; k < order.size(); ++k)
        position[at(order[k])] = static_cast<std::int32_t>(k);
    std::vector<std::vector<std::int32_t>> below(n);
    std::vector<std::int64_t> path(n, 0);
    EliminationCounts counts;
    for (const std::int32_t v : order) {
        std::vector<std::int32_t>& rows = below[at(v)];
        mark[at(v)] = v;
        const auto take = [&](std::int32_t u) {
            if (position[at(u)] <= position[at(v)] || mark[at(u)] == v) return;
            mark[at(u)] = v;
            rows.push_back(u);
        };
        for (std::int32_t k = view.edge_start[at(v)]; k < view.edge_start[at(v) + 1]; ++k)
            take(view.edges[at(k)]);
        for (std::int32_t c = head[at(v)]; c >= 0; c = next[at(c)]) {
            for (const std::int32_t u : below[at(c)]) take(u);
            below[at(c)] = {};  // only its parent needs it
        }
        std::int64_t scalars = 0;
        std::int32_t parent = -1;
        for (const std::int32_t u : rows) {
            scalars += view.nodes[at(u)].size;
            if (parent < 0 || position[at(u)] < position[at(parent)]) parent = u;
        }
        const std::int64_t s = view.nodes[at(v)].size;
        counts.nnz += s * (s + 1) / 2 + s * scalars;
        std::int64_t flops = 0;
        for (std::int64_t m = scalars + s - 1; m >= scalars; --m) flops += m * (m + 2);
        counts.flops += flops;
        path[at(v)] += flops;
        counts.path = std::max(counts.path, path[at(v)]);
        if (parent < 0) continue;
        path[at(parent)] = std::max(path[at(parent)], path[at(v)]);
        next[at(v)] = head[at(parent)];
        head[at(parent)] = v;
    }
    return counts;
}

}  // namespace hawser::report
