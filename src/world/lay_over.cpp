// SPDX-License-Identifier: Apache-2.0
/// Division of a wire element by a fairlead, roller or bollard (hawser/guide.h).
#include <hawser/world.h>

#include "context/context.h"
#include "edit/node_pieces.h"
#include "edit/nodes.h"
#include "edit/wire_ends.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/wheel_momentum.h"
#include "world/wire_capsule.h"
#include "world/wire_list.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace hawser {
namespace {

/// Check that the parts belong to the element.
/// @throws DefError
void check_parts(const world::Where& where, const InteractionDef& old, const InteractionDef& before,
                 const InteractionDef& behind) {
    const auto ends = [&](const InteractionDef& d) {
        return kind_info(d.kind).is(kAtGuide) && d.body[2] == before.body[2];
    };
    if (!ends(before) || !ends(behind))
        world::throw_def_error(where, "it is divided into parts of kind end_span with one slide");
    if (before.body[0] != old.body[0] || behind.body[1] != old.body[1] ||
        before.body[1] != behind.body[0])
        world::throw_def_error(where, "its parts must have its ends and meet at one body");
    if (!(before.get("radius") < 0.0 && behind.get("radius") > 0.0))
        world::throw_def_error(where, "the slide must lengthen one part and shorten the other");
}

/// Return the mass that a node transfers to the guide for its half of an element [kg]. This is the
/// whole half. If a drum or guide also loads the next element, a hundredth remains, because a body
/// needs some mass (edit/node_drum.cpp). 0: not possible.
double mass_moved_to_guide(const World& world, const world::Wire& wire, InteractionId element,
                           std::size_t end, double half) {
    const double has = world.body_def(world.interaction_def(element).body[end]).mass;
    if (edit::exceeds_half(has, half)) return half;
    const auto at = std::find(wire.elements.begin(), wire.elements.end(), element);
    if (end == 0 ? at == wire.elements.begin() : at + 1 == wire.elements.end()) return 0.0;
    const InteractionId next = end == 0 ? *(at - 1) : *(at + 1);
    if (!world.alive(next) || !kind_info(world.interaction_def(next).kind).is(kWoundUp)) return 0.0;
    return std::max(0.0, std::min(has, half) - edit::kKeptMass * half);
}

/// Parts of an element at a guide, and their capsules.
struct Parts {
    std::array<InteractionId, 2> element;
    std::array<ShapeId, 2> capsule;
};

/// Add both parts of an element at a guide, or none of them. @param then  Further call that may
/// throw.
template <class F>
Parts add_parts(World& world, const WireTrim& trim, const InteractionDef& before,
                const InteractionDef& behind, F&& then) {
    Parts out;
    try {
        for (const std::size_t k : {0U, 1U})
            out.element[k] = world.add_interaction(k == 0 ? before : behind);
        for (const std::size_t k : {0U, 1U})
            if (const auto part = world::element_capsule(world, trim, k == 0 ? before : behind))
                out.capsule[k] = world.add_shape(*part);
        then();
    } catch (...) {
        for (const ShapeId id : out.capsule)
            if (id.valid()) (void)world.remove_shape(id);
        for (const InteractionId id : out.element)
            if (id.valid()) (void)world.remove_interaction(id);
        throw;
    }
    return out;
}

}  // namespace

