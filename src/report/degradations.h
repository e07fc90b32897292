// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file degradations.h
/// Work that the steps of a run skipped to keep their budget, and the causes.

#include <hawser/stats.h>

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::report {

/// Degraded steps of an interval, from the first to the last.
struct DegradedSpan {
    std::int64_t steps = 0;            ///< Number of degraded steps in the interval.
    std::int64_t first = 0, last = 0;  ///< Step numbers, as in StepStats::step.
    double begin = 0.0, end = 0.0;     ///< Time of the first and of the last step [s].
    std::int32_t iterations =
        0;  ///< Least number of iterations in a limited step; 0: no step was limited.
    std::int32_t wires = 0;                  ///< Highest coarsening level of wires.
    int interfaces = 0;                      ///< Largest number of compliantly coupled interfaces.
    double momentum_defect = 0.0;            ///< Largest StepStats::momentum_defect.
    double cut_defect = 0.0;                 ///< Largest StepStats::cut_defect [N s].
    double foreseen = 0.0;                   ///< Largest StepStats::foreseen_seconds [s].
    double residual = 0.0;                   ///< Largest natural map.
    DegradedBy cause = DegradedBy::nothing;  ///< Cause of the first step.
};

struct Degradations {
    /// Degradations in the order in which the levels are applied. One step may have several levels.
    DegradedSpan all, wires, friction, coupling;
    std::array<std::int64_t, kDegradedByCount> by_cause{};
    std::vector<DegradedSpan>
        list;  ///< Intervals without a gap, in the order of time, at most kListedSpans.
    std::int64_t spans = 0;  ///< Number of intervals, including unlisted ones.

    void after_step(const StepStats& stats);
};
inline constexpr std::size_t kListedSpans = 100;

}  // namespace hawser::report
