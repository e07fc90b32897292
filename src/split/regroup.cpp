// SPDX-License-Identifier: Apache-2.0
/// Form groups of bodies automatically and update them with the state (docs/partition.md).
///
/// If WorldDef::parts is above 0 and some coupling is not exact, every body without a group from
/// the user gets one. It is a part of about equal cost. Cuts lie at interactions that may be cut,
/// where forces, velocities and violations are least. A *round* chooses the parts:
/// ```
///     step     0            kSettle             2 regroup_every · … from 0 on
///     by       model alone  weights, all new    weights, next to the present parts:
///                                               at most one cut moves (graph/split.h)
/// ```
/// New cuts and a new analysis are made only if a body changes its group. Rounds depend on the
/// state alone. Costs are those of the model, because those of an analysis would depend on the
/// present cuts. Rows are evaluated at the present poses.
#include "split/split.h"

#include "base/index.h"
#include "context/asleep.h"
#include "context/context.h"
#include "context/copies.h"
#include "context/cuts_data.h"
#include "context/guarded.h"
#include "context/regroup_data.h"
#include "context/timer.h"
#include "context/undo_data.h"
#include "context/view.h"
#include "split/cuts.h"
#include "state/undo.h"

#include <algorithm>
#include <utility>

namespace hawser::split {
namespace {

/// Evaluate the violation and Jacobian of every interaction at the present poses. This is necessary
/// because stage assemble omits cut interactions, and because a restored world has not assembled
/// any. The evaluation overwrites the active flags of ranges, which are part of the state and are
/// restored.
void evaluate_all(context::Model& model) {
    const assembly::View v = context::row_view(model);
    base::Array<double>& active = model.interactions.active;
    model.regroup.active.assign(active.begin(), active.end());
    for (std::size_t k = 0; k < model.interactions.pool.size(); ++k) {
        const model::Pool& pool = model.interactions.pool[k];
        const auto end = static_cast<std::int32_t>(pool.ids.size());
        for (std::int32_t a = 0, b = 0; a < end; a = b + 1) {  // ranges between empty slots
            for (b = a; b < end && !model.interactions.gone(pool.ids[at(b)]);) ++b;
            assembly::kernels().evaluate(v, static_cast<InteractionKind>(k), pool.ids.data(),
                                         pool.data.data(), a, b);
        }
    }
    std::copy(model.regroup.active.begin(), model.regroup.active.end(), active.begin());
}

/// Mark the interactions that must not be cut: those with exact coupling and those that cannot be
/// cut.
void mark_uncuttable(const context::Model& model, assembly::PartGraph& graph) {
    for (std::int32_t i = 0; i < context::interaction_count(model); ++i) {
        if (graph.edge_weight[at(i)] == graph::kNeverCut) continue;
        const std::vector<Coupling>& coupling = model.cuts.coupling;
        const Coupling c = at(i) < coupling.size() ? coupling[at(i)] : model.def.coupling;
        if (c == Coupling::exact || !can_cut(model, i)) graph.keep_whole(i);
    }
}

/// Number the groups of the user. They are the first parts, in the order of their first bodies.
void number_groups(context::Model& model) {
    context::Regroup& r = model.regroup;
    const auto bodies = at(context::body_count(model));
    r.by_hand.resize(bodies, -1);
    r.part_of_name.clear();
    std::int32_t parts = 0;
    for (std::size_t b = 0; b < bodies; ++b) {
        const std::int32_t name = r.by_hand[b];
        if (name < 0 || model.bodies.dof(static_cast<std::int32_t>(b)) == 0) continue;
        if (at(name) >= r.part_of_name.size()) r.part_of_name.resize(at(name) + 1, -1);
        if (r.part_of_name[at(name)] < 0) r.part_of_name[at(name)] = parts++;
    }
}

/// Return the part that the user's group of a body has; −1: the user has set no group.
std::int32_t user_part(const context::Model& model, std::int32_t body) noexcept {
    const context::Regroup& r = model.regroup;
    const std::int32_t name = r.by_hand[at(body)];
    return name < 0 || model.bodies.dof(body) == 0 ? -1 : r.part_of_name[at(name)];
}

/// Read the graph to be partitioned, with the groups from the user.
void read_user_graph(context::Model& model, bool compute_weights) {
    context::Regroup& r = model.regroup;
    read_graph(model, r.graph);
    mark_uncuttable(model, r.graph);
    if (compute_weights) weigh_graph(model, r.graph);
    number_groups(model);
    r.graph.group.clear();
    if (r.part_of_name.empty()) return;
    r.graph.group.resize(at(context::body_count(model)));
    for (std::int32_t b = 0; b < context::body_count(model); ++b)
        r.graph.group[at(b)] = user_part(model, b);
}

/// Make groups from the model if there are none, or if the model has changed.
void make_groups(context::Model& model, const context::State& state) {
    context::Regroup& r = model.regroup;
    if (!makes_groups(model)) {
        r.parts = {};
        r.stale = true;
        return;
    }
    if (!r.stale && r.parts.part.size() == at(context::body_count(model)) &&
        r.interactions == context::interaction_count(model))
        return;
    read_user_graph(model, false);
    r.next = r.parts;
    (void)r.splitter.split_from_previous(r.graph.view(), {model.def.parts}, r.next);
    std::swap(r.parts, r.next);
    (void)assign_groups(model);
    r.made = r.seen = state.step;
    r.interactions = context::interaction_count(model);
    r.stale = false;
}

/// True if the groups must be updated before this step.
bool update_is_due(const context::Model& model, const context::State& state) noexcept {
    const context::Regroup& r = model.regroup;
    if (model.def.regroup_every < 1 || !makes_groups(model) || state.step == r.seen) return false;
    const std::int64_t age = state.step - r.made;
    return age > 0 && (age == context::Regroup::kSettle || age % model.def.regroup_every == 0);
}

/// Make ghost bodies and duplicated rows for changed groups, and analyse the new system.
void rebuild_cuts(context::StepContext& ctx) {
    make_cuts(ctx.model);
    ctx.model.cuts.asked = 0;  // interfaces have new indices
    ctx.work.limits.cut_levels.set({});
    const context::StageTimer timer(ctx, Stage::analyse);
    analyse(ctx);
    context::reserve_sleep(ctx.model, ctx.work.sleep);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    state::reserve_undo(ctx.model, ctx.work.undo);
}

}  // namespace

void read_graph(const context::Model& model, assembly::PartGraph& graph) {
    graph.build(model.bodies, context::body_count(model), model.interactions,
                context::interaction_count(model), model.system.contacts.links);
}

void weigh_graph(context::Model& model, assembly::PartGraph& graph) {
    evaluate_all(model);
    std::vector<std::int32_t>& cut = model.regroup.cut;
    cut.clear();
    for (const context::Cut& c : model.cuts.list)
        if (c.open) cut.push_back(c.id);
    graph.compute_weights(model.bodies, model.interactions, cut, model.def);
    // Contacts of the last step are part of the state.
    for (std::size_t k = 0; k < model.collider.last_awake_count(); ++k)
        for (const std::int32_t s : model.collider.last_contacts()[k].shape)
            for (const std::int32_t b : model.collider.shapes()[at(s)].body)
                if (b >= 0) graph.add_contact_weight(b);
}

std::int64_t assign_groups(context::Model& model) {
    number_groups(model);
    std::int64_t moved = 0;
    model.cuts.group.resize(at(context::body_count(model)), 0);
    for (std::int32_t b = 0; b < context::body_count(model); ++b) {
        const std::int32_t hand = user_part(model, b);
        const std::int32_t part = hand >= 0 ? hand : std::max(0, model.regroup.parts.part[at(b)]);
        moved += model.cuts.group[at(b)] != part ? 1 : 0;
        model.cuts.group[at(b)] = part;
    }
    return moved;
}

void split_model(context::StepContext& ctx) {
    make_groups(ctx.model, ctx.state);
    make_cuts(ctx.model);
    ctx.work.limits.cut_levels.set({});  // they belong to cuts that no longer exist
}

Status regroup(context::StepContext& ctx) noexcept {
    if (!update_is_due(ctx.model, ctx.state)) return Status::ok;
    context::Regroup& r = ctx.model.regroup;
    const context::StageTimer timer(ctx, Stage::graph);
    return context::guarded(ctx, [&] {
        state::save_state(ctx, context::Undo::Depth::system);
        read_user_graph(ctx.model, true);
        r.next = r.parts;
        const graph::PartitionOptions options{ctx.model.def.parts};
        if (ctx.state.step - r.made == context::Regroup::kSettle)
            r.splitter.split(r.graph.view(), options, r.next);
        else
            (void)r.splitter.split_from_previous(r.graph.view(), options, r.next);
        r.seen = ctx.state.step;
        std::swap(r.parts, r.next);
        const std::int64_t moved = assign_groups(ctx.model);
        if (moved == 0) return;
        state::save_state(ctx, context::Undo::Depth::model);
        rebuild_cuts(ctx);
        ++ctx.work.stats.regroupings;
        ctx.work.stats.regrouped_bodies += moved;
    });
}

}  // namespace hawser::split
