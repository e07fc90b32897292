// SPDX-License-Identifier: Apache-2.0
/// Commands in pictures over time: they exclude actions of systems on their own parts.
#include "record/commands.h"
#include "draw/commands_note.h"
#include "draw/plots.h"
#include "draw/svg.h"
#include "draw/winch_scene.h"
#include "record/series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace hawser::test {
namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

TEST(Commands, AreTheTimelinesAndNotThoseOfAWinchToItsMotor) {
    const record::Recording r = WinchScene::record(WinchScene::kCut + 0.2);
    // The winch set its motor many times.
    ASSERT_EQ(r.inner_inputs.size(), r.input_names.size());
    EXPECT_GT(std::count(r.inner_inputs.begin(), r.inner_inputs.end(), true), 0);
    EXPECT_GT(r.inputs.size(), 3U);
    const auto commands = draw::list_commands_by_time(r);
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_NEAR(commands[0].time, 0.5, 1e-9);
    EXPECT_EQ(commands[0].actions, "hoist.mode speed");
    EXPECT_EQ(commands[0].text, "hoist.speed 1");
    EXPECT_NEAR(commands[1].time, WinchScene::kCut, 1e-9);
    EXPECT_EQ(commands[1].actions, "cut fall at 5 m");
    EXPECT_EQ(commands[1].text, "");
    const auto drawing = draw::plot_tensions(r, record::collect_series(r));
    ASSERT_TRUE(drawing);
    const std::string svg = draw::to_svg(*drawing);
    EXPECT_NE(svg.find("A  0.5 s: hoist.mode speed; inputs set, hoist.speed 1"), std::string::npos);
    EXPECT_NE(svg.find("B  10 s: cut fall at 5 m"), std::string::npos);
    EXPECT_EQ(svg.find("hoist/"), std::string::npos);
}

TEST(Commands, WhatATakeDoesAgainIsListedOnce) {
    const record::Recording r = WinchScene::record(WinchScene::kCut + 0.2, true);
    ASSERT_EQ(r.takes.size(), 1U);
    const auto commands = draw::list_commands_by_time(r);
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_EQ(commands[1].actions, "cut fall at 5 m");
}

/// Controls move often; actions on wires are marked nevertheless.
TEST(Commands, WhatWasDoneIsMarkedBesideManyLevers) {
    record::Recording r = WinchScene::record(0.2);
    const std::vector<std::byte> lever = bytes_of("hoist.speed 0.1"),
                                 cut = bytes_of("cut tow at 1 m");
    r.notes.clear();
    for (int i = 0; i < 40; ++i) r.notes.push_back({i, record::kSetNote, lever});
    r.notes.push_back({200, record::kDoneNote, cut});
    r.notes.push_back({210, "exercise", cut});
    const auto commands = draw::list_commands_by_time(r);
    ASSERT_EQ(commands.size(), 7U);
    EXPECT_EQ(commands[6].actions, "cut tow at 1 m; 34 later changes are not marked");
    EXPECT_NEAR(commands[6].time, 2.0, 1e-9);
}

}  // namespace
}  // namespace hawser::test
