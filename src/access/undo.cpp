// SPDX-License-Identifier: Apache-2.0
#include "access/undo.h"

#include "access/wire_alerts.h"
#include "context/undo_data.h"

#include <algorithm>
#include <utility>

namespace hawser::stepper {
namespace {

/// Where nothing may throw: room for it was made before.
template <class A>
void put(const A& from, A& to) noexcept {
    to.assign(from.begin(), from.end());
}

Undo::Scalars read(const StepContext& c) noexcept {
    return {c.step,
            c.time,
            c.work,
            c.drag,
            c.drive,
            c.friction,
            c.contact,
            c.damped,
            c.loads.work,
            c.loads.added,
            c.refine_unasked,
            c.started,
            c.stats.event_count,
            c.judge.state};
}

void write(const Undo::Scalars& from, StepContext& c) noexcept {
    c.step = c.stats.step = from.step;
    c.time = c.stats.time = from.time;
    c.work = from.work;
    c.drag = from.drag;
    c.drive = from.drive;
    c.friction = from.friction;
    c.contact = from.contact;
    c.damped = from.damped;
    c.loads.work = from.system_work;
    c.loads.added = from.added;
    c.refine_unasked = from.refine_unasked;
    c.started = from.started;
    c.stats.event_count = from.event_count;
    c.judge.state = from.judge;
}

void keep_system(StepContext& ctx) {
    Undo& u = ctx.undo;
    reserve_undo(ctx);
    ctx.system.keep(u.system);
    u.analysed_x = ctx.analysed_x;
    u.analysed_r = ctx.analysed_r;
    u.asleep = ctx.bodies.asleep;
    u.quiet = ctx.bodies.quiet;
    u.links = ctx.system.contacts.links;
    u.cuts = ctx.cuts.list;
    u.group = ctx.cuts.group;
    u.coupling = ctx.cuts.coupling;
    u.parts = ctx.regroup.parts;
    if (ctx.topology_changed) u.wires = ctx.wires;
    keep_links(ctx);
    keep_motion(ctx);
    u.mend = ctx.mend;
    u.topology_changed = ctx.topology_changed;
    u.asleep_count = ctx.stats.asleep;
    u.asked = ctx.cuts.asked;
    u.interfaces = ctx.cuts.interfaces;
    u.grouped = ctx.cuts.grouped;
    u.made = ctx.regroup.made;
    u.seen = ctx.regroup.seen;
    u.stale = ctx.regroup.stale;
    u.grouped_interactions = ctx.regroup.interactions;
}

void go_back_system(StepContext& ctx) noexcept {
    Undo& u = ctx.undo;
    ctx.system.go_back(u.system);
    ctx.analysed_x.swap(u.analysed_x);
    ctx.analysed_r.swap(u.analysed_r);
    ctx.cuts.list.swap(u.cuts);
    ctx.cuts.group.swap(u.group);
    ctx.cuts.coupling.swap(u.coupling);
    std::swap(ctx.regroup.parts, u.parts);
    ctx.system.contacts.links.swap(u.links);
    ctx.system.contacts.forget_missing();
    ctx.stats.asleep = u.asleep_count;
    ctx.cuts.asked = u.asked;
    ctx.cuts.interfaces = u.interfaces;
    ctx.cuts.grouped = u.grouped;
    ctx.regroup.made = u.made;
    ctx.regroup.seen = u.seen;
    ctx.regroup.stale = u.stale;
    ctx.regroup.interactions = u.grouped_interactions;
    if (u.topology_changed) std::swap(ctx.wires, u.wires);
    ctx.topology_changed = u.topology_changed;
    ctx.mend = u.mend == Mend::nothing ? Mend::rebuild : u.mend;
}

void go_back_all(StepContext& ctx) noexcept {
    Undo& u = ctx.undo;
    ctx.collider.kept().swap(u.kept);
    ctx.collider.kept_awake() = u.kept_awake;
    ctx.system.contacts.memory.swap(u.memory);
    ctx.system.contacts.resistances.memory.swap(u.resistances);
    std::swap(ctx.contacts, u.contacts);
    ctx.contact_impulse.swap(u.contact_impulse);
    ctx.contact_sliding.swap(u.contact_sliding);
    ctx.stats.contacts = u.contact_count;
}

}  // namespace

void reserve_undo(StepContext& ctx) {
    Undo& u = ctx.undo;
    u.v.reserve(ctx.bodies.v.size());
    u.spin_change.reserve(ctx.bodies.spin_change.size());
    u.lambda.reserve(ctx.interactions.lambda.size());
    u.active.reserve(ctx.interactions.active.size());
    u.repeats.reserve(ctx.interactions.repeats.size());
    u.coarse.reserve(ctx.interactions.coarse.size());
    u.credit.reserve(ctx.wires.credit.size());
    u.alert.reserve(ctx.wires.alert.size());
}

void keep_motion(StepContext& ctx) noexcept {
    Undo& u = ctx.undo;
    if (u.moved) return;
    put(ctx.bodies.v, u.v);
    put(ctx.bodies.spin_change, u.spin_change);
    put(ctx.interactions.lambda, u.lambda);
    put(ctx.interactions.active, u.active);
    put(ctx.interactions.repeats, u.repeats);
    put(ctx.interactions.coarse, u.coarse);
    put(ctx.wires.credit, u.credit);
    put(ctx.wires.alert, u.alert);
    u.scalars = read(ctx);
    u.moved = true;
}

void keep_links(StepContext& ctx) {
    Undo& u = ctx.undo;
    if (u.linked) return;
    u.link_used = ctx.system.contacts.link_used;
    u.linked = true;
}

void keep_state(StepContext& ctx, Undo::Depth depth) {
    Undo& u = ctx.undo;
    if (u.depth < 0) {
        keep_system(ctx);
        u.depth = 0;
    }
    if (static_cast<int>(depth) <= u.depth) return;
    u.bodies = ctx.bodies;
    u.interactions = ctx.interactions;
    u.all_cuts = ctx.cuts;
    if (depth == Undo::Depth::all) {
        u.kept = ctx.collider.kept();
        u.memory = ctx.system.contacts.memory;
        u.resistances = ctx.system.contacts.resistances.memory;
        u.contacts = ctx.contacts;
        u.contact_impulse = ctx.contact_impulse;
        u.contact_sliding = ctx.contact_sliding;
        u.kept_awake = ctx.collider.kept_awake();
        u.contact_count = ctx.stats.contacts;
    }
    u.depth = static_cast<int>(depth);
}

void restore_kept(StepContext& ctx) noexcept {
    Undo& u = ctx.undo;
    if (u.depth >= static_cast<int>(Undo::Depth::model)) {
        std::swap(ctx.bodies, u.bodies);
        std::swap(ctx.interactions, u.interactions);
        std::swap(ctx.cuts, u.all_cuts);
    }
    if (u.depth >= 0) {
        go_back_system(ctx);
        ctx.bodies.asleep.swap(u.asleep);
        ctx.bodies.quiet.swap(u.quiet);
    }
    if (u.depth >= static_cast<int>(Undo::Depth::all)) go_back_all(ctx);
    if (u.linked) ctx.system.contacts.link_used.swap(u.link_used);
    if (u.moved) {
        put(u.v, ctx.bodies.v);
        put(u.spin_change, ctx.bodies.spin_change);
        put(u.lambda, ctx.interactions.lambda);
        put(u.active, ctx.interactions.active);
        put(u.repeats, ctx.interactions.repeats);
        put(u.coarse, ctx.interactions.coarse);
        put(u.credit, ctx.wires.credit);
        put(u.alert, ctx.wires.alert);
        follow_alerts(ctx);
        write(u.scalars, ctx);
    }
    drop_kept(ctx);
}

void drop_kept(StepContext& ctx) noexcept {
    Undo& u = ctx.undo;
    u.moved = u.linked = false;
    // Copies of the whole model are rare and large.
    if (u.depth >= static_cast<int>(Undo::Depth::model)) {
        u.bodies = {};
        u.interactions = {};
        u.all_cuts = {};
    }
    u.depth = -1;
}

}  // namespace hawser::stepper
