// SPDX-License-Identifier: Apache-2.0
/// Typed definitions: joints start closed for any poses of their bodies, at the requested
/// coordinate, with the requested parts and defaults of the table; all or nothing.
#include <hawser/hawser.h>

#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

namespace hawser::test {
namespace {

Quat leaning_turn(double x, double y, double z) {
    return Quat(Eigen::AngleAxisd(Vec3(x, y, z).norm(), Vec3(x, y, z).normalized()));
}

/// Two bodies that are tilted in the world, a point mass, a drum and the ground.
struct JointYard {
    World world{WorldDef{.gravity = {0, 0, 0}}};
    BodyId a, b, lump, drum, ground;
    JointYard() {
        const Mat3 inertia = Vec3(1, 2, 2.5).asDiagonal();
        a = world.add_body({.name = "a",
                            .position = {1, 2, 3},
                            .orientation = leaning_turn(0.3, -0.8, 0.2),
                            .mass = 2,
                            .inertia = inertia});
        b = world.add_body({.name = "b",
                            .position = {1.5, 2.5, 2},
                            .orientation = leaning_turn(-1.0, 0.4, 0.9),
                            .mass = 3,
                            .inertia = inertia});
        lump = world.add_body({.kind = BodyKind::lump, .position = {0, 0, 5}, .mass = 1});
        drum = world.add_body({.kind = BodyKind::scalar, .mass = 1});
        ground = world.add_body({.kind = BodyKind::fixed, .position = {0, 0, 1}});
    }
    [[nodiscard]] double open(InteractionId id) const {
        double most = 0.0;
        for (const double g : world.violation(id)) most = std::max(most, std::abs(g));
        return most;
    }
    /// Return a direction fixed in a body, in the world frame.
    [[nodiscard]] Vec3 axis_of(InteractionId id, std::size_t slot) const {
        const InteractionDef& d = world.interaction_def(id);
        return world.pose(d.body[slot]).orientation * (d.frame[slot] * Vec3::UnitZ());
    }
};

// Rounding of poses some metres away.
constexpr double kPoseRounding = 1e-14;
const Vec3 kJointPoint(0.7, -0.3, 2.2), kJointAxis(1, 2, -2);

TEST(Define, JointsBeginClosedAtTheCoordinateAskedFor) {
    JointYard y;
    const JointIds hinge = y.world.add(
        HingeDef{.a = y.a, .b = y.b, .point = kJointPoint, .axis = kJointAxis, .coordinate = 0.6});
    EXPECT_LT(y.open(hinge.joint), kPoseRounding);
    EXPECT_NEAR(y.world.coordinate(hinge.joint), 0.6, kPoseRounding);
    EXPECT_LT((y.axis_of(hinge.joint, 0) - kJointAxis / 3.0).norm(), kPoseRounding);
    EXPECT_LT((y.axis_of(hinge.joint, 1) - kJointAxis / 3.0).norm(), kPoseRounding);
    const Vec3 where = y.world.world_point(y.b, y.world.interaction_def(hinge.joint).point[1]);
    EXPECT_LT((where - kJointPoint).norm(), kPoseRounding);
    EXPECT_FALSE(hinge.limit.valid() || hinge.motor.valid() || hinge.friction.valid());

    const JointIds slide = y.world.add(PrismaticDef{
        .a = y.a, .b = y.b, .point = kJointPoint, .axis = kJointAxis, .coordinate = -1.5});
    EXPECT_LT(y.open(slide.joint), kPoseRounding);
    EXPECT_NEAR(y.world.coordinate(slide.joint), -1.5, kPoseRounding);
    const CylindricalIds both =
        y.world.add(CylindricalDef{.a = y.a,
                                   .b = y.b,
                                   .point = kJointPoint,
                                   .axis = kJointAxis,
                                   .along = {.coordinate = 2.0, .motor = AxisMotor{}},
                                   .about = {.coordinate = -0.25, .motor = AxisMotor{}}});
    EXPECT_LT(y.open(both.joint), kPoseRounding);
    EXPECT_NEAR(y.world.coordinate(both.joint), 2.0, kPoseRounding);
    EXPECT_NEAR(y.world.coordinate(both.along.motor), 2.0, kPoseRounding);
    EXPECT_NEAR(y.world.coordinate(both.about.motor), -0.25, kPoseRounding);
    EXPECT_LT(y.open(y.world.add(BallDef{.a = y.a, .b = y.b, .point = kJointPoint})),
              kPoseRounding);
    EXPECT_LT(y.open(y.world.add(BallDef{.a = y.a, .b = y.lump, .point = {0, 0, 5}})),
              kPoseRounding);
    EXPECT_LT(y.open(y.world.add(LockDef{.a = y.a, .b = y.b, .point = kJointPoint})),
              kPoseRounding);
    const InteractionId cardan = y.world.add(UniversalDef{
        .a = y.a, .b = y.b, .point = kJointPoint, .axis_a = kJointAxis, .axis_b = {2, 1, 2}});
    EXPECT_LT(y.open(cardan), kPoseRounding);
    EXPECT_LT((y.axis_of(cardan, 1) - Vec3(2, 1, 2) / 3.0).norm(), kPoseRounding);
}

TEST(Define, PlacesInTheFrameOfTheFirstBodyAreThoseOfTheWorld) {
    JointYard in_world, in_a;
    const Pose pose = in_a.world.pose(in_a.a);
    const JointIds one = in_world.world.add(
        HingeDef{.a = in_world.a, .b = in_world.b, .point = kJointPoint, .axis = kJointAxis});
    const JointIds two = in_a.world.add(
        HingeDef{.a = in_a.a,
                 .b = in_a.b,
                 .point = pose.orientation.conjugate() * (kJointPoint - pose.position),
                 .axis = pose.orientation.conjugate() * kJointAxis,
                 .frame = JointFrame::body_a});
    const InteractionDef &d = in_world.world.interaction_def(one.joint),
                         &e = in_a.world.interaction_def(two.joint);
    for (std::size_t slot = 0; slot < 2; ++slot)
        EXPECT_LT((d.point[slot] - e.point[slot]).norm(), kPoseRounding);
    EXPECT_LT((in_world.axis_of(one.joint, 1) - in_a.axis_of(two.joint, 1)).norm(), kPoseRounding);
}

/// b rotates about the axis by the right-hand rule if the coordinate increases.
TEST(Define, TheCoordinateGrowsByTheRightHand) {
    JointYard y;
    const JointIds hinge =
        y.world.add(HingeDef{.a = y.ground, .b = y.b, .point = {1.5, 2.5, 2}, .axis = kJointAxis});
    const Pose p = y.world.pose(y.b);
    const Quat turn(Eigen::AngleAxisd(0.1, kJointAxis.normalized()));
    y.world.set_pose(y.b, {p.position, turn * p.orientation});
    EXPECT_NEAR(y.world.coordinate(hinge.joint), 0.1, kPoseRounding);
    y.world.set_velocity(y.b, {{0, 0, 0}, 2.0 * kJointAxis.normalized()});
    EXPECT_NEAR(y.world.speed(hinge.joint), 2.0, kPoseRounding);
}

TEST(Define, PartsHaveNamesParametersAndDefaultsOfTheTable) {
    JointYard y;
    const JointIds ids =
        y.world.add(HingeDef{.name = "boom",
                             .a = y.a,
                             .b = y.b,
                             .point = kJointPoint,
                             .axis = kJointAxis,
                             .limit = AxisLimit{.max = 1.25},
                             .motor = AxisMotor{.speed = 0.1, .force_max = 7e5},
                             .friction = AxisFriction{.bound = 30.0, .own_load = 0.02}});
    EXPECT_EQ(y.world.find_interaction("boom"), ids.joint);
    EXPECT_EQ(y.world.find_interaction("boom/limit"), ids.limit);
    EXPECT_EQ(y.world.find_interaction("boom/motor"), ids.motor);
    EXPECT_EQ(y.world.find_interaction("boom/friction"), ids.friction);
    const InteractionDef& limit = y.world.interaction_def(ids.limit);
    EXPECT_EQ(limit.kind, InteractionKind::HingeRange);
    EXPECT_EQ(limit.get("max"), 1.25);
    EXPECT_EQ(limit.get("min"), kind_info(limit.kind).params[0].min);
    const InteractionDef& friction = y.world.interaction_def(ids.friction);
    EXPECT_EQ(friction.get("torque"), 30.0);
    EXPECT_EQ(friction.load[0].interaction, ids.joint);
    EXPECT_EQ(friction.load[0].factor, 0.02);
    EXPECT_FALSE(friction.load[1].interaction.valid());
    // The same joint by hand without options: compliances, damping and the other parameters agree.
    const InteractionDef motor = y.world.interaction_def(ids.motor);
    InteractionDef plain = between(InteractionKind::HingeMotor, {y.a, y.b});
    plain.point = motor.point;
    plain.frame = motor.frame;
    plain.set("speed", 0.1).set("force_max", 7e5);
    const InteractionDef& by_hand = y.world.interaction_def(y.world.add_interaction(plain));
    EXPECT_EQ(std::memcmp(&by_hand.params, &motor.params, sizeof motor.params), 0);
    EXPECT_EQ(std::memcmp(&by_hand.compliance, &motor.compliance, sizeof motor.compliance), 0);
    // Without a name, no part has one.
    const JointIds nameless = y.world.add(HingeDef{
        .a = y.a, .b = y.b, .point = kJointPoint, .axis = kJointAxis, .motor = AxisMotor{}});
    EXPECT_EQ(y.world.interaction_def(nameless.motor).name, "");
}

std::string define_refusal(World& world, const auto& def) {
    const int count = world.interaction_count();
    try {
        world.add(def);
    } catch (const DefError& error) {
        EXPECT_EQ(world.interaction_count(), count);
        return error.what();
    }
    return "";
}

TEST(Define, AllPartsOrNone) {
    JointYard y;
    ASSERT_EQ(y.world.step(), Status::ok);
    const std::vector<std::byte> before = y.world.state().save();
    HingeDef def{.name = "boom",
                 .a = y.a,
                 .b = y.b,
                 .point = kJointPoint,
                 .axis = kJointAxis,
                 .limit = AxisLimit{.min = -1, .max = 1},
                 .motor = AxisMotor{.force_min = 5, .force_max = -5}};
    EXPECT_NE(define_refusal(y.world, def).find("boom/motor"), std::string::npos);
    for (const char* name : {"boom", "boom/limit", "boom/motor"})
        EXPECT_FALSE(y.world.find_interaction(name).valid()) << name;
    def.motor = AxisMotor{};
    def.friction = AxisFriction{.bound = -1.0};
    EXPECT_NE(define_refusal(y.world, def), "");
    def.friction = AxisFriction{.bound = 1.0, .own_load = 1e9};
    EXPECT_NE(define_refusal(y.world, def).find("factor"), std::string::npos);
    def.friction = AxisFriction{.bound = 1.0, .load = {.factor = 0.1}};
    EXPECT_NE(define_refusal(y.world, def).find("own_load"), std::string::npos);
    // One of its parts' names is used already.
    InteractionDef other = between(InteractionKind::Hold, {y.drum});
    other.name = "boom/motor";
    JointYard taken;
    taken.world.add_interaction(other);
    def.friction.reset();
    EXPECT_NE(define_refusal(taken.world, def).find("name is in use"), std::string::npos);
    EXPECT_FALSE(taken.world.find_interaction("boom").valid());
    EXPECT_FALSE(taken.world.find_interaction("boom/limit").valid());
    // Nothing has changed: the state is restored, and the joint can be added.
    y.world.state().restore(before);
    EXPECT_TRUE(y.world.add(def).motor.valid());
}

TEST(Define, WhatMakesNoSenseIsRefused) {
    JointYard y;
    EXPECT_NE(define_refusal(y.world, HingeDef{.a = y.a, .b = y.b, .axis = {0, 0, 0}}).find("axis"),
              std::string::npos);
    EXPECT_NE(define_refusal(y.world, HingeDef{.a = y.a}), "");
    EXPECT_NE(define_refusal(y.world, HingeDef{.a = y.a, .b = y.a}), "");
    EXPECT_NE(
        define_refusal(y.world, BallDef{.a = y.a, .b = y.lump, .point = {0, 0, 4}}).find("lump"),
        std::string::npos);
    EXPECT_NE(define_refusal(y.world, UniversalDef{.a = y.a, .b = y.b, .axis_b = {1, 0, 0.1}})
                  .find("square"),
              std::string::npos);
    EXPECT_NE(define_refusal(y.world, DrumDef{.drum = y.drum}), "");
    EXPECT_NE(define_refusal(y.world, DrumDef{.drum = y.a, .motor = AxisMotor{}}), "");
    EXPECT_NE(define_refusal(y.world, StretchDef{.a = y.a, .b = y.b}).find("EA"),
              std::string::npos);
    EXPECT_NE(
        define_refusal(y.world, StretchDef{.a = y.a, .b = y.lump, .point_b = {1, 0, 0}, .EA = 1e6})
            .find("point mass has no attachment points"),
        std::string::npos);
}

TEST(Define, LinesTakeTheirLengthFromThePosesAndTheRestFromTheTable) {
    JointYard y;
    const InteractionId rod =
        y.world.add(DistanceDef{.name = "rod", .a = y.ground, .b = y.lump, .compliance = 1e-4});
    EXPECT_EQ(y.world.interaction_def(rod).get("length"), 4.0);
    EXPECT_EQ(y.world.interaction_def(rod).compliance[0], 1e-4);
    const InteractionId line = y.world.add(StretchDef{.a = y.ground,
                                                      .b = y.lump,
                                                      .point_a = {0, 0, 1},
                                                      .EA = 2e6,
                                                      .tension_only = false,
                                                      .breaking_load = 1e5});
    const InteractionDef& d = y.world.interaction_def(line);
    EXPECT_EQ(d.get("length"), 3.0);
    EXPECT_EQ(d.get("tension_only"), 0.0);
    EXPECT_EQ(d.get("breaking_load"), 1e5);
    EXPECT_EQ(d.compliance[0], 3.0 / 2e6);
    const InteractionId winch = y.world.add(
        WinchStretchDef{.a = y.ground, .b = y.lump, .drum = y.drum, .radius = 0.5, .EA = 2e6});
    EXPECT_EQ(y.world.interaction_def(winch).get("radius"), 0.5);
    EXPECT_EQ(y.world.interaction_def(winch).get("tension_only"), 1.0);
    const InteractionId bend = y.world.add(
        BendDef{.first = y.ground, .middle = y.lump, .last = y.b, .EI = 50.0, .length = 2.0});
    EXPECT_EQ(y.world.interaction_def(bend).compliance[1], 2.0 / 50.0);
    const DrumIds drum = y.world.add(DrumDef{.name = "winch",
                                             .drum = y.drum,
                                             .motor = AxisMotor{.force_max = 10.0},
                                             .friction = AxisFriction{.bound = 3.0},
                                             .hold = 0.25});
    EXPECT_EQ(y.world.find_interaction("winch/motor"), drum.motor);
    EXPECT_EQ(y.world.interaction_def(drum.hold).get("target"), 0.25);
    EXPECT_EQ(y.world.interaction_def(drum.friction).get("force"), 3.0);
}

/// A boom is driven against its weight to its limit, where friction holds it.
TEST(Define, ACraneJointDoesWhatItsPartsSay) {
    World world;
    const BodyId ship = world.add_body({.kind = BodyKind::fixed});
    const BodyId boom = world.add_body(
        {.position = {2, 0, 0}, .mass = 100, .inertia = Vec3(1, 140, 140).asDiagonal()});
    const JointIds ids = world.add(HingeDef{.a = ship,
                                            .b = boom,
                                            .axis = {0, -1, 0},  // up is positive
                                            .limit = AxisLimit{.min = -1.5, .max = 0.5},
                                            .motor = AxisMotor{.speed = 0.4, .force_max = 5000},
                                            .friction = AxisFriction{.bound = 3000}});
    for (int i = 0; i < 240; ++i) ASSERT_EQ(world.step(), Status::ok);
    // Driven on against a stop of 1e-12 rad/(N m) with at most 5000 N m.
    EXPECT_NEAR(world.coordinate(ids.joint), 0.5, 1e-8);
    EXPECT_NEAR(world.motor_force(ids.motor), 5000.0, 1e-6);
    const InputId most =
        world.add_input({.name = "most", .interaction = ids.motor, .param = "force_max"});
    const InputId least =
        world.add_input({.name = "least", .interaction = ids.motor, .param = "force_min"});
    world.set_input(least, 0.0);
    world.set_input(most, 0.0);
    for (int i = 0; i < 240; ++i) ASSERT_EQ(world.step(), Status::ok);
    // Its weight, 100 · 9.81 · 2 · cos 0.5 = 1722 N m, is less than the friction of 3000 N m.
    EXPECT_NEAR(world.coordinate(ids.joint), 0.5, 1e-8);
    // Friction and stop keep the force between them; their sum carries the weight.
    EXPECT_NEAR(world.force(ids.friction)[0] + world.force(ids.limit)[0],
                100 * 9.81 * 2 * std::cos(0.5), 0.01);
    EXPECT_GT(world.force(ids.friction)[0], 1700.0);
}

}  // namespace
}  // namespace hawser::test
