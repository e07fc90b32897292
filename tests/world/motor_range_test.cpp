// SPDX-License-Identifier: Apache-2.0
/// Motors at the ends of their force range.
#include "support/recipe.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

/// A motor at one end of its range gets the opposite speed. It passes to the other end at once,
/// although its force in a step is far less than the required change.
TEST(MotorRange, IsCrossedFromOneEndToTheOther) {
    Recipe r;
    const BodyId drum = r.scalar(0.0, 30.0);
    r.bodies.back().gravity = false;
    InteractionDef d = between(InteractionKind::ScalarMotor, {drum});
    const InteractionId motor =
        r.add(d.set("speed", 5.0).set("force_min", -6.0).set("force_max", 6.0));
    World w = r.make();
    const double h = w.settings().step;
    const InputId speed = w.add_input({.name = "speed", .interaction = motor, .param = "speed"});
    for (int i = 0; i < 50; ++i) ASSERT_EQ(w.step(), Status::ok);
    const double turned = w.velocity(drum).linear.x();
    EXPECT_NEAR(turned, 49.5 * h * 6.0 / 30.0, 1e-12);  // the first step starts half a step late
    w.set_input(speed, -5.0);
    for (int i = 1; i <= 100; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_NEAR(w.force(motor)[0], -6.0, 1e-12) << i;
        ASSERT_NEAR(w.velocity(drum).linear.x(), turned - i * h * 6.0 / 30.0, 1e-12) << i;
    }
}

/// A clutch accelerates one drum by another with its holding torque until both rotate together: J₁
/// ω / (J₁ + J₂), for any slip.
TEST(MotorRange, AClutchSlipsUntilBothTurnAsOne) {
    Recipe r;
    const BodyId wheel = r.scalar(0.0, 30.0), chain = r.scalar(0.0, 20.0);
    for (BodyDef& body : r.bodies) body.gravity = false;
    r.bodies.front().velocity = {2.0, 0, 0};
    InteractionDef d = between(InteractionKind::ScalarClutch, {wheel, chain});
    const InteractionId clutch = r.add(d.set("force_min", -12.0).set("force_max", 12.0));
    World w = r.make();
    const double h = w.settings().step;
    ASSERT_EQ(w.step(), Status::ok);  // half a step late
    for (int i = 1; i <= 100; ++i) {
        const double before = w.velocity(chain).linear.x();
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_NEAR(w.force(clutch)[0], 12.0, 1e-9);
        ASSERT_NEAR(w.velocity(chain).linear.x(), before + h * 12.0 / 20.0, 1e-12);
    }
    for (int i = 0; i < 400; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.velocity(wheel).linear.x(), 1.2, 1e-9);
    EXPECT_NEAR(w.velocity(chain).linear.x(), 1.2, 1e-9);
}

/// The range of a motor's force need not contain 0: a winch that holds between two tensions. It
/// exerts the end against its motion, in either direction, and stops between.
TEST(MotorRange, MayLieOnOneSideOfZero) {
    Recipe r;
    const BodyId drum = r.scalar(0.0, 30.0);
    r.bodies.back().gravity = false;
    InteractionDef d = between(InteractionKind::ScalarMotor, {drum});
    const InteractionId motor = r.add(d.set("force_min", -12.0).set("force_max", -8.0));
    World w = r.make();
    const double h = w.settings().step;
    ASSERT_EQ(w.step(), Status::ok);  // after the start, which is half a step
    const auto expect_force = [&](double pull, double speed, double force) {
        w.set_force(drum, {pull, 0, 0}, Vec3::Zero());
        w.set_velocity(drum, {.linear = {speed, 0, 0}});
        ASSERT_EQ(w.step(), Status::ok);
        // Between its ends it creeps due to its compliance, 1e-12 rad/s/(N m).
        EXPECT_NEAR(w.force(motor)[0], force, 1e-7) << pull << " N m at " << speed << " rad/s";
        EXPECT_NEAR(w.velocity(drum).linear.x(), speed + h * (pull + force) / 30.0, 1e-9);
    };
    expect_force(10.0, -1.0, -8.0);
    expect_force(10.0, 1.0, -12.0);
    expect_force(10.0, -1.0, -8.0);
    expect_force(20.0, -1.0, -8.0);
    expect_force(20.0, 1.0, -12.0);
    expect_force(0.0, 0.0, -8.0);
    expect_force(13.0, 0.0, -12.0);
    expect_force(9.0, 0.0, -9.0);
}

/// A motor without force is off, not at the end of its range.
TEST(MotorRange, OfNothingIsNotSaturated) {
    Recipe r;
    const BodyId drum = r.scalar(0.0, 30.0);
    InteractionDef d = between(InteractionKind::ScalarMotor, {drum});
    const InteractionId motor =
        r.add(d.set("speed", 5.0).set("force_min", 0.0).set("force_max", 0.0));
    World w = r.make();
    const InputId most = w.add_input({.name = "most", .interaction = motor, .param = "force_max"});
    for (int i = 0; i < 10; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.events().extremes(EventKind::saturation).count, 0);
    w.set_input(most, 6.0);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.events().extremes(EventKind::saturation).count, 1);
    EXPECT_EQ(w.events().extremes(EventKind::saturation).first.value, 6.0);
}

}  // namespace
}  // namespace hawser::test
