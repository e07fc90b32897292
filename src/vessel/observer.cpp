// SPDX-License-Identifier: Apache-2.0
#include "vessel/observer.h"

#include "vessel/actuators.h"

#include <cmath>
#include <numbers>
#include <span>

namespace hawser::vessel {
namespace {

constexpr double kCutoffRatio = 1.22;   ///< ω_c over the wave frequency.
constexpr double kWaveDamping = 0.1;    ///< Damping ratio of the wave model.
constexpr double kNotchDamping = 1.0;   ///< Damping ratio of the notch.
constexpr double kVelocityGain = 0.15;  ///< K_4 over M ω_c².
constexpr double kBiasTime = 60.0;      ///< K_4 over K_3 [s].

}  // namespace

Vec3 to_earth(const Vec3& of_ship, double heading) noexcept {
    const double c = std::cos(heading), s = std::sin(heading);
    return {c * of_ship[0] - s * of_ship[1], s * of_ship[0] + c * of_ship[1], of_ship[2]};
}

Vec3 to_ship(const Vec3& of_earth, double heading) noexcept {
    const double c = std::cos(heading), s = std::sin(heading);
    return {c * of_earth[0] + s * of_earth[1], -s * of_earth[0] + c * of_earth[1], of_earth[2]};
}

Observer::Observer(const Vec3& mass, const Vec3& damping, double period)
    : mass_(mass), damping_(damping), frequency_(2.0 * std::numbers::pi / period) {}

void Observer::start(const Planar& measured) noexcept {
    low_frequency_ = measured;
    bias_.setZero();
    swell_.setZero();
    swell_rate_.setZero();
}

void Observer::step(const Planar& measured, const Vec3& force, double h) noexcept {
    const double w = frequency_, cut = kCutoffRatio * w;
    const double heading = measured.planar_position[2];
    Vec3 error = measured.planar_position - low_frequency_.planar_position - swell_rate_;
    error[2] =
        wrapped(measured.planar_position[2] - low_frequency_.planar_position[2] - swell_rate_[2]);
    // Gains of the wave model place a notch at ω_0 (Fossen and Strand).
    const double k1 = -2.0 * (kNotchDamping - kWaveDamping) * kCutoffRatio;
    const double k2 = 2.0 * w * (kNotchDamping - kWaveDamping);
    const Vec3 rate = low_frequency_.motion, error_ship = to_ship(error, heading);
    const Vec3 accelerating = kVelocityGain * cut * cut * error_ship;
    const Vec3 acceleration =
        (force + bias_ - damping_.cwiseProduct(rate)).cwiseQuotient(mass_) + accelerating;
    swell_rate_ += h * (-w * w * swell_ - 2.0 * kWaveDamping * w * swell_rate_ + k2 * error);
    swell_ += h * (swell_rate_ + k1 * error);
    low_frequency_.motion += h * acceleration;
    bias_ += h * mass_.cwiseProduct(accelerating) / kBiasTime;
    low_frequency_.planar_position += h * (to_earth(low_frequency_.motion, heading) + cut * error);
    low_frequency_.planar_position[2] = wrapped(low_frequency_.planar_position[2]);
}

void Observer::visit(StateVisitor& v) {
    for (Vec3* x :
         {&low_frequency_.planar_position, &low_frequency_.motion, &bias_, &swell_, &swell_rate_})
        v.visit(std::span<double>(x->data(), 3));
}

}  // namespace hawser::vessel
