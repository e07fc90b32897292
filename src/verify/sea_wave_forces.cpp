// SPDX-License-Identifier: Apache-2.0
/// Forces of waves from coefficients, strips, linear statics and convection, by each component.
#include "verify/sea_loads.h"
#include "verify/sea_tools.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace hawser::verify {

namespace {

template <class T>
T interpolate_frequency(const WaveCoefficients& c, const std::vector<T>& table, std::size_t head,
                        int k, double omega, double above) {
    const auto& w = c.frequency;
    const auto entry = [&](std::size_t i) {
        return table[(head * w.size() + i) * 6 + std::size_t(k)];
    };
    if (omega <= w.front()) return entry(0);
    for (std::size_t i = 1; i < w.size(); ++i)
        if (omega < w[i])
            return entry(i - 1) +
                   (omega - w[i - 1]) / (w[i] - w[i - 1]) * (entry(i) - entry(i - 1));
    return (omega > w.back() * (1.0 + 1e-9) ? above : 1.0) * entry(w.size() - 1);
}

/// Return the entry of a coefficient table for a wave direction. If the table lacks the direction,
/// return the entry of the mirrored direction.
template <class T>
T in_direction(const WaveCoefficients& c, const std::vector<T>& table, int k, double omega,
               double direction, double above) {
    const auto& heads = c.heading;
    const auto value = [&](std::size_t i) {
        return interpolate_frequency(c, table, i, k, omega, above);
    };
    const auto inside = [&](double d) {
        if (d <= heads.front()) return value(0);
        for (std::size_t i = 1; i < heads.size(); ++i)
            if (d <= heads[i])
                return value(i - 1) +
                       (d - heads[i - 1]) / (heads[i] - heads[i - 1]) * (value(i) - value(i - 1));
        return value(heads.size() - 1);
    };
    const double d = wrap_angle(direction), whole = 2.0 * kHalfTurn;
    for (const double turned : {d, d + whole, d - whole})
        if (turned >= heads.front() && turned <= heads.back()) return inside(turned);
    const bool half = heads.size() > 1 && std::abs(heads.front()) < 1e-3 &&
                      std::abs(heads.back() - kHalfTurn) < 1e-3;
    if (half && d < 0.0) return (k % 2 == 1 ? -1.0 : 1.0) * inside(-d);
    const double beyond = d > heads.back() ? d : d + whole;
    const double next = heads.front() + whole;
    if (heads.size() > 2 && beyond - heads.back() < next - heads.back() &&
        next - heads.back() < 1.2)
        return value(heads.size() - 1) + (beyond - heads.back()) / (next - heads.back()) *
                                             (value(0) - value(heads.size() - 1));
    return inside(std::abs(d - heads.front()) < std::abs(d - heads.back()) ? heads.front()
                                                                           : heads.back());
}

}  // namespace

Vec3 SeaVerifier::convection(const Vec3& x) const {
    // Gradient of the velocity in still-water coordinates, by differences of fourth order.
    const double up = surface(x.x(), x.y()), d = def_->depth;
    const double z = d * (std::clamp(x.z(), -d, up) + d) / (d + up) - d;
    const auto flow = [&](const Vec3& at) {
        Vec3 sum = Vec3::Zero();
        for (const WaveComponent& w : sea_->components()) {
            const double k = w.wave_number, a = inputs_.waves * w.amplitude * w.frequency;
            const Vec3 along(std::cos(w.direction), std::sin(w.direction), 0.0);
            const double theta = k * along.dot(at) - w.frequency * time_ + w.phase;
            const double all = -std::expm1(-2.0 * k * d);
            const double top = std::exp(k * at.z()), low = std::exp(-k * (at.z() + 2.0 * d));
            sum += a / all *
                   ((top + low) * std::cos(theta) * along +
                    (top - low) * std::sin(theta) * Vec3(0, 0, 1));
        }
        return sum;
    };
    const Vec3 here(x.x(), x.y(), z), u = flow(here);
    Vec3 out = Vec3::Zero();
    constexpr double kDifferenceStep = 1e-3;
    for (int k = 0; k < 3; ++k) {
        Vec3 e = Vec3::Zero();
        e[k] = kDifferenceStep;
        out +=
            u[k] *
            (8.0 * (flow(here + e) - flow(here - e)) - (flow(here + 2 * e) - flow(here - 2 * e))) /
            (12.0 * kDifferenceStep);
    }
    return out;
}

