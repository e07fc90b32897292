// SPDX-License-Identifier: Apache-2.0
/// Loads and thrust of DNV-ST-0111 Level 1 (hawser/dp_capability.h).
#include <hawser/dp_capability.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace hawser {
namespace {

constexpr double kDpPi = std::numbers::pi;
constexpr double kDpAir = 1.226, kDpWater = 1026.0, kDpGravity = 9.81;
constexpr double kDpMargin = 1.25;  ///< Dynamic allowance on the sum of loads.
/// Ratio of the peak period to the zero-crossing period.
constexpr double kDpPeriods = 1.4049;

constexpr DpCondition kDpScale[] = {
    {1.5, 0.1, 3.5, 0.25},   {3.4, 0.4, 4.5, 0.50},   {5.4, 0.8, 5.5, 0.75},
    {7.9, 1.3, 6.5, 0.75},   {10.7, 2.1, 7.5, 0.75},  {13.8, 3.1, 8.5, 0.75},
    {17.1, 4.2, 9.0, 0.75},  {20.7, 5.7, 10.0, 0.75}, {24.4, 7.4, 10.5, 0.75},
    {28.4, 9.5, 11.5, 0.75}, {32.6, 12.1, 12.0, 0.75}};
static_assert(sizeof kDpScale / sizeof kDpScale[0] == kDpNumbers);

/// Return the equivalent direction in 0 … π for a symmetric ship.
double direction_on_one_side(double from) noexcept {
    return std::abs(std::remainder(from, 2.0 * kDpPi));
}

double zero_crossing(const DpCondition& at) noexcept { return at.period / kDpPeriods; }

/// Return the factor of wave drift. It decreases with the ratio of the wave period to the ship's
/// period.
double drift_of_period(double t) noexcept {
    if (t < 1.0) return 1.0;
    const double inverse = 1.0 / (t * t * t);
    return inverse * std::exp(1.0 - inverse);
}

DpLoad wind_load(const DpShip& s, double speed, double from, double dir) noexcept {
    const double q = 0.5 * kDpAir * speed * speed;
    DpLoad out;
    out.x = q * s.frontal_area * -0.7 * std::cos(from);
    out.y = q * s.lateral_area * 0.9 * std::sin(from);
    out.n = out.y * (s.lateral_x + 0.3 * (1.0 - 2.0 * dir / kDpPi) * s.length);
    return out;
}

DpLoad current_load(const DpShip& s, double speed, double from, double dir) noexcept {
    const double q = 0.5 * kDpWater * speed * speed;
    DpLoad out;
    out.x = q * s.beam * s.draught * -0.07 * std::cos(from);
    out.y = q * s.submerged_area * 0.6 * std::sin(from);
    const double arm = std::clamp(0.4 * (1.0 - 2.0 * dir / kDpPi), -0.2, 0.25);
    out.n = out.y * (s.submerged_x + arm * s.length);
    return out;
}

DpLoad drift_load(const DpShip& s, const DpCondition& at, double from, double dir) noexcept {
    const double q = 0.5 * kDpWater * kDpGravity * at.height * at.height;
    const double tz = zero_crossing(at);
    const double along = s.surface_length > 0.0 ? s.surface_length : s.length;
    const double bow = 0.8 * std::pow(s.bow_angle, 0.45);
    const double fullness = std::clamp(s.aft_waterplane / (0.5 * s.length * s.beam), 0.85, 1.15);
    const double stern = 0.7 * fullness * fullness;
    const double shape = bow + dir / kDpPi * (stern - bow);
    const double turn = 0.05 + 0.95 * std::atan(1.45 * (dir - 1.75));
    DpLoad out;
    out.x =
        q * s.beam * 0.09 * shape * turn * drift_of_period(tz / (0.9 * std::pow(s.length, 0.33)));
    out.y = q * along * 0.09 * std::sin(from) * drift_of_period(tz / (0.75 * std::sqrt(s.beam)));
    out.n = out.y * (s.surface_x + (0.05 - 0.14 * dir / kDpPi) * along);
    return out;
}

/// Return η1, the factor of thrust by power and diameter.
double thrust_factor(const DpThruster& t) noexcept {
    if (t.kind == DpThrusterKind::cycloidal || t.kind == DpThrusterKind::tunnel) return 900.0;
    switch (t.propeller) {
        case DpPropeller::ducted:
            return 1200.0;
        case DpPropeller::contra_rotating:
            return 950.0;
        case DpPropeller::open:
            break;
    }
    return 800.0;
}

/// Return η2, the factor of direction and inlet.
double direction_factor(const DpThruster& t, bool astern) noexcept {
    if (t.kind == DpThrusterKind::tunnel) {
        if (t.inlet == DpInlet::rounded) return 1.07;
        return t.inlet == DpInlet::broken ? 1.0 : 0.93;
    }
    if (!astern || t.kind == DpThrusterKind::cycloidal) return 1.0;
    const bool ducted = t.propeller == DpPropeller::ducted;
    if (t.controllable) return ducted ? 0.5 : 0.65;
    return ducted ? 0.7 : 0.9;
}

/// Return η_M, the mechanical efficiency.
double mechanical_efficiency(const DpThruster& t) noexcept {
    if (t.drive == DpDrive::rim) return 0.995;
    switch (t.kind) {
        case DpThrusterKind::shaft:
            return 0.97;
        case DpThrusterKind::pod:
            return 0.98;
        case DpThrusterKind::cycloidal:
            return t.drive == DpDrive::permanent_magnet ? 0.97 : 0.91;
        case DpThrusterKind::azimuth:
        case DpThrusterKind::tunnel:
            break;
    }
    return 0.93;
}

}  // namespace

