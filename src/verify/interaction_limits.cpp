// SPDX-License-Identifier: Apache-2.0
/// Compute geometric stiffness and damping, which are no row forces, and bounds of row forces.
#include "verify/interaction_forces.h"

#include "base/dense.h"
#include "verify/line_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::verify {

namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

bool is_line(InteractionKind kind) {
    return kind == InteractionKind::Distance || kind == InteractionKind::Stretch ||
           kind == InteractionKind::WinchStretch || kind == InteractionKind::EndSpan;
}

bool is_joint(InteractionKind kind) {
    return kind == InteractionKind::Ball || kind == InteractionKind::Hinge ||
           kind == InteractionKind::Universal || kind == InteractionKind::Lock;
}

// Return the stiffness of the torque of a constant force on a rotating arm, without its negative
// eigenvalues.
Mat3 arm_stiffness(const Vec3& force, const Vec3& arm) {
    const Mat3 outer = force * arm.transpose();
    const Mat3 k = force.dot(arm) * Mat3::Identity() - 0.5 * (outer + outer.transpose());
    const auto eigen = base::symmetric_eigen(k);
    return eigen.vectors * eigen.values.cwiseMax(0.0).asDiagonal() * eigen.vectors.transpose();
}

// Return |r|/I, with the mean moment of inertia I about the axes across the arm r.
double angular_mobility(const BodyDef& body, const Vec3& arm) {
    if (arm.norm() == 0.0) return 0.0;
    const Vec3 u = arm.normalized();
    return 2.0 * arm.norm() / (body.inertia.trace() - u.dot(body.inertia * u));
}

// Return the transverse mobility of the lighter end of a line [1/kg].
double transverse_mobility(const Attached& on, const World& world) {
    double most = 0.0;
    const bool rigid = on.kind(0) == BodyKind::rigid && on.kind(1) == BodyKind::rigid;
    for (std::size_t b = 0; b < 2; ++b) {
        const BodyDef& body = world.body_def(on.def().body[b]);
        const BodyKind kind = on.kind(static_cast<int>(b));
        if (kind == BodyKind::fixed || kind == BodyKind::kinematic) continue;
        double end = 1.0 / body.mass;
        if (rigid)
            end += on.def().point[b].norm() * angular_mobility(body, on.def().point[b]);
        else if (kind == BodyKind::rigid)
            end += on.def().point[b].squaredNorm() * Mat3(body.inertia.inverse()).trace();
        most = std::max(most, end);
    }
    return most;
}

// Return the reduction factor of the stiffness of a line between rotating bodies without nodes. It
// applies if the transverse vibration is resolved.
double vibration_reduction(const Attached& on, double s) {
    return on.is_point(0) || on.is_point(1) || s >= 0.25 ? 1.0 : 16.0 * s * s;
}

// Add the impulse of the transverse stiffness of a line under tension. It depends on the changes of
// velocity in the step, and on the differences from velocities extrapolated from the last two steps
// (docs/theory/wires.md).
// @param damped  True: a wire that is damped because its step was rejected.
// @param held  Fraction of the stiffness that acts in the step.
void add_transverse_stiffness(const World& world, const Attached& on, std::span<const Twist> before,
                              std::span<const Twist> earlier, double tension, bool damped,
                              double held, Wrenches& out) {
    const double h = world.settings().step;
    const LineEnds ends = line_ends(on);
    const Vec3 between = ends.at[1] - ends.at[0], u = between.normalized();
    const double full = held * h * h * world.settings().geometric_stiffness * tension /
                        std::max(between.norm(), 1e-9);
    const double s = full * transverse_mobility(on, world), fade = vibration_reduction(on, s),
                 // Between two rigid bodies the trapezoidal rule applies at any frequency.
        p = s > 0.25 && (on.is_point(0) || on.is_point(1) || on.kind(0) != BodyKind::rigid ||
                         on.kind(1) != BodyKind::rigid)
                ? (s - 0.25) / (s + 0.25)
                : 0.0;
    const double late = 0.25 + p * (damped ? 0.75 : 0.25), ahead = p * (damped ? -0.2 : -0.1);
    Vec3 arm[2], push = Vec3::Zero();
    for (int b = 0; b < 2; ++b) {
        const BodyId body = on.def().body[static_cast<std::size_t>(b)];
        const auto i = static_cast<std::size_t>(body.index);
        const bool prescribed = on.kind(b) == BodyKind::fixed || on.kind(b) == BodyKind::kinematic;
        const bool turns = !on.is_point(b);
        arm[b] = ends.at[b] - on.center(b);
        const auto at_point = [&](const Twist& t) -> Vec3 {
            return turns ? Vec3(t.linear + t.angular.cross(arm[b])) : t.linear;
        };
        const Vec3 now = at_point(on.velocity(b)), old = at_point(before[i]);
        const Vec3 expected = prescribed ? now : Vec3(2.0 * old - at_point(earlier[i]));
        push += (b == 0 ? -1.0 : 1.0) * (late * (now - old) + ahead * (now - expected));
    }
    const Vec3 across = fade * full * (push - push.dot(u) * u);
    for (std::size_t b = 0; b < 2; ++b) {
        const double sign = b == 0 ? 1.0 : -1.0;
        out.on[b].force += sign * across;
        out.on[b].torque += sign * arm[b].cross(across);
    }
}

