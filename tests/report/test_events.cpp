// SPDX-License-Identifier: Apache-2.0
/// Events in a report and a summary: in words, the first and the worst of each kind.
#include "report/summary.h"

#include "record/small_scene.h"

#include <nlohmann/json.hpp>

namespace hawser::test {
namespace {

report::Summary run_with_events(SmallScene& scene) {
    report::SummaryCollector collector(scene.info, scene.world);
    const InputId push = scene.world.find_input("box.push");
    for (int i = 0; i < 120; ++i) {
        // Out of range repeatedly, further each time until the 40th step.
        scene.world.set_input(push, i < 40 ? 100.0 + i : 60.0);
        EXPECT_EQ(scene.world.step(), Status::ok);
        collector.after_step(scene.world, scene.world.events().take());
    }
    return collector.result(scene.world);
}

TEST(ReportedEvents, FirstAndWorstInWords) {
    SmallScene scene;
    const report::Summary summary = run_with_events(scene);
    const std::string text = report::event_lines(summary);
    EXPECT_NE(text.find("inputs were limited to their range 120 times: first at 0 s, the input "
                        "\"box.push\", 100"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("worst at 0.65 s, the input \"box.push\", 139"), std::string::npos) << text;
}

TEST(ReportedEvents, SummaryHasTheSame) {
    SmallScene scene;
    const auto json = nlohmann::json::parse(report::to_json(run_with_events(scene)));
    const auto& clamped = json["event_extremes"]["input_clamped"];
    EXPECT_EQ(clamped["count"], 120);
    EXPECT_EQ(clamped["first"]["value"], 100.0);
    EXPECT_EQ(clamped["worst"]["value"], 139.0);
    EXPECT_EQ(clamped["worst"]["where"], "the input \"box.push\"");
    EXPECT_FALSE(json["event_extremes"].contains("line_break"));
    EXPECT_EQ(json["events"].size(), report::kListedEvents);
}

/// Inputs of systems are not inputs of the world, but have names.
TEST(ReportedEvents, SignalsByTheirNames) {
    SmallScene scene;
    scene.world.add(SeaDef{.depth = 20.0});
    report::SummaryCollector collector(scene.info, scene.world);
    scene.world.set_system_signal("sea.waves", 1e6);
    ASSERT_EQ(scene.world.step(), Status::ok);
    collector.after_step(scene.world, scene.world.events().take());
    const report::Summary summary = collector.result(scene.world);
    EXPECT_NE(report::event_lines(summary).find("the input \"sea.waves\", 1e+06"),
              std::string::npos)
        << report::event_lines(summary);
    ASSERT_EQ(summary.events.size(), 1U);
    EXPECT_EQ(summary.events[0].where, "sea.waves");
}

TEST(ReportedEvents, LinesInWordsAndListsOfTheirOwn) {
    SmallScene scene;
    report::SummaryCollector collector(scene.info, scene.world);
    ASSERT_EQ(scene.world.step(), Status::ok);
    std::vector<Event> many(500, Event{.time = 1,
                                       .kind = EventKind::slack,
                                       .interaction = scene.info.cables[0].elements[0]});
    many.push_back({.time = 2,
                    .kind = EventKind::line_break,
                    .interaction = scene.info.cables[0].elements[1],
                    .value = 2e4});
    collector.after_step(scene.world, many);
    report::Summary summary = collector.result(scene.world);
    ASSERT_EQ(summary.events.size(), report::kListedEvents + 1);
    EXPECT_EQ(summary.events.back().kind, "line_break");
    EXPECT_NE(report::to_text(summary, report::Detail::solver).find("events       none"),
              std::string::npos)
        << "the world itself had none";
    EXPECT_EQ(record::interaction_in_words(scene.world, scene.info.cables[0].elements[1]),
              "the stretch \"wire/s1\" between \"wire/1\" and \"box & <friends>\"");
}

/// In report and summary, operations of the timeline come before their effects, for any number of
/// other events.
TEST(ReportedEvents, WhatTheTimelineDidIsListedWhole) {
    SmallScene scene;
    report::SummaryCollector collector(scene.info, scene.world);
    const std::vector<Event> many(report::kListedEvents + 1,
                                  Event{.time = 0.5, .kind = EventKind::range});
    ASSERT_EQ(scene.world.step(), Status::ok);
    collector.after_step(scene.world, many);
    collector.add_operation(0.25, "the winch hauls: set hoist.speed = -1");
    collector.add_operation(0.25, "cut wire at 2 m");
    collector.add_operation(0.75, "release hook");
    const report::Summary summary = collector.result(scene.world);
    const auto list = nlohmann::json::parse(report::to_json(summary)).at("events");
    ASSERT_EQ(list.size(), report::kListedEvents + 3);
    EXPECT_EQ(list[0]["kind"], "timeline");
    EXPECT_EQ(list[0]["time"], 0.25);
    EXPECT_EQ(list[0]["where"], "the winch hauls: set hoist.speed = -1");
    EXPECT_EQ(list[1]["where"], "cut wire at 2 m");
    EXPECT_EQ(list[2]["kind"], "range");
    EXPECT_EQ(list.back()["where"], "release hook");
    EXPECT_NE(report::to_text(summary, report::Detail::solver)
                  .find("timeline     0.25 s: the winch hauls: set"),
              std::string::npos);
}

}  // namespace
}  // namespace hawser::test
