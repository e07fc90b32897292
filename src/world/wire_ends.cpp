// SPDX-License-Identifier: Apache-2.0
/// Ends of wires: test whether they are free, and release (hawser/wire.h).
#include <hawser/world.h>

#include "context/asleep.h"
#include "context/push_event.h"
#include "context/wire_alerts.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"
#include "edit/wire_ends.h"
#include "split/split.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/parts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace hawser {

world::FreeEnd WorldImpl::free_end(BodyId lump) const {
    const edit::NodeLinks links = edit::adjacent_elements(ctx, lump.index);
    const std::string where = world::label("body", body_defs[at(lump.index)].name);
    if (!edit::is_free_node(ctx, lump.index) || (links.before < 0) == (links.after < 0) ||
        !links.has_only_bends)
        world::throw_def_error(
            where,
            "it is no free end of a wire: a lump that one whole element holds and "
            "nothing else; detach() what is taken");
    const bool last = links.before >= 0;
    return {lump, ctx.model.interactions.id(last ? links.before : links.after), last ? 1U : 0U};
}

world::FreeEnd WorldImpl::free_end(WireId id, int end) const {
    const world::Wire& of = wire(id);
    const std::string where = world::label("wire", of.name);
    if (end != 0 && end != 1) world::throw_def_error(where, "end must be 0, the first one, or 1");
    const BodyId node = end == 0 ? of.nodes.front() : of.nodes.back();
    if (!ctx.model.bodies.slots.names(node))
        world::throw_def_error(where, "the lump at this end has been removed");
    const std::string name = end == 0 ? "its first end" : "its last end";
    if (!edit::is_free_node(ctx, node.index))
        world::throw_def_error(where, name + " is taken by the " +
                                          world::label("body", body_defs[at(node.index)].name) +
                                          "; detach() it first");
    const edit::NodeLinks links = edit::adjacent_elements(ctx, node.index);
    if ((links.before >= 0 && links.after >= 0) || !links.has_only_bends)
        world::throw_def_error(where, name + " is taken; detach() it first");
    if (links.before < 0 && links.after < 0)
        world::throw_def_error(where, "the element at this end has parted or gone");
    return free_end(node);
}

void WorldWires::detach(WireId id, int end) {
    const world::Using use(impl().use, "detach");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    const world::Wire& wire = impl().wire(id);
    const std::string where = world::label("wire", wire.name);
    if (end != 0 && end != 1) world::throw_def_error(where, "end must be 0, the first one, or 1");
    const InteractionId element = end == 0 ? wire.elements.front() : wire.elements.back();
    if (!world_->alive(element) || !world_->intact(element))
        world::throw_def_error(where, "the element at this end has parted or gone");
    detach(element, end);
}

void WorldWires::detach(InteractionId element, int end) {
    const world::Using use(impl().use, "detach");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    WorldImpl& m = impl();
    const model::Interactions& in = m.ctx.model.interactions;
    const std::size_t e = m.index_of(element);
    const std::string where = world::label("interaction", in.def[e].name);
    if (!kind_info(in.def[e].kind).is(kWireElement) || in.parted[e] != 0)
        world::throw_def_error(where, "only elements of wires that are whole have ends");
    if (end != 0 && end != 1) world::throw_def_error(where, "end must be 0, the first one, or 1");
    const BodyId body = in.def[e].body[at(end)];
    m.update_wire_of(element);
    if (context::has_cuts(m.ctx.model)) edit::begin_edit(m.ctx);  // remove duplicated rows first
    if (edit::is_free_node(m.ctx, body.index))
        m.open_gear(element, body);
    else
        m.free_node(*world_, element, at(end));
    if (m.listener != nullptr) m.listener->detached(element, end);
}

void WorldImpl::open_gear(InteractionId element, BodyId lump) {
    const model::Interactions& in = ctx.model.interactions;
    const auto holds = [&](const world::GearInUse& g) {
        if (!in.slots.names(g.id) || in.parted[at(g.id.index)] != 0) return false;
        const std::int32_t* body = &in.body[kMaxInteractionBodies * at(g.id.index)];
        return body[0] == lump.index || body[1] == lump.index;
    };
    if (std::none_of(gear.begin(), gear.end(), holds))
        world::throw_def_error(world::label("body", body_defs[at(lump.index)].name),
                               "no gear holds this end of a wire");
    for (const world::GearInUse& g : gear)
        if (holds(g)) check_not_needed(g.id);
    reserve_removal();
    // No call below throws.
    const double tension = edit::tension_of(ctx, element.index);
    context::begin_recoil(ctx.model, element.index, false);
    for (const world::GearInUse& g : gear)
        if (holds(g)) remove(g.id);
    std::erase_if(gear, [&](const world::GearInUse& g) { return !in.slots.names(g.id); });
    context::wake_island(ctx.model, lump.index);
    context::push_event(ctx, EventKind::detach, element.index, tension);
}

