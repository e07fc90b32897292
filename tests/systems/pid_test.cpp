// SPDX-License-Identifier: Apache-2.0
/// The PID system at a winch that controls the tension of a line to a barge in swell.
#include <hawser/hawser.h>

#include "support/recipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <memory>

namespace hawser::test {
namespace {

constexpr double kLength = 20.0, kEA = 1e6, kRadius = 0.5;
constexpr double kSpeed = 0.5, kRate = 0.6;  ///< Motion of the barge: kSpeed cos(kRate t) [m/s,
                                             ///< rad/s].
constexpr double kGain = 4e-4, kReset = 0.3, kTarget = 20e3;

struct Tow {
    World w{WorldDef{}};
    BodyId barge{};
    InteractionId line{};
    InputId speed{};

    Tow() {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        barge =
            w.add_body({.name = "barge", .kind = BodyKind::kinematic, .position = {kLength, 0, 0}});
        const BodyId drum =
            w.add_body({.name = "drum", .kind = BodyKind::scalar, .mass = 30.0, .gravity = false});
        InteractionDef d = between(InteractionKind::WinchStretch, {deck, barge, drum});
        d.set("length", kLength).set("EA", kEA).set("radius", kRadius);
        line = w.add_interaction(d);
        const InteractionId motor =
            w.add_interaction(between(InteractionKind::ScalarMotor, {drum}));
        speed = w.add_input({.name = "winch speed", .interaction = motor, .param = "speed"});
    }
    void control() {
        // The drum pays out if it rotates forwards: higher tension requires less speed.
        w.add_system(std::make_unique<Pid>(PidDef{.name = "tension",
                                                  .measured = line,
                                                  .driven = speed,
                                                  .target = kTarget,
                                                  .gain = -kGain,
                                                  .reset = kReset,
                                                  .low = -5.0,
                                                  .high = 5.0}));
    }
    void step() {
        Twist t;
        t.linear.x() = kSpeed * std::cos(kRate * w.time());
        w.set_velocity(barge, t);
        ASSERT_EQ(w.step(), Status::ok);
    }
    /// Return the largest error of the tension from 10 s on, over two periods.
    double worst() {
        double most = 0.0;
        while (w.time() < 10.0 + 4.0 * M_PI / kRate) {
            step();
            if (w.time() > 10.0) most = std::max(most, std::abs(-w.force(line)[0] - kTarget));
        }
        return most;
    }
};

TEST(PidSystem, HoldsTheTensionOfAWinchAsTheClosedLoopSays) {
    Tow held;
    held.control();
    const double worst = held.worst();
    // Line of stiffness k = EA/l, drum of radius r: s E = −k (V + r U), U = −G (1 + 1/(T s)) E.
    const std::complex<double> s(0.0, kRate);
    const double k = kEA / kLength, loop = k * kRadius * kGain;
    const double theory = std::abs(k * kSpeed * s / (s * s + loop * s + loop / kReset));
    std::printf("tension off by %.0f N of %.0f N, by theory %.0f N\n", worst, kTarget, theory);
    // The line's stiffness depends on its length, within 5 %; the loop is late by a step.
    EXPECT_NEAR(worst, theory, 0.1 * theory);
    EXPECT_NEAR(held.w.system_signal("tension.measured"), kTarget, 1.1 * theory);
    // With a stopped winch the tension varies by k × 0.83 m, and the line goes slack.
    Tow still;
    EXPECT_GT(still.worst(), 15e3);
}

TEST(PidSystem, IsPartOfTheStateAndTakesNewTargets) {
    Tow a, b;
    a.control();
    b.control();
    for (int i = 0; i < 100; ++i) a.step();
    a.w.set_system_signal("tension.target", 10e3);
    const auto saved = a.w.state().save();
    World twin = a.w.twin();
    b.w.state().restore(saved);
    EXPECT_EQ(b.w.system_signal("tension.target"), 10e3);
    for (int i = 0; i < 200; ++i) {
        a.step();
        b.step();
        twin.set_velocity(a.barge, a.w.velocity(a.barge));
        ASSERT_EQ(twin.step(), Status::ok);
        ASSERT_EQ(a.w.state().hash(), b.w.state().hash());
        ASSERT_EQ(a.w.state().hash(), twin.state().hash());
    }
    EXPECT_NEAR(a.w.system_signal("tension.measured"), 10e3, 1e3);
}

TEST(PidSystem, OfNothingEndsTheStepAndSaysWho) {
    Tow t;
    t.w.add_system(std::make_unique<Pid>(PidDef{.measured = t.line, .row = 7, .driven = t.speed}));
    EXPECT_EQ(t.w.step(), Status::bad_load);
    EXPECT_NE(to_string(t.w.bad_load(), t.w).find("'pid'"), std::string::npos);
}

}  // namespace
}  // namespace hawser::test
