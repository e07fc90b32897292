// SPDX-License-Identifier: Apache-2.0
/// Splicing of wires (hawser/wire.h, edit/wire_ends.h).
#include <hawser/world.h>

#include "context/push_event.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"
#include "edit/wire_ends.h"
#include "world/checks.h"
#include "world/impl.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace hawser {
namespace {

/// Append elements, nodes and other parts of one wire to those of another. Capacity has been
/// reserved.
void append_wire(world::Wire& to, const world::Wire& more, BodyId both) noexcept {
    to.nodes.back() = both;
    to.nodes.insert(to.nodes.end(), more.nodes.begin() + 1, more.nodes.end());
    to.elements.insert(to.elements.end(), more.elements.begin(), more.elements.end());
}
void prepend_wire(world::Wire& to, const world::Wire& more, BodyId both) noexcept {
    to.nodes.front() = both;
    to.nodes.insert(to.nodes.begin(), more.nodes.begin(), more.nodes.end() - 1);
    to.elements.insert(to.elements.begin(), more.elements.begin(), more.elements.end());
}

/// Return a bend at the joined node, like the adjacent bend.
InteractionDef bend_at_splice(const model::Interactions& in, std::int32_t beside, BodyId before,
                              BodyId node, BodyId after, double length) {
    InteractionDef out;
    out.kind = InteractionKind::Bend;
    out.body = {before, node, after};
    out.set("EI", in.def[at(beside)].get("EI")).set("length", length);
    return out;
}

void reserve_for(world::Wire& to, const world::Wire& more) {
    base::reserve_more(to.nodes, more.nodes.size() + 1);
    base::reserve_more(to.elements, more.elements.size() + 1);
    base::reserve_more(to.lumps, more.lumps.size() + 1);
    base::reserve_more(to.bends, more.bends.size() + 1);
    base::reserve_more(to.shapes, more.shapes.size() + 1);
}

/// The joined node, and the one removed.
struct Spliced {
    BodyId both, removed_body;
};
void merge_wire(world::Wire& to, world::Wire& more, const Spliced& lumps, bool behind,
                InteractionId bend) noexcept {
    behind ? append_wire(to, more, lumps.both) : prepend_wire(to, more, lumps.both);
    std::erase(more.lumps, lumps.removed_body);
    to.lumps.insert(to.lumps.end(), more.lumps.begin(), more.lumps.end());
    to.bends.insert(to.bends.end(), more.bends.begin(), more.bends.end());
    to.shapes.insert(to.shapes.end(), more.shapes.begin(), more.shapes.end());
    to.owns = to.owns || more.owns;
    if (bend.valid() && to.owns) to.bends.push_back(bend);
}

}  // namespace

/// Reverse elements, bends and capsules of a chain.
void WorldImpl::reverse_chain(std::span<const std::int32_t> chain) noexcept {
    model::Interactions& in = ctx.model.interactions;
    for (std::size_t k = 0; k < chain.size(); ++k) {
        const std::int32_t id = chain[k];
        const std::int32_t ends[2] = {edit::end_of(ctx, id, 0), edit::end_of(ctx, id, 1)};
        if (const ShapeId s = segment_between(ends[0], ends[1]); s.valid()) {
            const ShapeDef& def = shape_defs[at(s.index)];
            const Vec3 point = def.position;
            add_capsule(s, def.body_b, def.body, point);
        }
        if (k > 0) {
            const std::int32_t* last = &in.body[kMaxInteractionBodies * at(chain[k - 1])];
            const std::int32_t node = last[0] == ends[0] || last[0] == ends[1] ? last[0] : last[1];
            const std::int32_t bend =
                edit::bend_at_body(ctx, node, ends[0] == node ? ends[1] : ends[0]);
            if (bend >= 0) edit::reverse_ends(ctx, bend);
        }
        edit::reverse_ends(ctx, id);
    }
}

