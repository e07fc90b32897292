// SPDX-License-Identifier: Apache-2.0
/// Mariner, S175 and the Esso 190k tanker (hawser/vessel_ships.h).
#include "vessel/ships.h"

#include "base/number.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace hawser {
namespace {

using vessel::MainSizes;
using enum HullAxis;

constexpr double kDegree = std::numbers::pi / 180.0, kWaterDensity = 1025.0;

std::vector<HullTerm> mariner_terms() {
    std::vector<HullTerm> terms = {
        {x, "u", -184},  {x, "uu", -110},  {x, "uuu", -215},  {x, "vv", -899},   {x, "rr", 18},
        {x, "rv", 798},  {x, "dd", -95},   {x, "udd", -190},  {x, "vd", 93},     {x, "uvd", 93},
        {y, "v", -1160}, {y, "r", -499},   {y, "vvv", -8078}, {y, "vvr", 15356}, {y, "vu", -1160},
        {y, "ru", -499}, {y, "d", 278},    {y, "ddd", -90},   {y, "ud", 556},    {y, "uud", 278},
        {y, "vdd", -4},  {y, "vvd", 1190}, {y, "0", -4},      {y, "u", -8},      {y, "uu", -4},
        {n, "v", -264},  {n, "r", -166},   {n, "vvv", 1636},  {n, "vvr", -5483}, {n, "vu", -264},
        {n, "ru", -166}, {n, "d", -139},   {n, "ddd", 45},    {n, "ud", -278},   {n, "uud", -139},
        {n, "vdd", 13},  {n, "vvd", -489}, {n, "0", 3},       {n, "u", 6},       {n, "uu", 3}};
    for (HullTerm& t : terms) t.value *= 1e-5;
    return terms;
}

std::vector<HullTerm> s175_terms() {
    return {{x, "uu", -0.0004226},
            {x, "vr", -0.00311},
            {x, "rr", 0.0002},
            {x, "ff", -0.0002},
            {x, "vv", -0.00386},
            {y, "v", -0.0116},
            {y, "r", 0.00242},
            {y, "f", -0.000063},
            {y, "vvv", -0.109},
            {y, "rrr", 0.00177},
            {y, "vvr", 0.0214},
            {y, "vrr", -0.0405},
            {y, "vvf", 0.04605},
            {y, "vff", 0.00304},
            {y, "rrf", 0.009325},
            {y, "rff", -0.001368},
            {k, "v", 0.0003026},
            {k, "r", -0.000063},
            {k, "p", -7.5e-6},
            {k, "f", -2.1e-5},
            {k, "vvv", 0.002843},
            {k, "rrr", -4.62e-5},
            {k, "vvr", -0.000588},
            {k, "vrr", 0.0010565},
            {k, "vvf", -0.0012012},
            {k, "vff", -7.93e-5},
            {k, "rrf", -0.000243},
            {k, "rff", 3.569e-5},
            {k, "ur", 0.000238 * 0.0313},  // m_x l_x u r
            {n, "v", -0.0038545},
            {n, "r", -0.00222},
            {n, "p", 0.000213},
            {n, "f", -0.0001424},
            {n, "vvv", 0.001492},
            {n, "rrr", -0.00229},
            {n, "vvr", -0.0424},
            {n, "vrr", 0.00156},
            {n, "vvf", -0.019058},
            {n, "vff", -0.0053766},
            {n, "rrf", -0.0038592},
            {n, "rff", 0.0024195}};
}

void set_s175_stern(SonNomotoStern& s, double length) {
    s.diameter = 6.533;
    s.length = length;
    s.k0 = 0.527;
    s.k1 = -0.455;
    s.thrust_deduction = 0.175;
    s.wake = 0.184;
    s.wake_turn = 1.09;
    s.propeller_x = -0.526;
    s.rudder_area = 33.0376;
    s.aspect = 1.8219;
    s.wake_ratio = 0.921;
    s.slipstream = 0.631;
    s.gamma = 0.088;
    s.c_r = -0.156;
    s.c_rrr = -0.275;
    s.c_rrv = 1.96;
    s.drag_share = 0.71;
    s.hull_increase = 0.237;
    s.rudder_x = -0.5;
    s.rudder_z = 0.033;
    s.hull_x = -0.48;
}

/// Add the terms of value · c² · (variables in `more`), with the squared speed of the slipstream
/// c² = 0.605 u n + 38.2 n².
void add_slipstream(std::vector<HullTerm>& terms, HullAxis axis, double value, const char* more) {
    terms.push_back({axis, std::string("un") + more, 0.605 * value});
    terms.push_back({axis, std::string("nn") + more, 38.2 * value});
}

/// Add the terms of value · (L g_T), with the thrust L g_T = −0.00695 u² − 0.00063 L u n +
/// 0.0000354 L² |n| n.
void add_thrust(std::vector<HullTerm>& terms, HullAxis axis, double value, double length) {
    terms.push_back({axis, "uu", -0.00695 * value});
    terms.push_back({axis, "un", -0.00063 * length * value});
    terms.push_back({axis, "nN", 0.0000354 * length * length * value});
}

/// Return the terms of the Esso 190k tanker. @param z  Draught over the water depth under the keel.
std::vector<HullTerm> esso_terms(double length, double z) {
    std::vector<HullTerm> terms;
    const double a = 1.0 / length, b = a * a;
    const auto add = [&](HullAxis axis, const char* of, double value) {
        terms.push_back({axis, of, value});
    };
    add(x, "uu", a * (-0.0377 - 0.0061 * z));
    add(x, "vr", 2.020 + 0.387 * z);
    add(x, "vv", a * (0.3 + 0.0125 * z * z));
    add_slipstream(terms, x, -0.093 * a, "dd");
    add_slipstream(terms, x, 0.152 * a, "bd");
    add_thrust(terms, x, a * (1.0 - 0.22), length);
    const double deep = z >= 0.8 ? -0.85 * (1.0 - 0.8 / z) : 0.0;
    add(y, "uv", a * (-1.205 + deep * z));
    add(y, "Vv", a * (-2.4 - 1.5 * z));
    add_slipstream(terms, y, 0.208 * a, "d");
    add(y, "ur", -0.752 + 0.182 * z);
    add_slipstream(terms, y, a * (-2.16 - 0.191 * z), "BbD");
    add_thrust(terms, y, 0.04 * a, length);
    add(n, "uv", b * (-0.451 - 0.241 * z));
    add(n, "Vr", a * (-0.3 - 0.12 * z));
    add_slipstream(terms, n, -0.098 * b, "d");
    add(n, "ur", a * (-0.231 - 0.047 * z));
    add_slipstream(terms, n, b * (0.688 + 0.344 * z), "BbD");
    add_thrust(terms, n, -0.02 * b, length);
    return terms;
}

/// Return the speed at which X vanishes on a straight course. X = a u² + b u + c at constant
/// revolutions.
double esso_speed(double length, double z, double rps) {
    const double t = 1.0 - 0.22;
    const double a = -0.0377 - 0.0061 * z - 0.00695 * t, b = -0.00063 * length * rps * t;
    const double c = 0.0000354 * length * length * rps * rps * t;
    return (-b - std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

}  // namespace

PublishedShip mariner() {
    PublishedShip ship;
    VesselDef& v = ship.vessel;
    v.name = "mariner";
    ship.speed = 7.7175;
    MainSizes sizes{160.93, 23.17, 8.23};
    const double length = sizes.length, unit = 0.5 * kWaterDensity * std::pow(length, 3);
    const double centre = -0.023 * length;
    sizes.mass = 798e-5 * unit;
    const double yaw = 39.2e-5 * unit * length * length / sizes.mass - centre * centre;
    vessel::set_body(ship, sizes, 0.35 * sizes.beam, std::sqrt(yaw));
    v.origin = {-centre, 0.0, 0.0};
    v.added_mass(0, 0) = 42e-5 * unit;
    v.added_mass(1, 1) = 748e-5 * unit;
    v.added_mass(1, 5) = 9.354e-5 * unit * length;
    v.added_mass(5, 1) = -4.646e-5 * unit * length;
    v.added_mass(5, 5) = 43.8e-5 * unit * length * length;
    v.coriolis = AddedCoriolis::none;
    v.polynomial.own_coriolis = true;
    v.polynomial.terms = mariner_terms();
    v.polynomial.length = length;
    v.polynomial.area = length * length;
    v.polynomial.speed = ship.speed;
    v.polynomial.rudder_sign = -1.0;  // The source counts rudder angles to port.
    v.steering = {.most_angle = 40.0 * kDegree, .rate = 5.0 * kDegree, .lag = 1.0};
    vessel::set_default_stability(ship, sizes, true);
    return ship;
}

PublishedShip s175() {
    PublishedShip ship;
    VesselDef& v = ship.vessel;
    v.name = "s175";
    ship.speed = 8.37666;
    MainSizes sizes{175.0, 25.4, 8.5};
    const double length = sizes.length, unit = 0.5 * kWaterDensity * std::pow(length, 3);
    const double square = unit * length * length;
    sizes.mass = 0.00792 * unit;
    vessel::set_body(ship, sizes, std::sqrt(1.76e-5 * square / sizes.mass),
                     std::sqrt(4.56e-4 * square / sizes.mass));
    v.added_mass(0, 0) = 0.000238 * unit;
    v.added_mass(1, 1) = 0.007049 * unit;
    v.added_mass(1, 3) = v.added_mass(3, 1) = -0.007049 * 0.0313 * unit * length;
    v.added_mass(1, 5) = v.added_mass(5, 1) = 0.007049 * 0.05 * unit * length;
    v.added_mass(3, 3) = 3.4e-6 * square;
    v.added_mass(5, 5) = 4.19e-4 * square;
    v.coriolis = AddedCoriolis::planar;
    v.polynomial.terms = s175_terms();
    v.polynomial.length = length;
    v.polynomial.area = length * length;
    set_s175_stern(v.son_nomoto, length);
    v.steering = {
        .most_angle = 35.0 * kDegree, .rate = 5.0 * kDegree, .lag = 1.0, .rps = 80.0 / 60.0};
    vessel::set_default_stability(ship, sizes, false);
    constexpr double kGravity = 9.81, kDisplacedVolume = 21222.0, kMetacentricHeight = 0.3;
    v.restoring(3, 3) = kWaterDensity * kGravity * kDisplacedVolume * kMetacentricHeight;
    return ship;
}

PublishedShip esso_190k(double depth) {
    constexpr double kDraught = 18.46;
    if (!(depth > 1.05 * kDraught))
        throw DefError("ship 'esso_190k': depth: " + number(depth) +
                       " m; give more than 19.4 m, draught 18.46 m");
    PublishedShip ship;
    VesselDef& v = ship.vessel;
    v.name = "esso_190k";
    MainSizes sizes{304.8, 47.17, kDraught};
    const double length = sizes.length, z = kDraught / (depth - kDraught);
    constexpr double kPropellerSpeed = 80.0 / 60.0, kDisplacedVolume = 220000.0;
    ship.speed = esso_speed(length, z, kPropellerSpeed);
    sizes.mass = kWaterDensity * kDisplacedVolume;
    vessel::set_body(ship, sizes, 0.35 * sizes.beam, 0.25 * length);
    v.added_mass(0, 0) = (0.05 + 0.05 * z) * sizes.mass;
    v.added_mass(1, 1) = (1.02 + 0.387 * z) * sizes.mass;
    v.added_mass(5, 5) = (0.1232 + 0.0045 * z - 0.0625) * sizes.mass * length * length;
    v.coriolis = AddedCoriolis::none;
    v.polynomial.own_coriolis = true;
    v.polynomial.scale = HullScale::mass;
    v.polynomial.terms = esso_terms(length, z);
    v.polynomial.length = length;
    v.polynomial.rudder_sign = -1.0;
    v.steering = {.most_angle = 35.0 * kDegree,
                  .rate = 2.33 * kDegree,
                  .lag = 1.0,
                  .rps = kPropellerSpeed,
                  .shaft_lag = 50.0};
    vessel::set_default_stability(ship, sizes, true);
    return ship;
}

PublishedShip osv() {
    PublishedShip ship;
    VesselDef& v = ship.vessel;
    v.name = "osv";
    MainSizes sizes{83.0, 18.0, 5.0};
    const double length = sizes.length, beam = sizes.beam;
    sizes.mass = kWaterDensity * length * beam * sizes.draught * 0.65;
    vessel::set_body(ship, sizes, 0.35 * beam, 0.25 * length);
    ship.body.position = {-4.5, 0.0, 1.2};
    v.origin = {4.5, 0.0, -1.2};
    const auto set = [](Matrix6& m, int i, int j, double value) {
        m(i - 1, j - 1) = m(j - 1, i - 1) = value;
    };
    for (const auto& [ij, value] : {std::pair{11, 0.0006},
                                    {22, 0.0020},
                                    {33, 0.0083},
                                    {44, 0.0748},
                                    {55, 3.9875},
                                    {66, 1.2416},
                                    {24, 0.0031},
                                    {26, -0.0091},
                                    {35, 0.0907},
                                    {46, -0.1127}})
        set(v.added_mass, ij / 10, ij % 10, 1e9 * value);
    for (const auto& [ij, value] :
         {std::pair{33, 1.201803e7}, {44, 1.008569e8}, {55, 5.87455e9}, {35, 6.009017e6}})
        set(v.restoring, ij / 10, ij % 10, value);
    for (const auto& [ij, value] : {std::pair{22, 6.97689e4},
                                    {33, 5.05272e6},
                                    {44, 5.03691e7},
                                    {55, 3.63222e9},
                                    {66, 3.48524e9}})
        set(v.damping, ij / 10, ij % 10, value);
    v.coriolis = AddedCoriolis::full;
    v.resistance = {.curve = {}, .linear = 55362.0, .quadratic = 18131.22, .blend = 2.0};
    v.cross_flow = {.length = length, .beam = beam, .draught = sizes.draught, .end_strips = true};
    const auto propulsor = [&](const char* name, PropulsorKind kind, const Vec3& at, double most) {
        PropulsorDef p;
        p.name = name;
        p.kind = kind;
        p.point = v.origin + at;
        p.thrust = most;
        p.turn_rate = 0.3;
        v.propulsors.push_back(p);
    };
    propulsor("bow1", PropulsorKind::tunnel, {37.0, 0.0, 0.0}, 300e3);
    propulsor("bow2", PropulsorKind::tunnel, {35.0, 0.0, 0.0}, 300e3);
    // The source has 420 and 655 kN, with which full ahead turns the ship.
    propulsor("port", PropulsorKind::azimuth, {-41.5, 7.0, 0.0}, 537.5e3);
    propulsor("starboard", PropulsorKind::azimuth, {-41.5, -7.0, 0.0}, 537.5e3);
    return ship;
}

}  // namespace hawser
