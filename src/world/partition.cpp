// SPDX-License-Identifier: Apache-2.0
#include <hawser/experimental/splits.h>
#include <hawser/world.h>

#include "assembly/part_cost.h"
#include "assembly/parts.h"
#include "graph/follow.h"
#include "graph/partition.h"
#include "graph/split.h"
#include "split/split.h"
#include "step/ready.h"
#include "world/impl.h"
#include "world/lookup.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <vector>

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
        // Touching pairs are not cut, so all cuts are interactions.
        const auto i = static_cast<std::size_t>(e);
        CutInteraction cut;
        cut.interaction = in.id(e);
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

/// Return the cost of the largest part plus all separators, as a fraction of the total cost. A
/// fraction is used because costs change with the contacts.
double makespan(const graph::Partition& p) {
    double longest = 0.0, sum = static_cast<double>(p.separator_cost);
    for (const std::int64_t cost : p.cost) {
        longest = std::max(longest, static_cast<double>(cost));
        sum += static_cast<double>(cost);
    }
    return sum > 0.0 ? (longest + static_cast<double>(p.separator_cost)) / sum : 0.0;
}

/// Update the separators of an earlier partition.
/// @return false if a new partition is required.
bool follow_separators(const assembly::PartGraph& g, std::span<const std::int64_t> model_cost,
                       const PartitionView& before, const graph::PartitionOptions& options,
                       graph::Partition& out) {
    const graph::Hypergraph graph = g.view();
    const std::span<const std::int64_t> cost = graph.cost.empty() ? model_cost : graph.cost;
    if (before.parts != options.parts || before.part_of_body.size() != graph.size.size())
        return false;
    out.parts = before.parts;
    out.part = before.part_of_body;
    out.cost.assign(at(out.parts), 0);
    out.separator_cost = 0;
    for (std::size_t v = 0; v < out.part.size(); ++v) {
        const std::int32_t part = out.part[v];
        if ((graph.size[v] == 0) != (part == graph::kNoPart) || part >= out.parts ||
            part < graph::kSeparator)
            return false;
        if (part != graph::kNoPart) (part < 0 ? out.separator_cost : out.cost[at(part)]) += cost[v];
    }
    graph::Follower follower;
    follower.start(graph, cost, out);
    // New edges join two parts. Separators with removed edges join the adjacent part.
    std::vector<std::int32_t> changed;
    for (std::int32_t e = 0; e < graph.edges(); ++e) {
        std::int32_t part = graph::kNoPart;
        bool joins = false, between = false;
        for (const std::int32_t v : graph.edge(e)) {
            between |= out.part[at(v)] == graph::kSeparator;
            if (out.part[at(v)] < 0) continue;
            joins |= part >= 0 && out.part[at(v)] != part;
            part = out.part[at(v)];
        }
        if (joins) changed.push_back(e);
        if (joins && graph.edge(e).size() > graph::Follower::kMaxMembers) return false;
        if (between && !joins) changed.push_back(-1 - e);
    }
    constexpr std::int64_t kMinSeparatorRatio = 20;  // one in this many
    const auto came = std::count_if(changed.begin(), changed.end(), [](auto e) { return e >= 0; });
    if (kMinSeparatorRatio * came > graph.edges()) return false;
    for (const std::int32_t e : changed)
        if (e >= 0) follower.change(e, graph.edge(e));
    for (const std::int32_t e : changed)
        if (const std::int32_t b = -1 - e;
            b >= 0 && graph.edge(b).size() <= graph::Follower::kMaxMembers)
            follower.change(b, graph.edge(b));
    follower.copy_to(out);
    return makespan(out) <= graph::Follower::kReplanRatio * before.makespan_new;
}

