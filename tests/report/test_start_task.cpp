// SPDX-License-Identifier: Apache-2.0
/// Warnings about the task of an exercise: phases, goals and stations.
#include <hawser/exercise.h>
#include <hawser/hawser.h>

#include "report/start/parts.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

using report::start::FindingKind;
using report::start::Findings;

/// Return an exercise of 100 s with two goals: the second one follows the first.
exercise::Exercise two_goals(double first_hold, double second_hold, double by) {
    exercise::Exercise e;
    e.duration = 100.0;
    exercise::Goal first, second;
    first.name = "first";
    first.when.conditions.push_back({"depth", 1.0});
    first.when.hold = first_hold;
    second = first;
    second.name = "second";
    second.after = "first";
    second.when.hold = second_hold;
    second.by = by;
    e.goals = {first, second};
    return e;
}

Findings findings_of(const exercise::Exercise& e) {
    Findings out;
    report::start::check_task(e, out);
    return out;
}

TEST(StartTask, PhaseWithoutEndConditionIsWarnedWithPath) {
    exercise::Exercise e = two_goals(1.0, 1.0, 50.0);
    e.phases = {{"haul", "", "first"}, {"wait", "", ""}};
    const Findings found = findings_of(e);
    ASSERT_EQ(found.list.size(), 1U);
    EXPECT_EQ(found.list[0].kind, FindingKind::phase);
    EXPECT_FALSE(found.list[0].error);
    EXPECT_NE(found.list[0].text.find("/phases/1: "), std::string::npos) << found.list[0].text;
    EXPECT_NE(found.list[0].text.find("\"wait\""), std::string::npos) << found.list[0].text;
}

TEST(StartTask, GoalThatNoControlReachesInTime) {
    // 20 s of the first goal and 30 s of the second one end at 50 s.
    EXPECT_TRUE(findings_of(two_goals(20.0, 30.0, 50.0)).list.empty());
    const Findings late = findings_of(two_goals(20.0, 30.0, 49.0));
    ASSERT_EQ(late.list.size(), 1U);
    EXPECT_EQ(late.list[0].kind, FindingKind::goal);
    EXPECT_NEAR(late.list[0].value, 1.0, 1e-12) << "missing time [s]";
    EXPECT_NE(late.list[0].text.find("/goals/1/by: "), std::string::npos) << late.list[0].text;
    // The duration ends before the hold time.
    const Findings over = findings_of(two_goals(101.0, 0.0, 50.0));
    ASSERT_EQ(over.list.size(), 2U);
    EXPECT_NE(over.list[0].text.find("/goals/0/hold: "), std::string::npos) << over.list[0].text;
}

TEST(StartTask, ControlsWithoutARange) {
    const scene::Scene scene = scene::load_text(
        R"({"version": 1, "name": "box",
            "bodies": [{"name": "hull", "mass": 1e6, "box": [20, 5, 2], "gravity": false}],
            "inputs": [{"name": "push", "body": "hull", "component": "force_x"},
                       {"name": "side", "body": "hull", "component": "force_y", "min": -1e5,
                        "max": 1e5}]})",
        "box.json");
    exercise::Exercise e = two_goals(1.0, 1.0, 50.0);
    e.stations = {{.name = "bridge", .inputs = {"side", "push"}}};
    Findings found;
    report::start::check_controls(e, scene, found);
    ASSERT_EQ(found.list.size(), 1U);
    EXPECT_EQ(found.list[0].kind, FindingKind::range);
    EXPECT_FALSE(found.list[0].error);
    EXPECT_NE(found.list[0].text.find("/stations/0/inputs/1: the control \"push\" has no range"),
              std::string::npos)
        << found.list[0].text;
}

TEST(StartTask, StationWithoutInputs) {
    exercise::Exercise e = two_goals(1.0, 1.0, 50.0);
    e.stations = {{.name = "bridge", .inputs = {"rudder"}}, {.name = "winch"}};
    const Findings found = findings_of(e);
    ASSERT_EQ(found.list.size(), 1U);
    EXPECT_EQ(found.list[0].kind, FindingKind::station);
    EXPECT_NE(found.list[0].text.find("/stations/1/inputs: "), std::string::npos)
        << found.list[0].text;
}

}  // namespace
}  // namespace hawser::test
