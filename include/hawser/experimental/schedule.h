// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file schedule.h
/// Prediction of the run time on any number of threads from task times measured on one.
///
/// A step consists of *loops* of independent tasks, and of code between them that only the calling
/// thread runs. Tasks of a loop are assigned in order, each to the first free thread
/// (src/runtime/tasks.h). If tasks depend on each other, a free thread runs the ready task with the
/// lowest rank (src/factor/task_graph.h). A loop ends with its last task. The functions of this
/// header take the measured times of all tasks and of the code between them, and simulate the
/// assignment for any number of threads:
///
/// ```
/// caller   before ─┬─ task 0 ── task 2 ─┬─ before ─┬─ …
/// worker           └─ task 1 ── task 3 ─┘          └─ …
///               start                 join
/// ```
/// Limits: effects of threads on each other through caches and memory are not modelled. A
/// prediction is therefore a lower bound of the time, which follows from the order of the work.
/// Tests compare it with measurements on two threads.

#include <hawser/trace.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// Measured times of a loop, whose tasks run on any thread.
struct LoopTimes {
    double before = 0.0;       ///< Time on the calling thread since the last loop [s].
    std::vector<double> task;  ///< Time of each task, in order of assignment [s].
    TaskWaits waits{};         ///< Dependencies of the tasks; empty: independent.
    std::int8_t stage = -1;    ///< Stage, as TraceSpan::stage.
    /// Return the largest sum of the times of tasks that must run in succession [s].
    [[nodiscard]] double critical() const;
};

/// Measured times of a program: loops, and code of the calling thread between them.
struct ProgramTimes {
    std::vector<LoopTimes> loops;  ///< Loops in order.
    double after = 0.0;            ///< Time on the calling thread after the last loop [s].
    /// Return the total time on one thread [s].
    [[nodiscard]] double work() const noexcept;
    /// Return the time outside loops [s].
    [[nodiscard]] double serial() const noexcept;
    /// Return the time with an unlimited number of threads and without overhead [s].
    [[nodiscard]] double critical() const;
};

/// Overheads of the assignment of tasks. They are zero with one thread, and for loops with one
/// task.
struct PoolCosts {
    double start = 0.0;  ///< Time until another thread has started its first task of a loop [s].
    double join = 0.0;   ///< Time from the end of the last task until the caller continues [s].
    double wake =
        0.0;  ///< Time from the start of the program until the other threads are awake [s].
    double deal = 0.0;  ///< Time to fetch a task, one thread at a time [s].
};

/// Measure the overheads of this machine on two threads. This takes about 0.1 s, or longer if other
/// programs use the second processor. The result is the lowest decile of the samples, since
/// disturbances only lengthen them.
[[nodiscard]] PoolCosts measure_pool_costs();

/// Result of a simulation.
struct Simulated {
    double seconds = 0.0;  ///< Time of the whole program [s].
    double busy = 0.0;  ///< Sum of the times in which threads are busy with tasks or with code of
                        ///< the caller [s].
    std::vector<double> loop;  ///< Time of each loop from start to join [s].
};

/// Simulate a program on a number of threads.
/// @param spans  If not null, receives the loops and tasks as a trace of the simulated run.
[[nodiscard]] Simulated simulate(const ProgramTimes& program, int threads, const PoolCosts& costs,
                                 std::vector<TraceSpan>* spans = nullptr);

/// Return the times of the program that one thread ran in a trace.
/// @param begin, end  Times in the trace [s]. The trace must contain all spans between them.
[[nodiscard]] ProgramTimes program_of(const TraceView& trace, double begin, double end);

}  // namespace hawser
