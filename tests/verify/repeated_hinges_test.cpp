// SPDX-License-Identifier: Apache-2.0
/// Redundant joints in a rotating mechanism.
#include <hawser/scene.h>

#include "verify/certificate.h"

#include <gtest/gtest.h>

namespace hawser {
namespace {

/// A platform that slews, with a boom on two hinges of one axis that falls from horizontal.
const char* const kSlew = R"({
  "version": 1, "name": "slew", "settings": {"step": 0.016666666666666666},
  "bodies": [
    {"name": "platform", "mass": 500, "box": [1, 1, 0.3], "angular_velocity": [0, 0, 0.6]},
    {"name": "boom", "position": [3, 0, 0.3], "mass": 120, "box": [3, 0.3, 0.2],
     "velocity": [0, 1.8, 0], "angular_velocity": [0, 0, 0.6]}],
  "interactions": [
    {"name": "slew", "kind": "hinge", "bodies": ["world", "platform"], "at": [0, 0, 0],
     "axis": [0, 0, 1]},
    {"name": "left", "kind": "hinge", "bodies": ["platform", "boom"], "at": [0, -0.4, 0.3],
     "axis": [0, 1, 0]},
    {"name": "right", "kind": "hinge", "bodies": ["platform", "boom"], "at": [0, 0.4, 0.3],
     "axis": [0, 1, 0]}]
})";

TEST(RepeatedHinges, AreVerified) {
    scene::Scene scene = scene::load_text(kSlew, "slew");
    verify::Verifier verifier(scene.world);
    for (int i = 0; i < 240; ++i) {
        verifier.before_step(scene.world);
        ASSERT_EQ(scene.world.step(), Status::ok);
        ASSERT_EQ(verifier.after_step(scene.world), "") << "step " << i;
    }
    EXPECT_EQ(verifier.result().covered_bodies, 2);
}

TEST(RepeatedHinges, AreFoundToBeWrong) {
    // A millionth of a radian per second of the boom is above rounding.
    scene::Scene scene = scene::load_text(kSlew, "slew");
    verify::Verifier verifier(scene.world);
    const BodyId boom = scene.world.find_body("boom");
    for (int i = 0; i < 40; ++i) {
        verifier.before_step(scene.world);
        ASSERT_EQ(scene.world.step(), Status::ok);
        if (i == 39) {
            Twist twist = scene.world.velocity(boom);
            twist.angular.y() += 1e-6;
            scene.world.set_velocity(boom, twist);
        }
        EXPECT_EQ(verifier.after_step(scene.world).empty(), i != 39) << "step " << i;
    }
}

}  // namespace
}  // namespace hawser