std::array<InteractionId, 2> WorldWires::engage(InteractionId element, InteractionDef before,
                                                const InteractionDef& behind) {
    const world::Using use(impl().use, "wires().engage");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    WorldImpl& m = impl();
    const InteractionDef old = world_->interaction_def(element);
    const world::Where where("interaction", old.name);
    if (!kind_info(old.kind).is(kWireElement) || kind_info(old.kind).is(kWoundUp))
        world::throw_def_error(
            where, "only an element of a wire that no drum or guide has can be divided");
    if (!world_->intact(element)) world::throw_def_error(where, "it is broken");
    check_parts(where, old, before, behind);
    world::Wire* wire = m.wire_with(element);
    if (wire == nullptr) world::throw_def_error(where, "it is of no wire");
    const double half = 0.5 * edit::mass_of_element(m.ctx, element.index);
    std::array<double, 2> moved_mass{};
    for (const std::size_t end : {0U, 1U}) {
        if (world_->body_def(old.body[end]).kind != BodyKind::lump || !(half > 0.0)) continue;
        moved_mass[end] = mass_moved_to_guide(*world_, *wire, element, end, half);
        if (!(moved_mass[end] > 0.0))
            world::throw_def_error(where, "a node at its end has less than half of it");
    }
    m.check_not_needed(element);
    base::reserve_more(wire->elements, 1);
    base::reserve_more(wire->nodes, 1);
    base::reserve_more(wire->shapes, 2);
    const std::array<Vec3, 2> speed{edit::speed_of(m.ctx, element.index, 0, m.ctx.model.bodies.v),
                                    edit::speed_of(m.ctx, element.index, 1, m.ctx.model.bodies.v)};
    std::array<InteractionId, 2> out;
    {
        const WorldImpl::SilencedListener silenced(m);
        // The name moves after all checks.
        const std::string name_before = std::exchange(before.name, "");
        const Parts parts =
            add_parts(*world_, wire->trim, before, behind, [&m] { m.reserve_removal(); });
        before.name = name_before;
        out = parts.element;
        for (const ShapeId id : parts.capsule)
            if (id.valid()) wire->shapes.push_back(id);
        const ShapeId capsule = m.segment_between(old.body[0].index, old.body[1].index);
        if (capsule.valid()) {
            m.remove(capsule);
            std::erase(wire->shapes, capsule);
        }
        world::Names::Map::node_type name = m.interaction_names.extract_name(old.name);
        m.remove(element);
        m.interaction_names.insert_at(std::move(name), out[0].index);
        m.ctx.model.interactions.def[at(out[0].index)].name = old.name;
        (void)m.sorted_removal();
        const auto place = std::find(wire->elements.begin(), wire->elements.end(), element);
        *place = out[0];
        const auto k = place - wire->elements.begin();
        wire->elements.insert(place + 1, out[1]);
        wire->nodes.insert(wire->nodes.begin() + k + 1, before.body[1]);
        for (const std::size_t side : {0U, 1U})  // its neighbour is now the guide
            m.replace_bend_neighbour(old.body[side], old.body[1 - side], before.body[1],
                                     edit::attachment_point(m.ctx, out[side].index, 1 - side));
        std::erase_if(wire->bends, [&](InteractionId id) { return !world_->alive(id); });
        for (const std::size_t end : {0U, 1U})
            if (moved_mass[end] > 0.0)
                set_mass(old.body[end], world_->body_def(old.body[end]).mass - moved_mass[end]);
        world::apply_lateral_impulse(m.ctx, {out[0].index, out[1].index}, speed,
                                     0.5 * (moved_mass[0] + moved_mass[1]));
    }
    if (m.listener != nullptr) m.listener->laid_over(element, before, behind);
    return out;
}

/// Replace a neighbour of the bend about a node by a body that holds it at a point of its frame.
void WorldImpl::replace_bend_neighbour(BodyId lump, BodyId from, BodyId to,
                                       const Vec3& point) noexcept {
    model::Interactions& in = ctx.model.interactions;
    const std::int32_t bend = edit::bend_at_body(ctx, lump.index, from.index);
    if (bend < 0) return;
    const std::size_t slot = edit::end_of(ctx, bend, 0) == from.index ? 0 : 2;
    in.def[at(bend)].point[slot] = point;
    in.rewire(bend, slot, to, ctx.model.bodies);
    remove_folded_bend(bend);
}

/// Remove a bend between two turning points of one body, because an interaction can have each body
/// only once. The effect of a bend between a bollard and a drum of one ship is negligible. Capacity
/// has been reserved (reserve_removal()).
void WorldImpl::remove_folded_bend(std::int32_t bend) noexcept {
    if (bend >= 0 && edit::end_of(ctx, bend, 0) == edit::end_of(ctx, bend, 2))
        remove(ctx.model.interactions.id(bend));
}

/// Return the wire to which two parts belong. @throws DefError if they are not results of
/// lay_over().
world::Wire& WorldImpl::wire_on_guide(InteractionId before, InteractionId behind,
                                      const InteractionDef& element) {
    const InteractionDef &a = ctx.model.interactions.def[at(before.index)],
                         &b = ctx.model.interactions.def[at(behind.index)];
    const world::Where where("interaction", a.name);
    if (!kind_info(a.kind).is(kAtGuide) || b.kind != a.kind || a.body[2] != b.body[2] ||
        a.body[1] != b.body[0])
        world::throw_def_error(where, "only two parts with one slide become an element again");
    if (!kind_info(element.kind).is(kWireElement) || kind_info(element.kind).is(kWoundUp) ||
        element.body[0] != a.body[0] || element.body[1] != b.body[1])
        world::throw_def_error(where, "the result must be an element of a wire between their ends");
    world::Wire* wire = wire_with(before);
    if (wire == nullptr || wire != wire_with(behind))
        world::throw_def_error(where, "it is of no wire");
    return *wire;
}

