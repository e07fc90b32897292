// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file trace.h
/// What each thread did and when: spans of steps, stages, parallel loops and their tasks.
///
/// World::start_trace() makes room; from then on every step leaves its spans in a ring for each
/// thread, the newest of which are kept, and World::trace() copies out the steps of which nothing
/// was lost. Spans of one thread nest: a step holds stages, a stage holds stages (where iterations
/// factor) and loops, a loop holds the calling thread's tasks. Other threads have tasks only.
/// Tracing changes no result; it takes two looks at the clock a span.

#include <hawser/stats.h>

#include <cstdint>
#include <vector>

namespace hawser {

enum class SpanKind : std::uint8_t {
    step,   ///< A whole step.
    stage,  ///< A stage, or a part of one: stages can be entered more than once a step.
    loop,   ///< A list of tasks that any thread may run, from handing it over to its last task.
    task,   ///< One of these tasks.
};
[[nodiscard]] const char* to_string(SpanKind kind) noexcept;

struct TraceSpan {
    double begin = 0.0, end = 0.0;  ///< Since tracing began [s].
    std::int64_t step = 0;          ///< Number of the step, as StepStats::step counts.
    std::int32_t loop = -1;         ///< Running number of the loop; −1: of no loop.
    std::int32_t task = -1;         ///< Of a task: its index in the loop. Of a loop: their number.
    std::int32_t thread = 0;        ///< 0: the thread that called World::step().
    SpanKind kind = SpanKind::task;
    std::int8_t stage = -1;  ///< The innermost one, a value of Stage; −1: outside all.
    [[nodiscard]] double seconds() const noexcept { return end - begin; }
};

/// Which tasks of a loop wait for which. Task i sets free next[start[i]] to next[start[i + 1]]; of
/// the ready ones that with the lowest rank goes first. Empty: all are independent and go by index.
struct TaskWaits {
    std::vector<std::int32_t> start, next, rank;
};

/// The spans of whole steps, sorted by begin, longer ones first. See World::trace().
struct TraceView {
    std::vector<TraceSpan> spans;
    std::vector<std::int32_t> graph_loop;  ///< Loops whose tasks wait for each other, ascending.
    std::vector<TaskWaits> graph;          ///< Of each of them.
    int threads = 1;
    std::int64_t steps = 0;       ///< That it holds.
    std::int64_t steps_lost = 0;  ///< Steps traced before, whose room newer ones needed.
};

}  // namespace hawser
