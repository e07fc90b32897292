// SPDX-License-Identifier: Apache-2.0
/// Insertion and removal of nodes of wires (hawser/wire.h, edit/nodes.h).
#include <hawser/world.h>

#include "edit/node_pieces.h"
#include "edit/nodes.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/node_defs.h"
#include "world/wire_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace hawser {
namespace {

/// Return the position of an element in a list; −1: absent.
template <class Id>
std::ptrdiff_t find_in(const std::vector<Id>& list, Id id) noexcept {
    const auto found = std::find(list.begin(), list.end(), id);
    return found == list.end() ? -1 : found - list.begin();
}

void reserve_node(world::Wire& wire) {
    for (auto* list : {&wire.elements, &wire.bends}) base::reserve_more(*list, 1);
    for (auto* list : {&wire.nodes, &wire.lumps}) base::reserve_more(*list, 1);
    base::reserve_more(wire.shapes, 1);
}

/// Insert a node and the objects added with it into the lists of a wire. Capacity has been
/// reserved.
/// @param made  The node, its element, bend and capsule.
/// @param first  True if the new element comes before the existing one.
void insert_into_lists(world::Wire& wire, InteractionId element, const world::Wire& made,
                       bool first) noexcept {
    const auto k = find_in(wire.elements, element);
    wire.nodes.insert(wire.nodes.begin() + k + 1, made.lumps[0]);
    wire.elements.insert(wire.elements.begin() + k + (first ? 0 : 1), made.elements[0]);
    if (!wire.owns) return;
    wire.lumps.push_back(made.lumps[0]);
    for (const InteractionId id : made.bends) wire.bends.push_back(id);
    for (const ShapeId id : made.shapes) wire.shapes.push_back(id);
}

}  // namespace

world::Wire* WorldImpl::wire_with(InteractionId element) noexcept {
    for (const WireId id : wires.ids)
        if (find_in(wires.wires[at(id.index)].elements, element) >= 0)
            return &wires.wires[at(id.index)];
    return nullptr;
}

WireId WorldWiresView::of(InteractionId element) const noexcept {
    for (const WireId id : impl().wires.ids)
        if (find_in(impl().wires.wires[at(id.index)].elements, element) >= 0) return id;
    return {};
}

/// Update the stored definitions after an edit has changed masses and drags: nodes, their forces
/// that depend on mass, elements, and inputs of an element at a drum.
void WorldImpl::update_definitions_near(const edit::NodeSurroundings& place) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    for (const std::int32_t id : {place.first, place.second}) {
        for (std::size_t slot = 0; id >= 0 && slot < 2; ++slot) {
            const std::int32_t body = in.body[kMaxInteractionBodies * at(id) + slot];
            if (ctx.model.bodies.kind[at(body)] != BodyKind::lump) continue;
            BodyDef& def = body_defs[at(body)];
            const double scale = ctx.model.bodies.mass[at(body)] / def.mass;
            def.mass = ctx.model.bodies.mass[at(body)];
            for (int k = 0; k < 3; ++k) {
                def.linear_damping[k] = ctx.model.bodies.damping[6 * at(body) + at(k)];
                if (def.force[k] == 0.0) continue;
                def.force[k] *= scale;
                add_up_force(BodyId{body}, k);
            }
        }
        if (id >= 0 && kind_info(in.kinds[at(id)]).is(kWoundUp)) follow_inputs(id);
    }
}

void WorldImpl::follow_inputs(std::int32_t element) noexcept {
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (inputs[i].interaction.valid() && inputs[i].interaction.index == element)
            input_values[i] = ctx.model.interactions.def[at(element)].get(inputs[i].param);
}

/// Return the EI for the bend at a node that is inserted in an element [N m²]. It is that of the
/// bend at the first end, or of the bend at the last end if two line types meet at the first.
double WorldImpl::bend_stiffness_near(const edit::NodeSurroundings& place,
                                      const world::Wire* wire) const noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const auto same_line = [&](std::int32_t id) {
        return id < 0 || edit::is_at_drum(ctx, id) || edit::is_at_drum(ctx, place.first) ||
               in.def[at(id)].get("EA") == in.def[at(place.first)].get("EA");
    };
    const bool first = place.bend[0] >= 0 && (same_line(place.before[0]) || place.bend[2] < 0);
    const std::int32_t adjacent_bend = first ? place.bend[0] : place.bend[2];
    if (adjacent_bend >= 0) return in.def[at(adjacent_bend)].get("EI");
    return wire != nullptr ? wire->trim.EI : 0.0;
}

