// SPDX-License-Identifier: Apache-2.0
// Outputs of a scene: what they name, in instances and copies, and that a world has them.
#include "good_scenes.h"
#include "support.h"

#include <gtest/gtest.h>

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
    // 13 of each copy, the statistic once, the instance's one a copy.
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
    // The world does not move along with a copy: its point does.
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
    // The ship begins at 90 degrees and turns by 0.01 rad/s, for one step of 1/60 s.
    EXPECT_NEAR(world.output(heading), 1.5707963267948966 + 0.01 / 60.0, 1e-5);
    const InteractionId pivot = world.find_interaction("port/pivot");
    EXPECT_EQ(world.output(world.find_output("slew")), world.coordinate(pivot));
    EXPECT_EQ(world.output_def(world.find_output("bearing_load")).unit, "N");
    EXPECT_EQ(world.output(world.find_output("fall")),
              -world.force(world.find_interaction("fall"))[0]);
}

}  // namespace
}  // namespace hawser::scene::test
