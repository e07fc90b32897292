// SPDX-License-Identifier: Apache-2.0
#include "vessel/vessel_system.h"

#include <hawser/sea.h>
#include <hawser/world.h>

#include "base/dense.h"
#include "vessel/control_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::vessel {
namespace {

/// Steps of difference quotients [m/s, rad/s]. Forces are quadratic in the velocity, so that
/// central differences are exact to rounding.
constexpr double kSpeedStep = 1e-3, kTurnStep = 1e-5;

Mat3 cross_matrix(const Vec3& a) noexcept {
    Mat3 out;
    out << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return out;
}

/// Return the matrix that transforms the velocity of the centre of mass into the velocity of the
/// origin O of the ship, in the marine frame. @param arm  From the centre of mass to O [m].
Matrix6 to_origin(const Vec3& arm) noexcept {
    Matrix6 out = Matrix6::Identity();
    out.topRightCorner<3, 3>() = -cross_matrix(arm);
    return out;
}

/// Return the symmetric positive semi-definite matrix nearest to an added mass, as loads require.
/// @param radius  Scale of lengths [m].
Matrix6 part_for_loads(const Matrix6& a, double radius) {
    Wrench scale;
    scale << 1.0, 1.0, 1.0, radius, radius, radius;
    Matrix6 symmetric = 0.5 * (a + a.transpose());
    const Matrix6 scaled =
        scale.cwiseInverse().asDiagonal() * symmetric * scale.cwiseInverse().asDiagonal();
    const base::SymmetricEigen<6> eigen = base::symmetric_eigen(scaled);
    if (eigen.values.minCoeff() >= 0.0) return symmetric;
    const Wrench kept = eigen.values.cwiseMax(0.0);
    const Matrix6 out = eigen.vectors * kept.asDiagonal() * eigen.vectors.transpose();
    // Rounding must not make it indefinite again.
    Matrix6 back = scale.asDiagonal() * out * scale.asDiagonal();
    back = (0.5 * (back + back.transpose())).eval();
    back.diagonal() *= 1.0 + 1e-12;
    return back;
}

/// True if a term of the polynomial contains one of the letters.
bool names_variable(const HullPolynomial& polynomial, const char* letters) noexcept {
    return std::any_of(polynomial.terms.begin(), polynomial.terms.end(), [&](const HullTerm& t) {
        return t.of.find_first_of(letters) != std::string::npos;
    });
}

const SystemSignal* find_signal(const World& world, std::string_view name) noexcept {
    for (const SystemSignal& s : world.system_signals())
        if (s.system == "sea" && s.name == name) return &s;
    return nullptr;
}

double signal_or(const World& world, std::string_view name, double fallback) noexcept {
    const SystemSignal* s = find_signal(world, name);
    return s == nullptr ? fallback : *s->value;
}

/// Return the current at a depth below still water [m/s].
Vec3 current_at(const std::vector<SeaCurrent>& profile, double depth) noexcept {
    if (profile.empty()) return Vec3::Zero();
    const auto flow = [](const SeaCurrent& c) {
        return Vec3(c.speed * std::cos(c.direction), c.speed * std::sin(c.direction), 0.0);
    };
    if (depth <= profile.front().depth) return flow(profile.front());
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const SeaCurrent &a = profile[i - 1], &b = profile[i];
        if (depth <= b.depth) {
            const double x = (depth - a.depth) / (b.depth - a.depth);
            return (1.0 - x) * flow(a) + x * flow(b);
        }
    }
    return flow(profile.back());
}

/// Return the mean wind at a height divided by the wind at 10 m, by the profile of NPD
/// (hawser/sea.h) [1].
double wind_profile(double speed, double height) noexcept {
    const double c = 0.0573 * std::sqrt(1.0 + 0.15 * speed);
    return std::max(0.0, 1.0 + c * std::log(std::max(1.0, height) / 10.0));
}

}  // namespace

Matrix6 rigid_mass(double mass, const Mat3& inertia, const Vec3& origin) {
    // The body's axes at rest are (x, -y, -z) of the marine frame.
    const Vec3 flip(1.0, -1.0, -1.0);
    Matrix6 rigid = Matrix6::Zero();
    rigid.topLeftCorner<3, 3>() = mass * Mat3::Identity();
    rigid.bottomRightCorner<3, 3>() = flip.asDiagonal() * inertia * flip.asDiagonal();
    const Matrix6 back = to_origin(-flip.cwiseProduct(origin));
    return back.transpose() * rigid * back;
}

