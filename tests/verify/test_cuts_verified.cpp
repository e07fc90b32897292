// SPDX-License-Identifier: Apache-2.0
// Separate code verifies the step in which a wire under tension is cut: its new ends are bodies
// that go on with a velocity that no earlier step of theirs tells.
#include <hawser/scene.h>

#include "verify/certificate.h"

#include <gtest/gtest.h>

namespace hawser {
namespace {

class CutVerified : public ::testing::TestWithParam<double> {};

TEST_P(CutVerified, SeparateCodeAgrees) {
    scene::Scene scene = scene::load_file("scenes/tow_payout.json");
    World& world = scene.world;
    verify::Verifier verifier(world);
    for (int i = 0; i < 240; ++i) {
        if (i == 180) (void)world.cut(world.find_wire("tow"), GetParam());
        verifier.before_step(world);
        ASSERT_EQ(world.step(), Status::ok) << "step " << i;
        ASSERT_EQ(verifier.after_step(world), "") << "step " << i;
    }
    // All but what guards wires against energy may hide, a body or two at the ends.
    EXPECT_GE(verifier.result().covered_bodies, verifier.result().moving_bodies - 2);
    EXPECT_EQ(verifier.result().steps, 240);
}

// Near an end of an element, in its middle, near both ends of the wire [m].
INSTANTIATE_TEST_SUITE_P(Places, CutVerified, ::testing::Values(60.3, 165.8, 168.2, 200.0, 318.0));

}  // namespace
}  // namespace hawser