namespace {

/// Return the definition of the node at a released end.
BodyDef freed_body(const World& w, const context::StepContext& c, std::int32_t element,
                   std::size_t side, const edit::NodeFraction& node_fraction) {
    const BodyDef& next = w.body_def(c.model.interactions.def[at(element)].body[1 - side]);
    const bool lump = next.kind == BodyKind::lump;
    BodyDef out{.kind = BodyKind::lump, .position = edit::point_of(c, element, side)};
    out.velocity = edit::speed_of(c, element, side, c.model.bodies.v);
    out.mass = node_fraction.mass;
    if (!lump) return out;
    out.linear_damping = node_fraction.share * next.linear_damping;
    out.force = node_fraction.share * next.force;
    out.gravity = next.gravity;
    out.group = next.group;
    return out;
}

/// Return an element between two bodies that replaces an element at a drum, with the data of the
/// next element.
InteractionDef element_without_drum(const context::StepContext& c,
                                    const std::array<std::int32_t, 2>& element, std::size_t side,
                                    BodyId lump, double mass) {
    const model::Interactions& in = c.model.interactions;
    const std::int32_t id = element[0];
    const InteractionDef& def = in.def[at(id)];
    InteractionDef out;
    out.kind = InteractionKind::Stretch;
    out.body = {def.body[0], def.body[1]};
    out.body[side] = lump;
    out.point[1 - side] = def.point[1 - side];
    out.set("length", in.rest_length[at(id)]);
    for (const char* same : {"EA", "tension_only", "breaking_load"}) out.set(same, def.get(same));
    if (in.row_flags[at(in.row_begin[at(id)])] & model::kRowDamper)
        out.damping_time[0] = def.damping_time[0];
    if (mass > 0.0 && element[1] >= 0 && edit::mass_of_element(c, element[1]) > 0.0)
        out.set("mass", mass);
    return out;
}

void reserve_end(world::Wire& wire) {
    base::reserve_more(wire.lumps, 1);
    base::reserve_more(wire.elements, 1);
    base::reserve_more(wire.shapes, 1);
}

/// Copy the forces of one element to the element that replaces it.
void copy_forces(model::Interactions& in, std::int32_t from, std::int32_t to) noexcept {
    const auto before = at(in.row_begin[at(from)]), now = at(in.row_begin[at(to)]);
    in.lambda[now] = in.lambda[before];
    in.force[now] = in.force[before];
    in.active[at(to)] = in.active[at(from)];
}

/// Replace the last element of a wire by one that ends at a new node of the wire.
void end_at_node(world::Wire& wire, std::size_t side, const world::Wire& made, InteractionId before,
                 InteractionId now) noexcept {
    (side == 0 ? wire.nodes.front() : wire.nodes.back()) = made.lumps[0];
    std::replace(wire.elements.begin(), wire.elements.end(), before, now);
    if (!wire.owns) return;
    wire.lumps.push_back(made.lumps[0]);
    for (const ShapeId id : made.shapes) wire.shapes.push_back(id);
}

/// Fraction of an element's mass and loads that a node gets if the end of the element is released.
struct EndFraction {
    edit::NodeFraction node_fraction;
    double carried;             ///< Mass of the element that its winch carries [kg].
    std::int32_t next_element;  ///< Element on the other side of the next node; −1: none.
    bool node_next;             ///< True if the element's other end is a node.
};

EndFraction end_fraction(const context::StepContext& ctx, const world::Systems& systems,
                         InteractionId element, BodyId next) {
    const std::int32_t e = element.index;
    EndFraction out{.node_fraction = {.mass = 0.5 * edit::mass_of_element(ctx, e)},
                    .carried = systems.carried_mass(element),
                    .next_element = -1,
                    .node_next = edit::is_free_node(ctx, next.index)};
    if (out.node_next) {
        const edit::NodeLinks links = edit::adjacent_elements(ctx, next.index);
        out.next_element = links.before == e ? links.after : links.before;
        // The new end has half of the element like the body before it, for any other mass of the
        // next node.
        const double half = out.node_fraction.mass;
        out.node_fraction =
            half > 0.0 ? edit::NodeFraction{half, half / ctx.model.bodies.mass[at(next.index)]}
                       : edit::fraction_of(ctx, next.index, out.next_element, e);
    }
    if (out.carried > 0.0) {
        out.node_fraction.mass = 0.5 * out.carried;
        if (out.node_next)
            out.node_fraction.share =
                out.node_fraction.mass / ctx.model.bodies.mass[at(next.index)];
    }
    return out;
}

/// Return a capsule for an element at the end of a wire that has none, like the capsule of the next
/// element.
template <class Impl>
std::optional<ShapeDef> capsule_like(const Impl& m, std::int32_t next_element) {
    const ShapeId its = m.segment_between(edit::end_of(m.ctx, next_element, 0),
                                          edit::end_of(m.ctx, next_element, 1));
    if (!its.valid()) return {};
    std::optional<ShapeDef> out = m.shape_defs[at(its.index)];
    out->name.clear();
    out->position.setZero();
    return out;
}

/// Restore the mass of a node to the last bit. Scaling back would not give equal bits.
template <class Impl>
void restore_mass(Impl& m, World& world, BodyId lump, const BodyDef& was) {
    BodyDef& now = m.body_defs[at(lump.index)];
    if (now.mass == was.mass) return;
    world.wires().set_mass(lump, was.mass);
    for (int k = 0; k < 3; ++k) {
        now.linear_damping[k] = m.ctx.model.bodies.damping[at(6 * lump.index + k)] =
            was.linear_damping[k];
        now.force[k] = was.force[k];
        m.add_up_force(lump, k);
    }
}

}  // namespace

