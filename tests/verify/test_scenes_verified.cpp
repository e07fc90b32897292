// SPDX-License-Identifier: Apache-2.0
// Separate code verifies the first seconds of every scene with contacts: laws of contacts, momentum
// of bodies, bounds of rows.
#include <hawser/scene.h>

#include "support/sanitizer.h"
#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace hawser {
namespace {

constexpr int kVerifiedSteps = test::kSanitized ? 12 : 120;

// A list: finding the names would require reading all scenes.
const std::vector<std::string> kTouchingScenes = {"anchor_adaptive",
                                                  "anchor_contact",
                                                  "anchor_drag",
                                                  "anchor_handling",
                                                  "anchor_handling_lower",
                                                  "anchor_run",
                                                  "anchor_run_fine",
                                                  "anchor_seaway",
                                                  "arch",
                                                  "belt",
                                                  "berthing",
                                                  "bouncing_ball",
                                                  "box_stack",
                                                  "box_stack_1e6",
                                                  "buoy",
                                                  "chain_gypsy",
                                                  "chain_pile",
                                                  "chaser",
                                                  "crane_knuckle",
                                                  "crane_lattice",
                                                  "incline",
                                                  "incline_slide",
                                                  "moored_barge",
                                                  "mooring_seabed",
                                                  "painleve",
                                                  "rolling_resistance",
                                                  "rolling_sphere",
                                                  "spinning_disk",
                                                  "subsea_lift",
                                                  "tow_payout",
                                                  "wall_648",
                                                  "wall_976",
                                                  "wedge",
                                                  "wire_cross",
                                                  "wire_cylinder",
                                                  "wire_edge",
                                                  "wire_pins",
                                                  "wire_slide"};

TEST(SceneVerified, IsEverySceneWithShapes) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
        const std::string file = entry.path().filename().string();
        // A state or a part has a name of two words: "anchor_lines.settled.json".
        if (file.ends_with(".json") && file.find('.') + 5 == file.size() &&
            scene::load_file(entry.path()).world.shape_count() > 0)
            names.push_back(file.substr(0, file.size() - 5));
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, kTouchingScenes);
}

/// Scenes of more than 1,000 bodies whose kinds of bodies and wires are in other scenes as well.
const std::vector<std::string> kLargeScenes = {"anchor_adaptive", "anchor_handling",
                                               "anchor_handling_lower", "anchor_run_fine",
                                               "anchor_seaway"};

bool is_large(const std::string& scene) {
    return std::find(kLargeScenes.begin(), kLargeScenes.end(), scene) != kLargeScenes.end();
}

std::vector<std::string> small_scenes() {
    std::vector<std::string> out;
    std::remove_copy_if(kTouchingScenes.begin(), kTouchingScenes.end(), std::back_inserter(out),
                        is_large);
    return out;
}

class VerifiedScene : public ::testing::TestWithParam<std::string> {};

TEST_P(VerifiedScene, SeparateCodeAgrees) {
    scene::Scene scene = scene::load_file("scenes/" + GetParam() + ".json");
    verify::Verifier verifier(scene.world);
    int open_steps = 0;
    for (int i = 0; i < kVerifiedSteps; ++i) {
        verifier.before_step(scene.world);
        ASSERT_EQ(scene.world.step(), Status::ok) << "step " << i;
        ASSERT_EQ(verifier.after_step(scene.world), "") << "step " << i;
        const StepStats& stats = scene.world.stats();
        const bool solved = stats.natural_map <= scene.world.settings().contact_tolerance;
        open_steps += solved && stats.flips_left == 0 ? 0 : 1;
    }
    // Guarantee of the solver for every step. Friction of Painlevé's rod is beyond the paradox:
    // when it stops sliding, a step may have no solution (`hawser validate painleve` allows the
    // same number).
    EXPECT_LE(open_steps, GetParam() == "painleve" ? 2 : 0);
    // The jaw of this scene closes in the first step. The verifier does not check a step that adds
    // a joint; the slack chain and pennant become taut after it.
    const bool joins = GetParam() == "anchor_handling_lower";
    EXPECT_EQ(verifier.result().steps, kVerifiedSteps - (joins ? 1 : 0));
    // Both figures are sums of a few terms in different orders.
    EXPECT_LE(verifier.result().difference, 1e-9);
    // It may leave out a body for a step if rounding determines a row's direction; not many.
    EXPECT_GE(10 * verifier.result().covered_bodies, 9 * verifier.result().moving_bodies);
    EXPECT_LE(verifier.result().rejected_steps, joins ? 3 : 2);
}

INSTANTIATE_TEST_SUITE_P(Scenes, VerifiedScene, ::testing::ValuesIn(small_scenes()),
                         [](const auto& scene) { return scene.param; });
INSTANTIATE_TEST_SUITE_P(LargeScenes, VerifiedScene, ::testing::ValuesIn(kLargeScenes),
                         [](const auto& scene) { return scene.param + "_full"; });

}  // namespace
}  // namespace hawser
