// SPDX-License-Identifier: Apache-2.0
// Cables of several line types: properties of their nodes and elements, positions at rest, their
// winches, and rejections with their positions.
#include "support.h"

#include <hawser/catenary.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace hawser::scene::test {
namespace {

const std::string kMooring = R"({
  "version": 1, "name": "mooring", "settings": {"step": 0.01},
  "line_types": {
    "chain": {"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.137, "breaking_load": 4.9e6,
              "submerged_factor": 0.87, "drag": 100, "axial_damping": 2, "link": 0.304},
    "wire": {"mass_per_length": 23, "EA": 2.33e8, "EI": 4e3, "diameter": 0.076,
             "breaking_load": 3.7e6, "submerged_factor": 0.8, "drag": 20, "axial_damping": 2}},
  "cables": [{"name": "leg", "from": {"at": [0, 0, 0]}, "to": {"at": [200, 0, -40]},
              "shape": "hanging",
              "sections": [{"line_type": "chain", "length": 30.4, "elements": 5},
                           {"line_type": "wire", "length": 150, "elements": 15},
                           {"line_type": "chain", "length": 36.48, "elements": 6}]}]})";

std::string mooring_with(const std::string& from, const std::string& to) {
    std::string text = kMooring;
    text.replace(text.find(from), from.size(), to);
    return text;
}

std::string error_message(const std::string& text) {
    try {
        (void)load_text(text, "mooring.json");
    } catch (const SceneError& error) {
        return error.path + ": " + error.message;
    }
    return "";
}

TEST(Sections, HaveLumpsAndElementsOfTheirOwn) {
    Scene scene = load_text(kMooring, "mooring.json");
    World& w = scene.world;
    const Cable& leg = scene.cables.front();
    EXPECT_EQ(leg.line_type, "chain + wire + chain");
    ASSERT_EQ(leg.sections.size(), 3U);
    EXPECT_NEAR(leg.length, 30.4 + 150 + 36.48, 1e-12);
    ASSERT_EQ(leg.stretch.size(), 26U);
    const auto element = [&](std::size_t i) -> const InteractionDef& {
        return w.interaction_def(leg.stretch[i]);
    };
    EXPECT_EQ(element(4).get("EA"), 5.83e8);
    EXPECT_EQ(element(5).get("EA"), 2.33e8);
    EXPECT_EQ(element(20).get("EA"), 5.83e8);
    EXPECT_NEAR(element(4).get("length"), 6.08, 1e-12);
    EXPECT_NEAR(element(19).get("length"), 10.0, 1e-12);
    EXPECT_EQ(element(19).get("breaking_load"), 3.7e6);
    EXPECT_EQ(element(25).get("breaking_load"), 4.9e6);
    // The node between two line types has half of each.
    const auto lump = [&](std::size_t i) -> const BodyDef& { return w.body_def(leg.nodes[i]); };
    EXPECT_NEAR(lump(4).mass, 126.5 * 6.08, 1e-9);
    EXPECT_NEAR(lump(5).mass, 0.5 * (126.5 * 6.08 + 23 * 10), 1e-9);
    EXPECT_NEAR(lump(6).mass, 230.0, 1e-9);
    EXPECT_NEAR(lump(5).linear_damping.x(), 0.5 * (100 * 6.08 + 20 * 10), 1e-9);
    EXPECT_NEAR(lump(20).force.z(), 9.81 * 0.5 * (0.2 * 230 + 0.13 * 126.5 * 6.08), 0.01);
    // Chain and the nodes at its ends have no bending.
    int bends = 0;
    for (const InteractionId id : w.interactions())
        if (w.interaction_def(id).kind == InteractionKind::Bend) ++bends;
    EXPECT_EQ(bends, 14);
}

