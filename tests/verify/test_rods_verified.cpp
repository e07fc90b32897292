// SPDX-License-Identifier: Apache-2.0
// A scene with rods in waves by separate code.
#include <hawser/scene.h>

#include "verify/certificate.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace hawser {
namespace {

constexpr const char* kRig = R"({
  "version": 1, "name": "rig",
  "settings": {"step": 0.0166666667},
  "bodies": [{"name": "rig", "mass": 400000, "box": [10, 10, 4], "position": [0, 0, -4]},
             {"name": "spar", "mass": 60000, "cylinder": {"radius": 1, "length": 30, "axis": "z"},
              "position": [40, 0, -4]}],
  "interactions": [{"kind": "ball", "name": "hinge", "bodies": ["rig", "spar"],
                    "at": [20, 0, -4]}],
  "sea": {"depth": 60, "current": [{"speed": 0.8}],
    "waves": [{"kind": "jonswap", "height": 4, "period": 8, "spreading": 4, "components": 16}],
    "rods": [
      {"body": "rig", "from": [-9, -9, -8], "to": [-9, -9, 12], "diameter": 3},
      {"body": "rig", "from": [9, -9, -8], "to": [9, -9, 12], "diameter": 3, "segments": 20},
      {"body": "rig", "from": [0, 9, -8], "to": [0, 9, 12], "diameter": 4, "ca_tangential": 0.4},
      {"body": "rig", "from": [-9, -9, -7], "to": [9, -9, 8], "diameter": 0.8,
       "displaced_area": 0, "cd_tangential": 0.05},
      {"body": "spar", "from": [0, 0, -15], "to": [0, 0, 15], "diameter": 2, "segments": 33}]}
})";

TEST(RodsVerified, AgreeWithSeparateCodeInWaves) {
    scene::Scene scene = scene::load_text(kRig, "rig");
    verify::Verifier verifier(scene.world);
    for (int i = 0; i < 300; ++i) {
        verifier.before_step(scene.world);
        ASSERT_EQ(scene.world.step(), Status::ok) << "step " << i;
        ASSERT_EQ(verifier.after_step(scene.world), "") << "step " << i;
    }
    std::printf("loads of the sea differ by %.2g, momentum by %.2g\n", verifier.result().sea,
                verifier.result().momentum);
    EXPECT_GT(verifier.result().sea, 0.0) << "some load was compared";
    EXPECT_LT(verifier.result().sea, 1e-9);
}

TEST(RodsVerified, AThousandthOfADiameterIsSeen) {
    scene::Scene scene = scene::load_text(kRig, "rig");
    std::string thicker = kRig;
    const std::string leg = "\"diameter\": 4,";
    thicker.replace(thicker.find(leg), leg.size(), "\"diameter\": 4.004,");
    const scene::Scene other = scene::load_text(thicker, "rig");
    // Equal bodies and positions; only the sea given to the verifier differs.
    verify::Verifier verifier(other.world);
    verifier.before_step(scene.world);
    ASSERT_EQ(scene.world.step(), Status::ok);
    EXPECT_NE(verifier.after_step(scene.world), "");
    EXPECT_GT(verifier.result().sea, 1e-9);
}

}  // namespace
}  // namespace hawser
