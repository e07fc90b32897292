// SPDX-License-Identifier: Apache-2.0
#include <hawser/experimental/schedule.h>

#include "runtime/tasks.h"
#include "runtime/trace.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace hawser {
namespace {

/// Return the quantile of v at the fraction `fraction`; 0 if v is empty.
double quantile(std::vector<double>& v, double fraction) {
    if (v.empty()) return 0.0;
    const auto at =
        v.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(v.size()));
    std::nth_element(v.begin(), at, v.end());
    return *at;
}

constexpr int kMinBursts = 20, kMaxBursts = 200, kLoopsPerBurst = 100, kTasksPerLoop = 8;
constexpr double kTaskSeconds = 4e-6;  // [s]; long enough for the other thread to arrive
constexpr double kMaxStartDelay = 2.0 * kTaskSeconds;  // [s]; a later thread had no processor

struct CostSamples {
    std::vector<double> wake, start, join;
    std::vector<double> gap;  ///< Time between two tasks of a thread [s].
    /// Time between two tasks of a thread without work sharing [s]: the cost of the trace itself.
    std::vector<double> alone;
};

/// Record loops of tasks that are long enough for both threads to join.
void record_loops(runtime::Pool& pool, bool awake, CostSamples& samples) {
    runtime::Trace trace(2, static_cast<std::size_t>(kLoopsPerBurst * (kTasksPerLoop + 1)));
    auto spin = [&](int, int) noexcept {
        for (const double from = trace.now(); trace.now() < from + kTaskSeconds;) {
        }
    };
    pool.record(&trace);
    const double resumed = trace.now();
    if (awake) pool.resume();
    for (int k = 0; k < kLoopsPerBurst; ++k) pool.for_each(kTasksPerLoop, spin);
    pool.pause();
    pool.record(nullptr);
    TraceView view;
    trace.copy(0.0, view);
    std::vector<double> begin(kLoopsPerBurst, 0.0), end(kLoopsPerBurst, 0.0),
        last(kLoopsPerBurst, 0.0);
    double first = -1.0;
    std::vector<double>& gap = awake ? samples.gap : samples.alone;
    TraceSpan before[2];
    for (const TraceSpan& s : view.spans) {
        const auto k = static_cast<std::size_t>(s.loop);
        if (s.kind == SpanKind::loop) {
            begin[k] = s.begin;
            end[k] = s.end;
            continue;
        }
        last[k] = std::max(last[k], s.end);
        TraceSpan& previous = before[s.thread];
        if (previous.loop == s.loop) gap.push_back(s.begin - previous.end);
        previous = s;
        if (s.thread == 0 || begin[k] < 0.0) continue;
        if (first < 0.0)
            samples.wake.push_back(first = s.begin - resumed);
        else if (s.begin - begin[k] < kMaxStartDelay)
            samples.start.push_back(s.begin - begin[k]);
        begin[k] = -1.0;  // count the first task of the thread only
    }
    for (std::size_t k = 0; awake && k < kLoopsPerBurst; ++k)
        samples.join.push_back(end[k] - last[k]);
}

}  // namespace

PoolCosts measure_pool_costs() {
    runtime::Pool pool(2);
    CostSamples samples;
    // Add bursts if other programs occupy the second processor.
    for (int burst = 0;
         burst < kMinBursts || (burst < kMaxBursts && samples.start.size() < 10 * kLoopsPerBurst);
         ++burst) {
        record_loops(pool, true, samples);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));  // lets the workers sleep
    }
    record_loops(pool, false, samples);
    PoolCosts costs;
    // Other programs can only lengthen samples; on a busy machine they lengthen nearly all of them.
    // Gaps are short and many, so that their median is not affected. If the threads never ran
    // together, the bound kMaxStartDelay is the only estimate.
    costs.start = samples.start.empty() ? kMaxStartDelay : quantile(samples.start, 0.1);
    costs.join = quantile(samples.join, 0.02);
    costs.wake = quantile(samples.wake, 0.0);
    costs.deal = std::max(0.0, quantile(samples.gap, 0.5) - quantile(samples.alone, 0.5));
    return costs;
}

}  // namespace hawser
