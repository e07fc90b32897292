// SPDX-License-Identifier: Apache-2.0
// A minute of the frozen scene anchor_lines under its own loads.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "scenes/anchor_lines_probe.h"

namespace hawser {
namespace {

void expect_physical_minute(scene::Scene& scene, test::AnchorLinesProbe& probe) {
    const int steps = static_cast<int>(std::lround(60.0 / scene.world.settings().step));
    for (int i = 0; i < steps; ++i) {
        ASSERT_TRUE(probe.step()) << "step " << i;
    }
    EXPECT_EQ(scene.world.stats().islands, 1);
    EXPECT_LE(probe.violation_max, 1e-3);
    EXPECT_LE(probe.stretch_error_max, 1e-4);
    EXPECT_GT(probe.tension_min, 0.0);
    EXPECT_LT(probe.load_max, 1.0);
    EXPECT_LE(probe.momentum_residual_max, 1e-10);
    EXPECT_LE(probe.drift_max, 1.0);
    EXPECT_LE(probe.turn_max, 2.0);
    std::printf(
        "    violation %.2e m, stretch error %.2e, tension %.1f kN to %.1f %% of the "
        "breaking load, momentum residual %.1e, drift %.3g m %.3g deg\n",
        probe.violation_max, probe.stretch_error_max, probe.tension_min / 1e3,
        100.0 * probe.load_max, probe.momentum_residual_max, probe.drift_max, probe.turn_max);
}

TEST(AnchorLinesMinute, StaysPhysicalAndEveryInteractionCarriesForce_full) {
    scene::Scene scene = scene::load_file("scenes/anchor_lines.json");
    test::AnchorLinesProbe probe(scene);
    expect_physical_minute(scene, probe);
    // The least loaded interactions are bends of the tow wire, 2-3 N m by design. Unloaded ones
    // have rounding errors below 1e-3.
    for (const std::string& name : probe.idle(0.1)) {
        ADD_FAILURE() << name << " carries no force";
    }
    std::printf("    least loaded interaction: %.3g N or N m\n", probe.min_force());
}

TEST(AnchorLinesMinute, ARowOfSitesStaysPhysical_full) {
    scene::Options options;
    options.scale = 3;
    scene::Scene scene = scene::load_file("scenes/anchor_lines.json", options);
    test::AnchorLinesProbe probe(scene);
    ASSERT_EQ(probe.vessel_count(), 9U);
    expect_physical_minute(scene, probe);
}

// The exercise of scenes/anchor_lines.control.csv: winch, crane and thrust are used.
TEST(AnchorLinesMinute, AnExerciseStaysPhysical_full) {
    scene::Scene scene = scene::load_file("scenes/anchor_lines.json");
    World& world = scene.world;
    test::AnchorLinesProbe probe(scene);
    const auto set = [&world](const char* name, double value) {
        const InputId id = world.find_input(name);
        ASSERT_TRUE(id.valid()) << name;
        world.set_input(id, value);
    };
    set("ahts1/tow_speed", -0.2);  // Hauls in 0.24 m/s.
    set("ahts1/crane/slew_speed", 0.05);
    set("ahts1/crane/hoist_speed", 0.5);
    set("ahts2/thrust_y", 2e5);
    for (int i = 0; i < 600; ++i) {
        ASSERT_TRUE(probe.step()) << "step " << i;
    }
    set("ahts1/tow_speed", 0.0);
    set("ahts1/crane/hoist_speed", 0.0);
    for (int i = 0; i < 1800; ++i) {
        ASSERT_TRUE(probe.step()) << "step " << i;
    }
    EXPECT_LE(probe.violation_max, 1e-3);
    EXPECT_GT(probe.tension_min, 0.0);
    EXPECT_LT(probe.load_max, 0.5);
    EXPECT_LE(probe.momentum_residual_max, 1e-10);
    EXPECT_GT(probe.drift_max, 1.0);  // It moved: ahts2 is pushed aside by about 20 m.
    EXPECT_LT(probe.drift_max, 50.0);
    for (const Event& event : world.events().take()) {
        EXPECT_NE(event.kind, EventKind::line_break);
    }
}

}  // namespace
}  // namespace hawser