VesselSystem::VesselSystem(VesselDef def, double mass, Mat3 inertia, Surface surface,
                           std::vector<FedLine> lines)
    : def_(std::move(def)),
      mass_(mass),
      inertia_(std::move(inertia)),
      added_(part_for_loads(def_.added_mass, std::sqrt(inertia_.trace() / (3.0 * mass)))),
      balance_(Matrix6::Identity()),
      polynomial_(def_.polynomial, mass),
      surface_(std::move(surface)),
      has_losses_(has_losses(def_)),
      lines_(std::move(lines)),
      bus_(def_) {
    for (const PropulsorDef& p : def_.propulsors) propulsors_.emplace_back(p, def_.origin);
    for (const RudderDef& r : def_.rudders) {
        int behind = -1;
        for (std::size_t i = 0; i < def_.propulsors.size(); ++i)
            if (!r.behind.empty() && def_.propulsors[i].name == r.behind)
                behind = static_cast<int>(i);
        rudders_.emplace_back(r, def_.origin, behind);
    }
    propulsor_.resize(propulsors_.size());
    rudder_state_.resize(rudders_.size());
    thrusts_.assign(propulsors_.size(), 0.0);
    pushes_.assign(propulsors_.size() + rudders_.size(), Wrench::Zero());
    rps_ = rps_order_ = def_.steering.rps;
    if (def_.control.active) {
        const Matrix6 whole = rigid_mass(mass_, inertia_, def_.origin) + def_.added_mass;
        control_ = std::make_unique<Control>(def_, Vec3(whole(0, 0), whole(1, 1), whole(5, 5)));
    }
    if (added_ == def_.added_mass) return;
    const Matrix6 rigid = rigid_mass(mass_, inertia_, def_.origin);
    balance_ = (rigid + added_) * base::inverse(rigid + def_.added_mass);
    balanced_ = false;
}

bool VesselSystem::has_set(const VesselDef& def) noexcept {
    return has_shaft(def) || names_variable(def.polynomial, "dD");
}

bool VesselSystem::has_shaft(const VesselDef& def) noexcept {
    return def.mmg.diameter > 0.0 || def.son_nomoto.diameter > 0.0 ||
           names_variable(def.polynomial, "nN");
}

std::unique_ptr<System> VesselSystem::clone() const {
    return std::make_unique<VesselSystem>(def_, mass_, inertia_, surface_, lines_);
}

void VesselSystem::read_sea(const World& world, Vec3& current, Vec3& wind,
                            Motion& m) const noexcept {
    m.flow.density = def_.density;
    m.air = def_.wind.density;
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr) return;
    m.flow.density = sea->density;
    m.air = sea->wind.density;
    m.heave = still_water(world);
    current = signal_or(world, "current", 1.0) * current_at(sea->current, 0.5 * def_.draught);
    const double speed = signal_or(world, "wind", sea->wind.speed);
    const double to = signal_or(world, "wind_direction", sea->wind.direction);
    const double local_speed = speed * wind_profile(speed, def_.wind.height);
    wind = {local_speed * std::cos(to), local_speed * std::sin(to), 0.0};
}

VesselSystem::Motion VesselSystem::read_motion(const Prestep& now) noexcept {
    Motion m;
    const Pose pose = now.world.pose(def_.body);
    const Twist twist = now.world.velocity(def_.body);
    if (started_ == 0) {
        last_velocity_ = twist.linear;
        last_spin_ = twist.angular;
        started_ = 1;
    }
    // Velocities are half a step old, those of the step before one and a half steps: extrapolate.
    const Vec3 velocity = twist.linear + 0.5 * (twist.linear - last_velocity_);
    const Vec3 spin = twist.angular + 0.5 * (twist.angular - last_spin_);
    last_velocity_ = twist.linear;
    last_spin_ = twist.angular;

    const Mat3 body = pose.orientation.toRotationMatrix();
    const double level = std::hypot(body(0, 0), body(1, 0));
    const double c = level > 1e-9 ? body(0, 0) / level : 1.0;
    const double s = level > 1e-9 ? body(1, 0) / level : 0.0;
    m.axes << c, s, 0.0, s, -c, 0.0, 0.0, 0.0, -1.0;
    const Mat3 to = m.axes.transpose();
    const Vec3 arm = body * def_.origin;
    m.arm = to * arm;
    m.flow.roll = std::atan2(body(2, 1), body(2, 2));
    m.pitch = std::asin(std::clamp(body(2, 0), -1.0, 1.0));
    Vec3 current = Vec3::Zero(), wind = Vec3::Zero();
    read_sea(now.world, current, wind, m);
    m.heave -= pose.position.z() + arm.z();
    const Vec3 spin_m = to * spin;
    m.ground << to * velocity + spin_m.cross(m.arm), spin_m;
    m.centre << to * (velocity - current), spin_m;
    m.flow.motion << m.centre.head<3>() + spin_m.cross(m.arm), spin_m;
    m.flow.rudder = rudder_;
    m.flow.rps = rps_;
    m.wind = to * wind - m.ground.head<3>();
    return m;
}

