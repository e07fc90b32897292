// SPDX-License-Identifier: Apache-2.0
/// Lines around bollards by several turns: nearly all of their bound comes from their own friction.
#include "support/recipe.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <cmath>
#include <string>

namespace hawser {
namespace {

using test::between;

/// A weight of 50 kg and a heavier one, by a fraction of e^{μδ}, on a line around a bollard.
struct Capstan {
    InteractionId light, heavy, friction;
    BodyId weight;
};

Capstan add_capstan(World& w, BodyId ground, double y, double angle, double share) {
    constexpr double kLight = 50.0;
    BodyDef line;
    line.kind = BodyKind::scalar;
    line.mass = 1e-3;
    line.gravity = false;
    const BodyId spool = w.add_body(line);
    const auto end = [&](double x, double mass, double radius) {
        BodyDef d;
        d.kind = BodyKind::lump;
        d.mass = mass;
        d.position = {x, y, -5.0};
        InteractionDef s = between(InteractionKind::WinchStretch, {ground, w.add_body(d), spool});
        s.point[0] = {x, y, 0.0};
        s.set("EA", 1e7).set("length", 5.0).set("radius", radius);
        s.damping_time[0] = 0.05;
        return w.add_interaction(s);
    };
    Capstan c;
    c.light = end(0.5, kLight, 1.0);
    c.heavy = end(-0.5, kLight * share * std::exp(angle), -1.0);
    c.weight = w.interaction_def(c.heavy).body[1];
    InteractionDef f = between(InteractionKind::ScalarFriction, {spool});
    f.load[0] = {c.light, std::tanh(0.5 * angle)};
    f.load[1] = {c.heavy, std::tanh(0.5 * angle)};
    c.friction = w.add_interaction(f);
    return c;
}

class Capstans : public testing::TestWithParam<bool> {
  protected:
    World w;
    BodyId ground{};
    void SetUp() override {
        BodyDef fixed;
        fixed.kind = BodyKind::fixed;
        ground = w.add_body(fixed);
        if (!GetParam()) return;
        // Add sliding boxes: Newton's method then solves the world.
        ShapeDef plane;
        plane.kind = ShapeKind::plane;
        plane.body = ground;
        plane.position = {0, 0, -20};
        w.add_shape(plane);
        BodyDef box;
        box.mass = 100.0;
        box.inertia = 10.0 * Mat3::Identity();
        box.position = {30, 0, -19.5};
        box.velocity = {3, 0, 0};
        ShapeDef s;
        s.kind = ShapeKind::box;
        s.half_size = {0.5, 0.5, 0.5};
        s.body = w.add_body(box);
        w.add_shape(s);
    }
};

/// Half a turn to three turns at μ = 0.3, all at once: ratios of 2.6 to 286. Without acceleration
/// the last needs 2,000 iterations per step; the limit is 100.
TEST_P(Capstans, RunAtEulersRatio) {
    std::vector<std::pair<Capstan, double>> all;
    for (const double turns : {0.5, 1.0, 2.0, 3.0}) {
        const double angle = 0.3 * 2.0 * 3.14159265358979 * turns;
        all.emplace_back(add_capstan(w, ground, 4.0 * turns, angle, 1.2), angle);
    }
    int iterations = 0, long_steps = 0;
    for (int k = 0; k < 60; ++k) {
        ASSERT_EQ(w.step(), Status::ok);
        iterations += w.stats().newton_iterations;
        EXPECT_LE(w.stats().natural_map, 1e-6) << k;
        EXPECT_EQ(w.stats().flips_left, 0) << k;
        long_steps += w.stats().newton_iterations > 32 ? 1 : 0;
        if (k < 30) continue;
        for (const auto& [c, angle] : all) {
            const double ratio = w.force(c.heavy)[0] / w.force(c.light)[0];
            // The bound is met to 1e-6 of itself, and the smaller tension is e^{−μδ} of it.
            EXPECT_NEAR(ratio / std::exp(angle), 1.0, 2e-6 * std::exp(angle)) << angle << " " << k;
        }
    }
    if (GetParam()) {
        // Four unknowns, switches and contacts together; mostly 3 to 11. Rounding determines the
        // worst step, 15 to 60.
        EXPECT_LE(iterations, 60 * 10);
        EXPECT_LE(long_steps, 3);
    }
    for (const auto& [c, angle] : all) EXPECT_LT(w.velocity(c.weight).linear.z(), -0.3) << angle;
}

TEST_P(Capstans, HoldsBelowIt) {
    const Capstan c = add_capstan(w, ground, 0.0, 0.3 * 6.0 * 3.14159265358979, 0.9);
    for (int k = 0; k < 900; ++k) ASSERT_EQ(w.step(), Status::ok);
    const double z = w.pose(c.weight).position.z();
    for (int k = 0; k < 600; ++k) {
        ASSERT_EQ(w.step(), Status::ok);
        EXPECT_LE(w.stats().natural_map, 1e-6);
    }
    EXPECT_NEAR(w.pose(c.weight).position.z(), z, 1e-9) << "it hangs still for 10 s";
}

/// One iteration cannot switch a line that comes taut and solve with it. Such a step reports this,
/// although its contacts, at rest, are solved.
TEST(BoundsLeftOpen, AreCountedWhereIterationsEnd) {
    WorldDef def{.on_diverged = OnDiverged::warn};
    def.contact_iterations = 1;
    World w(def);
    BodyDef d;
    d.kind = BodyKind::fixed;
    const BodyId ground = w.add_body(d);
    ShapeDef plane;
    plane.kind = ShapeKind::plane;
    plane.body = ground;
    w.add_shape(plane);
    d.kind = BodyKind::rigid;
    d.mass = 100.0;
    d.inertia = 10.0 * Mat3::Identity();
    d.position = {5.0, 0.0, 0.5};
    ShapeDef box;
    box.kind = ShapeKind::box;
    box.half_size = {0.5, 0.5, 0.5};
    box.body = w.add_body(d);
    w.add_shape(box);
    d.kind = BodyKind::lump;
    d.mass = 10.0;
    d.position = {0.0, 0.0, 19.5};
    InteractionDef line = between(InteractionKind::Stretch, {ground, w.add_body(d)});
    line.point[0] = {0.0, 0.0, 20.0};
    line.set("EA", 1e6).set("length", 2.0).set("tension_only", 1.0);
    w.add_interaction(line);
    int open = 0;
    for (int k = 0; k < 60; ++k) {
        ASSERT_EQ(w.step(), Status::ok);
        if (w.stats().natural_map <= def.contact_tolerance && w.stats().flips_left > 0) ++open;
    }
    EXPECT_GT(open, 0);
}

INSTANTIATE_TEST_SUITE_P(Worlds, Capstans, testing::Bool(), [](const auto& with) {
    return std::string(with.param ? "WithContacts" : "Alone");
});

}  // namespace
}  // namespace hawser
