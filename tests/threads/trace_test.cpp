// SPDX-License-Identifier: Apache-2.0
/// Traces of whole steps: they have no effect, nest, and agree with the times of the statistics.
#include "support/small_recipes.h"

#include <gtest/gtest.h>
#include <hawser/experimental/schedule.h>
#include <hawser/trace.h>

#include <array>
#include <map>
#include <vector>

namespace hawser::test {
namespace {

class EachTracedRecipe : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Recipes, EachTracedRecipe, testing::ValuesIn(kSmallRecipes), name_of);

/// Expect that spans of the calling thread are nested or disjoint; tasks of other threads are
/// disjoint.
void expect_nested(const TraceView& view) {
    std::vector<TraceSpan> open;
    std::vector<double> busy_until(static_cast<std::size_t>(view.threads), 0.0);
    for (const TraceSpan& s : view.spans) {
        ASSERT_GE(s.thread, 0);
        ASSERT_LT(s.thread, view.threads);
        if (s.thread > 0) {
            double& until = busy_until[static_cast<std::size_t>(s.thread)];
            EXPECT_EQ(s.kind, SpanKind::task);
            EXPECT_GE(s.begin, until);
            until = s.end;
            continue;
        }
        while (!open.empty() && open.back().end <= s.begin) open.pop_back();
        if (open.empty()) {
            EXPECT_EQ(s.kind, SpanKind::step);
        } else {
            EXPECT_LE(s.end, open.back().end);
            EXPECT_EQ(s.step, open.back().step);
            if (s.kind == SpanKind::task) {
                EXPECT_EQ(open.back().kind, SpanKind::loop);
                EXPECT_EQ(s.stage, open.back().stage);
            }
        }
        open.push_back(s);
    }
}

/// Return the time of each stage in a step, without its inner stages, from the spans.
std::array<double, kStageCount> stage_seconds(const TraceView& view, std::int64_t step) {
    std::array<double, kStageCount> own{};
    std::vector<TraceSpan> open;
    for (const TraceSpan& s : view.spans) {
        if (s.kind != SpanKind::stage || s.step != step) continue;
        while (!open.empty() && open.back().end <= s.begin) open.pop_back();
        own[static_cast<std::size_t>(s.stage)] += s.seconds();
        if (!open.empty()) own[static_cast<std::size_t>(open.back().stage)] -= s.seconds();
        open.push_back(s);
    }
    return own;
}

void expect_whole_loops_of(const TraceView& view) {
    std::map<std::int32_t, std::int32_t> left;
    for (const TraceSpan& s : view.spans) {
        if (s.kind == SpanKind::loop) left[s.loop] += s.task;
        if (s.kind == SpanKind::task) left[s.loop] -= 1;
    }
    for (const auto& [loop, tasks] : left) EXPECT_EQ(tasks, 0) << "loop " << loop;
}

TEST_P(EachTracedRecipe, NestsAndChangesNothing) {
    const Recipe recipe = GetParam().make();
    World plain = recipe.make();
    for (int i = 0; i < 20; ++i) ASSERT_EQ(plain.step(), Status::ok);
    for (const int threads : {1, 2, 3}) {
        WorldDef def = recipe.world;
        def.threads = threads;
        World traced = recipe.make(def);
        traced.solver().start_trace(10'000);
        for (int i = 0; i < 20; ++i) ASSERT_EQ(traced.step(), Status::ok);
        EXPECT_EQ(traced.state().hash(), plain.state().hash()) << threads << " threads";
        const TraceView view = traced.solver().trace();
        EXPECT_EQ(view.steps + view.steps_lost, 20);
        EXPECT_EQ(view.threads, threads);
        expect_nested(view);
        expect_whole_loops_of(view);
        // Both come from the same clock readings: rounding of their sums.
        const std::array<double, kStageCount> own = stage_seconds(view, 20);
        for (std::size_t k = 0; k < kStageCount; ++k)
            EXPECT_NEAR(own[k], traced.stats().stage_seconds[k], 1e-9)
                << to_string(static_cast<Stage>(k));
    }
}

TEST(Trace, KeepsTheLastStepsWhole) {
    Recipe recipe = mixed(11, 150);
    for (const int threads : {1, 2, 4}) {
        recipe.world.threads = threads;
        World w = recipe.make();
        ASSERT_EQ(w.step(), Status::ok);
        w.solver().start_trace(600);  // some steps
        for (int i = 0; i < 30; ++i) ASSERT_EQ(w.step(), Status::ok);
        const TraceView view = w.solver().trace();
        EXPECT_GT(view.steps, 0);
        EXPECT_GT(view.steps_lost, 0);
        EXPECT_EQ(view.steps + view.steps_lost, 30);
        expect_nested(view);
        expect_whole_loops_of(view);
        EXPECT_EQ(view.spans.back().step, 31);
        EXPECT_EQ(view.spans.front().step, 31 - view.steps + 1);
        EXPECT_EQ(w.solver().trace(1).spans.front().step, 31);
        w.solver().start_trace(0);
        EXPECT_TRUE(w.solver().trace().spans.empty());
        ASSERT_EQ(w.step(), Status::ok);
    }
}

/// The program of a step on one thread: complete, with graphs for tasks that wait for each other.
TEST(Trace, AStepIsAProgramForTheSimulator) {
    Recipe recipe = mixed(11, 150);
    World w = recipe.make();
    w.solver().start_trace(20'000);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(w.step(), Status::ok);
    const TraceView view = w.solver().trace(1);
    ASSERT_EQ(view.steps, 1);
    const TraceSpan step = view.spans.front();
    const ProgramTimes p = program_of(view, step.begin, step.end);
    EXPECT_GT(p.loops.size(), 4U);
    EXPECT_LE(p.work(), step.seconds() * (1.0 + 1e-12));  // rounding
    EXPECT_NEAR(simulate(p, 1, {}).seconds, p.work(), 1e-12);
    EXPECT_GE(simulate(p, 8, {}).seconds, p.critical() * (1.0 - 1e-12));
    int graphs = 0;
    for (const LoopTimes& l : p.loops) {
        if (l.waits.start.empty()) continue;
        ++graphs;
        EXPECT_EQ(l.waits.start.size(), l.task.size() + 1);
        EXPECT_EQ(l.waits.rank.size(), l.task.size());
        EXPECT_EQ(l.stage, static_cast<std::int8_t>(Stage::factor));
    }
    EXPECT_GE(graphs, 2);  // up and down
}

}  // namespace
}  // namespace hawser::test
