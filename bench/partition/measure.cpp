// SPDX-License-Identifier: Apache-2.0
#include "partition/measure.h"

#include "base/executor.h"
#include "factor/analyse.h"
#include "factor/columns.h"
#include "factor/numeric.h"
#include "factor/symbolic.h"
#include "graph/hypergraph.h"
#include "index.h"
#include "linear/timing.h"
#include "partition/foreign.h"

#include <algorithm>
#include <cmath>

namespace hawser::bench {

FactorCounts count_factor(const factor::Pattern& pattern, const std::vector<std::int32_t>& order) {
    std::vector<std::int32_t> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        position[at(order[k])] = static_cast<std::int32_t>(k);
    factor::Columns columns;
    columns.build(pattern, order, position);
    FactorCounts counts;
    counts.node.resize(order.size());
    std::vector<std::int64_t> path(order.size(), 0);
    for (const std::int32_t v : order) {
        const std::int64_t s = pattern.size[at(v)], below = columns.below(v);
        counts.nnz += s * (s + 1) / 2 + s * below;
        counts.node[at(v)] = factor::front_flops(static_cast<int>(s), static_cast<int>(below));
        counts.flops += counts.node[at(v)];
        path[at(v)] += counts.node[at(v)];
        counts.path = std::max(counts.path, path[at(v)]);
        const std::int32_t parent = columns.parent(v);
        if (parent >= 0) path[at(parent)] = std::max(path[at(parent)], path[at(v)]);
    }
    return counts;
}

std::vector<std::int64_t> inside_costs(const factor::Pattern& pattern,
                                       const std::vector<std::int32_t>& part,
                                       const std::vector<std::int64_t>& counted) {
    std::vector<std::int64_t> cost = counted;
    for (std::int32_t v = 0; v < pattern.nodes(); ++v) {
        if (part[at(v)] >= 0) continue;
        std::int64_t sum = 0, count = 0;
        for (const std::int32_t u : pattern.neighbours(v))
            if (part[at(u)] >= 0) {
                sum += counted[at(u)];
                ++count;
            }
        cost[at(v)] = count > 0 ? sum / count : 0;
    }
    return cost;
}

double median_seconds(const std::function<void()>& f, int least) {
    std::vector<double> seconds;
    double sum = 0.0;
    // Repeat short calls more often: a median of a few microseconds needs many.
    while (static_cast<int>(seconds.size()) < least || (sum < 0.02 && seconds.size() < 1000)) {
        const double from = thread_seconds();
        f();
        seconds.push_back(thread_seconds() - from);
        sum += seconds.back();
    }
    return median(seconds);
}

double factor_seconds(const factor::Pattern& pattern, const std::vector<std::int32_t>& order,
                      int least) {
    const factor::Symbolic symbolic = factor::analyse(pattern, order);
    factor::Numeric numeric;
    numeric.reserve(symbolic, 1);
    base::SerialExecutor serial;
    std::vector<double> seconds, x(at(symbolic.scalars) + 8, 1.0);
    double sum = 0.0;
    while (static_cast<int>(seconds.size()) < least || (sum < 0.02 && seconds.size() < 200)) {
        // A diagonal matrix: times depend on the pattern alone.
        numeric.clear(symbolic, serial);
        for (std::int32_t v = 0; v < pattern.nodes(); ++v) {
            const factor::BlockTarget t = symbolic.target(v, v);
            for (std::int64_t i = 0; i < pattern.size[at(v)]; ++i)
                numeric.values()[t.address + i * (t.step + t.ld)] = 1.0;
        }
        const double from = thread_seconds();
        (void)numeric.factor(symbolic, serial);
        seconds.push_back(thread_seconds() - from);
        sum += seconds.back();
    }
    return median(seconds);
}

double factor_ms(const PartCase& c, const std::vector<std::int32_t>& order,
                 const FactorCounts& counts) {
    if (counts.flops > kMaxFlops) return std::nan("");
    return 1e3 * factor_seconds(c.pattern, order, c.bodies() > 20'000 ? 1 : 5);
}

PartRow measure_parts(const std::string& method, const PartCase& c,
                      const std::vector<std::int32_t>& part, int parts, const FactorCounts& amd) {
    PartRow row;
    row.method = method;
    const std::vector<std::int32_t> order = order_parts(c.pattern, part);
    row.counts = count_factor(c.pattern, order);
    std::vector<std::int64_t> load(at(parts), 0);
    std::int64_t between = 0, inside = 0, dearest = 0;
    for (std::size_t v = 0; v < part.size(); ++v) {
        if (part[v] < 0) {
            between += row.counts.node[v];
            ++row.separators;
            row.scalars += c.size[v];
            continue;
        }
        load[at(part[v])] += row.counts.node[v];
        inside += row.counts.node[v];
        dearest = std::max(dearest, row.counts.node[v]);
    }
    for (std::size_t e = 0; e + 1 < c.begin.size(); ++e)
        row.cut += std::any_of(c.members.begin() + c.begin[e], c.members.begin() + c.begin[e + 1],
                               [&](std::int32_t v) { return part[at(v)] < 0; });
    const std::int64_t most = *std::max_element(load.begin(), load.end());
    const double mean = static_cast<double>(std::max<std::int64_t>(1, inside)) / parts;
    row.imbalance = static_cast<double>(most) / mean;
    row.largest = static_cast<double>(dearest) / mean;
    row.fill = static_cast<double>(row.counts.nnz) / static_cast<double>(amd.nnz);
    row.flops = static_cast<double>(row.counts.flops) / static_cast<double>(amd.flops);
    row.makespan = static_cast<double>(most + between) / static_cast<double>(amd.flops);
    row.factor_ms = factor_ms(c, order, row.counts);
    return row;
}

}  // namespace hawser::bench
