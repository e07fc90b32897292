// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file schedule.h
/// Predicts the time on any number of threads from task times measured on one.
///
/// The library runs a step as *loops* of independent tasks with code between them that only the
/// calling thread runs. A loop's tasks are dealt out in order, each to the first thread that is
/// free (src/runtime/tasks.h); where tasks wait for each other, a free thread takes the most urgent
/// ready one (src/factor/task_graph.h). A loop ends with its last task. Given the time of every
/// task and of all code between, this file replays that dealing for any number of threads:
///
/// ```
/// caller   before ─┬─ task 0 ── task 2 ─┬─ before ─┬─ …
/// worker           └─ task 1 ── task 3 ─┘          └─ …
///               start                 join
/// ```
/// What it cannot know is what threads do to each other through caches and memory: a prediction is
/// what the order of the work allows, and is checked against what two threads measure.

#include <hawser/trace.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// A loop whose tasks any thread may run.
struct LoopTimes {
    double before = 0.0;       ///< Of the calling thread alone, since the last loop [s].
    std::vector<double> task;  ///< Of each task, in the order of dealing [s].
    TaskWaits waits{};
    std::int8_t stage = -1;  ///< As in TraceSpan.
    /// Longest sum of tasks that wait for each other [s].
    [[nodiscard]] double critical() const;
};

struct ProgramTimes {
    std::vector<LoopTimes> loops;
    double after = 0.0;                            ///< Of the calling thread alone, at the end [s].
    [[nodiscard]] double work() const noexcept;    ///< Of one thread: everything [s].
    [[nodiscard]] double serial() const noexcept;  ///< Outside loops [s].
    /// Of any number of threads that cost nothing: what must wait for each other [s].
    [[nodiscard]] double critical() const;
};

/// What dealing out tasks costs; zero on one thread, and where a loop has one task.
struct PoolCosts {
    double start = 0.0;  ///< Until another thread has begun its first task of a loop [s].
    double join = 0.0;   ///< From the end of the last task until the caller goes on [s].
    double wake = 0.0;   ///< From the start of the program until the other threads are awake [s].
    double deal = 0.0;   ///< Of taking a task; one thread at a time takes one [s].
};

/// Of this machine, measured on two threads; takes a tenth of a second, more where other programs
/// have the second processor. A tenth of the samples are shorter: disturbances only lengthen them.
[[nodiscard]] PoolCosts measure_pool_costs();

struct Simulated {
    double seconds = 0.0;      ///< Of the whole program.
    double busy = 0.0;         ///< Of all threads: tasks, and code of the caller alone [s].
    std::vector<double> loop;  ///< Of each loop from start to join [s].
};

/// @param spans  Where given, receives loops and tasks as a trace of such a run would show them.
[[nodiscard]] Simulated simulate(const ProgramTimes& program, int threads, const PoolCosts& costs,
                                 std::vector<TraceSpan>* spans = nullptr);

/// The program that one thread ran from `begin` to `end` [s]; the trace has all of it.
[[nodiscard]] ProgramTimes program_of(const TraceView& trace, double begin, double end);

}  // namespace hawser
