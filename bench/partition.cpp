// SPDX-License-Identifier: Apache-2.0
// hawser-bench partition: our parts beside those of METIS and Scotch, on the same graphs.
#include "graph/partition.h"
#include "commands.h"
#include "factor/ordering.h"
#include "graph/follow.h"
#include "graph/split.h"
#include "index.h"
#include "linear/timing.h"
#include "paper_matrix/structures.h"
#include "partition/cases.h"
#include "partition/cost_study.h"
#include "partition/foreign.h"
#include "partition/measure.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace hawser::bench {
namespace {

struct PartitionFlags {
    int scale = 1, parts = 4;
    bool cost = false;
    std::string json, picture;
};

/// Rounds of partition and exact cost: each takes the flops of the one before, and the most even
/// one counts. A running world has them from its last analysis.
constexpr int kPartRounds = 5;

void print_part_heading() {
    fmt::print("  {:<22} {:>9} {:>5} {:>5} {:>5} {:>9} {:>7} {:>6} {:>6} {:>8} {:>9}\n", "method",
               "us", "sep", "scal", "cut", "imbalance", "dearest", "fill", "flops", "makespan",
               "factor ms");
}

nlohmann::json print_part_row(const PartRow& r) {
    fmt::print(
        "  {:<22} {:>9.1f} {:>5} {:>5} {:>5} {:>9.3f} {:>7.3f} {:>6.3f} {:>6.3f} {:>8.3f} "
        "{:>9.3f}\n",
        r.method, 1e6 * r.seconds, r.separators, r.scalars, r.cut, r.imbalance, r.largest, r.fill,
        r.flops, r.makespan, r.factor_ms);
    return {{"method", r.method},
            {"seconds", r.seconds},
            {"separators", r.separators},
            {"scalars", r.scalars},
            {"cut", r.cut},
            {"imbalance", r.imbalance},
            {"dearest", r.largest},
            {"fill", r.fill},
            {"flops", r.flops},
            {"makespan", r.makespan},
            {"factor_ms", r.factor_ms}};
}

/// An order without parts: fill, flops, and the longest path as its makespan.
PartRow order_row(const std::string& name, const PartCase& c,
                  const std::vector<std::int32_t>& order, double seconds, const FactorCounts& amd) {
    PartRow r;
    r.method = name;
    r.seconds = seconds;
    r.counts = count_factor(c.pattern, order);
    r.fill = static_cast<double>(r.counts.nnz) / static_cast<double>(amd.nnz);
    r.flops = static_cast<double>(r.counts.flops) / static_cast<double>(amd.flops);
    r.makespan = static_cast<double>(r.counts.path) / static_cast<double>(amd.flops);
    r.factor_ms = 1e3 * factor_seconds(c.pattern, order, 5);
    return r;
}

struct OurParts {
    graph::Partitioner partitioner;
    graph::Partition partition;
    std::vector<std::int64_t> exact;
};

/// Cost, contraction, line and parts: all that comes after the body graph.
void partition_again(const graph::Hypergraph& g, int parts, graph::Partitioner& p,
                     graph::Partition& out) {
    p.graph = g;
    p.cost.build(g, p.neighbours);
    p.units.build(g, p.neighbours);
    p.lineup.build(g, p.neighbours, p.cost, p.units);
    p.separate({parts}, out);
}

/// Time from the body graph, which METIS gets ready-made as well.
PartRow our_row(const std::string& name, const PartCase& c, int parts, const FactorCounts& amd,
                OurParts& o) {
    const int least = c.bodies() > 20'000 ? 3 : 21;
    const graph::Hypergraph g = c.graph(o.exact);
    o.partitioner.neighbours.build(g);
    const double seconds =
        median_seconds([&] { partition_again(g, parts, o.partitioner, o.partition); }, least);
    PartRow r = measure_parts(name, c, o.partition.part, parts, amd);
    r.seconds = seconds;
    o.exact = r.counts.node;
    return r;
}

/// Median times of one call [s], METIS and ours by turns.
struct Race {
    double metis = 0.0;       ///< METIS k-way, by itself again and again.
    double metis_turn = 0.0;  ///< The same by turns with ours.
    double ours = 0.0;        ///< From the body graph, again and again.
    double turn = 0.0;        ///< The same, each after a call of METIS: nothing is foretold.
    double fresh = 0.0;       ///< The same with a new object, which has no memory yet.
    double graph = 0.0;       ///< The body graph from interactions.
    double cuts = 0.0;        ///< Cuts with weights instead of separators, graph included.
};

Race race(const PartCase& c, int parts, const std::vector<std::int64_t>& exact) {
    const int least = c.bodies() > 20'000 ? 3 : 61;
    ForeignGraph f(c.pattern);
    const graph::Hypergraph g = c.graph(exact);
    graph::Hypergraph weighted = g;
    // Weights as physics would give them, of any size: their values do not change the work.
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
    const auto metis = [&] { (void)metis_parts(f, f.weight, parts); };
    const auto ours = [&] { partition_again(g, parts, p, out); };
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
        d.push_back(time_of([&] { partition_again(g, parts, other, parts_of_other); }));
    }
    r.metis_turn = median(a);
    r.turn = median(b);
    r.fresh = median(d);
    // Rounds of each by itself, by turns as well, so that both meet the same machine.
    a.clear();
    b.clear();
    for (int i = 0; i < 5; ++i) {
        a.push_back(median_seconds(metis, least / 3));
        b.push_back(median_seconds(ours, least / 3));
    }
    r.metis = median(a);
    r.ours = median(b);
    r.cuts = median_seconds([&] { splitter.split(weighted, {parts}, out); }, least);
    return r;
}