void VesselSystem::compute_pushes(const Flow& flow) noexcept {
    const std::size_t count = propulsors_.size();
    for (std::size_t i = 0; i < count; ++i) {
        double along = 0.0;
        thrusts_[i] = propulsors_[i].open(propulsor_[i], flow, along).thrust;
        pushes_[i] = propulsors_[i].push(propulsor_[i], thrusts_[i]);
    }
    for (std::size_t i = 0; i < rudders_.size(); ++i) {
        double thrust = 0.0, diameter = 0.0;
        if (const int b = rudders_[i].behind(); b >= 0) {
            const auto j = static_cast<std::size_t>(b);
            thrust = thrusts_[j];
            diameter = propulsors_[j].def().propeller.diameter;
        }
        pushes_[count + i] = rudders_[i].force(rudder_state_[i], flow, thrust, diameter);
    }
}

Wrench VesselSystem::water_force(const Flow& flow, bool push) noexcept {
    Wrench out = -(def_.damping * flow.motion);
    out[0] += surge_force(def_.resistance, flow.u());
    out += cross_flow_force(def_.cross_flow, flow);
    out += current_force(def_.current, flow);
    out += polynomial_.force(flow);
    out += stern_force(def_.mmg, flow);
    out += stern_force(def_.son_nomoto, flow);
    if (push) compute_pushes(flow);
    for (const Wrench& p : pushes_) out += p;
    return out;
}

Wrench VesselSystem::wind_force(const Motion& m) const noexcept {
    Wrench out = Wrench::Zero();
    const WindLoad& w = def_.wind;
    if (w.ship == WindShip::none) return out;
    const double square = m.wind.x() * m.wind.x() + m.wind.y() * m.wind.y();
    const double from = std::atan2(-m.wind.y(), -m.wind.x());
    const WindCoefficients c = wind_coefficients(w, from);
    const double q = 0.5 * m.air * square;
    out[0] = q * c.x * w.frontal_area;
    out[1] = q * c.y * w.lateral_area;
    out[3] = q * c.k * w.lateral_area * w.lateral_area / w.length;
    out[5] = q * c.n * w.lateral_area * w.length;
    return out;
}

/// Return −C_A ν of the added mass.
Wrench VesselSystem::added_coriolis(const Motion& m) const noexcept {
    Wrench out = Wrench::Zero();
    const Matrix6& a = def_.added_mass;
    const Wrench& flow = m.flow.motion;
    switch (def_.coriolis) {
        case AddedCoriolis::none:
            break;
        case AddedCoriolis::planar:
            out[0] += a(1, 1) * flow[1] * flow[5];
            out[1] -= a(0, 0) * flow[0] * flow[5];
            break;
        case AddedCoriolis::full:
        case AddedCoriolis::at_rest: {
            const Wrench& of = def_.coriolis == AddedCoriolis::at_rest ? m.ground : flow;
            const Wrench momentum = 0.5 * (a * of + a.transpose() * of);
            const Vec3 v = flow.head<3>(), w = flow.tail<3>(), p = momentum.head<3>();
            out.head<3>() -= w.cross(p);
            out.tail<3>() -= v.cross(p) + w.cross(Vec3(momentum.tail<3>()));
        }
    }
    return out;
}

