// SPDX-License-Identifier: Apache-2.0
/// Gears against closed forms: ratio, energy, and the reaction on their carrier.
#include <hawser/hawser.h>

#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hawser {
namespace {

constexpr double kStep = 1e-3;
constexpr double kFirst = 0.2, kSecond = 1.5;  // Moments of inertia about the axes [kg m²].

/// Two wheels on a carrier, without gravity.
struct Train {
    World w{{.step = kStep, .gravity = Vec3::Zero()}};
    BodyId carrier, first, second;
    InteractionId gear;
    JointIds hinge[2];

    Train(bool fixed, int teeth_1, int teeth_2) {
        BodyDef def{.name = "carrier", .kind = fixed ? BodyKind::fixed : BodyKind::rigid};
        if (!fixed) {
            def.mass = 30.0;
            def.inertia = Mat3::Identity() * 4.0;
        }
        carrier = w.add_body(def);
        const auto wheel = [&](const char* name, double x, double about) {
            return w.add_body({.name = name,
                               .position = {x, 0, 0},
                               .mass = 5.0,
                               .inertia = Vec3(0.6 * about, 0.6 * about, about).asDiagonal()});
        };
        first = wheel("first", 0.5, kFirst);
        second = wheel("second", -0.5, kSecond);
        const BodyId wheels[] = {first, second};
        for (int k = 0; k < 2; ++k)
            hinge[k] =
                w.add(HingeDef{.a = carrier, .b = wheels[k], .point = {k == 0 ? 0.5 : -0.5, 0, 0}});
        gear = w.add(GearDef{.name = "gear",
                             .carrier = carrier,
                             .first = first,
                             .second = second,
                             .teeth_first = teeth_1,
                             .teeth_second = teeth_2});
    }
    [[nodiscard]] double spin(BodyId body) const { return w.velocity(body).angular.z(); }
};

TEST(Gear, TurnsAsTheTeethSayUnderATorque) {
    for (const int teeth_2 : {60, -60}) {
        Train t(true, 20, teeth_2);
        verify::Verifier verifier(t.w);
        const double torque = 3.0, ratio = 20.0 / teeth_2;  // ω₂ = −ratio ω₁
        t.w.set_force(t.first, Vec3::Zero(), {0, 0, torque});
        constexpr int kSteps = 2000;
        for (int i = 0; i < kSteps; ++i) {
            verifier.before_step(t.w);
            ASSERT_EQ(t.w.step(), Status::ok);
            ASSERT_EQ(verifier.after_step(t.w), "") << "step " << i;
        }
        // One rotation with inertia I₁ + ratio² I₂; velocities belong to half a step before.
        const double inertia = kFirst + ratio * ratio * kSecond;
        const double speed = torque / inertia * (kSteps - 0.5) * kStep;
        // The row constrains angles, and a body at ω rotates by 2 atan(h ω/2) in a step: speeds
        // have a relative error of (h ω)²/12.
        const double off = speed * kStep * speed * kStep / 12.0;
        EXPECT_NEAR(t.spin(t.first), speed, 1.1 * off * speed);
        EXPECT_NEAR(t.spin(t.second), -ratio * speed, 1.1 * off * ratio * ratio * 3.0 * speed);
        EXPECT_GT(0.5 * speed * kSteps * kStep, 10.0);  // several revolutions
        EXPECT_NEAR(t.w.energy().kinetic, 0.5 * inertia * speed * speed,
                    2.2 * off * t.w.energy().kinetic);
        // The teeth accelerate the second wheel, relative to the first: −I₂ α₂ ratio. The relative
        // error above grows by 2 (h ω)²/12 as the speed doubles.
        const double teeth = -ratio * ratio * kSecond * torque / inertia;
        EXPECT_NEAR(t.w.force(t.gear)[0], teeth, 3.3 * off / (ratio * ratio) * std::abs(teeth));
    }
}

TEST(Gear, PushesTheCarrierBack) {
    // No external torque: a motor between the carrier and the first wheel rotates all three so that
    // their angular momentum stays 0, including the orbit of the wheels.
    Train t(false, 20, 50);
    InteractionDef motor = t.w.interaction_def(t.hinge[0].joint);
    motor.kind = InteractionKind::HingeMotor;
    motor.compliance.fill(kDefault);
    motor.damping_time.fill(kDefault);
    motor.params.fill(kDefault);
    motor.set("speed", 5.0).set("force_min", -2.0).set("force_max", 2.0);
    (void)t.w.add_interaction(motor);
    verify::Verifier verifier(t.w);
    for (int i = 0; i < 3000; ++i) {
        verifier.before_step(t.w);
        ASSERT_EQ(t.w.step(), Status::ok);
        ASSERT_EQ(verifier.after_step(t.w), "") << "step " << i;
    }
    double total = 0.0, size = 0.0;
    for (const auto& [body, about] :
         {std::pair(t.carrier, 4.0), std::pair(t.first, kFirst), std::pair(t.second, kSecond)}) {
        const BodyDef& def = t.w.body_def(body);
        // Move a body's centre to the middle of its step.
        const Vec3 v = t.w.velocity(body).linear, x = t.w.pose(body).position - 0.5 * kStep * v;
        const double one = def.mass * x.cross(v).z() + about * t.spin(body);
        total += one;
        size += std::abs(one);
    }
    EXPECT_GT(size, 0.5);
    // Hinges whose arms rotate within a step conserve it to second order.
    EXPECT_LT(std::abs(total), 1e-3 * size);
    const double slip = 20.0 * (t.spin(t.first) - t.spin(t.carrier)) +
                        50.0 * (t.spin(t.second) - t.spin(t.carrier));
    EXPECT_LT(std::abs(slip), 20.0 * 5.0 * kStep * kStep * 25.0 / 6.0);  // as above
    EXPECT_NEAR(t.spin(t.first) - t.spin(t.carrier), 5.0, 1e-6);
}

TEST(Gear, RefusesTeethThatAreNone) {
    Train t(true, 20, 30);
    const auto add = [&](int a, int b) {
        t.w.add(GearDef{.carrier = t.carrier,
                        .first = t.first,
                        .second = t.second,
                        .teeth_first = a,
                        .teeth_second = b});
    };
    EXPECT_THROW(add(0, 20), DefError);
    EXPECT_THROW(add(20, 0), DefError);
    InteractionDef half = t.w.interaction_def(t.gear);
    half.name = "half";
    half.set("teeth_2", 20.5);
    try {
        (void)t.w.add_interaction(half);
        FAIL();
    } catch (const DefError& error) {
        EXPECT_NE(std::string(error.what()).find("whole numbers"), std::string::npos);
    }
}

TEST(Gear, SaysThatATeethWasJumped) {
    // Rotated by a third of a tooth by hand: the monitor of joints names the gear.
    Train t(true, 8, 8);
    ASSERT_EQ(t.w.step(), Status::ok);
    Pose pose = t.w.pose(t.second);
    pose.orientation = Quat(Eigen::AngleAxisd(2.0 * std::acos(-1.0) / 8.0 / 3.0, Vec3::UnitZ())) *
                       pose.orientation;
    t.w.set_pose(t.second, pose);
    bool named = t.w.step() == Status::diverged;
    for (const Event& e : t.w.events().take())
        named = named || (e.kind == EventKind::joint_open && e.interaction == t.gear);
    EXPECT_TRUE(named);
}

}  // namespace
}  // namespace hawser