nlohmann::json print_race(const Race& r) {
    const auto line = [&](const char* what, double seconds, double metis) {
        fmt::print("  {:<58} {:>9.1f} us", what, 1e6 * seconds);
        if (metis > 0.0) fmt::print(", METIS {:>6.1f}x", metis / seconds);
        fmt::print("\n");
    };
    line("ours from the body graph, with cost, again and again", r.ours, r.metis);
    line("  by turns with METIS", r.turn, r.metis_turn);
    line("  by turns with METIS, a new object without memory", r.fresh, r.metis_turn);
    line("  and the body graph from interactions", r.ours + r.graph, r.metis);
    line("cuts instead of separators, with weights, graph included", r.cuts, r.metis);
    return {{"metis_seconds", r.metis},
            {"metis_by_turns_seconds", r.metis_turn},
            {"seconds", r.ours},
            {"by_turns_seconds", r.turn},
            {"new_object_seconds", r.fresh},
            {"graph_seconds", r.graph},
            {"cuts_seconds", r.cuts}};
}

/// Contacts that change: the time of following them, there and back. @return s for one way.
double update_seconds(const PartCase& c, const OurParts& ours) {
    graph::Follower follower;
    follower.start(c.graph(), ours.partitioner.cost.node, ours.partition);
    const auto span_of = [](const std::int32_t* m) {
        return std::span<const std::int32_t>(m, m[1] < 0 ? 1 : 2);
    };
    return 0.5 * median_seconds(
                     [&] {
                         for (std::size_t i = 0; i < c.edited.size(); ++i)
                             follower.change(c.edited[i], span_of(&c.edited_to[2 * i]));
                         for (const std::int32_t e : c.edited)
                             follower.change(e, c.graph().edge(e));
                     },
                     101);
}