// Return the fraction of the stiffness for a joint with end-of-step constraint iterations. It is 0
// if the step resolves the oscillation about the joint, and 1 from twice the limit frequency on.
double completed_fraction(const Attached& on, const World& world, double force) {
    double rate = 0.0;
    for (std::size_t b = 0; b < 2; ++b) {
        const BodyDef& body = world.body_def(on.def().body[b]);
        const BodyKind kind = on.kind(static_cast<int>(b));
        if (kind == BodyKind::rigid)
            rate = std::max(rate, angular_mobility(body, on.def().point[b]));
        if (kind == BodyKind::lump && on.def().kind == InteractionKind::Distance)
            rate = std::max(rate, 1.0 / (on.def().get("length") * body.mass));
    }
    const double h = world.settings().step;
    return std::clamp(h * h * force * rate - 1.0, 0.0, 1.0);
}

double angle_of(const Attached& on) {
    const Quat turn = on.frame(0).conjugate() * on.frame(1);
    return std::remainder(2.0 * std::atan2(turn.z(), turn.w()), 2.0 * std::acos(-1.0));
}

double travel_of(const Attached& on) { return on.axis(0, 2).dot(on.point(1) - on.point(0)); }

// Return the norm of the force of an interaction on which a friction depends, over its rows in
// metres [N].
double load_size(const World& world, InteractionId id) {
    const std::string_view units = kind_info(world.interaction_def(id).kind).row_units;
    const std::span<const double> f = world.force(id);
    double square = 0.0;
    for (std::size_t r = 0; r < f.size(); ++r)
        if (units[r] == 'm') square += f[r] * f[r];
    return std::sqrt(square);
}

// Return (r − 1)/(r + 1) for the ratio r of the tensions before and after a turning point, at which
// the line slides (Euler and Eytelwein).
double line_fraction(const World& world, const InteractionDef& def, std::span<const Pose> pose) {
    const double angle = turn_between(world, def.load[0].interaction, def.load[1].interaction,
                                      def.get("angle"), pose);
    const double ratio = std::exp(def.get("friction") * angle) / def.get("efficiency");
    return (ratio - 1.0) / (ratio + 1.0);
}

ForceRange friction_range(const World& world, InteractionId id, std::span<const Pose> pose,
                          const char* bound) {
    double most = parameter(world, id, bound);
    const InteractionDef& def = world.interaction_def(id);
    const bool of_line = def.kind == InteractionKind::LineFriction;
    for (const FrictionLoad& load : def.load)
        if (load.interaction.valid())
            most += (of_line ? line_fraction(world, def, pose) : load.factor) *
                    load_size(world, load.interaction);
    const double back = world.interaction_def(id).kind == InteractionKind::ScalarFriction
                            ? parameter(world, id, "back")
                            : 1.0;
    const double loads = most - parameter(world, id, bound);
    return {-most, back * parameter(world, id, bound) + loads, true, true};
}

