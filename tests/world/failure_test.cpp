// SPDX-License-Identifier: Apache-2.0
/// A failed step returns a status and keeps the state of the last successful step.
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

/// Largest double: the impulse h f is finite, its square is not.
constexpr double kHuge = 1e300;

TEST(FailedStep, LeavesTheStateAlone) {
    for (const std::uint32_t seed : seeds(1, 4, 20, 200)) {
        SCOPED_TRACE(seed);
        const Recipe recipe = mixed(seed);
        World w = recipe.make(), twin = recipe.make();
        const BodyId last{w.body_count() - 2};
        for (int i = 0; i < 5; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_EQ(twin.step(), Status::ok);
        }
        const BodyId moved{1};
        const Vec3 force = recipe.bodies[1].force, torque = recipe.bodies[1].torque;
        const auto before = w.state().save();
        w.set_force(moved, {kHuge, kHuge, kHuge}, torque);
        EXPECT_EQ(w.step(), Status::not_finite) << "body " << last.index;
        EXPECT_EQ(w.stats().status, Status::not_finite);
        EXPECT_EQ(w.step_count(), 5);
        w.set_force(moved, force, torque);
        EXPECT_EQ(w.state().hash(), twin.state().hash());
        EXPECT_EQ(w.state().save(), before);
        for (int i = 0; i < 3; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_EQ(twin.step(), Status::ok);
        }
        EXPECT_EQ(w.state().hash(), twin.state().hash()) << "seed " << seed;
    }
}

TEST(FailedStep, LeavesTheStateAloneWhenItIsTheFirst) {
    for (const std::uint32_t seed : seeds(1, 4, 20, 200)) {
        SCOPED_TRACE(seed);
        const Recipe recipe = mixed(seed);
        World w = recipe.make(), twin = recipe.make();
        w.prepare();
        twin.prepare();
        const Vec3 force = recipe.bodies[1].force, torque = recipe.bodies[1].torque;
        w.set_force(BodyId{1}, {kHuge, 0, 0}, torque);
        EXPECT_EQ(w.step(), Status::not_finite);
        EXPECT_EQ(w.step_count(), 0);
        w.set_force(BodyId{1}, force, torque);
        EXPECT_EQ(w.state().hash(), twin.state().hash()) << "seed " << seed;
        for (int i = 0; i < 3; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_EQ(twin.step(), Status::ok);
        }
        EXPECT_EQ(w.state().hash(), twin.state().hash())
            << "seed " << seed << ": the first good step must still start staggered";
    }
}

/// Condensing adds a stiffness of 1e24 times the mass, which is lost in rounding.
TEST(FailedStep, ReportsASingularModel) {
    Recipe r;
    const BodyId a = r.lump({0, 0, 0}, 1e-9), b = r.lump({1, 0, 0}, 1e-9);
    InteractionDef d = between(InteractionKind::Stretch, {a, b});
    r.add(d.set("EA", 1e15).set("length", 1.0));
    r.world.form = Form::condensed;
    r.world.step = 1.0 / 60.0;
    World w = r.make();
    const auto hash = w.state().hash();
    w.prepare();
    const Status status = w.step();
    EXPECT_TRUE(status == Status::wrong_pivot || status == Status::not_finite) << to_string(status);
    EXPECT_EQ(w.state().hash(), hash);
    EXPECT_EQ(w.step(), status) << "and goes on saying so";
    EXPECT_TRUE(w.pose(a).position.allFinite());
}

/// Such a bend has no direction. A fault let its Jacobian overflow, and steps ended as wrong_pivot.
/// Twelve of them are evaluated in a batch of eight and the last ones one by one.
TEST(FailedStep, NodesOfAWireMayCoincide) {
    const double EI = 1e3, length = 1.0;
    for (const int wires : {1, 12}) {
        Recipe r;
        std::vector<BodyId> nodes;
        std::vector<InteractionId> bends;
        for (int i = 0; i < wires; ++i) {
            const double y = 10.0 * i;
            const BodyId a = r.lump({0, y, 0}, 1.0), b = r.lump({0, y, 0}, 1.0),
                         c = r.lump({1, y, 0}, 1.0);
            r.bodies[static_cast<std::size_t>(b.index)].velocity = {0, 1e-3, 0};
            InteractionDef d = between(InteractionKind::Bend, {a, b, c});
            bends.push_back(r.add(d.set("EI", EI).set("length", length)));
            nodes.insert(nodes.end(), {a, b, c});
        }
        World w = r.make();
        for (int i = 0; i < 100; ++i) ASSERT_EQ(w.step(), Status::ok) << wires;
        // A unit vector changes by at most 2.
        for (const InteractionId bend : bends)
            for (const double moment : w.force(bend))
                EXPECT_LE(std::abs(moment), 2.0 * EI / length) << wires;
        for (const BodyId id : nodes)
            EXPECT_LT(w.velocity(id).linear.norm(), 1e-2 + 9.81 * 1.7) << wires;
    }
}

TEST(FailedStep, SpinTooFastForTheStepIsNoCrash) {
    Recipe r;
    const BodyId b = r.rigid({0, 0, 0}, Quat::Identity(), 1.0, {1, 2, 2.5});
    r.bodies[static_cast<std::size_t>(b.index)].angular_velocity = {1e5, -1e5, 1e5};
    World w = r.make();
    for (int i = 0; i < 10; ++i) {
        if (w.step() != Status::ok) break;
    }
    EXPECT_TRUE(w.velocity(b).angular.allFinite());
    EXPECT_NEAR(w.pose(b).orientation.norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace hawser::test
