// SPDX-License-Identifier: Apache-2.0
/// Scores by hand: durations of conditions, order, time limits, points.
#include "exercise/scorer.h"

#include <gtest/gtest.h>

namespace hawser::test {
namespace {

using namespace exercise;

Trigger above(const char* output, double limit, double hold = 0.0) {
    return {.conditions = {{output, limit}}, .hold = hold, .of = ""};
}

/// Feed values of one output, at intervals of 0.1 s.
struct Fed {
    Exercise e;
    std::unique_ptr<Scorer> scorer;
    int step = 0;
    Fed() { e.duration = 100.0; }
    void feed(double value, int times = 1, double other = 0.0) {
        if (!scorer) scorer = std::make_unique<Scorer>(e, 0.1);
        std::vector<double> values(list_channels(e).size(), other);
        if (!values.empty()) values[0] = value;
        for (int i = 0; i < times; ++i) scorer->after_step(0.1 * ++step, values);
    }
    [[nodiscard]] const Result& r() const { return scorer->result(); }
};

TEST(Scorer, AGoalIsReachedOnceItHasHeldWithoutABreak) {
    Fed f;
    f.e.goals = {{.name = "g", .text = "", .when = above("x", 1.0, 0.5), .points = 7, .after = ""}};
    f.e.until_done = false;
    f.feed(1.0, 5);
    EXPECT_FALSE(f.r().goals[0].reached) << "0.4 s from the first moment";
    f.feed(0.9);
    f.feed(2.0, 5);
    EXPECT_FALSE(f.r().goals[0].reached) << "from anew";
    f.feed(2.0);
    EXPECT_TRUE(f.r().goals[0].reached);
    EXPECT_NEAR(f.r().goals[0].time, 1.2, 1e-12);
    f.feed(0.0, 3);
    EXPECT_EQ(f.r().points, 7.0) << "it stays";
    EXPECT_EQ(f.r().outcome, Outcome::running);
}

TEST(Scorer, GoalsHaveAnOrderAndATime) {
    Fed f;
    f.e.goals = {
        {.name = "a", .text = "", .when = above("x", 1.0), .points = 1, .after = ""},
        {.name = "b", .text = "", .when = above("x", 0.5), .points = 2, .after = "a"},
        {.name = "c", .text = "", .when = above("x", 5.0), .points = 4, .after = "", .by = 0.5}};
    f.feed(0.7, 2);
    EXPECT_FALSE(f.r().goals[1].reached) << "a has to come first";
    f.feed(1.0);
    EXPECT_TRUE(f.r().goals[0].reached);
    EXPECT_TRUE(f.r().goals[1].reached) << "in the same step, in the order of the list";
    f.feed(0.0, 3);
    EXPECT_EQ(f.r().outcome, Outcome::passed) << "what is left is too late";
    EXPECT_NEAR(f.r().time, 0.6, 1e-12);
    f.feed(9.0);
    EXPECT_EQ(f.r().points, 3.0);
    EXPECT_EQ(f.r().possible, 7.0);
}

TEST(Scorer, PenaltiesCostEachTimeAndWhileTheyLast) {
    Fed f;
    f.e.penalties = {{.name = "p",
                      .text = "",
                      .when = above("x", 1.0),
                      .points = 2,
                      .per_second = 10,
                      .most = 11},
                     {.name = "e", .text = "", .when = {.event = EventKind::slack}, .points = 3}};
    f.feed(1.0, 3);
    EXPECT_NEAR(f.r().points, -5.0, 1e-12) << "2 and 0.3 s";
    f.feed(0.0, 4);
    EXPECT_NEAR(f.r().points, -5.0, 1e-12);
    f.feed(1.0, 9);
    EXPECT_NEAR(f.r().points, -11.0, 1e-12) << "at most";
    EXPECT_EQ(f.r().penalties[0].times, 2);
    EXPECT_NEAR(f.r().penalties[0].seconds, 1.2, 1e-12);
    f.feed(0.0, 1, 2.0);  // two events in one step
    EXPECT_EQ(f.r().penalties[1].times, 2);
    EXPECT_NEAR(f.r().points, -17.0, 1e-12);
    f.feed(0.0, 1, 1.0);
    EXPECT_NEAR(f.r().points, -20.0, 1e-12) << "each of them, also one step after the other";
}

TEST(Scorer, AlarmsSeeWhatDisplaysShow) {
    Fed f;
    f.e.alarms = {{.name = "a", .text = "", .when = above("x", 1.0, 0.2)}};
    const Fault frozen{.name = "f", .text = "", .kind = FaultKind::output_frozen, .target = "x"};
    f.feed(0.0);
    f.scorer->fault(0.1, frozen, "instructor", true);
    EXPECT_EQ(f.scorer->frozen_value("x"), 0.0);
    f.feed(2.0, 9);
    EXPECT_EQ(f.r().alarms[0].times, 0);
    f.scorer->fault(1.0, frozen, "instructor", false);
    f.feed(2.0, 3);
    EXPECT_EQ(f.r().alarms[0].times, 1);
    EXPECT_TRUE(f.r().alarms[0].active);
    f.feed(0.0);
    EXPECT_FALSE(f.r().alarms[0].active);
    const std::vector<EntryKind> kinds{EntryKind::fault, EntryKind::fault_end, EntryKind::alarm,
                                       EntryKind::alarm_end};
    ASSERT_EQ(f.r().entries.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(f.r().entries[i].kind, kinds[i]);
}

TEST(Scorer, EndsWithTooFewPointsOrByAFailure) {
    Fed late;
    late.e.duration = 0.3;
    late.e.pass = 1.0;
    late.feed(0.0, 3);
    EXPECT_EQ(late.r().outcome, Outcome::failed) << "0 points of 1";
    EXPECT_EQ(late.r().end, "the time is over");
    Fed lost;
    lost.e.ends = {{.name = "e", .text = "lost", .when = above("x", 3.0), .failed = true}};
    lost.feed(4.0, 2);
    EXPECT_EQ(lost.r().outcome, Outcome::failed);
    EXPECT_EQ(lost.r().end, "lost");
    EXPECT_NEAR(lost.r().time, 0.1, 1e-12);
    Fed nan;
    nan.e.goals = {{.name = "g", .text = "", .when = above("x", -1e9), .points = 7, .after = ""}};
    nan.feed(NAN, 3);
    EXPECT_FALSE(nan.r().goals[0].reached) << "what is not there holds nothing";
}

}  // namespace
}  // namespace hawser::test