/// Return the load of a force τ, in the marine frame: P (τ − c) + c + A (Ω × ν), with P = M_s M⁻¹.
/// −c is the Coriolis force of the body's mass, which the world itself computes.
Wrench VesselSystem::marine_load(const Motion& m, const Wrench& force) const noexcept {
    const Vec3 turn{0.0, 0.0, m.flow.r()};
    const Vec3 linear = m.centre.head<3>(), angular = m.centre.tail<3>();
    Wrench turned;
    turned << turn.cross(linear), turn.cross(angular);
    const Vec3 own = mass_ * turn.cross(linear);
    Wrench centripetal;
    centripetal << own, -m.arm.cross(own);  // acts at the centre of mass
    Wrench out = force;
    if (!def_.polynomial.own_coriolis) out -= centripetal;
    if (!balanced_) out = (balance_ * out).eval();
    return out + centripetal + added_ * turned;
}

void VesselSystem::add_loads(Loads& loads, const Motion& m, const Wrench& force,
                             const Wrench& damping) const noexcept {
    Matrix6 b = to_origin(m.arm);
    Matrix6 turn = Matrix6::Zero();
    turn.topLeftCorner<3, 3>() = m.axes.transpose();
    turn.bottomRightCorner<3, 3>() = m.axes.transpose();
    b = (b * turn).eval();
    const Wrench at = b.transpose() * force;
    loads.add_force(def_.body, at.head<3>(), at.tail<3>());
    const auto in_world = [&](const Matrix6& of) {
        const Matrix6 out = b.transpose() * of * b;
        return Matrix6(0.5 * (out + out.transpose()));
    };
    loads.add_mass(def_.body, in_world(added_));
    loads.add_damping(def_.body, in_world(Matrix6(damping.asDiagonal())));
    if (!def_.restoring.isZero(0.0)) loads.add_stiffness(def_.body, in_world(def_.restoring));
}

namespace {

/// Send an event when a failure begins. @param last  Input: failure of the last step. Output: of
/// this step.
void report_failure(Prestep& now, BodyId body, double input, std::int32_t& last) noexcept {
    const auto mode = static_cast<std::int32_t>(failure_from_input(input));
    if (mode != 0 && mode != last) now.tell(EventKind::failure, body, input);
    last = mode;
}

}  // namespace

void VesselSystem::advance_steering(Prestep& now) noexcept {
    const SteeringDef& s = def_.steering;
    report_failure(now, def_.body, rudder_failed_, rudder_failed_last_);
    report_failure(now, def_.body, rps_failed_, rps_failed_last_);
    double target = std::clamp(rudder_order_, -s.most_angle, s.most_angle);
    const Failure jam = failure_from_input(rudder_failed_), stop = failure_from_input(rps_failed_);
    if (jam == Failure::stopped) target = rudder_;
    if (jam == Failure::kept) target = s.most_angle;
    if (jam == Failure::full) target = -s.most_angle;
    const bool limited = follow(rudder_, target, s.rate, s.lag, now.step);
    if (limited && steering_limited_ == 0) now.tell(EventKind::saturation, def_.body, s.rate);
    steering_limited_ = limited ? 1 : 0;
    double order = rps_order_;
    if (stop == Failure::stopped) order = 0.0;
    if (stop == Failure::kept) order = rps_;
    if (stop == Failure::full) order = s.most_rps > 0.0 ? s.most_rps : 2.0 * s.rps;
    rps_ = s.shaft_lag > 0.0 ? order - (order - rps_) * std::exp(-now.step / s.shaft_lag) : order;
}

void VesselSystem::advance_propulsors(Prestep& now, const Flow& flow) noexcept {
    for (std::size_t i = 0; i < propulsors_.size(); ++i) {
        PropulsorState& s = propulsor_[i];
        report_failure(now, def_.body, s.failed, s.failed_last);
        if (bus_.any()) bus_.demand(i, propulsors_[i].demand(s, flow, bus_.rated_power(i)));
    }
    if (bus_.any()) bus_.grant_power(now, def_.body);
    for (std::size_t i = 0; i < propulsors_.size(); ++i) {
        PropulsorState& s = propulsor_[i];
        Limit turn, power;
        const double granted = bus_.granted_power(i);
        const double demanded =
            granted < 1e300 ? propulsors_[i].demand(s, flow, bus_.rated_power(i)) : 0.0;
        propulsors_[i].advance(s, flow, now.step, granted, demanded, turn, power);
        if (turn.is_met) now.tell(EventKind::saturation, def_.body, turn.value);
        if (power.is_met) now.tell(EventKind::saturation, def_.body, power.value);
    }
}

