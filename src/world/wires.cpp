// SPDX-License-Identifier: Apache-2.0
/// Wires as objects of a world (hawser/wire.h).
#include <hawser/world.h>

#include "context/asleep.h"
#include "context/context.h"
#include "context/push_event.h"
#include "context/wire_alerts.h"
#include "split/split.h"
#include "step/ready.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/lookup.h"
#include "world/wire_maker.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <utility>

namespace hawser {
WireId WorldWires::add(const WireDef& def) {
    const world::Using use(impl().use, "wires().add");
    const world::Where where("wire", def.name);
    world::check(def);
    WorldImpl& m = impl();
    if (!world_->alive(def.from))
        world::throw_def_error(where, "there is no body that holds its first end");
    if (def.to.valid() && !world_->alive(def.to))
        world::throw_def_error(where, "there is no body that holds its last end");
    if (m.wires.names.contains(def.name))
        world::throw_def_error(where, "the name is in use; names must be unique");
    world::Wire& made = m.wires.coming;
    made.begin(def.name, true);
    made.trim.EI = def.sections.empty() ? def.EI : def.sections.front().EI;
    for (const WireSection& s : def.sections) made.trim.EI = std::min(made.trim.EI, s.EI);
    const WorldImpl::Mark before = m.mark(def.from, def.to);
    WireId id;
    try {
        const WorldImpl::SilencedListener silenced(m);
        world::make_wire(*world_, def, made, m.wires.lumps);
        id = m.store_wire(made);
    } catch (...) {
        m.take_back(before, made);
        throw;
    }
    m.report_wire(m.wire(id));
    return id;
}

/// Report an added wire to the listener part by part, in the order of addition.
void WorldImpl::report_wire(const world::Wire& made) const noexcept {
    if (listener == nullptr) return;
    try {
        for (const BodyId id : made.lumps) listener->added(body_defs[at(id.index)]);
        for (const auto* list : {&made.elements, &made.bends})
            for (const InteractionId id : *list) {
                InteractionDef d = ctx.model.interactions.def[at(id.index)];
                // As given: a default follows the length.
                if (ctx.model.interactions.flags[at(id.index)] & model::kFromLength)
                    d.compliance[0] = kDefault;
                listener->added(d);
            }
        for (const ShapeId id : made.shapes) listener->added(shape_defs[at(id.index)]);
    } catch (const std::bad_alloc&) {
        listener->lost();
    }
}

WorldImpl::Mark WorldImpl::mark(BodyId from, BodyId to) const noexcept {
    const auto quiet = [&](BodyId id) {
        return id.valid() ? ctx.model.bodies.quiet[at(id.index)] : 0;
    };
    return {context::body_count(ctx.model),
            context::interaction_count(ctx.model),
            ctx.model.collider.count(),
            ctx.state.edits.interactions.size(),
            ctx.state.ledger.edited,
            ctx.model.cuts.bodies >= 0 ? context::Changed::all : ctx.state.changed,
            ctx.state.edits.any,
            ctx.model.regroup.stale,
            {from, to},
            {quiet(from), quiet(to)}};
}

/// Undo all additions since a mark. Indices behind the mark are removed; reused indices become
/// vacant again, with their former generation.
void WorldImpl::take_back(const Mark& before, const world::Wire& made) noexcept {
    forget_removal();
    for (const ShapeId id : made.shapes) {
        remove(id);
        ctx.model.collider.slots.undo_vacate(id.index);
    }
    for (const auto* list : {&made.bends, &made.elements})
        for (const InteractionId id : *list) {
            remove(id);
            ctx.model.interactions.slots.undo_vacate(id.index);
        }
    for (const BodyId id : made.lumps) {
        remove(id);
        ctx.model.bodies.slots.undo_vacate(id.index);
    }
    ctx.model.collider.truncate(before.shapes);
    ctx.model.interactions.truncate(before.interactions, ctx.model.bodies);
    ctx.model.bodies.truncate(before.bodies);
    shape_defs.resize(at(before.shapes));
    body_defs.resize(at(before.bodies));
    ctx.model.regroup.by_hand.resize(at(before.bodies));
    ctx.model.cuts.group.resize(at(before.bodies));
    ctx.state.edits.interactions.resize(before.noted);
    ctx.state.ledger.edited = before.edited;
    ctx.state.changed = before.changed;
    ctx.state.edits.any = before.any_edit;
    ctx.model.regroup.stale = before.stale;
    for (std::size_t k = 0; k < 2; ++k)
        if (before.end[k].valid())
            ctx.model.bodies.quiet[at(before.end[k].index)] = before.quiet[k];
}

WireId WorldWires::adopt(const std::string& name, std::span<const InteractionId> elements,
                         const WireTrim& trim) {
    const world::Using use(impl().use, "wires().adopt");
    const std::string where = world::label("wire", name);
    if (name.empty()) throw DefError("a wire needs a name");
    if (elements.empty()) world::throw_def_error(where, "it has no elements");
    WorldImpl& m = impl();
    world::Wire& made = m.wires.coming;
    if (!(trim.EI >= 0.0) || !std::isfinite(trim.EI))
        world::throw_def_error(where, "EI must be a number from 0 on");
    made.begin(name, false);
    made.trim = trim;
    for (const InteractionId id : elements) {
        const InteractionDef& d = world_->interaction_def(id);
        if (!kind_info(d.kind).is(kWireElement))
            world::throw_def_error(
                where, world::label("interaction", d.name) + " is no element of a wire");
        if (made.nodes.empty()) made.nodes.push_back(d.body[0]);
        if (made.nodes.back() != d.body[0])
            world::throw_def_error(where, world::label("interaction", d.name) +
                                              " does not begin where the element before it ends");
        made.nodes.push_back(d.body[1]);
        made.elements.push_back(id);
    }
    if (m.wires.names.contains(name))
        world::throw_def_error(where, "the name is in use; names must be unique");
    return m.store_wire(made);
}

std::int32_t WorldImpl::reserve_wire_slot(const std::string& name) {
    wires.slots.reserve_more();
    base::reserve_more(wires.wires, 1);
    base::reserve_more(wires.ids, 1);
    const std::int32_t vacant = wires.slots.find_vacant([](std::int32_t) { return true; });
    world::claim_name(wires.names, name, vacant < 0 ? wires.slots.count() : vacant, "wire");
    return vacant;
}

WireId WorldImpl::put_wire(world::Wire& wire, std::int32_t vacant) noexcept {
    const std::int32_t place = vacant < 0 ? wires.slots.count() : vacant;
    if (vacant < 0) {
        (void)wires.slots.append();
        wires.wires.push_back(std::move(wire));
    } else {
        wires.slots.take(place);
        std::swap(wires.wires[at(place)], wire);  // its memory serves the next one
    }
    const auto id = wires.slots.id<WireId>(place);
    wires.ids.insert(std::lower_bound(wires.ids.begin(), wires.ids.end(), id), id);
    return id;
}

WireId WorldImpl::store_wire(world::Wire& wire) {
    return put_wire(wire, reserve_wire_slot(wire.name));
}

void WorldImpl::forget_wire(WireId id) noexcept {
    world::release(wires.names, wires.wires[at(id.index)].name);
    wires.ids.erase(std::lower_bound(wires.ids.begin(), wires.ids.end(), id));
    wires.wires[at(id.index)].begin({}, false);
    wires.slots.vacate(id.index);
}

const world::Wire& WorldImpl::wire(WireId id) const {
    return wires.wires[world::slot_index_of(id, wires.slots, wires.slots.count(), "wire")];
}

const Removed& WorldWires::remove(WireId id) {
    const world::Using use(impl().use, "wires().remove");
    WorldImpl& m = impl();
    const world::Wire& wire = m.wire(id);
    m.reserve_removal();
    if (wire.owns) {
        for (const InteractionId element : wire.elements)
            if (world_->alive(element)) m.remove(element);
        for (const InteractionId bend : wire.bends)
            if (world_->alive(bend)) m.remove(bend);
        for (const BodyId lump : wire.lumps)
            if (world_->alive(lump)) m.remove(lump);
    }
    if (m.listener != nullptr) {
        for (const InteractionId gone : m.removed.interactions) m.listener->removed(gone);
        for (const BodyId gone : m.removed.bodies) m.listener->removed(gone);
    }
    m.forget_wire(id);
    return m.sorted_removal();
}

std::span<const WireId> WorldWiresView::ids() const noexcept { return impl().wires.ids; }
bool World::alive(WireId id) const noexcept { return impl_->wires.slots.names(id); }
WireId WorldWiresView::find(std::string_view name) const noexcept {
    return impl().wires.slots.id<WireId>(world::lookup(impl().wires.names, name));
}
const std::string& WorldWiresView::name(WireId id) const { return impl().wire(id).name; }
std::span<const BodyId> WorldWiresView::nodes(WireId id) const { return impl().wire(id).nodes; }
std::span<const InteractionId> WorldWiresView::elements(WireId id) const {
    return impl().wire(id).elements;
}

double WorldWiresView::length(WireId id) const {
    double sum = 0.0;
    for (const InteractionId element : impl().wire(id).elements)
        if (world_->alive(element))
            sum += impl().ctx.model.interactions.rest_length[at(element.index)];
    return sum;
}

namespace {

/// Return the element at a material coordinate. Removed elements have no length.
InteractionId element_at(const World& w, const model::Interactions& in, const world::Wire& wire,
                         double s) {
    double end = 0.0;
    InteractionId last{};
    for (const InteractionId element : wire.elements) {
        if (!w.alive(element)) continue;
        end += in.rest_length[at(element.index)];
        last = element;
        if (s < end) break;
    }
    if (!(s >= 0.0) || !(s <= end) || !last.valid())
        throw DefError(world::label("wire", wire.name) + ": s = " + world::number(s) +
                       " m is not on it; give 0 to " + world::number(end) + " m");
    return last;
}

}  // namespace

double WorldWiresView::tension(WireId id, double s) const {
    const world::Wire& wire = impl().wire(id);
    const InteractionId element = element_at(*world_, impl().ctx.model.interactions, wire, s);
    return world_->intact(element) ? std::max(0.0, -world_->force(element)[0]) : 0.0;
}

/// Update the assignment of elements to wires for the recoil of a new element. @throws
/// std::bad_alloc.
void WorldImpl::update_wire_of(InteractionId element) {
    const std::vector<std::int32_t>& added = ctx.state.edits.interactions;
    if (!ctx.state.started || std::find(added.begin(), added.end(), element.index) != added.end())
        step::ready(ctx);
}

void WorldWires::part(WireId id, double s) {
    const world::Using use(impl().use, "part");
    part(element_at(*world_, impl().ctx.model.interactions, impl().wire(id), s));
}

void WorldWires::part(InteractionId id) {
    const world::Using use(impl().use, "part");
    const std::size_t i = impl().index_of(id);
    context::StepContext& c = impl().ctx;
    if (!kind_info(c.model.interactions.def[i].kind).is(kWireElement))
        throw DefError(world::label("interaction", c.model.interactions.def[i].name) +
                       ": only elements of wires part; World::remove_interaction() removes others");
    if (c.model.interactions.parted[i] != 0) return;
    impl().update_wire_of(id);
    const double tension =
        std::max(0.0, -c.model.interactions.force[at(c.model.interactions.row_begin[i])]);
    c.state.ledger.damped += edit::energy_of_interaction(c, id.index);
    c.state.ledger.edited.given += edit::piece_energy(c, id.index);
    for (std::size_t b = 0; b < c.model.interactions.bodies[i]; ++b)
        context::wake_island(c.model, c.model.interactions.body[kMaxInteractionBodies * i + b]);
    split::part_all(c.model, id.index);
    context::begin_recoil(c.model, id.index, c.state.changed == context::Changed::nothing);
    context::push_event(c, EventKind::line_break, id.index, tension);
    if (impl().listener != nullptr) impl().listener->parted(id);
}

}  // namespace hawser
