// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file schedule.h
/// Prediction of the run time on any number of threads from task times measured on one.
///
/// A step consists of *loops* of independent tasks, with code between them on the calling thread
/// only. Tasks of a loop are assigned in order, each to the first free thread
/// (src/runtime/tasks.h). If tasks depend on each other, a free thread executes the most urgent
/// ready one (src/factor/task_graph.h). A loop ends with its last task. From the times of all tasks
/// and of the code between, this file simulates the assignment for any number of threads:
///
/// ```
/// caller   before ─┬─ task 0 ── task 2 ─┬─ before ─┬─ …
/// worker           └─ task 1 ── task 3 ─┘          └─ …
///               start                 join
/// ```
/// Limits: effects of threads on each other through caches and memory are not modelled. A
/// prediction shows the limit by the order of the work. It is compared with measurements on two
/// threads.

#include <hawser/trace.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// Loop whose tasks run on any thread.
struct LoopTimes {
    double before = 0.0;       ///< Time on the calling thread since the last loop [s].
    std::vector<double> task;  ///< Time of each task, in order of assignment [s].
    TaskWaits waits{};         ///< Dependencies of the tasks.
    std::int8_t stage = -1;    ///< As TraceSpan::stage.
    /// Return the longest sum of dependent tasks [s].
    [[nodiscard]] double critical() const;
};

/// Times of a program: loops, and code of the calling thread.
struct ProgramTimes {
    std::vector<LoopTimes> loops;
    double after = 0.0;  ///< Time on the calling thread after the last loop [s].
    /// Return the total time on one thread [s].
    [[nodiscard]] double work() const noexcept;
    /// Return the time outside loops [s].
    [[nodiscard]] double serial() const noexcept;
    /// Return the time with unlimited threads at no overhead: the longest sum of dependent work
    /// [s].
    [[nodiscard]] double critical() const;
};

/// Overhead of the assignment of tasks; zero on one thread, and for loops with one task.
struct PoolCosts {
    double start = 0.0;  ///< Time until another thread has started its first task of a loop [s].
    double join = 0.0;   ///< Time from the end of the last task until the caller continues [s].
    double wake = 0.0;   ///< Time from the start of the program until the other threads are awake
                         ///< [s].
    double deal = 0.0;   ///< Time to fetch a task, one thread at a time [s].
};

/// Measure the overheads of this machine on two threads. Takes about 0.1 s, or longer if other
/// programs use the second processor. The result is the lowest decile, since disturbances only
/// lengthen samples.
[[nodiscard]] PoolCosts measure_pool_costs();

/// Simulated run of a program.
struct Simulated {
    double seconds = 0.0;  ///< Time of the whole program [s].
    double busy = 0.0;     ///< Busy time of all threads, in tasks and in code of the caller [s].
    std::vector<double> loop;  ///< Time of each loop from start to join [s].
};

/// Simulate a program on a number of threads.
/// @param spans  If given, receives loops and tasks like a trace of such a run.
[[nodiscard]] Simulated simulate(const ProgramTimes& program, int threads, const PoolCosts& costs,
                                 std::vector<TraceSpan>* spans = nullptr);

/// Return the program that one thread ran from `begin` to `end` [s]. The trace must contain all of
/// it.
[[nodiscard]] ProgramTimes program_of(const TraceView& trace, double begin, double end);

}  // namespace hawser
