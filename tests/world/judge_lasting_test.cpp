// SPDX-License-Identifier: Apache-2.0
/// Violated ranges and overlapping bodies end a run; impacts at the end of a range, and falls, do
/// not.
#include <hawser/hawser.h>
#include <hawser/limits.h>

#include <gtest/gtest.h>

#include <string>

namespace hawser {
namespace {

/// A wheel on a hinge, with ranges of its angle.
struct Wheel {
    World world;
    BodyId ground, wheel;
    explicit Wheel(double speed = 0.0) : world({.step = 1.0 / 60.0}) {
        ground = world.add_body({.kind = BodyKind::fixed});
        wheel = world.add_body({.angular_velocity = {0, 0, speed},
                                .mass = 1000,
                                .inertia = Mat3::Identity() * 167.0,
                                .gravity = false});
        world.add_interaction({.kind = InteractionKind::Hinge, .body = {ground, wheel}});
    }
    Wheel& range(const std::string& name, double min, double max) {
        InteractionDef d{
            .name = name, .kind = InteractionKind::HingeRange, .body = {ground, wheel}};
        d.set("min", min);
        d.set("max", max);
        world.add_interaction(d);
        return *this;
    }
};

Status run(World& w, int steps) {
    Status status = Status::ok;
    for (int i = 0; i < steps && status == Status::ok; ++i) status = w.step();
    return status;
}

TEST(MonitorLasting, RangesThatContradictEachOtherEndTheRun) {
    Wheel m;
    m.range("left", 0.5, 0.6).range("right", -0.6, -0.5);
    EXPECT_EQ(run(m.world, 60), Status::diverged);
    const Verdict v = m.world.verdict();
    EXPECT_EQ(v.judge, Judge::violation);
    const std::string& name = m.world.interaction_def(v.of(v.judge).interaction).name;
    EXPECT_TRUE(name == "left" || name == "right") << name;
}

TEST(MonitorLasting, AMotorThatPushesBeyondARangeEndsTheRun) {
    Wheel m;
    m.range("stop", -0.1, 0.1);
    InteractionDef motor{.kind = InteractionKind::HingeMotor, .body = {m.ground, m.wheel}};
    motor.set("speed", 1.0);
    m.world.add_interaction(motor);
    EXPECT_EQ(run(m.world, 120), Status::diverged);
    EXPECT_EQ(m.world.verdict().judge, Judge::violation);
}

TEST(MonitorLasting, WhatStrikesTheEndOfItsRangeIsGood) {
    // In a step it moves 0.033 rad beyond, 14 mm at its edge: above the limit of suspect.
    Wheel m(2.0);
    m.range("stop", -0.3, 0.3);
    ASSERT_EQ(run(m.world, 240), Status::ok);
    EXPECT_EQ(m.world.verdict().grade, Grade::good);
    EXPECT_GT(m.world.stats().event_count[static_cast<std::size_t>(EventKind::range)], 0);
}

/// Make a ball on a plate that is thinner than the ball.
World ball_on_plate(double mass, double height) {
    World w({.step = 1.0 / 60.0});
    const BodyId plate = w.add_body({.name = "plate", .kind = BodyKind::fixed});
    w.add_shape({.kind = ShapeKind::box, .body = plate, .half_size = {5, 5, 0.05}});
    const BodyId ball = w.add_body({.name = "ball",
                                    .position = {0, 0, 1.05 + height},
                                    .mass = mass,
                                    .inertia = Mat3::Identity() * 0.4 * mass});
    w.add_shape({.kind = ShapeKind::sphere, .body = ball, .radius = 1.0});
    return w;
}

TEST(MonitorLasting, WhatSinksThroughAPlateEndsTheRun) {
    World w = ball_on_plate(3e7, 0.1);
    EXPECT_EQ(run(w, 300), Status::diverged);
    const Verdict v = w.verdict();
    EXPECT_EQ(v.judge, Judge::violation);
    EXPECT_EQ(w.body_def(v.of(v.judge).body).name, "plate");
}

TEST(MonitorLasting, AShapeThatCameWhileTheWorldRanIsJudgedAsWell) {
    World w({.step = 1.0 / 60.0});
    const BodyId plate = w.add_body({.name = "plate", .kind = BodyKind::fixed});
    w.add_shape(
        {.kind = ShapeKind::box, .body = plate, .position = {0, 50, 0}, .half_size = {1, 1, 1}});
    const BodyId ball = w.add_body({.name = "ball",
                                    .position = {0, 0, 1.1},
                                    .mass = 3e7,
                                    .inertia = Mat3::Identity() * 1.2e7,
                                    .gravity = false});
    w.add_shape({.kind = ShapeKind::sphere, .body = ball, .radius = 1.0});
    ASSERT_EQ(run(w, 10), Status::ok);
    w.add_shape({.kind = ShapeKind::box, .body = plate, .half_size = {5, 5, 0.05}});
    w.set_force(ball, {0, 0, -3e8}, Vec3::Zero());
    EXPECT_EQ(run(w, 300), Status::diverged);
    const Verdict v = w.verdict();
    EXPECT_EQ(v.judge, Judge::violation);
    EXPECT_EQ(w.body_def(v.of(v.judge).body).name, "plate");
}

TEST(MonitorLasting, WhatFallsOnAPlateIsGood) {
    World w = ball_on_plate(1e3, 3.0);
    ASSERT_EQ(run(w, 300), Status::ok);
    EXPECT_EQ(w.verdict().grade, Grade::good);
}

TEST(MonitorLasting, ARestoredWorldGivesTheSameVerdictAtTheSameStep) {
    World w = ball_on_plate(3e7, 0.1), other = ball_on_plate(3e7, 0.1);
    int steps = 0;
    std::vector<std::byte> saved;
    while (w.step() == Status::ok && steps < 300) {
        ++steps;
        saved = w.state().save();
    }
    other.state().restore(saved);
    EXPECT_EQ(other.step(), Status::diverged);
    EXPECT_EQ(other.verdict().of(Judge::violation).wrong, w.verdict().of(Judge::violation).wrong);
}

}  // namespace
}  // namespace hawser
