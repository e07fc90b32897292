// SPDX-License-Identifier: Apache-2.0
/// One block on a floor: more points than forces can be told apart, and friction at its limit.
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <algorithm>
#include <cmath>

namespace hawser::test {
namespace {

constexpr double kBlockMass = 100.0, kBlockFriction = 0.5, kBlockHalfHeight = 0.25;

World block_on_floor(BodyId& block) {
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
    d.position = {0.0, 0.0, kBlockHalfHeight};
    s.body = block = w.add_body(d);
    s.kind = ShapeKind::box;
    s.half_size = {0.5, 0.5, kBlockHalfHeight};
    w.add_shape(s);
    return w;
}

TEST(Block, FourPointsOfAFaceShareItsWeightEqually) {
    BodyId block;
    World w = block_on_floor(block);
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    ASSERT_EQ(w.contacts().size(), 4U);
    const double quarter = kBlockMass * 9.81 / 4.0;
    // Three forces would do: it is the compliance of the points that makes the four equal.
    for (const ContactView& c : w.contacts()) {
        EXPECT_NEAR(std::abs(c.force.z()), quarter, 1e-6 * quarter);
        EXPECT_LT(c.force.head<2>().norm(), 1e-6 * quarter);
    }
}

/// Pushed by μ m g times `share`, at the height of its centre. @return way in 2 s [m].
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
    // Below the limit the bristles give way: F/(4 k_t), k_t = 0.7 × 5e7 N/m.
    const double give = limit * kBlockMass / (4.0 * 0.7 * 5e7);
    EXPECT_LT(pushed_way(0.9, speed), 4.0 * give);
    EXPECT_NEAR(speed, 0.0, 1e-9);
    // At the limit nothing is left to slow it down but what a step's bristles hold.
    for (const double share : {1.0 - 1e-12, 1.0, 1.0 + 1e-12}) {
        EXPECT_LT(pushed_way(share, speed), 1e-3) << share;
        EXPECT_LT(std::abs(speed), limit * h) << share;  // one step without friction
    }
    // Above: the difference accelerates it, from half a step before 0 on.
    (void)pushed_way(1.1, speed);
    EXPECT_NEAR(speed, 0.1 * limit * 2.0, 0.1 * limit * h);
}

}  // namespace
}  // namespace hawser::test
