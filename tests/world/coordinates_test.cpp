// SPDX-License-Identifier: Apache-2.0
/// World::coordinate(), speed() and motor_force(): for poses made by hand with known angles and
/// distances, and for steps, against differences of coordinates.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hawser::test {
namespace {

Quat turn_about(const Vec3& axis, double angle) {
    return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// Two free bodies with one interaction between them. The second one is rotated by `angle` about,
/// and moved by `way` along, the z axis of a frame that is tilted in the world.
struct JointPair {
    World world{WorldDef{.gravity = {0, 0, 0}}};
    BodyId a, b;
    InteractionId id;

    JointPair(InteractionKind kind, double angle, double way) {
        const Quat lean = turn_about({1, 2, 3}, 0.7), qa = turn_about({3, -1, 2}, 1.1);
        const Vec3 point(1, 2, 3), pa(0.4, -0.2, 0.3), pb(-0.3, 0.5, 0.2);
        const Quat turn = lean * turn_about({0, 0, 1}, angle);
        const Quat own = turn_about({-1, 1, 1}, 0.9);  // frame 1 in b
        const Quat qb = turn * own.conjugate();
        const Mat3 inertia = Vec3(1, 2, 2.5).asDiagonal();
        a = world.add_body({.name = "a",
                            .position = point - qa * pa,
                            .orientation = qa,
                            .mass = 2,
                            .inertia = inertia});
        b = world.add_body({.name = "b",
                            .position = point + way * (lean * Vec3::UnitZ()) - qb * pb,
                            .orientation = qb,
                            .mass = 3,
                            .inertia = inertia});
        InteractionDef d = between(kind, {a, b});
        d.point = {pa, pb};
        d.frame = {qa.conjugate() * lean, own};
        if (kind_info(kind).is(kRangeKind)) d.set("min", -0.1).set("max", 0.1);
        if (kind == InteractionKind::Twist) d.set("GJ", 1.0).set("length", 1.0);
        id = world.add_interaction(d);
    }
};

TEST(Coordinates, AnglesAreThoseOfTheFrames) {
    using enum InteractionKind;
    for (const InteractionKind kind : {Hinge, HingeMotor, HingeRange, HingeFriction, Twist})
        for (const double angle : {-3.0, -0.6, 0.0, 0.1, 1.0, 3.1}) {
            const JointPair pair(kind, angle, 0.0);
            // Rounding of a few rotations.
            EXPECT_NEAR(pair.world.coordinate(pair.id), angle, 1e-14) << kind_info(kind).name;
        }
    // Beyond half a revolution it continues from the other end.
    EXPECT_NEAR(JointPair(Hinge, 3.3, 0.0).world.coordinate({0}), 3.3 - 2.0 * std::numbers::pi,
                1e-14);
}

TEST(Coordinates, WaysAreAlongTheFirstFrame) {
    using enum InteractionKind;
    for (const InteractionKind kind :
         {Prismatic, Cylindrical, SlideMotor, SlideRange, SlideFriction})
        for (const double way : {-2.0, 0.0, 0.05, 7.0}) {
            const JointPair pair(kind, 0.0, way);
            EXPECT_NEAR(pair.world.coordinate(pair.id), way, 1e-14) << kind_info(kind).name;
        }
}

TEST(Coordinates, OfAScalarBodyItIsItsOwn) {
    World world;
    const BodyId drum = world.add_body(
        {.kind = BodyKind::scalar, .position = {2.5, 0, 0}, .velocity = {-0.3, 0, 0}, .mass = 1});
    using enum InteractionKind;
    for (const InteractionKind kind : {Hold, ScalarMotor, ScalarFriction}) {
        const InteractionId id = world.add_interaction(between(kind, {drum}));
        EXPECT_EQ(world.coordinate(id), 2.5);
        EXPECT_EQ(world.speed(id), -0.3);
    }
}

TEST(Coordinates, OfAClutchItIsThatOfTheSecondBodyAgainstTheFirst) {
    World world;
    const BodyId wheel = world.add_body(
        {.kind = BodyKind::scalar, .position = {2.5, 0, 0}, .velocity = {-0.3, 0, 0}, .mass = 1});
    const BodyId chain = world.add_body(
        {.kind = BodyKind::scalar, .position = {4.0, 0, 0}, .velocity = {0.1, 0, 0}, .mass = 1});
    const InteractionId id =
        world.add_interaction(between(InteractionKind::ScalarClutch, {wheel, chain}));
    EXPECT_EQ(world.coordinate(id), 1.5);
    EXPECT_EQ(world.speed(id), 0.4);
}

/// The speed is the derivative of the coordinate along the velocities: by central differences of
/// poses moved by hand, with an error of order e².
TEST(Coordinates, SpeedsAreTheirDerivatives) {
    using enum InteractionKind;
    for (const InteractionKind kind : {Hinge, HingeMotor, HingeRange, HingeFriction, Prismatic,
                                       Cylindrical, SlideMotor, SlideRange, SlideFriction}) {
        JointPair pair(kind, 0.4, 0.0);
        const hawser::Twist twist[2] = {{{0.3, -0.1, 0.2}, {0.5, 0.2, -0.4}},
                                        {{-0.2, 0.6, 0.1}, {-0.1, 0.7, 0.3}}};
        const BodyId body[2] = {pair.a, pair.b};
        const Pose start[2] = {pair.world.pose(pair.a), pair.world.pose(pair.b)};
        for (int k = 0; k < 2; ++k) pair.world.set_velocity(body[k], twist[k]);
        const double speed = pair.world.speed(pair.id);
        const double e = 1e-5;
        double q[2];
        for (int side = 0; side < 2; ++side) {
            const double t = side == 0 ? -e : e;
            for (int k = 0; k < 2; ++k) {
                const Vec3 w = twist[k].angular;
                pair.world.set_pose(body[k], {start[k].position + t * twist[k].linear,
                                              turn_about(w, t * w.norm()) * start[k].orientation});
            }
            q[side] = pair.world.coordinate(pair.id);
        }
        // Rounding of q over 2e: 1e-16/2e-5; e² times third derivatives of order one.
        EXPECT_NEAR(speed, (q[1] - q[0]) / (2.0 * e), 1e-9) << kind_info(kind).name;
    }
}

/// The motor of a hinge holds a speed against a torque: force, speed and coordinate have known
/// values.
TEST(Coordinates, AMotorTurnsAtItsSpeed) {
    World world({.step = 1.0 / 100.0, .gravity = {0, 0, 0}});
    const BodyId ground = world.add_body({.kind = BodyKind::fixed});
    const BodyId wheel =
        world.add_body({.mass = 1, .inertia = Vec3(1, 1, 2).asDiagonal(), .torque = {0, 0, -3}});
    (void)world.add_interaction(between(InteractionKind::Hinge, {ground, wheel}));
    InteractionDef d = between(InteractionKind::HingeMotor, {ground, wheel});
    const InteractionId motor = world.add_interaction(d.set("speed", 0.5));
    for (int i = 0; i < 100; ++i) ASSERT_EQ(world.step(), Status::ok);
    EXPECT_NEAR(world.speed(motor), 0.5, 1e-9);
    // From rest, the staggered start loses half a step of motion.
    EXPECT_NEAR(world.coordinate(motor), 0.5, 0.5 / 100.0 + 1e-9);
    EXPECT_NEAR(world.motor_force(motor), 3.0, 1e-8);  // it holds against −3 N m
}

std::string coordinate_refusal(const auto& call) {
    try {
        call();
    } catch (const DefError& error) {
        return error.what();
    }
    return "";
}

TEST(Coordinates, KindsWithoutOneAreRefused) {
    Recipe r = pendulum();
    World world = r.make();
    const std::string said = coordinate_refusal([&] { (void)world.coordinate({0}); });
    EXPECT_NE(said.find("distance"), std::string::npos) << said;
    EXPECT_NE(said.find("hinge"), std::string::npos) << said;
    EXPECT_NE(coordinate_refusal([&] { (void)world.speed({0}); }), "");
    EXPECT_NE(coordinate_refusal([&] { (void)world.motor_force({0}); }), "");
    EXPECT_NE(coordinate_refusal([&] { (void)world.coordinate({7}); }), "");
    const JointPair hinge(InteractionKind::Hinge, 0.0, 0.0);
    const std::string motor = coordinate_refusal([&] { (void)hinge.world.motor_force(hinge.id); });
    EXPECT_NE(motor.find("hinge_motor"), std::string::npos) << motor;
}

}  // namespace
}  // namespace hawser::test
