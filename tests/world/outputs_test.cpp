// SPDX-License-Identifier: Apache-2.0
/// Outputs: values for poses made by hand, and compared with other functions of the world; equal
/// bits after a restore and on two threads; rejected definitions.
#include <hawser/hawser.h>

#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace hawser::test {
namespace {

constexpr double kHullYaw = 0.7, kHullPitch = -0.2, kHullRoll = 0.4;

/// A rotating hull, a boom on a motor, a drum with a line to a load, a wire of three elements.
struct OutputCrane {
    World world;
    BodyId ground, hull, boom, drum, load, node[2];
    InteractionId hinge, motor, winch, drive;
    std::vector<InteractionId> wire;

    explicit OutputCrane(int threads = 1)
        : world(WorldDef{.step = 1.0 / 60.0, .threads = threads}) {
        const Quat q = Quat(Eigen::AngleAxisd(kHullYaw, Vec3::UnitZ()) *
                            Eigen::AngleAxisd(kHullPitch, Vec3::UnitY()) *
                            Eigen::AngleAxisd(kHullRoll, Vec3::UnitX()));
        ground = world.add_body({.name = "ground", .kind = BodyKind::fixed});
        hull = world.add_body({.name = "hull",
                               .position = {1, 2, 3},
                               .orientation = q,
                               .velocity = {0.5, -0.25, 0.125},
                               .angular_velocity = {0.1, 0.2, 0.3},
                               .mass = 1000,
                               .inertia = Vec3(500, 600, 700).asDiagonal(),
                               .gravity = false});
        boom = world.add_body({.name = "boom",
                               .position = {1, 2, 5},
                               .orientation = q,
                               .velocity = {0.5, -0.25, 0.125},
                               .angular_velocity = {0.1, 0.2, 0.3},
                               .mass = 100,
                               .inertia = Vec3(10, 60, 60).asDiagonal(),
                               .gravity = false});
        drum = world.add_body({.kind = BodyKind::scalar, .position = {0.5, 0, 0}, .mass = 10});
        load = world.add_body({.kind = BodyKind::lump, .position = {20, 0, -10}, .mass = 50});
        for (int i = 0; i < 2; ++i)
            node[i] = world.add_body(
                {.kind = BodyKind::lump, .position = {20.0, 1.0 + i, -0.1}, .mass = 5});
        const JointIds ids = world.add(HingeDef{.a = hull,
                                                .b = boom,
                                                .point = {1, 2, 4},
                                                .axis = {0, 1, 0},
                                                .motor = AxisMotor{.speed = 0.05}});
        hinge = ids.joint;
        motor = ids.motor;
        winch = world.add(WinchStretchDef{.a = ground,
                                          .b = load,
                                          .point_a = {20, 0, 0},
                                          .drum = drum,
                                          .radius = 0.4,
                                          .length = 9.8,
                                          .EA = 1e5});
        drive = world.add(DrumDef{.drum = drum, .motor = AxisMotor{.speed = 0.2}}).motor;
        wire.push_back(
            world.add(StretchDef{.a = ground, .b = node[0], .point_a = {20, 0, 0}, .EA = 1e6}));
        wire.push_back(world.add(StretchDef{.a = node[0], .b = node[1], .EA = 1e6}));
        wire.push_back(
            world.add(StretchDef{.a = node[1], .b = ground, .point_b = {20, 3, 0}, .EA = 1e6}));
    }
    OutputId add(OutputDef def) {
        def.name = "output " + std::to_string(world.output_count());
        return world.add_output(def);
    }
    double value(OutputDef def) { return world.output(add(std::move(def))); }
    /// Add at least one of every kind, without clock times.
    void add_all() {
        for (const OutputComponent& c : output_kind_info(OutputKind::pose).components)
            add({.kind = OutputKind::pose, .body = hull, .point = {1, 2, 3}, .component = c.name});
        for (const OutputComponent& c : output_kind_info(OutputKind::velocity).components)
            for (const bool local : {false, true})
                add({.kind = OutputKind::velocity,
                     .body = boom,
                     .point = {1, 0, 0},
                     .component = c.name,
                     .local = local});
        for (const InteractionId id : {hinge, motor, drive}) {
            add({.kind = OutputKind::coordinate, .interaction = id});
            add({.kind = OutputKind::speed, .interaction = id});
        }
        for (const InteractionId id : {motor, drive})
            add({.kind = OutputKind::motor_force, .interaction = id});
        for (int r = 0; r < 5; ++r)
            add({.kind = OutputKind::force,
                 .interaction = hinge,
                 .component = "row_" + std::to_string(r)});
        for (const char* c : {"first", "last", "largest"})
            add({.kind = OutputKind::tension, .line = wire, .component = c});
        for (const char* c : {"paid_out", "length"})
            add({.kind = OutputKind::drum, .interaction = winch, .component = c});
        add({.kind = OutputKind::distance, .body = hull, .body_b = load});
        for (const OutputComponent& c : output_kind_info(OutputKind::statistic).components)
            if (!c.measured) add({.kind = OutputKind::statistic, .component = c.name});
    }
};

TEST(Outputs, PosesAreThoseOfTheDefinition) {
    OutputCrane c;
    const auto pose = [&](const char* component) {
        return c.value({.kind = OutputKind::pose, .body = c.hull, .component = component});
    };
    EXPECT_EQ(pose("x"), 1.0);
    EXPECT_EQ(pose("z"), 3.0);
    // Rounding of a quaternion made of three.
    EXPECT_NEAR(pose("roll"), kHullRoll, 1e-15);
    EXPECT_NEAR(pose("pitch"), kHullPitch, 1e-15);
    EXPECT_NEAR(pose("yaw"), kHullYaw, 1e-15);
    const Quat q = c.world.pose(c.hull).orientation;
    EXPECT_EQ(pose("qw"), q.w());
    EXPECT_EQ(pose("qz"), q.z());
    const Vec3 there = Vec3(1, 2, 3) + q * Vec3(0, -2, 1);
    EXPECT_NEAR(
        c.value({.kind = OutputKind::pose, .body = c.hull, .point = {0, -2, 1}, .component = "y"}),
        there.y(), 1e-14);
    EXPECT_EQ(c.value({.kind = OutputKind::pose, .body = c.drum, .component = "x"}), 0.5);
}

TEST(Outputs, VelocitiesAreOfThePointAndTheAxesAskedFor) {
    OutputCrane c;
    const Quat q = c.world.pose(c.hull).orientation;
    const Vec3 arm(2, -1, 0.5), w(0.1, 0.2, 0.3);
    const Vec3 there = Vec3(0.5, -0.25, 0.125) + w.cross(q * arm);
    const char* names[] = {"x", "y", "z", "turn_x", "turn_y", "turn_z"};
    for (int k = 0; k < 6; ++k)
        for (const bool local : {false, true}) {
            const Vec3 v = k < 3 ? there : w;
            const Vec3 wanted = local ? Vec3(q.conjugate() * v) : v;
            EXPECT_NEAR(c.value({.kind = OutputKind::velocity,
                                 .body = c.hull,
                                 .point = arm,
                                 .component = names[k],
                                 .local = local}),
                        wanted[k % 3], 1e-14)
                << names[k] << local;
        }
}

/// After steps, against functions of World for the same quantities.
TEST(Outputs, FollowTheSteps) {
    OutputCrane c;
    const OutputId yaw = c.add({.kind = OutputKind::pose, .body = c.hull, .component = "yaw"});
    const OutputId angle = c.add({.kind = OutputKind::coordinate, .interaction = c.hinge});
    const OutputId speed = c.add({.kind = OutputKind::speed, .interaction = c.hinge});
    const OutputId push = c.add({.kind = OutputKind::motor_force, .interaction = c.motor});
    const OutputId row =
        c.add({.kind = OutputKind::force, .interaction = c.hinge, .component = "row_2"});
    const OutputId paid =
        c.add({.kind = OutputKind::drum, .interaction = c.winch, .component = "paid_out"});
    const OutputId length =
        c.add({.kind = OutputKind::drum, .interaction = c.winch, .component = "length"});
    const OutputId separation =
        c.add({.kind = OutputKind::distance, .body = c.hull, .body_b = c.load});
    const OutputId first =
        c.add({.kind = OutputKind::tension, .line = c.wire, .component = "first"});
    const OutputId last = c.add({.kind = OutputKind::tension, .line = c.wire, .component = "last"});
    const OutputId most =
        c.add({.kind = OutputKind::tension, .line = c.wire, .component = "largest"});
    const OutputId kinetic = c.add({.kind = OutputKind::statistic, .component = "kinetic"});
    const OutputId whole = c.add({.kind = OutputKind::statistic, .component = "mechanical"});
    const OutputId residual = c.add({.kind = OutputKind::statistic, .component = "residual"});
    double highest = 0.0;
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(c.world.step(), Status::ok);
        const std::span<const double> all = c.world.outputs();
        ASSERT_EQ(all.size(), 14U);
        const Vec3 ahead = c.world.pose(c.hull).orientation * Vec3::UnitX();
        EXPECT_NEAR(all[0], std::atan2(ahead.y(), ahead.x()), 1e-14);
        EXPECT_EQ(c.world.output(yaw), all[0]);
        EXPECT_EQ(c.world.output(angle), c.world.coordinate(c.hinge));
        EXPECT_EQ(c.world.output(speed), c.world.speed(c.hinge));
        EXPECT_EQ(c.world.output(push), c.world.motor_force(c.motor));
        EXPECT_EQ(c.world.output(row), c.world.force(c.hinge)[2]);
        const double turned = c.world.pose(c.drum).position.x();
        EXPECT_NEAR(c.world.output(paid), 0.4 * turned, 1e-15);
        EXPECT_NEAR(c.world.output(length), 9.8 + 0.4 * turned, 1e-14);
        EXPECT_NEAR(c.world.output(separation),
                    (c.world.pose(c.hull).position - c.world.pose(c.load).position).norm(), 1e-13);
        EXPECT_EQ(c.world.output(first), -c.world.force(c.wire[0])[0]);
        EXPECT_EQ(c.world.output(last), -c.world.force(c.wire[2])[0]);
        double largest = -1e300;
        for (const InteractionId id : c.wire) largest = std::max(largest, -c.world.force(id)[0]);
        EXPECT_EQ(c.world.output(most), largest);
        EXPECT_EQ(c.world.output(residual), c.world.stats().momentum_residual);
        const Energy e = c.world.energy();
        EXPECT_EQ(c.world.output(kinetic), e.kinetic);
        EXPECT_EQ(c.world.output(whole), e.mechanical());
        highest = std::max(highest, largest);
    }
    EXPECT_GT(highest, 10.0);  // the wire carried a load
}

