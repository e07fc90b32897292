// SPDX-License-Identifier: Apache-2.0
// Definitions of the sea by a user, and its signals.
#include <hawser/hawser.h>

#include "record/event_input.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace hawser::test {
namespace {

/// Example of include/hawser/sea.h and docs/theory/waves.md.
TEST(SeaDefinition, ExampleOfTheHeader) {
    World world;
    const BodyId from = world.add_body({.kind = BodyKind::fixed, .position = {0, 0, -5}});
    const BodyId to = world.add_body({.kind = BodyKind::fixed, .position = {100, 0, -5}});
    const WireId wire = world.wires().add({.name = "tow",
                                           .from = from,
                                           .to = to,
                                           .elements = 20,
                                           .length = 101.0,
                                           .EA = 5e7,
                                           .mass_per_length = 20.0});
    const auto example = [&world](WireId tow) {
        hawser::SeaDef sea{.depth = 150.0};
        sea.waves.push_back({.kind = hawser::WaveKind::jonswap, .height = 3.0, .period = 9.0});
        sea.current.push_back({.depth = 0.0, .speed = 0.8, .direction = 0.0});
        sea.lines.push_back(
            {.wire = tow, .sections = {{20, {.diameter = 0.076, .cd_normal = 1.8}}}});
        world.add(sea);
        world.set_system_signal("sea.waves", 0.5);  // half the height from now on
    };
    example(wire);
    for (int i = 0; i < 2; ++i) ASSERT_EQ(world.step(), Status::ok);
    EXPECT_EQ(world.system_signal("sea.waves"), 0.5);
    EXPECT_GE(sea_loads(world).size(), 19U);  // of its nodes
}

/// Signals beyond their range make events; the level stays above the bottom at the lowest tide.
TEST(SeaDefinition, SignalsBeyondTheirRangeAreEvents) {
    World w;
    w.add_body({.kind = BodyKind::lump, .position = {0, 0, -1}, .mass = 1.0});
    w.add(SeaDef{.depth = 50.0,
                 .level = {{.time = 0.0, .level = 0.5}, {.time = 600.0, .level = -2.0}}});
    w.set_system_signal("sea.wind", 12.0);
    EXPECT_EQ(w.events().extremes(EventKind::input_clamped).count, 0);
    w.set_system_signal("sea.waves", 1e6);
    EXPECT_EQ(w.system_signal("sea.waves"), 10.0);
    w.set_system_signal("sea.current", -30.0);
    EXPECT_EQ(w.system_signal("sea.current"), -10.0);
    w.set_system_signal("sea.level", -60.0);
    EXPECT_DOUBLE_EQ(w.system_signal("sea.level"), -0.99 * 48.0);
    const std::vector<Event> reported = w.events().take();
    ASSERT_EQ(reported.size(), 3U);
    const char* names[] = {"sea.waves", "sea.current", "sea.level"};
    const double asked[] = {1e6, -30.0, -60.0};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(reported[i].kind, EventKind::input_clamped);
        EXPECT_EQ(reported[i].value, asked[i]);
        EXPECT_FALSE(reported[i].input.valid());
        EXPECT_EQ(record::input_label(w, reported[i]), names[i]);
    }
}

}  // namespace
}  // namespace hawser::test