/// Return the speed of a coordinate after the step [m/s or rad/s].
double coordinate_speed(const Attached& on) {
    if (on.def().kind == InteractionKind::ScalarMotor) return on.velocity(0).linear.x();
    const Vec3 axis = on.axis(0, 2);
    const Twist a = on.velocity(0), b = on.velocity(1);
    const Vec3 turning = b.angular - a.angular;
    if (on.def().kind == InteractionKind::HingeMotor) return axis.dot(turning);
    if (on.def().kind == InteractionKind::HingeRange) {  // the axes may differ
        const Vec3 other = on.axis(1, 2);
        return (axis + other).dot(turning) / (1.0 + axis.dot(other));
    }
    const Vec3 where = on.point(1);
    return axis.dot(b.linear + b.angular.cross(where - on.center(1)) - a.linear -
                    a.angular.cross(where - on.center(0)));
}

/// Return the forces of a range. An end acts in a step that reaches it.
/// @param q, travel  Coordinate before the step, and its displacement in the step.
ForceRange limit_range(const World& world, InteractionId id, double q, double travel) {
    const InteractionDef& def = world.interaction_def(id);
    const double below = def.get("min") - std::min(q, q + travel),
                 above = std::max(q, q + travel) - def.get("max");
    // If rounding decides whether the limit is reached, accept both cases.
    const double noise = 1e-12 * (1.0 + std::abs(q));
    return {above > -noise ? -kNoBound : 0.0, below > -noise ? kNoBound : 0.0, true, false};
}

}  // namespace

double piece_mass(const World& world, InteractionId id) {
    const InteractionDef& def = world.interaction_def(id);
    if (def.kind != InteractionKind::Stretch) return 0.0;
    if (world.settings().nonsmooth == Nonsmooth::pgs) return 0.0;
    for (int b = 0; b < 2; ++b)
        if (world.body_def(def.body[static_cast<std::size_t>(b)]).kind != BodyKind::lump)
            return 0.0;
    return def.get("mass");
}

namespace {

/// Add the impulses of the consistent mass of an element: the mass times the changes of velocity in
/// the step.
void add_piece(const World& world, InteractionId id, std::span<const Twist> before, Wrenches& out) {
    const double mass = piece_mass(world, id);
    if (!(mass > 0.0)) return;
    const auto& body = world.interaction_def(id).body;
    Vec3 gained[2];
    for (std::size_t b = 0; b < 2; ++b)
        gained[b] =
            world.velocity(body[b]).linear - before[static_cast<std::size_t>(body[b].index)].linear;
    for (std::size_t b = 0; b < 2; ++b) out.on[b].force += mass / 6.0 * (gained[b] - gained[1 - b]);
}

}  // namespace

