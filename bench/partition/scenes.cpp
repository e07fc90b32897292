// SPDX-License-Identifier: Apache-2.0
#include "partition/scenes.h"

#include "index.h"
#include "linear/timing.h"
#include "partition/foreign.h"

#include <hawser/experimental/splits.h>
#include <hawser/scene.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace hawser::bench {
namespace {

constexpr int kStepsFirst = 60;  ///< forces and velocities are those of a running scene

double wall_seconds(std::chrono::steady_clock::time_point from) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

}  // namespace

BodyGraph body_graph(const World& world) {
    BodyGraph g;
    g.node.assign(at(world.body_count()), -1);
    std::vector<std::int8_t> size;
    for (std::int32_t b = 0; b < world.body_count(); ++b) {
        const BodyKind kind = world.body_def(BodyId{b}).kind;
        if (kind == BodyKind::fixed || kind == BodyKind::kinematic) continue;
        g.node[at(b)] = static_cast<std::int32_t>(size.size());
        size.push_back(kind == BodyKind::rigid ? 6 : kind == BodyKind::lump ? 3 : 1);
    }
    std::vector<std::int32_t> from, to;
    const auto join = [&](BodyId a, BodyId b) {
        if (!a.valid() || !b.valid() || g.node[at(a.index)] < 0 || g.node[at(b.index)] < 0) return;
        from.push_back(g.node[at(a.index)]);
        to.push_back(g.node[at(b.index)]);
    };
    for (std::int32_t i = 0; i < world.interaction_count(); ++i) {
        const InteractionDef& d = world.interaction_def(InteractionId{i});
        for (std::size_t k = 0; k < d.body.size(); ++k)
            for (std::size_t l = 0; l < k; ++l) join(d.body[k], d.body[l]);
    }
    for (const ContactView& contact : world.contacts())
        join(world.shape_def(contact.shape[0]).body, world.shape_def(contact.shape[1]).body);
    const std::vector<std::int8_t> signs(size.size(), 1);
    g.pattern = factor::make_pattern(size, signs, from, to);
    return g;
}

nlohmann::json time_scenes(int parts, int turns) {
    fmt::print(
        "\ncuts with weights from forces and velocities, by WorldSplits::partition() after {} "
        "steps, {} parts [us]\n  {:<16} {:>6} {:>12} {:>5} {:>8} {:>8} {:>8} {:>8} {:>12} "
        "{:>9}\n",
        kStepsFirst, parts, "", "bodies", "interactions", "cuts", "graph", "weights", "cuts", "sum",
        "METIS k-way", "over sum");
    nlohmann::json rows = nlohmann::json::array();
    for (const char* name : {"anchor_lines", "anchor_contact"}) {
        const std::string file = std::string("scenes/") + name + ".json";
        if (!std::filesystem::exists(file)) {
            fmt::print("  {}: not there, left out\n", file);
            continue;
        }
        World world = scene::load_file(file).world;
        for (int i = 0; i < kStepsFirst; ++i)
            if (world.step() != Status::ok) throw std::runtime_error(file + " does not step");
        const BodyGraph g = body_graph(world);
        ForeignGraph foreign(g.pattern);
        const bool metis = !metis_parts(foreign, foreign.weight, parts).empty();
        PartitionRequest request;
        request.use = PartitionUse::cuts;
        request.parts = parts;
        std::vector<double> graph, weights, partition, theirs;
        std::size_t cuts = 0;
        for (int i = 0; i < turns; ++i) {
            const PartitionView view = world.splits().partition(request);
            graph.push_back(view.graph_seconds);
            weights.push_back(view.weight_seconds);
            partition.push_back(view.partition_seconds);
            cuts = view.cuts.size();
            if (!metis) continue;
            const auto start = std::chrono::steady_clock::now();
            (void)metis_parts(foreign, foreign.weight, parts);
            theirs.push_back(wall_seconds(start));
        }
        const double sum = median(graph) + median(weights) + median(partition);
        fmt::print("  {:<16} {:>6} {:>12} {:>5} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>12} {:>9}\n",
                   name, g.pattern.nodes(), world.interaction_count(), cuts, 1e6 * median(graph),
                   1e6 * median(weights), 1e6 * median(partition), 1e6 * sum,
                   metis ? fmt::format("{:.1f}", 1e6 * median(theirs)) : "-",
                   metis ? fmt::format("{:.1f}x", median(theirs) / sum) : "-");
        rows.push_back(
            {{"scene", name},
             {"bodies", g.pattern.nodes()},
             {"interactions", world.interaction_count()},
             {"cuts", cuts},
             {"graph_seconds", median(graph)},
             {"weight_seconds", median(weights)},
             {"cut_seconds", median(partition)},
             {"metis_seconds", metis ? nlohmann::json(median(theirs)) : nlohmann::json()}});
    }
    return rows;
}

}  // namespace hawser::bench
