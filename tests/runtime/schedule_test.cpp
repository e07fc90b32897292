// SPDX-License-Identifier: Apache-2.0
/// The simulator of schedules against closed forms, and against the pool itself.
#include <hawser/experimental/schedule.h>

#include "runtime/tasks.h"
#include "runtime/trace.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace hawser::runtime {
namespace {

// Rounding of sums of a few hundred numbers near 1.
constexpr double kRounding = 1e-12;

ProgramTimes one_loop(std::vector<double> task) {
    ProgramTimes p;
    p.loops.push_back({0.0, std::move(task)});
    return p;
}

TEST(Schedule, EqualTasksTakeTheirShareRoundedUp) {
    for (const int tasks : {1, 7, 48, 100})
        for (const int threads : {1, 2, 3, 8, 64}) {
            const ProgramTimes p =
                one_loop(std::vector<double>(static_cast<std::size_t>(tasks), 1.0));
            EXPECT_NEAR(simulate(p, threads, {}).seconds, (tasks + threads - 1) / threads,
                        kRounding);
        }
}

TEST(Schedule, OneLongTaskBoundsTheRest) {
    std::vector<double> task(30, 1.0);
    task.insert(task.begin(), 20.0);  // assigned first: the others fit beside it on 4 threads
    // Two threads: 20 short tasks beside the long one, then 5 on each.
    EXPECT_NEAR(simulate(one_loop(task), 2, {}).seconds, 25.0, kRounding);
    EXPECT_NEAR(simulate(one_loop(task), 4, {}).seconds, 20.0, kRounding);
    std::rotate(task.begin(), task.begin() + 1, task.end());  // assigned last: starts late
    EXPECT_NEAR(simulate(one_loop(task), 2, {}).seconds, 15.0 + 20.0, kRounding);
    EXPECT_NEAR(one_loop(task).critical(), 20.0, kRounding);
}

TEST(Schedule, SerialCodeFollowsAmdahl) {
    ProgramTimes p;
    for (int k = 0; k < 5; ++k) p.loops.push_back({0.2, std::vector<double>(64, 0.125)});
    p.after = 1.0;
    const double serial = 2.0, parallel = 40.0;
    EXPECT_NEAR(p.serial(), serial, kRounding);
    EXPECT_NEAR(p.work(), serial + parallel, kRounding);
    for (const int threads : {1, 2, 4, 8, 16, 32, 64})
        EXPECT_NEAR(simulate(p, threads, {}).seconds, serial + parallel / threads, kRounding);
}

TEST(Schedule, EveryCostAppearsOnceALoop) {
    ProgramTimes p;
    for (int k = 0; k < 3; ++k) p.loops.push_back({1.0, {1.0, 1.0}});
    p.loops.push_back({1.0, {1.0}});  // one task wakes no thread
    PoolCosts costs;
    costs.start = 0.25;
    costs.join = 0.5;
    // The other thread starts 0.25 late and the caller waits for it: 1 + 1.25 + 0.5 per loop.
    EXPECT_NEAR(simulate(p, 2, costs).seconds, 3 * 2.75 + 2.0, kRounding);
    EXPECT_NEAR(simulate(p, 1, costs).seconds, p.work(), kRounding);
    // A sleeping thread starts no task: the caller has completed both when it wakes.
    costs.wake = 3.5;
    EXPECT_NEAR(simulate(p, 2, costs).seconds, (1.0 + 2.0 + 0.5) + 2 * 2.75 + 2.0, kRounding);
    // Threads acquire one task at a time.
    costs = {};
    costs.deal = 0.1;
    EXPECT_NEAR(simulate(one_loop(std::vector<double>(10, 0.0)), 4, costs).seconds, 1.0, kRounding);
}

/// Let every task wait for its children; the rank is the order of the tasks.
TaskWaits towards(const std::vector<std::int32_t>& parent) {
    TaskWaits w;
    w.start.push_back(0);
    for (const std::int32_t p : parent) {
        if (p >= 0) w.next.push_back(p);
        w.start.push_back(static_cast<std::int32_t>(w.next.size()));
    }
    w.rank.resize(parent.size());
    std::iota(w.rank.begin(), w.rank.end(), 0);
    return w;
}

TEST(Schedule, ATaskWaitsForItsChildren) {
    // A binary tree of 2^5 − 1 equal tasks, level by level: 5 levels.
    constexpr int kLevels = 5;
    std::vector<std::int32_t> parent;
    for (int width = 1 << (kLevels - 1), begin = 0; width > 0; begin += width, width /= 2)
        for (int i = 0; i < width; ++i) parent.push_back(width == 1 ? -1 : begin + width + i / 2);
    ProgramTimes p = one_loop(std::vector<double>(parent.size(), 1.0));
    p.loops[0].waits = towards(parent);
    EXPECT_NEAR(p.critical(), kLevels, kRounding);
    EXPECT_NEAR(simulate(p, 16, {}).seconds, kLevels, kRounding);
    EXPECT_NEAR(simulate(p, 1, {}).seconds, 31.0, kRounding);
    EXPECT_NEAR(simulate(p, 4, {}).seconds, 4 + 2 + 1 + 1 + 1, kRounding);
    // A chain of tasks gains nothing.
    for (std::size_t i = 0; i < parent.size(); ++i)
        parent[i] = i + 1 < parent.size() ? static_cast<std::int32_t>(i + 1) : -1;
    p.loops[0].waits = towards(parent);
    EXPECT_NEAR(simulate(p, 64, {}).seconds, 31.0, kRounding);
}

TEST(Schedule, TheMostUrgentReadyTaskGoesFirst) {
    // Two short tasks, then one followed by a long one. By rank the latter comes first.
    ProgramTimes p = one_loop({1.0, 1.0, 1.0, 5.0});
    p.loops[0].waits = towards({-1, -1, 3, -1});
    EXPECT_NEAR(simulate(p, 2, {}).seconds, 7.0, kRounding);
    p.loops[0].waits.rank = {2, 3, 0, 1};
    EXPECT_NEAR(simulate(p, 2, {}).seconds, 6.0, kRounding);
    EXPECT_NEAR(p.critical(), 6.0, kRounding);
}

/// One chain of blocks of size s, cut into k parts: a part with one boundary costs 7/3 s³ per
/// block, one with two boundaries 19/3 s³. With balanced lengths S(k) = 2 + (k − 2) 7/19.
TEST(Schedule, AChainInPartsReachesItsLimit) {
    constexpr double kOne = 7.0 / 3.0, kTwo = 19.0 / 3.0, kBlocks = 100'000.0;
    for (const int k : {2, 4, 8, 16}) {
        const double limit = 2.0 + (k - 2) * 7.0 / 19.0;
        const double end = kBlocks / limit, middle = end * kOne / kTwo;  // blocks of a part
        std::vector<double> parts(static_cast<std::size_t>(k), middle * kTwo);
        parts.front() = parts.back() = end * kOne;
        ASSERT_NEAR(2 * end + (k - 2) * middle, kBlocks, 1e-9 * kBlocks);
        const double whole = kBlocks * kOne;
        EXPECT_NEAR(whole / simulate(one_loop(parts), k, {}).seconds, limit, 1e-9) << k;
        // The chain is long, so that the k − 1 blocks of the separators have little effect.
        ProgramTimes p = one_loop(parts);
        p.after = (k - 1) * kTwo;
        EXPECT_GT(whole / simulate(p, k, {}).seconds, 0.99 * limit) << k;
    }
}

/// List scheduling is within a factor of the optimum (Graham 1966), and never below the bounds.
TEST(Schedule, RandomLoopsKeepTheBoundsOfLists) {
    test::Random random(test::first_seed(7));
    const int rounds = test::by_tier(300, 1500, 15'000);
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> task(static_cast<std::size_t>(random.integer(1, 60)));
        for (double& t : task) t = random.uniform(0.1, 3.0);
        const ProgramTimes p = one_loop(task);
        double last = p.work() * (1.0 + kRounding);
        for (const int threads : {1, 2, 4, 8, 16, 64}) {
            const double t = simulate(p, threads, {}).seconds;
            const double share = p.work() / threads, longest = p.critical();
            EXPECT_GE(t * (1.0 + kRounding), std::max(share, longest));
            EXPECT_LE(t, (share + longest) * (1.0 + kRounding));
            EXPECT_LE(t, last);  // independent tasks in a fixed order: more threads never take
                                 // longer
            last = t * (1.0 + kRounding);
        }
    }
}

TEST(Schedule, SpansAreThoseOfARun) {
    std::vector<TraceSpan> spans;
    ProgramTimes p;
    p.loops.push_back({1.0, {2.0, 1.0, 1.0, 3.0}});
    p.loops.push_back({0.5, {1.0}});
    const Simulated s = simulate(p, 2, {}, &spans);
    ASSERT_EQ(spans.size(), 7U);
    EXPECT_NEAR(s.seconds, 1.0 + 5.0 + 0.5 + 1.0, kRounding);
    std::set<int> threads;
    double busy = p.serial();
    for (const TraceSpan& a : spans) {
        if (a.kind != SpanKind::task) continue;
        threads.insert(a.thread);
        busy += a.seconds();
        for (const TraceSpan& b : spans)
            if (b.kind == SpanKind::task && &a != &b && a.thread == b.thread) {
                EXPECT_TRUE(a.end <= b.begin || b.end <= a.begin);
            }
    }
    EXPECT_EQ(threads.size(), 2U);
    EXPECT_NEAR(busy, s.busy, kRounding);
}

/// The simulator reads the record of one thread of the pool: times add up.
TEST(Schedule, ReadsTheProgramThatAPoolRecorded) {
    Pool pool(1);
    Trace trace(1, 4096);
    auto spin = [&](int i, int) noexcept {
        for (const double from = trace.now(); trace.now() < from + 2e-6 * (1 + i % 3);) {
        }
    };
    pool.record(&trace);
    const double begin = trace.now();
    pool.for_each(30, spin);
    spin(2, 0);  // serial part
    pool.for_each(0, spin);
    pool.for_each(12, spin);
    const double end = trace.now();
    pool.record(nullptr);
    pool.for_each(5, spin);  // not recorded
    TraceView view;
    trace.copy(0.0, view);
    const ProgramTimes p = program_of(view, begin, end);
    ASSERT_EQ(p.loops.size(), 3U);
    EXPECT_EQ(p.loops[0].task.size(), 30U);
    EXPECT_EQ(p.loops[1].task.size(), 0U);
    EXPECT_EQ(p.loops[2].task.size(), 12U);
    EXPECT_GE(p.loops[1].before, 6e-6);
    for (const LoopTimes& l : p.loops)
        for (std::size_t i = 0; i < l.task.size(); ++i)
            EXPECT_GE(l.task[i], 2e-6 * static_cast<double>(1 + i % 3));
    // Clock readings between tasks are in no task.
    EXPECT_LE(p.work(), end - begin);
    EXPECT_GE(p.work(), 2e-6 * (2 * 30 + 3 + 2 * 12));
}

}  // namespace
}  // namespace hawser::runtime
