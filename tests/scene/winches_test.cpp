// SPDX-License-Identifier: Apache-2.0
// Winches of a scene: their bodies and systems, instances and copies, and rejections with their
// positions.
#include "support.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace hawser::scene::test {
namespace {

const std::string kLift = R"({
  "version": 1, "name": "lift", "settings": {"step": 0.01},
  "line_types": {"wire": {"mass_per_length": 4.2, "EA": 4.5e7, "diameter": 0.032}},
  "bodies": [{"name": "load", "position": [0, 0, 0], "mass": 8000, "box": [1, 1, 1]}],
  "cables": [{"name": "fall", "line_type": "wire", "from": {"at": [0, 0, 12]},
              "to": {"body": "load"}, "elements": 3}],
  "winches": [{"name": "hoist", "cable": "fall", "core_radius": 0.3, "width": 1, "stored": 200,
               "inertia": 500, "mode": "tension", "tension": 5e4}],
  "outputs": [{"name": "paid", "kind": "drum", "cable": "fall", "component": "paid_out"},
              {"name": "pull", "kind": "tension", "cable": "fall", "component": "first"}],
  "repeat": {"offset": [0, 20, 0]}})";

std::string lift_with(const std::string& from, const std::string& to) {
    std::string text = kLift;
    text.replace(text.find(from), from.size(), to);
    return text;
}

/// Return a scene with a resolution, which divides elements longer than 4 m.
std::string fine_with(const std::string& keys) {
    std::string text = lift_with("\"elements\": 3",
                                 "\"elements\": 3, \"consistent_mass\": true, \"resolution\": "
                                 "{\"min_length\": 1, \"max_length\": 4}");
    text.replace(text.find("\"stored\": 200"), 13, "\"stored\": 200, " + keys);
    return text;
}

/// Return the message: "path: message".
std::string refused_at(const std::string& text) {
    try {
        (void)load_text(text, "lift.json");
    } catch (const SceneError& error) {
        return error.path + ": " + error.message;
    }
    return "";
}

TEST(SceneWinches, WindUpTheirCables) {
    Scene scene = load_text(kLift, "lift.json");
    World& w = scene.world;
    ASSERT_EQ(w.step(), Status::ok);
    const InteractionId element = scene.cables.front().stretch.front();
    EXPECT_EQ(w.wires().elements(w.wires().find("fall")).front(), element);
    EXPECT_EQ(w.interaction_def(element).kind, InteractionKind::WinchStretch);
    EXPECT_EQ(w.interaction_def(element).get("EA"), 4.5e7);
    EXPECT_EQ(w.system_signal("hoist.mode"), 1.0);
    // 31 turns per layer of r = 0.316 + 0.032 (k − 1): 61.5, 67.8 and 74 m.
    EXPECT_EQ(w.system_signal("hoist.layer"), 3.0);
    EXPECT_NEAR(w.interaction_def(element).get("radius"), 0.38, 1e-12);
    EXPECT_NEAR(w.system_signal("hoist.inertia"), 500.0 + 4.2 * (200.0 * 0.126), 20.0);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(w.step(), Status::ok);
    // The weight exceeds the tension: wire runs out.
    EXPECT_GT(w.output(w.find_output("paid")), 0.1);
    EXPECT_LT(w.system_signal("hoist.wire_left"), 199.9);
}

TEST(SceneWinches, AreInEveryCopyWithSignalsOfTheirOwn) {
    Options options;
    options.scale = 3;
    Scene scene = load_text(kLift, "lift.json", options);
    EXPECT_EQ(scene.world.system_count(), 3);
    scene.world.set_system_signal("2:hoist.tension", 9e4);
    EXPECT_EQ(scene.world.system_signal("hoist.tension"), 5e4);
    for (int i = 0; i < 200; ++i) ASSERT_EQ(scene.world.step(), Status::ok);
    EXPECT_LT(scene.world.pose(scene.world.find_body("load")).position.z(), 0.0);
    EXPECT_GT(scene.world.pose(scene.world.find_body("2:load")).position.z(), 0.0);
    EXPECT_EQ(scene.world.pose(scene.world.find_body("load")).position.z(),
              scene.world.pose(scene.world.find_body("1:load")).position.z());
}

