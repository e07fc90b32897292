// SPDX-License-Identifier: Apache-2.0
/// Guides without an upper roller: the wire leaves if it would pull at the wheel, and returns.
///
/// *Leaving.* Seen along the axis, the wire turns by α on the wheel; T is its tension, w the weight
/// of the half elements there towards the wheel. The wheel presses with T α + w for small α. If α <
/// −kLetGo and T (α + kLetGo) + w < 0 it would have to pull, and the wire leaves, as at a bollard.
///
/// The two parts become one element again, with a node where the wheel was. They keep their rest
/// length and their momentum (world/wheel_momentum.h).
///
/// *Coming back.* Take the point of each element that is nearest to the axis. Let d be its distance
/// on the side on which the wire lies on the wheel:
/// ```
///         u ►         d: from the centre, along outward = sgn(R) u × axis
///     ────┬────
///      .-'┆d'-.       g = d − R
///     (   c    )
/// ```
/// Let g be the gap at the present poses, ġ its rate. The wire is laid on at the first pose with
/// g ≤ 0, and −g ≤ h|ġ|, beside the guide's point by no more than kBeside R. The parts keep the
/// rest length of the element. With elements of length l the path over the wheel is longer than the
/// wire by about g²/l, which is stretch. A wire that passes under the wheel stays there. A node at
/// the wheel goes first; the parts get the rest length that its removal took away.
///
/// *Landing.* A string that falls across on a pin is at rest out to c t after a time t, c = √(T/ρ).
/// Steps with c h above an element do not resolve that. Nodes within c h are therefore damped
/// across the wire, with a time of h/kStops, for kLanding steps. The body of the guide gets their
/// momentum. Steps that resolve the landing have no node within c h.
#include "wire/guide_on_off.h"
#include "wire/lift.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace hawser::wire {
namespace {

constexpr double kLetGo = 2e-3;       ///< Angle that does not count [rad].
constexpr double kDeep = 0.1;         ///< Share of the element: deeper wires pass under the wheel.
constexpr double kBeside = 2.0;       ///< Share of the radius.
constexpr double kAtNode = 0.06;      ///< Share of an element: its node is at the wheel.
constexpr double kMaxBend = 3.2;      ///< A node at the wheel goes however the wire is bent.
constexpr std::int32_t kLanding = 3;  ///< Steps.
constexpr double kStops = 3.0;        ///< In a step of landing exp(−kStops) is left of a speed.

/// Where a piece of a wire passes a wheel.
struct Passing {
    InteractionId element{};
    double fraction = 0.0;      ///< Position on the element, 0 to 1.
    double gap = 1e300;         ///< Beyond the wheel's radius, outwards [m].
    double rate = 0.0;          ///< Rate of the gap [m/s].
    double length = 0.0;        ///< Length of the element [m].
    double axial_offset = 0.0;  ///< From the guide's point, along the axis [m].
};

/// The wheel of a guide in the world.
struct Wheel {
    Vec3 centre, axis, speed;
    double radius = 0.0;  ///< With the sign of the guide's.
};

/// Ends of a piece of a wire, and their speeds.
struct Piece {
    std::array<Vec3, 2> at, speed;
};

Vec3 speed_at_point(const World& world, BodyId body, const Vec3& place) {
    const Twist twist = world.velocity(body);
    if (world.body_def(body).kind == BodyKind::lump) return twist.linear;
    return twist.linear + twist.angular.cross(place - world.pose(body).position);
}

Wheel guide_wheel(const World& world, const GuideDef& def) {
    const Vec3 centre = world.world_point(def.body, def.point);
    return {centre, world.pose(def.body).orientation * def.axis.normalized(),
            speed_at_point(world, def.body, centre), def.radius};
}

Piece wire_piece_at(const World& world, InteractionId id) {
    const InteractionDef& d = world.interaction_def(id);
    const std::array<Vec3, 2> at = world.wires().ends(id);
    return {at, {speed_at_point(world, d.body[0], at[0]), speed_at_point(world, d.body[1], at[1])}};
}

/// Return the point of a piece nearest to the axis, seen along the axis. Its side of the wheel is
/// the side of the piece; at an end, that of the nearer neighbour.
Passing passing(const Piece& piece, const Wheel& wheel) {
    const Vec3 d = piece.at[1] - piece.at[0], from = piece.at[0] - wheel.centre;
    const auto flat = [&wheel](const Vec3& x) -> Vec3 {
        return x - x.dot(wheel.axis) * wheel.axis;
    };
    const Vec3 across = flat(d);
    const double fraction =
        std::clamp(-flat(from).dot(across) / std::max(across.squaredNorm(), 1e-300), 0.0, 1.0);
    const Vec3 at = from + fraction * d, to = flat(at);
    const Vec3 outward = (wheel.radius > 0.0 ? 1.0 : -1.0) * across.normalized().cross(wheel.axis);
    const double side = to.dot(outward) < 0.0 ? -1.0 : 1.0;
    const Vec3 speed = (1.0 - fraction) * piece.speed[0] + fraction * piece.speed[1] - wheel.speed;
    const double far = to.norm();
    const Vec3 away = far > 0.0 ? Vec3(side / far * to) : outward;
    return {.element = {},
            .fraction = fraction,
            .gap = side * far - std::abs(wheel.radius),
            .rate = speed.dot(away),
            .length = d.norm(),
            .axial_offset = at.dot(wheel.axis)};
}

/// Return the element of a wire that passes the wheel nearest, seen along its axis; invalid if
/// there is none.
Passing nearest_passing(const World& world, const GuideDef& def, const Wheel& wheel) {
    Passing best;
    for (const InteractionId id : world.wires().elements(def.wire)) {
        if (!world.alive(id) || !world.intact(id)) continue;
        if (kind_info(world.interaction_def(id).kind).is(kWoundUp)) continue;
        Passing one = passing(wire_piece_at(world, id), wheel);
        one.element = id;
        if (std::abs(one.axial_offset) > kBeside * std::abs(def.radius)) continue;
        const double radius = std::abs(wheel.radius);
        if (!best.element.valid() || std::abs(one.gap + radius) < std::abs(best.gap + radius))
            best = one;
    }
    return best;
}

/// True if the wire has met the wheel in the last step, or lies inside its rim and moves deeper.
bool wire_met_wheel(const Passing& at, double step) {
    if (!at.element.valid() || at.gap > 0.0 || !(at.rate < 0.0)) return false;
    return at.gap - step * at.rate > 0.0 || at.gap > -kDeep * at.length;
}

/// Return the straight piece of wire that results from removing the node between two elements.
Piece without_node(const World& world, InteractionId before, InteractionId behind) {
    const Piece first = wire_piece_at(world, before), second = wire_piece_at(world, behind);
    return {{first.at[0], second.at[1]}, {first.speed[0], second.speed[1]}};
}

/// Return the speed of the wire past the wheel, along the element [m/s].
double speed_along(const World& world, const Passing& at, const Wheel& wheel) {
    const Piece piece = wire_piece_at(world, at.element);
    const Vec3 along = (piece.at[1] - piece.at[0]).normalized();
    return ((1.0 - at.fraction) * piece.speed[0] + at.fraction * piece.speed[1] - wheel.speed)
        .dot(along);
}

}  // namespace

