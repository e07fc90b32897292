// SPDX-License-Identifier: Apache-2.0
// Sizes and first seconds of the frozen scene anchor_lines; tests/slow runs it for a minute.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scenes/anchor_lines_probe.h"

namespace hawser {
namespace {

constexpr const char* kScene = "scenes/anchor_lines.json";

scene::Scene load(int scale = 1) {
    scene::Options options;
    options.scale = scale;
    return scene::load_file(kScene, options);
}

// Compare the frozen copy with its original counts and hash (CONTRIBUTING.md).
TEST(AnchorLines, IsFrozenWithTheDesignedSizes) {
    scene::Scene scene = scene::load_file("bench/scenes/frozen/anchor_lines.json");
    EXPECT_EQ(scene.hash, 0x1c1b7aa5303ee24aU);
    EXPECT_EQ(scene.world.body_count(), 1002);
    std::map<BodyKind, int> bodies;
    for (int i = 0; i < scene.world.body_count(); ++i) {
        ++bodies[scene.world.body_def({i}).kind];
    }
    // Counted by scripts/make_anchor_lines.py from the cables and templates.
    EXPECT_EQ(bodies[BodyKind::rigid], 42);
    EXPECT_EQ(bodies[BodyKind::scalar], 18);
    EXPECT_EQ(bodies[BodyKind::lump], 934);
    EXPECT_EQ(scene.world.interaction_count(), 1952);
    std::size_t elements = 0;
    for (const scene::Cable& cable : scene.cables) {
        elements += cable.stretch.size();
        EXPECT_EQ(cable.nodes.size(), cable.stretch.size() + 1) << cable.name;
        EXPECT_GT(cable.breaking_load, 0.0) << cable.name;
    }
    EXPECT_EQ(elements, 952U);

    ASSERT_EQ(scene.world.step(), Status::ok);
    const StepStats& stats = scene.world.stats();
    EXPECT_EQ(stats.bodies, 994);
    EXPECT_EQ(stats.interactions, 1952);
    EXPECT_EQ(stats.equations, 6099);
    EXPECT_EQ(stats.islands, 1);
}

TEST(AnchorLines, MassRatioIsThatOfTheClass) {
    scene::Scene scene = load();
    double least = 1e300;
    double most = 0.0;
    for (int i = 0; i < scene.world.body_count(); ++i) {
        const BodyDef& def = scene.world.body_def({i});
        if (def.kind == BodyKind::lump || def.kind == BodyKind::rigid) {
            least = std::min(least, def.mass);
            most = std::max(most, def.mass);
        }
    }
    EXPECT_GT(most / least, 1e5);  // Rig 2.8e7 kg; work wire nodes 98 kg, hoist wire nodes 7 kg.
}

TEST(AnchorLines, StartsSettled) {
    scene::Scene scene = load();
    test::AnchorLinesProbe probe(scene);
    ASSERT_EQ(probe.vessel_count(), 3U);
    for (int i = 0; i < 120; ++i) {
        ASSERT_TRUE(probe.step()) << "step " << i;
    }
    double fastest = 0.0;
    for (int i = 0; i < scene.world.body_count(); ++i) {
        if (scene.world.body_def({i}).kind != BodyKind::scalar) {
            fastest = std::max(fastest, scene.world.velocity({i}).linear.norm());
        }
    }
    EXPECT_LT(fastest, 1e-3);  // A stored state at rest; the unsettled start moves at 1 m/s.
    EXPECT_LT(probe.drift_max, 1e-3);
    EXPECT_LE(probe.violation_max, 1e-3);
    EXPECT_LE(probe.stretch_error_max, 1e-4);
    EXPECT_GT(probe.tension_min, 0.0);
    EXPECT_LT(probe.load_max, 0.25);  // Designed for a safety factor of at least 5.
}

TEST(AnchorLines, ARowOfSitesIsOneIsland) {
    constexpr int kCopies = 3;
    scene::Scene scene = load(kCopies);
    ASSERT_EQ(scene.world.step(), Status::ok);
    const StepStats& stats = scene.world.stats();
    constexpr int kTowNodes = 59;
    EXPECT_EQ(stats.bodies, kCopies * 994 + (kCopies - 1) * kTowNodes);
    EXPECT_EQ(stats.islands, 1);
    EXPECT_LE(stats.violation_max, 1e-3);
}

}  // namespace
}  // namespace hawser
