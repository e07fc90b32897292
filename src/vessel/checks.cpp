// SPDX-License-Identifier: Apache-2.0
#include "vessel/checks.h"

#include <hawser/sea.h>
#include <hawser/world.h>

#include "base/dense.h"
#include "base/number.h"
#include "vessel/control_lines.h"
#include "vessel/power.h"
#include "vessel/vessel_system.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::vessel {
namespace {

constexpr double kMaxLength = 1e4, kMaxForce = 1e15, kMaxMass = 1e18, kMaxSpeed = 1e3;

/// Check the fields of one definition.
class VesselFields {
  public:
    explicit VesselFields(const std::string& name) : name_(name) {}

    void positive(const std::string& field, double value, double most) const {
        if (!(value > 0.0 && value <= most))
            fail(field, number(value) + "; give a number above 0 and at most " + number(most));
    }
    void from(const std::string& field, double value, double least, double most) const {
        if (!(value >= least && value <= most))
            fail(field,
                 number(value) + "; give a number from " + number(least) + " to " + number(most));
    }
    void point(const std::string& field, const Vec3& p) const {
        if (!p.allFinite() || p.norm() > kMaxLength) fail(field, "give a point within 10 km");
    }
    [[noreturn]] void fail(const std::string& field, const std::string& why) const {
        throw DefError("vessel '" + name_ + "': " + field + ": " + why);
    }

