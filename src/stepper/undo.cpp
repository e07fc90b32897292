// SPDX-License-Identifier: Apache-2.0
#include "stepper/undo.h"

#include "stepper/sleep.h"
#include "stepper/stages.h"
#include "stepper/step.h"
#include "stepper/wires.h"

#include <algorithm>
#include <utility>

namespace hawser::stepper {
namespace {

/// Where nothing may throw: room for it was made before.
template <class A>
void put(const A& from, A& to) noexcept {
    to.assign(from.begin(), from.end());
}

}  // namespace

void Undo::reserve(const StepContext& ctx) {
    v_.reserve(ctx.bodies.v.size());
    spin_change_.reserve(ctx.bodies.spin_change.size());
    lambda_.reserve(ctx.interactions.lambda.size());
    active_.reserve(ctx.interactions.active.size());
    repeats_.reserve(ctx.interactions.repeats.size());
    coarse_.reserve(ctx.interactions.coarse.size());
    credit_.reserve(ctx.wires.credit.size());
    alert_.reserve(ctx.wires.alert.size());
}

Undo::Scalars Undo::read(const StepContext& c) noexcept {
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

void Undo::write(const Scalars& from, StepContext& c) noexcept {
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

void Undo::keep_motion(const StepContext& ctx) noexcept {
    if (moved_) return;
    put(ctx.bodies.v, v_);
    put(ctx.bodies.spin_change, spin_change_);
    put(ctx.interactions.lambda, lambda_);
    put(ctx.interactions.active, active_);
    put(ctx.interactions.repeats, repeats_);
    put(ctx.interactions.coarse, coarse_);
    put(ctx.wires.credit, credit_);
    put(ctx.wires.alert, alert_);
    scalars_ = read(ctx);
    moved_ = true;
}

void Undo::keep_links(const StepContext& ctx) {
    if (linked_) return;
    link_used_ = ctx.system.contacts.link_used;
    linked_ = true;
}

void Undo::keep_system(const StepContext& ctx) {
    reserve(ctx);
    ctx.system.keep(system_);
    analysed_x_ = ctx.analysed_x;
    analysed_r_ = ctx.analysed_r;
    asleep_ = ctx.bodies.asleep;
    quiet_ = ctx.bodies.quiet;
    links_ = ctx.system.contacts.links;
    cuts_ = ctx.cuts.list;
    group_ = ctx.cuts.group;
    coupling_ = ctx.cuts.coupling;
    parts_ = ctx.regroup.parts;
    if (ctx.topology_changed) wires_ = ctx.wires;
    keep_links(ctx);
    keep_motion(ctx);
    mend_ = ctx.mend;
    topology_changed_ = ctx.topology_changed;
    asleep_count_ = ctx.stats.asleep;
    asked_ = ctx.cuts.asked;
    interfaces_ = ctx.cuts.interfaces;
    grouped_ = ctx.cuts.grouped;
    made_ = ctx.regroup.made;
    seen_ = ctx.regroup.seen;
    stale_ = ctx.regroup.stale;
    grouped_interactions_ = ctx.regroup.interactions;
}

void Undo::keep(const StepContext& ctx, Depth depth) {
    if (depth_ < 0) {
        keep_system(ctx);
        depth_ = 0;
    }
    if (static_cast<int>(depth) <= depth_) return;
    bodies_ = ctx.bodies;
    interactions_ = ctx.interactions;
    all_cuts_ = ctx.cuts;
    if (depth == Depth::all) {
        kept_ = ctx.collider.kept();
        memory_ = ctx.system.contacts.memory;
        resistances_ = ctx.system.contacts.resistances.memory;
        contacts_ = ctx.contacts;
        contact_impulse_ = ctx.contact_impulse;
        contact_sliding_ = ctx.contact_sliding;
        kept_awake_ = ctx.collider.kept_awake();
        contact_count_ = ctx.stats.contacts;
    }
    depth_ = static_cast<int>(depth);
}

void Undo::go_back_system(StepContext& ctx) noexcept {
    ctx.system.go_back(system_);
    ctx.analysed_x.swap(analysed_x_);
    ctx.analysed_r.swap(analysed_r_);
    ctx.cuts.list.swap(cuts_);
    ctx.cuts.group.swap(group_);
    ctx.cuts.coupling.swap(coupling_);
    std::swap(ctx.regroup.parts, parts_);
    ctx.system.contacts.links.swap(links_);
    ctx.system.contacts.forget_missing();
    ctx.stats.asleep = asleep_count_;
    ctx.cuts.asked = asked_;
    ctx.cuts.interfaces = interfaces_;
    ctx.cuts.grouped = grouped_;
    ctx.regroup.made = made_;
    ctx.regroup.seen = seen_;
    ctx.regroup.stale = stale_;
    ctx.regroup.interactions = grouped_interactions_;
    if (topology_changed_) std::swap(ctx.wires, wires_);
    ctx.topology_changed = topology_changed_;
    ctx.mend = mend_ == Mend::nothing ? Mend::rebuild : mend_;
}

void Undo::go_back_all(StepContext& ctx) noexcept {
    ctx.collider.kept().swap(kept_);
    ctx.collider.kept_awake() = kept_awake_;
    ctx.system.contacts.memory.swap(memory_);
    ctx.system.contacts.resistances.memory.swap(resistances_);
    std::swap(ctx.contacts, contacts_);
    ctx.contact_impulse.swap(contact_impulse_);
    ctx.contact_sliding.swap(contact_sliding_);
    ctx.stats.contacts = contact_count_;
}

void Undo::go_back(StepContext& ctx) noexcept {
    if (depth_ >= static_cast<int>(Depth::model)) {
        std::swap(ctx.bodies, bodies_);
        std::swap(ctx.interactions, interactions_);
        std::swap(ctx.cuts, all_cuts_);
    }
    if (depth_ >= 0) {
        go_back_system(ctx);
        ctx.bodies.asleep.swap(asleep_);
        ctx.bodies.quiet.swap(quiet_);
    }
    if (depth_ >= static_cast<int>(Depth::all)) go_back_all(ctx);
    if (linked_) ctx.system.contacts.link_used.swap(link_used_);
    if (moved_) {
        put(v_, ctx.bodies.v);
        put(spin_change_, ctx.bodies.spin_change);
        put(lambda_, ctx.interactions.lambda);
        put(active_, ctx.interactions.active);
        put(repeats_, ctx.interactions.repeats);
        put(coarse_, ctx.interactions.coarse);
        put(credit_, ctx.wires.credit);
        put(alert_, ctx.wires.alert);
        follow_alerts(ctx);
        write(scalars_, ctx);
    }
    drop();
}

void Undo::drop() noexcept {
    moved_ = linked_ = false;
    // Copies of the whole model are rare and large.
    if (depth_ >= static_cast<int>(Depth::model)) {
        bodies_ = {};
        interactions_ = {};
        all_cuts_ = {};
    }
    depth_ = -1;
}

namespace {

/// Poses and which rows are active are those of an analysis for as long as this lives.
class AnalysedPoses {
  public:
    explicit AnalysedPoses(StepContext& ctx)
        : ctx_(ctx), x_(ctx.bodies.x), r_(ctx.bodies.r), active_(ctx.interactions.active) {
        ctx.bodies.x = ctx.analysed_x;
        ctx.bodies.r = ctx.analysed_r;
    }
    ~AnalysedPoses() {
        ctx_.bodies.x.swap(x_);
        ctx_.bodies.r.swap(r_);
        ctx_.interactions.active.swap(active_);
    }
    AnalysedPoses(const AnalysedPoses&) = delete;
    AnalysedPoses& operator=(const AnalysedPoses&) = delete;

  private:
    StepContext& ctx_;
    base::Array<double> x_, r_, active_;
};

}  // namespace

void mend(StepContext& ctx) {
    if (ctx.mend == Mend::nothing) return;
    assembly::System::Kept before;
    ctx.system.keep(before);
    try {
        const factor::AnalysisState order = before.analysis.state;
        ctx.system.contacts.make_blocks();
        const AnalysedPoses poses(ctx);
        analyse(ctx, ctx.mend == Mend::rebuild ? &order : nullptr);
    } catch (...) {
        ctx.system.go_back(before);
        throw;
    }
    reserve_sleep(ctx);
    ctx.lambda_before.resize(ctx.interactions.lambda.size());
    ctx.repeats_before.resize(ctx.interactions.repeats.size());
    ctx.undo.reserve(ctx);
    ctx.mend = Mend::nothing;
}

void make_ready(StepContext& ctx) {
    if (ctx.topology_changed) {
        ctx.undo.keep(ctx, may_have_cuts(ctx) ? Undo::Depth::model : Undo::Depth::system);
        prepare(ctx);
        ctx.mend = Mend::nothing;
    } else {
        mend(ctx);
    }
}

Transaction::Transaction(StepContext& ctx) noexcept : ctx_(ctx), done_(ctx.undo.holds()) {}

Transaction::~Transaction() {
    if (!done_) ctx_.undo.go_back(ctx_);
}

void Transaction::done() noexcept {
    if (!done_) {
        ctx_.undo.drop();
        ctx_.edits.clear();
    }
    done_ = true;
}

void ready(StepContext& ctx) {
    if (!ctx.topology_changed && ctx.mend == Mend::nothing) return;
    Transaction all(ctx);
    make_ready(ctx);
    all.done();
}

}  // namespace hawser::stepper
