// SPDX-License-Identifier: Apache-2.0
/// An element of a wire comes to lie over what it runs over (hawser/guide.h).
#include <hawser/world.h>

#include "context/context.h"
#include "step/node_pieces.h"
#include "step/wire_ends.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/wire_list.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace hawser {
namespace {

/// @throws DefError where the parts are not those of the element.
void check_parts(const world::Where& where, const InteractionDef& old, const InteractionDef& before,
                 const InteractionDef& behind) {
    const auto ends = [&](const InteractionDef& d) {
        return d.kind == InteractionKind::EndSpan && d.body[2] == before.body[2];
    };
    if (!ends(before) || !ends(behind))
        world::refuse(where, "it is divided into parts of kind end_span with one slide");
    if (before.body[0] != old.body[0] || behind.body[1] != old.body[1] ||
        before.body[1] != behind.body[0])
        world::refuse(where, "its parts must have its ends and meet at one body");
    if (!(before.get("radius") < 0.0 && behind.get("radius") > 0.0))
        world::refuse(where, "the slide must take from the part before and give to the one behind");
}

}  // namespace

std::array<InteractionId, 2> World::lay_over(InteractionId element, InteractionDef before,
                                             InteractionDef behind) {
    const world::Using use(impl_->use, "lay_over");
    Impl& m = *impl_;
    const InteractionDef old = interaction_def(element);
    const world::Where where("interaction", old.name);
    if (!kind_info(old.kind).is(kWireElement) || kind_info(old.kind).is(kWoundUp))
        world::refuse(where, "only an element of a wire that no drum or guide has can be divided");
    if (!intact(element)) world::refuse(where, "it has parted");
    check_parts(where, old, before, behind);
    world::Wire* wire = m.wire_with(element);
    if (wire == nullptr) world::refuse(where, "it is of no wire");
    const double half = 0.5 * stepper::mass_of_element(m.ctx, element.index);
    for (const BodyId end : {old.body[0], old.body[1]})
        if (body_def(end).kind == BodyKind::lump && !(body_def(end).mass > half))
            world::refuse(where, "a lump at its end has less than half of it");
    m.refuse_held(element);
    base::make_room(wire->elements, 1);
    base::make_room(wire->nodes, 1);
    std::array<InteractionId, 2> out;
    // Its name changes hands once nothing can be refused.
    before.name.clear();
    out[0] = add_interaction(before);
    try {
        out[1] = add_interaction(behind);
        m.reserve_removal();
    } catch (...) {
        (void)remove_interaction(out[0]);
        throw;
    }
    const ShapeId capsule = m.segment_between(old.body[0].index, old.body[1].index);
    if (capsule.valid()) {
        m.remove(capsule);
        std::erase(wire->shapes, capsule);
    }
    world::Names::Map::node_type name = m.interaction_names.take(old.name);
    m.remove(element);
    if (m.listener != nullptr) {
        if (capsule.valid()) m.listener->removed(capsule);
        m.listener->removed(element);
    }
    m.interaction_names.give(std::move(name), out[0].index);
    m.ctx.model.interactions.def[at(out[0].index)].name = old.name;
    (void)m.sorted_removal();
    const auto place = std::find(wire->elements.begin(), wire->elements.end(), element);
    *place = out[0];
    const auto k = place - wire->elements.begin();
    wire->elements.insert(place + 1, out[1]);
    wire->nodes.insert(wire->nodes.begin() + k + 1, before.body[1]);
    model::Interactions& in = m.ctx.model.interactions;
    for (const std::size_t side : {0U, 1U}) {
        // The bend about a lump at its end has the guide for a neighbour now.
        const std::int32_t end = old.body[side].index, other = old.body[1 - side].index;
        const std::int32_t bend = stepper::bend_about(m.ctx, end, other);
        if (bend < 0) continue;
        const std::size_t slot = stepper::end_of(m.ctx, bend, 0) == other ? 0 : 2;
        in.def[at(bend)].point[slot] = stepper::held_at(m.ctx, out[side].index, 1 - side);
        in.rewire(bend, slot, before.body[1], m.ctx.model.bodies);
    }
    for (const BodyId end : {old.body[0], old.body[1]})
        if (half > 0.0 && body_def(end).kind == BodyKind::lump)
            set_mass(end, body_def(end).mass - half);
    return out;
}

std::array<Vec3, 2> World::ends(InteractionId id) const {
    const InteractionDef& d = interaction_def(id);
    const KindInfo& kind = kind_info(d.kind);
    if (!kind.is(kPulls) || !kind.uses_points)
        throw DefError(world::label("interaction", d.name) + ": a " + kind.name +
                       " is no piece of a line with two ends");
    if (!kind.is(kRouted))
        return {world_point(d.body[0], d.point[0]), world_point(d.body[1], d.point[1])};
    const model::LineShape s =
        impl_->ctx.model.interactions.line_shape(id.index, impl_->ctx.model.bodies);
    return {s.at[0], s.at[1]};
}

}  // namespace hawser
