// SPDX-License-Identifier: Apache-2.0
/// Relative-rotation damping of joints: it stabilises chains of stiff links, and has no effect on
/// resolved motions.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hawser::test {
namespace {

/// Links along x, 1 mm off the line to either side, and the force on them.
struct Chain {
    int links = 40;
    double length = 2.0, mass = 50.0;  ///< Length and mass of a link [m, kg].
    double force = 5e5, off = 1e-3;    ///< [N, m]
};

Recipe taut_chain(InteractionKind joint, double damping, const Chain& chain = {}) {
    const int kLinks = chain.links;
    const double kLength = chain.length, kMass = chain.mass;
    const double kAcross = kMass * kLength * kLength / 12.0;
    Recipe r;
    r.world.gravity = {0, 0, 0};
    r.world.rotation_damping = damping;
    auto node = [&](int i) {
        const double off = i == 0 || i == kLinks ? 0.0 : (i % 2 ? chain.off : -chain.off);
        return Vec3(kLength * i, 0, off + 0.05 * std::sin(EIGEN_PI * i / kLinks));
    };
    const Quat about_y(Eigen::AngleAxisd(-EIGEN_PI / 2, Vec3::UnitX()));  // z of the frame along y
    BodyId last = r.ground();
    for (int i = 0; i < kLinks; ++i) {
        const Vec3 a = node(i), b = node(i + 1);
        const Quat q = turn_between(Vec3::UnitX(), b - a);
        const BodyId link = r.rigid(0.5 * (a + b), q, kMass, {0.06, kAcross, kAcross});
        InteractionDef d = r.at(joint, {last, link}, a, about_y);
        if (joint == InteractionKind::Universal)  // its second axis is perpendicular to the first
            d.frame[1] = d.frame[1] * Quat(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()));
        r.add(d);
        last = link;
    }
    const Vec3 end = node(kLinks);
    const BodyId ship = r.rigid(end + Vec3(1, 0, 0), Quat::Identity(), 4e6, {1e8, 1e9, 1e9});
    r.bodies.back().force = {chain.force, 0, 0};
    r.add(r.at(InteractionKind::Ball, {last, ship}, end));
    return r;
}

/// Return the largest kinetic energy in the last second of 20 s [J].
double late_energy(World w) {
    double most = 0.0;
    for (int i = 0; i < 1200; ++i) {
        if (w.step() != Status::ok) return HUGE_VAL;
        if (i >= 1140) most = std::max(most, w.energy().kinetic);
    }
    return most;
}

TEST(JointDamping, HoldsTautChainsTogether) {
    for (const InteractionKind kind :
         {InteractionKind::Ball, InteractionKind::Hinge, InteractionKind::Universal}) {
        const std::string name = kind_info(kind).name;
        // The bow of 5 cm contains about 150 J; many times more is created energy.
        EXPECT_LT(late_energy(taut_chain(kind, 0.1).make()), 5e3) << name;
        // Without damping the energy is above the bound: 9 to 20 kJ, depending on rounding.
        EXPECT_GT(late_energy(taut_chain(kind, 0.0).make()), 6e3) << name << ": damping unneeded";
    }
}

/// Short links under large forces: s (docs/theory/stiffness.md) is 130, 540 and 4300. With half of
/// the damping explicit at any s they reached megajoules, with gaps of metres.
TEST(JointDamping, HoldsTautChainsOfShortLinksTogether) {
    for (const double force : {5e5, 2e6, 1.6e7}) {
        const Chain chain{400, 0.25, 25.0, force, 1e-4};
        World w = taut_chain(InteractionKind::Ball, 0.1, chain).make();
        double late = 0.0, gap = 0.0;
        for (int i = 0; i < 600; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            if (i >= 540) late = std::max(late, w.energy().kinetic);
            gap = std::max(gap, w.stats().violation_max);
        }
        // Energy of the bow of 5 cm over the length L: T (A π/L)² L/4; the jolt of the start is
        // added.
        const double slope = 0.05 * EIGEN_PI / (chain.links * chain.length);
        const double bow = 0.25 * force * slope * slope * chain.links * chain.length;
        EXPECT_LT(late, 3.0 * bow) << force;
        EXPECT_GT(late, 0.1 * bow) << force << ": the bow's own motion is to stay";
        EXPECT_LT(gap, 2e-4) << force;
    }
}

/// Two hinged bars that swing under gravity: resolved at 60 Hz, so the default damping must be
/// negligible compared with their motion. Undamped and default agree to fifth order in the step.
TEST(JointDamping, LeavesAMechanismAlone) {
    auto angle_after = [](double damping, double h) {
        Recipe r;
        r.world.step = h;
        r.world.rotation_damping = damping;
        const Quat about_y(Eigen::AngleAxisd(-EIGEN_PI / 2, Vec3::UnitX()));
        BodyId last = r.ground();
        for (int i = 0; i < 2; ++i) {
            const BodyId bar =
                r.rigid({i + 0.5, 0, 0}, Quat::Identity(), 1.0, {0.01, 1. / 12, 1. / 12});
            r.add(r.at(InteractionKind::Hinge, {last, bar}, Vec3(i, 0, 0), about_y));
            last = bar;
        }
        World w = r.make();
        while (w.time() < 2.0 - 0.5 * h) EXPECT_EQ(w.step(), Status::ok);
        return w.pose(last).position;
    };
    const double coarse = (angle_after(0.1, 1. / 60) - angle_after(0.0, 1. / 60)).norm();
    const double fine = (angle_after(0.1, 1. / 120) - angle_after(0.0, 1. / 120)).norm();
    // The step's own error is 2e-2 m here (docs/theory/step.md: 2.6e-2 for a pendulum of 1 m).
    EXPECT_LT(coarse, 5e-3);
    EXPECT_LT(fine, coarse / 12.0) << "of fifth order, less what the chaos of the motion adds";
}

}  // namespace
}  // namespace hawser::test
