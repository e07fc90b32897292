// SPDX-License-Identifier: Apache-2.0
#include "vessel/actuators.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser {
namespace {

constexpr double kStalledCoefficient = 1.2;  ///< C_N of a stalled plate, divided by sin α.
constexpr double kStallWidth = std::numbers::pi / 18.0;  ///< From full lift to the plate [rad].
constexpr double kReversedLift = 0.5;                    ///< Factor of the lift in reversed flow.
constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// Fraction of the maximum revolutions below which a granted power limits the torque as at this
/// speed. A shaft at rest needs torque but no power.
constexpr double kSlowShaft = 0.05;

}  // namespace

double rudder_normal(const RudderDef& rudder, double attack) noexcept {
    const double slope = 6.13 * rudder.aspect / (rudder.aspect + 2.25);
    double a = std::abs(attack);
    double lift = slope;
    if (a > 0.5 * std::numbers::pi) {
        a = std::numbers::pi - a;
        lift *= kReversedLift;
    }
    const double flat = std::min(kStalledCoefficient, lift);
    const double x = std::clamp((a - rudder.stall) / kStallWidth, 0.0, 1.0);
    return (lift + (flat - lift) * x * x * (3.0 - 2.0 * x)) * std::sin(attack);
}

namespace vessel {

bool follow(double& now, double target, double rate, double lag, double step) noexcept {
    const double error = target - now, side = error < 0.0 ? -1.0 : 1.0;
    const double knee = rate * lag;  // From here on the first-order rate is below the limit.
    double left = std::abs(error), time = step;
    bool is_limited = false;
    if (left > knee) {
        const double moved = std::min(left - knee, rate * step);
        is_limited = left - knee > rate * step;
        left -= moved;
        time -= rate > 0.0 ? moved / rate : step;
    }
    if (lag > 0.0) left *= std::exp(-std::max(0.0, time) / lag);
    now = target - side * left;
    return is_limited;
}

double wrapped(double angle) noexcept { return std::remainder(angle, kTwoPi); }

Wrench push_at(const Vec3& at, double x, double y) noexcept {
    Wrench out;
    out << x, y, 0.0, -at.z() * y, at.z() * x, at.x() * y - at.y() * x;
    return out;
}

Propulsor::Propulsor(const PropulsorDef& def, const Vec3& origin)
    : def_(def),
      at_(def.point.x() - origin.x(), origin.y() - def.point.y(), origin.z() - def.point.z()) {}

double Propulsor::direction(const PropulsorState& s) const noexcept {
    switch (def_.kind) {
        case PropulsorKind::shaft:
            return 0.0;
        case PropulsorKind::azimuth:
        case PropulsorKind::cycloidal:
            return s.angle;
        case PropulsorKind::tunnel:
            break;
    }
    return 0.5 * std::numbers::pi;
}

PropellerForce Propulsor::open(const PropulsorState& s, const Flow& flow,
                               double& along) const noexcept {
    const double a = direction(s);
    const double x = flow.u() - at_.y() * flow.r(), y = flow.v() + at_.x() * flow.r();
    along = (1.0 - def_.wake) * (x * std::cos(a) + y * std::sin(a));
    if (def_.kind == PropulsorKind::tunnel) along = 0.0;
    PropellerForce out;
    if (is_screw()) {
        const double pitch = def_.propeller.pitch * (def_.controllable ? s.pitch : 1.0);
        out = propeller_force(def_.propeller, pitch, s.rps, along, flow.density);
    } else {
        out.thrust =
            def_.thrust * s.level * std::abs(s.level) * (s.level < 0.0 ? def_.astern : 1.0);
    }
    if (def_.kind == PropulsorKind::tunnel && def_.lost_at > 0.0)
        out.thrust *= std::max(0.0, 1.0 - std::abs(flow.u()) / def_.lost_at);
    out.thrust *= s.thrust_fraction;
    out.torque *= s.torque_fraction;
    return out;
}

double Propulsor::max_thrust(double density) const noexcept {
    if (!is_screw()) return def_.thrust;
    return propeller_force(def_.propeller, def_.propeller.pitch, def_.most_rps, 0.0, density)
        .thrust;
}

Wrench Propulsor::push(const PropulsorState& s, double thrust) const noexcept {
    if (thrust > 0.0) thrust *= 1.0 - def_.thrust_deduction;
    const double a = direction(s);
    if (def_.kind == PropulsorKind::shaft) return push_at(at_, thrust, 0.0);
    if (def_.kind == PropulsorKind::tunnel) return push_at(at_, 0.0, thrust);
    return push_at(at_, thrust * std::cos(a), thrust * std::sin(a));
}

Wrench Propulsor::force(const PropulsorState& s, const Flow& flow) const noexcept {
    double along = 0.0;
    return push(s, open(s, flow, along).thrust);
}

Failure failure_from_input(double input) noexcept {
    return static_cast<Failure>(std::clamp(static_cast<int>(std::lround(input)), 0, 3));
}

double Propulsor::effective_order(const PropulsorState& s) const noexcept {
    switch (failure_from_input(s.failed)) {
        case Failure::none:
            break;
        case Failure::stopped:
            return 0.0;
        case Failure::kept:
            return is_screw() && def_.shaft_inertia > 0.0 ? s.rps / def_.most_rps : s.level;
        case Failure::full:
            return 1.0;
    }
    return std::clamp(s.order, -1.0, 1.0);
}

double Propulsor::turning(const PropulsorState& s) const noexcept {
    return std::max(std::abs(s.rps), kSlowShaft * def_.most_rps);
}

Propulsor::Shaft Propulsor::shaft(const PropulsorState& s, const Flow& flow) const noexcept {
    Shaft out;
    out.target = effective_order(s) * def_.most_rps;
    const double inertia = kTwoPi * def_.shaft_inertia;
    double along = 0.0;
    out.load = open(s, flow, along).torque;
    PropulsorState more = s;
    const double d = 1e-4 * def_.most_rps;
    more.rps = s.rps + d;
    out.slope = std::max(0.0, (open(more, flow, along).torque - out.load) / d);
    out.unlimited_torque = out.load + inertia * (out.target - s.rps) / def_.response;
    if (failure_from_input(s.failed) == Failure::stopped) return out;
    double most = def_.most_torque > 0.0 ? def_.most_torque : 1e300;
    if (def_.most_power > 0.0)
        most = std::min(most, def_.most_power / std::max(kTwoPi * std::abs(s.rps), 1e-6));
    out.motor = std::clamp(out.unlimited_torque, -most, most);
    return out;
}

double Propulsor::demand(const PropulsorState& s, const Flow& flow, double rated) const noexcept {
    const double order = effective_order(s);
    if (!is_screw()) return rated * std::abs(order * order * order);
    if (!(def_.shaft_inertia > 0.0)) {
        PropulsorState at = s;
        at.rps = order * def_.most_rps;
        double along = 0.0;
        return std::max(0.0, kTwoPi * at.rps * open(at, flow, along).torque);
    }
    const double motor = shaft(s, flow).motor;
    return motor * s.rps < 0.0 ? 0.0 : kTwoPi * turning(s) * std::abs(motor);
}

/// Advance the shaft: the motor follows the ordered revolutions within its torque and power. The
/// water's torque is linearised in n, so that light shafts are stable.
void Propulsor::turn_shaft(PropulsorState& s, const Flow& flow, double step, double granted,
                           Limit& power) const noexcept {
    const Shaft at = shaft(s, flow);
    const double inertia = kTwoPi * def_.shaft_inertia;
    double motor = at.motor;
    const bool stopped = failure_from_input(s.failed) == Failure::stopped;
    const bool is_limited = motor != at.unlimited_torque && !stopped;
    if (motor * s.rps >= 0.0) {
        const double most = granted / (kTwoPi * turning(s));
        motor = std::clamp(motor, -most, most);
    }
    const double before = s.rps;
    double next = before + step * (motor - at.load) / (inertia + step * at.slope);
    if (motor == at.unlimited_torque) {
        // Without a limit the response is exactly first order.
        next = at.target - (at.target - before) * std::exp(-step / def_.response);
        // Mean torque of the motor in the step.
        motor = at.load + 0.5 * at.slope * (next - before) + inertia * (next - before) / step;
    }
    s.rps = next;
    s.power = std::numbers::pi * (before + next) * motor;
    if (is_limited && s.power_limited == 0) power = {true, s.power};
    s.power_limited = is_limited ? 1 : 0;
}

void Propulsor::turn(PropulsorState& s, double step, Limit& turn) const noexcept {
    double target = s.angle_order;
    if (!(def_.most_angle > 0.0)) target = s.angle + wrapped(s.angle_order - s.angle);
    const bool is_limited = follow(s.angle, target, def_.turn_rate, 0.0, step);
    if (!(def_.most_angle > 0.0)) s.angle = wrapped(s.angle);
    if (is_limited && s.turning_limited == 0) turn = {true, def_.turn_rate};
    s.turning_limited = is_limited ? 1 : 0;
}

void Propulsor::turn_vector(PropulsorState& s, double order, double step) const noexcept {
    const double angle = failure_from_input(s.failed) == Failure::none ? s.angle_order : s.angle;
    double x = s.level * std::cos(s.angle), y = s.level * std::sin(s.angle);
    const double to_x = order * std::cos(angle) - x, to_y = order * std::sin(angle) - y;
    const double way = std::hypot(to_x, to_y);
    const double moved = def_.ramp > 0.0 ? std::min(way, 2.0 * step / def_.ramp) : way;
    if (way > 0.0) {
        x += to_x * moved / way;
        y += to_y * moved / way;
    }
    s.level = std::min(1.0, std::hypot(x, y));
    if (s.level > 1e-12) s.angle = std::atan2(y, x);
}

void Propulsor::advance(PropulsorState& s, const Flow& flow, double step, double granted,
                        double demanded, Limit& turning, Limit& power) const noexcept {
    double along = 0.0;
    const PropellerForce water = open(s, flow, along);
    s.thrust = water.thrust;
    s.torque = water.torque;
    const Failure failure = failure_from_input(s.failed);
    if (is_screw() && def_.controllable && failure != Failure::stopped &&
        failure != Failure::kept) {
        const double rate = def_.pitch_time > 0.0 ? 1.0 / def_.pitch_time : 1e30;
        const bool is_limited =
            follow(s.pitch, failure == Failure::full ? 1.0 : s.pitch_order, rate, 0.0, step);
        if (is_limited && s.pitch_limited == 0) turning = {true, rate};
        s.pitch_limited = is_limited ? 1 : 0;
    }
    if (is_screw() && def_.shaft_inertia > 0.0) {
        turn_shaft(s, flow, step, granted, power);
    } else {
        double target = effective_order(s);
        // Power grows with the cube of the order.
        if (granted < demanded) target *= std::cbrt(granted / demanded);
        if (def_.kind == PropulsorKind::cycloidal) {
            turn_vector(s, target, step);
            return;
        }
        (void)follow(s.level, target, def_.ramp > 0.0 ? 1.0 / def_.ramp : 1e30, 0.0, step);
        if (is_screw()) {
            s.rps = s.level * def_.most_rps;
            s.power = kTwoPi * s.rps * open(s, flow, along).torque;
        }
    }
    if (def_.kind == PropulsorKind::azimuth && failure == Failure::none) turn(s, step, turning);
}

Rudder::Rudder(const RudderDef& def, const Vec3& origin, int behind)
    : def_(def),
      at_(def.point.x() - origin.x(), origin.y() - def.point.y(), origin.z() - def.point.z()),
      behind_(behind) {}

Wrench Rudder::force(const RudderState& s, const Flow& flow, double thrust,
                     double diameter) const noexcept {
    const double u = (1.0 - def_.wake) * (flow.u() - at_.y() * flow.r());
    const double v = flow.v() + at_.x() * flow.r();
    double along = u;
    if (diameter > 0.0 && thrust > 0.0) {
        const double disc = 8.0 * thrust / (std::numbers::pi * flow.density * diameter * diameter);
        const double start = std::max(u, 0.0);
        const double jet = start + def_.slipstream * (std::sqrt(start * start + disc) - start);
        const double mean =
            std::sqrt(def_.covered * jet * jet + (1.0 - def_.covered) * start * start);
        along = u > 0.0 ? mean : u + mean;
    }
    // δ > 0: the trailing edge to starboard; the flow past the rudder comes from (along, v).
    const double attack = wrapped(s.angle - std::atan2(v, along));
    const double normal =
        0.5 * flow.density * def_.area * (along * along + v * v) * rudder_normal(def_, attack);
    return push_at(at_, -normal * std::sin(s.angle),
                   -(1.0 + def_.hull_increase) * normal * std::cos(s.angle));
}

void Rudder::advance(RudderState& s, double step, Limit& rate) const noexcept {
    double target = std::clamp(s.order, -def_.most_angle, def_.most_angle);
    const Failure failure = failure_from_input(s.failed);
    if (failure == Failure::stopped) target = s.angle;
    if (failure == Failure::kept) target = def_.most_angle;
    if (failure == Failure::full) target = -def_.most_angle;
    const bool is_limited = follow(s.angle, target, def_.rate, 0.0, step);
    if (is_limited && s.is_limited == 0) rate = {true, def_.rate};
    s.is_limited = is_limited ? 1 : 0;
}

}  // namespace vessel
}  // namespace hawser
