// SPDX-License-Identifier: Apache-2.0
/// Propellers in open water (hawser/vessel_propeller.h).
#include <hawser/vessel_propeller.h>

#include "vessel/propeller_tables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace hawser {
namespace {

using vessel::DuctTerm;
using vessel::WageningenTerm;

constexpr double kTipFraction = 0.7 * std::numbers::pi;  ///< Blade section at 0.7 R: 0.7 π n D.
constexpr double kMinPitch = 0.5;                        ///< Below: linear in the pitch.
constexpr double kIdleTorque = 0.2;  ///< Torque at pitch 0 over that at pitch ratio 0.5.
constexpr double kBlendFrom = 0.9, kBlendTo = 1.2;  ///< J over P/D.
constexpr int kBisections = 60;

/// Return x^n for small n ≥ 0.
double power_of(double x, int n) noexcept {
    double out = 1.0;
    for (int i = 0; i < n; ++i) out *= x;
    return out;
}

double sum_terms(std::span<const WageningenTerm> terms, double j, double p, double a,
                 double z) noexcept {
    double sum = 0.0;
    for (const WageningenTerm& t : terms)
        sum += t.value * power_of(j, t.s) * power_of(p, t.t) * power_of(a, t.u) * power_of(z, t.v);
    return sum;
}

double sum_terms(std::span<const DuctTerm> terms, double j, double p) noexcept {
    double sum = 0.0;
    for (const DuctTerm& t : terms) sum += t.value * power_of(p, t.pitch) * power_of(j, t.advance);
    return sum;
}

/// Return thrust and torque by the Fourier series of the B4-70, scaled to the series at J = 0.
PropellerForce by_quadrants(const PropellerDef& propeller, double pitch, double rps, double speed,
                            double density) noexcept {
    const double d = propeller.diameter, tip = kTipFraction * rps * d, flow = speed / pitch;
    const QuadrantPoint at = four_quadrants_b4_70(std::atan2(flow, tip));
    static const QuadrantPoint still = four_quadrants_b4_70(0.0);
    PropellerDef own = propeller;
    own.pitch = pitch;
    const PropellerPoint first = open_water(own, 0.0);
    const double still_tip =
        kTipFraction * kTipFraction * std::numbers::pi / 8.0;  // K = C still_tip
    const double q = density * std::numbers::pi / 8.0 * d * d * (tip * tip + flow * flow);
    return {q * at.thrust * first.thrust / (still.thrust * still_tip),
            q * d * at.torque * first.torque / (still.torque * still_tip)};
}

}  // namespace

PropellerPoint wageningen_b(double advance, double pitch, double area, double blades) noexcept {
    return {sum_terms(vessel::kThrustTerms, advance, pitch, area, blades),
            sum_terms(vessel::kTorqueTerms, advance, pitch, area, blades), 0.0};
}

PropellerPoint ka4_70(double advance, double pitch) noexcept {
    return {sum_terms(vessel::kKa470Thrust, advance, pitch),
            sum_terms(vessel::kKa470Torque, advance, pitch),
            sum_terms(vessel::kKa470Nozzle, advance, pitch)};
}

PropellerPoint ka5_75(double advance, double pitch) noexcept {
    return {sum_terms(vessel::kKa575Thrust, advance, pitch),
            sum_terms(vessel::kKa575Torque, advance, pitch),
            sum_terms(vessel::kKa575Nozzle, advance, pitch)};
}

QuadrantPoint four_quadrants_b4_70(double angle) noexcept {
    QuadrantPoint sum;
    for (std::size_t k = 0; k < std::size(vessel::kThrustCos); ++k) {
        const double at = static_cast<double>(k) * angle;
        const double c = std::cos(at), s = std::sin(at);
        sum.thrust += vessel::kThrustCos[k] * c + vessel::kThrustSin[k] * s;
        sum.torque += vessel::kTorqueCos[k] * c + vessel::kTorqueSin[k] * s;
    }
    return sum;
}

const char* to_string(PropellerSeries series) noexcept {
    constexpr const char* kNames[] = {"wageningen_b", "ka4_70", "ka5_75"};
    return kNames[static_cast<std::size_t>(series)];
}

PropellerPoint open_water(const PropellerDef& propeller, double advance) noexcept {
    switch (propeller.series) {
        case PropellerSeries::wageningen_b:
            break;
        case PropellerSeries::ka4_70:
            return ka4_70(advance, propeller.pitch);
        case PropellerSeries::ka5_75:
            return ka5_75(advance, propeller.pitch);
    }
    return wageningen_b(advance, propeller.pitch, propeller.area, propeller.blades);
}

PropellerForce propeller_force(const PropellerDef& propeller, double pitch, double rps,
                               double speed, double density) noexcept {
    const double d = propeller.diameter;
    if (rps == 0.0 && speed == 0.0) return {};
    const double side = pitch < 0.0 ? -1.0 : 1.0;
    const double share = std::min(1.0, std::abs(pitch) / kMinPitch);
    PropellerDef own = propeller;
    own.pitch = std::max(std::abs(pitch), kMinPitch);
    const double flow = side * speed;
    double weight = 0.0;  // // weight of the series
    PropellerForce out;
    if (rps > 0.0 && flow >= 0.0) {
        const double advance = flow / (rps * d);
        const double x =
            std::clamp((advance / own.pitch - kBlendFrom) / (kBlendTo - kBlendFrom), 0.0, 1.0);
        weight = 1.0 - x * x * (3.0 - 2.0 * x);
        if (weight > 0.0) {
            const PropellerPoint k = open_water(own, advance);
            const double scale = density * rps * rps * power_of(d, 4);
            out = {weight * k.thrust * scale, weight * k.torque * scale * d};
        }
    }
    if (weight < 1.0) {
        const PropellerForce rest = by_quadrants(own, own.pitch, rps, flow, density);
        out.thrust += (1.0 - weight) * rest.thrust;
        out.torque += (1.0 - weight) * rest.torque;
    }
    out.thrust *= side * share;
    out.torque *= kIdleTorque + (1.0 - kIdleTorque) * share * share;
    return out;
}

PowerPoint at_power(const PropellerDef& propeller, double power, double speed,
                    double density) noexcept {
    const double d = propeller.diameter;
    const auto absorbed = [&](double n) {
        const double k = open_water(propeller, speed / (n * d)).torque;
        return 2.0 * std::numbers::pi * k * density * power_of(n, 3) * power_of(d, 5);
    };
    double low = std::max(1e-3, speed / (1.5 * propeller.pitch * d)), high = 2.0 * low;
    while (absorbed(high) < power && high < 1e6) high *= 2.0;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (low + high);
        (absorbed(middle) < power ? low : high) = middle;
    }
    const PropellerPoint k = open_water(propeller, speed / (high * d));
    const double scale = density * high * high * power_of(d, 4);
    return {high, k.thrust * scale, k.torque * scale * d};
}

}  // namespace hawser
