// SPDX-License-Identifier: Apache-2.0
/// Contacts of wires with a bollard, and the test whether wires would pull at it.
#include "wire/post_system.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>

namespace hawser::wire {
namespace {

constexpr double kMinAngle = -2e-3;  ///< Angle below which a wire would pull at its bollard [rad].
/// Relative tolerance of the radius: a wire that just touches turns by almost 0 and not backwards.
constexpr double kRadiusTolerance = 1e-9;

/// Nearest points of two lines: fraction along a–b, and distance along the axis from its
/// centre [m].
struct NearestPoints {
    double fraction, along;
    Vec3 separation;  ///< Vector from the axis to a–b, perpendicular to the axis.
};
NearestPoints nearest_to_axis(const Vec3& a, const Vec3& b, const Vec3& centre,
                              const Vec3& axis) noexcept {
    const Vec3 d = b - a;
    const Vec3 from = a - centre;
    const Vec3 d_across = d - d.dot(axis) * axis, from_across = from - from.dot(axis) * axis;
    const double fraction =
        std::clamp(-from_across.dot(d_across) / std::max(d_across.squaredNorm(), 1e-300), 0.0, 1.0);
    const Vec3 at = from + fraction * d;
    const double along = at.dot(axis);
    return {fraction, along, at - along * axis};
}

/// Return the velocity of an end of an element at a point of the world [m/s].
Vec3 speed_at(const World& world, const InteractionDef& d, std::size_t end, const Vec3& place) {
    const Twist twist = world.velocity(d.body[end]);
    if (world.body_def(d.body[end]).kind == BodyKind::lump) return twist.linear;
    return twist.linear + twist.angular.cross(place - world.pose(d.body[end]).position);
}

}  // namespace

PostSystem::Separation PostSystem::separation(const World& world,
                                              const std::array<Vec3, 2>& line) const {
    const Pose pose = world.pose(position_.body);
    const Vec3 axis = pose.orientation * position_.axis;
    const NearestPoints near = nearest_to_axis(
        line[0], line[1], pose.position + pose.orientation * position_.centre, axis);
    const double beyond = std::max(0.0, std::abs(near.along) - position_.half_length);
    return {std::hypot(near.separation.norm(), beyond) - position_.radius, near.fraction};
}

/// Find the wire element that belongs to a capsule.
/// @return false if no such element may engage.
bool PostSystem::find(const World& world, ShapeId segment, Touch& out) const {
    const ShapeDef& capsule = world.shape_def(segment);
    if (!capsule.body_b.valid()) return false;
    // A body that holds one end may also hold the wire elsewhere.
    const bool first = world.body_def(capsule.body).kind == BodyKind::lump;
    const BodyId lump = first ? capsule.body : capsule.body_b;
    for (const WireId wire : world.wires().ids()) {
        const auto nodes = world.wires().nodes(wire);
        const auto elements = world.wires().elements(wire);
        const auto at = std::find(nodes.begin(), nodes.end(), lump);
        if (at == nodes.end()) continue;
        for (const std::ptrdiff_t k : {at - nodes.begin(), at - nodes.begin() - 1}) {
            if (k < 0 || k >= std::ssize(elements)) continue;
            const InteractionId id = elements[static_cast<std::size_t>(k)];
            if (!world.alive(id) || !world.intact(id)) continue;
            const InteractionDef& d = world.interaction_def(id);
            const bool its = (d.body[0] == capsule.body && d.body[1] == capsule.body_b) ||
                             (d.body[1] == capsule.body && d.body[0] == capsule.body_b);
            if (!its || kind_info(d.kind).is(kWoundUp) || !(d.get("mass") > 0.0)) continue;
            out.element = id;
            out.wire = wire;
            complete_touch(world, capsule.radius, out);
            return true;
        }
    }
    return false;
}

void PostSystem::complete_touch(const World& world, double half, Touch& out) const {
    const InteractionDef& d = world.interaction_def(out.element);
    const Pose pose = world.pose(position_.body);
    const Vec3 axis = pose.orientation * position_.axis;
    const Vec3 centre = pose.position + pose.orientation * position_.centre;
    const Vec3 a = world.world_point(d.body[0], d.point[0]),
               b = world.world_point(d.body[1], d.point[1]);
    const NearestPoints near = nearest_to_axis(a, b, centre, axis);
    const Vec3 along = (b - a).normalized();
    const double separation = near.separation.norm();
    out.fraction = near.fraction;
    out.point = position_.centre + near.along * position_.axis;
    const double way = axis.dot(near.separation.cross(along)) >= 0.0 ? 1.0 : -1.0;
    out.across_end =
        std::abs(near.along) > position_.half_length && separation < 0.5 * position_.radius;
    const double touching = position_.radius + half;
    out.radius = way * std::max(touching, separation * (1.0 - kRadiusTolerance));
    const Twist twist = world.velocity(position_.body);
    const Vec3 surface = twist.linear + twist.angular.cross(centre + near.along * axis +
                                                            near.separation - pose.position);
    const Vec3 speed[2] = {speed_at(world, d, 0, a) - surface, speed_at(world, d, 1, b) - surface};
    out.along = ((1.0 - near.fraction) * speed[0] + near.fraction * speed[1]).dot(along);
    out.strain = 0.0;
    for (const std::size_t end : {0U, 1U}) {
        const double length = (end == 0 ? near.fraction : 1.0 - near.fraction) * (b - a).norm();
        const Vec3 moves = world.settings().step * (speed[end] - speed[end].dot(along) * along);
        out.strain += moves.squaredNorm() / (2.0 * std::max(length, 1e-3) * (b - a).norm());
    }
}

/// True if a wire must leave the bollard: it would have to pull at it, or it has passed its end.
/// @param past  In: it had passed the end before. Out: it has passed it now.
bool PostSystem::must_disengage(const World& world, const GuideSystem& guide, bool& past) const {
    if (guide.parted()) return false;
    const Pose pose = world.pose(position_.body);
    const InteractionDef& before = world.interaction_def(guide.ids().before);
    const InteractionDef& behind = world.interaction_def(guide.ids().behind);
    const Vec3 a = world.world_point(before.body[0], before.point[0]);
    const Vec3 b = world.world_point(behind.body[1], behind.point[1]);
    const NearestPoints near =
        nearest_to_axis(a, b, pose.position + pose.orientation * position_.centre,
                        pose.orientation * position_.axis);
    past = past || std::abs(near.along) > position_.half_length + position_.radius;
    if (position_.carrier != position_.body) {
        const Vec3 lies = world.world_point(position_.carrier, guide.def().point);
        const Vec3 from = lies - world.world_point(position_.body, position_.centre);
        past =
            past || std::abs(from.dot(pose.orientation * position_.axis)) > position_.half_length;
    }
    return past || (guide.angle() < kMinAngle && guide.pressing_force(world, -kMinAngle) < 0.0);
}

}  // namespace hawser::wire
