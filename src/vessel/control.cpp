// SPDX-License-Identifier: Apache-2.0
#include "vessel/control.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>

namespace hawser::vessel {
namespace {

constexpr double kSmallThrust = 0.005;  ///< Fraction below which an azimuth keeps its angle.
constexpr double kSmallDemand = 0.01;   ///< Fraction below which no failure is analysed.
/// Shortfall, as a fraction of the capacity, that stops an integral. It exceeds kSmallThrust: an
/// azimuth that keeps its angle for a small thrust must not stop the integral, or the offset would
/// remain.
constexpr double kMaxShortfall = 1.5 * kSmallThrust;
constexpr double kAlarmHysteresis = 0.8;  ///< Offset over the alarm that arms it again.
constexpr double kRudderSpeed = 1.5;      ///< Least speed at which a rudder steers [m/s].
constexpr double kMeanTime = 20.0;        ///< Time constant of the demand for failures [s].
constexpr double kSpeedRate = 0.05;       ///< Rate of the speed control [1/s].
constexpr double kPowerBack = 5.0;        ///< Time in which withheld capacity comes back [s].
constexpr double kSteerDerivative = 2.0;  ///< Rudder per turn rate, in L/U.
constexpr double kSteerIntegral =
    20.0;  ///< Time constant of the rudder's integral, in units of L/U.

double fraction_of(double h, double time) noexcept {
    return time > 0.0 ? 1.0 - std::exp(-h / time) : 1.0;
}

bool finite(const Vec3& v) noexcept {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

}  // namespace

const char* Control::rejection_reason(ControlMode mode) const noexcept {
    const bool rudder = !def_.rudders.empty() || def_.mmg.diameter > 0.0 ||
                        def_.son_nomoto.diameter > 0.0 || !def_.polynomial.terms.empty();
    const bool yaw = largest_[2] > 0.0;
    switch (mode) {
        case ControlMode::off:
            return "";
        case ControlMode::joystick:
            return def_.propulsors.empty() && !def_.control.direct ? "it has no propulsors" : "";
        case ControlMode::heading:
            return rudder || yaw || def_.control.direct
                       ? ""
                       : "no rudder and no propulsor turns the vessel";
        case ControlMode::position:
            break;
        case ControlMode::follow:
            if (!(def_.control.target == BodyId{})) break;
            return "it has no target";
    }
    if (def_.control.direct || authority_ == 3) return "";
    if (!yaw) return "the propulsors give no yaw moment";
    return "the propulsors do not drive surge, sway and yaw independently";
}

double Control::heading_error() const noexcept {
    return wrapped(observer_.low_frequency_motion().planar_position[2] - desired_[2]);
}

bool Control::steers_by_rudder(const ControlSense& sense) const noexcept {
    const bool rudder = !def_.rudders.empty() || def_.mmg.diameter > 0.0 ||
                        def_.son_nomoto.diameter > 0.0 ||
                        (def_.propulsors.empty() && !def_.polynomial.terms.empty());
    return mode() == ControlMode::heading && rudder && sense.surge > kRudderSpeed;
}

/// Set the orders to the present position and heading, except those set in this step.
void Control::engage(ControlMode mode, const ControlSense& sense,
                     const ControlledActuators& act) noexcept {
    const Vec3 position = observer_.low_frequency_motion().planar_position;
    if (x_order_ == last_orders_[0]) x_order_ = position[0];
    if (y_order_ == last_orders_[1]) y_order_ = -position[1];
    if (heading_order_ == last_orders_[2]) heading_order_ = position[2];
    desired_ = position;
    sum_.setZero();
    steer_sum_ = 0.0;
    speed_sum_ = act.rps_order;
    arrived_ = 1;
    if (mode == ControlMode::follow)
        offset_ = Vec3(position[0] - sense.target[0], -position[1] - sense.target[1], 0.0);
}

void Control::choose_mode(Prestep& now, const ControlSense& sense,
                          const ControlledActuators& act) noexcept {
    const double requested_mode = std::round(mode_input_);
    if (requested_mode == active_mode_) {
        mode_input_ = active_mode_;
        return;
    }
    const auto mode = static_cast<ControlMode>(static_cast<int>(requested_mode));
    if (requested_mode != mode_input_ || *rejection_reason(mode) != '\0') {
        now.tell(EventKind::mode_refused, def_.body, mode_input_);
        mode_input_ = active_mode_;
        return;
    }
    active_mode_ = requested_mode;
    engage(mode, sense, act);
    // Discard the orders of the previous mode.
    if (mode == ControlMode::off)
        for (PropulsorState& s : act.propulsors) s.order = 0.0;
}

/// Move the desired position η_d towards the ordered position within the limits of speed.
void Control::follow_orders(const ControlSense& sense, double h) noexcept {
    if (mode() == ControlMode::follow) {
        x_order_ = sense.target[0] + offset_[0];
        y_order_ = sense.target[1] + offset_[1];
    }
    const Vec3 order(x_order_, -y_order_, heading_order_);
    Vec3 moved = order - Vec3(last_orders_[0], -last_orders_[1], last_orders_[2]);
    if (mode() == ControlMode::follow) moved[0] = moved[1] = 0.0;
    if (moved.cwiseAbs().maxCoeff() > 1e-9) arrived_ = 0;
    const double share = fraction_of(h, def_.control.filter);
    const bool follows = mode() == ControlMode::follow;
    for (int i = 0; i < 2; ++i) desired_[i] += (follows ? 1.0 : share) * (order[i] - desired_[i]);
    desired_[2] = wrapped(desired_[2] + share * wrapped(order[2] - desired_[2]));
    last_orders_ = Vec3(x_order_, y_order_, heading_order_);
}

/// Return the force of the PI control of the speed through the water. The integral is a force.
Vec3 Control::speed_demand(const ControlSense& sense, double h) noexcept {
    const double error = speed_order_ - sense.surge;
    const double force = mass_[0] * kSpeedRate * error + sum_[0];
    const bool over = std::abs(force) > largest_[0] && force * error > 0.0;
    if (!over) sum_[0] += h * mass_[0] * kSpeedRate * 0.2 * kSpeedRate * error;
    return {force, 0.0, 0.0};
}

Vec3 Control::demand(const ControlSense& sense, double h) noexcept {
    Vec3 stick(stick_x_ * largest_[0], stick_y_ * largest_[1], stick_n_ * largest_[2]);
    const Planar& low = observer_.low_frequency_motion();
    Vec3 tau = Vec3::Zero();
    error_.setZero();
    switch (mode()) {
        case ControlMode::off:
            return tau;
        case ControlMode::joystick:
            return stick;
        case ControlMode::heading:
            tau = speed_order_ > 0.0 ? speed_demand(sense, h) : Vec3(stick[0], 0.0, 0.0);
            if (!(speed_order_ > 0.0)) sum_[0] = 0.0;
            tau[1] = stick[1];
            error_[2] = heading_error();
            if (steers_by_rudder(sense)) return tau;
            tau[2] = -proportional_[2] * error_[2] - derivative_[2] * low.motion[2] -
                     integral_[2] * sum_[2];
            return tau;
        case ControlMode::position:
        case ControlMode::follow:
            break;
    }
    Vec3 separation = low.planar_position - desired_;
    separation[2] = heading_error();
    error_ = to_ship(separation, low.planar_position[2]);
    Vec3 motion = low.motion;
    if (mode() == ControlMode::follow) {
        const Vec3 carried(sense.target_motion[0], -sense.target_motion[1], 0.0);
        motion -= to_ship(carried, low.planar_position[2]);
    }
    tau = -proportional_.cwiseProduct(error_) - derivative_.cwiseProduct(motion) -
          integral_.cwiseProduct(to_ship(sum_, low.planar_position[2]));
    return tau - feed_;
}

/// Integrate the position error of each axis, except if the thrust of this axis is too small and
/// the error would increase the integral.
void Control::integrate(const Vec3& tau, double h) noexcept {
    const ControlMode m = mode();
    if (m == ControlMode::off || m == ControlMode::joystick) return;
    Vec3 adding = error_;
    for (int i = 0; i < 3; ++i) {
        const double lacking = tau[i] - allocated_[i];
        if (std::abs(lacking) > kMaxShortfall * largest_[i] && -adding[i] * lacking > 0.0)
            adding[i] = 0.0;
    }
    if (m == ControlMode::heading) {
        sum_[2] += h * adding[2];
        return;
    }
    sum_ += h * to_earth(adding, observer_.low_frequency_motion().planar_position[2]);
}

/// Set the rudder by the errors of heading and turn rate, and the revolutions of a propeller in a
/// coefficient set by the speed error.
void Control::steer(const ControlSense& sense, ControlledActuators act, double h) noexcept {
    if (mode() == ControlMode::position || mode() == ControlMode::follow) {
        // Thrusters alone hold the position: a rudder that stays over would be a load.
        act.rudder_order = 0.0;
        for (RudderState& r : act.rudders) r.order = 0.0;
    }
    if (mode() != ControlMode::heading) return;
    if (speed_order_ > 0.0 && def_.steering.rps > 0.0) {
        const double max_rps =
            def_.steering.most_rps > 0.0 ? def_.steering.most_rps : 2.0 * def_.steering.rps;
        const double error = speed_order_ - sense.surge, gain = 0.2 * def_.steering.rps;
        const double rps_demand = speed_sum_ + gain * error;
        if (std::abs(rps_demand) < max_rps || rps_demand * error < 0.0)
            speed_sum_ += h * gain * error / 60.0;
        act.rps_order = std::clamp(rps_demand, -max_rps, max_rps);
    }
    if (!steers_by_rudder(sense)) {
        act.rudder_order = 0.0;
        for (RudderState& r : act.rudders) r.order = 0.0;
        return;
    }
    const double time = length_ / std::max(sense.surge, kRudderSpeed);
    const double error = -heading_error();
    const double steer_demand =
        error - kSteerDerivative * time * observer_.low_frequency_motion().motion[2] + steer_sum_;
    const double max_angle = def_.steering.most_angle;
    if (std::abs(steer_demand) < max_angle || steer_demand * error < 0.0)
        steer_sum_ += h * error / (kSteerIntegral * time);
    act.rudder_order = std::clamp(steer_demand, -max_angle, max_angle);
    for (std::size_t i = 0; i < act.rudders.size(); ++i)
        act.rudders[i].order =
            std::clamp(steer_demand, -def_.rudders[i].most_angle, def_.rudders[i].most_angle);
}

/// Compute the available fraction of each propulsor's thrust, from its available power to the power
/// of 2/3. It increases slowly, so that thrusters on one power bus do not alternate.
void Control::find_available(const ControlledActuators& act, double h) noexcept {
    uncontrolled_.setZero();
    for (std::size_t i = 0; i < act.propulsors.size(); ++i) {
        const PropulsorState& s = act.propulsors[i];
        available_[i] = 1.0;
        if (!powered_.empty()) {
            const double offered = std::cbrt(act.bus.available_fraction(i, full_));
            powered_[i] = std::min(offered * offered, powered_[i] + h / kPowerBack);
            available_[i] = powered_[i];
        }
        if (failure_from_input(s.failed) != Failure::none) available_[i] = 0.0;
        if (available_[i] <= 0.0) uncontrolled_ += push(s, i);
    }
}

/// Order an azimuth thruster to the angle of the allocation.
void Control::order_angle(PropulsorState& s, std::size_t i) noexcept {
    const AllocatedThruster& t = allocation_.thrusters()[i];
    const double x = allocation_.x(i), y = allocation_.y(i);
    const bool reversed =
        sectors_[i] >= 0 && t.sectors[static_cast<std::size_t>(sectors_[i])].reversed;
    if (std::hypot(x, y) > kSmallThrust * t.ahead)
        s.angle_order = wrapped(std::atan2(y, x) + (reversed ? std::acos(-1.0) : 0.0));
    ThrusterNow& now = present_thrust_[i];
    now.angle = s.angle;
    now.thrust_min = reversed ? -available_[i] * t.astern : 0.0;
    if (reversed) now.thrust_max = 0.0;
    // A thruster that turns through a zone does not push there.
    bool allowed = t.sectors.empty();
    for (const ThrustSector& sector : t.sectors) {
        const double turned = s.angle + (sector.reversed ? std::acos(-1.0) : 0.0);
        const double off = wrapped(turned - sector.from - 0.5 * sector.width);
        allowed =
            allowed || (sector.reversed == reversed && std::abs(off) <= 0.5 * sector.width + 0.02);
    }
    if (!allowed) now.thrust_min = now.thrust_max = 0.0;
}

/// Limit the thrust of a propulsor in this step by its capacity, direction and ramp.
void Control::limit_thruster(const PropulsorState& s, std::size_t i, double h) noexcept {
    const PropulsorDef& p = def_.propulsors[i];
    const AllocatedThruster& t = allocation_.thrusters()[i];
    ThrusterNow& now = present_thrust_[i];
    if (!(p.ramp > 0.0) || p.shaft_inertia > 0.0) return;
    const double past = p.propeller.diameter > 0.0 ? s.rps / p.most_rps : s.level;
    const auto thrust = [&](double level) {
        const double f = std::clamp(level / rps_[i], -1.0, 1.0);
        return f * std::abs(f) * (f < 0.0 ? t.astern : t.ahead);
    };
    const double thrust_min = now.thrust_min, thrust_max = now.thrust_max;
    now.thrust_min = std::clamp(thrust(past - h / p.ramp), thrust_min, thrust_max);
    now.thrust_max = std::clamp(thrust(past + h / p.ramp), thrust_min, thrust_max);
}

/// Order the propulsors: azimuths to the angles of the allocation, thrusts within their rates. A
/// propulsor that has failed or has no power gets no order.
void Control::order_thrusters(const Vec3& tau, ControlledActuators act, double h) noexcept {
    const Vec3 thrust_demand = tau - uncontrolled_;
    allocation_.allocate(thrust_demand, available_.data(), sectors_.data());
    for (std::size_t i = 0; i < act.propulsors.size(); ++i) {
        PropulsorState& s = act.propulsors[i];
        const AllocatedThruster& t = allocation_.thrusters()[i];
        present_thrust_[i] = {t.axis, -available_[i] * t.astern, available_[i] * t.ahead};
        if (available_[i] <= 0.0) continue;
        if (t.is_azimuth) order_angle(s, i);
        limit_thruster(s, i, h);
    }
    allocation_.thrust_at_fixed_angles(thrust_demand, present_thrust_.data(), thrusts_.data());
    allocated_ = allocation_.total() + uncontrolled_;
    for (std::size_t i = 0; i < act.propulsors.size(); ++i) {
        const AllocatedThruster& t = allocation_.thrusters()[i];
        const double capacity = thrusts_[i] < 0.0 ? t.astern : t.ahead;
        const double share = capacity > 0.0 ? std::sqrt(std::abs(thrusts_[i]) / capacity) : 0.0;
        act.propulsors[i].order = std::copysign(std::min(share, 1.0) * rps_[i], thrusts_[i]);
        if (available_[i] <= 0.0) act.propulsors[i].order = 0.0;
    }
}

/// Allocate the mean demand without the thrusters of one failure, and update the worst failure.
void Control::analyse_failure(Prestep& now, double h) noexcept {
    mean_ += fraction_of(h, kMeanTime) * (demand_ - mean_);
    if (shortfalls_.empty() || def_.control.direct) return;
    const double size = allocation_.scaled_norm(mean_);
    const auto k = static_cast<std::size_t>(next_failure_);
    shortfalls_[k] = 0.0;
    if (size > kSmallDemand) {
        for (std::size_t i = 0; i < spare_.size(); ++i) {
            spare_[i] = sectors_[i];
            remaining_[i] = failures_[k][i] != 0 ? 0.0 : available_[i];
        }
        const Vec3 thrust_demand = mean_ - uncontrolled_;
        allocation_.allocate(thrust_demand, remaining_.data(), spare_.data());
        shortfalls_[k] = allocation_.scaled_norm(Vec3(thrust_demand - allocation_.total())) / size;
    }
    next_failure_ = k + 1 < shortfalls_.size() ? next_failure_ + 1 : 0;
    const auto worst = std::max_element(shortfalls_.begin(), shortfalls_.end());
    worst_ = *worst;
    worst_failure_ = worst_ > 0.0 ? static_cast<double>(worst - shortfalls_.begin()) : -1.0;
    const double alarm = def_.control.consequence_alarm;
    const ControlMode m = mode();
    const bool holding = m == ControlMode::position || m == ControlMode::follow;
    if (holding && worst_ > alarm && critical_ == 0) {
        now.tell(EventKind::failure_critical, def_.body, worst_);
        critical_ = 1;
    }
    if (worst_ < kAlarmHysteresis * alarm || !holding) critical_ = 0;
}

void Control::report(Prestep& now) noexcept {
    const Planar& low = observer_.low_frequency_motion();
    const Vec3 order(x_order_, -y_order_, heading_order_);
    Vec3 separation = low.planar_position - order;
    separation[2] = wrapped(separation[2]);
    const ControlMode m = mode();
    offsets_.setZero();
    if (m == ControlMode::heading) offsets_[2] = separation[2];
    if (m != ControlMode::position && m != ControlMode::follow) return;
    offsets_ = to_ship(separation, low.planar_position[2]);
    const double distance = std::hypot(offsets_[0], offsets_[1]);
    const VesselControl& c = def_.control;
    const double over =
        std::max(distance / c.position_alarm, std::abs(offsets_[2]) / c.heading_alarm);
    if (arrived_ == 0 && over < kAlarmHysteresis) arrived_ = 1;
    if (arrived_ == 1 && over > 1.0) {
        now.tell(EventKind::position_lost, def_.body, distance);
        arrived_ = 0;
    }
}

Vec3 Control::push(const PropulsorState& s, std::size_t i) const noexcept {
    const AllocatedThruster& t = allocation_.thrusters()[i];
    const double thrust_fraction = s.thrust > 0.0 ? 1.0 - def_.propulsors[i].thrust_deduction : 1.0;
    const double a = t.is_azimuth ? s.angle : t.axis;
    const double x = thrust_fraction * s.thrust * std::cos(a),
                 y = thrust_fraction * s.thrust * std::sin(a);
    return {x, y, t.x * y - t.y * x};
}

/// Return the force of all propulsors in the last step.
Vec3 Control::last_propulsor_force(const ControlledActuators& act) const noexcept {
    Vec3 out = Vec3::Zero();
    for (std::size_t i = 0; i < act.propulsors.size(); ++i) out += push(act.propulsors[i], i);
    return out;
}

Vec3 Control::step(Prestep& now, const ControlSense& sense, ControlledActuators act) noexcept {
    const double h = now.step;
    if (started_ == 0) {
        observer_.start(sense.measured);
        feed_ = (def_.control.wind ? sense.wind : Vec3::Zero()) + sense.lines;
        started_ = 1;
    }
    if (def_.control.observer)
        observer_.step(sense.measured, acting_, h);
    else
        observer_.start(sense.measured);
    heading_ = wrapped(observer_.low_frequency_motion().planar_position[2]);
    choose_mode(now, sense, act);
    const Vec3 feed = (def_.control.wind ? sense.wind : Vec3::Zero()) + sense.lines;
    feed_ += fraction_of(h, def_.control.wind_filter) * (feed - feed_);
    const ControlMode m = mode();
    find_available(act, h);
    if (m != ControlMode::off && m != ControlMode::joystick) follow_orders(sense, h);
    demand_ = demand(sense, h);
    if (!finite(demand_)) demand_.setZero();
    Vec3 direct = Vec3::Zero();
    if (m == ControlMode::off) {
        allocated_.setZero();
        last_orders_ = Vec3(x_order_, y_order_, heading_order_);
    } else if (def_.control.direct) {
        direct = allocated_ = demand_;
    } else {
        order_thrusters(demand_, act, h);
    }
    steer(sense, act, h);
    integrate(demand_, h);
    acting_ = feed + (def_.control.direct ? direct : last_propulsor_force(act));
    report(now);
    analyse_failure(now, h);
    return direct;
}

}  // namespace hawser::vessel
