// SPDX-License-Identifier: Apache-2.0
#include <hawser/schedule.h>

#include "runtime/tasks.h"
#include "runtime/trace.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace hawser {
namespace {

/// The value that a tenth of all stays below: other programs only ever make a sample longer.
double least(std::vector<double>& v) {
    if (v.empty()) return 0.0;
    const auto tenth = v.begin() + static_cast<std::ptrdiff_t>(v.size() / 10);
    std::nth_element(v.begin(), tenth, v.end());
    return *tenth;
}

constexpr int kBursts = 20, kMostBursts = 200, kLoops = 100, kTasks = 8, kEmpty = 2048;
constexpr double kTask = 4e-6;  // [s]; long enough for the other thread to come

struct CostSamples {
    std::vector<double> wake, start, join, deal;
};

/// Loops of tasks that both threads have time to take.
void record_loops(runtime::Pool& pool, CostSamples& samples) {
    runtime::Trace trace(2, static_cast<std::size_t>(kLoops * (kTasks + 1)));
    auto spin = [&](int, int) noexcept {
        for (const double from = trace.now(); trace.now() < from + kTask;) {
        }
    };
    pool.record(&trace);
    const double resumed = trace.now();
    pool.resume();
    for (int k = 0; k < kLoops; ++k) pool.for_each(kTasks, spin);
    pool.pause();
    pool.record(nullptr);
    TraceView view;
    trace.copy(0.0, view);
    std::vector<double> begin(kLoops, 0.0), end(kLoops, 0.0), last(kLoops, 0.0);
    double first = -1.0;
    for (const TraceSpan& s : view.spans) {
        const auto k = static_cast<std::size_t>(s.loop);
        if (s.kind == SpanKind::loop) {
            begin[k] = s.begin;
            end[k] = s.end;
            continue;
        }
        last[k] = std::max(last[k], s.end);
        if (s.thread == 0 || begin[k] < 0.0) continue;
        if (first < 0.0)
            samples.wake.push_back(first = s.begin - resumed);
        else
            samples.start.push_back(s.begin - begin[k]);
        begin[k] = -1.0;  // its first task only
    }
    for (std::size_t k = 0; k < kLoops; ++k) samples.join.push_back(end[k] - last[k]);
}

/// Loops of tasks that do nothing.
void time_dealing(runtime::Pool& pool, CostSamples& samples) {
    alignas(64) int taken[2][16] = {};  // a cache line for each thread
    auto nothing = [&](int, int thread) noexcept { ++taken[thread][0]; };
    pool.resume();
    for (int k = 0; k < kLoops / 10; ++k) {
        taken[1][0] = 0;
        const auto from = std::chrono::steady_clock::now();
        pool.for_each(kEmpty, nothing);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - from;
        if (taken[1][0] > kEmpty / 4)  // else the other thread was away
            samples.deal.push_back(time.count() / kEmpty);
    }
    pool.pause();
}

}  // namespace

PoolCosts measure_pool_costs() {
    runtime::Pool pool(2);
    CostSamples samples;
    // Where other programs keep the second processor, it takes longer to find out.
    for (int burst = 0;
         burst < kBursts || (burst < kMostBursts && samples.start.size() < 10 * kLoops); ++burst) {
        record_loops(pool, samples);
        time_dealing(pool, samples);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the workers sleep
    }
    PoolCosts costs;
    costs.start = least(samples.start);
    costs.join = least(samples.join);
    costs.deal = least(samples.deal);
    costs.wake = least(samples.wake);
    return costs;
}

}  // namespace hawser
