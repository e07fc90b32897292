// SPDX-License-Identifier: Apache-2.0
// Verification of steps that a budget ends early: reported tensions of wire elements are those that
// moved their nodes, also for elements that went slack in the iterations.
#include <hawser/scene.h>

#include "verify/certificate.h"

#include <gtest/gtest.h>

namespace hawser {
namespace {

/// A wire of 30 elements, fixed at one end, falls on three balls and a deck.
constexpr const char* kFallingWire = R"({
  "version": 1, "name": "falling_wire", "settings": {"step": 0.016666666666666666},
  "materials": {"m": {"friction": 0.6}},
  "bodies": [
    {"name": "deck", "kind": "fixed",
     "shapes": [{"kind": "box", "half_size": [20, 9, 1], "position": [0, 0, -1], "material": "m"}]},
    {"name": "b0", "position": [-3.713, -1.216, 0.4], "mass": 300, "sphere": 0.3,
     "shapes": [{"kind": "sphere", "radius": 0.3, "material": "m"}]},
    {"name": "b1", "position": [-2.283, -1.475, 0.4], "mass": 300, "sphere": 0.3,
     "shapes": [{"kind": "sphere", "radius": 0.3, "material": "m"}]},
    {"name": "b2", "position": [-0.349, -1.279, 0.4], "mass": 300, "sphere": 0.3,
     "shapes": [{"kind": "sphere", "radius": 0.3, "material": "m"}]}],
  "line_types": {"w": {"mass_per_length": 12, "EA": 1.2e8, "diameter": 0.056}},
  "cables": [{"name": "c", "line_type": "w", "from": {"free": [-8, -1.7, 5]},
              "to": {"body": "deck", "point": [10, 0, 0.1]}, "elements": 30,
              "shape": "straight", "contact": {"material": "m"}}]})";

TEST(IdleRows, OfStepsThatABudgetEndsShowWhatActs) {
    scene::Options options;
    options.budget_work = 2e4;  // an iteration or two
    scene::Scene scene = scene::load_text(kFallingWire, "falling_wire", options);
    World& world = scene.world;
    verify::Verifier verifier(world);
    int cut = 0;
    for (int i = 0; i < 150; ++i) {
        verifier.before_step(world);
        ASSERT_EQ(world.step(), Status::ok) << "step " << i;
        ASSERT_EQ(verifier.after_step(world), "") << "step " << i;
        cut += world.stats().cut ? 1 : 0;
    }
    EXPECT_GT(cut, 10);
}

}  // namespace
}  // namespace hawser
