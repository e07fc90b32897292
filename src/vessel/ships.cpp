// SPDX-License-Identifier: Apache-2.0
#include "vessel/ships.h"

#include <cmath>
#include <numbers>
#include <string>

namespace hawser {
namespace vessel {

void set_body(PublishedShip& ship, const MainSizes& sizes, double roll_radius, double yaw_radius) {
    BodyDef& b = ship.body;
    b.name = ship.vessel.name;
    b.mass = sizes.mass;
    const double roll = sizes.mass * roll_radius * roll_radius;
    const double yaw = sizes.mass * yaw_radius * yaw_radius;
    b.inertia = Vec3(roll, yaw, yaw).asDiagonal();
    b.gravity = false;
    b.half_size = {0.5 * sizes.length, 0.5 * sizes.beam, 0.75 * sizes.draught};
    b.velocity = {ship.speed, 0.0, 0.0};
    ship.length = sizes.length;
    ship.vessel.draught = sizes.draught;
}

void set_default_stability(PublishedShip& ship, const MainSizes& s, bool roll) {
    constexpr double kGravity = 9.81, kWaterplaneCoefficient = 0.85, kMetacentreOverBeam = 0.05,
                     kHeaveDampingRatio = 0.2;
    Matrix6& g = ship.vessel.restoring;
    Matrix6& d = ship.vessel.damping;
    const double plane = kWaterplaneCoefficient * s.length * s.beam;
    g(2, 2) = s.density * kGravity * plane;
    if (roll) g(3, 3) = s.mass * kGravity * kMetacentreOverBeam * s.beam;
    g(4, 4) = s.density * kGravity * plane * s.length * s.length / 14.0;
    // Use the rigid-body mass, because added masses of these motions are not published.
    d(2, 2) = 2.0 * kHeaveDampingRatio * std::sqrt(g(2, 2) * s.mass);
    if (roll) d(3, 3) = 2.0 * kHeaveDampingRatio * std::sqrt(g(3, 3) * ship.body.inertia(0, 0));
    d(4, 4) = 2.0 * kHeaveDampingRatio * std::sqrt(g(4, 4) * ship.body.inertia(1, 1));
}

}  // namespace vessel

namespace {

using vessel::MainSizes;

constexpr double kDegreeOf = std::numbers::pi / 180.0;

struct KvlccSizes {
    const char* name;
    MainSizes sizes;
    double volume, centre, diameter, rudder_height, rudder_area, wake, speed, rps;
};
constexpr KvlccSizes kKvlccScales[] = {
    {"kvlcc2_l7", {7.0, 1.27, 0.46}, 3.27, 0.25, 0.216, 0.345, 0.0539, 0.40, 1.179, 11.8516},
    {"kvlcc2_l3", {2.902, 0.527, 0.189}, 0.235, 0.102, 0.090, 0.144, 0.00928, 0.40, 0.76, 18.1946},
    {"kvlcc2", {320.0, 58.0, 20.8}, 312600.0, 11.2, 9.86, 15.8, 112.5, 0.35, 7.9739, 1.77851}};

/// Return the revolutions at which thrust equals resistance on a straight course, by bisection.
double self_propulsion(const VesselDef& v, double speed) {
    const double resistance = 0.022 * 0.5 * v.density * v.polynomial.area * speed * speed;
    double low = 0.0, high = 10.0 * speed / v.mmg.diameter;
    for (int i = 0; i < 80; ++i) {
        const double n = 0.5 * (low + high), d = v.mmg.diameter;
        const double flow = speed * (1.0 - v.mmg.wake);
        const double thrust =
            (1.0 - v.mmg.thrust_deduction) * v.density * d * d *
            (v.mmg.k0 * n * n * d * d + v.mmg.k1 * n * d * flow + v.mmg.k2 * flow * flow);
        (thrust < resistance ? low : high) = n;
    }
    return high;
}

void set_kvlcc_stern(MmgStern& m, const KvlccSizes& k) {
    m.diameter = k.diameter;
    m.length = k.sizes.length;
    m.k0 = 0.2931;
    m.k1 = -0.2753;
    m.k2 = -0.1385;
    m.thrust_deduction = 0.22;
    m.wake = k.wake;
    m.wake_port = 1.6;
    m.wake_star = 1.1;
    m.propeller_x = -0.48;
    m.rudder_area = k.rudder_area;
    m.height_share = k.diameter / k.rudder_height;
    m.steering_deduction = 0.387;
    m.hull_increase = 0.312;
    m.hull_x = -0.464;
    m.rudder_x = -0.5;
    m.wake_ratio = 1.09;
    m.slipstream = 0.50;
    m.lift_slope = 2.747;
    m.inflow_x = -0.710;
    m.straight_port = 0.395;
    m.straight_star = 0.640;
}

}  // namespace

PublishedShip kvlcc2(KvlccScale scale) {
    const KvlccSizes& from = kKvlccScales[static_cast<std::size_t>(scale)];
    PublishedShip ship;
    VesselDef& v = ship.vessel;
    v.name = from.name;
    ship.speed = from.speed;
    MainSizes sizes = from.sizes;
    sizes.mass = sizes.density * from.volume;
    const double length = sizes.length;
    vessel::set_body(ship, sizes, 0.35 * sizes.beam, 0.25 * length);
    v.origin = {-from.centre, 0.0, 0.0};
    const double unit = 0.5 * sizes.density * length * length * sizes.draught;
    v.added_mass(0, 0) = 0.022 * unit;
    v.added_mass(1, 1) = 0.223 * unit;
    v.added_mass(5, 5) = 0.011 * unit * length * length;
    v.coriolis = AddedCoriolis::planar;
    v.polynomial.length = length;
    v.polynomial.area = length * sizes.draught;
    using enum HullAxis;
    v.polynomial.terms = {{x, "0", -0.022},   {x, "vv", -0.040},  {x, "vr", 0.002},
                          {x, "rr", 0.011},   {x, "vvvv", 0.771}, {y, "v", -0.315},
                          {y, "r", 0.083},    {y, "vvv", -1.607}, {y, "vvr", 0.379},
                          {y, "vrr", -0.391}, {y, "rrr", 0.008},  {n, "v", -0.137},
                          {n, "r", -0.049},   {n, "vvv", -0.030}, {n, "vvr", -0.294},
                          {n, "vrr", 0.055},  {n, "rrr", -0.013}};
    set_kvlcc_stern(v.mmg, from);
    // Steering gear of 2.34 degrees a second at full scale, by Froude in models.
    v.steering.rate = 2.34 * kDegreeOf * std::sqrt(320.0 / length);
    v.steering.rps = self_propulsion(v, ship.speed);
    vessel::set_default_stability(ship, sizes, true);
    return ship;
}

PublishedShip published_ship(std::string_view name, double depth) {
    if (name == "kvlcc2") return kvlcc2(KvlccScale::full);
    if (name == "kvlcc2_l7") return kvlcc2(KvlccScale::l7);
    if (name == "kvlcc2_l3") return kvlcc2(KvlccScale::l3);
    if (name == "mariner") return mariner();
    if (name == "s175") return s175();
    if (name == "esso_190k") return esso_190k(depth);
    if (name == "osv") return osv();
    std::string known;
    for (const char* each : kPublishedShips)
        known += (known.empty() ? "" : ", ") + std::string(each);
    throw DefError("ship: there is no ship '" + std::string(name) + "'; give one of " + known);
}

}  // namespace hawser
