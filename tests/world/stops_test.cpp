// SPDX-License-Identifier: Apache-2.0
/// Ends of the ranges of joints: bodies and motors that reach them, compared with closed forms
/// (docs/theory/impacts.md).
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

constexpr double kSteps[] = {1.0 / 30.0, 1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0};

/// A body of a slide or hinge with a range and perhaps a motor.
struct Guided {
    World world;
    BodyId body;
    InteractionId range, motor;
    [[nodiscard]] double at() const { return world.coordinate(range); }
};

struct GuidedDef {
    double step = 1.0 / 60.0, mass = 1.0, speed = 0.0;
    double min = -1.0, max = 1.0;
    double compliance = kDefault, damping_time = kDefault;
    bool turns = false;
    double motor_speed = kDefault, motor_force = 0.0;
};

Guided make_guided(const GuidedDef& d) {
    Guided out{World({.step = d.step, .gravity = {0, 0, 0}}), {}, {}, {}};
    World& w = out.world;
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    BodyDef body{.mass = d.mass, .inertia = d.mass * Mat3::Identity()};
    // The centre of mass lies on the axis of the hinge.
    (d.turns ? body.angular_velocity : body.velocity) = {0, 0, d.speed};
    out.body = w.add_body(body);
    const auto add = [&](InteractionKind slides, InteractionKind turns) {
        return InteractionDef{.kind = d.turns ? turns : slides, .body = {ground, out.body}};
    };
    w.add_interaction(add(InteractionKind::Prismatic, InteractionKind::Hinge));
    InteractionDef range = add(InteractionKind::SlideRange, InteractionKind::HingeRange);
    range.set("min", d.min).set("max", d.max);
    range.compliance[0] = d.compliance;
    range.damping_time[0] = d.damping_time;
    out.range = w.add_interaction(range);
    if (std::isnan(d.motor_speed)) return out;
    InteractionDef motor = add(InteractionKind::SlideMotor, InteractionKind::HingeMotor);
    motor.set("speed", d.motor_speed);
    motor.set("force_min", -d.motor_force).set("force_max", d.motor_force);
    out.motor = w.add_interaction(motor);
    return out;
}