  private:
    const std::string& name_;
};

std::string at(const char* list, std::size_t i, const char* field) {
    return std::string(list) + "/" + std::to_string(i) + "/" + field;
}

void check_matrices(const VesselFields& f, const World& world, const VesselDef& def) {
    for (const auto& [field, matrix] :
         {std::pair<const char*, const Matrix6*>{"added_mass", &def.added_mass},
          {"damping", &def.damping},
          {"restoring", &def.restoring}})
        if (!matrix->allFinite() || matrix->cwiseAbs().maxCoeff() > kMaxMass)
            f.fail(field, "give finite numbers up to 1e18");
    const auto least = [](const Matrix6& m) {
        return base::symmetric_eigenvalues(Matrix6(0.5 * (m + m.transpose()))).minCoeff();
    };
    const BodyDef& body = world.body_def(def.body);
    if (!(least(rigid_mass(body.mass, body.inertia, def.origin) + def.added_mass) > 0.0))
        f.fail("added_mass", "with the mass of the body it is not positive definite");
    const Matrix6& g = def.restoring;
    if (g != g.transpose()) f.fail("restoring", "give a symmetric matrix");
    if (least(g) < -1e-9 * g.cwiseAbs().maxCoeff())
        f.fail("restoring", "it has a negative eigenvalue");
    for (const int i : {0, 1, 5})
        if (!g.row(i).isZero(0.0))
            f.fail("restoring", "rows of surge, sway and yaw are 0: nothing restores them");
}

void check_polynomial(const VesselFields& f, const HullPolynomial& p) {
    if (p.terms.empty()) return;
    f.positive("polynomial/length", p.length, kMaxLength);
    if (p.scale == HullScale::speed) f.positive("polynomial/area", p.area, 1e8);
    f.from("polynomial/speed", p.speed, 0.0, kMaxSpeed);
    f.from("polynomial/most_turn", p.most_turn, 0.1, 100.0);
    for (std::size_t i = 0; i < p.terms.size(); ++i) {
        const HullTerm& t = p.terms[i];
        const std::string field = at("polynomial/terms", i, "of");
        if (!std::isfinite(t.value) || std::abs(t.value) > 1e12)
            f.fail(at("polynomial/terms", i, "value"), "give a finite number up to 1e12");
        if (t.of.empty() || t.of.size() > kMaxPowers)
            f.fail(field, "give 1 to " + std::to_string(kMaxPowers) + " letters, or 0");
        if (t.of == "0") continue;
        for (const char letter : t.of) {
            if (variable_of(letter) < 0)
                f.fail(field, "'" + t.of + "' has the letter '" + letter +
                                  "'; give some of u v r p f d n b and V R D N B");
            const bool revolutions = letter == 'n' || letter == 'N';
            if (revolutions && p.scale == HullScale::speed)
                f.fail(field, "'" + t.of + "': revolutions are a variable of the scale mass alone");
        }
    }
}

void check_current(const VesselFields& f, const VesselDef& def) {
    const CurrentLoad& c = def.current;
    if (c.points.empty()) return;
    f.positive("current/length", c.length, kMaxLength);
    f.positive("current/draught", c.draught, kMaxLength);
    if (c.points.size() < 2) f.fail("current/points", "give two points or more");
    for (std::size_t i = 0; i < c.points.size(); ++i) {
        const CurrentPoint& p = c.points[i];
        f.from(at("current/points", i, "angle"), p.angle, 0.0, 3.15);
        if (!(std::abs(p.x) <= 100.0 && std::abs(p.y) <= 100.0 && std::abs(p.n) <= 100.0))
            f.fail(at("current/points", i, "x"), "give coefficients up to 100");
        if (i > 0 && !(p.angle > c.points[i - 1].angle))
            f.fail(at("current/points", i, "angle"), "angles have to ascend");
    }
    if (def.cross_flow.length > 0.0 || !def.resistance.curve.empty() ||
        def.resistance.quadratic > 0.0)
        f.fail("current", "cross_flow and resistance count its load twice; leave them out");
}

void check_hull(const VesselFields& f, const VesselDef& def) {
    const HullResistance& r = def.resistance;
    for (std::size_t i = 0; i < r.curve.size(); ++i) {
        f.from(at("resistance/curve", i, "speed"), r.curve[i].speed, 0.0, kMaxSpeed);
        f.from(at("resistance/curve", i, "resistance"), r.curve[i].resistance, 0.0, kMaxForce);
        if (i > 0 && !(r.curve[i].speed > r.curve[i - 1].speed))
            f.fail(at("resistance/curve", i, "speed"), "speeds have to ascend");
    }
    if (!r.curve.empty() && r.curve.front().speed != 0.0)
        f.fail("resistance/curve", "give the first point at speed 0");
    if (r.curve.size() == 1) f.fail("resistance/curve", "give two points or more");
    f.from("resistance/linear", r.linear, 0.0, kMaxForce);
    f.from("resistance/quadratic", r.quadratic, 0.0, kMaxForce);
    f.positive("resistance/blend", r.blend, kMaxSpeed);
    const CrossFlow& c = def.cross_flow;
    f.from("cross_flow/length", c.length, 0.0, kMaxLength);
    if (c.length > 0.0) {
        f.positive("cross_flow/beam", c.beam, kMaxLength);
        f.positive("cross_flow/draught", c.draught, kMaxLength);
        f.from("cross_flow/drag", c.drag, 0.0, 10.0);
        f.from("cross_flow/strips", c.strips, 1.0, 1000.0);
    }
    check_polynomial(f, def.polynomial);
    check_current(f, def);
    const WindLoad& w = def.wind;
    if (w.ship == WindShip::none) return;
    f.from("wind/frontal_area", w.frontal_area, 0.0, 1e6);
    f.positive("wind/lateral_area", w.lateral_area, 1e6);
    f.positive("wind/length", w.length, kMaxLength);
    f.from("wind/centre", w.centre, -kMaxLength, kMaxLength);
    f.from("wind/height", w.height, 0.0, kMaxLength);
    f.positive("wind/density", w.density, 1e3);
}

void check_stern(const VesselFields& f, const VesselDef& def) {
    const auto finite = [&](const char* field, std::initializer_list<double> values) {
        for (const double x : values)
            if (!(std::abs(x) <= 1e6)) f.fail(field, "give finite coefficients");
    };
    const MmgStern& m = def.mmg;
    f.from("mmg/diameter", m.diameter, 0.0, 100.0);
    if (m.diameter > 0.0) {
        f.positive("mmg/length", m.length, kMaxLength);
        f.positive("mmg/rudder_area", m.rudder_area, 1e5);
        f.from("mmg/height_share", m.height_share, 0.0, 1.0);
        f.from("mmg/wake", m.wake, 0.0, 0.9);
        finite("mmg",
               {m.k0, m.k1, m.k2, m.thrust_deduction, m.wake_port, m.wake_star, m.propeller_x,
                m.steering_deduction, m.hull_increase, m.hull_x, m.rudder_x, m.wake_ratio,
                m.slipstream, m.lift_slope, m.inflow_x, m.straight_port, m.straight_star});
    }
    const SonNomotoStern& s = def.son_nomoto;
    f.from("son_nomoto/diameter", s.diameter, 0.0, 100.0);
    if (s.diameter > 0.0) {
        f.positive("son_nomoto/length", s.length, kMaxLength);
        f.positive("son_nomoto/rudder_area", s.rudder_area, 1e5);
        f.positive("son_nomoto/aspect", s.aspect, 100.0);
        finite("son_nomoto", {s.k0, s.k1, s.thrust_deduction, s.wake, s.wake_turn, s.propeller_x,
                              s.wake_ratio, s.slipstream, s.gamma, s.c_r, s.c_rrr, s.c_rrv,
                              s.drag_share, s.hull_increase, s.rudder_x, s.rudder_z, s.hull_x});
    }
    if (!VesselSystem::has_set(def)) return;
    const SteeringDef& g = def.steering;
    f.positive("steering/most_angle", g.most_angle, 1.6);
    f.positive("steering/rate", g.rate, 10.0);
    f.from("steering/lag", g.lag, 0.0, 1e4);
    f.from("steering/rps", g.rps, 0.0, 1e3);
    f.from("steering/most_rps", g.most_rps, 0.0, 1e3);
    if (g.most_rps > 0.0 && g.rps > g.most_rps)
        f.fail("steering/rps", number(g.rps) + " is above most_rps " + number(g.most_rps));
    f.from("steering/shaft_lag", g.shaft_lag, 0.0, 1e5);
}

void check_propulsor(const VesselFields& f, const PropulsorDef& p, std::size_t i) {
    const auto field = [&](const char* name) { return at("propulsors", i, name); };
    f.point(field("point"), p.point);
    f.from(field("ramp"), p.ramp, 0.0, 1e4);
    f.from(field("astern"), p.astern, 0.0, 1.0);
    f.from(field("lost_at"), p.lost_at, 0.0, kMaxSpeed);
    f.positive(field("turn_rate"), p.turn_rate, 100.0);
    f.from(field("most_angle"), p.most_angle, 0.0, 3.15);
    f.from(field("propeller/diameter"), p.propeller.diameter, 0.0, 100.0);
    f.from(field("diameter"), p.diameter, 0.0, 100.0);
    f.from(field("hull_loss"), p.hull_loss, 0.0, 1.0);
    if (p.ventilates && !(p.diameter > 0.0 || p.propeller.diameter > 0.0))
        f.fail(field("diameter"), "ventilation needs the diameter");
    if (p.kind == PropulsorKind::cycloidal && p.propeller.diameter > 0.0)
        f.fail(field("propeller"), "a cycloidal propeller is ideal; give thrust");
    if (!(p.propeller.diameter > 0.0)) {
        f.positive(field("thrust"), p.thrust, kMaxForce);
        if (p.controllable) f.fail(field("controllable"), "an ideal propulsor has no pitch");
        return;
    }
    f.positive(field("most_rps"), p.most_rps, 1e3);
    f.from(field("propeller/pitch"), p.propeller.pitch, 0.1, 3.0);
    f.from(field("propeller/area"), p.propeller.area, 0.1, 2.0);
    f.from(field("propeller/blades"), p.propeller.blades, 2.0, 10.0);
    f.from(field("wake"), p.wake, 0.0, 0.9);
    f.from(field("thrust_deduction"), p.thrust_deduction, 0.0, 0.9);
    f.from(field("shaft_inertia"), p.shaft_inertia, 0.0, kMaxMass);
    f.positive(field("response"), p.response, 1e4);
    f.from(field("most_torque"), p.most_torque, 0.0, kMaxForce);
    f.from(field("most_power"), p.most_power, 0.0, kMaxForce);
    f.from(field("pitch_time"), p.pitch_time, 0.0, 1e4);
    if ((p.most_torque > 0.0 || p.most_power > 0.0) && !(p.shaft_inertia > 0.0))
        f.fail(field("shaft_inertia"), "limits of torque and power need the inertia of the shaft");
}

void check_rudder(const VesselFields& f, const VesselDef& def, std::size_t i) {
    const RudderDef& r = def.rudders[i];
    const auto field = [&](const char* name) { return at("rudders", i, name); };
    f.point(field("point"), r.point);
    f.positive(field("area"), r.area, 1e5);
    f.positive(field("aspect"), r.aspect, 100.0);
    f.from(field("covered"), r.covered, 0.0, 1.0);
    f.from(field("slipstream"), r.slipstream, 0.0, 1.0);
    f.from(field("wake"), r.wake, 0.0, 0.9);
    f.from(field("hull_increase"), r.hull_increase, 0.0, 2.0);
    f.positive(field("stall"), r.stall, 1.5);
    f.positive(field("most_angle"), r.most_angle, 1.6);
    f.positive(field("rate"), r.rate, 10.0);
    if (r.behind.empty()) return;
    std::string known;
    for (const PropulsorDef& p : def.propulsors) {
        if (p.name == r.behind) return;
        known.append(known.empty() ? "" : ", ").append(p.name);
    }
    f.fail(field("behind"), "there is no propulsor '" + r.behind + "'; " +
                                (known.empty() ? "the vessel has none" : "give one of " + known));
}

/// Check that the names of signals differ, because all of them belong to one list.
void check_names(const VesselFields& f, const VesselDef& def) {
    std::vector<std::string> used_names;
    if (VesselSystem::has_set(def)) used_names.emplace_back("rudder");
    if (VesselSystem::has_shaft(def)) used_names.emplace_back("rps");
    const auto take = [&](const std::string& name, const std::string& field) {
        if (name.empty()) f.fail(field, "give a name");
        if (name.find('.') != std::string::npos) f.fail(field, "a name has no dot");
        if (std::find(used_names.begin(), used_names.end(), name) != used_names.end())
            f.fail(field, "the name '" + name + "' is taken");
        used_names.push_back(name);
    };
    for (std::size_t i = 0; i < def.propulsors.size(); ++i)
        take(def.propulsors[i].name, at("propulsors", i, "name"));
    for (std::size_t i = 0; i < def.rudders.size(); ++i)
        take(def.rudders[i].name, at("rudders", i, "name"));
}

bool has_hull(const World& world, const VesselDef& def) {
    if (!def.polynomial.terms.empty() || def.cross_flow.length > 0.0 ||
        !def.current.points.empty() || !def.resistance.curve.empty() ||
        def.resistance.quadratic > 0.0 || def.resistance.linear > 0.0 || !def.damping.isZero(0.0))
        return true;
    const SeaDef* sea = find_sea(world);
    return sea != nullptr && std::any_of(sea->hulls.begin(), sea->hulls.end(),
                                         [&](const WaterHull& h) { return h.body == def.body; });
}

}  // namespace

