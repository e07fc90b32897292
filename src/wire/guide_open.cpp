// SPDX-License-Identifier: Apache-2.0
/// Guides without an upper roller: the wire leaves if it would pull at the wheel, and returns.
///
/// *Leaving.* Seen along the axis, the wire turns by α on the wheel; T is its tension, w the weight
/// of the half elements there towards the wheel. The wheel presses with T α + w for small α. If α <
/// −kLetGo and T (α + kLetGo) + w < 0 it would have to pull, and the wire leaves, as at a bollard.
///
/// *Returning.* On each element of the wire find the point nearest to the axis, at the distance d
/// on the side on which the wire runs on the wheel. The wire has returned if d < R:
/// ```
///         u ►         d: from the centre, along outward = sgn(R) u × axis
///     ────┬────
///      .-'┆d'-.
///     (   c    )
/// ```
/// It engages if it is within kDeep of an element's length of the wheel, so that a wire that passes
/// under the wheel stays there. It must also be within kBeside R of the guide's point along the
/// axis. A node at the wheel is removed first.
#include "wire/guide_on_off.h"
#include "wire/lift.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace hawser::wire {
namespace {

constexpr double kLetGo = 2e-3;    ///< Angle within rounding of straight [rad].
constexpr double kDeep = 0.25;     ///< Fraction of the element.
constexpr double kBeside = 2.0;    ///< Multiple of the radius.
constexpr double kAtNode = 0.06;   ///< Fraction of an element at its end: its node is at the wheel.
constexpr double kMostBend = 3.2;  ///< Bend limit: a node at the wheel is removed at any bend.
constexpr std::int32_t kRefusedWait = 15;  ///< Steps.

/// Point of an element nearest to a wheel.
struct Passing {
    InteractionId element{};
    double share = 0.0;   ///< Fraction along the element.
    double gap = 1e300;   ///< Distance outside the wheel's surface [m].
    double length = 0.0;  ///< Length of the element [m].
    double beside = 0.0;  ///< Distance from the guide's point along the axis [m].
};

/// Find the point of an element nearest to the wheel.
/// @param centre  World frame [m].
/// @param axis  World frame, unit.
Passing passing(const World& world, InteractionId id, const GuideDef& def, const Vec3& centre,
                const Vec3& axis) {
    const std::array<Vec3, 2> ends = world.ends(id);
    const Vec3 d = ends[1] - ends[0], from = ends[0] - centre;
    const Vec3 across = d - d.dot(axis) * axis, apart = from - from.dot(axis) * axis;
    const double share =
        std::clamp(-apart.dot(across) / std::max(across.squaredNorm(), 1e-300), 0.0, 1.0);
    const Vec3 at = from + share * d;
    const Vec3 outward = (def.radius > 0.0 ? 1.0 : -1.0) * across.normalized().cross(axis);
    return {id, share, at.dot(outward) - std::abs(def.radius), d.norm(), at.dot(axis)};
}

/// Find the element of a wire that passes nearest to the wheel, seen along its axis; invalid: none.
Passing nearest_passing(const World& world, const GuideDef& def, const Vec3& centre,
                        const Vec3& axis) {
    Passing best;
    for (const InteractionId id : world.elements(def.wire)) {
        if (!world.alive(id) || !world.intact(id)) continue;
        if (kind_info(world.interaction_def(id).kind).is(kWoundUp)) continue;
        const Passing one = passing(world, id, def, centre, axis);
        // At the end of an element another one is nearer, or none passes.
        if (std::abs(one.beside) > kBeside * std::abs(def.radius)) continue;
        if (!best.element.valid() || std::abs(one.gap) < std::abs(best.gap)) best = one;
    }
    return best;
}

/// Return the speed of the wire past the wheel, along the element [m/s].
double speed_along(const World& world, const GuideDef& def, const Passing& at) {
    const InteractionDef& d = world.interaction_def(at.element);
    const std::array<Vec3, 2> ends = world.ends(at.element);
    const Vec3 along = (ends[1] - ends[0]).normalized();
    const auto speed = [&](BodyId body, const Vec3& place) -> Vec3 {
        const Twist twist = world.velocity(body);
        return twist.linear + twist.angular.cross(place - world.pose(body).position);
    };
    const auto end = [&](std::size_t k) -> Vec3 {
        return world.body_def(d.body[k]).kind == BodyKind::lump ? world.velocity(d.body[k]).linear
                                                                : speed(d.body[k], ends[k]);
    };
    const Vec3 wheel = speed(def.body, world.world_point(def.body, def.point));
    return ((1.0 - at.share) * end(0) + at.share * end(1) - wheel).dot(along);
}

}  // namespace

void GuideSystem::lift(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (parted_ != 0 || !whole(world)) return;
    if (!(angle_ < -kLetGo && pressing(world, kLetGo) < 0.0)) return;
    const double tension = std::max(tension_[0], tension_[1]);
    const InteractionDef element = lifted_element(world, *this, false);
    parted_ = kLifted;  // the guide holds no wire any more
    InteractionId made{};
    if (!lift_off_guide(nodes, *this, element, &made)) {
        parted_ = 0;
        return;
    }
    nodes.tell(EventKind::lift_off, made, tension);
    tension_ = {};
    angle_ = speed_ = slide_ = hanging_ = bound_ = 0.0;
    material_ = {};
    stopped_ = -1;
    wait_ = 0;
}

void GuideSystem::come_back(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (wait_ > 0) {
        --wait_;
        return;
    }
    if (!world.alive(def_.wire)) return;
    const Vec3 centre = world.world_point(def_.body, def_.point);
    const Vec3 axis = world.pose(def_.body).orientation * def_.axis.normalized();
    Passing at = nearest_passing(world, def_, centre, axis);
    const auto back = [&] {
        return at.element.valid() && at.gap <= 0.0 &&
               at.gap > -std::abs(def_.radius) - kDeep * at.length;
    };
    if (!back()) return;
    const bool first = at.share < kAtNode;
    if (first || at.share > 1.0 - kAtNode) {
        const BodyId node = world.interaction_def(at.element).body[first ? 0 : 1];
        if (world.body_def(node).kind != BodyKind::lump || !nodes.remove_node(node, kMostBend)) {
            wait_ = kRefusedWait;
            return;
        }
        at = nearest_passing(world, def_, centre, axis);
        if (!back()) return;
    }
    try {
        if (!lay_back(nodes, at.element, speed_along(world, def_, at))) wait_ = kRefusedWait;
    } catch (const std::bad_alloc&) {
        nodes.out_of_memory();
    } catch (const std::exception&) {
        wait_ = kRefusedWait;  // out of memory: the step fails as a whole
    }
}

bool GuideSystem::lay_back(NodeEdits& nodes, InteractionId element, double along) {
    GuideDef def = def_;
    def.element = element;
    def.slide = {};
    def.mass_per_length = kDefault;
    const double tension = nodes.world.force(element)[0];
    const auto made = lay_on_guide(nodes, std::move(def), along);
    if (made == nullptr) return false;
    def_ = made->def_;
    ids_ = made->ids_;
    stop_ = made->stop_;
    material_ = made->material_;
    angle_ = ids_.angle;
    speed_ = along;
    slide_ = nodes.world.pose(ids_.slide).position.x();
    length_ = {def_.element_length, def_.element_length};
    bound_ = 0.0;
    parted_ = 0;
    nodes.tell(EventKind::lay_on, ids_.before, std::max(0.0, -tension));
    return true;
}

}  // namespace hawser::wire
