// SPDX-License-Identifier: Apache-2.0
// Sizes and first seconds of the frozen scene anchor_contact.

#include <hawser/scene.h>

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hawser {
namespace {

// Compare the frozen copy with its original counts and hash (CONTRIBUTING.md).
TEST(AnchorContact, IsFrozen) {
    scene::Scene scene = scene::load_file("bench/scenes/frozen/anchor_contact.json");
    EXPECT_EQ(scene.hash, 0x0d49d945f0930921U);
    EXPECT_EQ(scene.world.body_count(), 2057);
    EXPECT_EQ(scene.world.shape_count(), 1888);
    ASSERT_EQ(scene.world.step(), Status::ok);
    const StepStats& stats = scene.world.stats();
    EXPECT_EQ(stats.bodies, 2055);
    EXPECT_EQ(stats.interactions, 3643);
    EXPECT_EQ(stats.equations, 11632);
}

TEST(AnchorContact, StartsSettledAndCertified) {
    scene::Scene scene = scene::load_file("scenes/anchor_contact.json");
    World& world = scene.world;
    int least = 1 << 30;
    double map = 0.0, violation = 0.0;
    for (int i = 0; i < (test::kSanitized ? 20 : 120); ++i) {
        ASSERT_EQ(world.step(), Status::ok) << "step " << i;
        const StepStats& stats = world.stats();
        least = std::min(least, stats.contacts);
        map = std::max(map, stats.natural_map);
        violation = std::max(violation, stats.violation_max);
    }
    EXPECT_GE(least, 1000);
    EXPECT_LE(map, 1e-6);        // Guarantee of the solver for every step.
    EXPECT_LE(violation, 1e-3);  // Compliance times force of the joints.
    EXPECT_EQ(world.stats().islands, 1);
    EXPECT_GE(world.stats().equations + 3 * least, 9500);
    double fastest = 0.0;
    for (int i = 0; i < world.body_count(); ++i) {
        if (world.body_def({i}).kind != BodyKind::scalar) {
            fastest = std::max(fastest, world.velocity({i}).linear.norm());
        }
    }
    EXPECT_LT(fastest, 0.05);  // Friction builds up again at the start.
}

}  // namespace
}  // namespace hawser