TEST(Outputs, FollowWhatIsSetBetweenSteps) {
    OutputCrane c;
    const OutputId x = c.add({.kind = OutputKind::pose, .body = c.load, .component = "x"});
    EXPECT_EQ(c.world.outputs()[0], 20.0);
    c.world.set_pose(c.load, {{7, 8, 9}, Quat::Identity()});
    EXPECT_EQ(c.world.outputs()[0], 7.0);
    EXPECT_EQ(c.world.output(x), 7.0);
}

TEST(Outputs, AreTheSameBitsOnTwoThreadsAndAfterARestore) {
    OutputCrane one(1), two(2);
    one.add_all();
    two.add_all();
    std::vector<std::byte> saved;
    std::vector<std::vector<double>> after;
    const auto bits = [](const World& w) {
        return std::vector<double>(w.outputs().begin(), w.outputs().end());
    };
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(one.world.step(), Status::ok);
        ASSERT_EQ(two.world.step(), Status::ok);
        const auto a = bits(one.world), b = bits(two.world);
        ASSERT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0) << i;
        if (i == 29) one.world.state().save(saved);
        if (i > 29) after.push_back(a);
    }
    one.world.state().restore(saved);
    for (const std::vector<double>& wanted : after) {
        ASSERT_EQ(one.world.step(), Status::ok);
        EXPECT_EQ(
            std::memcmp(bits(one.world).data(), wanted.data(), wanted.size() * sizeof(double)), 0);
    }
    // The same as in a world without steps.
    one.world.state().restore(saved);
    OutputCrane fresh;
    fresh.add_all();
    fresh.world.state().restore(saved);
    EXPECT_EQ(bits(one.world), bits(fresh.world));
    EXPECT_EQ(bits(one.world), bits(one.world.twin()));
}

