// SPDX-License-Identifier: Apache-2.0
/// Lines that go slack in the iterations that find contacts: the matrix follows both.
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <cmath>

namespace hawser {
namespace {

/// Two weightless wires from one point, tight or slack, whose last nodes or elements meet head-on.
World meeting_wires(int elements, bool segments) {
    World w;
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
    for (const auto& [elements, segments] :
         {std::pair(1, false), std::pair(3, true), std::pair(10, false), std::pair(10, true)}) {
        World w = meeting_wires(elements, segments);
        bool touched = false;
        for (int i = 0; i < 14; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            touched = touched || w.stats().contacts > 0;
            // At rest the residual is measured against a millionth of what one weight does in a
            // step: 1e-6 of that is no force at all. A matrix that misses a row gives 1e9 and more.
            EXPECT_LT(w.stats().momentum_residual, 1e-5) << elements << ", step " << i;
            for (int b = 1; b < w.body_count(); ++b)
                EXPECT_LT(w.velocity(BodyId{b}).linear.norm(), 6.0) << elements << ", step " << i;
        }
        EXPECT_TRUE(touched);
    }
}

}  // namespace
}  // namespace hawser