DpCondition dp_condition(int number) noexcept {
    return kDpScale[static_cast<std::size_t>(std::clamp(number, 1, kDpNumbers) - 1)];
}

DpLoads dp_loads(const DpShip& ship, const DpCondition& at, double from) noexcept {
    const double dir = direction_on_one_side(from);
    DpLoads out;
    out.wind = wind_load(ship, at.wind, from, dir);
    out.current = current_load(ship, at.current, from, dir);
    out.waves = drift_load(ship, at, from, dir);
    out.total.x = kDpMargin * (out.wind.x + out.current.x + out.waves.x);
    out.total.y = kDpMargin * (out.wind.y + out.current.y + out.waves.y);
    out.total.n = kDpMargin * (out.wind.n + out.current.n + out.waves.n);
    return out;
}

double dp_nominal_thrust(const DpThruster& thruster, bool astern) noexcept {
    const double kilowatts = 1e-3 * thruster.power;
    return thrust_factor(thruster) * direction_factor(thruster, astern) *
           std::pow(thruster.diameter * kilowatts * mechanical_efficiency(thruster), 2.0 / 3.0);
}

double dp_load_factor(const DpThruster& thruster, bool astern) noexcept {
    const double d = thruster.diameter;
    return std::sqrt(dp_nominal_thrust(thruster, astern) / (d * d * d)) / 15.2;
}

double dp_ventilation(const DpShip& ship, const DpThruster& thruster, const DpCondition& at,
                      double from, bool astern) noexcept {
    const double dir = direction_on_one_side(from);
    const double depth = ship.draught - thruster.point.z();
    const double share = dir <= 0.5 * kDpPi ? 1.0 + 0.38 * dir / kDpPi : 1.38 - 0.38 * dir / kDpPi;
    const double x = thruster.point.x();
    const double place = x >= 0.0 ? 1.0 : 1.0 + 0.4 * x / ship.length;
    const double motion = 0.85 * share * place * at.height *
                          std::min(0.64 * std::sqrt(ship.length) / zero_crossing(at), 1.0);
    const double loaded = std::max(dp_load_factor(thruster, astern) - 1.0, 0.0);
    const double sigma = 0.25 * (motion + loaded);
    const double x_normal = 2.0 * 2.0 * depth / thruster.diameter - 1.5 * sigma;
    return 0.5 * std::erfc(-x_normal / std::numbers::sqrt2);
}

DpRudderForce dp_rudder_force(const DpThruster& thruster, double angle) noexcept {
    constexpr double kProfileFactors[] = {1.1, 1.35, 1.1, 1.4, 1.65, 1.9, 1.21};
    static_assert(sizeof kProfileFactors / sizeof kProfileFactors[0] == kDpRudderProfiles);
    constexpr double kMaxAngle = 30.0, kNozzleFactor = 1.15;
    const double degrees = std::clamp(angle * 180.0 / kDpPi, -kMaxAngle, kMaxAngle);
    double slope = 0.0126 * kProfileFactors[static_cast<std::size_t>(thruster.rudder.profile)] *
                   thruster.rudder.area / (thruster.diameter * thruster.diameter);
    if (thruster.propeller == DpPropeller::ducted) slope *= kNozzleFactor;
    return {1.0 - 0.02 * slope * degrees * degrees, slope * degrees};
}

}  // namespace hawser
