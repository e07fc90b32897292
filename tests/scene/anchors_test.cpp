// SPDX-License-Identifier: Apache-2.0
/// The keys "anchors" and "stability" of a scene, and those of winches that protect and compensate.
#include <hawser/anchor.h>
#include <hawser/scene.h>
#include <hawser/stability.h>

#include "anchor_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace hawser::scene::test {
namespace {

std::string anchor_text(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string anchor_scene_refusal(const std::string& text) {
    try {
        (void)load_text(text, "anchors");
    } catch (const SceneError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(SceneAnchors, KeysReachTheDefinition) {
    Scene scene = load_text(std::string(kAnchors), "anchors");
    World& w = scene.world;
    const std::vector<AnchorView> anchors = anchors_of(w);
    ASSERT_EQ(anchors.size(), 2u);
    const AnchorDef& hold = anchors[0].def;
    EXPECT_EQ(hold.body, w.find_body("hook"));
    EXPECT_EQ(hold.wire, w.wires().find("line"));
    EXPECT_EQ(hold.soil, AnchorSoil::sand);
    EXPECT_EQ(hold.uhc, anchor_uhc(AnchorType::stevpris_mk6, AnchorSoil::sand, 8100.0));
    EXPECT_EQ(hold.set_after, 1.5);
    EXPECT_EQ(hold.clay.chain_bearing, 10.0);
    EXPECT_TRUE(anchors[0].set);
    EXPECT_EQ(anchors[1].def.law, AnchorLaw::trajectory);
    EXPECT_NEAR(anchors[1].def.clay.fluke_angle, 50.0 * std::numbers::pi / 180.0, 1e-12);
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    // g = 0.1 + 0.9 (1 - e^(-20/15)); the line leads up by 8 to 14 degrees, f 0.5 to 0.7.
    const double angle = w.system_signal("hold.line_angle");
    EXPECT_GT(angle, 0.1);
    EXPECT_LT(angle, 0.25);
    const double level = hold.uhc * (1.0 - 0.9 * std::exp(-20.0 / 15.0));
    EXPECT_GT(w.system_signal("hold.capacity"), 0.5 * level);
    EXPECT_LT(w.system_signal("hold.capacity"), 0.75 * level);
    EXPECT_NEAR(w.system_signal("gauge.gz_max"), 1.5, 1e-6);  // GM at 90 degrees
    EXPECT_GT(w.system_signal("gauge.permissible"), 0.0);
    EXPECT_GT(w.system_signal("hoist.wire_out"), 40.0);
}

TEST(SceneAnchors, SlipsAreNamedWithTheirPlace) {
    struct Slip {
        std::string from, to, said;
    };
    const std::string good(kAnchors);
    const Slip slips[] = {
        {R"("soil": "sand")", R"("soil": "sandy")", "did you mean \"sand\""},
        {R"("soil": "sand",)", "", "/anchors/0: "},
        {R"("type": "stevpris_mk6")", R"("type": "stevmud")", "/anchors/0/soil: no capacity"},
        {R"("body": "plough")", R"("body": "plow")", "/anchors/1/body: there is no body \"plow\""},
        {R"("cable": "line", "soil")", R"("cable": "lin", "soil")",
         "/anchors/0/cable: there is no cable \"lin\"; did you mean \"line\""},
        {R"("cable": "line", "soil")", R"("cable": "fall", "soil")", "/anchors/0/cable: no end"},
        {R"("fluke_area": 6, )", "", "/anchors/1/clay/fluke_area: 0"},
        {R"("name": "dives")", R"("name": "hold")", "/anchors/1/name: the name \"hold\" exists"},
        {R"("drag_length": 15)", R"("drag_lenght": 15)", "did you mean \"drag_length\""},
        {R"("cable": "line", "pin")", R"("cable": "fal", "pin")",
         "/stability/0/cable: there is no cable \"fal\"; did you mean \"fall\""},
        {R"("gm": 1.5,)", "", "/stability/0/gm: the body has no hull with a mesh"},
        {R"("heave_speed": 2,)", "", "/winches/0"},
        {R"("overload_retained": 1e4)", R"("overload_retained": 1e6)", "above overload_limit"}};
    for (const Slip& slip : slips) {
        const std::string said = anchor_scene_refusal(anchor_text(good, slip.from, slip.to));
        EXPECT_NE(said.find(slip.said), std::string::npos) << slip.to << ": " << said;
    }
}

TEST(SceneAnchors, ShippedAnchorHoldsThenDrags) {
    Scene scene = load_file("scenes/drag_anchor.json");
    World& w = scene.world;
    for (int i = 0; i < 60 * 30; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.system_signal("hold.drag"), 2.0);
    w.set_input(w.find_input("tug"), 1.2e6);
    for (int i = 0; i < 60 * 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_GT(w.system_signal("hold.drag"), 5.0);
    // 1.4 MN of pull at an angle of about 8 degrees.
    EXPECT_NEAR(w.system_signal("hold.capacity"), 1.4e6, 0.15e6);
}

}  // namespace
}  // namespace hawser::scene::test