TEST(Outputs, AFailedStepLeavesThemAsTheyWere) {
    OutputCrane c;
    c.add_all();
    ASSERT_EQ(c.world.step(), Status::ok);
    const std::vector<double> before(c.world.outputs().begin(), c.world.outputs().end());
    c.world.cancel();
    ASSERT_EQ(c.world.step(), Status::cancelled);
    EXPECT_EQ(std::vector<double>(c.world.outputs().begin(), c.world.outputs().end()), before);
}

TEST(Outputs, OfWhatHasBeenRemovedAreNoNumbers) {
    OutputCrane c;
    const OutputId x = c.add({.kind = OutputKind::pose, .body = c.load, .component = "x"});
    const OutputId line =
        c.add({.kind = OutputKind::tension, .line = c.wire, .component = "largest"});
    const OutputId hull = c.add({.kind = OutputKind::pose, .body = c.hull, .component = "x"});
    (void)c.world.remove_body(c.load);
    (void)c.world.remove_interaction(c.wire[1]);
    // Another object in its slot is not the requested one.
    (void)c.world.add_body({.kind = BodyKind::lump, .position = {5, 0, 0}, .mass = 1});
    ASSERT_EQ(c.world.step(), Status::ok);
    EXPECT_TRUE(std::isnan(c.world.output(x)));
    EXPECT_TRUE(std::isnan(c.world.output(line)));
    EXPECT_FALSE(std::isnan(c.world.output(hull)));
    EXPECT_THROW(c.add({.kind = OutputKind::pose, .body = c.load, .component = "y"}), DefError);
}

