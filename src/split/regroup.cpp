// SPDX-License-Identifier: Apache-2.0
#include "split/regroup.h"

#include "access/asleep.h"
#include "access/copies.h"
#include "access/guarded.h"
#include "access/timer.h"
#include "access/undo.h"
#include "access/view.h"
#include "base/index.h"
#include "context/context.h"
#include "context/cuts_data.h"
#include "context/regroup_data.h"
#include "context/undo_data.h"
#include "split/analyse.h"
#include "split/cuts.h"

#include <algorithm>
#include <utility>

namespace hawser::stepper {
namespace {

/// Every interaction's violation and Jacobian at the present poses. Stage assemble leaves out what
/// is cut, and a restored world has not assembled anything yet. Which ranges are at their ends is
/// told anew with it and part of the state, so that it is put back.
void evaluate_all(StepContext& ctx) {
    const assembly::View v = view(ctx);
    base::Array<double>& active = ctx.model.interactions.active;
    ctx.model.regroup.active.assign(active.begin(), active.end());
    for (std::size_t k = 0; k < ctx.model.interactions.pool.size(); ++k) {
        const model::Pool& pool = ctx.model.interactions.pool[k];
        const auto end = static_cast<std::int32_t>(pool.ids.size());
        for (std::int32_t a = 0, b = 0; a < end; a = b + 1) {  // between empty places
            for (b = a; b < end && !ctx.model.interactions.gone(pool.ids[at(b)]);) ++b;
            assembly::kernels().evaluate(v, static_cast<InteractionKind>(k), pool.ids.data(),
                                         pool.data.data(), a, b);
        }
    }
    std::copy(ctx.model.regroup.active.begin(), ctx.model.regroup.active.end(), active.begin());
}

/// What must stay whole because it is coupled exactly or cannot be cut.
void keep_exact(StepContext& ctx, assembly::PartGraph& graph) {
    for (std::int32_t i = 0; i < interaction_count(ctx); ++i) {
        if (graph.edge_weight[at(i)] == graph::kNeverCut) continue;
        const std::vector<Coupling>& coupling = ctx.model.cuts.coupling;
        const Coupling c = at(i) < coupling.size() ? coupling[at(i)] : ctx.model.def.coupling;
        if (c == Coupling::exact || !can_cut(ctx, i)) graph.keep_whole(i);
    }
}

/// Groups by hand are the first parts, in the order of their first bodies.
void number_groups(StepContext& ctx) {
    Regroup& r = ctx.model.regroup;
    const auto bodies = at(body_count(ctx));
    r.by_hand.resize(bodies, -1);
    r.part_of_name.clear();
    std::int32_t parts = 0;
    for (std::size_t b = 0; b < bodies; ++b) {
        const std::int32_t name = r.by_hand[b];
        if (name < 0 || ctx.model.bodies.dof(static_cast<std::int32_t>(b)) == 0) continue;
        if (at(name) >= r.part_of_name.size()) r.part_of_name.resize(at(name) + 1, -1);
        if (r.part_of_name[at(name)] < 0) r.part_of_name[at(name)] = parts++;
    }
}

/// The part that a group by hand is; −1: the body is free.
std::int32_t part_by_hand(const StepContext& ctx, std::int32_t body) noexcept {
    const Regroup& r = ctx.model.regroup;
    const std::int32_t name = r.by_hand[at(body)];
    return name < 0 || ctx.model.bodies.dof(body) == 0 ? -1 : r.part_of_name[at(name)];
}

/// The graph of what is to be parted, with groups by hand.
void read_own_graph(StepContext& ctx, bool weigh) {
    Regroup& r = ctx.model.regroup;
    read_graph(ctx, r.graph);
    keep_exact(ctx, r.graph);
    if (weigh) weigh_graph(ctx, r.graph);
    number_groups(ctx);
    r.graph.group.clear();
    if (r.part_of_name.empty()) return;
    r.graph.group.resize(at(body_count(ctx)));
    for (std::int32_t b = 0; b < body_count(ctx); ++b) r.graph.group[at(b)] = part_by_hand(ctx, b);
}

/// A round is due before the step.
bool due(const StepContext& ctx) noexcept {
    const Regroup& r = ctx.model.regroup;
    if (ctx.model.def.regroup_every < 1 || !makes_groups(ctx) || ctx.state.step == r.seen)
        return false;
    const std::int64_t age = ctx.state.step - r.made;
    return age > 0 && (age == Regroup::kSettle || age % ctx.model.def.regroup_every == 0);
}

/// The part of prepare() that groups have a say in.
void cut_anew(StepContext& ctx) {
    make_cuts(ctx);
    ctx.model.cuts.asked = 0;  // interfaces have other numbers now
    ctx.work.limits.cut_levels.set({});
    const StageTimer timer(ctx, Stage::analyse);
    analyse(ctx);
    reserve_sleep(ctx);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    reserve_undo(ctx);
}

}  // namespace

void read_graph(StepContext& ctx, assembly::PartGraph& graph) {
    graph.build(ctx.model.bodies, body_count(ctx), ctx.model.interactions, interaction_count(ctx),
                ctx.model.system.contacts.links);
}

void weigh_graph(StepContext& ctx, assembly::PartGraph& graph) {
    evaluate_all(ctx);
    std::vector<std::int32_t>& cut = ctx.model.regroup.cut;
    cut.clear();
    for (const Cut& c : ctx.model.cuts.list)
        if (c.open) cut.push_back(c.id);
    graph.weigh(ctx.model.bodies, ctx.model.interactions, cut, ctx.model.def);
    // Contacts of the last step: those of the state.
    for (std::size_t k = 0; k < ctx.model.collider.kept_awake(); ++k)
        for (const std::int32_t s : ctx.model.collider.kept()[k].shape)
            for (const std::int32_t b : ctx.model.collider.shapes()[at(s)].body)
                if (b >= 0) graph.touch(b);
}

std::int64_t assign_groups(StepContext& ctx) {
    number_groups(ctx);
    std::int64_t moved = 0;
    ctx.model.cuts.group.resize(at(body_count(ctx)), 0);
    for (std::int32_t b = 0; b < body_count(ctx); ++b) {
        const std::int32_t hand = part_by_hand(ctx, b);
        const std::int32_t part =
            hand >= 0 ? hand : std::max(0, ctx.model.regroup.parts.part[at(b)]);
        moved += ctx.model.cuts.group[at(b)] != part ? 1 : 0;
        ctx.model.cuts.group[at(b)] = part;
    }
    return moved;
}

void make_groups(StepContext& ctx) {
    Regroup& r = ctx.model.regroup;
    if (!makes_groups(ctx)) {
        r.parts = {};
        r.stale = true;
        return;
    }
    if (!r.stale && r.parts.part.size() == at(body_count(ctx)) &&
        r.interactions == interaction_count(ctx))
        return;
    read_own_graph(ctx, false);
    r.next = r.parts;
    (void)r.splitter.follow(r.graph.view(), {ctx.model.def.parts}, r.next);
    std::swap(r.parts, r.next);
    (void)assign_groups(ctx);
    r.made = r.seen = ctx.state.step;
    r.interactions = interaction_count(ctx);
    r.stale = false;
}

Status regroup(StepContext& ctx) noexcept {
    if (!due(ctx)) return Status::ok;
    Regroup& r = ctx.model.regroup;
    const StageTimer timer(ctx, Stage::graph);
    return guarded(ctx, [&] {
        keep_state(ctx, Undo::Depth::system);
        read_own_graph(ctx, true);
        r.next = r.parts;
        const graph::PartitionOptions options{ctx.model.def.parts};
        if (ctx.state.step - r.made == Regroup::kSettle)
            r.splitter.split(r.graph.view(), options, r.next);
        else
            (void)r.splitter.follow(r.graph.view(), options, r.next);
        r.seen = ctx.state.step;
        std::swap(r.parts, r.next);
        const std::int64_t moved = assign_groups(ctx);
        if (moved == 0) return;
        keep_state(ctx, Undo::Depth::model);
        cut_anew(ctx);
        ++ctx.work.stats.regroupings;
        ctx.work.stats.regrouped_bodies += moved;
    });
}

}  // namespace hawser::stepper
