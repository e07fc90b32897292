// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file degradations.h
/// What the steps of a run left out to keep to its budget, and why.

#include <hawser/stats.h>

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::report {

/// Steps that were degraded, from the first to the last.
struct DegradedSpan {
    std::int64_t steps = 0;                  ///< Degraded ones among them.
    std::int64_t first = 0, last = 0;        ///< Counted as StepStats::step is.
    double begin = 0.0, end = 0.0;           ///< Of the first, and of the last [s].
    std::int32_t iterations = 0;             ///< Fewest where they were limited; 0: nowhere.
    std::int32_t wires = 0;                  ///< Highest level by which wires were coarser.
    int interfaces = 0;                      ///< Most that were coupled compliantly.
    double momentum_defect = 0.0;            ///< Largest StepStats::momentum_defect.
    double cut_defect = 0.0;                 ///< Largest StepStats::cut_defect [N s].
    double foreseen = 0.0;                   ///< Largest StepStats::foreseen_seconds [s].
    double residual = 0.0;                   ///< Largest natural map.
    DegradedBy cause = DegradedBy::nothing;  ///< Of the first.
};

struct Degradations {
    /// The levels in the order in which they are taken: one step may be of several.
    DegradedSpan all, wires, friction, coupling;
    std::array<std::int64_t, kDegradedByCount> by_cause{};
    std::vector<DegradedSpan>
        list;                ///< Without a gap, in the order of time, the first kListedSpans.
    std::int64_t spans = 0;  ///< Listed or not.

    void after_step(const StepStats& stats);
};
inline constexpr std::size_t kListedSpans = 100;

}  // namespace hawser::report
