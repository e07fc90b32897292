// SPDX-License-Identifier: Apache-2.0
/// Guides without an upper roller: the wire leaves where it would pull, and comes back.
///
/// *Leaving.* Seen along the axis, the wire turns by α on the wheel; T is its tension, w the weight
/// of the half elements there towards the wheel. The wheel presses with T α + w for small α. It
/// would have to pull, and the wire leaves, where α < −kLetGo and T (α + kLetGo) + w < 0, as at a
/// post.
///
/// *Coming back.* Of each element of the wire take the point nearest to the axis, at the distance d
/// on the side on which the wire lies on the wheel. The wire is back where d < R:
/// ```
///         u ►         d: from the centre, along outward = sgn(R) u × axis
///     ────┬────
///      .-'┆d'-.
///     (   c    )
/// ```
/// It is laid on where it has come to the wheel within kDeep of an element's length, so that a wire
/// that passes under the wheel stays there, and beside the guide's point by no more than kBeside R.
/// A node at the wheel goes first.
#include "wire/guide_on_off.h"
#include "wire/lift.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace hawser::wire {
namespace {

constexpr double kLetGo = 2e-3;            ///< Angle that does not count [rad].
constexpr double kDeep = 0.25;             ///< Of the element.
constexpr double kBeside = 2.0;            ///< Of the radius.
constexpr double kAtNode = 0.06;           ///< Of an element: its node is at the wheel.
constexpr double kMostBend = 3.2;          ///< A node at the wheel goes however the wire is bent.
constexpr std::int32_t kRefusedWait = 15;  ///< Steps.

/// Where an element passes a wheel.
struct Passing {
    InteractionId element{};
    double share = 0.0;   ///< Of the element.
    double gap = 1e300;   ///< Beyond the wheel's radius, outwards [m].
    double length = 0.0;  ///< Of the element [m].
    double beside = 0.0;  ///< From the guide's point, along the axis [m].
};

/// @param centre, axis  In the world.
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

/// The element of a wire that passes the wheel nearest, seen along its axis; none: invalid.
Passing nearest_passing(const World& world, const GuideDef& def, const Vec3& centre,
                        const Vec3& axis) {
    Passing best;
    for (const InteractionId id : world.elements(def.wire)) {
        if (!world.alive(id) || !world.intact(id)) continue;
        if (kind_info(world.interaction_def(id).kind).is(kWoundUp)) continue;
        const Passing one = passing(world, id, def, centre, axis);
        // At an end of it another element is nearer, or none passes.
        if (std::abs(one.beside) > kBeside * std::abs(def.radius)) continue;
        if (!best.element.valid() || std::abs(one.gap) < std::abs(best.gap)) best = one;
    }
    return best;
}

/// Of the wire past the wheel, along the element [m/s].
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
    parted_ = kLifted;  // it holds nothing of the wire
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
        wait_ = kRefusedWait;  // no memory: the step fails, and this with it
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
