// SPDX-License-Identifier: Apache-2.0
/// What the judge of energy makes of a start.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

TEST(JudgeOfAStart, TakesAForceFromRestForWhatItIs) {
    // The start goes back by h/2 to v = −(F/m) h/2 and comes to +(F/m) h/2: the force has done
    // nothing by its account, and the body moves.
    for (const double step : {1e-4, 0.01, 0.1}) {
        World w({.step = step});
        const BodyId body = w.add_body(
            {.mass = 2.0, .inertia = Mat3::Identity(), .force = {3, 0, 0}, .gravity = false});
        for (int i = 0; i < 100; ++i) {
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_EQ(w.verdict().grade, Grade::good) << "step " << i << " of " << step << " s";
        }
        EXPECT_NEAR(w.velocity(body).linear.x(), 1.5 * step * 99.5, 1e-12);
    }
}

TEST(JudgeOfAStart, StillSeesEnergyThatComesOutOfNothing) {
    // The same start; then energy is made behind its back, by moving the weight of the body up in
    // steps of its own: two joints that contradict each other, one of them moved each time.
    World w({.step = 0.01});
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    const BodyId body = w.add_body(
        {.position = {1, 0, 0}, .mass = 2.0, .inertia = Mat3::Identity(), .force = {3, 0, 0}});
    w.add(DistanceDef{.a = ground, .b = body, .length = 1.0});
    w.add(DistanceDef{.a = ground, .b = body, .length = 1.5});
    bool said = false;
    for (int i = 0; i < 200 && !said; ++i)
        said = w.step() == Status::diverged || w.verdict().grade != Grade::good;
    EXPECT_TRUE(said);
}

}  // namespace
}  // namespace hawser::test
