// SPDX-License-Identifier: Apache-2.0
/// Dampers and drag: the velocities on which they act (model/damping.h).
#include "model/damping.h"
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

TEST(Damping, ShareGoesFromHalfToOne) {
    EXPECT_EQ(model::late_fraction(0.0), 0.5);
    EXPECT_EQ(model::late_fraction(std::numeric_limits<double>::infinity()), 1.0);
    double last = 0.5;
    for (double z = 1e-6; z < 1e12; z *= 1.5) {
        const double share = model::late_fraction(z);
        // Near 1/2 the fraction increases by less than the rounding of 1/z near the change of
        // formula.
        EXPECT_GE(share, last - 1e-13) << z;
        EXPECT_LE(share, 1.0);
        // A damper alone: w+ = (1 - (1 - share) z)/(1 + share z) w is exp(-z) w.
        EXPECT_NEAR((1.0 - (1.0 - share) * z) / (1.0 + share * z), std::exp(-z), 2e-13) << z;
        last = share;
    }
}

/// A body with drag alone slows down exactly, for any drag.
TEST(Damping, DragAloneIsExact) {
    for (const double drag : {0.1, 10.0, 1e4}) {
        Recipe r;
        r.world.gravity = {0, 0, 0};
        r.world.staggered_start = false;
        const BodyId b = r.rigid({0, 0, 0}, Quat::Identity(), 2.0, {1, 3, 3});
        r.bodies.back().velocity = {1, 0, 0};
        r.bodies.back().angular_velocity = {5, 0, 0};
        r.bodies.back().linear_damping = {drag, drag, drag};
        r.bodies.back().angular_damping = {drag, drag, drag};
        World w = r.make();
        for (int k = 1; k <= 20; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            const double t = k * r.world.step;
            // Rounding of twenty products.
            EXPECT_NEAR(w.velocity(b).linear.x(), std::exp(-drag * t / 2.0), 1e-14);
            EXPECT_NEAR(w.velocity(b).angular.x(), 5.0 * std::exp(-drag * t), 1e-13);
        }
        // Drag has dissipated the lost part, of a joule and of 12.5.
        const Energy e = w.energy();
        EXPECT_NEAR(e.mechanical() + e.dissipated, 13.5, 1e-12);
    }
}

/// Two bodies on a damper with a negligible spring: their relative velocity decays exactly.
TEST(Damping, DamperBetweenBodiesIsExact) {
    Recipe r;
    r.world.gravity = {0, 0, 0};
    r.world.staggered_start = false;
    const BodyId a = r.lump({0, 0, 0}, 1.0), b = r.lump({1, 0, 0}, 3.0);
    r.bodies.back().velocity = {0.1, 0, 0};
    InteractionDef d = between(InteractionKind::Distance, {a, b});
    constexpr double kSpring = 1e-6, kDamper = 2.0;  // N/m, N s/m
    d.compliance[0] = 1.0 / kSpring;
    d.damping_time[0] = kDamper / kSpring;
    r.add(d.set("length", 1.0));
    World w = r.make();
    for (int k = 1; k <= 60; ++k) {
        ASSERT_EQ(w.step(), Status::ok);
        const double rate = kDamper * (1.0 + 1.0 / 3.0), t = k * r.world.step;
        const double separation = w.velocity(b).linear.x() - w.velocity(a).linear.x();
        // The spring of 1e-6 N/m, at most 0.05 m long, in a second.
        EXPECT_NEAR(separation, 0.1 * std::exp(-rate * t), 1e-7);
    }
    // Its damping dissipates the difference; half a step before the start the spring was 0.8 mm
    // shorter.
    const Energy e = w.energy();
    EXPECT_NEAR(e.mechanical() + e.damped, 0.5 * 3.0 * 0.01, 1e-12);
}

/// At rest the fraction has no effect: g = -e f.
TEST(Damping, EnergyOfDampersIsAccountedFor) {
    for (const double tau : {0.0, 0.003, 0.02, 1.0, 50.0}) {
        Recipe r;
        r.world.gravity = {0, 0, 0};
        const BodyId g = r.ground(), b = r.lump({1.2, 0, 0}, 1.5);
        InteractionDef d = between(InteractionKind::Distance, {g, b});
        d.compliance[0] = 1e-3;
        d.damping_time[0] = tau;
        r.add(d.set("length", 1.0));
        World w = r.make();
        ASSERT_EQ(w.step(), Status::ok);
        const Energy first = w.energy();
        for (int k = 0; k < 300; ++k) ASSERT_EQ(w.step(), Status::ok);
        const Energy e = w.energy();
        // One row that does not rotate: exact to rounding, of 20 J.
        EXPECT_NEAR(e.mechanical() + e.damped, first.mechanical() + first.damped, 1e-11) << tau;
    }
}

}  // namespace
}  // namespace hawser::test
