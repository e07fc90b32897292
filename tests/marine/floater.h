// SPDX-License-Identifier: Apache-2.0
#pragma once
// A hull with coefficients whose memory function has a closed form.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

namespace hawser::test {

using Complex = std::complex<double>;
inline constexpr double kPi = std::numbers::pi;

inline void go(World& w, int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_EQ(w.step(), Status::ok) << to_string(w.bad_load(), w);
}

/// Compute B = c ω² e^(−ω/s). Its memory is K = (4c/π) s³ (1 − 3 s²t²)/(1 + s²t²)³.
inline double bell(double omega, double c, double s) {
    return c * omega * omega * std::exp(-omega / s);
}
inline double bell_memory(double t, double c, double s) {
    const double x = s * s * t * t;
    return 4.0 * c / kPi * s * s * s * (1.0 - 3.0 * x) / std::pow(1.0 + x, 3);
}
/// Compute A(ω) − A(∞) = −(1/ω) ∫ K sin ωt dt by Simpson's rule, up to the time at which K is 1e-8
/// of K(0).
inline double bell_added(double omega, double c, double s) {
    double sum = 0.0;
    const int n = 8'000;
    const double dt = 100.0 / s / n;
    for (int i = 0; i <= n; ++i)
        sum += (i == 0 || i == n ? 1.0
                : i % 2 == 1     ? 4.0
                                 : 2.0) *
               std::sin(omega * i * dt) * bell_memory(i * dt, c, s);
    return -sum * dt / 3.0 / omega;
}

/// Make a hull of 1000 t that heaves, sways and rolls; sway and roll are coupled.
inline WaveCoefficients coupled(double top = 12.0, int count = 240) {
    WaveCoefficients c;
    const double s = 0.5;
    const struct {
        int i, j;
        double damping, added;
    } pairs[] = {{2, 2, 4e6, 8e5}, {1, 1, 2e6, 4e5}, {3, 3, 5e7, 2e7}, {1, 3, 4e6, -1e6}};
    for (int n = 1; n <= count; ++n) {
        const double omega = top * n / count;
        Matrix6 a = Matrix6::Zero(), b = a;
        for (const auto& p : pairs) {
            b(p.i, p.j) = b(p.j, p.i) = bell(omega, p.damping, s);
            a(p.i, p.j) = a(p.j, p.i) = p.added;  // A(∞) only; ours() adds the rest where needed
        }
        c.frequency.push_back(omega);
        c.added_mass.push_back(a);
        c.damping.push_back(b);
    }
    for (const auto& p : pairs) c.infinite(p.i, p.j) = c.infinite(p.j, p.i) = p.added;
    c.has_infinite = true;
    c.stiffness(2, 2) = 1e6;
    c.stiffness(3, 3) = 2e7;
    c.stiffness(4, 4) = 2e7;
    c.has_stiffness = true;
    return c;
}

/// Add wave loads in phase with the wave for two directions, with drift.
inline void add_waves(WaveCoefficients& c) {
    c.heading = {0.0, 0.5 * kPi, kPi};
    for (std::size_t h = 0; h < 3; ++h)
        for (std::size_t w = 0; w < c.frequency.size(); ++w)
            for (int k = 0; k < 6; ++k) {
                const double size = 2e4 / (1.0 + c.frequency[w]);
                const bool across = k % 2 == 1, sideways = h == 1;
                const Complex x = across && !sideways ? Complex() : size * Complex(0.8, -0.3 * k);
                c.excitation.push_back(x);
                c.scattering.push_back(0.3 * x);
                c.drift.push_back(k == 0   ? (h == 1 ? -100.0 : 900.0 * c.frequency[w])
                                  : k == 1 ? (h == 1 ? 500.0 : 0.0)
                                           : 0.0);
            }
}

struct Floater {
    World w;
    BodyId body{};
    SeaDef sea{.depth = 200.0};
    WaterHull hull{};

    explicit Floater(WaveCoefficients c, RadiationKind radiation = RadiationKind::convolution,
                     const WorldDef& def = {})
        : w(def) {
        body =
            w.add_body({.name = "hull", .mass = 1e6, .inertia = Vec3(3e7, 4e7, 4e7).asDiagonal()});
        c.reference = {0.0, 0.0, 0.0};
        hull.body = body;
        hull.wave_pressure = false;
        hull.radiation = radiation;
        hull.coefficients = std::make_shared<const WaveCoefficients>(std::move(c));
        hull.linear.on = true;
    }
    void start() {
        sea.hulls = {hull};
        w.add(sea);
    }
};

}  // namespace hawser::test
