// SPDX-License-Identifier: Apache-2.0
/// Energy losses of rows: damping of springs, lines that come taut and break.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

/// Return the energy between two states that no account contains [J].
double not_booked(const Energy& a, const Energy& b) {
    return b.mechanical() - a.mechanical() - (b.applied - a.applied) - (b.driven - a.driven) +
           (b.dissipated - a.dissipated) + (b.damped - a.damped);
}

// Motions along a line are linear, so that only rounding is left: some hundred steps of sums of 1
// kJ.
constexpr double kNothing = 1e-9;

TEST(Losses, ADampedSpringLosesWhatADashpotTakes) {
    Recipe r;
    const double k = 4e3, tau = 0.02;
    const BodyId load = r.lump({0, 0, -1.3}, 10.0);
    InteractionDef d = between(InteractionKind::Distance, {r.ground(), load});
    d.compliance[0] = 1.0 / k;
    d.damping_time[0] = tau;
    r.add(d.set("length", 1.0));
    World w = r.make();
    ASSERT_EQ(w.step(), Status::ok);  // velocities are at half steps from here on
    const Energy start = w.energy();
    // Rate of the damper, docs/theory/step.md.
    const double h = w.settings().step, z = h * k / 10.0 * (tau + 0.25 * h);
    const double late = 1.0 / (1.0 - std::exp(-z)) - 1.0 / z;
    double dashpot = 0.0, before = w.velocity(load).linear.z();
    for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        const double now = w.velocity(load).linear.z();
        dashpot += 0.5 * h * k * tau * (late * now + (1.0 - late) * before) * (before + now);
        before = now;
        ASSERT_NEAR(not_booked(start, w.energy()), 0.0, kNothing);
    }
    // It was released 0.275 m below its rest: 152 J, all of it lost after 3.3 s.
    EXPECT_NEAR(w.energy().damped - start.damped, dashpot, kNothing);
    EXPECT_GT(dashpot, 100.0);
}

TEST(Losses, ALineThatComesTautLosesAndNeverGains) {
    Recipe r;
    const BodyId load = r.lump({0, 0, -0.2}, 10.0);
    InteractionDef d = between(InteractionKind::Stretch, {r.ground(), load});
    r.add(d.set("EA", 1e5).set("length", 1.0));
    World w = r.make();
    ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    double last = start.damped;
    int taut = 0, slack = 0;
    for (int i = 0; i < 200; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        const Energy now = w.energy();
        ASSERT_NEAR(not_booked(start, now), 0.0, kNothing) << "step " << i;
        ASSERT_GE(now.damped, last - kNothing) << "step " << i;
        if (now.damped > last + kNothing) ++taut;
        if (w.pose(load).position.z() > -1.0) ++slack;
        last = now.damped;
    }
    EXPECT_GT(taut, 5);
    EXPECT_GT(slack, 30);
    EXPECT_GT(last - start.damped, 10.0);
}

TEST(Losses, ALineThatPartsLosesWhatItHeld) {
    Recipe r;
    const BodyId load = r.lump({0, 0, -1}, 10.0);
    InteractionDef d = between(InteractionKind::Stretch, {r.ground(), load});
    r.add(d.set("EA", 1e5).set("length", 1.0).set("breaking_load", 200.0));
    World w = r.make();
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    const Energy start = w.energy();
    EXPECT_GT(start.elastic, 0.04);  // 98 N at 1e5 N/m
    w.set_force(load, {0, 0, -300}, {0, 0, 0});
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_NEAR(not_booked(start, w.energy()), 0.0, kNothing) << "step " << i;
    }
    EXPECT_EQ(w.energy().elastic, 0.0);
    EXPECT_GT(w.energy().damped - start.damped, 0.1);
    EXPECT_LT(w.pose(load).position.z(), -2.0);
}

}  // namespace
}  // namespace hawser::test
