// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// Show the work of threads in a step. Output: numbers, a picture with a line for each thread, or a
/// file for trace viewers.

#include "draw/drawing.h"

#include <hawser/experimental/schedule.h>
#include <hawser/trace.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::draw {

/// Kinds of work; each has a colour.
enum class Work : std::uint8_t {
    collide,         ///< Stage collide.
    analysis,        ///< Stages graph and analyse.
    assembly,        ///< Stage assemble.
    linear_algebra,  ///< Stage factor: factorisations and substitutions.
    nonsmooth,       ///< Stage nonsmooth.
    integrate,       ///< Stage integrate.
    other,           ///< Stage prestep, and time outside all stages.
};
inline constexpr int kWorkCount = 7;
[[nodiscard]] const char* to_string(Work work) noexcept;
/// Return the kind of work of a stage. @param stage  As in TraceSpan.
[[nodiscard]] Work work_of(std::int8_t stage) noexcept;
[[nodiscard]] Color color_of(Work work) noexcept;

/// Interval in which a thread works.
struct Segment {
    double begin = 0.0, end = 0.0;  ///< Time since the start of the step [s].
    int thread = 0;
    Work work = Work::other;
    /// True for a task that any thread could have run; false for code of the calling thread.
    bool task = false;
};

/// Timeline of one step, measured or simulated.
struct Timeline {
    std::vector<Segment> segments;
    double seconds = 0.0;  ///< Duration of the step [s].
    int threads = 1;
    std::int64_t step = 0;  ///< Number of the step.
    bool simulated = false;
};

/// Return the timeline of a step in the trace. @param step  Number of the step. @throws
/// std::out_of_range.
[[nodiscard]] Timeline timeline_of(const TraceView& trace, std::int64_t step);
/// Return the step of median duration. @throws std::out_of_range if there is none.
[[nodiscard]] std::int64_t typical_step(const TraceView& trace);
/// Simulate the timeline of a step on several threads from a run on one thread. The time of code
/// between loops is added to the following loop.
[[nodiscard]] Timeline simulated_timeline(const TraceView& trace, std::int64_t step, int threads,
                                          const PoolCosts& costs);

struct TimelineFigures {
    std::array<double, kWorkCount> seconds{};  ///< Time of all threads together [s].
    double busy = 0.0;            ///< Fraction of the threads' time in which they work.
    double balance = 1.0;         ///< Work of the average thread over that of the busiest one.
    double linear_algebra = 0.0;  ///< Fraction of linear algebra in the work.
};
[[nodiscard]] TimelineFigures figures_of(const Timeline& timeline);
/// Return one line with duration, threads, fraction of linear algebra, load balance, idle time.
[[nodiscard]] std::string describe(const Timeline& timeline);

/// Draw the lines of the threads in a part of a picture, from 0 to `until` [s], without a legend.
void draw_timeline(Drawing& drawing, const Box& frame, const Timeline& timeline, double until);
/// Draw a legend of the kinds of work that occur, as wide as the box.
void draw_work_legend(Drawing& drawing, const Box& frame, const std::vector<Timeline>& timelines);
/// Draw one or several timelines, one above the other, on one time axis.
[[nodiscard]] Drawing plot_timelines(const std::vector<Timeline>& timelines,
                                     const std::string& title, const std::string& parameters);

/// Return the trace in Trace Event Format, for chrome://tracing and Perfetto. It consists of
/// complete events ("ph": "X") with times in microseconds. The name of a thread is in a metadata
/// event.
[[nodiscard]] std::string to_trace_events(const TraceView& trace, const std::string& scene);

}  // namespace hawser::draw
