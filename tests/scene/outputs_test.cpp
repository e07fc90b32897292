// SPDX-License-Identifier: Apache-2.0
// Outputs of a scene: their objects, in instances and copies, and their presence in a world.
#include "good_scenes.h"
#include "support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace hawser::scene::test {
namespace {

TEST(SceneOutputs, name_what_the_scene_has) {
    const Description d = flat(kSite);
    const auto find = [&](const std::string& name) -> const OutputDef& {
        for (const OutputDef& def : d.outputs) {
            if (def.name == name) {
                return def;
            }
        }
        ADD_FAILURE() << "no output " << name;
        return d.outputs.front();
    };
    // 13 of each copy, the statistic once, one of the instance in each copy.
    EXPECT_EQ(d.outputs.size(), 2 * 14 + 1U);
    EXPECT_EQ(find("heading").body, d.find_body("ship"));
    EXPECT_EQ(find("heading").unit, "rad");
    EXPECT_EQ(find("heading").group, "ship");
    EXPECT_EQ(find("heading").nominal, 3.0);
    EXPECT_TRUE(find("surge").local);
    EXPECT_EQ(find("surge").point, Vec3(40, 0, 0));
    EXPECT_EQ(find("slew").interaction, d.find_interaction("port/pivot"));
    EXPECT_EQ(find("port/load").line, d.find_cable("port/hoist")->stretch);
    EXPECT_EQ(find("paid_out").interaction, d.find_cable("tow")->stretch.front());
    EXPECT_EQ(find("gap").point_b, Vec3(-40, 0, 0));
    EXPECT_EQ(find("1:heading").body, d.find_body("1:ship"));
    EXPECT_EQ(find("1:port/load").line, d.find_cable("1:port/hoist")->stretch);
    EXPECT_EQ(find("1:gap").body_b, d.find_body("1:ship"));
    // The world does not move with a copy; the point on it does.
    EXPECT_EQ(find("way").point, Vec3(0, 10, 0));
    EXPECT_EQ(find("1:way").point, Vec3(0, 1510, 0));
    EXPECT_EQ(find("1:way").body, find("way").body);
    const InputDef& thrust = d.inputs[1];
    EXPECT_TRUE(thrust.local);
    EXPECT_EQ(thrust.group, "ship");
    EXPECT_EQ(thrust.spring, 0.0);
    EXPECT_FALSE(d.inputs[0].spring.has_value());
}

TEST(SceneOutputs, are_those_of_the_world) {
    Scene scene = load_text(kSite, "test.json");
    World& world = scene.world;
    ASSERT_EQ(world.step(), Status::ok);
    const OutputId heading = world.find_output("heading");
    // The ship starts at 90 degrees and rotates at 0.01 rad/s for one step of 1/60 s.
    EXPECT_NEAR(world.output(heading), 1.5707963267948966 + 0.01 / 60.0, 1e-5);
    const InteractionId pivot = world.find_interaction("port/pivot");
    EXPECT_EQ(world.output(world.find_output("slew")), world.coordinate(pivot));
    EXPECT_EQ(world.output_def(world.find_output("bearing_load")).unit, "N");
    EXPECT_EQ(world.output(world.find_output("fall")),
              -world.force(world.find_interaction("fall"))[0]);
}

/// A winch pays out 10 m of a wire with elements of 2 m and hauls in 16: new nodes are inserted and
/// removed, then those of the start.
const std::string kPayOut = R"({
  "version": 1, "name": "pay_out", "settings": {"step": 0.02},
  "line_types": {"wire": {"mass_per_length": 4.2, "EA": 4.5e7, "diameter": 0.032,
                          "axial_damping": 2, "drag": 20}},
  "bodies": [{"name": "load", "position": [0, 0, 0], "mass": 800, "box": [1, 1, 1]}],
  "cables": [{"name": "fall", "line_type": "wire", "from": {"at": [0, 0, 12]},
              "to": {"body": "load"}, "elements": 6, "consistent_mass": true}],
  "winches": [{"name": "hoist", "cable": "fall", "core_radius": 0.3, "width": 1, "stored": 68,
               "inertia": 500, "mode": "speed", "speed": 1}],
  "outputs": [{"name": "paid", "kind": "drum", "cable": "fall", "component": "paid_out"},
              {"name": "first", "kind": "tension", "cable": "fall", "component": "first"},
              {"name": "last", "kind": "tension", "cable": "fall", "component": "last"},
              {"name": "largest", "kind": "tension", "cable": "fall", "component": "largest"}]})";

TEST(SceneOutputs, go_on_where_nodes_of_a_wire_come_and_go) {
    Scene scene = load_text(kPayOut, "test.json");
    World& w = scene.world;
    const WireId fall = w.wires().find("fall");
    const auto value = [&](const char* name) { return w.output(w.find_output(name)); };
    const auto tension = [&](InteractionId id) { return -w.force(id)[0]; };
    const double start = w.wires().length(fall);
    EXPECT_EQ(value("paid"), 0.0);
    std::size_t most = 0, least = 100;
    for (int i = 0; i < 1300; ++i) {
        if (i == 500) w.set_system_signal("hoist.speed", -1.0);
        ASSERT_EQ(w.step(), Status::ok);
        const auto elements = w.wires().elements(fall);
        double largest = -1e300;
        for (const InteractionId id : elements) largest = std::max(largest, tension(id));
        ASSERT_EQ(value("first"), tension(elements.front())) << i;
        ASSERT_EQ(value("last"), tension(elements.back())) << i;
        ASSERT_EQ(value("largest"), largest) << i;
        // The part beyond the drum has become longer by the length paid out. Inserting or removing
        // a node keeps tensions, of some kN over EA: lengths change by rounding of their strain.
        ASSERT_NEAR(value("paid"), w.wires().length(fall) - start, 1e-6) << i;
        most = std::max(most, elements.size());
        least = std::min(least, elements.size());
    }
    EXPECT_GT(most, 9U);   // 22 m in elements of 2 m
    EXPECT_LT(least, 5U);  // 6 m
    // Within the lag of the motor that turns the drum.
    EXPECT_NEAR(value("paid"), -6.0, 0.5);
    // A copy that returns to its initial state reports the same value.
    const double paid = value("paid");
    const std::vector<std::byte> saved = w.state().save();
    World other = w.twin();
    ASSERT_EQ(other.step(), Status::ok);
    EXPECT_NE(other.output(other.find_output("paid")), paid);
    other.state().restore(saved);
    EXPECT_EQ(other.output(other.find_output("paid")), paid);
}

}  // namespace
}  // namespace hawser::scene::test