void GuideSystem::update_lift(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (parted_ != 0 || wait_ > 0 || !parts_intact(world)) return;
    if (!(angle_ < -kLetGo && pressing(world, kLetGo) < 0.0)) return;
    const double tension = std::max(tension_[0], tension_[1]);
    const InteractionDef element = lifted_element(world, *this, true);
    parted_ = kLifted;  // it holds nothing of the wire
    InteractionId made{};
    if (!disengage_guide(nodes, *this, element, &made)) {
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

void GuideSystem::return_to_wheel(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (!world.alive(def_.wire)) return;
    const Wheel wheel = guide_wheel(world, def_);
    Passing at = nearest_passing(world, def_, wheel);
    if (!wire_met_wheel(at, world.settings().step)) return;
    const double length = world.wires().length(def_.wire);
    const bool first = at.fraction < kAtNode;
    if (first || at.fraction > 1.0 - kAtNode) {
        const auto elements = world.wires().elements(def_.wire);
        const auto here = std::find(elements.begin(), elements.end(), at.element);
        const bool ends = first ? here == elements.begin() : here + 1 == elements.end();
        const BodyId node = world.interaction_def(at.element).body[first ? 0 : 1];
        // A wire that is bent there would be drawn into the wheel.
        if (ends || world.body_def(node).kind != BodyKind::lump) return;
        const Passing straight = passing(first ? without_node(world, *(here - 1), at.element)
                                               : without_node(world, at.element, *(here + 1)),
                                         wheel);
        if (straight.gap > -kDeep * at.length && nodes.remove_node(node, kMaxBend)) {
            at = nearest_passing(world, def_, wheel);
            if (!at.element.valid()) return;
        }
    }
    // Rest length that removing the node took from the wire [m].
    const double kept = length - world.wires().length(def_.wire);
    try {
        (void)reengage(nodes, at.element, speed_along(world, at, wheel), kept);
    } catch (const std::bad_alloc&) {
        nodes.out_of_memory();
    } catch (const std::exception&) {
        return;  // refused, or no memory: the step fails, and this with it
    }
}

bool GuideSystem::reengage(NodeEdits& nodes, InteractionId element, double along, double kept) {
    GuideDef def = def_;
    def.element = element;
    def.slide = {};
    // The parts have the length of their mass (add_guide_parts()).
    const InteractionDef& whole = nodes.world.interaction_def(element);
    const double mass = whole.get("mass"), length = whole.get("length") + kept;
    def.mass_per_length = mass > 0.0 && length > 0.0 ? mass / length : kDefault;
    const double tension = nodes.world.force(element)[0];
    const auto made = engage_guide(nodes, std::move(def), along);
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
    tension_.fill(std::max(0.0, -tension));
    wait_ = kLanding;
    nodes.tell(EventKind::lay_on, ids_.before, std::max(0.0, -tension));
    return true;
}

void GuideSystem::damp_landing(const World& world, Loads& loads) noexcept {
    if (def_.closed || wait_ <= 0 || parted_ != 0 || !(def_.mass_per_length > 0.0)) return;
    --wait_;
    const Wheel wheel = guide_wheel(world, def_);
    const double h = world.settings().step, tension = std::max(tension_[0], tension_[1]);
    const double reach = h * std::sqrt(tension / def_.mass_per_length);
    Vec3 along = Vec3::Zero();
    for (const InteractionId id : {ids_.before, ids_.behind}) {
        const std::array<Vec3, 2> ends = world.wires().ends(id);
        along += (ends[1] - ends[0]).normalized();
    }
    const Vec3 n = along.cross(wheel.axis).normalized();
    const auto elements = world.wires().elements(def_.wire);
    Vec3 lost = Vec3::Zero();  // by the nodes in this step [N]
    for (const std::size_t side : {0U, 1U}) {
        auto at = std::find(elements.begin(), elements.end(), element(side));
        double way = 0.0;
        while (at != elements.end() && world.alive(*at) && world.intact(*at)) {
            const std::array<Vec3, 2> ends = world.wires().ends(*at);
            const BodyId lump = world.interaction_def(*at).body[side];
            way += (ends[1] - ends[0]).norm();
            const BodyDef& body = world.body_def(lump);
            if (way > reach || body.kind != BodyKind::lump) break;
            const double mass = body.mass + (*at == element(side) ? half_mass(side) : 0.0);
            const Mat3 damping = kStops * mass / h * n * n.transpose();
            loads.add_damping(lump, damping);
            loads.add_force(lump, damping * wheel.speed);
            lost += (1.0 - std::exp(-kStops)) * mass / h *
                    n.dot(world.velocity(lump).linear - wheel.speed) * n;
            if (side == 0 && at == elements.begin()) break;
            at += side == 0 ? -1 : 1;
        }
    }
    if (world.body_def(def_.body).kind != BodyKind::rigid) return;
    const Vec3 arm = wheel.centre - world.pose(def_.body).position;
    loads.add_force(def_.body, lost, arm.cross(lost));
}

}  // namespace hawser::wire
