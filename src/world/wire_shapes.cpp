// SPDX-License-Identifier: Apache-2.0
/// Capsules of wires when elements are added, removed or replaced.
#include "edit/edits.h"
#include "edit/node_pieces.h"
#include "world/impl.h"
#include "world/wire_capsule.h"

#include <optional>

namespace hawser {
namespace world {

std::optional<ShapeDef> element_capsule(const World& world, const WireTrim& trim,
                                        const std::array<BodyId, 2>& body,
                                        const std::array<Vec3, 2>& point) {
    std::optional<ShapeDef> out;
    if (!trim.segment) return out;
    const auto is_free_node = [&](std::size_t end) {
        return world.body_def(body[end]).kind == BodyKind::lump;
    };
    const bool lumps = is_free_node(0) && is_free_node(1), one = is_free_node(0) || is_free_node(1);
    if (!lumps && !(one && trim.to_ends)) return out;
    out = trim.segment;
    out->body = body[0];
    out->body_b = body[1];
    if (!lumps) out->position = point[is_free_node(0) ? 1 : 0];
    return out;
}

}  // namespace world

/// Move a segment to other bodies, one of which may hold it at a point of its frame.
void WorldImpl::add_capsule(ShapeId segment, BodyId first, BodyId second,
                            const Vec3& point) noexcept {
    edit::forget_contacts(ctx, segment.index);
    ShapeDef& def = shape_defs[at(segment.index)];
    def.body = first;
    def.body_b = second;
    def.position = point;
    ctx.model.collider.attach_segment(segment.index, first.index, second.index, point,
                                      ctx.model.bodies);
}

/// Move the segment of an element with it: to a node, or to a body that holds it at its previous
/// point.
void WorldImpl::move_segment(ShapeId segment, std::size_t side, BodyId to) noexcept {
    const ShapeDef& def = shape_defs[at(segment.index)];
    const BodyId first = side == 0 ? to : def.body, second = side == 0 ? def.body_b : to;
    const bool lumps =
        edit::is_free_node(ctx, first.index) && edit::is_free_node(ctx, second.index);
    add_capsule(segment, first, second, lumps ? Vec3(Vec3::Zero()) : def.position);
}

/// Join two segments that meet at a removed node. Between two bodies there is none: both are
/// removed with the node.
void WorldImpl::join_segments(ShapeId near, ShapeId far) noexcept {
    const ShapeDef &before = shape_defs[at(near.index)], &behind = shape_defs[at(far.index)];
    const bool ends_at_node = edit::is_free_node(ctx, behind.body_b.index);
    if (!ends_at_node && !edit::is_free_node(ctx, before.body.index)) return;
    const Vec3 point = ends_at_node ? before.position : behind.position;
    add_capsule(near, before.body, behind.body_b, point);
}

/// Return the capsule between two ends of an element, in their order; invalid: none.
ShapeId WorldImpl::segment_between(std::int32_t a, std::int32_t b) const noexcept {
    for (const ShapeId id : shape_ids) {
        const std::int32_t* body = ctx.model.collider.shapes()[at(id.index)].body;
        if (body[0] == a && body[1] == b) return id;
    }
    return {};
}

/// Return the capsule to add with a node on an element; none if its wire has no contacts there.
std::optional<ShapeDef> WorldImpl::next_segment(const edit::NodeSurroundings& place, BodyId node,
                                                bool first, const world::Wire* wire) const {
    const auto end = [&](std::size_t slot) {
        return ctx.model.bodies.id(edit::end_of(ctx, place.first, slot));
    };
    const ShapeId own = segment_between(end(0).index, end(1).index);
    std::optional<ShapeDef> out;
    if (own.valid()) {
        out = shape_defs[at(own.index)];
        out->name.clear();
        out->body = node;
        if (edit::is_free_node(ctx, out->body_b.index)) out->position.setZero();
    } else if (wire != nullptr && wire->trim.segment &&
               edit::is_free_node(ctx, end(first ? 0 : 1).index)) {
        out = wire->trim.segment;
        out->body = first ? end(0) : node;
        out->body_b = first ? node : end(1);
    }
    return out;
}

}  // namespace hawser
