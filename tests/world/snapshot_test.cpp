// SPDX-License-Identifier: Apache-2.0
/// Save and restore: later steps are equal bit for bit, and damage is rejected.
#include <hawser/inspect.h>

#include "support/small_recipes.h"
#include "support/tier.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

class EachRecipe : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Recipes, EachRecipe, testing::ValuesIn(kSmallRecipes), name_of);

TEST_P(EachRecipe, ContinuesBitForBitAfterRestore) {
    const Recipe recipe = GetParam().make();
    World a = recipe.make();
    Random random(first_seed(7));
    const int rounds = by_tier(10, 30, 300);
    for (int round = 0; round < rounds; ++round) {
        for (int i = random.integer(0, 6); i > 0; --i) ASSERT_EQ(a.step(), Status::ok);
        const auto bytes = a.state().save();
        World fresh = recipe.make();
        fresh.state().restore(bytes);
        ASSERT_EQ(fresh.state().hash(), a.state().hash()) << "round " << round;
        ASSERT_EQ(fresh.time(), a.time());
        for (int i = 0; i < 5; ++i) {
            ASSERT_EQ(a.step(), Status::ok);
            ASSERT_EQ(fresh.step(), Status::ok);
            ASSERT_EQ(fresh.state().hash(), a.state().hash()) << "round " << round << " step " << i;
        }
        ASSERT_EQ(fresh.state().save(), a.state().save()) << "the state holds more than the hash";
        ASSERT_EQ(fresh.energy().mechanical(), a.energy().mechanical());
        // Back in time, also in the same world.
        a.state().restore(bytes);
        for (int i = 0; i < 5; ++i) ASSERT_EQ(a.step(), Status::ok);
        ASSERT_EQ(fresh.state().hash(), a.state().hash());
    }
}

TEST_P(EachRecipe, ReadingDoesNotChangeTheState) {
    const Recipe recipe = GetParam().make();
    World a = recipe.make(), b = recipe.make();
    for (int i = 0; i < 10; ++i) {
        ASSERT_EQ(a.step(), Status::ok);
        ASSERT_EQ(b.step(), Status::ok);
        (void)a.energy();
        (void)a.solver().matrix();
        (void)a.solver().memory_bytes();
        for (int k = 0; k < a.interaction_count(); ++k) (void)a.violation(InteractionId{k});
        ASSERT_EQ(a.state().hash(), b.state().hash()) << "step " << i;
    }
}

TEST(Snapshot, RefusesDamageAndLeavesTheStateAlone) {
    const Recipe recipe = mixed(5);
    World w = recipe.make();
    for (int i = 0; i < 3; ++i) ASSERT_EQ(w.step(), Status::ok);
    const auto good = w.state().save();
    ASSERT_EQ(w.step(), Status::ok);
    const auto hash = w.state().hash();
    Random random(first_seed(3));
    const int trials = by_tier(200, 1000, 10'000);
    for (int trial = 0; trial < trials; ++trial) {
        auto bytes = good;
        const auto where =
            static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1));
        bytes[where] ^= static_cast<std::byte>(random.integer(1, 255));
        EXPECT_THROW(w.state().restore(bytes), DefError) << "byte " << where;
        ASSERT_EQ(w.state().hash(), hash);
    }
    for (std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{24}, good.size() - 1}) {
        EXPECT_THROW(w.state().restore(std::span(good).first(size)), DefError) << size;
    }
    auto longer = good;
    longer.push_back(std::byte{0});
    EXPECT_THROW(w.state().restore(longer), DefError);
    World other = wire(5).make();
    EXPECT_THROW(other.state().restore(good), DefError) << "another world's bytes";
    w.state().restore(good);
    EXPECT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.state().hash(), hash);
}

/// The acting force is part of the state. The last value of an input that drove it before
/// set_force() replaced it must not return.
TEST(Snapshot, KeepsAForceThatReplacedAnInput) {
    const Recipe recipe = pendulum();
    auto make = [&] {
        World w = recipe.make();
        InputDef push;
        push.name = "push";
        push.body = BodyId{1};
        push.min = -100;
        push.max = 100;
        w.add_input(push);
        return w;
    };
    World a = make();
    a.set_input(a.find_input("push"), 5.0);
    a.set_force(BodyId{1}, {7.0, 0, 0}, {0, 0, 0});
    ASSERT_EQ(a.step(), Status::ok);
    World b = make();
    b.state().restore(a.state().save());
    ASSERT_EQ(a.step(), Status::ok);
    ASSERT_EQ(b.step(), Status::ok);
    EXPECT_EQ(a.state().hash(), b.state().hash());
}

/// Rigid rows get a small compliance from the bodies' mobility at the analysis of the system; a
/// world analysed at another pose must nevertheless continue bit for bit.
TEST(Snapshot, DoesNotDependOnThePoseAtWhichTheSystemWasAnalysed) {
    Recipe recipe;
    const BodyId g = recipe.ground();
    const BodyId b = recipe.rigid({1, 0, 0}, Quat::Identity(), 3.0, {1, 2, 2.5});
    InteractionDef d = recipe.at(InteractionKind::Distance, {g, b}, {0.9, 0.1, 0});
    d.point[0] = {0, 0, 1};
    d.compliance[0] = 0.0;
    recipe.add(d);
    World a = recipe.make();
    // Not yet analysed: the first step does it at this pose.
    a.set_pose(b, {Vec3(0.9, 0.1, 0.2), Quat(0.9, 0.1, 0.3, 0.2).normalized()});
    for (int i = 0; i < 3; ++i) ASSERT_EQ(a.step(), Status::ok);
    World fresh = recipe.make();
    fresh.state().restore(a.state().save());
    ASSERT_EQ(a.step(), Status::ok);
    ASSERT_EQ(fresh.step(), Status::ok);
    EXPECT_EQ(a.state().hash(), fresh.state().hash());
}

TEST(Snapshot, RestoresInputsOfInteractions) {
    auto make = [] {
        Recipe r;
        const BodyId drum = r.scalar(0.0, 2.0);
        r.add(between(InteractionKind::ScalarMotor, {drum}));
        World w = r.make();
        InputDef speed;
        speed.name = "speed";
        speed.interaction = InteractionId{0};
        speed.param = "speed";
        w.add_input(speed);
        return w;
    };
    World a = make();
    a.set_input(a.find_input("speed"), 2.0);
    ASSERT_EQ(a.step(), Status::ok);
    World b = make();
    b.state().restore(a.state().save());
    EXPECT_EQ(b.input(b.find_input("speed")), 2.0);
    ASSERT_EQ(b.step(), Status::ok);
    EXPECT_NEAR(b.velocity(BodyId{0}).linear.x(), 2.0, 1e-6);
    const auto hash = b.state().hash();
    b.set_input(b.find_input("speed"), 3.0);
    EXPECT_NE(b.state().hash(), hash) << "inputs belong to the hash";
}

}  // namespace
}  // namespace hawser::test
