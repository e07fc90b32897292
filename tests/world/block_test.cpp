// SPDX-License-Identifier: Apache-2.0
/// One block on a floor: more points than needed to determine the forces, and friction at its
/// limit.
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kBlockMass = 100.0, kBlockFriction = 0.5, kBlockHalfHeight = 0.25;

/// Make blocks in a row, far apart.
World blocks_on_floor(int count, std::vector<BodyId>& blocks) {
    World w;
    MaterialDef material;
    material.name = "wood";
    material.friction = kBlockFriction;
    ShapeDef s;
    s.kind = ShapeKind::plane;
    s.material = w.add_material(material);
    BodyDef d;
    d.kind = BodyKind::fixed;
    s.body = w.add_body(d);
    w.add_shape(s);
    d.kind = BodyKind::rigid;
    d.mass = kBlockMass;
    d.inertia = Vec3(10.0, 10.0, 15.0).asDiagonal();
    s.kind = ShapeKind::box;
    s.half_size = {0.5, 0.5, kBlockHalfHeight};
    for (int i = 0; i < count; ++i) {
        d.position = {0.0, 3.0 * i, kBlockHalfHeight};
        blocks.push_back(s.body = w.add_body(d));
        w.add_shape(s);
    }
    return w;
}

World block_on_floor(BodyId& block) {
    std::vector<BodyId> blocks;
    World w = blocks_on_floor(1, blocks);
    block = blocks[0];
    return w;
}

TEST(Block, FourPointsOfAFaceShareItsWeightEqually) {
    BodyId block;
    World w = block_on_floor(block);
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    ASSERT_EQ(w.contacts().size(), 4U);
    const double quarter = kBlockMass * 9.81 / 4.0;
    // Three forces would suffice: the compliance of the points makes the four equal.
    for (const ContactView& c : w.contacts()) {
        EXPECT_NEAR(std::abs(c.force.z()), quarter, 1e-6 * quarter);
        EXPECT_LT(c.force.head<2>().norm(), 1e-6 * quarter);
    }
}

/// Push with μ m g times `share`, at the height of its centre. @return distance in 2 s [m].
double pushed_way(double share, double& speed) {
    BodyId block;
    World w = block_on_floor(block);
    for (int i = 0; i < 30; ++i) EXPECT_EQ(w.step(), Status::ok);
    w.set_force(block, {share * kBlockFriction * kBlockMass * 9.81, 0.0, 0.0}, Vec3::Zero());
    for (int i = 0; i < 120; ++i) {
        EXPECT_EQ(w.step(), Status::ok);
        EXPECT_LE(w.stats().natural_map, w.settings().contact_tolerance) << share << ", " << i;
        EXPECT_EQ(w.stats().flips_left, 0) << share << ", " << i;
        EXPECT_TRUE(w.pose(block).position.allFinite());
    }
    speed = w.velocity(block).linear.x();
    return w.pose(block).position.x();
}

TEST(Block, ExactlyAtTheLimitOfFrictionItNeitherFailsNorRunsAway) {
    double speed = 0.0;
    const double h = 1.0 / 60.0, limit = kBlockFriction * 9.81;
    // Below the limit the bristles deform: F/(4 k_t), k_t = 0.7 × 5e7 N/m.
    const double give = limit * kBlockMass / (4.0 * 0.7 * 5e7);
    EXPECT_LT(pushed_way(0.9, speed), 4.0 * give);
    EXPECT_NEAR(speed, 0.0, 1e-9);
    // At the limit only the bristles of one step slow it down.
    for (const double share : {1.0 - 1e-12, 1.0, 1.0 + 1e-12}) {
        EXPECT_LT(pushed_way(share, speed), 1e-3) << share;
        EXPECT_LT(std::abs(speed), limit * h) << share;  // one step without friction
    }
    // Above the limit the difference accelerates it, from half a step before 0 on.
    (void)pushed_way(1.1, speed);
    EXPECT_NEAR(speed, 0.1 * limit * 2.0, 0.1 * limit * h);
}

/// One of eight blocks is pushed: the step's second factorisation includes only its contacts, and
/// gives the result of a single block.
TEST(Block, IterationsFactorWhatChangedOnly) {
    const Vec3 push(2.0 * kBlockFriction * kBlockMass * 9.81, 0.0, 0.0);
    BodyId single;
    World alone = block_on_floor(single);
    std::vector<BodyId> blocks;
    World w = blocks_on_floor(8, blocks);
    for (int i = 0; i < 30; ++i) {
        ASSERT_EQ(alone.step(), Status::ok);
        ASSERT_EQ(w.step(), Status::ok);
    }
    EXPECT_EQ(w.stats().partial_factorisations, 0) << "at rest one factorisation does";
    alone.set_force(single, push, Vec3::Zero());
    w.set_force(blocks[3], push, Vec3::Zero());
    ASSERT_EQ(alone.step(), Status::ok);
    ASSERT_EQ(w.step(), Status::ok);
    EXPECT_GE(w.stats().partial_factorisations, 1);
    EXPECT_LT(w.stats().partial_factorisations, w.stats().factorisations);
    EXPECT_LE(w.stats().natural_map, w.settings().contact_tolerance);
    const Twist expected = alone.velocity(single), pushed = w.velocity(blocks[3]);
    EXPECT_GT(expected.linear.x(), 0.01);
    // The same equations with other numbers around them: the tolerance of the iterations.
    EXPECT_LT((pushed.linear - expected.linear).norm(), 1e-6 * expected.linear.norm());
    EXPECT_LT((pushed.angular - expected.angular).norm(), 1e-6 * expected.linear.norm());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (i == 3) continue;
        EXPECT_LT(w.velocity(blocks[i]).linear.norm(), 1e-9) << i;
    }
}

}  // namespace
}  // namespace hawser::test
