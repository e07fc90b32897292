// SPDX-License-Identifier: Apache-2.0
/// Save every scene at random steps and restore it in another world of the same file: later steps
/// are equal bit for bit.
#include "stepper/scenes.h"
#include "support/random.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <hawser/experimental/splits.h>

#include <gtest/gtest.h>

namespace hawser {
namespace {

TEST(SceneRestore, ContinuesBitForBitAtRandomSteps) {
    const std::uint32_t seed = test::first_seed(17);
    const int rounds = test::by_tier(2, test::kSanitized ? 2 : 20, 200);
    for (const auto& file : test::scene_files()) {
        scene::Scene one = scene::load_file(file), other = scene::load_file(file);
        World &a = one.world, &b = other.world;
        test::Random random(seed);
        for (int round = 0; round < rounds; ++round) {
            for (int i = random.integer(0, 4); i > 0; --i) ASSERT_EQ(a.step(), Status::ok) << file;
            b.state().restore(a.state().structure(), a.state().save());
            ASSERT_EQ(a.state().hash(), b.state().hash()) << file << " round " << round;
            ASSERT_EQ(a.step(), Status::ok) << file;
            ASSERT_EQ(b.step(), Status::ok) << file;
            ASSERT_EQ(a.state().hash(), b.state().hash()) << file << " round " << round;
        }
        EXPECT_EQ(a.state().save(), b.state().save()) << file;
    }
}

/// A request of parts evaluates rows at the present poses, which must not affect steps.
TEST(SceneRestore, PartitionsLeaveTheStateAlone) {
    for (const auto& file : test::scene_files()) {
        scene::Scene one = scene::load_file(file), other = scene::load_file(file);
        World &a = one.world, &b = other.world;
        a.prepare();
        b.prepare();
        // Small ones run long enough for joints to reach their limits and leave them.
        const int steps = a.body_count() < 50 ? 200 : 12;
        for (int i = 0; i < (test::kSanitized ? steps / 4 : steps); ++i) {
            for (const PartitionUse use : {PartitionUse::cuts, PartitionUse::separators})
                EXPECT_GE(a.splits().partition({.use = use, .parts = 3}).parts, 3) << file;
            ASSERT_EQ(a.state().hash(), b.state().hash()) << file << " before step " << i;
            ASSERT_EQ(a.step(), Status::ok) << file;
            ASSERT_EQ(b.step(), Status::ok) << file;
            ASSERT_EQ(a.state().hash(), b.state().hash()) << file << " step " << i;
        }
        EXPECT_EQ(a.state().save(), b.state().save()) << file;
    }
}

}  // namespace
}  // namespace hawser
