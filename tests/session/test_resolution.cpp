// SPDX-License-Identifier: Apache-2.0
/// Wires with changing nodes in a session. Recordings reproduce them without the systems that
/// changed them; a budget makes them coarser first; inputs of a scene set signals.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/repeat.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace hawser::test::resolution {
namespace {

namespace fs = std::filesystem;

/// A wire between a winch and a drifting barge.
const std::string kTow = R"({
  "version": 1, "name": "tow", "settings": {"step": 0.0166666666},
  "line_types": {"wire": {"mass_per_length": 23, "EA": 2.33e8, "diameter": 0.076, "drag": 20}},
  "bodies": [{"name": "barge", "position": [300, 0, 0], "mass": 2e6, "box": [20, 8, 3],
              "gravity": false, "force": [3e5, 0, 0], "linear_damping": [1e5, 1e5, 1e7],
              "angular_damping": [1e9, 1e9, 1e9]}],
  "cables": [{"name": "line", "line_type": "wire", "from": {"at": [0, 0, 3]},
              "to": {"body": "barge", "point": [-20, 0, 3]}, "length": 282, "elements": 56,
              "shape": "hanging", "consistent_mass": true,
              "resolution": {"min_length": 2.5, "max_length": 20, "patience": 0.5}}],
  "winches": [{"name": "winch", "cable": "line", "core_radius": 0.6, "width": 2, "stored": 500,
               "inertia": 4e4, "mode": "speed"}],
  "inputs": [{"name": "haul", "signal": "winch.speed", "factor": -0.5, "min": -1, "max": 2}]
})";

struct Place {
    fs::path path = fs::temp_directory_path() / ("hawser_resolution_" + std::to_string(::getpid()));
    Place() { fs::create_directories(path); }
    ~Place() { fs::remove_all(path); }
};

TEST(SessionResolution, IsRepeatedFromARecording) {
    const Place place;
    const std::string file = (place.path / "run.hwr").string();
    Session session({.scene_text = kTow, .record = file, .every = 20});
    for (int k = 0; k < 900; ++k) {
        if (k == 100) session.set_input("haul", -1.0);
        if (k == 500) session.set_input("haul", 2.0);
        ASSERT_EQ(session.step(), Status::ok);
    }
    EXPECT_GT(session.world().system_signal("line/resolution.inserted") +
                  session.world().system_signal("line/resolution.removed"),
              8.0);
    session.finish();
    const auto recording = record::Recording::open(file);
    EXPECT_EQ(recording.damage, "");
    const Repeated again = expect_repeats(recording, 1);
    const World& world = again.scene.world;
    EXPECT_EQ(world.wires().nodes(world.wires().find("line")).size(),
              session.world().wires().nodes(session.world().wires().find("line")).size());
}

/// A budget of work counts the flops of a step; the wire makes nearly all of them.
TEST(SessionResolution, BudgetMakesWiresCoarserFirst) {
    const auto flops = [](const World& w) {
        return w.stats().factor_work * static_cast<double>(w.stats().factor_flops);
    };
    const Place place;
    const std::string file = (place.path / "run.hwr").string();
    Session free({.scene_text = kTow});
    for (int k = 0; k < 200; ++k) ASSERT_EQ(free.step(), Status::ok);
    scene::Options options;
    options.budget_work = 0.6 * flops(free.world());
    Session session({.scene_text = kTow, .options = options, .record = file, .every = 20});
    int first = -1, highest = 0;
    for (int k = 0; k < 900; ++k) {
        ASSERT_EQ(session.step(), Status::ok);
        const StepStats& s = session.world().stats();
        if (s.degradation.any() && first < 0) {
            first = k;
            EXPECT_EQ(s.degradation, (Degradation{.wires = 1})) << "wires come first";
            EXPECT_EQ(s.degraded_by, DegradedBy::prediction);
        }
        highest = std::max(highest, s.degradation.wires);
    }
    EXPECT_GT(first, 0);
    EXPECT_LT(first, 60);
    EXPECT_GE(highest, 2);
    EXPECT_LT(flops(session.world()), options.budget_work);
    session.finish();
    const auto recording = record::Recording::open(file);
    ASSERT_EQ(recording.damage, "");
    ASSERT_FALSE(recording.cuts.empty());
    EXPECT_EQ(recording.cuts.front().step, first);
    EXPECT_EQ(recording.cuts.front().left_out, (Degradation{.wires = 1}));
    // With its systems, a world gives the same result from the remaining data.
    scene::Scene scene = scene::load_text(kTow, "tow");
    for (int k = 0; k < 900; ++k) {
        for (const record::RecordedCut& cut : recording.cuts)
            if (cut.step == k) scene.world.solver().degrade_next_step(cut.left_out);
        ASSERT_EQ(scene.world.step(), Status::ok);
    }
    EXPECT_EQ(scene.world.state().hash(), session.world().state().hash());
}

TEST(SessionResolution, InputsOfScenesSetSignals) {
    const Place place;
    std::ofstream(place.path / "haul.csv") << "time,haul\n0,1\n0.5,2\n";
    Session session({.scene_text = kTow, .control = (place.path / "haul.csv").string()});
    ASSERT_EQ(session.step(), Status::ok);
    EXPECT_EQ(session.world().system_signal("winch.speed"), -0.5);
    for (int k = 0; k < 60; ++k) ASSERT_EQ(session.step(), Status::ok);
    EXPECT_EQ(session.world().system_signal("winch.speed"), -1.0);
    session.set_input("haul", 5.0);
    EXPECT_EQ(session.world().system_signal("winch.speed"), -1.0) << "clamped to 2, times -0.5";
    session.set_input("haul", -1.0);
    EXPECT_EQ(session.world().system_signal("winch.speed"), 0.5);
    std::string text = kTow;
    text.replace(text.find("winch.speed"), 11, "winch.sped");
    try {
        (void)scene::load_text(text, "tow");
        FAIL() << "taken";
    } catch (const scene::SceneError& error) {
        EXPECT_EQ(error.path, "/inputs/0/signal");
        EXPECT_NE(error.message.find("winch.speed"), std::string::npos) << error.message;
    }
}

}  // namespace
}  // namespace hawser::test::resolution
