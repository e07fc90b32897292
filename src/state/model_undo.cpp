// SPDX-License-Identifier: Apache-2.0
#include "state/model_undo.h"

#include "context/wire_alerts.h"

#include <utility>

namespace hawser::state {

void ModelUndo::keep(const context::StepContext& ctx) {
    const context::Model& m = ctx.model;
    const context::State& s = ctx.state;
    bodies_ = m.bodies;
    interactions_ = m.interactions;
    m.collider.keep(collider_);
    m.system.keep(system_);
    omitted_ = m.system.left_out;
    sides_ = m.system.sides;
    memory_ = m.system.contacts.memory;
    resistances_ = m.system.contacts.resistances.memory;
    links_ = m.system.contacts.links;
    link_used_ = m.system.contacts.link_used;
    cuts_ = m.cuts;
    wires_ = m.wires;
    parts_ = m.regroup.parts;
    manual_groups_ = m.regroup.by_hand;
    made_ = m.regroup.made;
    seen_ = m.regroup.seen;
    stale_ = m.regroup.stale;
    grouped_interactions_ = m.regroup.interactions;
    ledger_ = s.ledger;
    work_ = s.loads.work;
    water_ = s.loads.water;
    added_ = s.loads.added;
    monitor_ = s.monitor.state;
    contacts_ = s.contacts;
    contact_impulse_ = s.contact_impulse;
    contact_sliding_ = s.contact_sliding;
    analysed_x_ = s.analysed_x;
    analysed_r_ = s.analysed_r;
    changed_ = s.changed;
    edits_ = s.edits;
    repair_ = s.repair;
    event_count_ = ctx.work.stats.event_count;
    asleep_ = ctx.work.stats.asleep;
    contact_count_ = ctx.work.stats.contacts;
}

void ModelUndo::go_back(context::StepContext& ctx) noexcept {
    context::Model& m = ctx.model;
    context::State& s = ctx.state;
    std::swap(m.bodies, bodies_);
    std::swap(m.interactions, interactions_);
    m.collider.restore_shapes(collider_);
    m.system.go_back(system_);
    m.system.left_out.swap(omitted_);
    m.system.sides.swap(sides_);
    m.system.contacts.memory.swap(memory_);
    m.system.contacts.resistances.memory.swap(resistances_);
    m.system.contacts.links.swap(links_);
    m.system.contacts.link_used.swap(link_used_);
    m.system.contacts.forget_missing();
    std::swap(m.cuts, cuts_);
    std::swap(m.wires, wires_);
    std::swap(m.regroup.parts, parts_);
    m.regroup.by_hand.swap(manual_groups_);
    m.regroup.made = made_;
    m.regroup.seen = seen_;
    m.regroup.stale = stale_;
    m.regroup.interactions = grouped_interactions_;
    s.ledger = ledger_;
    s.loads.work = work_;
    s.loads.water = water_;
    s.loads.added = added_;
    s.monitor.state = monitor_;
    std::swap(s.contacts, contacts_);
    s.contact_impulse.swap(contact_impulse_);
    s.contact_sliding.swap(contact_sliding_);
    s.analysed_x.swap(analysed_x_);
    s.analysed_r.swap(analysed_r_);
    std::swap(s.edits, edits_);
    s.changed = changed_;
    // If the model was to be prepared anyway, that follows from the restored order.
    if (changed_ != context::Changed::all)
        s.repair = repair_ == context::PendingRepair::follow ||
                           repair_ == context::PendingRepair::all_follow
                       ? context::PendingRepair::all_follow
                       : context::PendingRepair::all;
    else
        s.repair =
            repair_ == context::PendingRepair::nothing ? context::PendingRepair::rebuild : repair_;
    ctx.work.stats.event_count = event_count_;
    ctx.work.stats.asleep = asleep_;
    ctx.work.stats.contacts = contact_count_;
    s.events.release(false);
}

}  // namespace hawser::state
