// SPDX-License-Identifier: Apache-2.0
/// Contacts without friction whose bodies do not move, or move along the normal alone.
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <cmath>

namespace hawser::test {
namespace {

/// A capsule from a fixed body to a point mass of 10 kg over a bed.
World make_capsule(double gap, double friction, double depth) {
    World w(WorldDef{});
    const MaterialId ice = w.add_material({.name = "ice", .friction = friction});
    ShapeDef plane{.kind = ShapeKind::plane,
                   .body = w.add_body({.kind = BodyKind::fixed, .position = {0, 0, -depth}})};
    plane.material = ice;
    w.add_shape(plane);
    const BodyId end = w.add_body({.kind = BodyKind::fixed, .position = {0, 0, 0.1 + gap - depth}});
    const BodyId mass =
        w.add_body({.kind = BodyKind::lump, .position = {2, 0, 0.1 - depth}, .mass = 10.0});
    ShapeDef capsule{.kind = ShapeKind::capsule, .body = mass, .body_b = end, .radius = 0.1};
    capsule.material = ice;
    w.add_shape(capsule);
    InteractionDef line{.kind = InteractionKind::Stretch, .body = {end, mass}};
    w.add_interaction(line.set("length", 2.0).set("EA", 1e6));
    return w;
}

/// Each step is certified with one or two factorisations, for any gap at the fixed end.
TEST(Frictionless, AContactOfFixedBodiesIsOpen) {
    Random random(first_seed(1));
    for (int i = by_tier(24, 400, 4000); i > 0; --i) {
        const double gap = std::pow(10.0, random.uniform(-16.0, -1.0));
        const double depth = random.chance(0.5) ? 0.0 : random.uniform(1.0, 500.0);
        World w = make_capsule(gap, 0.0, depth);
        double factorisations = 0.0;
        constexpr int kRun = 60;
        for (int k = 0; k < kRun; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            factorisations += w.stats().factorisations;
            ASSERT_LE(w.stats().natural_map, 1e-6) << gap << " m, depth " << depth << " m";
        }
        EXPECT_LE(factorisations / kRun, 2.0) << gap << " m, depth " << depth << " m";
        EXPECT_EQ(w.verdict().grade, Grade::good);
        // The mass rests: the motion is that of a contact with little friction.
        EXPECT_NEAR(w.pose(BodyId{2}).position.z() + depth, 0.1, 1e-5);
    }
}

/// A body that falls without friction straight onto a plane has a tangential velocity of exactly 0.
TEST(Frictionless, AFallingBallIsCertified) {
    WorldDef def;
    World w(def);
    const MaterialId ice = w.add_material({.name = "ice", .friction = 0.0});
    ShapeDef plane{.kind = ShapeKind::plane, .body = w.add_body({.kind = BodyKind::fixed})};
    plane.material = ice;
    w.add_shape(plane);
    ShapeDef ball{.kind = ShapeKind::sphere,
                  .body = w.add_body(
                      {.position = {0, 0, 0.6}, .mass = 1.0, .inertia = 0.004 * Mat3::Identity()}),
                  .radius = 0.1};
    ball.material = ice;
    w.add_shape(ball);
    for (int k = 0; k < 60; ++k) {
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_LE(w.stats().natural_map, 1e-6) << "step " << k;
    }
    EXPECT_NEAR(w.pose(BodyId{1}).position.z(), 0.1, 1e-5);
}

}  // namespace
}  // namespace hawser::test
