// SPDX-License-Identifier: Apache-2.0
// Radiation and diffraction of hulls by coefficients: memory against integrals, closed forms of
// motions in frequency, passivity, drift, Kirchhoff's forces, strips, and restored states.
#include <hawser/hawser.h>

#include "marine/floater.h"
#include "verify/sea_loads.h"

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <memory>
#include <numbers>
#include <vector>

namespace hawser::test {
namespace {

TEST(Radiation, MemoryIsTheIntegralOfDamping) {
    const WaveCoefficients c = coupled();
    for (const double t : {0.0, 0.3, 1.0, 4.0, 9.0, 20.0}) {
        const Matrix6 k = retardation(c, t);
        // Linear between 240 frequencies: 1e-3 of K(0).
        EXPECT_NEAR(k(2, 2), bell_memory(t, 4e6, 0.5), 1e-3 * bell_memory(0, 4e6, 0.5)) << t;
        EXPECT_NEAR(k(1, 3), bell_memory(t, 4e6, 0.5), 1e-3 * bell_memory(0, 4e6, 0.5)) << t;
    }
    WaveCoefficients known = c;
    for (std::size_t w = 0; w < known.frequency.size(); ++w)
        known.added_mass[w](2, 2) += bell_added(known.frequency[w], 4e6, 0.5);
    EXPECT_NEAR(infinite_added_mass(known)(2, 2), 8e5, 4e3);
}

/// Compute the amplitude of heave under a force of 1 N cos ωt with a world.
Complex response(RadiationKind kind, double omega) {
    Floater f(coupled(), kind);
    f.hull.order = 12;
    f.start();
    const double h = f.w.settings().step;
    const int period = static_cast<int>(std::lround(2.0 * kPi / omega / h));
    const double w = 2.0 * kPi / (period * h);
    Complex sum = 0.0;
    const int settle = 60 * 300 / period, measured = 4;
    for (int i = 0; i < (settle + measured) * period; ++i) {
        const double ramp = std::min(1.0, f.w.time() / 100.0);
        f.w.set_force(f.body, {0, 0, ramp * 1e4 * std::cos(w * f.w.time())}, Vec3::Zero());
        if (f.w.step() != Status::ok) ADD_FAILURE();
        if (i >= settle * period)
            sum += f.w.pose(f.body).position.z() * std::polar(1.0, -w * f.w.time());
    }
    return 2.0 * sum / (1e4 * measured * period);
}

TEST(Radiation, HeaveIsThatOfItsFrequency) {
    HAWSER_SKIP_IF_SAMPLED();
    for (const double omega : {0.5, 0.8, 1.2}) {
        const double a = 8e5 + bell_added(omega, 4e6, 0.5), b = bell(omega, 4e6, 0.5);
        const Complex exact = 1.0 / Complex(1e6 - omega * omega * (1e6 + a), omega * b);
        for (const RadiationKind kind : {RadiationKind::convolution, RadiationKind::state_space}) {
            const Complex ours = response(kind, omega);
            std::printf("omega %.1f: |x| %.5e exact %.5e, phase %.3f deg\n", omega, std::abs(ours),
                        std::abs(exact), 180.0 / kPi * std::arg(ours / exact));
            // Periods are rounded to steps: error 0.5 % near resonance.
            EXPECT_NEAR(std::abs(ours - exact), 0.0, 0.01 * std::abs(exact)) << omega;
        }
    }
}

TEST(Radiation, NeitherMemoryMakesEnergy) {
    HAWSER_SKIP_IF_SAMPLED();
    // Released far from rest, with steps much too long for it: motions decay.
    for (const RadiationKind kind : {RadiationKind::convolution, RadiationKind::state_space})
        for (const double step : {1.0 / 60.0, 0.25}) {
            Floater f(coupled(), kind, {.step = step});
            f.hull.linear.height = -1.0;  // at rest, 1 m lower
            f.hull.order = 10;
            f.start();
            f.w.set_velocity(f.body, {{0, 1.0, 0}, {0.2, 0, 0}});
            double least = 1e300;
            for (int i = 0; i < 40; ++i) {
                go(f.w, static_cast<int>(10.0 / step));
                const Twist v = f.w.velocity(f.body);
                const double energy = 0.5e6 * v.linear.squaredNorm() +
                                      0.5 * 1e6 * std::pow(f.w.pose(f.body).position.z() + 1, 2);
                ASSERT_LE(energy, 3.0 * least + 1.0) << step << " " << i;
                least = std::min(least, energy);
            }
            const HullMemory m = hull_memory(f.w, 0);
            std::printf("step %.3f: fit %.2e, added damping %.2e of K(0)\n", step, m.fit_error,
                        m.added(2, 2) / m.first(2, 2));
        }
}

TEST(Radiation, DriftIsTheTablesAndSlowAtTheDifference) {
    HAWSER_SKIP_IF_SAMPLED();
    // The mean is Σ a² D; two waves add 2 a₁ a₂ √(D₁ D₂) at the difference of their frequencies.
    WaveCoefficients c = coupled();
    add_waves(c);
    Floater f(c, RadiationKind::none);
    f.hull.drift = true;
    f.sea.waves = {{.height = 1.0, .period = 9.0}, {.height = 0.6, .period = 7.5}};
    f.start();
    const double w1 = 2 * kPi / 9.0, w2 = 2 * kPi / 7.5;
    const double d1 = 0.25 * 900 * w1, d2 = 0.09 * 900 * w2;
    double sum = 0.0, most = -1e300, least = 1e300;
    const int n = 60 * 45 * 4;
    for (int i = 0; i < n; ++i) {
        f.w.set_pose(f.body, {});  // fixed, so that the wave meets it at one position
        go(f.w, 1);
        const double x = sea_loads(f.w)[0].force[0];
        sum += x / n;
        most = std::max(most, x);
        least = std::min(least, x);
    }
    EXPECT_NEAR(sum, d1 + d2, 2e-3 * (d1 + d2));  // the beat of 45 s has whole periods, tables are
                                                  // linear
    EXPECT_NEAR(0.5 * (most - least), 2 * std::sqrt(d1 * d2), 5e-3 * (d1 + d2));
}

/// Compute the change of energy of a body in ideal fluid within 20 s.
double energy_strays(double step) {
    WaveCoefficients c = coupled();
    c.infinite.setZero();
    c.infinite.diagonal() << 1e5, 9e5, 8e5, 1e7, 2e7, 3e7;
    for (auto& b : c.damping) b.setZero();
    c.stiffness.setZero();
    Floater f(c, RadiationKind::convolution, {.step = step});
    f.hull.coriolis = true;
    f.start();
    f.w.set_velocity(f.body, {{2.0, 0.5, 0}, {0, 0, 0}});
    go(f.w, 1);
    EXPECT_NEAR(sea_loads(f.w)[0].force[5], -(9e5 - 1e5) * 2.0 * 0.5, 1.0);
    const Eigen::Array3d al = c.infinite.diagonal().head<3>().array() + 1e6;
    const Eigen::Array3d aa =
        c.infinite.diagonal().tail<3>().array() + Eigen::Array3d(3e7, 4e7, 4e7);
    const auto energy = [&] {
        // Velocities belong to half a step before the pose.
        const Twist v = f.w.velocity(f.body);
        const double angle = 0.5 * step * v.angular.norm();
        const Mat3 back = angle > 0.0
                              ? Eigen::AngleAxisd(-angle, v.angular.normalized()).toRotationMatrix()
                              : Mat3(Mat3::Identity());
        const Mat3 r = back * f.w.pose(f.body).orientation.toRotationMatrix();
        const Vec3 lin = r.transpose() * v.linear, ang = r.transpose() * v.angular;
        return 0.5 * (al * lin.array().square()).sum() + 0.5 * (aa * ang.array().square()).sum();
    };
    const double first = energy();
    double worst = 0.0;
    for (int i = 0; i < 20; ++i) {
        go(f.w, static_cast<int>(std::lround(1.0 / step)));
        worst = std::max(worst, std::abs(energy() / first - 1.0));
    }
    return worst;
}

TEST(Radiation, KirchhoffsForcesKeepEnergyAndTurnIntoTheStream) {
    // A body in ideal fluid without damping: ½ νᵀ (M + A) ν is constant, and M_z = −(A₂₂ − A₁₁) u
    // v. The force belongs to the middle of a step: the error is of second order, 1e-6 at 1/60 s.
    const double coarse = energy_strays(1.0 / 60.0), fine = energy_strays(1.0 / 240.0);
    std::printf("energy of a body in ideal fluid over 20 s: %.2e, %.2e\n", coarse, fine);
    EXPECT_LT(coarse, 5e-6);
    EXPECT_LT(fine, 0.1 * coarse);
}

TEST(Radiation, StripsStopATurn) {
    // ω̇ = −c ω|ω| with c = ½ρ C_dA L²/32/I of an even row of strips, so that 1/ω grows by c t.
    WaveCoefficients c = coupled();
    Floater f(c, RadiationKind::none);
    const double length = 80.0, area = 400.0, inertia = 4e7;
    for (int i = 0; i < 40; ++i)
        f.hull.strips.push_back({{length * ((i + 0.5) / 40 - 0.5), 0, 0}, {0, 1, 0}, area / 40});
    f.start();
    f.w.set_velocity(f.body, {{0, 0, 0}, {0, 0, 0.05}});
    go(f.w, 600);
    const double rate = 0.5 * 1025 * area * std::pow(length, 3) / 32 / inertia;
    const double exact = 1.0 / (1.0 / 0.05 + rate * (f.w.time() - 0.5 / 60));
    // Errors: 40 strips 1e-3, the step 1e-3.
    EXPECT_NEAR(f.w.velocity(f.body).angular.z() / exact, 1.0, 4e-3);
}

/// Make a floater with all loads, on a mesh or on linear statics.
Floater busy(RadiationKind kind, bool mesh, int threads = 1) {
    WaveCoefficients c = coupled(4.0, 40);
    add_waves(c);
    Floater f(c, kind, {.threads = threads});
    auto moved = std::make_shared<WaveCoefficients>(*f.hull.coefficients);
    moved->reference = {1.0, 0.5, 1.5};
    f.hull.coefficients = moved;
    f.hull.memory = 20.0;
    f.hull.order = 10;
    f.hull.constant_period = 8.0;
    f.hull.drift = true;
    f.hull.coriolis = true;
    f.hull.added_mass = {1e4, 2e4, 3e4, 1e5, 2e5, 3e5};
    f.hull.damping = {1e3, 2e3, 3e3, 1e5, 2e5, 3e5};
    f.hull.strips = {{{-9, 0, -1}, {0, 1, 0}, 20}, {{9, 0, -1}, {0, 0.6, 0.8}, 20}};
    f.hull.excitation = ExcitationKind::full;
    if (mesh) {
        f.hull.linear.on = false;
        f.hull.wave_pressure = true;
        f.hull.excitation = ExcitationKind::scattering;
        f.hull.mesh = box_hull({12, 8, 5}, 6, 4, 3);
    }
    f.sea.convective = true;
    f.sea.current = {{0.0, 0.8, 1.0}};
    f.sea.waves = {{.kind = WaveKind::jonswap,
                    .height = 2.0,
                    .period = 8.0,
                    .direction = 0.4,
                    .spreading = 6.0,
                    .components = 16}};
    f.w.set_velocity(f.body, {{0.5, 0.1, 0}, {0, 0.02, 0.05}});
    f.start();
    return f;
}

TEST(Radiation, AgreesWithSeparateCode) {
    for (const RadiationKind kind :
         {RadiationKind::convolution, RadiationKind::state_space, RadiationKind::constant})
        for (const bool mesh : {false, true}) {
            Floater f = busy(kind, mesh);
            verify::SeaVerifier verifier(f.w);
            double worst = 0.0;
            for (int i = 0; i < 150; ++i) {
                verifier.before_step(f.w);
                const std::vector<Pose> pose{f.w.pose(f.body)};
                const std::vector<Twist> before{f.w.velocity(f.body)};
                go(f.w, 1);
                worst = std::max(worst, verifier.after_step(f.w, pose, before));
            }
            std::printf("kind %d, mesh %d: loads differ by %.2e\n", int(kind), int(mesh), worst);
            EXPECT_LT(worst, 1e-9);
        }
}

TEST(Radiation, MemoryIsPartOfStateAndThreadsDoNotMatter) {
    for (const RadiationKind kind : {RadiationKind::convolution, RadiationKind::state_space}) {
        std::uint64_t hash = 0;
        for (const int threads : {1, 2, 4, 8}) {
            Floater f = busy(kind, true, threads);
            go(f.w, 100);
            const auto saved = f.w.state().save();
            World twin = f.w.twin();
            go(f.w, 60);
            go(twin, 60);
            EXPECT_EQ(twin.state().hash(), f.w.state().hash());
            Floater other = busy(kind, true, threads);
            other.w.state().restore(saved);
            go(other.w, 60);
            EXPECT_EQ(other.w.state().hash(), f.w.state().hash());
            if (threads == 1) hash = f.w.state().hash();
            EXPECT_EQ(f.w.state().hash(), hash) << threads;
        }
    }
}

}  // namespace
}  // namespace hawser::test