void VesselSystem::update_losses(const Prestep& now, double density) noexcept {
    if (!has_losses_) return;
    surface_.update(now.world, now.time);
    for (std::size_t i = 0; i < propulsors_.size(); ++i) {
        PropulsorState& s = propulsor_[i];
        const PropulsorDef& d = propulsors_[i].def();
        s.thrust_fraction = s.torque_fraction = 1.0;
        if (d.ventilates) {
            const Vec3 hub = now.world.world_point(def_.body, d.point);
            const double depth = surface_.height(hub.x(), hub.y()) - hub.z();
            s.thrust_fraction = ventilated_thrust(2.0 * depth / propulsors_[i].diameter());
            s.torque_fraction = std::pow(s.thrust_fraction, 0.85);
        }
        s.thrust_fraction *= thrust_fraction_under_hull(propulsors_[i], s);
    }
    if (def_.thruster_losses) apply_race_losses(propulsors_, propulsor_, density);
    for (PropulsorState& s : propulsor_) s.loss = 1.0 - s.thrust_fraction;
}

void VesselSystem::advance(Prestep& now, const Flow& flow) noexcept {
    advance_steering(now);
    advance_propulsors(now, flow);
    for (std::size_t i = 0; i < rudders_.size(); ++i) {
        Limit rate;
        report_failure(now, def_.body, rudder_state_[i].failed, rudder_state_[i].failed_last);
        rudders_[i].advance(rudder_state_[i], now.step, rate);
        if (rate.is_met) now.tell(EventKind::saturation, def_.body, rate.value);
    }
}

Wrench VesselSystem::control(Prestep& now, const Motion& m) noexcept {
    Wrench out = Wrench::Zero();
    if (control_ == nullptr) return out;
    const Vec3 origin = now.world.world_point(def_.body, def_.origin);
    const Wrench wind = wind_force(m);
    ControlSense sense;
    sense.measured.planar_position = {origin.x(), -origin.y(),
                                      -std::atan2(m.axes(1, 0), m.axes(0, 0))};
    sense.measured.motion = {m.ground[0], m.ground[1], m.ground[5]};
    sense.surge = m.flow.u();
    sense.wind = {wind[0], wind[1], wind[5]};
    sense.lines = line_load(now.world, def_, lines_, m.axes, origin);
    if (now.world.alive(def_.control.target)) {
        sense.target = now.world.pose(def_.control.target).position;
        sense.target_motion = now.world.velocity(def_.control.target).linear;
    }
    const Vec3 direct = control_->step(
        now, sense,
        ControlledActuators{propulsor_, rudder_state_, rudder_order_, rps_order_, bus_});
    out << direct[0], direct[1], 0.0, 0.0, 0.0, direct[2];
    return out;
}

void VesselSystem::prestep(Prestep& now, Loads& loads) noexcept {
    const Motion m = read_motion(now);
    const Flow& flow = m.flow;
    update_losses(now, flow.density);
    const Wrench direct = control(now, m);
    const Wrench water = water_force(flow, true);
    Wrench damping = Wrench::Zero();
    // Propulsors and rudders depend on u, v, r alone: w, p, q go first and keep their forces.
    for (const int i : {2, 3, 4, 0, 1, 5}) {
        const bool push = i < 2 || i == 5;
        const double d = i < 3 ? kSpeedStep : kTurnStep;
        Flow less = flow, more = flow;
        less.motion[i] -= d;
        more.motion[i] += d;
        const double above = water_force(more, push)[i];
        damping[i] = std::max(0.0, (water_force(less, push)[i] - above) / (2.0 * d));
    }
    Wrench displacement = Wrench::Zero();
    displacement[2] = m.heave;
    displacement[3] = flow.roll;
    displacement[4] = m.pitch;
    Wrench force = marine_load(m, water + direct + wind_force(m) + added_coriolis(m) -
                                      Wrench(def_.restoring * displacement));
    force += damping.cwiseProduct(m.ground);
    add_loads(loads, m, force, damping);

    speed_ = std::hypot(flow.u(), flow.v());
    ground_speed_ = std::hypot(m.ground[0], m.ground[1]);
    drift_ = speed_ > 1e-9 ? std::atan2(-flow.v(), flow.u()) : 0.0;
    turn_rate_ = flow.r();
    surge_ = water[0];
    sway_ = water[1];
    yaw_ = water[5];
    advance(now, flow);
}

}  // namespace hawser::vessel
