// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file schedule.h
/// Hawser's solution on more threads than the machine has: task times of one thread, scheduled by
/// the simulator of hawser/experimental/schedule.h, compared with measurements of two threads.

#include "linear/problem.h"

#include <hawser/experimental/schedule.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace hawser::bench {

/// Measured and predicted times of one part of the work [s].
struct ScheduleTimes {
    double one = 0.0, two = 0.0;            ///< Measured medians.
    double one_best = 0.0, two_best = 0.0;  ///< Measured minima.
    std::vector<double> predicted;          ///< Medians by kScheduleThreads.
    std::vector<double> speed_up;  ///< By kScheduleThreads: work of one thread over `predicted`.
    double serial = 0.0, critical = 0.0;  ///< Medians.
    [[nodiscard]] double deviation() const noexcept { return predicted[1] / two - 1.0; }
};

/// A loop and the code before it, one thread [s].
struct ScheduleLoop {
    std::string phase;
    int tasks = 0;
    double before = 0.0, sum = 0.0;
    double path = 0.0;   ///< With unlimited threads.
    double eight = 0.0;  ///< With eight, from start to join.
};

/// Medians of one phase of the work [s].
struct SchedulePhase {
    std::string name;
    double one = 0.0, two = 0.0;  ///< Measured.
    double predicted = 0.0;       ///< On two threads.
};

struct ScheduleReport {
    std::string name, form;
    ScheduleTimes solve;  ///< Factorisation with its values, and substitution.
    ScheduleTimes whole;  ///< Condense, factor, solve, refine once.
    std::vector<SchedulePhase> phases;
    std::vector<ScheduleLoop> loops;
    int samples = 0, disturbed = 0;  ///< Disturbed: a thread lost its processor.
    bool quiet = false;              ///< True if in most samples of two threads both had a
                                     ///< processor.
};

inline constexpr int kScheduleThreads[] = {1, 2, 4, 8, 16, 32, 64};

/// Measure. @param condensed  The form. @param rounds  Samples of each measurement.
[[nodiscard]] ScheduleReport measure_schedule(const ProblemSource& source, bool condensed,
                                              int rounds, const PoolCosts& costs);

void print_schedule_head(const PoolCosts& costs);
void print_schedule(const ScheduleReport& report);
/// Print the bounds of the schedule: every loop with the code before it.
void print_schedule_loops(const ScheduleReport& report);
[[nodiscard]] nlohmann::json to_json(const ScheduleReport& report);

}  // namespace hawser::bench