Wrenches stiffness_wrenches(const World& world, InteractionId id, std::span<const Pose> pose,
                            std::span<const Twist> before, std::span<const Twist> earlier,
                            std::span<const double> last, int damped_steps_before) {
    const Attached on(world, id, pose);
    const InteractionKind kind = on.def().kind;
    const WorldDef& settings = world.settings();
    Wrenches out;
    if (!(is_line(kind) || is_joint(kind)) || settings.nonsmooth == Nonsmooth::pgs) return out;
    // A World does not show the replacement terms of a flagged wire that would have gained energy.
    out.is_known = world.wires().damped_steps(id) <
                   std::lround(std::ceil(std::max(20.0, 1.0 / settings.step)));
    const double h = settings.step, scale = 0.25 * h * h * settings.geometric_stiffness;
    const LineEnds ends = is_line(kind) ? line_ends(on) : LineEnds{{on.point(0), on.point(1)}, {}};
    const Vec3 between = ends.at[1] - ends.at[0];
    add_piece(world, id, before, out);
    Vec3 pull;  // on body 1
    if (is_line(kind)) {
        if (!(last[0] < 0.0)) return out;  // only elements under tension
        pull = last[0] * between.normalized();
    } else {
        pull = Vec3(last[0], last[1], last[2]);
    }
    const bool completed = world.solver().completed(id);
    const double held = completed ? completed_fraction(on, world, pull.norm()) : 1.0;
    if (held == 0.0) return out;
    // Excess of the oscillation about a joint over the resolved frequency:
    // docs/theory/stiffness.md.
    double swings = 0.0, fast = 0.0;
    const bool damped =
        is_joint(kind) && on.kind(0) == BodyKind::rigid && on.kind(1) == BodyKind::rigid;
    for (int b = 0; damped && b < 2; ++b) {
        const auto slot = static_cast<std::size_t>(b);
        const double rate =
            angular_mobility(world.body_def(on.def().body[slot]), on.def().point[slot]);
        swings = std::max(swings, h * h * pull.norm() * rate);
    }
    if (swings > 4.0) fast = (swings - 4.0) / (swings + 4.0);
    constexpr double kMaxVibrations = 2.5e9;  // beyond, the terms stop growing with the force
    const double bound = std::min(1.0, kMaxVibrations / swings);
    const double fraction =
        completed ? held
        : is_line(kind)
            ? vibration_reduction(on, 4.0 * scale * pull.norm() / std::max(between.norm(), 1e-9) *
                                          transverse_mobility(on, world))
            : 1.0;
    Vec3 arm[2], turned[2], spin[2];  // changes of velocity; (1 − u) ω + (1 + u) ω₊
    for (int b = 0; b < 2; ++b) {
        const BodyId body = on.def().body[static_cast<std::size_t>(b)];
        const Twist &old = before[static_cast<std::size_t>(body.index)], now = on.velocity(b);
        const bool turns = !on.is_point(b);
        arm[b] = ends.at[b] - on.center(b);
        turned[b] = turns ? Vec3(now.angular - old.angular) : Vec3::Zero();
        spin[b] =
            turns ? Vec3((1.0 + fast) * now.angular + (1.0 - fast) * old.angular) : Vec3::Zero();
        if (on.kind(b) == BodyKind::rigid)
            out.on[static_cast<std::size_t>(b)].torque -=
                fraction * bound * (1.0 + 0.5 * fast) * scale *
                (arm_stiffness(b == 0 ? Vec3(-pull) : pull, arm[b]) * turned[b]);
    }
    if (is_line(kind)) {
        add_transverse_stiffness(world, on, before, earlier, -last[0], damped_steps_before > 0,
                                 held, out);
    } else if (damped && !completed) {
        const double damping = settings.rotation_damping * h * h * pull.norm() *
                               std::min(arm[0].norm(), arm[1].norm()) *
                               std::min(1.0, 16.0 * swings * swings) * (1.0 + 9.0 * fast) * bound;
        const Vec3 torque = damping * (spin[1] - spin[0]);
        out.on[0].torque += torque;
        out.on[1].torque -= torque;
    }
    return out;
}

namespace {

/// Return a force range that is reduced so that the motor has a power ≤ `power` [W].
ForceRange with_power(const Attached& on, double power, ForceRange range) {
    if (!(power < 1e30)) return range;
    const double speed = coordinate_speed(on);
    // A range beyond the limit is reduced to it.
    const double most = speed > 0.0 ? power / speed : kNoBound;
    const double least = speed < 0.0 ? power / speed : -kNoBound;
    range = {std::clamp(range.low, least, most), std::clamp(range.high, least, most)};
    return range;
}

}  // namespace

ForceRange force_range(const World& world, InteractionId id, std::span<const Pose> pose) {
    const Attached on(world, id, pose);
    switch (on.def().kind) {
        case InteractionKind::Stretch:
        case InteractionKind::WinchStretch:
        case InteractionKind::Span:
        case InteractionKind::EndSpan:
        case InteractionKind::BodySpan:
            if (!(on.def().get("tension_only") > 0.5)) return {};
            return {-kNoBound, 0.0, true, false};
        case InteractionKind::HingeMotor:
        case InteractionKind::SlideMotor:
        case InteractionKind::ScalarMotor:
        case InteractionKind::ScalarClutch: {
            const double high = parameter(world, id, "force_max");
            return with_power(on, parameter(world, id, "power"),
                              {std::min(parameter(world, id, "force_min"), high), high, true});
        }
        case InteractionKind::HingeRange:
        case InteractionKind::SlideRange: {
            const double q =
                on.def().kind == InteractionKind::HingeRange ? angle_of(on) : travel_of(on);
            return limit_range(world, id, q, world.settings().step * coordinate_speed(on));
        }
        case InteractionKind::HingeFriction:
            return friction_range(world, id, pose, "torque");
        case InteractionKind::SlideFriction:
        case InteractionKind::ScalarFriction:
        case InteractionKind::LineFriction:
            return friction_range(world, id, pose, "force");
        default:
            return {};
    }
}

}  // namespace hawser::verify
