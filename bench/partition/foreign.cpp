// SPDX-License-Identifier: Apache-2.0
#include "partition/foreign.h"

#include "factor/ordering.h"
#include "graph/hypergraph.h"
#include "index.h"

#include <cstdio>

extern "C" {
#if HAWSER_HAVE_CAMD
#include <camd.h>
#endif
#if HAWSER_HAVE_METIS
#include <metis.h>
#endif
#if HAWSER_HAVE_SCOTCH
#include <scotch.h>
#endif
}

#include <algorithm>
#include <queue>
#include <stdexcept>
#include <tuple>

namespace hawser::bench {

using graph::kSeparator;

ForeignGraph::ForeignGraph(const factor::Pattern& pattern)
    : start(pattern.start.begin(), pattern.start.end()),
      adjacent(pattern.adjacent.begin(), pattern.adjacent.end()),
      weight(pattern.size.begin(), pattern.size.end()) {}

std::vector<std::int32_t> metis_parts([[maybe_unused]] ForeignGraph& g,
                                      [[maybe_unused]] std::vector<int>& weight,
                                      [[maybe_unused]] int parts) {
#if HAWSER_HAVE_METIS
    static_assert(sizeof(idx_t) == sizeof(int));
    idx_t n = g.nodes(), constraints = 1, k = parts, cut = 0;
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    std::vector<std::int32_t> part(at(n), 0);
    if (METIS_PartGraphKway(&n, &constraints, g.start.data(), g.adjacent.data(), weight.data(),
                            nullptr, nullptr, &k, nullptr, nullptr, options, &cut,
                            part.data()) != METIS_OK)
        throw std::runtime_error("METIS failed");
    return part;
#else
    return {};
#endif
}

std::vector<std::int32_t> metis_order([[maybe_unused]] ForeignGraph& g) {
#if HAWSER_HAVE_METIS
    idx_t n = g.nodes();
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    std::vector<std::int32_t> order(at(n)), place(at(n));
    if (METIS_NodeND(&n, g.start.data(), g.adjacent.data(), g.weight.data(), options, order.data(),
                     place.data()) != METIS_OK)
        throw std::runtime_error("METIS failed");
    return order;
#else
    return {};
#endif
}

#if HAWSER_HAVE_SCOTCH
namespace {

/// Graph and strategy of one call.
struct Scotch {
    SCOTCH_Graph graph;
    SCOTCH_Strat strategy;

    explicit Scotch(ForeignGraph& g) {
        static_assert(sizeof(SCOTCH_Num) == sizeof(int));
        SCOTCH_randomReset();
        SCOTCH_graphInit(&graph);
        SCOTCH_stratInit(&strategy);
        if (SCOTCH_graphBuild(&graph, 0, g.nodes(), g.start.data(), g.start.data() + 1,
                              g.weight.data(), nullptr, static_cast<int>(g.adjacent.size()),
                              g.adjacent.data(), nullptr) != 0)
            throw std::runtime_error("Scotch refuses the graph");
    }
    ~Scotch() {
        SCOTCH_stratExit(&strategy);
        SCOTCH_graphExit(&graph);
    }
    Scotch(const Scotch&) = delete;
    Scotch& operator=(const Scotch&) = delete;
};

}  // namespace
#endif

std::vector<std::int32_t> scotch_parts([[maybe_unused]] ForeignGraph& g,
                                       [[maybe_unused]] int parts) {
#if HAWSER_HAVE_SCOTCH
    Scotch s(g);
    std::vector<std::int32_t> part(at(g.nodes()), 0);
    if (SCOTCH_graphPart(&s.graph, parts, &s.strategy, part.data()) != 0)
        throw std::runtime_error("Scotch failed");
    return part;
#else
    return {};
#endif
}

std::vector<std::int32_t> scotch_order([[maybe_unused]] ForeignGraph& g) {
#if HAWSER_HAVE_SCOTCH
    Scotch s(g);
    std::vector<std::int32_t> place(at(g.nodes())), order(at(g.nodes()));
    if (SCOTCH_graphOrder(&s.graph, &s.strategy, place.data(), order.data(), nullptr, nullptr,
                          nullptr) != 0)
        throw std::runtime_error("Scotch failed");
    return order;
#else
    return {};
#endif
}

void cover_cuts(const factor::Pattern& pattern, std::vector<std::int32_t>& parts) {
    const std::vector<std::int32_t> old = parts;
    std::vector<std::int32_t> open(old.size(), 0);
    // Sorted by uncovered edges per scalar, then by number; outdated entries are skipped.
    using Entry = std::tuple<double, std::int32_t, std::int32_t>;
    std::priority_queue<Entry> queue;
    const auto offer = [&](std::int32_t v) {
        if (open[at(v)] > 0)
            queue.push({static_cast<double>(open[at(v)]) / pattern.size[at(v)], -v, open[at(v)]});
    };
    for (int v = 0; v < pattern.nodes(); ++v) {
        for (const std::int32_t u : pattern.neighbours(v)) open[at(v)] += old[at(u)] != old[at(v)];
        offer(v);
    }
    while (!queue.empty()) {
        const auto [gain, minus, count] = queue.top();
        queue.pop();
        const std::int32_t v = -minus;
        if (open[at(v)] != count || parts[at(v)] == kSeparator) continue;
        parts[at(v)] = kSeparator;
        for (const std::int32_t u : pattern.neighbours(v))
            if (old[at(u)] != old[at(v)] && parts[at(u)] != kSeparator) {
                --open[at(u)];
                offer(u);
            }
    }
}

std::vector<std::int32_t> order_parts(const factor::Pattern& pattern,
                                      const std::vector<std::int32_t>& parts) {
#if HAWSER_HAVE_CAMD
    const int n = pattern.nodes();
    std::vector<std::int32_t> order(at(n)), last(at(n));
    for (int v = 0; v < n; ++v) last[at(v)] = parts[at(v)] == kSeparator ? 1 : 0;
    double control[CAMD_CONTROL], info[CAMD_INFO];
    camd_defaults(control);
    control[CAMD_DENSE] = 100.0;  // like factor::order_nodes()
    if (camd_order(n, pattern.start.data(), pattern.adjacent.data(), order.data(), control, info,
                   last.data()) < 0)
        throw std::runtime_error("CAMD failed");
    return order;
#else
    std::vector<std::int32_t> order = factor::order_nodes(pattern);
    std::stable_partition(order.begin(), order.end(),
                          [&](std::int32_t v) { return parts[at(v)] != kSeparator; });
    return order;
#endif
}

}  // namespace hawser::bench