BodyId WorldWires::insert_node(InteractionId element, double share, double mass) {
    const world::Using use(impl().use, "insert_node");
    const Attempt attempt(*world_, context::has_cuts(impl().ctx.model));
    WorldImpl& m = impl();
    model::Interactions& in = m.ctx.model.interactions;
    m.check_node(element, share, mass);
    edit::NodeSurroundings place{.first = element.index};
    const bool wound = edit::is_at_drum(m.ctx, element.index);
    // True if the new element comes first, because the one at a drum stays there.
    const bool first = wound && edit::drum_side(m.ctx, element.index) == 1;
    const double whole = wound ? mass : edit::mass_of_element(m.ctx, element.index);
    if (context::has_cuts(m.ctx.model)) edit::begin_edit(m.ctx);  // remove duplicated rows first
    (void)edit::complete_surroundings(m.ctx, place);
    const BodyId a = in.def[at(element.index)].body[0], b = in.def[at(element.index)].body[1];
    const BodyDef body = world::node_body(*world_, in.def[at(element.index)],
                                          edit::node_on(m.ctx, element.index, share, whole));
    const ShapeId segment = m.segment_between(a.index, b.index);
    world::Wire* wire = m.wire_with(element);
    if (wire != nullptr) reserve_node(*wire);

    const WorldImpl::Mark before = m.mark(a, b);
    const edit::NodeEnergies was = edit::begin_node_edit(m.ctx, place);
    world::Wire& made = m.wires.coming;
    made.begin({}, true);
    reserve_node(made);
    const double EI = m.bend_stiffness_near(place, wire);
    InteractionDef bend = world::node_bend(in, element.index, EI);
    for (const std::size_t slot : {0U, 1U})
        bend.point[2 * slot] = edit::attachment_point(m.ctx, element.index, slot);
    try {
        const WorldImpl::SilencedListener silenced(m);
        const BodyId node = world_->add_body(body);
        made.lumps.push_back(node);
        bend.body[1] = node;
        const double own = first ? share : 1.0 - share;
        made.elements.push_back(world_->add_interaction(
            world::other_element(in, element.index, node, share, first, own * whole,
                                 first ? place.before[0] : place.after[0])));
        if (EI > 0.0 && a != b) made.bends.push_back(world_->add_interaction(bend));
        if (const auto next = m.next_segment(place, node, first, wire); next)
            made.shapes.push_back(world_->add_shape(*next));
    } catch (...) {
        m.take_back(before, made);
        throw;
    }
    // No call below throws.
    place.node = made.lumps[0].index;
    place.first = first ? made.elements[0].index : element.index;
    place.second = first ? element.index : made.elements[0].index;
    place.bend[1] = made.bends.empty() ? -1 : made.bends[0].index;
    edit::finish_node_insertion(m.ctx, place, element.index, share, whole);
    edit::end_node_edit(m.ctx, place, was);
    m.update_definitions_near(place);
    if (segment.valid()) m.move_segment(segment, 1, made.lumps[0]);
    if (wire != nullptr) insert_into_lists(*wire, element, made, first);
    if (m.listener != nullptr) m.listener->node_inserted(element, share, mass);
    return made.lumps[0];
}

bool WorldWires::remove_node(BodyId node, double bend) {
    const world::Using use(impl().use, "remove_node");
    Attempt attempt(*world_, context::has_cuts(impl().ctx.model));
    WorldImpl& m = impl();
    (void)m.index_of(node);
    if (context::has_cuts(m.ctx.model)) edit::begin_edit(m.ctx);  // remove duplicated rows first
    edit::NodeSurroundings place{.node = node.index};
    const std::int32_t stays = m.check_node_removable(node, place, bend);
    model::Interactions& in = m.ctx.model.interactions;
    const InteractionId kept = in.id(stays),
                        gone = in.id(stays == place.first ? place.second : place.first);
    const BodyId a = in.def[at(place.first)].body[0], b = in.def[at(place.second)].body[1];
    m.reserve_removal();
    const ShapeId near = m.segment_between(a.index, node.index),
                  far = m.segment_between(node.index, b.index);
    const edit::NodeEnergies was = edit::begin_node_edit(m.ctx, place);
    const bool goes = edit::is_at_drum(m.ctx, stays) ? edit::release_drum_node(m.ctx, place, bend)
                                                     : edit::release_node(m.ctx, place, bend);
    if (!goes) {
        attempt.fail();
        return false;
    }
    if (near.valid() && far.valid()) m.join_segments(near, far);
    if (place.bend[1] >= 0) m.remove(in.id(place.bend[1]));
    m.remove_folded_bend(place.bend[0]);
    m.remove_folded_bend(place.bend[2]);
    m.remove(gone);
    m.remove(node);
    place.first = stays;
    place.second = place.node = place.bend[1] = -1;
    edit::end_node_edit(m.ctx, place, was);
    m.update_definitions_near(place);
    if (world::Wire* wire = m.wire_with(kept)) {
        wire->elements.erase(wire->elements.begin() + find_in(wire->elements, gone));
        wire->nodes.erase(wire->nodes.begin() + find_in(wire->nodes, node));
        std::erase(wire->lumps, node);
        std::erase_if(wire->bends, [&](InteractionId id) { return !world_->alive(id); });
        std::erase_if(wire->shapes, [&](ShapeId id) { return !world_->alive(id); });
    }
    if (m.listener != nullptr) m.listener->node_removed(node, bend);
    return true;
}

}  // namespace hawser
