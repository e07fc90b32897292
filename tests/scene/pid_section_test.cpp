// SPDX-License-Identifier: Apache-2.0
// The section "pids" of a scene: the same controller as in C++, also in templates and copies, and
// rejections with their position.
#include "support.h"

#include <hawser/systems/pid.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace hawser::scene::test {
namespace {

// A load on a line from a drum, turned by a motor: the controller holds 300 N.
const std::string kParts = R"("bodies": [
    {"name": "deck", "kind": "fixed"},
    {"name": "load", "kind": "lump", "mass": 20, "position": [0, 0, -3]},
    {"name": "drum", "kind": "scalar", "mass": 5, "gravity": false}],
  "interactions": [
    {"name": "line", "kind": "winch_stretch", "bodies": ["deck", "load", "drum"], "EA": 1e5,
     "length": 3, "radius": 0.3},
    {"name": "motor", "kind": "scalar_motor", "bodies": ["drum"]}],
  "inputs": [{"name": "speed", "interaction": "motor", "param": "speed"}])";
const std::string kPid = R"("pids": [{"name": "hold", "measured": "line", "input": "speed",
    "target": 300, "gain": -2e-3, "reset": 0.5, "low": -2, "high": 2}])";

std::string scene_with(const std::string& pid, const std::string& more = {}) {
    return R"({"version": 2, "name": "held", "settings": {"step": 0.01}, )" + kParts +
           (pid.empty() ? "" : ", " + pid) + more + "}";
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

std::string refused(const std::string& pid) {
    try {
        (void)load_text(scene_with(pid), "held.json");
    } catch (const SceneError& error) {
        return error.path + ": " + error.message;
    }
    return "read";
}

TEST(PidSection, IsTheControllerOfCpp) {
    Scene read = load_text(scene_with(kPid), "held.json");
    Scene own = load_text(scene_with(""), "held.json");
    own.world.add_system(
        std::make_unique<Pid>(PidDef{.name = "hold",
                                     .measured = own.world.find_interaction("line"),
                                     .driven = own.world.find_input("speed"),
                                     .target = 300.0,
                                     .gain = -2e-3,
                                     .reset = 0.5,
                                     .low = -2.0,
                                     .high = 2.0}));
    for (int i = 0; i < 300; ++i) {
        ASSERT_EQ(read.world.step(), Status::ok);
        ASSERT_EQ(own.world.step(), Status::ok);
    }
    EXPECT_EQ(read.world.state().hash(), own.world.state().hash());
    EXPECT_EQ(read.world.system_signal("hold.measured"), own.world.system_signal("hold.measured"));
    // Without the controller the drum stops, and the line carries the weight of 196 N.
    EXPECT_GT(read.world.system_signal("hold.output"), -2.0);
    EXPECT_NE(read.world.system_signal("hold.output"), 0.0);
}

TEST(PidSection, WorksInTemplatesAndCopies) {
    const std::string instances =
        R"({"version": 2, "name": "two", "settings": {"step": 0.01}, "templates": {"winch": {)" +
        kParts + ", " + with(kPid, "300", "\"${pull}\"") +
        R"(, "parameters": {"pull": 100}}}, "instances": [{"template": "winch", "name": "port",
            "parameters": {"pull": 250}},
           {"template": "winch", "name": "starboard", "position": [5, 0, 0]}]})";
    Scene two = load_text(instances, "two.json");
    EXPECT_EQ(two.world.system_signal("port/hold.target"), 250.0);
    EXPECT_EQ(two.world.system_signal("starboard/hold.target"), 100.0);

    Options options;
    options.scale = 2;
    Scene copies =
        load_text(scene_with(kPid, R"(, "repeat": {"offset": [10, 0, 0]})"), "held.json", options);
    for (int i = 0; i < 50; ++i) ASSERT_EQ(copies.world.step(), Status::ok);
    EXPECT_NE(copies.world.system_signal("hold.measured"), 0.0);
    EXPECT_NEAR(copies.world.system_signal("1:hold.measured"),
                copies.world.system_signal("hold.measured"), 1e-6);  // 10 m apart: rounding
}

TEST(PidSection, RefusesWithPlaceAndNearestName) {
    EXPECT_EQ(refused(with(kPid, "\"line\"", "\"lime\"")),
              "/pids/0/measured: there is no interaction \"lime\"; did you mean \"line\"?");
    EXPECT_EQ(refused(with(kPid, "\"speed\"", "\"sped\"")),
              "/pids/0/input: there is no input \"sped\"; did you mean \"speed\"?");
    EXPECT_EQ(refused(with(kPid, "\"low\": -2", "\"low\": 3")),
              "/pids/0/low: must be less than \"high\"");
    EXPECT_NE(refused(with(kPid, "\"gain\"", "\"gane\"")).find("gane"), std::string::npos);
    EXPECT_NE(refused(with(kPid, "\"target\"", "\"row\": 4, \"target\"")).find("/pids/0/row"),
              std::string::npos);
    const std::string twice = with(kPid, "]",
                                   ", {\"name\": \"hold\", \"measured\": \"line\", "
                                   "\"input\": \"speed\"}]");
    EXPECT_EQ(refused(twice), "/pids/1/name: the name \"hold\" exists already");
}

}  // namespace
}  // namespace hawser::scene::test
