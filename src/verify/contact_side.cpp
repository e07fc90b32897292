// SPDX-License-Identifier: Apache-2.0
#include "verify/contact_side.h"

#include "verify/line_path.h"

#include <algorithm>

namespace hawser::verify {
namespace {

/// Least weight of a node in a contact at the other end of a segment, if that end is attached to a
/// body. See docs/collision.md, item "Wires". Its effect on the velocity is above the tolerance of
/// this check.
constexpr double kMinFractionOfNode = 2e-9;
/// Least weight of the body in a contact at the node. A smaller computed weight differs from 0 only
/// by rounding; the body then gets no moment of the force either.
constexpr double kMinFractionOfBody = 1e-11;

const Pose& pose_of(std::span<const Pose> pose, BodyId body) {
    return pose[static_cast<std::size_t>(body.index)];
}

/// True if the end of a segment is attached to a body at a point of its frame.
bool holds(const World& world, const ShapeDef& def, BodyId body) {
    const BodyKind kind = world.body_def(body).kind;
    return kind != BodyKind::lump && !(kind == BodyKind::fixed && def.position.isZero(0.0));
}

/// Return the element along a segment; invalid: there is none.
InteractionId element_of_segment(const World& world, const ShapeDef& def) {
    for (const InteractionId id : world.interactions()) {
        const InteractionDef& d = world.interaction_def(id);
        if (kind_info(d.kind).is(kWireElement) && d.body[0] == def.body && d.body[1] == def.body_b)
            return id;
    }
    return {};
}

}  // namespace

ContactSide contact_side(const World& world, ShapeId shape, const Vec3& on_axis, const Vec3& point,
                         std::span<const Pose> pose) {
    const ShapeDef& def = world.shape_def(shape);
    ContactSide side{.body = {def.body, def.body_b}};
    const auto is_lump = [&](int k) { return world.body_def(side.body[k]).kind == BodyKind::lump; };
    if (!def.body_b.valid()) {
        if (!is_lump(0)) side.arm[0] = point - pose_of(pose, def.body).position;
        return side;
    }
    side.count = 2;
    Vec3 end[2] = {pose_of(pose, def.body).position, pose_of(pose, def.body_b).position};
    int held = -1;
    for (int k = 0; k < 2; ++k)
        if (holds(world, def, side.body[k])) held = k;
    if (held >= 0) {
        const InteractionId element = element_of_segment(world, def);
        const Pose& by = pose_of(pose, side.body[held]);
        end[held] = element.valid() ? line_ends(Attached(world, element, pose)).at[held]
                                    : Vec3(by.position + by.orientation * def.position);
    }
    const Vec3 along = end[1] - end[0];
    double s = std::clamp((on_axis - end[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    // Beyond the body's point of attachment the node keeps its least weight.
    if (held == 0) s = std::max(s, kMinFractionOfNode);
    if (held == 1) s = std::min(s, 1.0 - kMinFractionOfNode);
    if (held == 0 && 1.0 - s < kMinFractionOfBody) s = 1.0;
    if (held == 1 && s < kMinFractionOfBody) s = 0.0;
    side.fraction[0] = 1.0 - s;
    side.fraction[1] = s;
    side.length = along.norm();
    // The body gets the rest of the moment, so that both together receive the force at its point.
    if (held >= 0 && side.fraction[held] > 0.0) {
        const int lump = 1 - held;
        const Vec3 rest = point - side.fraction[lump] * pose_of(pose, side.body[lump]).position;
        side.arm[held] = rest / side.fraction[held] - pose_of(pose, side.body[held]).position;
    }
    return side;
}

}  // namespace hawser::verify
