// SPDX-License-Identifier: Apache-2.0
/// Gains and thrusters of the control of a vessel, its state and signals (control.h).
#include "vessel/control.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace hawser {

const char* to_string(ControlMode mode) noexcept {
    constexpr const char* kNames[] = {"off", "joystick", "heading", "position", "follow"};
    return kNames[static_cast<std::size_t>(mode)];
}

namespace vessel {
namespace {

constexpr double kControlPi = std::numbers::pi;
constexpr double kMaxCoordinate = 1e9;

/// Thrust of a propulsor at full order without inflow [N].
struct Bollard {
    double ahead = 0.0, astern = 0.0;
    double rps = 1.0;    ///< Revolutions over most_rps.
    double power = 0.0;  ///< Of a propeller, at its shaft [W].
};

Bollard bollard_pull_data(const PropulsorDef& p, double density) {
    Bollard out;
    if (!(p.propeller.diameter > 0.0)) {
        out.ahead = p.thrust * (1.0 - p.thrust_deduction);
        out.astern = p.thrust * p.astern;
        return out;
    }
    double rps = p.most_rps;
    if (p.most_power > 0.0)
        rps = std::min(rps, at_power(p.propeller, p.most_power, 0.0, density).rps);
    if (p.most_torque > 0.0) {
        const double full =
            propeller_force(p.propeller, p.propeller.pitch, rps, 0.0, density).torque;
        if (full > p.most_torque) rps *= std::sqrt(p.most_torque / full);
    }
    const double pitch = p.propeller.pitch;
    const PropellerForce full_ahead = propeller_force(p.propeller, pitch, rps, 0.0, density);
    out.ahead = full_ahead.thrust * (1.0 - p.thrust_deduction);
    out.power = std::max(0.0, 2.0 * kControlPi * rps * full_ahead.torque);
    out.astern = -propeller_force(p.propeller, pitch, -rps, 0.0, density).thrust;
    out.rps = rps / p.most_rps;
    return out;
}

/// Return the allowed sectors of an azimuth with forbidden zones or end stops.
std::vector<ThrustSector> allowed_sectors(const PropulsorDef& p,
                                          const std::vector<ControlZone>& zones) {
    std::vector<std::pair<double, double>> open;
    const bool stops = p.most_angle > 0.0 && p.most_angle < kControlPi;
    if (stops)
        open = {{-p.most_angle, p.most_angle}};
    else
        open = {{-kControlPi, kControlPi}};
    bool cut = stops;
    for (const ControlZone& z : zones) {
        if (z.propulsor != p.name) continue;
        cut = true;
        for (const double turn : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
            const double from = z.from + turn * 2.0 * kControlPi;
            const double to = z.to + turn * 2.0 * kControlPi;
            std::vector<std::pair<double, double>> left;
            for (const auto& [a, b] : open) {
                if (to <= a || from >= b) {
                    left.emplace_back(a, b);
                    continue;
                }
                if (from > a) left.emplace_back(a, from);
                if (to < b) left.emplace_back(to, b);
            }
            open = left;
        }
    }
    std::vector<ThrustSector> out;
    if (!cut) return out;
    for (const auto& [a, b] : open) {
        const int parts = b - a > kControlPi ? 2 : 1;
        for (int k = 0; k < parts; ++k)
            out.push_back({a + k * (b - a) / parts, (b - a) / parts, false});
    }
    // With end stops the propeller reverses for astern thrust.
    const std::size_t ahead = out.size();
    for (std::size_t k = 0; stops && p.astern > 0.0 && k < ahead; ++k)
        out.push_back({out[k].from + kControlPi, out[k].width, true});
    return out;
}

double length_of(const VesselDef& def) noexcept {
    for (const double length : {def.polynomial.terms.empty() ? 0.0 : def.polynomial.length,
                                def.cross_flow.length, def.wind.length})
        if (length > 0.0) return length;
    return 100.0;
}

}  // namespace

Control::Control(const VesselDef& def, const Vec3& mass)
    : def_(def), mass_(mass), length_(length_of(def)) {
    const VesselControl& c = def_.control;
    const Vec3 w = c.bandwidth;
    proportional_ = mass.cwiseProduct(w.cwiseProduct(w));
    derivative_ = 2.0 * c.damping * mass.cwiseProduct(w);
    integral_ = c.integral * w.cwiseProduct(proportional_);
    std::vector<AllocatedThruster> thrusters;
    for (const PropulsorDef& p : def_.propulsors) {
        const Bollard b = bollard_pull_data(p, def_.density);
        AllocatedThruster t;
        t.is_azimuth = p.kind == PropulsorKind::azimuth;
        t.x = p.point.x() - def_.origin.x();
        t.y = def_.origin.y() - p.point.y();
        t.axis = p.kind == PropulsorKind::tunnel ? 0.5 * kControlPi : 0.0;
        t.ahead = std::max(b.ahead, 0.0);
        t.astern = std::max(b.astern, 0.0);
        if (t.is_azimuth) t.cost = c.azimuth_cost;
        if (t.is_azimuth) t.sectors = allowed_sectors(p, c.zones);
        thrusters.push_back(std::move(t));
        rps_.push_back(b.rps);
        full_.push_back(b.power);
        for (const ConsumerDef& consumer : def_.power.consumers)
            if (consumer.name == p.name && !(p.propeller.diameter > 0.0))
                full_.back() = consumer.power;
    }
    allocation_ = Allocation(std::move(thrusters));
    largest_ = allocation_.largest_axis_forces();
    authority_ = allocation_.independent_axes();
    const std::size_t count = def_.propulsors.size();
    if (c.failures.empty()) {
        for (std::size_t i = 0; i < count; ++i) {
            failures_.emplace_back(count, std::uint8_t{0});
            failures_.back()[i] = 1;
        }
    }
    for (const ControlFailure& f : c.failures) {
        failures_.emplace_back(count, std::uint8_t{0});
        for (std::size_t i = 0; i < count; ++i)
            if (std::find(f.propulsors.begin(), f.propulsors.end(), def_.propulsors[i].name) !=
                f.propulsors.end())
                failures_.back()[i] = 1;
    }
    present_thrust_.resize(count);
    thrusts_.assign(count, 0.0);
    spare_.assign(count, -1);
    sectors_.assign(count, -1);
    shortfalls_.assign(failures_.size(), 0.0);
    available_.assign(count, 1.0);
    remaining_.assign(count, 1.0);
    if (!def_.power.boards.empty()) powered_.assign(count, 1.0);
    const Vec3 damping(def_.damping(0, 0), def_.damping(1, 1), def_.damping(5, 5));
    observer_ = Observer(mass, damping, c.wave_period);
    mode_input_ = static_cast<double>(c.mode);
}

void Control::visit(StateVisitor& v) {
    for (double* x :
         {&mode_input_, &x_order_, &y_order_, &heading_order_, &speed_order_, &stick_x_, &stick_y_,
          &stick_n_, &steer_sum_, &speed_sum_, &active_mode_, &heading_, &worst_, &worst_failure_})
        v.visit(*x);
    for (std::int32_t* x : {&started_, &arrived_, &critical_, &next_failure_}) v.visit(*x);
    for (Vec3* x : {&last_orders_, &desired_, &error_, &sum_, &offset_, &feed_, &acting_, &mean_,
                    &offsets_, &demand_, &allocated_})
        v.visit(std::span<double>(x->data(), 3));
    observer_.visit(v);
    for (std::int32_t& s : sectors_) v.visit(s);
    for (double& s : shortfalls_) v.visit(s);
    for (double& p : powered_) v.visit(p);
}

void Control::check(StateRules& rules) const {
    rules.flag(started_, "whether the control has started is no flag");
    rules.flag(arrived_, "whether the vessel is at its order is no flag");
    rules.flag(critical_, "whether a failure is critical is no flag");
    rules.range(active_mode_, 0.0, kControlModes - 1.0, "the mode of control is out of range");
    rules.range(next_failure_, 0.0, std::max(0.0, static_cast<double>(failures_.size()) - 1.0),
                "the failure to analyse is out of range");
    for (std::size_t i = 0; i < sectors_.size(); ++i)
        rules.range(sectors_[i], -1.0,
                    static_cast<double>(allocation_.thrusters()[i].sectors.size()) - 1.0,
                    "the sector of an azimuth is out of range");
    for (const double p : powered_)
        rules.range(p, 0.0, 1.0, "the fraction of a thruster's power is out of range");
    for (const Vec3* vector :
         {&desired_, &last_orders_, &offset_, &observer_.low_frequency_motion().planar_position})
        for (const double x : *vector)
            rules.range(x, -kMaxCoordinate, kMaxCoordinate,
                        "an order of the control is out of range");
}

const std::vector<std::string>& Control::signal_names() {
    static const std::vector<std::string> kNames{
        "mode",           "x_order",     "y_order",
        "heading_order",  "speed_order", "joystick_x",
        "joystick_y",     "joystick_n",  "mode_now",
        "heading",        "offset_x",    "offset_y",
        "offset_heading", "demand_x",    "demand_y",
        "demand_n",       "allocated_x", "allocated_y",
        "allocated_n",    "consequence", "consequence_failure"};
    return kNames;
}

void Control::signals(SignalTable& table) {
    table.input("mode", "1", mode_input_, 0.0, kControlModes - 1.0);
    table.input("x_order", "m", x_order_, -1e8, 1e8);
    table.input("y_order", "m", y_order_, -1e8, 1e8);
    table.input("heading_order", "rad", heading_order_, -100.0, 100.0);
    table.input("speed_order", "m/s", speed_order_, 0.0, 50.0);
    table.input("joystick_x", "1", stick_x_, -1.0, 1.0);
    table.input("joystick_y", "1", stick_y_, -1.0, 1.0);
    table.input("joystick_n", "1", stick_n_, -1.0, 1.0);
    table.output("mode_now", "1", active_mode_);
    table.output("heading", "rad", heading_);
    table.output("offset_x", "m", offsets_[0]);
    table.output("offset_y", "m", offsets_[1]);
    table.output("offset_heading", "rad", offsets_[2]);
    table.output("demand_x", "N", demand_[0]);
    table.output("demand_y", "N", demand_[1]);
    table.output("demand_n", "N m", demand_[2]);
    table.output("allocated_x", "N", allocated_[0]);
    table.output("allocated_y", "N", allocated_[1]);
    table.output("allocated_n", "N m", allocated_[2]);
    table.output("consequence", "1", worst_);
    table.output("consequence_failure", "1", worst_failure_);
}

}  // namespace vessel
}  // namespace hawser