Joint WorldImpl::splice(World& world, BodyId a, BodyId b) {
    model::Interactions& in = ctx.model.interactions;
    const world::FreeEnd one = free_end(a), other = free_end(b);
    const std::int32_t ea = one.element.index, eb = other.element.index;
    const std::string where = world::label("body", body_defs[at(b.index)].name);
    if (ea == eb) world::throw_def_error(where, "both ends are of one element");
    check_not_needed(b);
    const double separation = (world.pose(b).position - world.pose(a).position).norm();
    const BodyId other_end_a = in.def[at(ea)].body[1 - one.slot],
                 other_end_b = in.def[at(eb)].body[1 - other.slot];
    if (other_end_a == other_end_b)
        world::throw_def_error(where, "both elements hold one body; join by gear");
    const std::vector<std::int32_t> chain = one.slot == other.slot
                                                ? edit::chain_from(ctx, eb, other.slot)
                                                : std::vector<std::int32_t>{};
    world::Wire* wire_a = wire_with(one.element);
    world::Wire* wire_b = wire_with(other.element);
    if (wire_a != nullptr && wire_a == wire_b)
        world::throw_def_error(where, "both are ends of one wire");
    if (wire_a != nullptr && wire_b != nullptr) reserve_for(*wire_a, *wire_b);
    reserve_removal();
    wires.slots.reserve_more();
    const std::int32_t near[2] = {edit::bend_at_body(ctx, other_end_a.index, a.index),
                                  edit::bend_at_body(ctx, other_end_b.index, b.index)};
    const std::int32_t adjacent_bend = near[0] >= 0 ? near[0] : near[1];
    InteractionId bend;
    const context::Edited edited = ctx.state.ledger.edited;
    const context::Edited had = edit::splice_energy(ctx, a.index, b.index, ea, eb);
    if (adjacent_bend >= 0) {
        const double length = 0.5 * (in.rest_length[at(ea)] + in.rest_length[at(eb)]);
        const SilencedListener silenced(*this);
        bend = world.add_interaction(
            bend_at_splice(in, adjacent_bend, one.slot == 1 ? other_end_a : other_end_b, a,
                           one.slot == 1 ? other_end_b : other_end_a, length));
    }
    // No call below throws.
    edit::begin_edit(ctx);
    const Vec3 load = body_defs[at(b.index)].force;
    reverse_chain(chain);
    const ShapeId segment = one.slot == 1 ? segment_between(b.index, other_end_b.index)
                                          : segment_between(other_end_b.index, b.index);
    if (segment.valid()) move_segment(segment, one.slot == 1 ? 0 : 1, a);
    if (near[1] >= 0)
        in.rewire(near[1], edit::end_of(ctx, near[1], 0) == b.index ? 0 : 2, a, ctx.model.bodies);
    edit::merge_nodes(ctx, a.index, b.index, ea, eb);
    remove(b);
    body_defs[at(a.index)].force += load;
    for (int i = 0; i < 3; ++i) add_up_force(a, i);
    update_definition(a);
    edit::update_elements_of_node(ctx, a.index);
    if (bend.valid()) edit::set_bend(ctx, bend.index, ea, eb);
    ctx.state.ledger.edited = edited + edit::splice_energy(ctx, a.index, -1, ea, eb) - had;
    context::push_event(ctx, EventKind::join, ea, separation);
    if (wire_b != nullptr && !chain.empty()) {
        std::reverse(wire_b->nodes.begin(), wire_b->nodes.end());
        std::reverse(wire_b->elements.begin(), wire_b->elements.end());
    }
    if (wire_a == nullptr || wire_b == nullptr) {
        if (wire_b != nullptr) std::replace(wire_b->nodes.begin(), wire_b->nodes.end(), b, a);
        return {};
    }
    merge_wire(*wire_a, *wire_b, {a, b}, one.slot == 1, bend);
    forget_wire(id_of(*wire_b));
    return {};
}

}  // namespace hawser