/// Check a request.
/// @throws DefError
void check(const PartitionRequest& request, std::size_t bodies) {
    if (request.parts < 1 || request.parts > 4096)
        throw DefError("a partition has 1 to 4096 parts");
    if (!request.group.empty() && request.group.size() != bodies)
        throw DefError("groups of a partition: one for each body, or none");
    for (const std::int32_t g : request.group)
        if (g < -1 || g >= request.parts)
            throw DefError("groups of a partition: -1 or below the number of parts");
    if (request.before != nullptr && request.before->use != request.use)
        throw DefError("a partition can only continue one of the same purpose");
}

/// Find a partition with separators.
/// @param partitioner  Must have read the graph.
graph::Partition find_separators(const assembly::PartGraph& g, const PartitionRequest& request,
                                 graph::Partitioner& partitioner, PartitionView& view) {
    graph::Partition p;
    const graph::PartitionOptions options{request.parts};
    view.followed = request.before != nullptr &&
                    follow_separators(g, partitioner.cost.node, *request.before, options, p);
    if (view.followed) {
        view.makespan_new = request.before->makespan_new;
    } else {
        partitioner.separate(options, p);
        view.makespan_new = makespan(p);
    }
    view.largest_cluster = 0.0;
    for (const std::int64_t cost : partitioner.cost.node)
        view.largest_cluster = std::max(view.largest_cluster, static_cast<double>(cost));
    return p;
}

/// Find a partition whose parts are separated by cuts.
graph::Partition find_split(const assembly::PartGraph& g, const PartitionRequest& request,
                            PartitionView& view) {
    graph::Partition p;
    graph::Splitter splitter;
    const graph::PartitionOptions options{request.parts};
    if (request.before != nullptr) {
        p.parts = request.before->parts;
        p.part = request.before->part_of_body;
        p.worse_for = request.before->worse_for;
        view.followed = splitter.split_from_previous(g.view(), options, p);
    } else {
        splitter.split(g.view(), options, p);
    }
    view.worse_for = p.worse_for;
    view.largest_cluster = static_cast<double>(splitter.largest_cluster);
    view.makespan_new = view.followed ? request.before->makespan_new : makespan(p);
    return p;
}

}  // namespace

PartitionView WorldSplitsView::partition(const PartitionRequest& request) const {
    const world::Using use(impl().use, "partition");
    check(request, static_cast<std::size_t>(world_->body_count()));
    context::StepContext& c = impl().ctx;
    step::ready(c);
    PartitionView view;
    view.use = request.use;
    Clock::time_point clock = Clock::now();
    assembly::PartGraph g;
    split::read_graph(c.model, g);
    g.group = request.group;
    view.graph_seconds = seconds_since(clock);
    split::weigh_graph(c.model, g);
    view.weight_seconds = seconds_since(clock);
    if (request.exact_cost) {
        g.cost = assembly::body_flops(c.model.system, c.model.bodies.count());
        g.cost.resize(at(world_->body_count()));
    }
    (void)seconds_since(clock);
    const bool cuts = request.use == PartitionUse::cuts;
    graph::Partitioner partitioner;
    if (!cuts) partitioner.read(g.view());
    graph::Partition p =
        cuts ? find_split(g, request, view) : find_separators(g, request, partitioner, view);
    view.partition_seconds = seconds_since(clock);
    if (cuts) partitioner.read(g.view());
    for (const std::int64_t cost : partitioner.cost.paper)
        view.island_cost.push_back(static_cast<double>(cost));
    view.parts = p.parts;
    for (const std::int64_t cost : p.cost) view.part_cost.push_back(static_cast<double>(cost));
    view.separator_cost = static_cast<double>(p.separator_cost);
    view.imbalance = p.imbalance();
    for (const std::int32_t b : p.separator) {
        view.separator.push_back(c.model.bodies.id(b));
        view.separator_scalars += g.size[static_cast<std::size_t>(b)];
    }
    list_cuts(g, c.model.interactions, p, view);
    view.part_of_body = std::move(p.part);
    return view;
}

}  // namespace hawser
