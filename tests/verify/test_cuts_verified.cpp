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

TEST(CutsVerified, AWeakLinkThatPartsAsAStepBegins) {
    // A load swings on a wire whose last half metre lies on the drum; then more hangs on it than
    // its end there holds. Nothing of the tension before acts across the element any more.
    World w(WorldDef{.step = 1.0 / 120.0});
    const BodyId deck = w.add_body({.kind = BodyKind::fixed});
    const BodyId load = w.add_body(
        {.kind = BodyKind::lump, .position = {0, 0, -30}, .velocity = {3, 1, 0}, .mass = 2000.0});
    const WireId wire = w.add_wire({.name = "wire",
                                    .from = deck,
                                    .to = load,
                                    .elements = 6,
                                    .EA = 3e7,
                                    .mass_per_length = 10.0});
    const WinchIds winch = w.add(WinchDef{.name = "winch",
                                          .wire = wire,
                                          .core_radius = 0.3,
                                          .width = 1.0,
                                          .wire_diameter = 0.03,
                                          .mass_per_length = 10.0,
                                          .stored = 0.5,
                                          .inertia = 400.0,
                                          .torque_haul = 3e6,
                                          .torque_pay = 3e6,
                                          .weak_link = 4e4});
    verify::Verifier verifier(w);
    for (int i = 0; i < 240; ++i) {
        if (i == 60) w.set_force(load, Vec3(0, 0, -6e4), Vec3::Zero());
        verifier.before_step(w);
        ASSERT_EQ(w.step(), Status::ok) << "step " << i;
        ASSERT_EQ(verifier.after_step(w), "") << "step " << i;
        if (i == 59) {
            EXPECT_TRUE(w.intact(winch.line));
        }
    }
    EXPECT_FALSE(w.intact(winch.line));
}

}  // namespace
}  // namespace hawser
