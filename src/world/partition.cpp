// SPDX-License-Identifier: Apache-2.0
#include <hawser/partition.h>
#include <hawser/world.h>

#include "assembly/part_cost.h"
#include "assembly/parts.h"
#include "graph/partition.h"
#include "graph/split.h"
#include "world/impl.h"
#include "world/lookup.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace hawser {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point& from) {
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - from).count();
    from = now;
    return seconds;
}

void list_cuts(const assembly::PartGraph& g, const model::Interactions& in,
               const graph::Partition& p, PartitionView& view) {
    for (const std::int32_t e : p.cut) {
        // Pairs that touch stay whole, so that cuts are interactions.
        const auto i = static_cast<std::size_t>(e);
        CutInteraction cut;
        cut.interaction = InteractionId{e};
        for (int r = 0; r < in.rows[i]; ++r)
            cut.force =
                std::max(cut.force, std::abs(in.force[static_cast<std::size_t>(in.row_begin[i]) +
                                                      static_cast<std::size_t>(r)]));
        double weight = g.edge_weight[i];
        for (std::int32_t k = g.begin[i]; k < g.begin[i + 1]; ++k) {
            const auto b = static_cast<std::size_t>(g.members[static_cast<std::size_t>(k)]);
            cut.net_force = std::max(cut.net_force, g.net_force[b]);
            weight += g.node_weight[b];
        }
        cut.relative_velocity = g.speed[i];
        cut.violation = g.violation[i];
        cut.weight = 1e-3 * weight;
        view.cuts.push_back(cut);
    }
}

}  // namespace

PartitionView World::partition(const PartitionRequest& request) const {
    if (request.parts < 1 || request.parts > 4096)
        throw DefError("a partition has 1 to 4096 parts");
    if (!request.group.empty() && request.group.size() != static_cast<std::size_t>(body_count()))
        throw DefError("groups of a partition: one for each body, or none");
    for (const std::int32_t g : request.group)
        if (g < -1 || g >= request.parts)
            throw DefError("groups of a partition: -1 or below the number of parts");
    stepper::StepContext& c = impl_->ctx;
    if (c.topology_changed) stepper::prepare(c);
    PartitionView view;
    Clock::time_point clock = Clock::now();
    assembly::PartGraph g;
    g.build(c.bodies, c.interactions, c.system.contacts.links);
    g.group = request.group;
    view.graph_seconds = seconds_since(clock);
    g.weigh(c.bodies, c.interactions, c.system.contacts, c.def);
    view.weight_seconds = seconds_since(clock);
    if (request.exact_cost) g.cost = assembly::body_flops(c.system, c.bodies.count());
    (void)seconds_since(clock);
    graph::Partition p;
    graph::Partitioner partitioner;
    const graph::PartitionOptions options{request.parts};
    if (request.use == PartitionUse::separators) {
        partitioner.read(g.view());
        partitioner.separate(options, p);
        view.largest_cluster = 0.0;
        for (const std::int64_t cost : partitioner.cost.node)
            view.largest_cluster = std::max(view.largest_cluster, static_cast<double>(cost));
    } else {
        graph::Splitter splitter;
        splitter.split(g.view(), options, p);
        view.largest_cluster = static_cast<double>(splitter.largest_cluster);
    }
    view.partition_seconds = seconds_since(clock);
    if (request.use == PartitionUse::cuts) partitioner.read(g.view());
    for (const std::int64_t cost : partitioner.cost.paper)
        view.island_cost.push_back(static_cast<double>(cost));
    view.parts = p.parts;
    for (const std::int64_t cost : p.cost) view.part_cost.push_back(static_cast<double>(cost));
    view.separator_cost = static_cast<double>(p.separator_cost);
    view.imbalance = p.imbalance();
    for (const std::int32_t b : p.separator) {
        view.separator.push_back(BodyId{b});
        view.separator_scalars += g.size[static_cast<std::size_t>(b)];
    }
    list_cuts(g, c.interactions, p, view);
    view.part_of_body = std::move(p.part);
    // Images and copies of a split stand behind the bodies and interactions of the user.
    view.part_of_body.resize(at(body_count()));
    std::erase_if(view.cuts, [&](const CutInteraction& cut) {
        return cut.interaction.index >= interaction_count();
    });
    return view;
}

}  // namespace hawser