/// A body at constant speed stops at the end of its range, for any distance in its step.
TEST(Stops, ABodyStopsAtTheEnd) {
    Random random(first_seed(1));
    for (int i = by_tier(60, 1000, 10'000); i > 0; --i) {
        GuidedDef d;
        d.step = kSteps[random.integer(0, 3)];
        d.mass = std::pow(10.0, random.uniform(-2, 4));
        d.speed = random.uniform(-8.0, 8.0);
        d.min = -random.uniform(1e-3, 1.0);
        d.max = random.uniform(1e-3, 1.0);
        d.turns = random.chance(0.5);
        Guided g = make_guided(d);
        SCOPED_TRACE(::testing::Message() << d.speed << " in " << d.min << " to " << d.max << ", "
                                          << d.step << " s, " << d.mass << " kg");
        // The stop yields by 1e-12 m/N under the impact; the body returns at this way per step.
        const double yields = 1e-9 + 1e-12 * d.mass * std::abs(d.speed) / d.step;
        for (int k = 1; k * d.step * std::abs(d.speed) < 3.0; ++k) {
            ASSERT_EQ(g.world.step(), Status::ok);
            const double exact = std::clamp(d.speed * k * d.step, d.min, d.max);
            ASSERT_NEAR(g.at(), exact, k * yields) << "step " << k;
            ASSERT_LE(g.at(), d.max + yields);
            ASSERT_GE(g.at(), d.min - yields);
        }
        EXPECT_EQ(g.world.verdict().grade, Grade::good);
        // The stop has absorbed the energy.
        const Energy e = g.world.energy();
        EXPECT_LT(e.kinetic, d.mass * std::pow(yields / d.step, 2));
        EXPECT_NEAR(e.damped, 0.5 * d.mass * d.speed * d.speed, 1e-6 * d.mass * d.speed * d.speed);
    }
}

/// A motor of limited force drives a body from rest into the end of its range and holds it there.
TEST(Stops, AMotorHoldsAtTheEnd) {
    Random random(first_seed(2));
    for (int i = by_tier(40, 1000, 10'000); i > 0; --i) {
        GuidedDef d;
        d.step = kSteps[random.integer(0, 3)];
        d.mass = std::pow(10.0, random.uniform(-1, 3));
        d.max = std::pow(10.0, random.uniform(-4, 0));
        d.min = -d.max;
        d.turns = random.chance(0.5);
        d.motor_speed = random.uniform(5.0, 40.0) * (random.chance(0.5) ? 1.0 : -1.0);
        d.motor_force = d.mass * std::pow(10.0, random.uniform(0, 5));
        Guided g = make_guided(d);
        SCOPED_TRACE(::testing::Message() << d.motor_force << " N at " << d.motor_speed << ", to "
                                          << d.max << ", " << d.step << " s, " << d.mass << " kg");
        // The stop has a compliance of 1e-12 m/N or rad/(N m).
        const double hit = d.mass * std::abs(d.motor_speed) / d.step;
        const double end = d.max + 2e-12 * d.motor_force + 1e-12 * hit + 1e-9;
        double start = 0.0;
        for (int k = 0; k < static_cast<int>(2.0 / d.step); ++k) {
            ASSERT_EQ(g.world.step(), Status::ok);
            ASSERT_LE(std::abs(g.at()), end) << "step " << k;
            const Energy e = g.world.energy();
            // The work of the first step belongs to both sides of the start.
            if (k == 0) start = e.kinetic - e.driven;
            ASSERT_LE(e.kinetic, e.driven + start + 1e-9 * (e.driven + d.motor_force))
                << "step " << k;
        }
        if (d.motor_force / d.mass >= 10.0) {
            EXPECT_NEAR(std::abs(g.at()), d.max, 2e-12 * d.motor_force + 1e-9);
            EXPECT_NEAR(std::abs(g.world.force(g.range)[0]), d.motor_force, 1e-4 * d.motor_force);
        }
        EXPECT_EQ(g.world.verdict().grade, Grade::good);
    }
}

/// A motor that reverses moves a body from one end to the other, also if both are closer than its
/// travel of a step.
TEST(Stops, AMotorReversesBetweenBothEnds) {
    for (const double step : kSteps)
        for (const double half : {1e-4, 1e-2, 0.3}) {
            GuidedDef d{
                .step = step, .min = -half, .max = half, .motor_speed = 20.0, .motor_force = 1e4};
            Guided g = make_guided(d);
            const InputId speed =
                g.world.add_input({.name = "speed", .interaction = g.motor, .param = "speed"});
            for (int k = 0; k < 12; ++k) {
                const double sign = k % 2 == 0 ? 1.0 : -1.0;
                g.world.set_input(speed, 20.0 * sign);
                for (int i = 0; i < static_cast<int>(0.2 / step); ++i) {
                    ASSERT_EQ(g.world.step(), Status::ok);
                    ASSERT_LE(std::abs(g.at()), half + 1e-7) << step << " s, " << half << " m";
                }
                EXPECT_NEAR(g.at(), sign * half, 1e-7) << step << " s, " << half << " m";
            }
            EXPECT_EQ(g.world.verdict().grade, Grade::good);
        }
}

/// A spring without damping at the end of a range returns the energy of a body. Exact: the contact
/// lasts π √(m ε), and the body leaves at its speed.
TEST(Stops, ASpringAtTheEndReturnsTheBody) {
    Random random(first_seed(3));
    for (int i = by_tier(20, 500, 5000); i > 0; --i) {
        GuidedDef d;
        d.step = kSteps[random.integer(1, 3)];
        d.mass = std::pow(10.0, random.uniform(-1, 3));
        d.speed = random.uniform(0.5, 5.0);
        d.max = random.uniform(0.1, 0.4);
        const double turn = random.uniform(0.05, 0.3);  // hω of the body on its spring
        d.compliance = d.step * d.step / (turn * turn * d.mass);
        d.damping_time = 0.0;
        Guided g = make_guided(d);
        const double lasts = 3.14159265358979323846 * d.step / turn, hits = d.max / d.speed;
        const int steps = static_cast<int>((hits + lasts) / d.step) + 4;
        for (int k = 0; k < steps; ++k) ASSERT_EQ(g.world.step(), Status::ok);
        const double speed = g.world.velocity(g.body).linear.z();
        // Entry and exit within a step change the speed by up to (hω)²/8 each.
        EXPECT_NEAR(speed, -d.speed, 0.3 * turn * turn * d.speed) << turn;
        const double back = d.max - d.speed * (steps * d.step - hits - lasts);
        EXPECT_NEAR(g.at(), back, 0.6 * turn * d.step * d.speed) << turn;
        EXPECT_EQ(g.world.verdict().grade, Grade::good);
    }
}

/// A motor without a limit of force that drives against a range is named by the step that fails.
TEST(Stops, AMotorWithoutLimitIsNamed) {
    GuidedDef d{.max = 0.5, .turns = true, .motor_speed = 20.0, .motor_force = 1e30};
    Guided g = make_guided(d);
    Status status = Status::ok;
    for (int k = 0; k < 60 && status == Status::ok; ++k) status = g.world.step();
    EXPECT_EQ(status, Status::diverged);
    const Verdict v = g.world.verdict();
    EXPECT_EQ(v.worst[static_cast<std::size_t>(Judge::violation)].interaction, g.motor);
}

}  // namespace
}  // namespace hawser::test
