// SPDX-License-Identifier: Apache-2.0
/// Deck gear that a timeline controls: verified while it runs, and replayed from its recording
/// without the systems that took and released wires.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/repeat.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace hawser::test {
namespace {

/// A wire from a mast over a deck to a load that is hauled sideways. Below it are a jaw, a chain
/// stopper without a chain, and a pin that is lowered and raised again.
const std::string kDeck = R"({
  "version": 1, "name": "deck", "settings": {"step": 0.016666666666666666},
  "line_types": {"wire": {"mass_per_length": 23, "EA": 2.33e8, "drag": 40, "diameter": 0.076}},
  "bodies": [
    {"name": "deck", "kind": "fixed", "position": [0, 0, 0]},
    {"name": "mast", "kind": "fixed", "position": [0, 0, 3]},
    {"name": "load", "mass": 20000, "sphere": 1, "position": [40, 0, 3], "gravity": false,
     "linear_damping": [2e4, 2e4, 2e4], "angular_damping": [1e5, 1e5, 1e5]}],
  "cables": [{"name": "line", "line_type": "wire", "from": {"body": "mast"}, "to": {"body": "load"},
    "length": 40.2, "elements": 16, "shape": "hanging", "consistent_mass": true,
    "contact": {"radius": 0.038}}],
  "stoppers": [
    {"name": "jaw", "on": "deck", "point": [10, 0, 2], "outboard": [1, 0, 0], "reach": 2,
     "rated_load": 7e6},
    {"name": "far", "on": "deck", "point": [10, 30, 2], "outboard": [1, 0, 0], "reach": 0.5,
     "rated_load": 7e6, "pitch": 0.6}],
  "pins": [{"name": "pin", "on": "deck", "from": [25, 1, 0], "to": [25, 1, 5], "radius": 0.15,
            "friction": 0.2, "speed": 2}],
  "inputs": [{"name": "aside", "body": "load", "component": "force_y", "min": -1e6, "max": 1e6},
             {"name": "out", "body": "load", "component": "force_x", "min": -1e6, "max": 1e6}],
  "timeline": [
    {"at": 0, "set": {"out": 1e5}},
    {"at": 1, "set": {"jaw.close": 1, "far.close": 1}},
    {"at": 2, "set": {"aside": 4e4}},
    {"at": 9, "set": {"pin.up": 0}},
    {"at": 13, "set": {"jaw.close": 0, "far.close": 0}},
    {"at": 14, "set": {"pin.up": 1}}]
})";

TEST(SessionDeck, IsVerifiedAndRepeatedFromItsRecording) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                       ("hawser_deck_" + std::to_string(::getpid()) + ".hwr");
    {
        Session session({.scene_text = kDeck, .record = file.string(), .verify = true});
        const World& world = session.world();
        bool held = false, on_pin = false, sank = false;
        for (int k = 0; k < 1080; ++k) {
            ASSERT_EQ(session.step(), Status::ok) << world.time() << ": " << session.objection();
            held = held || world.system_signal("jaw.held") == 1.0;
            on_pin = on_pin || world.system_signal("pin/post.held") == 1.0;
            sank = sank || world.system_signal("pin.height") < 0.01;
        }
        EXPECT_TRUE(held);
        EXPECT_TRUE(on_pin);
        EXPECT_TRUE(sank);
        EXPECT_EQ(world.events().extremes(EventKind::join).count, 1);
        EXPECT_EQ(world.events().extremes(EventKind::detach).count, 1);
        EXPECT_EQ(world.events().extremes(EventKind::missed).count, 1);
        EXPECT_EQ(world.system_signal("jaw.held"), 0.0);
        EXPECT_NEAR(world.system_signal("pin.height"), 1.0, 1e-3);
        session.finish();
    }
    const record::Recording recording = record::Recording::open(file.string());
    EXPECT_EQ(recording.damage, "");
    for (const int threads : {1, 2}) EXPECT_EQ(expect_repeats(recording, threads).steps, 1080);
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace hawser::test
