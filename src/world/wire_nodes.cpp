// SPDX-License-Identifier: Apache-2.0
/// Nodes of wires that come and go (hawser/wire.h, step/nodes.h).
#include <hawser/world.h>

#include "step/node_pieces.h"
#include "step/nodes.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/wire_list.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace hawser {
namespace {

/// Where an element is in a list; −1: it is not there.
template <class Id>
std::ptrdiff_t find_in(const std::vector<Id>& list, Id id) noexcept {
    const auto found = std::find(list.begin(), list.end(), id);
    return found == list.end() ? -1 : found - list.begin();
}

/// A lump as those at the ends of its element are.
BodyDef node_body(const World& w, const InteractionDef& element, const stepper::NodeDef& node) {
    BodyDef out{.name = {}, .kind = BodyKind::lump, .position = node.position};
    out.velocity = node.velocity;
    out.mass = node.mass;
    out.linear_damping = node.damping;
    for (std::size_t b = 2; b-- > 0;) {
        const BodyDef& end = w.body_def(element.body[b]);
        if (end.kind != BodyKind::lump) continue;
        out.gravity = end.gravity;
        out.group = end.group;
    }
    return out;
}

/// What goes on from the node.
InteractionDef second_element(const model::Interactions& in, std::int32_t first, BodyId node,
                              double share) {
    const InteractionDef& def = in.def[at(first)];
    InteractionDef out;
    out.kind = def.kind;
    out.body = {node, def.body[1]};
    out.point[1] = def.point[1];
    out.set("length", (1.0 - share) * in.rest_length[at(first)]);
    for (const char* same : {"EA", "tension_only", "breaking_load"}) out.set(same, def.get(same));
    if (in.row_flags[at(in.row_begin[at(first)])] & model::kRowDamper)
        out.damping_time[0] = (1.0 - share) * def.damping_time[0];
    return out;
}

/// The bend at the node, as the one beside it.
InteractionDef node_bend(const model::Interactions& in, std::int32_t first, BodyId node,
                         std::int32_t beside) {
    const InteractionDef& def = in.def[at(first)];
    InteractionDef out;
    out.kind = in.def[at(beside)].kind;
    out.body = {def.body[0], node, def.body[1]};
    out.point = {def.point[0], Vec3::Zero(), def.point[1]};
    out.set("EI", in.def[at(beside)].get("EI")).set("length", 0.5 * in.rest_length[at(first)]);
    return out;
}

void make_room_for_node(world::Wire& wire) {
    for (auto* list : {&wire.elements, &wire.bends}) base::make_room(*list, 1);
    for (auto* list : {&wire.nodes, &wire.lumps}) base::make_room(*list, 1);
    base::make_room(wire.shapes, 1);
}

/// Room has been made. @param made  The node and what came with it.
void put_node(world::Wire& wire, InteractionId element, const world::Wire& made) noexcept {
    const auto k = find_in(wire.elements, element);
    wire.nodes.insert(wire.nodes.begin() + k + 1, made.lumps[0]);
    wire.elements.insert(wire.elements.begin() + k + 1, made.elements[0]);
    if (!wire.owns) return;
    wire.lumps.push_back(made.lumps[0]);
    for (const InteractionId id : made.bends) wire.bends.push_back(id);
    for (const ShapeId id : made.shapes) wire.shapes.push_back(id);
}

}  // namespace

world::Wire* World::Impl::wire_with(InteractionId element) noexcept {
    for (const WireId id : wires.ids)
        if (find_in(wires.wires[at(id.index)].elements, element) >= 0)
            return &wires.wires[at(id.index)];
    return nullptr;
}

/// The masses and lengths that an edit changed, for readers of definitions.
void World::Impl::follow_definitions(const stepper::NodePlace& place) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    for (const std::int32_t id : {place.first, place.second})
        for (std::size_t slot = 0; id >= 0 && slot < 2; ++slot) {
            const std::int32_t body = in.body[kMaxInteractionBodies * at(id) + slot];
            if (ctx.model.bodies.kind[at(body)] != BodyKind::lump) continue;
            body_defs[at(body)].mass = ctx.model.bodies.mass[at(body)];
            for (int k = 0; k < 3; ++k)
                body_defs[at(body)].linear_damping[k] =
                    ctx.model.bodies.damping[6 * at(body) + at(k)];
        }
}

/// The segment of an element goes to where the element goes.
void World::Impl::move_segment(ShapeId segment, std::size_t side, BodyId to) noexcept {
    stepper::forget_contacts(ctx, segment.index);
    (side == 0 ? shape_defs[at(segment.index)].body : shape_defs[at(segment.index)].body_b) = to;
    ctx.model.collider.rewire(segment.index, static_cast<int>(side), to.index);
}

/// The capsule between two lumps; invalid: there is none.
ShapeId World::Impl::segment_between(std::int32_t a, std::int32_t b) const noexcept {
    for (const ShapeId id : shape_ids) {
        const std::int32_t* body = ctx.model.collider.shapes()[at(id.index)].body;
        if (body[0] == a && body[1] == b) return id;
    }
    return {};
}