void check_vessel(const World& world, const VesselDef& def) {
    const VesselFields f(def.name);
    if (def.name.empty()) f.fail("name", "give a name");
    if (!world.alive(def.body)) f.fail("body", "there is no such body");
    if (world.body_def(def.body).kind != BodyKind::rigid)
        f.fail("body", "a vessel needs a rigid body");
    if (const VesselDef* other = find_vessel(world, def.body); other != nullptr)
        f.fail("body", "it is the body of the vessel '" + other->name + "' already");
    f.point("origin", def.origin);
    f.from("draught", def.draught, 0.0, kMaxLength);
    f.positive("density", def.density, 1e5);
    check_matrices(f, world, def);
    check_hull(f, def);
    check_stern(f, def);
    check_names(f, def);
    for (std::size_t i = 0; i < def.propulsors.size(); ++i)
        check_propulsor(f, def.propulsors[i], i);
    for (std::size_t i = 0; i < def.rudders.size(); ++i) check_rudder(f, def, i);
    check_power(def);
    if (!has_hull(world, def))
        f.fail(!def.propulsors.empty() ? "propulsors" : "body",
               "the body has no hull: give polynomial, cross_flow, resistance or damping, or a "
               "hull in the sea");
    check_control(world, def);
    if (def.dp_capability) check_dp_ship(*def.dp_capability);
}

}  // namespace hawser::vessel