std::string output_refusal(World& world, OutputDef def) {
    if (def.name.empty()) def.name = "x";
    const int count = world.output_count();
    try {
        world.add_output(def);
    } catch (const DefError& error) {
        EXPECT_EQ(world.output_count(), count);
        EXPECT_FALSE(world.find_output("x").valid());
        return error.what();
    }
    return "";
}

TEST(Outputs, WhatIsNotThereIsRefusedWithTheNearestName) {
    OutputCrane c;
    using enum OutputKind;
    const auto says = [&](const OutputDef& def, const char* part) {
        const std::string what = output_refusal(c.world, def);
        EXPECT_NE(what.find(part), std::string::npos) << what << "\nlacks " << part;
    };
    says({.kind = pose, .body = c.hull, .component = "rol"}, "did you mean 'roll'?");
    says({.kind = pose, .body = c.hull}, "give one of x, y, z");
    says({.kind = pose, .body = {99}, .component = "x"}, "body does not exist");
    says({.kind = pose, .body = c.load, .component = "roll"}, "does not rotate");
    says({.kind = pose, .body = c.drum, .component = "y"}, "component x");
    says({.kind = pose, .body = c.load, .point = {1, 0, 0}, .component = "x"}, "at 0");
    says({.kind = distance, .body = c.hull, .body_b = c.drum},
         "body_b is a scalar body, which has a coordinate but no position");
    says({.kind = distance, .body = c.hull}, "body_b");
    says({.kind = coordinate, .interaction = c.wire[0]}, "a stretch has no coordinate");
    says({.kind = motor_force, .interaction = c.hinge}, "hinge_motor");
    says({.kind = force, .interaction = c.motor, .component = "row_1"}, "1 rows");
    says({.kind = drum, .interaction = c.wire[0], .component = "length"}, "wound on no drum");
    says({.kind = tension, .component = "first"}, "elements");
    says({.kind = tension, .line = {c.motor}, .component = "first"}, "carries no tension");
    says({.kind = statistic, .component = "residuum"}, "did you mean 'residual'?");
    says({.kind = pose, .body = c.hull, .component = "x", .nominal = -1.0}, "nominal");
    says({.kind = pose, .body = c.hull, .component = "x", .local = true}, "velocity");
    c.world.add_output({.name = "x", .kind = pose, .body = c.hull, .component = "x"});
    EXPECT_THROW(c.world.add_output({.name = "x", .kind = pose, .body = c.hull, .component = "y"}),
                 DefError);
    EXPECT_THROW(c.world.add_output({.kind = pose, .body = c.hull, .component = "y"}), DefError);
    EXPECT_EQ(c.world.output_def(c.world.find_output("x")).unit, "m");
    EXPECT_THROW((void)c.world.output({5}), DefError);
    EXPECT_FALSE(c.world.find_output("y").valid());
}
}  // namespace
}  // namespace hawser::test
