// SPDX-License-Identifier: Apache-2.0
#include "state/undo.h"

#include "context/undo_data.h"
#include "context/wire_alerts.h"

#include <algorithm>
#include <utility>

namespace hawser::state {
namespace {

/// Copy an array to one whose capacity has been reserved, so that nothing is allocated.
template <class A>
void put(const A& from, A& to) noexcept {
    to.assign(from.begin(), from.end());
}

context::Undo::Scalars read(const context::State& state, const StepStats& stats) noexcept {
    return {state.step,        state.time,         state.ledger,         state.loads.work,
            state.loads.water, state.loads.added,  state.refine_unasked, state.started,
            stats.event_count, state.monitor.state};
}

void write(const context::Undo::Scalars& from, context::StepContext& c) noexcept {
    c.state.step = c.work.stats.step = from.step;
    c.state.time = c.work.stats.time = from.time;
    c.state.ledger = from.ledger;
    c.state.loads.work = from.system_work;
    c.state.loads.water = from.water;
    c.state.loads.added = from.added;
    c.state.refine_unasked = from.refine_unasked;
    c.state.started = from.started;
    c.work.stats.event_count = from.event_count;
    c.state.monitor.state = from.monitor;
}

void save_system(context::StepContext& ctx) {
    context::Undo& u = ctx.work.undo;
    reserve_undo(ctx.model, ctx.work.undo);
    ctx.model.system.keep(u.system);
    u.analysed_x = ctx.state.analysed_x;
    u.analysed_r = ctx.state.analysed_r;
    u.asleep = ctx.model.bodies.asleep;
    u.quiet = ctx.model.bodies.quiet;
    u.links = ctx.model.system.contacts.links;
    u.cuts = ctx.model.cuts.list;
    u.group = ctx.model.cuts.group;
    u.coupling = ctx.model.cuts.coupling;
    u.parts = ctx.model.regroup.parts;
    if (ctx.state.changed != context::Changed::nothing) u.wires = ctx.model.wires;
    save_link_steps(ctx.model, ctx.work.undo);
    save_motion(ctx);
    u.repair = ctx.state.repair;
    u.changed = ctx.state.changed;
    u.asleep_count = ctx.work.stats.asleep;
    u.asked = ctx.model.cuts.asked;
    u.interfaces = ctx.model.cuts.interfaces;
    u.grouped = ctx.model.cuts.grouped;
    u.made = ctx.model.regroup.made;
    u.seen = ctx.model.regroup.seen;
    u.stale = ctx.model.regroup.stale;
    u.grouped_interactions = ctx.model.regroup.interactions;
}

void restore_system(context::StepContext& ctx) noexcept {
    context::Undo& u = ctx.work.undo;
    ctx.model.system.go_back(u.system);
    ctx.state.analysed_x.swap(u.analysed_x);
    ctx.state.analysed_r.swap(u.analysed_r);
    ctx.model.cuts.list.swap(u.cuts);
    ctx.model.cuts.group.swap(u.group);
    ctx.model.cuts.coupling.swap(u.coupling);
    std::swap(ctx.model.regroup.parts, u.parts);
    ctx.model.system.contacts.links.swap(u.links);
    ctx.model.system.contacts.forget_missing();
    ctx.work.stats.asleep = u.asleep_count;
    ctx.model.cuts.asked = u.asked;
    ctx.model.cuts.interfaces = u.interfaces;
    ctx.model.cuts.grouped = u.grouped;
    ctx.model.regroup.made = u.made;
    ctx.model.regroup.seen = u.seen;
    ctx.model.regroup.stale = u.stale;
    ctx.model.regroup.interactions = u.grouped_interactions;
    if (u.changed != context::Changed::nothing) std::swap(ctx.model.wires, u.wires);
    ctx.state.changed = u.changed;
    ctx.state.repair =
        u.repair == context::PendingRepair::nothing ? context::PendingRepair::rebuild : u.repair;
}

void restore_all(context::StepContext& ctx) noexcept {
    context::Undo& u = ctx.work.undo;
    ctx.model.collider.last_contacts().swap(u.kept);
    ctx.model.collider.last_awake_count() = u.kept_awake;
    ctx.model.system.contacts.memory.swap(u.memory);
    ctx.model.system.contacts.resistances.memory.swap(u.resistances);
    std::swap(ctx.state.contacts, u.contacts);
    ctx.state.contact_impulse.swap(u.contact_impulse);
    ctx.state.contact_sliding.swap(u.contact_sliding);
    ctx.work.stats.contacts = u.contact_count;
}

}  // namespace

void reserve_undo(const context::Model& model, context::Undo& undo) {
    context::Undo& u = undo;
    u.v.reserve(model.bodies.v.size());
    u.spin_change.reserve(model.bodies.spin_change.size());
    u.lambda.reserve(model.interactions.lambda.size());
    u.active.reserve(model.interactions.active.size());
    u.repeats.reserve(model.interactions.repeats.size());
    u.coarse.reserve(model.interactions.coarse.size());
    u.energy_allowance.reserve(model.wires.energy_allowance.size());
    u.flag_steps.reserve(model.wires.flag_steps.size());
    u.recoil.reserve(model.wires.recoil.size());
    if (model.collider.count() == 0) return;  // impacts need shapes
    u.x.reserve(model.bodies.x.size());
    u.q.reserve(model.bodies.q.size());
    u.r.reserve(model.bodies.r.size());
}

void save_motion(context::StepContext& ctx) noexcept {
    context::Undo& u = ctx.work.undo;
    if (u.moved) return;
    put(ctx.model.bodies.v, u.v);
    put(ctx.model.bodies.spin_change, u.spin_change);
    put(ctx.model.interactions.lambda, u.lambda);
    put(ctx.model.interactions.active, u.active);
    put(ctx.model.interactions.repeats, u.repeats);
    put(ctx.model.interactions.coarse, u.coarse);
    put(ctx.model.wires.energy_allowance, u.energy_allowance);
    put(ctx.model.wires.flag_steps, u.flag_steps);
    put(ctx.model.wires.recoil, u.recoil);
    u.scalars = read(ctx.state, ctx.work.stats);
    u.moved = true;
}

void save_poses(context::StepContext& ctx) noexcept {
    context::Undo& u = ctx.work.undo;
    if (u.posed) return;
    put(ctx.model.bodies.x, u.x);
    put(ctx.model.bodies.q, u.q);
    put(ctx.model.bodies.r, u.r);
    u.posed = true;
}

void save_link_steps(const context::Model& model, context::Undo& undo) {
    context::Undo& u = undo;
    if (u.linked) return;
    u.link_used = model.system.contacts.link_used;
    u.linked = true;
}

void save_state(context::StepContext& ctx, context::Undo::Depth depth) {
    context::Undo& u = ctx.work.undo;
    if (u.depth < 0) {
        save_system(ctx);
        u.depth = 0;
    }
    if (static_cast<int>(depth) <= u.depth) return;
    u.bodies = ctx.model.bodies;
    u.interactions = ctx.model.interactions;
    u.all_cuts = ctx.model.cuts;
    if (depth == context::Undo::Depth::all) {
        u.kept = ctx.model.collider.last_contacts();
        u.memory = ctx.model.system.contacts.memory;
        u.resistances = ctx.model.system.contacts.resistances.memory;
        u.contacts = ctx.state.contacts;
        u.contact_impulse = ctx.state.contact_impulse;
        u.contact_sliding = ctx.state.contact_sliding;
        u.kept_awake = ctx.model.collider.last_awake_count();
        u.contact_count = ctx.work.stats.contacts;
    }
    u.depth = static_cast<int>(depth);
}

void restore_saved_values(context::StepContext& ctx) noexcept {
    context::Undo& u = ctx.work.undo;
    if (u.depth >= static_cast<int>(context::Undo::Depth::model)) {
        std::swap(ctx.model.bodies, u.bodies);
        std::swap(ctx.model.interactions, u.interactions);
        std::swap(ctx.model.cuts, u.all_cuts);
    }
    if (u.depth >= 0) {
        restore_system(ctx);
        ctx.model.bodies.asleep.swap(u.asleep);
        ctx.model.bodies.quiet.swap(u.quiet);
    }
    if (u.depth >= static_cast<int>(context::Undo::Depth::all)) restore_all(ctx);
    if (u.linked) ctx.model.system.contacts.link_used.swap(u.link_used);
    if (u.posed) {
        put(u.x, ctx.model.bodies.x);
        put(u.q, ctx.model.bodies.q);
        put(u.r, ctx.model.bodies.r);
    }
    if (u.moved) {
        put(u.v, ctx.model.bodies.v);
        put(u.spin_change, ctx.model.bodies.spin_change);
        put(u.lambda, ctx.model.interactions.lambda);
        put(u.active, ctx.model.interactions.active);
        put(u.repeats, ctx.model.interactions.repeats);
        put(u.coarse, ctx.model.interactions.coarse);
        put(u.energy_allowance, ctx.model.wires.energy_allowance);
        put(u.flag_steps, ctx.model.wires.flag_steps);
        put(u.recoil, ctx.model.wires.recoil);
        context::update_wire_flags(ctx.model);
        write(u.scalars, ctx);
    }
    discard_saved(ctx.work.undo);
}

void discard_saved(context::Undo& undo) noexcept {
    context::Undo& u = undo;
    u.moved = u.posed = u.linked = false;
    // Copies of the whole model are rare and large, so their memory is freed.
    if (u.depth >= static_cast<int>(context::Undo::Depth::model)) {
        u.bodies = {};
        u.interactions = {};
        u.all_cuts = {};
    }
    u.depth = -1;
}

}  // namespace hawser::state
