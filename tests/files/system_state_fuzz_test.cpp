// SPDX-License-Identifier: Apache-2.0
/// Snapshots of scenes with winches, cranes, seas and other systems, with changed contents and a
/// valid checksum. Each is rejected and leaves the world unchanged, or is accepted and the world
/// continues in bounded time.
#include "files/forge_state.h"
#include "files/watch.h"
#include "scene/good_scenes.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <optional>
#include <string>

namespace hawser::test {
namespace {

struct Outcome {
    int refused = 0, taken = 0, failed = 0;
    double longest = 0.0;
};

/// Attack a scene. @param share  Fraction of the inputs that change only systems; the others change
/// any part.
void attack_systems(const std::string& name, int inputs, double share, std::uint64_t seed,
                    Outcome& out, std::string_view text = {}) {
    Random random(seed);
    std::optional<scene::Scene> scene(after_some_steps(name, text));
    const std::vector<std::byte> good = scene->world.state().save();
    scene->world.state().restore(good);
    const auto hash = scene->world.state().hash();
    const auto systems = static_cast<std::size_t>(
        read_at<std::uint64_t>(std::span<const std::byte>(good), kSnapshotSystems));
    ASSERT_GT(systems, 0u) << name;
    const std::size_t first = good.size() - 8 - systems;
    Watch watch;
    for (int i = 0; i < inputs; ++i) {
        std::vector<std::byte> bad = good;
        const bool only = random.chance(share);
        forge_tail(bad, only ? first : kSnapshotSystems + 8, random);
        watch.begin(name + ", seed " + std::to_string(seed) + ", input " + std::to_string(i));
        World& world = scene->world;
        bool taken = true;
        try {
            world.state().restore(bad);
        } catch (const DefError& error) {
            taken = false;
            EXPECT_NE(std::string(error.what()).find("snapshot"), std::string::npos)
                << error.what();
        }
        ++(taken ? out.taken : out.refused);
        if (taken) {
            for (int k = 0; k < 2; ++k) out.failed += world.step() == Status::ok ? 0 : 1;
            (void)world.energy();
        }
        const double took = watch.seconds();
        out.longest = std::max(out.longest, took);
        EXPECT_LT(took, kLongest) << running;
        if (!taken) {
            ASSERT_EQ(world.state().hash(), hash) << running;
            continue;
        }
        try {
            world.state().restore(good);
        } catch (const DefError&) {  // a step has inserted or removed nodes
            scene.emplace(after_some_steps(name, text));
            scene->world.state().restore(good);
        }
        ASSERT_EQ(scene->world.state().hash(), hash) << running;
    }
}

class ForgedSystems : public testing::TestWithParam<const char*> {};

constexpr const char* kSystemScenes[] = {
    "winch_modes",   "payout",       "tow_payout",   "chain_gypsy", "wire_bollard",
    "wire_edge",     "wire_pins",    "wire_slide",   "chaser",      "crane_knuckle",
    "crane_lattice", "floating_box", "sphere_decay", "drifter"};

int of_scene(int quick, int full, int long_runs) { return inputs_of(quick, full, long_runs); }

void attack_scene(const std::string& name, int inputs, std::string_view text = {}) {
    Outcome out;
    attack_systems(name, inputs, 0.7, first_seed(61), out, text);
    std::printf("%s: %d refused, %d taken, %d of their steps failed, longest %.3f s\n",
                name.c_str(), out.refused, out.taken, out.failed, out.longest);
    EXPECT_GT(out.refused, 0);
    EXPECT_GT(out.taken, 0);
}

TEST_P(ForgedSystems, AreRefusedOrTaken) { attack_scene(GetParam(), of_scene(40, 350, 7000)); }

INSTANTIATE_TEST_SUITE_P(Scenes, ForgedSystems, testing::ValuesIn(kSystemScenes),
                         [](const auto& scene_name) { return std::string(scene_name.param); });

/// Hooks, stoppers, pins, chasers and cranes.
TEST(ForgedSystemsOfAScene, Gear) {
    attack_scene("gear", of_scene(40, 350, 7000), scene::test::kCranes);
}

/// Anchors, a stability gauge, a winch that protects and compensates.
TEST(ForgedSystemsOfAScene, Anchors) {
    attack_scene("anchors", of_scene(40, 350, 7000), scene::test::kAnchors);
}

/// Stoppers, pins, resolution, bollards, two winches.
TEST(ForgedSystemsOfAScene, AnchorRun_full) { attack_scene("anchor_run", of_scene(20, 60, 1200)); }
TEST(ForgedSystemsOfAScene, AnchorSea_full) { attack_scene("anchor_sea", of_scene(20, 60, 1200)); }

}  // namespace
}  // namespace hawser::test
