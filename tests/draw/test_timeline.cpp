// SPDX-License-Identifier: Apache-2.0
/// Timelines: figures of a hand-made trace, the picture, the file for trace viewers.
#include "draw/svg.h"
#include "draw/timeline.h"
#include "draw/xml_check.h"
#include "record/small_scene.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace hawser::test {
namespace {

using namespace draw;

constexpr auto kAssemble = static_cast<std::int8_t>(Stage::assemble);
constexpr auto kFactor = static_cast<std::int8_t>(Stage::factor);
// Rounding of sums of a few numbers of about 1.
constexpr double kRound = 1e-12;

TraceSpan span(SpanKind kind, double begin, double end, std::int8_t stage, int thread = 0,
               int loop = -1, int task = -1) {
    TraceSpan s;
    s.kind = kind;
    s.begin = begin;
    s.end = end;
    s.stage = stage;
    s.thread = thread;
    s.loop = loop;
    s.task = task;
    s.step = 7;
    return s;
}

/// Make two threads: 1 s of assembly, a loop of two tasks of 3 s and 2 s, 1 s of other code.
TraceView by_hand() {
    TraceView v;
    v.threads = 2;
    v.steps = 1;
    v.spans = {span(SpanKind::step, 10.0, 16.0, -1),
               span(SpanKind::stage, 10.0, 11.0, kAssemble),
               span(SpanKind::stage, 11.0, 15.0, kFactor),
               span(SpanKind::loop, 11.0, 14.0, kFactor, 0, 3, 2),
               span(SpanKind::task, 11.0, 14.0, kFactor, 1, 3, 0),
               span(SpanKind::task, 11.5, 13.5, kFactor, 0, 3, 1)};
    return v;
}

TEST(Timeline, FiguresOfATraceMadeByHand) {
    const TraceView view = by_hand();
    EXPECT_EQ(typical_step(view), 7);
    EXPECT_THROW((void)timeline_of(view, 8), std::out_of_range);
    EXPECT_THROW((void)typical_step(TraceView{}), std::out_of_range);
    const Timeline t = timeline_of(view, 7);
    EXPECT_EQ(t.threads, 2);
    EXPECT_NEAR(t.seconds, 6.0, kRound);
    const TimelineFigures f = figures_of(t);
    auto of = [&](Work w) { return f.seconds[static_cast<std::size_t>(w)]; };
    EXPECT_NEAR(of(Work::assembly), 1.0, kRound);
    EXPECT_NEAR(of(Work::linear_algebra), 3.0 + 2.0 + 1.0,
                kRound);  // tasks, and code after the loop
    EXPECT_NEAR(of(Work::other), 1.0, kRound);
    EXPECT_NEAR(f.busy, 8.0 / 12.0, kRound);
    EXPECT_NEAR(f.linear_algebra, 6.0 / 8.0, kRound);
    EXPECT_NEAR(f.balance, 4.0 / 5.0, kRound);  // 5 s and 3 s
    EXPECT_EQ(describe(t),
              "step 7: 6000 ms on 2 threads, linear algebra 75.0 % of the work, load balance "
              "80.0 %, idle 33.3 %");
}

TEST(Timeline, OneThreadNeverWaits) {
    TraceView view = by_hand();
    view.threads = 1;
    std::erase_if(view.spans, [](const TraceSpan& s) { return s.thread == 1; });
    EXPECT_NEAR(figures_of(timeline_of(view, 7)).busy, 1.0, kRound);
}

TEST(Timeline, SimulatesAStepOfOneThread) {
    TraceView view = by_hand();
    view.threads = 1;
    view.spans[3].end = 16.0;  // the loop, with one task after the other
    view.spans[0].end = 18.0;
    view.spans[2].end = 17.0;
    view.spans[4] = span(SpanKind::task, 11.0, 14.0, kFactor, 0, 3, 0);
    view.spans[5] = span(SpanKind::task, 14.0, 16.0, kFactor, 0, 3, 1);
    EXPECT_NEAR(timeline_of(view, 7).seconds, 8.0, kRound);
    const Timeline t = simulated_timeline(view, 7, 4, {});
    EXPECT_TRUE(t.simulated);
    EXPECT_EQ(t.threads, 4);
    EXPECT_NEAR(t.seconds, 1.0 + 3.0 + 2.0, kRound);
    EXPECT_NEAR(figures_of(t).busy, 8.0 / 24.0, kRound);
    EXPECT_NE(describe(t).find("4 simulated threads"), std::string::npos);
}

TEST(Timeline, ThePictureHasALineForEachThread) {
    const TraceView view = by_hand();
    const Drawing d =
        plot_timelines({timeline_of(view, 7), simulated_timeline(view, 7, 3, {})}, "a & b", "<p>");
    const XmlDocument xml = XmlReader(to_svg(d)).read();
    auto count = [&](const std::string& text) {
        return std::count(xml.texts.begin(), xml.texts.end(), text);
    };
    for (const char* text : {"thread 0", "thread 1", "simulated thread 0", "simulated thread 2",
                             "assembly", "linear algebra", "other", "idle"})
        EXPECT_EQ(count(text), 1) << text;
    EXPECT_EQ(count("nonsmooth"), 0);  // absent names are left out
    EXPECT_GE(count("a & b"), 1);
}

TEST(Timeline, TheFileForViewersIsJsonOfTheSpans) {
    SmallScene scene;
    scene.world.solver().start_trace(5000);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(scene.world.step(), Status::ok);
    const TraceView view = scene.world.solver().trace(4);
    ASSERT_EQ(view.steps, 4);
    const auto json = nlohmann::json::parse(to_trace_events(view, "a \"b\" \\ c\n"));
    EXPECT_EQ(json["otherData"]["scene"], "a \"b\" \\ c ");
    EXPECT_EQ(json["otherData"]["steps"], 4);
    const auto& events = json["traceEvents"];
    ASSERT_EQ(events.size(), view.spans.size() + 1);
    EXPECT_EQ(events[0]["ph"], "M");
    std::size_t steps = 0;
    for (std::size_t i = 0; i < view.spans.size(); ++i) {
        const auto& e = events[i + 1];
        const TraceSpan& s = view.spans[i];
        EXPECT_EQ(e["ph"], "X");
        EXPECT_EQ(e["tid"], s.thread);
        EXPECT_EQ(e["args"]["step"], s.step);
        EXPECT_NEAR(e["ts"].get<double>(), 1e6 * s.begin, 1e-3);  // written with three decimals
        EXPECT_NEAR(e["dur"].get<double>(), 1e6 * s.seconds(), 1e-3);
        if (e["cat"] == "stage") {
            EXPECT_EQ(e["name"], to_string(static_cast<Stage>(s.stage)));
        }
        steps += e["cat"] == "step" ? 1U : 0U;
    }
    EXPECT_EQ(steps, 4U);
    EXPECT_TRUE(nlohmann::json::accept(to_trace_events(TraceView{}, "empty")));
}

}  // namespace
}  // namespace hawser::test