Eigen::Matrix<double, 6, 1> SeaVerifier::waves_on(const WaterHull& def, const Past& past) const {
    const WaveCoefficients& c = *def.coefficients;
    std::array<double, 3> slow{};
    for (std::size_t k = 0; k < 3; ++k) slow[k] = 4.0 * past.lag[2][k] - 3.0 * past.lag[3][k];
    V6 out = V6::Zero();
    std::complex<double> above[6]{}, below[6]{};
    for (const WaveComponent& w : sea_->components()) {
        const double theta =
            w.wave_number * (slow[0] * std::cos(w.direction) + slow[1] * std::sin(w.direction)) -
            w.frequency * time_ + w.phase;
        const std::complex<double> eta = std::polar(inputs_.waves * w.amplitude, theta);
        const double from = w.direction - slow[2];
        for (int k = 0; k < 6; ++k) {
            if (def.excitation != ExcitationKind::none) {
                const auto& table =
                    def.excitation == ExcitationKind::full ? c.excitation : c.scattering;
                out[k] += (in_direction(c, table, k, w.frequency, from, 0.0) * eta).real();
            }
            if (!def.drift || (k > 1 && k < 5)) continue;
            const double d = std::min(1.0, w.frequency / c.frequency.front()) *
                             in_direction(c, c.drift, k, w.frequency, from, 1.0);
            (d > 0.0 ? above : below)[k] += std::sqrt(std::abs(d)) * eta;
        }
    }
    for (int k = 0; k < 6; ++k) out[k] += std::norm(above[k]) - std::norm(below[k]);
    return out;
}

void SeaVerifier::add_statics(const WaterHull& def, const Pose& pose, const Mat3& level,
                              Load& out) const {
    const WaveCoefficients& c = *def.coefficients;
    const Mat3 tilt = level.transpose() * pose.orientation.toRotationMatrix();
    const M6 t = motions_at(c.reference);
    const M6 k = t.transpose() * (0.5 * (c.stiffness + c.stiffness.transpose())) * t;
    V6 x = V6::Zero();
    const Mat3 odd = 0.5 * (tilt - tilt.transpose());
    x << 0, 0, pose.position.z() - level_ - def.linear.height, odd(2, 1), odd(0, 2), 0;
    const M6 turn = block_diagonal(level);
    out.force -= turn * k * x;
    out.force[2] += std::isnan(def.linear.weight)
                        ? mass_[static_cast<std::size_t>(def.body.index)] * gravity_
                        : def.linear.weight;
    M6 stable = M6::Zero();
    for (int i = 2; i < 5; ++i)
        for (int j = 2; j < 5; ++j) {
            if (!(k(i, i) > 0.0) || !(k(j, j) > 0.0)) continue;
            const double most = 0.5 * std::sqrt(k(i, i) * k(j, j));
            stable(i, j) = i == j ? k(i, i) : std::clamp(k(i, j), -most, most);
        }
    out.stiffness += turn * stable * turn.transpose();
}

void SeaVerifier::add_strips(const WaterHull& def, const Pose& pose, const Twist& twist,
                             const Vec3& wet_fraction, Load& out) const {
    for (const HullStrip& strip : def.strips) {
        const Vec3 arm = pose.orientation * strip.at, n = pose.orientation * strip.axis;
        const Vec3 at_strip = twist.linear + twist.angular.cross(arm);
        const double past = n.dot(water(pose.position + arm).flow - at_strip);
        double area = 0.0;
        for (int k = 0; k < 3; ++k)
            area += strip.drag_area * strip.axis[k] * strip.axis[k] * wet_fraction[k];
        const double c = 0.5 * def_->density * area;
        V6 s, v;
        s << n, arm.cross(n);
        v << twist.linear, twist.angular;
        const M6 d = 2.0 * c * std::abs(past) * s * s.transpose();
        out.force += c * std::abs(past) * past * s + d * v;
        out.damping += d;
    }
}

}  // namespace hawser::verify
