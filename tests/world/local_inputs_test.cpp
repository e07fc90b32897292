// SPDX-License-Identifier: Apache-2.0
/// Inputs whose force rotates with the body, and the declarations of an input for clients.
#include <hawser/hawser.h>

#include "support/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace hawser::test {
namespace {

constexpr double kShipMass = 4.0, kThrust = 6.0, kShipStep = 1.0 / 50.0;

/// Make a free body with rotated axes, spinning about z.
World spinning_ship(double angle, double rate) {
    World world({.step = kShipStep, .gravity = {0, 0, 0}});
    world.add_body({.name = "ship",
                    .orientation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())),
                    .angular_velocity = {0, 0, rate},
                    .mass = kShipMass,
                    .inertia = Vec3(1, 2, 3).asDiagonal()});
    return world;
}

InputDef thrust(int component) {
    return {.name = "thrust " + std::to_string(component),
            .body = {0},
            .component = component,
            .local = true};
}

TEST(LocalInputs, PushWhereTheBodyLooks) {
    World world = spinning_ship(0.5 * std::numbers::pi, 0.0);
    const InputId along = world.add_input(thrust(0)), turn = world.add_input(thrust(5));
    EXPECT_EQ(world.input(along), 0.0);
    world.set_input(along, kThrust);
    world.set_input(turn, 1.5);
    ASSERT_EQ(world.step(), Status::ok);
    // From rest, at −h/2 before the end of the first step: half a step of acceleration, along y.
    const Twist v = world.velocity({0});
    EXPECT_NEAR(v.linear.x(), 0.0, 1e-15);
    EXPECT_NEAR(v.linear.y(), 0.5 * kShipStep * kThrust / kShipMass, 1e-15);
    EXPECT_NEAR(v.angular.z(), 0.5 * kShipStep * 1.5 / 3.0, 1e-15);
}

/// Against a world whose applied force is set before every step from the pose, with a constant
/// force in both.
TEST(LocalInputs, TurnWithTheBodyAndAddToWhatElseActs) {
    World ours = spinning_ship(0.3, 1.7), other = spinning_ship(0.3, 1.7);
    const InputId along = ours.add_input(thrust(0)), side = ours.add_input(thrust(1));
    const InputId spin = ours.add_input(thrust(3));
    ours.set_input(along, kThrust);
    ours.set_input(side, -2.0);
    ours.set_input(spin, 0.1);
    ours.set_force({0}, {0.5, 0.25, -1.0}, {0, 0.125, 0});
    for (int i = 0; i < 300; ++i) {
        const Quat q = other.pose({0}).orientation;
        other.set_force({0}, Vec3(0.5, 0.25, -1.0) + q * Vec3(kThrust, -2.0, 0.0),
                        Vec3(0, 0.125, 0) + q * Vec3(0.1, 0, 0));
        ASSERT_EQ(other.step(), Status::ok);
        ASSERT_EQ(ours.step(), Status::ok);
    }
    const Pose a = ours.pose({0}), b = other.pose({0});
    // Rotations are rounded differently, 1e-16 per step, over 300 steps of a body about 10 m away.
    EXPECT_LT((a.position - b.position).norm(), 1e-11);
    EXPECT_LT(a.orientation.angularDistance(b.orientation), 1e-11);
    EXPECT_GT(a.position.norm(), 1.0);
}

TEST(LocalInputs, GoOnTheSameAfterARestore) {
    World world = spinning_ship(0.3, 1.7);
    const InputId along = world.add_input(thrust(0));
    (void)world.add_input({.name = "up", .body = {0}, .component = 2});
    world.set_input(along, kThrust);
    world.set_input({1}, 3.0);
    for (int i = 0; i < 40; ++i) ASSERT_EQ(world.step(), Status::ok);
    const std::vector<std::byte> saved = world.state().save();
    for (int i = 0; i < 40; ++i) ASSERT_EQ(world.step(), Status::ok);
    const std::uint64_t hash = world.state().hash();
    world.set_input(along, -1.0);
    world.state().restore(saved);
    EXPECT_EQ(world.input(along), kThrust);
    for (int i = 0; i < 40; ++i) ASSERT_EQ(world.step(), Status::ok);
    EXPECT_EQ(world.state().hash(), hash);
}

TEST(LocalInputs, ACancelledStepLeavesNoForceBehind) {
    World world = spinning_ship(0.3, 1.7), other = spinning_ship(0.3, 1.7);
    for (World* w : {&world, &other}) {
        w->add_input(thrust(0));
        w->set_input({0}, kThrust);
        ASSERT_EQ(w->step(), Status::ok);
    }
    world.cancel();
    ASSERT_EQ(world.step(), Status::cancelled);
    for (World* w : {&world, &other}) ASSERT_EQ(w->step(), Status::ok);
    EXPECT_EQ(world.state().hash(), other.state().hash());
}

TEST(LocalInputs, PushNoMoreWhenTheyAreRemoved) {
    World world = spinning_ship(0.0, 0.0);
    const InputId along = world.add_input(thrust(0)), side = world.add_input(thrust(1));
    world.set_input(along, kThrust);
    world.set_input(side, 2.0);
    (void)world.remove_input(along);
    ASSERT_EQ(world.step(), Status::ok);
    EXPECT_EQ(world.velocity({0}).linear.x(), 0.0);
    EXPECT_NEAR(world.velocity({0}).linear.y(), 0.5 * kShipStep * 2.0 / kShipMass, 1e-15);
}

std::string input_refusal(World& world, const InputDef& def) {
    try {
        world.add_input(def);
    } catch (const DefError& error) {
        EXPECT_EQ(world.input_count(), 0);
        return error.what();
    }
    return "";
}

TEST(LocalInputs, WhatMakesNoSenseIsRefused) {
    World world;
    const BodyId g = world.add_body({.kind = BodyKind::fixed});
    const BodyId lump = world.add_body({.kind = BodyKind::lump, .position = {1, 0, 0}, .mass = 1});
    const InteractionId rod = world.add(DistanceDef{.a = g, .b = lump});
    EXPECT_NE(
        input_refusal(world, {.name = "a", .body = lump, .local = true}).find("does not rotate"),
        std::string::npos);
    EXPECT_NE(
        input_refusal(world, {.name = "a", .interaction = rod, .param = "length", .local = true}),
        "");
    const InputDef spring{.name = "a", .body = lump, .min = -1, .max = 1, .spring = 2.0};
    EXPECT_NE(input_refusal(world, spring).find("spring"), std::string::npos);
    EXPECT_NE(input_refusal(world, {.name = "a", .body = lump, .nominal = -1.0}).find("nominal"),
              std::string::npos);
    const InputDef good{.name = "a",
                        .body = lump,
                        .min = -1,
                        .max = 1,
                        .unit = "N",
                        .group = "thrusters",
                        .nominal = 1.0,
                        .spring = 0.0};
    const InputDef kept = world.input_def(world.add_input(good));
    EXPECT_EQ(kept.unit, "N");
    EXPECT_EQ(kept.group, "thrusters");
    EXPECT_EQ(kept.nominal, 1.0);
    EXPECT_EQ(kept.spring, 0.0);
}

}  // namespace
}  // namespace hawser::test
