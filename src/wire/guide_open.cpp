// SPDX-License-Identifier: Apache-2.0
/// Guides without an upper roller: the wire leaves if it would pull at the wheel, and returns.
///
/// *Leaving.* The wire turns about the axis by α on the wheel. T is its tension, w the component of
/// the weight of the adjacent half elements towards the wheel. The wire presses on the wheel with
/// T α + w for small α. If α < −kLetGo and T (α + kLetGo) + w < 0, the wheel would have to pull,
/// and the wire leaves, as at a bollard.
///
/// The two parts become one element again, with a node at the former position of the wheel. Rest
/// length and momentum of the parts are conserved (world/wheel_momentum.h).
///
/// *Return.* For the point of each element that is nearest to the axis, d is the distance from the
/// axis towards the side of the wheel on which the wire lies:
/// ```
///         u ►         d: from the centre, along outward = sgn(R) u × axis
///     ────┬────
///      .-'┆d'-.       g = d − R
///     (   c    )
/// ```
/// Let g be the gap at the present poses, ġ its rate. The wire engages at the first pose with g ≤ 0
/// and −g ≤ h|ġ|, if its axial distance from the guide's point is at most kMaxAxialRatio R. The
/// parts get the rest length of the element. With elements of length l the path over the wheel is
/// longer than the wire by about g²/l, which stretches the wire. A wire that has passed under the
/// wheel does not engage. A node at the wheel is removed first; the parts get the rest length that
/// its removal subtracts.
///
/// *Landing.* If a string falls on a pin, the piece within c t of the pin is at rest after the time
/// t, c = √(T/ρ). Steps with c h longer than an element do not resolve this. The transverse motion
/// of nodes within c h is therefore damped with the time constant h/kLandingDecay for kLandingSteps
/// steps. The body of the guide receives their momentum. If the steps resolve the landing, no node
/// lies within c h.
#include "wire/guide_on_off.h"
#include "wire/lift.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace hawser::wire {
namespace {

constexpr double kLetGo = 2e-3;            ///< Amount of the angle at release [rad].
constexpr double kMaxDepthRatio = 0.1;     ///< Maximum depth over element length [1].
constexpr double kMaxAxialRatio = 2.0;     ///< Maximum axial offset over the radius [1].
constexpr double kAtNode = 0.06;           ///< Fraction of an element near its node [1].
constexpr double kMaxBend = 3.2;           ///< Above π: no bend prevents removal [rad].
constexpr std::int32_t kLandingSteps = 3;  ///< Steps of landing with damped nodes.
constexpr double kLandingDecay =
    3.0;  ///< A step of landing multiplies speeds by exp(−kLandingDecay).

/// Position at which a piece of a wire passes a wheel.
struct NearestPoint {
    InteractionId element{};
    double fraction = 0.0;  ///< Position on the element, 0 to 1.
    double gap = 1e300;     ///< Distance from the axis minus the radius of the wheel, outwards [m].
    double rate = 0.0;      ///< Rate of the gap [m/s].
    double length = 0.0;    ///< Length of the element [m].
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

/// Find the point of a piece of wire nearest to the axis of the wheel, seen along this axis, and
/// the side of the wheel on which the piece runs. If the nearest point is an end of the piece, the
/// side follows from the neighbouring piece that is nearer.
NearestPoint nearest_point_of_piece(const Piece& piece, const Wheel& wheel) {
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

/// Find the element of a wire nearest to the wheel, seen along its axis. The result is invalid if
/// there is none.
NearestPoint nearest_wire_piece(const World& world, const GuideDef& def, const Wheel& wheel) {
    NearestPoint best;
    for (const InteractionId id : world.wires().elements(def.wire)) {
        if (!world.alive(id) || !world.intact(id)) continue;
        if (kind_info(world.interaction_def(id).kind).is(kWoundUp)) continue;
        NearestPoint one = nearest_point_of_piece(wire_piece_at(world, id), wheel);
        one.element = id;
        if (std::abs(one.axial_offset) > kMaxAxialRatio * std::abs(def.radius)) continue;
        const double radius = std::abs(wheel.radius);
        if (!best.element.valid() || std::abs(one.gap + radius) < std::abs(best.gap + radius))
            best = one;
    }
    return best;
}

/// True if the wire has touched the wheel in the last step, or if it lies inside the rim and moves
/// further inwards.
bool wire_met_wheel(const NearestPoint& at, double step) {
    if (!at.element.valid() || at.gap > 0.0 || !(at.rate < 0.0)) return false;
    return at.gap - step * at.rate > 0.0 || at.gap > -kMaxDepthRatio * at.length;
}

/// Return the straight piece that would replace two elements if the node between them were removed.
Piece without_node(const World& world, InteractionId before, InteractionId behind) {
    const Piece first = wire_piece_at(world, before), second = wire_piece_at(world, behind);
    return {{first.at[0], second.at[1]}, {first.speed[0], second.speed[1]}};
}

/// Return the speed of the wire past the wheel, along the element [m/s].
double speed_along(const World& world, const NearestPoint& at, const Wheel& wheel) {
    const Piece piece = wire_piece_at(world, at.element);
    const Vec3 along = (piece.at[1] - piece.at[0]).normalized();
    return ((1.0 - at.fraction) * piece.speed[0] + at.fraction * piece.speed[1] - wheel.speed)
        .dot(along);
}

}  // namespace

void GuideSystem::update_lift(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (parted_ != 0 || landing_steps_left_ > 0 || !parts_intact(world)) return;
    if (!(angle_ < -kLetGo && pressing_force(world, kLetGo) < 0.0)) return;
    const double tension = std::max(tension_[0], tension_[1]);
    const InteractionDef element = lifted_element(world, *this, true);
    parted_ = kLiftedState;  // it holds nothing of the wire
    InteractionId made{};
    if (!disengage_guide(nodes, *this, element, &made)) {
        parted_ = 0;
        return;
    }
    nodes.tell(EventKind::lift_off, made, tension);
    tension_ = {};
    angle_ = speed_ = slide_ = half_element_weight_ = bound_ = 0.0;
    material_ = {};
    used_up_side_ = -1;
    landing_steps_left_ = 0;
}

void GuideSystem::return_to_wheel(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (!world.alive(def_.wire)) return;
    const Wheel wheel = guide_wheel(world, def_);
    NearestPoint at = nearest_wire_piece(world, def_, wheel);
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
        const NearestPoint straight =
            nearest_point_of_piece(first ? without_node(world, *(here - 1), at.element)
                                         : without_node(world, at.element, *(here + 1)),
                                   wheel);
        if (straight.gap > -kMaxDepthRatio * at.length && nodes.remove_node(node, kMaxBend)) {
            at = nearest_wire_piece(world, def_, wheel);
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
    landing_steps_left_ = kLandingSteps;
    nodes.tell(EventKind::lay_on, ids_.before, std::max(0.0, -tension));
    return true;
}

void GuideSystem::damp_landing(const World& world, Loads& loads) noexcept {
    if (def_.closed || landing_steps_left_ <= 0 || parted_ != 0 || !(def_.mass_per_length > 0.0))
        return;
    --landing_steps_left_;
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
            const Mat3 damping = kLandingDecay * mass / h * n * n.transpose();
            loads.add_damping(lump, damping);
            loads.add_force(lump, damping * wheel.speed);
            lost += (1.0 - std::exp(-kLandingDecay)) * mass / h *
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