/// They start in the shape of catenary(), and stay at rest.
TEST(Sections, RestFromTheStart) {
    Scene scene = load_text(kMooring, "mooring.json");
    World& w = scene.world;
    const Cable& leg = scene.cables.front();
    CatenaryDef def{.to = {200, 0, -40}};
    def.sections = {{30.4, 126.5 * 0.87 * 9.80665, 5.83e8, 5},
                    {150, 23 * 0.8 * 9.80665, 2.33e8, 15},
                    {36.48, 126.5 * 0.87 * 9.80665, 5.83e8, 6}};
    const double g = w.settings().gravity.norm();
    for (CatenarySection& s : def.sections) s.weight *= g / 9.80665;
    const Catenary rest = catenary(def);
    for (std::size_t i = 1; i < 26; ++i)
        EXPECT_LT((w.pose(leg.nodes[i]).position - rest.nodes[i]).norm(), 1e-9) << i;
    const double most = rest.largest();
    for (int i = 0; i < 500; ++i) ASSERT_EQ(w.step(), Status::ok);
    for (std::size_t i = 0; i < 26; ++i)
        EXPECT_NEAR(-w.force(leg.stretch[i])[0], rest.tension[i], 2e-3 * most) << i;
}

TEST(Sections, WeakPlacesAndPathsGoByLength) {
    Scene scene = load_text(
        mooring_with("\"shape\": \"hanging\"",
                     "\"shape\": \"straight\", \"weak\": {\"at\": 100, \"breaking_load\": 1e6}"),
        "mooring.json");
    const Cable& leg = scene.cables.front();
    for (std::size_t i = 0; i < 26; ++i)
        EXPECT_EQ(scene.world.interaction_def(leg.stretch[i]).get("breaking_load") == 1e6, i == 11);
    // Node 5 at 30.4 m of 216.88 m.
    const Vec3 expected = 30.4 / 216.88 * Vec3(200, 0, -40);
    EXPECT_LT((scene.world.pose(leg.nodes[5]).position - expected).norm(), 1e-9);
}

/// A winch hauls the section at its end, and of the next section at most the part in its element.
TEST(Sections, AWinchStopsAtTheNextLineType) {
    Scene scene = load_text(R"({
      "version": 1, "name": "hoist", "settings": {"step": 0.01},
      "line_types": {
        "chain": {"mass_per_length": 60, "EA": 3e8, "diameter": 0.05},
        "wire": {"mass_per_length": 10, "EA": 1e8, "diameter": 0.05}},
      "bodies": [{"name": "load", "position": [0, 0, 0], "mass": 8000, "box": [1, 1, 1]}],
      "cables": [{"name": "fall", "from": {"at": [0, 0, 40]}, "to": {"body": "load"},
                  "shape": "hanging",
                  "sections": [{"line_type": "wire", "length": 20, "elements": 4},
                               {"line_type": "chain", "length": 19.98, "elements": 4}]}],
      "winches": [{"name": "hoist", "cable": "fall", "core_radius": 0.3, "width": 1, "stored": 50,
                   "inertia": 500, "mode": "speed", "speed": -1, "brake_static": 1e6}]})",
                            "hoist.json");
    World& w = scene.world;
    EXPECT_NEAR(w.system_signal("hoist.inertia"), 500.0 + 10 * 50 * 0.106, 15.0);
    for (int i = 0; i < 3000; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(w.system_signal("hoist.state"), 7.0);
    const auto elements = w.wires().elements(w.wires().find("fall"));
    ASSERT_EQ(elements.size(), 5U);
    EXPECT_EQ(w.interaction_def(elements[0]).get("EA"), 1e8);
    EXPECT_EQ(w.interaction_def(elements[1]).get("EA"), 3e8);
    EXPECT_NEAR(w.system_signal("hoist.wire_left"), 70.0, 1.0);
    // The hanging weight: load, chain, and the rest of the wire.
    EXPECT_NEAR(w.system_signal("hoist.pull"), (8000 + 60 * 19.98) * 9.81, 0.02 * 9e4);
}

