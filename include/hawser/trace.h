// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file trace.h
/// Trace of the threads of a world: the time spans of steps, stages, parallel loops and their
/// tasks.
///
/// WorldSolver::start_trace() allocates a ring buffer for each thread. Each step then stores its
/// spans; newer spans replace the oldest. WorldSolver::trace() copies the steps of which no span
/// has been replaced. Spans of one thread are nested:
/// ```
///     caller   step ─ stage ─┬─ stage (iterations that factor again)
///                            └─ loop ─┬─ task
///     worker                          └─ task
/// ```
/// Tracing does not change results. It costs two readings of the clock per span.

#include <hawser/stats.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// Kind of a span.
enum class SpanKind : std::uint8_t {
    step,   ///< Whole step.
    stage,  ///< Stage or part of one; a stage may run several times in a step.
    loop,   ///< List of tasks for any thread, from its start to its last task.
    task,   ///< Task of a loop.
};
/// Return the name of a kind, as in its enumerator.
[[nodiscard]] const char* to_string(SpanKind kind) noexcept;

/// Time span of one thread.
struct TraceSpan {
    double begin = 0.0, end = 0.0;  ///< Times since the start of the trace [s].
    std::int64_t step = 0;          ///< Number of the step, as StepStats::step.
    std::int32_t loop = -1;         ///< Number of the loop; −1: none.
    std::int32_t task = -1;         ///< Task: its index in the loop. Loop: the number of its tasks.
    std::int32_t thread = 0;        ///< Index of the thread; 0: caller of World::step().
    SpanKind kind = SpanKind::task;  ///< Kind of the span.
    std::int8_t stage = -1;          ///< Innermost stage, a value of Stage; −1: none.
    /// Return the duration [s].
    [[nodiscard]] double seconds() const noexcept { return end - begin; }
};

/// Dependencies of the tasks of a loop. Empty: tasks are independent and run by index.
struct TaskWaits {
    /// Task i must end before the tasks next[start[i]] to next[start[i + 1] − 1] begin. The ready
    /// task with the lowest rank[i] runs first.
    std::vector<std::int32_t> start, next, rank;
};

/// Trace of whole steps, WorldSolverView::trace().
struct TraceView {
    std::vector<TraceSpan> spans;  ///< Spans ordered by `begin`, longer ones first.
    std::vector<std::int32_t>
        graph_loop;                ///< Numbers of the loops with dependent tasks, ascending.
    std::vector<TaskWaits> graph;  ///< Dependencies of each of these loops.
    int threads = 1;               ///< Number of threads.
    std::int64_t steps = 0;        ///< Number of steps in the trace.
    std::int64_t steps_lost = 0;   ///< Number of earlier steps that newer ones overwrote.
};

}  // namespace hawser
