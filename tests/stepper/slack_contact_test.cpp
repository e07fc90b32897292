// SPDX-License-Identifier: Apache-2.0
/// Lines that go slack in the iterations that find contacts: the matrix follows both.
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

/// Make two weightless wires from one point, taut or slack, whose last nodes or elements collide.
World meeting_wires(int elements, bool segments) {
    World w({.on_diverged = OnDiverged::warn});
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    const BodyId top = w.add_body(ground);
    for (const double side : {-1.0, 1.0}) {
        BodyId last = top, before = top;
        for (int i = 0; i < elements; ++i) {
            BodyDef d;
            d.kind = BodyKind::lump;
            d.mass = 20.0;
            d.gravity = false;
            d.position = {0.5 * side, 0.0, -1.0 - i};
            d.velocity = {-5.0 * side, 0.0, 0.0};
            const BodyId now = w.add_body(d);
            InteractionDef line{.kind = InteractionKind::Stretch, .body = {last, now}};
            line.set("length", i == 0 ? 1.118 : 1.0).set("EA", 2e8).set("tension_only", 1.0);
            w.add_interaction(line);
            before = last;
            last = now;
        }
        ShapeDef s;
        s.radius = 0.04;
        s.body = segments ? before : last;
        if (segments) {
            s.kind = ShapeKind::capsule;
            s.body_b = last;
        }
        w.add_shape(s);
    }
    return w;
}

TEST(SlackContact, LinesThatSwitchDuringTheIterationsStayInTheMatrix) {
    // Wires collide, and their lines switch between taut and slack in the iterations.
    for (const auto& [elements, segments] :
         {std::pair(1, false), std::pair(3, true), std::pair(10, false), std::pair(10, true)}) {
        World w = meeting_wires(elements, segments);
        bool touched = false;
        for (int i = 0; i < 14; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            touched = touched || w.stats().contacts > 0;
            // At rest the residual is relative to a millionth of one weight's impulse in a step:
            // 1e-6 of that is negligible. A matrix without a row would give 1e9 and more.
            EXPECT_LT(w.stats().momentum_residual, 1e-5) << elements << ", step " << i;
            for (int b = 1; b < w.body_count(); ++b)
                EXPECT_LT(w.velocity(BodyId{b}).linear.norm(), 6.0) << elements << ", step " << i;
        }
        EXPECT_TRUE(touched);
    }
}

/// Make a weight on a slack line. It falls until the line becomes taut, and then bounces or
/// oscillates.
World falling_weight(double stiffness, double aside, bool touching) {
    World w;
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    const BodyId top = w.add_body(ground);
    BodyDef d;
    d.kind = BodyKind::lump;
    d.mass = 20.0;
    d.position = {aside, 0.0, -0.5};
    const BodyId weight = w.add_body(d);
    InteractionDef line{.kind = InteractionKind::Stretch, .body = {top, weight}};
    line.damping_time[0] = 0.0;
    w.add_interaction(line.set("length", 1.0).set("EA", stiffness).set("tension_only", 1.0));
    if (!touching) return w;
    // Another weight in contact with a floor: lines then switch in the iterations for contacts.
    ShapeDef s;
    s.kind = ShapeKind::plane;
    s.body = top;
    s.position = {0.0, 0.0, -50.0};
    w.add_shape(s);
    d.position = {5.0, 0.0, -49.95};
    s = {};
    s.radius = 0.05;
    s.body = w.add_body(d);
    w.add_shape(s);
    return w;
}

TEST(SlackLine, ComingTautMakesNoEnergy) {
    for (const double stiffness : {1e4, 1e6, 1e8})
        for (const double aside : {0.0, 0.3})
            for (const bool touching : {false, true}) {
                World w = falling_weight(stiffness, aside, touching);
                ASSERT_EQ(w.step(), Status::ok);
                const double before = w.energy().mechanical();
                double most = before;
                int taut = 0;
                for (int i = 0; i < 600; ++i) {
                    ASSERT_EQ(w.step(), Status::ok);
                    most = std::max(most, w.energy().mechanical());
                    taut += w.force(InteractionId{0})[0] < 0.0 ? 1 : 0;
                }
                EXPECT_GT(taut, 5);
                // Rounding of the 98 J of the fall. A fault started a line with more damping than
                // its own: the weight that it should have stopped stretched it, 76 J to 9e5 J.
                EXPECT_LE(most - before, 1e-9) << stiffness << ", " << aside << ", " << touching;
            }
}

}  // namespace
}  // namespace hawser
