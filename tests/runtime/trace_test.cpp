// SPDX-License-Identifier: Apache-2.0
/// Ring buffers of spans: a span for every task, and complete loops after they have wrapped.
#include "runtime/trace.h"
#include "runtime/tasks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <vector>

namespace hawser::runtime {
namespace {

void work(Pool& pool, int loops) {
    std::atomic<int> sum{0};
    auto task = [&](int i, int) noexcept { sum.fetch_add(i, std::memory_order_relaxed); };
    for (int k = 0; k < loops; ++k) pool.for_each((7 * k) % 40, task);
}

/// Expect that loops of a view which begin at `from` or later have all their tasks, each once and
/// inside the loop.
int expect_whole_loops(const TraceView& view, double from) {
    std::map<std::int32_t, std::vector<int>> seen;
    std::map<std::int32_t, TraceSpan> loop;
    for (const TraceSpan& s : view.spans) {
        EXPECT_LE(s.begin, s.end);
        if (s.kind == SpanKind::loop && s.begin >= from) {
            loop[s.loop] = s;
            seen[s.loop].assign(static_cast<std::size_t>(s.task), 0);
        }
    }
    for (const TraceSpan& s : view.spans) {
        if (s.kind != SpanKind::task || !loop.contains(s.loop)) continue;
        EXPECT_GE(s.begin, loop[s.loop].begin);
        EXPECT_LE(s.end, loop[s.loop].end);
        if (s.task >= 0 && s.task < loop[s.loop].task)
            ++seen[s.loop][static_cast<std::size_t>(s.task)];
        else
            ADD_FAILURE() << "task " << s.task << " of loop " << s.loop;
    }
    for (const auto& [number, tasks] : seen)
        for (const int n : tasks) EXPECT_EQ(n, 1) << "loop " << number;
    return static_cast<int>(loop.size());
}

TEST(Trace, EveryTaskLeavesOneSpan) {
    for (const int threads : {1, 2, 3, 8}) {
        Pool pool(threads);
        Trace trace(threads, 1 << 14);
        pool.record(&trace);
        work(pool, 50);  // asleep: on the calling thread
        pool.resume();
        work(pool, 300);
        pool.pause();
        pool.record(nullptr);
        work(pool, 10);  // no longer recorded
        TraceView view;
        trace.copy(0.0, view);
        EXPECT_EQ(view.threads, threads);
        EXPECT_EQ(trace.end_of_overwritten(), 0.0);
        EXPECT_EQ(expect_whole_loops(view, 0.0), 350);
    }
}

TEST(Trace, WhatIsNotOverwrittenIsWhole) {
    for (const int threads : {1, 2, 4}) {
        Pool pool(threads);
        Trace trace(threads, 200);
        pool.record(&trace);
        pool.resume();
        work(pool, 500);
        pool.pause();
        const double from = trace.end_of_overwritten();
        EXPECT_GT(from, 0.0);
        TraceView view;
        trace.copy(from, view);
        // 200 spans of the calling thread are at least five loops, with all tasks on it.
        EXPECT_GE(expect_whole_loops(view, from), threads == 1 ? 5 : 1);
    }
}

TEST(Trace, NodesOfAGraphGoByTheirNumber) {
    Pool pool(2);
    Trace trace(2, 1000);
    const std::vector<std::int32_t> start{0, 1, 2, 2}, next{2, 2}, rank{1, 0, 2};
    pool.record(&trace);
    for (int k = 0; k < 5; ++k) {
        pool.announce({start, next, rank});
        auto task = [&](int i, int thread) noexcept { pool.begin_node(2 - i, thread); };
        pool.for_each(3, task);
        auto plain = [](int, int) noexcept {};
        pool.for_each(4, plain);
    }
    TraceView view;
    trace.copy(0.0, view);
    EXPECT_EQ(expect_whole_loops(view, 0.0), 10);
    ASSERT_EQ(view.graph_loop, (std::vector<std::int32_t>{0, 2, 4, 6, 8}));
    for (const TaskWaits& w : view.graph) {
        EXPECT_EQ(w.start, start);
        EXPECT_EQ(w.next, next);
        EXPECT_EQ(w.rank, rank);
    }
    std::vector<std::int32_t> order;
    for (const TraceSpan& s : view.spans)
        if (s.kind == SpanKind::task && s.loop == 0) order.push_back(s.task);
    EXPECT_EQ(order, (std::vector<std::int32_t>{2, 1, 0}));
}

}  // namespace
}  // namespace hawser::runtime