TEST(SceneWinches, TakeTheParametersOfTemplates) {
    const std::string text = R"({
      "version": 1, "name": "lifts", "settings": {"step": 0.01},
      "line_types": {"wire": {"mass_per_length": 4.2, "EA": 4.5e7, "diameter": 0.032}},
      "templates": {"lift": {
        "parameters": {"radius": 0.3, "pull": 0, "mode": "brake"},
        "bodies": [{"name": "load", "position": [0, 0, 0], "mass": 8000, "box": [1, 1, 1]}],
        "cables": [{"name": "fall", "line_type": "wire", "from": {"at": [0, 0, 12]},
                    "to": {"body": "load"}, "elements": 3}],
        "winches": [{"name": "hoist", "cable": "fall", "core_radius": "${radius}", "width": 1,
                     "stored": 200, "inertia": 500, "mode": "${mode}", "tension": "${pull}"}]}},
      "instances": [
        {"template": "lift", "name": "a", "parameters": {"pull": 5e4, "mode": "tension"}},
        {"template": "lift", "name": "b", "position": [0, 20, 0],
         "parameters": {"pull": 9e4, "mode": "render", "radius": 0.5}}]})";
    Scene scene = load_text(text, "lifts.json");
    World& w = scene.world;
    EXPECT_EQ(w.system_signal("a/hoist.tension"), 5e4);
    EXPECT_EQ(w.system_signal("b/hoist.tension"), 9e4);
    EXPECT_EQ(w.system_signal("a/hoist.mode"), static_cast<double>(WinchMode::tension));
    EXPECT_EQ(w.system_signal("b/hoist.mode"), static_cast<double>(WinchMode::render));
    ASSERT_EQ(w.step(), Status::ok);
    // 31 turns per layer: 61.5 m, 67.8 m and 74 m about 0.3 m, but 100.5 m and 106.7 m about 0.5 m.
    EXPECT_NEAR(w.system_signal("a/hoist.radius"), 0.316 + 2 * 0.032, 1e-12);
    EXPECT_NEAR(w.system_signal("b/hoist.radius"), 0.516 + 0.032, 1e-12);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_LT(w.system_signal("a/hoist.wire_left"), 199.9);
    EXPECT_GT(w.system_signal("b/hoist.wire_left"), 200.0);
}

TEST(SceneWinches, GoOnBitForBitFromASnapshotOnAnyNumberOfThreads) {
    Scene scene = load_text(kLift, "lift.json");
    for (int i = 0; i < 50; ++i) ASSERT_EQ(scene.world.step(), Status::ok);
    const std::vector<std::byte> middle = scene.world.state().save();
    for (int i = 0; i < 100; ++i) ASSERT_EQ(scene.world.step(), Status::ok);
    for (const int threads : {1, 2, 4, 8}) {
        Options options;
        options.threads = threads;
        Scene other = load_text(kLift, "lift.json", options);
        other.world.state().restore(middle);
        for (int i = 0; i < 100; ++i) ASSERT_EQ(other.world.step(), Status::ok);
        EXPECT_EQ(other.world.state().hash(), scene.world.state().hash()) << threads << " threads";
    }
}

TEST(SceneWinches, AreRefusedByTheirPlace) {
    EXPECT_EQ(refused_at(kLift), "");
    const auto says = [](const std::string& found, const char* path, const char* message) {
        return found.starts_with(std::string(path) + ": ") &&
               found.find(message) != std::string::npos;
    };
    std::string r =
        refused_at(lift_with("\"cable\": \"fall\", \"core", "\"cable\": \"fell\", \"core"));
    EXPECT_TRUE(says(r, "/winches/0/cable", "did you mean \"fall\"")) << r;
    r = refused_at(lift_with("\"mode\": \"tension\"", "\"mode\": \"tention\""));
    EXPECT_TRUE(says(r, "/winches/0/mode", "tension")) << r;
    r = refused_at(lift_with("\"core_radius\": 0.3", "\"core_radius\": 0.07"));
    EXPECT_TRUE(says(r, "/winches/0", "larger drum")) << r;
    r = refused_at(lift_with("\"stored\": 200", "\"stored\": 200, \"flange_radius\": 0.35"));
    EXPECT_TRUE(says(r, "/winches/0", "the drum holds")) << r;
    r = refused_at(lift_with("\"core_radius\"", "\"core_radios\""));
    EXPECT_TRUE(says(r, "/winches/0/core_radios", "did you mean \"core_radius\"")) << r;
    r = refused_at(lift_with("\"stored\": 200,", ""));
    EXPECT_TRUE(says(r, "/winches/0", "stored")) << r;
    r = refused_at(lift_with(", \"diameter\": 0.032", ""));
    EXPECT_TRUE(says(r, "/winches/0", "wire_diameter")) << r;
    const std::string second =
        R"("winches": [{"name": "NAME", "cable": "fall", "core_radius": 0.3, "width": 1,
            "stored": 100, "inertia": 500}, )";
    std::string two = lift_with("\"winches\": [", second);
    EXPECT_TRUE(says(r = refused_at(two), "/winches/1/cable", "an end can have one winch only"))
        << r;
    two.replace(two.find("NAME"), 4, "hoist");
    EXPECT_TRUE(says(r = refused_at(two), "/winches/1/name", "exists already")) << r;
}

