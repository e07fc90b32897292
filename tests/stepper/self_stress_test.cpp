// SPDX-License-Identifier: Apache-2.0
// The filter of joints in loops costs substitutions only if joints are redundant.
#include "scene/catenary.h"

#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hawser {
namespace {

constexpr double kLength = 0.25, kMass = 25.0;  // a link [m, kg]

void join(World& world, BodyId a, const Vec3& at_a, BodyId b, const Vec3& at_b) {
    InteractionDef ball{.kind = InteractionKind::Ball, .body = {a, b}};
    ball.point[0] = at_a;
    ball.point[1] = at_b;
    world.add_interaction(ball);
}

/// Add rigid links that hang from a float at the origin to an anchor.
void moor(World& world, BodyId from, BodyId anchor, const Vec3& foot, int links) {
    const Vec3 top = Vec3::Zero();
    const auto nodes =
        scene::hanging_nodes(top, foot, links * kLength, links, Vec3(0.0, 0.0, -1.0));
    ASSERT_TRUE(nodes);
    BodyId before = from;
    Vec3 hold = top;
    const Vec3 half(0.5 * kLength, 0.0, 0.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(links); ++i) {
        const Vec3 a = (*nodes)[i], b = (*nodes)[i + 1];
        BodyDef link;
        link.position = 0.5 * (a + b);
        link.orientation = turn_between(Vec3::UnitX(), b - a);
        link.mass = kMass;
        const double thin = kMass * 0.05 * 0.05, flat = kMass * kLength * kLength / 12.0;
        link.inertia = Vec3(thin, thin + flat, thin + flat).asDiagonal();
        const BodyId body = world.add_body(link);
        join(world, before, hold, body, -half);
        before = body;
        hold = half;
    }
    join(world, before, hold, anchor, foot);
}

/// Add two chains from a heavy float to the seabed: a loop through every joint, none of them
/// redundant.
void moor_float(World& world, int links) {
    const BodyId seabed = world.add_body({.kind = BodyKind::fixed});
    BodyDef buoy{.mass = 2e7};
    buoy.inertia = Vec3(4e9, 4e9, 4e9).asDiagonal();
    buoy.gravity = false;
    const BodyId held = world.add_body(buoy);
    const double reach = links * kLength / 1.02, depth = 300.0;
    const double flat = std::sqrt(reach * reach - depth * depth);
    for (const double side : {-1.0, 1.0})
        moor(world, held, seabed, Vec3(side * flat, 0.0, -depth), links);
}

// A few of 20,000 joints draw values near 0, and must not count as redundant. Otherwise each step
// takes one substitution in addition to the one after each factorisation.
TEST(SelfStress, LongChainsAreNotFilteredForTheFewJointsThatDrawNothing) {
    World world({.refinements = 0});
    moor_float(world, 10'000);
    if (HasFatalFailure()) return;
    for (int step = 0; step < 6; ++step) {
        ASSERT_EQ(world.step(), Status::ok);
        const StepStats& s = world.stats();
        const int drawn = step == 0 ? 1 : 0;  // for the draw, every 16 steps
        EXPECT_EQ(s.completion_rounds, 0);
        EXPECT_EQ(s.substitutions, s.factorisations + drawn) << "step " << step;
    }
}

}  // namespace
}  // namespace hawser
