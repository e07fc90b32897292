// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timeline.h
/// What threads did in a step, as numbers, as a picture with a line for each thread, and as a file
/// for trace viewers.

#include "draw/drawing.h"

#include <hawser/schedule.h>
#include <hawser/trace.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::draw {

/// Kinds of work, a colour each.
enum class Work : std::uint8_t {
    collide,         ///< Stage collide.
    analysis,        ///< Stages graph and analyse.
    assembly,        ///< Stage assemble.
    linear_algebra,  ///< Stage factor: factorisations and substitutions.
    nonsmooth,       ///< Stage nonsmooth.
    integrate,       ///< Stage integrate.
    other,           ///< Stage prestep, and what is outside all stages.
};
inline constexpr int kWorkCount = 7;
[[nodiscard]] const char* to_string(Work work) noexcept;
[[nodiscard]] Work work_of(std::int8_t stage) noexcept;  ///< @param stage  As in TraceSpan.
[[nodiscard]] Color color_of(Work work) noexcept;

/// A stretch in which a thread works.
struct Segment {
    double begin = 0.0, end = 0.0;  ///< Since the step began [s].
    int thread = 0;
    Work work = Work::other;
    bool task = false;  ///< One that any thread could have run; else code of the calling thread.
};

/// One step, or what a simulation of it says.
struct Timeline {
    std::vector<Segment> segments;
    double seconds = 0.0;  ///< Its length [s].
    int threads = 1;
    std::int64_t step = 0;  ///< Number of the step.
    bool simulated = false;
};

/// @param step  Number of a step that the trace holds. @throws std::out_of_range.
[[nodiscard]] Timeline timeline_of(const TraceView& trace, std::int64_t step);
/// The step whose length is in the middle. @throws std::out_of_range where there is none.
[[nodiscard]] std::int64_t typical_step(const TraceView& trace);
/// A step that one thread ran, on more. Code between loops counts for the loop after it.
[[nodiscard]] Timeline simulated_timeline(const TraceView& trace, std::int64_t step, int threads,
                                          const PoolCosts& costs);

struct TimelineFigures {
    std::array<double, kWorkCount> seconds{};  ///< All threads together [s].
    double busy = 0.0;                         ///< Share of the threads' time in which they work.
    double balance = 1.0;         ///< Work of the average thread over that of the busiest.
    double linear_algebra = 0.0;  ///< Share of the work.
};
[[nodiscard]] TimelineFigures figures_of(const Timeline& timeline);
/// In a line: length, threads, share of linear algebra, load balance, idle time.
[[nodiscard]] std::string describe(const Timeline& timeline);

/// The lines of the threads in a part of a picture, from 0 to `until` [s]; no legend.
void draw_timeline(Drawing& drawing, const Box& frame, const Timeline& timeline, double until);
/// The legend's width is that of the box; only kinds of work that occur.
void draw_work_legend(Drawing& drawing, const Box& frame, const std::vector<Timeline>& timelines);
/// A picture of one or several timelines below each other on one axis of time.
[[nodiscard]] Drawing plot_timelines(const std::vector<Timeline>& timelines,
                                     const std::string& title, const std::string& parameters);

/// Trace Event Format, as chrome://tracing and Perfetto read it: complete events ("ph": "X") with
/// times in microseconds; a thread's name is in a metadata event.
[[nodiscard]] std::string to_trace_events(const TraceView& trace, const std::string& scene);

}  // namespace hawser::draw
