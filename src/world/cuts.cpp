// SPDX-License-Identifier: Apache-2.0
/// Couplings of single interactions, and worlds that differ only in coupling.
#include <hawser/experimental/splits.h>
#include <hawser/inspect.h>

#include "context/asleep.h"
#include "context/context.h"
#include "context/cuts_data.h"
#include "context/undo_data.h"
#include "context/wire_alerts.h"
#include "split/split.h"
#include "state/undo.h"
#include "step/prepare.h"
#include "step/ready.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/lookup.h"
#include "world/saved_state.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace hawser {

void WorldSplits::set_group(BodyId id, const std::string& group) {
    const world::Using use(impl().use, "set_group");
    const std::size_t b = impl().index_of(id);
    WorldImpl& m = impl();
    if (m.body_defs[b].group == group) return;
    std::string name = group;
    m.ctx.model.regroup.by_hand[b] = m.number_of_group(group);
    m.body_defs[b].group.swap(name);
    m.ctx.model.regroup.stale = true;
    if (!split::makes_groups(m.ctx.model))
        m.ctx.model.cuts.group[b] = m.ctx.model.regroup.by_hand[b];
    m.ctx.state.changed = context::Changed::all;
    if (m.listener != nullptr) m.listener->set_group(id, group);
}

std::int32_t WorldImpl::number_of_group(const std::string& name) {
    if (name.empty()) return -1;
    if (const std::int32_t known = groups.find(name); known >= 0) return known;
    const auto number = static_cast<std::int32_t>(groups.size());
    groups.add(name, number);
    return number;
}

void WorldSplits::follow_groups(int parts, int every) {
    const world::Using use(impl().use, "follow_groups");
    context::StepContext& c = impl().ctx;
    WorldDef def = c.model.def;
    def.parts = parts;
    def.regroup_every = every;
    world::check(def);
    if (parts != c.model.def.parts) {
        std::vector<std::int32_t> by_hand = c.model.regroup.by_hand;
        c.model.regroup.parts = {};
        c.model.regroup.stale = true;
        c.state.changed = context::Changed::all;
        if (parts == 0) c.model.cuts.group.swap(by_hand);
    }
    c.model.def = def;
    if (impl().listener != nullptr) impl().listener->follow_groups(parts, every);
}

std::vector<std::int32_t> WorldSplitsView::groups() const {
    const world::Using use(impl().use, "groups");
    context::StepContext& c = impl().ctx;
    step::ready(c);
    std::vector<std::int32_t> out = c.model.cuts.group;
    for (std::int32_t b = 0; b < world_->body_count(); ++b)
        if (c.model.bodies.dof(b) == 0) out[at(b)] = -1;
    return out;
}

void WorldSplits::set_groups(int parts) {
    const world::Using use(impl().use, "set_groups");
    if (parts < 1 || parts > 4096)
        throw DefError("groups: parts = " + std::to_string(parts) + "; give 1 to 4096");
    WorldImpl& m = impl();
    std::vector<std::string> names;
    for (const BodyDef& b : m.body_defs) names.push_back(b.group);
    std::vector<std::int32_t> by_hand = m.ctx.model.regroup.by_hand;
    const WorldDef before = m.ctx.model.def;
    step::Transaction all(m.ctx);
    state::save_state(m.ctx, context::Undo::Depth::model);
    try {
        const WorldImpl::SilencedListener silenced(m);
        regroup_all(parts);
    } catch (...) {
        m.ctx.model.def = before;
        m.ctx.model.regroup.by_hand.swap(by_hand);
        for (std::size_t b = 0; b < names.size(); ++b) m.body_defs[b].group.swap(names[b]);
        throw;
    }
    all.done();
    if (m.listener != nullptr) m.listener->set_groups(parts);
}

void WorldSplits::regroup_all(int parts) {
    follow_groups(0, impl().ctx.model.def.regroup_every);
    for (const BodyId b : world_->bodies()) set_group(b, "");
    if (parts == 1) return;
    const PartitionView view = partition({.use = PartitionUse::cuts, .parts = parts});
    for (const BodyId b : world_->bodies())
        if (view.part_of_body[at(b.index)] >= 0)
            set_group(b, "part " + std::to_string(view.part_of_body[at(b.index)]));
}

