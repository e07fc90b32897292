// SPDX-License-Identifier: Apache-2.0
/// Relative-rotation damping of joints: it holds chains of stiff links together and leaves
/// motions that the step resolves alone.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hawser::test {
namespace {

/// 40 links of 2 m and 50 kg along x, 1 mm off the line to either side, pulled by 500 kN.
Recipe taut_chain(InteractionKind joint, double damping) {
    constexpr int kLinks = 40;
    constexpr double kLength = 2.0, kMass = 50.0, kAcross = kMass * kLength * kLength / 12.0;
    Recipe r;
    r.world.gravity = {0, 0, 0};
    r.world.rotation_damping = damping;
    auto node = [](int i) {
        const double off = i == 0 || i == kLinks ? 0.0 : (i % 2 ? 1e-3 : -1e-3);
        return Vec3(kLength * i, 0, off + 0.05 * std::sin(EIGEN_PI * i / kLinks));
    };
    const Quat about_y(Eigen::AngleAxisd(-EIGEN_PI / 2, Vec3::UnitX()));  // z of the frame along y
    BodyId last = r.ground();
    for (int i = 0; i < kLinks; ++i) {
        const Vec3 a = node(i), b = node(i + 1);
        const Quat q = turn_between(Vec3::UnitX(), b - a);
        const BodyId link = r.rigid(0.5 * (a + b), q, kMass, {0.06, kAcross, kAcross});
        InteractionDef d = r.at(joint, {last, link}, a, about_y);
        if (joint == InteractionKind::Universal)  // its second axis stands square to the first
            d.frame[1] = d.frame[1] * Quat(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()));
        r.add(d);
        last = link;
    }
    const Vec3 end = node(kLinks);
    const BodyId ship = r.rigid(end + Vec3(1, 0, 0), Quat::Identity(), 4e6, {1e8, 1e9, 1e9});
    r.bodies.back().force = {5e5, 0, 0};
    r.add(r.at(InteractionKind::Ball, {last, ship}, end));
    return r;
}

/// Largest kinetic energy in the last second of 20 s [J].
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
        // The bow of 5 cm holds about 150 J; what exceeds it many times over has been made up.
        EXPECT_LT(late_energy(taut_chain(kind, 0.1).make()), 5e3) << name;
        EXPECT_GT(late_energy(taut_chain(kind, 0.0).make()), 5e4) << name << ": no need for it";
    }
}

/// Two hinged bars that swing under gravity: resolved at 60 Hz, so the default damping must not
/// show beside the bars' motion. Undamped against default: the same to fifth order in the step.
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
    // The step's own error is 2e-2 m here (docs/methods.md: 2.6e-2 for a pendulum of 1 m).
    EXPECT_LT(coarse, 5e-3);
    EXPECT_LT(fine, coarse / 12.0) << "of fifth order, less what the chaos of the motion adds";
}

}  // namespace
}  // namespace hawser::test
