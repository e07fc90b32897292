// SPDX-License-Identifier: Apache-2.0
/// State and signals of vessels.
#include "vessel/vessel_system.h"

#include <span>

namespace hawser::vessel {
namespace {

constexpr double kMaxState = 1e6;  ///< Limit of velocities [m/s, rad/s].

}  // namespace

void VesselSystem::visit_state(StateVisitor& v) {
    v.visit(std::span<double>(last_velocity_.data(), 3));
    v.visit(std::span<double>(last_spin_.data(), 3));
    v.visit(started_);
    v.visit(steering_limited_);
    for (double* x : {&rudder_order_, &rps_order_, &rudder_, &rps_, &speed_, &ground_speed_,
                      &drift_, &turn_rate_, &surge_, &sway_, &yaw_})
        v.visit(*x);
    for (PropulsorState& s : propulsor_) {
        for (double* x : {&s.order, &s.angle_order, &s.pitch_order, &s.level, &s.rps, &s.angle,
                          &s.pitch, &s.thrust, &s.power})
            v.visit(*x);
        v.visit(s.turning_limited);
        v.visit(s.power_limited);
        for (double* x : {&s.failed, &s.thrust_fraction, &s.torque_fraction, &s.loss, &s.torque})
            v.visit(*x);
        v.visit(s.failed_last);
        v.visit(s.pitch_limited);
    }
    for (RudderState& s : rudder_state_) {
        v.visit(s.order);
        v.visit(s.angle);
        v.visit(s.is_limited);
        v.visit(s.failed);
        v.visit(s.failed_last);
    }
    for (double* x : {&rudder_failed_, &rps_failed_}) v.visit(*x);
    v.visit(rudder_failed_last_);
    v.visit(rps_failed_last_);
    bus_.visit_state(v);
    if (control_ != nullptr) control_->visit(v);
}

void VesselSystem::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    if (control_ != nullptr) control_->check(rules);
    constexpr double kRoundingFactor = 1.0 + 1e-12;
    rules.flag(started_, "whether it has started is no flag");
    rules.flag(steering_limited_, "whether the steering gear is at its limit is no flag");
    for (const double x : last_velocity_)
        rules.range(x, -kMaxState, kMaxState, "the last velocity is out of range");
    for (const double x : last_spin_)
        rules.range(x, -kMaxState, kMaxState, "the last turning rate is out of range");
    bus_.check_state(rules);
    const auto failure = [&](std::int32_t last) {
        rules.range(last, 0.0, 3.0, "the last failure is none of 0 to 3");
    };
    failure(rudder_failed_last_);
    failure(rps_failed_last_);
    const SteeringDef& steering = def_.steering;
    rules.range(rudder_, -steering.most_angle * kRoundingFactor,
                steering.most_angle * kRoundingFactor, "the rudder angle is out of range");
    const double most =
        (steering.most_rps > 0.0 ? steering.most_rps : 2.0 * steering.rps) * kRoundingFactor;
    rules.range(rps_, -most, most, "the revolutions are out of range");
    for (std::size_t i = 0; i < propulsor_.size(); ++i) {
        const PropulsorState& s = propulsor_[i];
        const PropulsorDef& d = propulsors_[i].def();
        const double angle = d.most_angle > 0.0 ? d.most_angle : 3.2;
        rules.range(s.level, -kRoundingFactor, kRoundingFactor,
                    "a propulsor's level is out of range");
        rules.range(s.rps, -10.0 * d.most_rps * kRoundingFactor,
                    10.0 * d.most_rps * kRoundingFactor,
                    "a propulsor's revolutions are out of range");
        rules.range(s.angle, -angle * kRoundingFactor, angle * kRoundingFactor,
                    "a propulsor's angle is out of range");
        rules.range(s.pitch, -kRoundingFactor, kRoundingFactor,
                    "a propulsor's pitch is out of range");
        rules.flag(s.turning_limited, "whether a propulsor is at its turning rate is no flag");
        rules.flag(s.power_limited, "whether a motor is at its limit is no flag");
        failure(s.failed_last);
        rules.flag(s.pitch_limited, "whether a pitch is at its rate is no flag");
        rules.range(s.thrust_fraction, 0.0, kRoundingFactor,
                    "the thrust that a propulsor keeps is out of range");
        rules.range(s.torque_fraction, 0.0, kRoundingFactor,
                    "the torque that a propulsor keeps is out of range");
    }
    for (std::size_t i = 0; i < rudder_state_.size(); ++i) {
        const double angle = rudders_[i].def().most_angle * kRoundingFactor;
        rules.range(rudder_state_[i].angle, -angle, angle, "a rudder's angle is out of range");
        rules.flag(rudder_state_[i].is_limited, "whether a rudder is at its rate is no flag");
        failure(rudder_state_[i].failed_last);
    }
}

void VesselSystem::signals(SignalTable& table) {
    if (has_set(def_)) {
        const SteeringDef& s = def_.steering;
        table.input("rudder", "rad", rudder_order_, -s.most_angle, s.most_angle);
        table.output("rudder_angle", "rad", rudder_);
        table.input("rudder_failed", "1", rudder_failed_, 0.0, 3.0);
    }
    if (has_shaft(def_)) {
        const SteeringDef& s = def_.steering;
        const double most = s.most_rps > 0.0 ? s.most_rps : 2.0 * s.rps;
        table.input("rps", "1/s", rps_order_, -most, most);
        table.output("shaft_rps", "1/s", rps_);
        table.input("rps_failed", "1", rps_failed_, 0.0, 3.0);
    }
    for (std::size_t i = 0; i < propulsor_.size(); ++i) {
        PropulsorState& s = propulsor_[i];
        const PropulsorDef& d = propulsors_[i].def();
        table.input(d.name, "1", s.order, -1.0, 1.0);
        table.output(d.name + "_thrust", "N", s.thrust);
        table.input(d.name + "_failed", "1", s.failed, 0.0, 3.0);
        if (has_losses_) table.output(d.name + "_loss", "1", s.loss);
        if (propulsors_[i].is_screw()) {
            table.output(d.name + "_rps", "1/s", s.rps);
            table.output(d.name + "_power", "W", s.power);
            table.output(d.name + "_torque", "N m", s.torque);
            if (d.controllable) {
                table.input(d.name + "_pitch", "1", s.pitch_order, -1.0, 1.0);
                table.output(d.name + "_set", "1", s.pitch);
            }
        }
        if (d.kind != PropulsorKind::azimuth && d.kind != PropulsorKind::cycloidal) continue;
        const double angle = d.most_angle > 0.0 ? d.most_angle : 6.283185307179586;
        table.input(d.name + "_angle", "rad", s.angle_order, -angle, angle);
        table.output(d.name + "_turned", "rad", s.angle);
    }
    for (std::size_t i = 0; i < rudder_state_.size(); ++i) {
        const RudderDef& d = rudders_[i].def();
        table.input(d.name, "rad", rudder_state_[i].order, -d.most_angle, d.most_angle);
        table.output(d.name + "_at", "rad", rudder_state_[i].angle);
        table.input(d.name + "_failed", "1", rudder_state_[i].failed, 0.0, 3.0);
    }
    bus_.signals(table);
    table.output("speed", "m/s", speed_);
    table.output("ground_speed", "m/s", ground_speed_);
    table.output("drift", "rad", drift_);
    table.output("turn_rate", "rad/s", turn_rate_);
    table.output("surge_force", "N", surge_);
    table.output("sway_force", "N", sway_);
    table.output("yaw_moment", "N m", yaw_);
    if (control_ != nullptr) control_->signals(table);
}

}  // namespace hawser::vessel
