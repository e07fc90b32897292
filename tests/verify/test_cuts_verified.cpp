// SPDX-License-Identifier: Apache-2.0
// Separate code verifies the step in which a wire under tension is cut: its new ends are bodies
// whose velocity is in no earlier step.
#include <hawser/scene.h>

#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

class CutVerified : public ::testing::TestWithParam<double> {};

TEST_P(CutVerified, SeparateCodeAgrees) {
    scene::Scene scene = scene::load_file("scenes/tow_payout.json");
    World& world = scene.world;
    verify::Verifier verifier(world);
    for (int i = 0; i < 240; ++i) {
        if (i == 180) (void)world.wires().cut(world.wires().find("tow"), GetParam());
        verifier.before_step(world);
        ASSERT_EQ(world.step(), Status::ok) << "step " << i;
        ASSERT_EQ(verifier.after_step(world), "") << "step " << i;
    }
    // All bodies except those that the wire guard may hide, one or two at the ends.
    EXPECT_GE(verifier.result().covered_bodies, verifier.result().moving_bodies - 2);
    EXPECT_EQ(verifier.result().steps, 240);
}

// Near an end of an element, in its middle, near both ends of the wire [m].
INSTANTIATE_TEST_SUITE_P(Slots, CutVerified, ::testing::Values(60.3, 165.8, 168.2, 200.0, 318.0));

WinchDef small_winch(WireId wire, double stored) {
    return {.name = "winch",
            .wire = wire,
            .core_radius = 0.3,
            .width = 1.0,
            .wire_diameter = 0.03,
            .mass_per_length = 7.0,
            .stored = stored,
            .inertia = 400.0,
            .torque_haul = 3e6,
            .torque_pay = 3e6};
}

/// A light wire along x under 100 kN, bent to alternate sides: a step of 1/60 s does not resolve
/// its transverse vibration.
struct Lively {
    World w{WorldDef{.gravity = Vec3::Zero(), .on_diverged = OnDiverged::warn}};
    BodyId end{};
    WireId wire{};
    Lively() {
        constexpr int kElements = 30;
        const BodyId fixed = w.add_body({.kind = BodyKind::fixed});
        end = w.add_body({.kind = BodyKind::lump, .position = {kElements, 0, 0}, .mass = 40.0});
        WireDef def{.name = "wire",
                    .from = fixed,
                    .to = end,
                    .elements = kElements,
                    .length = kElements,
                    .EA = 5e8,
                    .mass_per_length = 7.0,
                    .drag = 200.0};
        for (int i = 1; i < kElements; ++i)
            def.path.push_back({1.0 * i, 0.3 * std::sin(2.0 * i), 0.3 * std::cos(5.0 * i)});
        wire = w.wires().add(def);
        w.add(small_winch(wire, 50.0));
        w.set_force(end, Vec3(1e5, 0, 0), Vec3::Zero());
    }
    [[nodiscard]] int max_flag_steps() const {
        int most = 0;
        for (const InteractionId id : w.interactions())
            most = std::max(most, w.wires().damped_steps(id));
        return most;
    }
};

TEST(CutsVerified, AWireWhoseSwingsAreDamped) {
    // Only the step has the data that the new ends receive.
    Lively l;
    verify::Verifier verifier(l.w);
    for (int i = 0; i < 200; ++i) {
        if (i == 4) l.w.set_force(l.end, Vec3(2e4, 0, 0), Vec3::Zero());
        if (i == 6) {
            EXPECT_GT(l.max_flag_steps(), 0);
            l.w.wires().detach(l.wire, 0);
        }
        verifier.before_step(l.w);
        ASSERT_EQ(l.w.step(), Status::ok) << "step " << i;
        ASSERT_EQ(verifier.after_step(l.w), "") << "step " << i;
        // Not rejected again, after which the verifier would have fewer data.
        if (i == 6) {
            EXPECT_EQ(l.w.stats().wire_repeats, 0);
        }
    }
}

TEST(CutsVerified, AWeakLinkThatPartsAsAStepBegins) {
    // A load swings on a wire whose last half metre is on the drum; then the load exceeds the
    // strength of the fastening. The tension before the release no longer acts through the element.
    World w(WorldDef{.step = 1.0 / 120.0});
    const BodyId deck = w.add_body({.kind = BodyKind::fixed});
    const BodyId load = w.add_body(
        {.kind = BodyKind::lump, .position = {0, 0, -30}, .velocity = {3, 1, 0}, .mass = 2000.0});
    const WireId wire = w.wires().add({.name = "wire",
                                       .from = deck,
                                       .to = load,
                                       .elements = 6,
                                       .EA = 3e7,
                                       .mass_per_length = 10.0});
    WinchDef def = small_winch(wire, 0.5);
    def.mass_per_length = 10.0;
    def.weak_link = 4e4;
    const WinchIds winch = w.add(def);
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