InteractionId WorldWires::disengage(InteractionId before, InteractionId behind,
                                    InteractionDef element) {
    const world::Using use(impl().use, "wires().disengage");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    WorldImpl& m = impl();
    const InteractionDef a = world_->interaction_def(before), b = world_->interaction_def(behind);
    world::Wire& wire = m.wire_on_guide(before, behind, element);
    m.check_not_needed(a.body[2]);
    const std::string element_name = std::exchange(element.name, "");
    const auto is_free_node = [&](BodyId id) {
        return world_->body_def(id).kind == BodyKind::lump;
    };
    const double half = std::isnan(element.get("mass")) ? 0.0 : 0.5 * element.get("mass");
    const BodyId ends[2] = {a.body[0], b.body[1]};
    const double had[2] = {world_->body_def(ends[0]).mass, world_->body_def(ends[1]).mass};
    const world::WireAtWheel wheel =
        world::read_wire_at_wheel(m.ctx, {before.index, behind.index}, 2.0 * half);
    const auto weigh = [&](double more) {
        for (const std::size_t k : {0U, 1U})
            if (half > 0.0 && is_free_node(ends[k])) set_mass(ends[k], had[k] + more);
    };
    InteractionId out;
    {
        const WorldImpl::SilencedListener silenced(m);
        weigh(half);  // An element with a mass needs nodes with that mass.
        ShapeId capsule;
        try {
            out = world_->add_interaction(element);
            if (const auto segment = world::element_capsule(*world_, wire.trim, element)) {
                base::reserve_more(wire.shapes, 1);
                capsule = world_->add_shape(*segment);
            }
            m.reserve_removal();
        } catch (...) {
            if (capsule.valid()) (void)world_->remove_shape(capsule);
            if (out.valid()) (void)world_->remove_interaction(out);
            weigh(0.0);
            throw;
        }
        for (const InteractionDef* part : {&a, &b}) {
            const ShapeId its = m.segment_between(part->body[0].index, part->body[1].index);
            if (!its.valid()) continue;
            m.remove(its);
            std::erase(wire.shapes, its);
        }
        world::Names::Map::node_type name = m.interaction_names.extract_name(a.name);
        m.remove(a.body[2]);  // with the parts, their friction and its inputs
        m.interaction_names.insert_at(std::move(name), out.index);
        m.ctx.model.interactions.def[at(out.index)].name = a.name;
        (void)m.sorted_removal();
        if (capsule.valid()) wire.shapes.push_back(capsule);
        const auto place = std::find(wire.elements.begin(), wire.elements.end(), before);
        *place = out;
        const auto k = place - wire.elements.begin();
        wire.elements.erase(place + 1);
        wire.nodes.erase(wire.nodes.begin() + k + 1);
        for (const std::size_t side : {0U, 1U}) {
            const BodyId end = side == 0 ? a.body[0] : b.body[1],
                         far = side == 0 ? b.body[1] : a.body[0];
            m.replace_bend_neighbour(end, a.body[1], far, element.point[1 - side]);
        }
        std::erase_if(wire.bends, [&](InteractionId id) { return !world_->alive(id); });
        for (const std::size_t end : {0U, 1U})
            if (half > 0.0 && is_free_node(ends[end]))
                world::divide_momentum(m.ctx, ends[end].index, wheel, end);
    }
    element.name = element_name;
    if (m.listener != nullptr) m.listener->lifted(before, behind, element);
    return out;
}

std::array<Vec3, 2> WorldWiresView::ends(InteractionId id) const {
    const InteractionDef& d = world_->interaction_def(id);
    const KindInfo& kind = kind_info(d.kind);
    if (!kind.is(kPulls) || !kind.uses_points)
        throw DefError(world::label("interaction", d.name) + ": a " + kind.name +
                       " is no piece of a line with two ends");
    if (!kind.is(kRouted))
        return {world_->world_point(d.body[0], d.point[0]),
                world_->world_point(d.body[1], d.point[1])};
    const model::LineShape s =
        impl().ctx.model.interactions.line_shape(id.index, impl().ctx.model.bodies);
    return {s.at[0], s.at[1]};
}

std::array<double, 2> WorldWiresView::wrapped(InteractionId id) const {
    if (!kind_info(world_->interaction_def(id).kind).is(kRouted)) return {};
    return impl().ctx.model.interactions.wrapped(id.index, impl().ctx.model.bodies);
}

}  // namespace hawser