void WorldSplits::set_coupling(InteractionId id, Coupling coupling) {
    const world::Using use(impl().use, "set_coupling");
    const std::size_t i = impl().index_of(id);
    context::StepContext& c = impl().ctx;
    if (coupling > Coupling::deadline) throw DefError("unknown coupling");
    if (coupling != Coupling::exact && c.model.def.sleep_after > 0.0)
        throw DefError("a coupling other than exact needs sleep_after 0");
    if (coupling != Coupling::exact && !split::can_cut(c.model, id.index))
        throw DefError(world::label("interaction", c.model.interactions.def[i].name) +
                       ": a motor, a range, friction, a load of friction or a winch cannot be cut; "
                       "use the exact coupling");
    c.model.cuts.coupling.resize(at(world_->interaction_count()), c.model.def.coupling);
    if (c.model.cuts.coupling[i] == coupling) return;
    c.model.cuts.coupling[i] = coupling;
    c.model.regroup.stale = true;
    c.state.changed = context::Changed::all;
    if (impl().listener != nullptr) impl().listener->set_coupling(id, coupling);
}

Coupling WorldSplitsView::coupling(InteractionId id) const {
    const std::size_t i = impl().index_of(id);
    const context::Cuts& cuts = impl().ctx.model.cuts;
    return i < cuts.coupling.size() ? cuts.coupling[i] : impl().ctx.model.def.coupling;
}

std::vector<CutView> WorldSplitsView::cuts() const {
    const world::Using use(impl().use, "cuts");
    WorldImpl& m = impl();
    step::ready(m.ctx);
    std::vector<CutView> out;
    for (const context::Cut& c : m.ctx.model.cuts.list)
        out.push_back({m.ctx.model.interactions.id(c.id), m.ctx.model.cuts.coupling[at(c.id)],
                       c.open, c.defect, c.residual});
    return out;
}

namespace {

/// Copy motion, multipliers and stored friction, up to the common length of each array.
void copy_motion(const context::StepContext& from, context::StepContext& to) {
    std::vector<std::span<const std::byte>> arrays;
    world::visit_motion(from,
                        [&](const auto& a) { arrays.push_back(std::as_bytes(std::span(a))); });
    std::size_t next = 0;
    world::visit_motion(to, [&](auto& a) {
        const std::span<const std::byte> its = arrays[next++];
        const std::span<std::byte> mine = std::as_writable_bytes(std::span(a));
        std::copy_n(its.begin(), std::min(its.size(), mine.size()), mine.begin());
    });
    // With other cut elements the wires differ.
    if (from.model.wires.count() != to.model.wires.count()) {
        std::fill(to.model.wires.energy_allowance.begin(), to.model.wires.energy_allowance.end(),
                  0.0);
        std::fill(to.model.wires.flag_steps.begin(), to.model.wires.flag_steps.end(), 0);
        std::fill(to.model.wires.recoil.begin(), to.model.wires.recoil.end(), 0);
    }
    if (to.model.def.sleep_after == 0.0) {  // sleeping bodies are awake in this world
        std::fill(to.model.bodies.asleep.begin(), to.model.bodies.asleep.end(), std::uint8_t{0});
        std::fill(to.model.bodies.quiet.begin(), to.model.bodies.quiet.end(), 0);
    }
    context::check_asleep(to.model, to.work.stats);
    context::update_wire_flags(to.model);
}

void copy_values(const context::StepContext& from, context::StepContext& to) {
    std::vector<std::span<const std::byte>> values;
    world::visit_values(from,
                        [&](const auto& v) { values.push_back(std::as_bytes(std::span(&v, 1))); });
    std::size_t next = 0;
    world::visit_values(to, [&](auto& v) {
        const std::span<const std::byte> its = values[next++];
        std::memcpy(&v, its.data(), its.size());
    });
    to.state.time = to.work.stats.time = from.state.time;
    to.work.stats.step = from.state.step;
}

/// Copy the contacts of the last step.
/// @return true if other pairs of bodies are in contact than before.
bool copy_contacts(const context::StepContext& from, context::StepContext& to) {
    assembly::Contacts& c = to.model.system.contacts;
    const assembly::Contacts& f = from.model.system.contacts;
    to.model.collider.last_contacts() = from.model.collider.last_contacts();
    to.model.collider.last_awake_count() = from.model.collider.last_awake_count();
    c.memory = f.memory;
    c.resistances.memory = f.resistances.memory;
    c.link_used = f.link_used;
    to.state.contacts.contacts.clear();
    to.state.contacts.awake = 0;
    to.state.contact_impulse.clear();
    to.state.contact_sliding.clear();
    to.work.stats.contacts = 0;
    if (c.links == f.links) return false;
    c.links = f.links;
    c.make_blocks();
    return true;
}

/// Copy the groups that follow the state, if both worlds have such groups.
void copy_groups(const context::StepContext& from, context::StepContext& to) {
    if (!split::makes_groups(from.model) || !split::makes_groups(to.model)) return;
    const bool same = to.model.regroup.parts.part == from.model.regroup.parts.part;
    to.model.regroup.parts = from.model.regroup.parts;
    to.model.regroup.made = from.model.regroup.made;
    to.model.regroup.seen = from.model.regroup.seen;
    if (same || split::assign_groups(to.model) == 0) return;
    to.state.changed = context::Changed::all;
    step::prepare(to);
}

}  // namespace