/// Elements become longer within each line type. The node between two types stays, and each type
/// keeps its length to rounding.
TEST(Sections, HaveAResolutionOfTheirOwn) {
    Scene scene =
        load_text(mooring_with("\"shape\": \"hanging\"",
                               "\"shape\": \"hanging\", \"consistent_mass\": true, \"resolution\": "
                               "{\"min_length\": 2.5, \"max_length\": 40, \"patience\": 0.1, "
                               "\"sag_error\": 0.5, \"wave_period\": 0}"),
                  "mooring.json");
    World& w = scene.world;
    const WireId leg = w.wires().find("leg");
    const BodyId first = w.wires().nodes(leg)[5], second = w.wires().nodes(leg)[20];
    struct Line {
        double EA, mass;
        int elements;
    };
    const auto lines = [&] {
        std::vector<Line> out;
        for (const InteractionId id : w.wires().elements(leg)) {
            const InteractionDef& d = w.interaction_def(id);
            if (out.empty() || out.back().EA != d.get("EA")) out.push_back({d.get("EA"), 0.0, 0});
            out.back().mass += d.get("mass");
            ++out.back().elements;
        }
        return out;
    };
    const auto before = lines();
    ASSERT_EQ(before.size(), 3U);
    for (int i = 0; i < 2000; ++i) ASSERT_EQ(w.step(), Status::ok);
    const auto after = lines();
    ASSERT_EQ(after.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LE(after[k].elements, before[k].elements) << k;
        EXPECT_NEAR(after[k].mass, before[k].mass, 1e-9 * before[k].mass) << "an account";
    }
    // The heavier chain is bent too much at its ends for fewer elements.
    EXPECT_LT(after[1].elements, before[1].elements);
    EXPECT_NEAR(w.system_signal("leg/resolution.material"), 216.88, 1e-9);
    EXPECT_TRUE(w.alive(first) && w.alive(second));
    // An edit cannot remove it either: no element could replace both.
    try {
        (void)w.wires().remove_node(first, 3.2);
        FAIL() << "two line types became one";
    } catch (const DefError& error) {
        EXPECT_NE(std::string(error.what()).find("two line types meet"), std::string::npos)
            << error.what();
    }
}

TEST(Sections, AreRefusedByTheirPlace) {
    EXPECT_EQ(error_message(kMooring), "");
    struct Row {
        const char *from, *to, *path, *message;
    };
    for (const Row& row :
         {Row{"\"line_type\": \"wire\"", "\"line_type\": \"wier\"",
              "/cables/0/sections/1/line_type", "did you mean \"wire\""},
          Row{"\"length\": 150, ", "", "/cables/0/sections/1", "length"},
          Row{"\"shape\": \"hanging\"", "\"shape\": \"hanging\", \"length\": 200", "/cables/0",
              "not both"},
          Row{"\"shape\": \"hanging\"", "\"shape\": \"hanging\", \"line_type\": \"wire\"",
              "/cables/0", "not both"},
          Row{"\"shape\": \"hanging\"", "\"shape\": \"catenary\"", "/cables/0/shape", "hanging"},
          Row{"\"shape\": \"hanging\"", "\"as\": \"links\"", "/cables/0/sections", "line_type"},
          Row{"36.48", "36", "/cables/0/sections/2", "links each"},
          Row{"\"cables\"", "\"timeline\": [{\"at\": 1, \"cut\": \"leg\", \"s\": 300}], \"cables\"",
              "/timeline/0/s", "216.88"},
          Row{"\"length\": 150", "\"length\": -1", "/cables/0/sections/1/length", ""}}) {
        const std::string r = error_message(mooring_with(row.from, row.to));
        EXPECT_TRUE(r.starts_with(std::string(row.path) + ": ") &&
                    r.find(row.message) != std::string::npos)
            << row.to << " -> " << r;
    }
}

}  // namespace
}  // namespace hawser::scene::test