/// Release the end of an element from a body. If the body is a drum, its element remains there as
/// broken, and another element replaces it in the wire.
void WorldImpl::free_node(World& world, InteractionId element, std::size_t side) {
    model::Interactions& in = ctx.model.interactions;
    const std::int32_t e = element.index;
    const std::string where = world::label("interaction", in.def[at(e)].name);
    const BodyId held = in.def[at(e)].body[side], next = in.def[at(e)].body[1 - side];
    const bool wound = kind_info(in.def[at(e)].kind).is(kWoundUp);
    const auto [node_fraction, carried, next_element, node_next] =
        end_fraction(ctx, systems, element, next);
    world::check_end(where, node_fraction.mass, carried);
    const ShapeId own = segment_between(in.def[at(e)].body[0].index, in.def[at(e)].body[1].index);
    std::optional<ShapeDef> segment;
    if (!own.valid() && next_element >= 0) segment = capsule_like(*this, next_element);
    world::Wire* wire = wire_with(element);
    if (wire != nullptr) reserve_end(*wire);
    world::Wire made;
    reserve_end(made);
    const Mark before = mark(held, next);
    const context::Edited edited = ctx.state.ledger.edited;
    const context::Edited had = edit::splice_energy(ctx, next.index, -1, e, e);
    const SilencedListener silenced(*this);
    const BodyDef was = body_defs[at(next.index)];
    try {
        made.lumps.push_back(world.add_body(freed_body(world, ctx, e, side, node_fraction)));
        const BodyId lump = made.lumps[0];
        // Before the element that needs it, since the material at a drum may be heavier than the
        // next element.
        if (carried > 0.0 && node_next) world.wires().set_mass(next, was.mass + 0.5 * carried);
        if (wound)
            made.elements.push_back(world.add_interaction(
                element_without_drum(ctx, {e, next_element}, side, lump, carried)));
        if (segment) {
            segment->body = side == 0 ? lump : next;
            segment->body_b = side == 0 ? next : lump;
            made.shapes.push_back(world.add_shape(*segment));
        }
    } catch (...) {
        take_back(before, made);
        restore_mass(*this, world, next, was);
        ctx.state.ledger.edited = edited;
        throw;
    }
    // No call below throws.
    const BodyId lump = made.lumps[0];
    const double tension = edit::tension_of(ctx, e);
    const std::int32_t bend = edit::bend_at_body(ctx, next.index, held.index);
    context::begin_recoil(ctx.model, e, false);
    if (node_next && next_element >= 0)
        context::begin_recoil(ctx.model, next_element,
                              false);  // an element at a drum belongs to no wire
    edit::begin_edit(ctx);
    if (bend >= 0)
        edit::move_end(ctx, bend, edit::end_of(ctx, bend, 0) == held.index ? 0 : 2, lump.index);
    std::int32_t now = e;
    if (wound) {
        now = made.elements[0].index;
        copy_forces(in, e, now);
        split::part_all(ctx.model, e);
    } else {
        edit::move_end(ctx, e, side, lump.index);
    }
    if (own.valid()) move_segment(own, side, lump);
    for (const BodyId id : {held, next, lump}) context::wake_island(ctx.model, id.index);
    ctx.state.ledger.edited = edited + edit::splice_energy(ctx, next.index, -1, now, now) - had;
    ctx.state.ledger.edited.given += edit::energy_of_body(ctx, lump.index);
    context::push_event(ctx, EventKind::detach, now, tension);
    if (wire != nullptr) end_at_node(*wire, side, made, element, in.id(now));
}

}  // namespace hawser