void WorldState::copy_from(const World& other) {
    const world::Using use(impl().use, "state().copy_from"),
        reading(impl(other).use, "state().copy_from");
    const context::StepContext& from = impl(other).ctx;
    context::StepContext& to = impl().ctx;
    step::ready(impl(other).ctx);
    step::ready(to);
    if (other.body_count() != world_->body_count() ||
        other.interaction_count() != world_->interaction_count() ||
        other.input_count() != world_->input_count() ||
        from.model.bodies.v.size() != to.model.bodies.v.size() ||
        from.model.def.step != to.model.def.step)
        throw DefError("copy_from: the worlds have other bodies, interactions, inputs or steps");
    if (impl(other).systems.layout() != impl().systems.layout())
        throw DefError("copy_from: the worlds have other systems, or systems of other sizes");
    std::vector<std::byte> systems(impl().systems.state_bytes());
    std::vector<std::byte> systems_before(systems.size());
    impl(other).systems.save(systems.data());
    impl().systems.save(systems_before.data());
    std::vector<double> inputs = impl().input_values;
    std::vector<std::pair<Vec3, Vec3>> forces;
    for (const BodyDef& def : impl().body_defs) forces.emplace_back(def.force, def.torque);
    step::Transaction all(to);
    state::save_state(to, context::Undo::Depth::all);
    std::vector<std::byte> copied;
    try {
        impl().copy_from(impl(other));
        for (const BodyId id : impl().body_ids) {
            impl().body_defs[at(id.index)].force = impl(other).body_defs[at(id.index)].force;
            impl().body_defs[at(id.index)].torque = impl(other).body_defs[at(id.index)].torque;
        }
        impl().systems.restore(systems.data());
        if (impl().listener != nullptr) copied = save();
    } catch (...) {
        impl().input_values.swap(inputs);
        for (std::size_t b = 0; b < forces.size(); ++b)
            std::tie(impl().body_defs[b].force, impl().body_defs[b].torque) = forces[b];
        impl().systems.restore(systems_before.data());
        throw;
    }
    all.done();
    impl().systems.discard_actions();
    impl().outputs.forget_figures();
    if (impl().listener != nullptr) impl().listener->restored(copied);
}

void WorldImpl::copy_from(const WorldImpl& other) {
    const context::StepContext& from = other.ctx;
    context::StepContext& to = ctx;
    copy_groups(from, to);
    const auto asleep = to.model.bodies.asleep;
    copy_motion(from, to);
    if (copy_contacts(from, to) || asleep != to.model.bodies.asleep) split::analyse(to);
    copy_values(from, to);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        input_values[i] = other.input_values[i];
        if (inputs[i].interaction.valid()) apply_input(i, input_values[i]);
    }
    for (const auto* list : {&to.model.interactions.frictions, &to.model.interactions.spans})
        for (const std::int32_t id : *list)
            to.model.interactions.set_anchor(id, to.model.interactions.anchor[at(id)]);
    for (const std::int32_t id : to.model.interactions.winches)
        to.model.interactions.update_length_at_drum(id, to.model.bodies, to.model.def.step);
    // Ghost bodies and duplicated rows differ with the coupling.
    if (from.model.interactions.count() != to.model.interactions.count())
        split::follow_cuts(to.model);
    if (from.model.cuts.interfaces == to.model.cuts.interfaces &&
        split::request_cuts(to, from.model.cuts.asked) != Status::ok)
        throw std::bad_alloc();
}

}  // namespace hawser