BodyId World::insert_node(InteractionId element, double share) {
    const world::Using use(impl_->use, "insert_node");
    Impl& m = *impl_;
    model::Interactions& in = m.ctx.model.interactions;
    const std::size_t e = m.place(element);
    const InteractionDef def = in.def[e];
    const std::string where = world::label("interaction", def.name);
    if (!kind_info(def.kind).is(kWireElement) || in.parted[e] != 0)
        world::refuse(where, "only elements of wires that are whole have nodes");
    if (!(share > 0.0 && share < 1.0))
        world::refuse(where,
                      "a node is put at a share between 0 and 1, not " + world::number(share));
    stepper::NodePlace place{.first = element.index};
    if (!(stepper::mass_of_element(m.ctx, element.index) > 0.0) ||
        !stepper::is_of_material(m.ctx, element.index))
        world::refuse(where,
                      "it has no mass of its own that a node could take (give it `mass`), or "
                      "a compliance that is not that of its length");
    if (stepper::has_cuts(m.ctx.model)) stepper::begin_edit(m.ctx);  // without copies of anything
    (void)stepper::find_place(m.ctx, place);
    const BodyId a = def.body[0], b = def.body[1];
    const BodyDef body = node_body(*this, def, stepper::node_on(m.ctx, element.index, share));
    const ShapeId segment = m.segment_between(a.index, b.index);
    ShapeDef next_segment;
    if (segment.valid()) next_segment = shape_def(segment);
    world::Wire* wire = m.wire_with(element);
    if (wire != nullptr) make_room_for_node(*wire);

    const Impl::Mark before = m.mark(a, b);
    const stepper::NodeLedger was = stepper::begin_node_edit(m.ctx, place);
    world::Wire made;
    make_room_for_node(made);
    const std::int32_t beside = place.bend[0] >= 0 ? place.bend[0] : place.bend[2];
    try {
        const Impl::Untold untold(m);
        const BodyId node = add_body(body);
        made.lumps.push_back(node);
        made.elements.push_back(add_interaction(second_element(in, element.index, node, share)));
        if (beside >= 0)
            made.bends.push_back(add_interaction(node_bend(in, element.index, node, beside)));
        if (segment.valid()) {
            next_segment.name.clear();
            next_segment.body = node;
            made.shapes.push_back(add_shape(next_segment));
        }
    } catch (...) {
        m.take_back(before, made);
        throw;
    }
    // From here on nothing throws.
    place.node = made.lumps[0].index;
    place.second = made.elements[0].index;
    place.bend[1] = made.bends.empty() ? -1 : made.bends[0].index;
    stepper::settle_node(m.ctx, place, share);
    stepper::end_node_edit(m.ctx, place, was);
    m.follow_definitions(place);
    if (segment.valid()) m.move_segment(segment, 1, made.lumps[0]);
    if (wire != nullptr) put_node(*wire, element, made);
    if (m.listener != nullptr) m.listener->node_inserted(element, share);
    return made.lumps[0];
}

bool World::remove_node(BodyId node, double bend) {
    const world::Using use(impl_->use, "remove_node");
    Impl& m = *impl_;
    (void)m.place(node);
    m.refuse_held(node);
    const std::string where = world::label("body", body_def(node).name);
    if (stepper::has_cuts(m.ctx.model)) stepper::begin_edit(m.ctx);  // without copies of anything
    stepper::NodePlace place{.node = node.index};
    if (body_def(node).kind != BodyKind::lump || !stepper::find_place(m.ctx, place))
        world::refuse(where, "it is no node between two elements of a wire, and nothing else");
    for (const std::int32_t id : {place.first, place.second})
        if (!(stepper::mass_of_element(m.ctx, id) > 0.0) || !stepper::is_of_material(m.ctx, id))
            world::refuse(where,
                          "its elements have no mass of their own (give them `mass`), or a "
                          "compliance that is not that of their length");
    if (!(bend >= 0.0)) world::refuse(where, "bend must be an angle, not " + world::number(bend));
    model::Interactions& in = m.ctx.model.interactions;
    const InteractionId first = in.id(place.first), second = in.id(place.second);
    const BodyId a = in.def[at(place.first)].body[0], b = in.def[at(place.second)].body[1];
    m.reserve_removal();
    const ShapeId near = m.segment_between(a.index, node.index),
                  far = m.segment_between(node.index, b.index);
    const stepper::NodeLedger was = stepper::begin_node_edit(m.ctx, place);
    if (!stepper::release_node(m.ctx, place, bend)) return false;
    if (near.valid() && far.valid()) m.move_segment(near, 1, b);
    if (place.bend[1] >= 0) m.remove(in.id(place.bend[1]));
    m.remove(second);
    m.remove(node);
    place.second = place.node = place.bend[1] = -1;
    stepper::end_node_edit(m.ctx, place, was);
    m.follow_definitions(place);
    if (world::Wire* wire = m.wire_with(first)) {
        const auto k = find_in(wire->elements, second);
        wire->elements.erase(wire->elements.begin() + k);
        wire->nodes.erase(wire->nodes.begin() + k);
        std::erase(wire->lumps, node);
        std::erase_if(wire->bends, [&](InteractionId id) { return !alive(id); });
        std::erase_if(wire->shapes, [&](ShapeId id) { return !alive(id); });
    }
    if (m.listener != nullptr) m.listener->node_removed(node, bend);
    return true;
}

}  // namespace hawser