const std::string kWindlass = R"({
  "version": 1, "name": "windlass", "settings": {"step": 0.005},
  "line_types": {"chain": {"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.076, "link": 0.304},
                 "wire": {"mass_per_length": 23, "EA": 2.33e8, "EI": 5e3, "diameter": 0.076}},
  "bodies": [{"name": "anchor", "position": [0, 0, -0.06713], "mass": 8000, "box": [1, 1, 1]}],
  "cables": [{"name": "cable", "line_type": "chain", "from": {"at": [0, 0, 20]},
              "to": {"body": "anchor"}, "elements": 6, "length": 20.064, "shape": "hanging"}],
  "winches": [{"name": "windlass", "cable": "cable", "stored": 100, "inertia": 2e4,
               "gypsy": {"pockets": 5, "jump_load": 6e4, "locker_fall": 5},
               "brake_static": 1e6}],
  "repeat": {"offset": [0, 20, 0]}})";

std::string windlass_with(const std::string& from, const std::string& to) {
    std::string text = kWindlass;
    text.replace(text.find(from), from.size(), to);
    return text;
}

TEST(SceneWinches, AGypsyJumpsUnderItsAnchor) {
    Options options;
    options.scale = 2;
    Scene scene = load_text(kWindlass, "windlass.json", options);
    World& w = scene.world;
    // No body carries the half element at the anchor.
    const double weight = (8000 + (20.064 - 0.5 * 3.344) * 126.5) * 9.81, tail = 5 * 126.5 * 9.81;
    EXPECT_GT(weight - tail, 6e4);
    for (int i = 0; i < 400; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_NEAR(w.system_signal("windlass.radius"), 5 * 0.304 / 3.14159265358979, 1e-12);
    EXPECT_GE(w.system_signal("1:windlass.tail"),
              tail);  // plus the momentum of chain from the heap
    EXPECT_GT(w.events().extremes(EventKind::chain_jump).count, 0);
    EXPECT_EQ(w.system_signal("windlass.jumped"), w.system_signal("1:windlass.jumped"));
    // Below its load it hangs still.
    Scene held = load_text(windlass_with("6e4", "1.1e5"), "windlass.json");
    for (int i = 0; i < 400; ++i) ASSERT_EQ(held.world.step(), Status::ok);
    EXPECT_EQ(held.world.events().extremes(EventKind::chain_jump).count, 0);
    EXPECT_NEAR(held.world.system_signal("windlass.grip"), weight - tail, 0.005 * weight);
}

TEST(SceneWinches, GypsiesAndChainsAreRefusedByTheirPlace) {
    EXPECT_EQ(refused_at(kWindlass), "");
    struct Row {
        const char *from, *to, *path, *message;
    };
    for (const Row& row :
         {Row{"\"pockets\": 5", "\"pockets\": 2", "/winches/0/gypsy/pockets", "3"},
          Row{"\"pockets\": 5", "\"pocket\": 5", "/winches/0/gypsy/pocket",
              "did you mean \"pockets\""},
          Row{"\"pockets\": 5, ", "", "/winches/0/gypsy", "pockets"},
          Row{"\"gypsy\": {\"pockets\": 5, \"jump_load\": 6e4, \"locker_fall\": 5},", "",
              "/winches/0", "or \"gypsy\""},
          Row{"\"stored\": 100", "\"stored\": 100, \"core_radius\": 0.5", "/winches/0", "not both"},
          Row{"\"line_type\": \"chain\"", "\"line_type\": \"wire\"", "/winches/0/cable", "EI"},
          Row{"\"locker_fall\": 5", "\"locker_fall\": 5, \"locker\": 50", "/winches/0",
              "its locker holds 50 m"},
          Row{"\"locker_fall\": 5", "\"pitch\": 0.1", "/winches/0", "4 is usual"},
          Row{"\"link\": 0.304", "\"link\": 0.304, \"EI\": 10", "/cables/0/line_type",
              "leave out \"EI\""},
          Row{"\"stored\": 100", "\"stored\": 100, \"element\": 3", "/winches/0/element",
              "whole links"},
          Row{"20.064", "20", "/cables/0", "\"length\" 20.064 (66 links) and \"elements\" 6"},
          Row{"\"elements\": 6", "\"elements\": 7", "/cables/0", "\"elements\" 6"}}) {
        const std::string r = refused_at(windlass_with(row.from, row.to));
        EXPECT_TRUE(r.starts_with(std::string(row.path) + ": ") &&
                    r.find(row.message) != std::string::npos)
            << row.to << " -> " << r;
    }
}

/// Faults that the timeline can detect before the run, and rejections of a winch.
TEST(SceneWinches, LimitsAndTimelinesAreRefusedByTheirPlace) {
    const auto with_timeline = [&](const std::string& entry) {
        return windlass_with("\"repeat\": {\"offset\": [0, 20, 0]}",
                             "\"timeline\": [" + entry + "]");
    };
    struct Row {
        std::string text;
        const char *path, *message;
    };
    for (const Row& row :
         {Row{with_timeline(R"({"at": 1, "cut": "cabel", "s": 3})"), "/timeline/0/cut",
              "did you mean \"cable\""},
          Row{with_timeline(R"({"at": 1, "set": {"windlas.mode": "brake"}})"),
              "/timeline/0/set/windlas.mode", "did you mean \"windlass.mode\""},
          Row{with_timeline(R"({"at": 1, "set": {"windlass.mode": "break"}})"),
              "/timeline/0/set/windlass.mode", "did you mean \"brake\""},
          // A drum that is too small, and a wire longer than its capacity.
          Row{lift_with("\"core_radius\": 0.3", "\"core_radius\": 0.07"), "/winches/0",
              "give a larger drum"},
          Row{lift_with("\"stored\": 200", "\"stored\": 900, \"flange_radius\": 0.6"), "/winches/0",
              "the drum holds"},
          // Inconsistent limits: a band brake that slips above its holding force.
          Row{lift_with("\"stored\": 200",
                        "\"stored\": 200, \"brake_static\": 10, \"brake_dynamic\": 20"),
              "/winches/0", "brake_dynamic"},
          Row{lift_with("\"stored\": 200", "\"stored\": 200, \"dead_wraps\": 200"), "/winches/0",
              "dead_wraps"},
          Row{fine_with("\"element\": 1e-9"), "/winches/0", "shorter than its wire is thick"},
          Row{fine_with("\"element\": 5"), "/winches/0/element", "\"max_length\""},
          Row{windlass_with("\"locker_fall\": 5", "\"jump_friction\": 7e4"), "/winches/0",
              "jump_friction"}}) {
        const std::string r = refused_at(row.text);
        EXPECT_TRUE(r.starts_with(std::string(row.path) + ": ") &&
                    r.find(row.message) != std::string::npos)
            << row.message << " -> " << r;
    }
}

/// A mode that does not exist would be clamped to an emergency release.
TEST(SceneWinches, TimelinesKeepToTheRangesOfSignals) {
    const auto set = [](const char* what) {
        return refused_at(
            lift_with("\"repeat\": {\"offset\": [0, 20, 0]}",
                      std::string("\"timeline\": [{\"at\": 1, \"set\": {") + what + "}}]"));
    };
    EXPECT_EQ(set("\"hoist.mode\": 17"),
              "/timeline/0/set/hoist.mode: 17 is not within the input's range, 0 to 5");
    EXPECT_EQ(set("\"hoist.brake\": -0.5"),
              "/timeline/0/set/hoist.brake: -0.5 is not within the input's range, 0 to 1");
    EXPECT_EQ(set("\"hoist.mode\": 5, \"hoist.brake\": 1"), "");
}

/// 12 m hang and 200 m are on the drum: both bound the part that is cut off.
TEST(SceneWinches, CutsAreBoundedByWhatIsStored) {
    const auto cuts = [](const char* operations) {
        return refused_at(lift_with("\"repeat\": {\"offset\": [0, 20, 0]}",
                                    std::string("\"timeline\": [") + operations + "]"));
    };
    EXPECT_EQ(cuts(R"({"at": 1, "cut": "fall", "s": 100})"), "");
    EXPECT_TRUE(cuts(R"({"at": 1, "cut": "fall", "s": 5000})")
                    .starts_with("/timeline/0/s: the wire \"fall\" is 212 m long then, with all"))
        << cuts(R"({"at": 1, "cut": "fall", "s": 5000})");
    // At most 112 m hang below a cut at 100 m; the part above it may still be paid out.
    EXPECT_TRUE(cuts(R"({"at": 1, "cut": "fall", "s": 100}, {"at": 2, "cut": "fall/2", "s": 113})")
                    .starts_with("/timeline/1/s: the wire \"fall/2\" is 112 m long then"));
    EXPECT_EQ(cuts(R"({"at": 1, "cut": "fall", "s": 10}, {"at": 2, "cut": "fall", "s": 50})"), "");
}

TEST(SceneWinches, MistakesAreAllListed) {
    std::vector<SceneError> mistakes;
    std::string text = lift_with("\"stored\": 200", "\"stored\": -1");
    text.replace(text.find("\"mass\": 8000"), 12, "\"mass\": -8");
    EXPECT_FALSE(load_text(text, "lift.json", {}, mistakes).has_value());
    EXPECT_EQ(mistakes.size(), 2U);
}

}  // namespace
}  // namespace hawser::scene::test
