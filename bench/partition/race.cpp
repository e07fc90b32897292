// SPDX-License-Identifier: Apache-2.0
#include "partition/race.h"

#include "graph/split.h"
#include "index.h"
#include "linear/timing.h"
#include "partition/foreign.h"
#include "partition/measure.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace hawser::bench {

void repartition(const graph::Hypergraph& g, int parts, graph::Partitioner& p,
                 graph::Partition& out) {
    p.graph = g;
    p.cost.build(g, p.neighbours);
    p.units.build(g, p.neighbours);
    p.lineup.build(g, p.neighbours, p.cost, p.units);
    p.separate({parts}, out);
}

Race race(const PartCase& c, int parts, const std::vector<std::int64_t>& exact) {
    const int least = c.bodies() > 20'000 ? 3 : 61;
    ForeignGraph f(c.pattern);
    const graph::Hypergraph g = c.graph(exact);
    graph::Hypergraph weighted = g;
    // Weights like those of physics, of any size: their values do not change the work.
    std::vector<std::int32_t> edge(at(g.edges())), node(at(g.nodes()));
    for (std::size_t e = 0; e < edge.size(); ++e)
        edge[e] = static_cast<std::int32_t>(e * 7919 % 1000);
    for (std::size_t v = 0; v < node.size(); ++v)
        node[v] = static_cast<std::int32_t>(v * 104729 % 1000);
    weighted.edge_weight = edge;
    weighted.node_weight = node;
    graph::Partitioner p;
    graph::Partition out;
    graph::Splitter splitter;
    const bool foreign = !metis_parts(f, f.weight, parts).empty();
    const auto metis = [&] { (void)metis_parts(f, f.weight, parts); };
    const auto ours = [&] { repartition(g, parts, p, out); };
    const auto time_of = [](const auto& call) {
        const double from = thread_seconds();
        call();
        return thread_seconds() - from;
    };
    Race r;
    r.graph = median_seconds([&] { p.neighbours.build(g); }, least);
    std::vector<double> a, b, d;
    for (int i = 0; i < least; ++i) {
        a.push_back(time_of(metis));
        b.push_back(time_of(ours));
        graph::Partitioner other;
        graph::Partition parts_of_other;
        other.neighbours.build(g);
        d.push_back(time_of([&] { repartition(g, parts, other, parts_of_other); }));
    }
    r.metis_turn = foreign ? median(a) : 0.0;
    r.turn = median(b);
    r.fresh = median(d);
    // Measure each separately, also in turns, so that both run on an equal machine.
    a.clear();
    b.clear();
    for (int i = 0; i < 15; ++i) {
        a.push_back(median_seconds(metis, least / 3));
        b.push_back(median_seconds(ours, least / 3));
    }
    r.metis = foreign ? median(a) : 0.0;
    r.ours = median(b);
    r.cuts = median_seconds([&] { splitter.split(weighted, {parts}, out); }, least);
    return r;
}

nlohmann::json print_race(const Race& r) {
    const auto line = [&](const char* what, double seconds, double metis) {
        fmt::print("  {:<60} {:>9.1f} us", what, 1e6 * seconds);
        if (metis > 0.0) fmt::print(", METIS {:>6.1f}x", metis / seconds);
        fmt::print("\n");
    };
    line("ours from the body graph, with cost, again and again", r.ours, r.metis);
    line("  by turns with METIS", r.turn, r.metis_turn);
    line("  by turns with METIS, a new object without memory", r.fresh, r.metis_turn);
    line("  and the body graph from interactions", r.ours + r.graph, r.metis);
    line("cuts instead of separators, made-up weights, graph included", r.cuts, r.metis);
    return {{"metis_seconds", r.metis},
            {"metis_by_turns_seconds", r.metis_turn},
            {"seconds", r.ours},
            {"by_turns_seconds", r.turn},
            {"new_object_seconds", r.fresh},
            {"graph_seconds", r.graph},
            {"cuts_seconds", r.cuts}};
}

}  // namespace hawser::bench
