// SPDX-License-Identifier: Apache-2.0
#include "inspect_parts.h"

#include <hawser/experimental/splits.h>
#include <hawser/inspect.h>

#include "elimination_orders.h"
#include "report/elimination.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hawser::cli {
namespace {

BlockPattern pattern_of(const SystemView& view) {
    BlockPattern pattern;
    for (const SystemNode& node : view.nodes) {
        pattern.size.push_back(static_cast<std::int8_t>(node.size));
        pattern.sign.push_back(node.body.valid() ? 1 : -1);
    }
    for (std::size_t v = 0; v < view.nodes.size(); ++v)
        for (std::int32_t k = view.edge_start[v]; k < view.edge_start[v + 1]; ++k)
            if (const std::int32_t u = view.edges[static_cast<std::size_t>(k)];
                u < static_cast<std::int32_t>(v))
                pattern.edges.push_back({static_cast<std::int32_t>(v), u});
    return pattern;
}

void print_order(const char* name, const SystemView& view, const std::vector<std::int32_t>& order) {
    const report::EliminationCounts c = report::count_elimination(view, order);
    fmt::print("    {:<24} {:>10} {:>10.4g} {:>14.4g} {:>10.3g}x\n", name, c.nnz,
               1e-6 * static_cast<double>(c.flops), 1e-6 * static_cast<double>(c.path),
               c.path > 0 ? static_cast<double>(c.flops) / static_cast<double>(c.path) : 1.0);
}

void print_loads(const PartitionView& p) {
    std::vector<std::string> loads;
    for (const double cost : p.part_cost) loads.push_back(fmt::format("{:.4g}", 1e-6 * cost));
    double sum = 0.0;
    for (const double cost : p.part_cost) sum += cost;
    const double mean = sum / std::max(1, p.parts);
    fmt::print(
        "    cost of parts    {} Mflop; imbalance {:.3f}, dearest piece {:.3f} of the mean\n",
        fmt::join(loads, ", "), p.imbalance, mean > 0.0 ? p.largest_cluster / mean : 0.0);
    fmt::print(
        "    time             {:.1f} us for the graph, {:.1f} for weights, {:.1f} for parts\n",
        1e6 * p.graph_seconds, 1e6 * p.weight_seconds, 1e6 * p.partition_seconds);
}

std::string name_of(const World& world, InteractionId id) {
    const InteractionDef& d = world.interaction_def(id);
    if (!d.name.empty()) return d.name;
    const KindInfo& info = kind_info(d.kind);
    std::vector<std::string> bodies;
    for (int b = 0; b < info.bodies; ++b) {
        const BodyId body = d.body[static_cast<std::size_t>(b)];
        const std::string& name = world.body_def(body).name;
        bodies.push_back(name.empty() ? fmt::format("#{}", body.index) : name);
    }
    return fmt::format("{} {}", info.name, fmt::join(bodies, " - "));
}

void print_cuts(const World& world, const PartitionView& p) {
    constexpr std::size_t kMaxListedCuts = 24;
    for (std::size_t i = 0; i < std::min(kMaxListedCuts, p.cuts.size()); ++i) {
        const CutInteraction& c = p.cuts[i];
        fmt::print("      {:<44} {:>11.4g} {:>11.4g} {:>11.4g} {:>11.4g} {:>9.3f}\n",
                   name_of(world, c.interaction), c.force, c.net_force, c.relative_velocity,
                   c.violation, c.weight);
    }
    if (p.cuts.size() > kMaxListedCuts)
        fmt::print("      … and {} more\n", p.cuts.size() - kMaxListedCuts);
}

}  // namespace

void print_orders(const SystemView& view) {
    fmt::print("  orders of elimination of this matrix (exact counts, without merged zeros)\n");
    fmt::print("    {:<24} {:>10} {:>10} {:>14} {:>11}\n", "", "nnz(L)", "Mflop", "Mflop on path",
               "at most");
    const BlockPattern pattern = pattern_of(view);
    print_order("AMD", view, elimination_order(pattern, Ordering::amd));
    if (metis_available())
        print_order("METIS nested dissection", view, elimination_order(pattern, Ordering::metis));
    else
        fmt::print("    {:<24} not in this build\n", "METIS nested dissection");
    print_order("ours", view, view.order);
}

void print_groups(const World& world) {
    const std::vector<CutView> cuts = world.splits().cuts();
    if (cuts.empty()) return;
    std::vector<std::int64_t> bodies;
    for (const std::int32_t g : world.splits().groups()) {
        // A user-defined group without a name has no number.
        const auto k = static_cast<std::size_t>(g) + 1;
        if (k >= bodies.size()) bodies.resize(k + 1);
        ++bodies[k];
    }
    if (!bodies.empty()) bodies.erase(bodies.begin());
    const auto open =
        std::count_if(cuts.begin(), cuts.end(), [](const CutView& c) { return c.open; });
    fmt::print("  groups in force  bodies {}; {} interactions cut, {} of them open\n",
               fmt::join(bodies, ", "), cuts.size(), open);
    if (const WorldDef& def = world.settings(); def.parts > 0)
        fmt::print(
            "    of the world     {} parts, checked every {} steps: regrouped {} times, {} bodies "
            "moved\n",
            def.parts, def.regroup_every, world.stats().regroupings,
            world.stats().regrouped_bodies);
}

void print_parts(const World& world, int parts) {
    PartitionRequest request;
    request.parts = parts;
    const PartitionView exact = world.splits().partition(request);
    double paper = 0.0;
    for (const double c : exact.island_cost) paper += c;
    fmt::print("  {} parts with separators (exact coupling); c = {:.6g} over {} islands\n", parts,
               paper, exact.island_cost.size());
    fmt::print("    separators       {} bodies, {} scalars, {:.4g} Mflop\n", exact.separator.size(),
               exact.separator_scalars, 1e-6 * exact.separator_cost);
    print_loads(exact);
    request.use = PartitionUse::cuts;
    const PartitionView cut = world.splits().partition(request);
    fmt::print("  {} parts with cuts (approximate couplings): {} interactions cut\n", parts,
               cut.cuts.size());
    print_loads(cut);
    if (cut.cuts.empty()) return;
    fmt::print("      {:<44} {:>11} {:>11} {:>11} {:>11} {:>9}\n", "interaction", "force N",
               "net N", "|G v| m/s", "|g| m", "weight");
    print_cuts(world, cut);
}

}  // namespace hawser::cli
