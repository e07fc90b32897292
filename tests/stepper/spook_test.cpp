// SPDX-License-Identifier: Apache-2.0
/// Properties of the scheme that follow from its equations (docs/theory/step.md, rotation.md).
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace hawser::test {
namespace {

/// Make a point mass on a spring along x between it and the origin, rest length `rest`.
Recipe oscillator(double h, double mass, double compliance, double tau, double x, double v) {
    Recipe r;
    r.world.step = h;
    r.world.gravity = {0, 0, 0};
    r.world.staggered_start = false;
    r.world.geometric_stiffness = 0.0;
    const BodyId g = r.ground(), b = r.lump({10.0 + x, 0, 0}, mass);
    r.bodies.back().velocity = {v, 0, 0};
    InteractionDef d = between(InteractionKind::Distance, {g, b});
    d.compliance[0] = compliance;
    d.damping_time[0] = tau;
    r.add(d.set("length", 10.0));
    return r;
}

/// 1. At rest g = −ε f for any step and damping time.
TEST(Spook, StaticDeflectionDoesNotDependOnStepOrDamping) {
    constexpr double kCompliance = 1e-3, kMass = 1.0, kWeight = 9.81;
    for (double h : {1.0 / 60, 1.0 / 240, 1.0 / 1000})
        for (double n : {0.5, 2.0, 5.0}) {
            Recipe r = oscillator(h, kMass, kCompliance, n * h, 0.0, 0.0);
            r.world.gravity = {kWeight, 0, 0};
            // At rest: the static solution must be a fixed point of the scheme.
            r.bodies[1].position.x() = 10.0 + kCompliance * kMass * kWeight;
            World w = r.make();
            for (int i = 0; i < 500; ++i) ASSERT_EQ(w.step(), Status::ok);
            const double g = w.violation(InteractionId{0})[0];
            const double f = w.force(InteractionId{0})[0];
            // Positions of 10 m have rounding errors of 2e-15 m.
            EXPECT_NEAR(g, 0.00981, 1e-12) << "h " << h << " n " << n;
            EXPECT_NEAR(g, -kCompliance * f, 1e-12);
        }
}

/// A row without compliance is closed at the end of the first step already, to a fraction of its Σ.
TEST(Spook, ARigidRowHoldsAtTheEndOfTheStep) {
    World w = oscillator(1.0 / 60, 1.0, 0.0, 2.0 / 60, 1.0, 0.0).make();
    for (int k = 0; k < 30; ++k) {
        ASSERT_EQ(w.step(), Status::ok);
        EXPECT_NEAR(w.violation(InteractionId{0})[0], 0.0, 5e-9) << "step " << k + 1;
    }
}

/// 2. Decay of a violation, ε → 0, n = 2: 1, 5/9, 7/27, 1/9, …
TEST(Spook, ViolationDecaysWithTheDoubleRootOfOneThird) {
    // A row without compliance is closed at the end of the first step (completion.h).
    for (double compliance : {1e-12}) {
        const double h = 1.0 / 60;
        World w = oscillator(h, 1.0, compliance, 2 * h, 1.0, 0.0).make();
        double before = 1.0, now = 1.0;  // g₋₁ = g₀: at rest
        const double want[] = {5.0 / 9, 7.0 / 27, 1.0 / 9};
        for (int k = 0; k < 30; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            const double g = w.violation(InteractionId{0})[0];
            // A rigid row has a floor of Σ = 1e-9 G M⁻¹Gᵀ; Σ of 1e-12 m/N is 1.6e-9.
            if (k < 3) {
                EXPECT_NEAR(g, want[k], 5e-9) << "step " << k + 1;
            }
            const double upsilon = 1.0 / 9;
            EXPECT_NEAR(g, (1 - 3 * upsilon) * now - upsilon * before, 5e-9);
            before = now;
            now = g;
        }
        EXPECT_NEAR(now, 0.0, 1e-8);
    }
}

/// 3. Without damping ½ v M v + |g − (h/2) G v|²/(2ε) is constant.
TEST(Spook, UndampedOscillatorKeepsItsInvariant) {
    for (double omega_h : {0.05, 0.5, 3.0}) {
        const double h = 1.0 / 60, omega = omega_h / h, mass = 2.0;
        World w = oscillator(h, mass, 1.0 / (mass * omega * omega), 0.0, 0.3, 0.1).make();
        double first = 0.0;
        for (int k = 0; k < 20'000; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            const double v = w.velocity(BodyId{1}).linear.x();
            const double g = w.pose(BodyId{1}).position.x() - 10.0;
            const double bar = g - 0.5 * h * v;
            const double e = 0.5 * mass * v * v + 0.5 * mass * omega * omega * bar * bar;
            if (k == 0) first = e;
            // Rounding of x ≈ 10 is 2e-15 m per step, a random walk of 2e4 steps: about 1e-13 of
            // 0.3 m, and twice that in the energy.
            ASSERT_NEAR(e / first, 1.0, 1e-11) << "step " << k << " Ω " << omega_h;
        }
        EXPECT_NEAR(w.energy().mechanical() / first, 1.0, 1e-11);
    }
}

/// 4. |z| ≤ 1 for every n and Ω, with the decay of the characteristic polynomial.
TEST(Spook, LinearOscillatorFollowsItsCharacteristicPolynomial) {
    for (double n : {0.0, 0.5, 2.0, 10.0})
        for (double omega_h : {0.01, 0.3, 2.0, 30.0}) {
            const double h = 1.0 / 60, omega = omega_h / h;
            World w = oscillator(h, 1.0, 1.0 / (omega * omega), n * h, 0.01, 0.0).make();
            // (z − 1)² + (Ω²/4)[(1 + 4nθ)z² + (2 + 4n(1 − 2θ))z + 1 − 4n(1 − θ)] = 0
            const double q = omega_h * omega_h / 4, y = 4 * n * q + q;
            const double t = y < 1e-3 ? 0.5 + y / 12 : -1 / std::expm1(-y) - 1 / y;
            const double a = 1 + q * (1 + 4 * n * t), b = -2 + q * (2 + 4 * n * (1 - 2 * t)),
                         c = 1 + q * (1 - 4 * n * (1 - t));
            const std::complex<double> root = std::sqrt(std::complex<double>(b * b - 4 * a * c));
            EXPECT_LE(std::abs((-b + root) / (2 * a)), 1 + 1e-12);
            EXPECT_LE(std::abs((-b - root) / (2 * a)), 1 + 1e-12);
            double g0 = 0.01, g1 = 0.01;
            for (int k = 0; k < 200; ++k) {
                ASSERT_EQ(w.step(), Status::ok);
                const double g = w.pose(BodyId{1}).position.x() - 10.0;
                ASSERT_NEAR(a * g + b * g1 + c * g0, 0.0, 1e-12 * a)
                    << "n " << n << " Ω " << omega_h;
                // Undamped, two equal first positions give at most 2/sin θ, tan(θ/2) = Ω/2.
                ASSERT_LE(std::abs(g), 0.02 * (1 + q) / omega_h);
                g0 = g1;
                g1 = g;
            }
        }
}

/// A.3: the spatial momentum R μ₋(ω) of a free body is constant (base/turn.h),
/// μ₋(ω) = Iω − (h/2) ω × Iω + (h²/4) b ω × (ω × Iω),  b = (1 − |a| cot |a|)/|a|²,  a = hω/2.
TEST(FreeBody, AngularMomentumIsConserved) {
    Random random(3);
    for (double speed : {0.1, 1.0, 5.0, 30.0}) {
        Recipe r;
        r.world.gravity = {0, 0, 0};
        r.world.staggered_start = false;
        const Vec3 principal(1, 2, 2.9);
        const BodyId b = r.rigid({0, 0, 0}, random.rotation(), 4.0, principal);
        r.bodies[0].angular_velocity = speed * random.vector(1.0).normalized();
        World w = r.make();
        const double h = r.world.step;
        auto momentum = [&] {
            const Quat q = w.pose(b).orientation;
            const Vec3 o = q.conjugate() * w.velocity(b).angular;
            const Vec3 io = principal.cwiseProduct(o);
            const double a = 0.5 * h * o.norm(), bend = (1.0 - a / std::tan(a)) / (a * a);
            const Vec3 across = o.cross(io);
            return Vec3(q * (io - 0.5 * h * across + 0.25 * h * h * bend * o.cross(across)));
        };
        ASSERT_EQ(w.step(), Status::ok);
        const Vec3 first = momentum();
        for (int k = 0; k < 2000; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            // Random walk of rounding errors: 2000 steps of some 2⁻⁵³, with a margin. At 0.1
            // rad/s, b loses digits in the reference: y = 7e-7, of which b is a third.
            ASSERT_LE((momentum() - first).norm(), 1e-13 * 20 * first.norm())
                << "speed " << speed << " step " << k;
        }
    }
}

TEST(FreeBody, FallsAsItShould) {
    Recipe r;
    const BodyId b = r.lump({0, 0, 100}, 3.0);
    World w = r.make();
    for (int k = 0; k < 120; ++k) ASSERT_EQ(w.step(), Status::ok);
    // Staggered: x_k = x₀ − ½ g t² exactly for a constant force.
    EXPECT_NEAR(w.pose(b).position.z(), 100 - 0.5 * 9.81 * 4.0, 1e-11);
    EXPECT_NEAR(w.velocity(b).linear.z(), -9.81 * (2.0 - 0.5 / 60), 1e-12);
}

}  // namespace
}  // namespace hawser::test