nlohmann::json compare_parts(const PartCase& c, int parts) {
    fmt::print("\n{}: {} bodies, {} interactions, {} pairs, {} parts\n", c.name, c.bodies(),
               c.begin.size() - 1, c.pattern.adjacent.size() / 2, parts);
    print_part_heading();
    nlohmann::json rows = nlohmann::json::array();
    ForeignGraph g(c.pattern);
    const int least = c.bodies() > 20'000 ? 3 : 21;
    std::vector<std::int32_t> order;
    double seconds = median_seconds([&] { order = factor::order_nodes(c.pattern); }, least);
    const FactorCounts amd = count_factor(c.pattern, order);
    rows.push_back(print_part_row(order_row("AMD", c, order, seconds, amd)));
    seconds = median_seconds([&] { order = metis_order(g); }, least);
    if (!order.empty())
        rows.push_back(
            print_part_row(order_row("METIS nested dissection", c, order, seconds, amd)));
    std::vector<std::int32_t> part;
    seconds = median_seconds([&] { part = metis_parts(g, g.weight, parts); }, least);
    if (!part.empty()) {
        cover_cuts(c.pattern, part);
        PartRow r = measure_parts("METIS k-way", c, part, parts, amd);
        r.seconds = seconds;
        rows.push_back(print_part_row(r));
    }
    seconds = median_seconds([&] { order = scotch_order(g); }, 3);
    if (!order.empty())
        rows.push_back(print_part_row(order_row("Scotch order", c, order, seconds, amd)));
    seconds = median_seconds([&] { part = scotch_parts(g, parts); }, 3);
    if (!part.empty()) {
        cover_cuts(c.pattern, part);
        PartRow r = measure_parts("Scotch k-way", c, part, parts, amd);
        r.seconds = seconds;
        rows.push_back(print_part_row(r));
    }
    OurParts ours;
    rows.push_back(print_part_row(our_row("ours, model cost", c, parts, amd, ours)));
    PartRow best;
    for (int k = 0; k < kPartRounds; ++k) {
        const PartRow row = our_row("ours, exact cost", c, parts, amd, ours);
        if (k == 0 || row.imbalance < best.imbalance) best = row;
    }
    rows.push_back(print_part_row(best));
    const Race times = race(c, parts, ours.exact);
    nlohmann::json time_rows = print_race(times);
    double update = 0.0;
    if (!c.edited.empty()) {
        update = update_seconds(c, ours);
        fmt::print("  {:<58} {:>9.2f} us", fmt::format("update after {} changes", c.edited.size()),
                   1e6 * update);
        if (times.metis > 0.0) fmt::print(", METIS {:>6.0f}x", times.metis / update);
        fmt::print("\n");
    }
    return {{"name", c.name},
            {"bodies", c.bodies()},
            {"rows", rows},
            {"times", time_rows},
            {"update_seconds", update}};
}

}  // namespace

int partition_command(int argc, char** argv) {
    CLI::App app(
        "Parts for the exact solution: ours beside METIS, Scotch and AMD on the same graphs.\n"
        "imbalance: exact flops of the largest part over the mean; dearest: those of one body;\n"
        "fill, flops: of the factor over AMD's; makespan: largest part and all separators (of an\n"
        "order: its longest path) over AMD's flops; factor: one thread, processor time.",
        "hawser-bench partition");
    PartitionFlags o;
    app.add_option("--scale", o.scale, "Copies of the paper's scene")->check(CLI::Range(1, 1000));
    app.add_option("--parts", o.parts, "Parts")->check(CLI::Range(1, 256));
    app.add_flag("--cost", o.cost, "How well costs predict factor times, over many islands");
    app.add_option("--picture", o.picture, "SVG of --cost");
    app.add_option("--json", o.json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);
    nlohmann::json all;
    if (o.cost) {
        all = cost_study(o.picture);
    } else {
        std::vector<PartCase> cases{paper_case(false, o.scale), paper_case(true, o.scale),
                                    make_case(net(50)),         make_case(tree_of_chains(6, 40)),
                                    star_case(20, 50, 1),       random_case(1000, 1)};
        for (const PartCase& c : cases) all.push_back(compare_parts(c, o.parts));
    }
    if (!o.json.empty()) std::ofstream(o.json) << all.dump(2) << '\n';
    return 0;
}

}  // namespace hawser::bench
