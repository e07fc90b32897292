// SPDX-License-Identifier: Apache-2.0
/// Thousands of events of lines do not displace other events in the log.
#include "context/events.h"

#include "support/recipe.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

Event event(double time, EventKind kind, double value) {
    return {.time = time, .kind = kind, .interaction = InteractionId{1}, .value = value};
}

TEST(EventLog, SlackAndTautPushNothingElseOut) {
    context::EventLog log;
    log.push(event(0, EventKind::line_break, 5e5));
    log.push(event(0, EventKind::saturation, 100));
    for (int i = 1; i <= 200'000; ++i)
        log.push(event(i, i % 2 == 0 ? EventKind::slack : EventKind::taut, i % 2 == 0 ? 0 : i));
    log.push(event(3e5, EventKind::line_break, 3e5));
    const auto events = log.take();
    EXPECT_EQ(events.size(), 2 * context::EventLog::kFrequentCapacity + 3);
    EXPECT_EQ(events.front().kind, EventKind::line_break);
    EXPECT_EQ(events[1].kind, EventKind::saturation);
    EXPECT_EQ(events.back().time, 3e5);
    // In order of time, for all kinds.
    for (std::size_t i = 1; i < events.size(); ++i) EXPECT_LE(events[i - 1].time, events[i].time);
    EXPECT_TRUE(log.take().empty());
}

TEST(EventLog, FirstAndWorstStay) {
    context::EventLog log;
    EXPECT_EQ(log.extremes(EventKind::taut).count, 0);
    for (int i = 1; i <= 100'000; ++i)
        log.push(event(i, EventKind::taut, i == 5'000 ? 1e6 : i == 6'000 ? 1e6 : 1.0));
    (void)log.take();
    log.push(event(1e6, EventKind::range, -0.3));
    log.push(event(2e6, EventKind::range, 0.2));
    const EventExtremes& taut = log.extremes(EventKind::taut);
    EXPECT_EQ(taut.count, 100'000);
    EXPECT_EQ(taut.first.time, 1.0);
    EXPECT_EQ(taut.worst.time, 5'000.0) << "the first of equals";
    EXPECT_EQ(log.extremes(EventKind::range).worst.value, -0.3) << "by magnitude";
}

TEST(EventLog, AWorldTellsThemAndTheInput) {
    Recipe r;
    const BodyId g = r.ground(), b = r.lump({0, 0, -1}, 10.0);
    InteractionDef d = between(InteractionKind::Stretch, {g, b});
    r.add(d.set("EA", 1e5).set("length", 1.0).set("breaking_load", 200.0));
    World w = r.make();
    const InputId push = w.add_input({.name = "push", .body = b, .component = 2, .min = -300});
    w.set_input(push, -1e6);
    w.set_input(push, -5e6);
    for (int i = 0; i < 60; ++i) ASSERT_EQ(w.step(), Status::ok);
    const EventExtremes clamped = w.events().extremes(EventKind::input_clamped);
    EXPECT_EQ(clamped.count, 2);
    EXPECT_EQ(clamped.first.value, -1e6);
    EXPECT_EQ(clamped.worst.value, -5e6);
    EXPECT_EQ(clamped.worst.input, push);
    EXPECT_EQ(w.events().extremes(EventKind::line_break).count, 1);
    EXPECT_GT(w.events().extremes(EventKind::line_break).worst.value, 200.0);
    EXPECT_EQ(w.events().extremes(EventKind::slack).count, 0);
}

}  // namespace
}  // namespace hawser::test
