// SPDX-License-Identifier: Apache-2.0
/// @file
/// One run of a scene with a load in its middle third, for hawser-bench deadline.
#pragma once

#include "report/degradations.h"

#include <hawser/hawser.h>

#include <array>
#include <string>
#include <vector>

namespace hawser::bench {

inline constexpr int kDeadlinePhases = 3;
inline constexpr int kUncountedSteps = 60;  ///< First steps of a run, before caches are warm.
inline constexpr int kExactRow = 10;        ///< Exact steps in a row that count as exact again.
inline constexpr const char* kPhaseNames[kDeadlinePhases] = {"before", "load", "after"};

struct DeadlineOptions {
    std::string scene = "bench/scenes/frozen/anchor_contact.json";
    std::string control = "bench/scenes/frozen/anchor_lines.control.csv", json;
    double budget_ms = 5.0;
    int stacks = 135, steps = 300, threads = 1;
};

/// Times and errors of a phase of a run.
struct PhaseFigures {
    std::vector<double> cpu, wall, map;  ///< [ms], [ms], [1]
    int contacts = 0, degraded = 0;
    double momentum = 0.0;     ///< Largest relative residual.
    double violation = 0.0;    ///< [m]
    double drift = 0.0;        ///< Σ |unexplained energy| of single steps [J].
    double exchanged = 0.0;    ///< Σ |change of kinetic + potential energy| [J].
    double penetration = 0.0;  ///< [m]
    double speed = 0.0;        ///< [m/s]
};

struct DeadlineRun {
    std::array<PhaseFigures, kDeadlinePhases> phase;
    std::vector<Degradation> left_out;  ///< By step.
    report::Degradations log;
    std::vector<Vec3> at_end_of_load;  ///< Positions of the boxes.
    std::uint64_t hash = 0;
    double step = 0.0;     ///< h [s]
    int exact_after = -1;  ///< Steps until the first of kExactRow exact ones in a row.
    /// Steps beyond the budget: in which something was analysed; of one iteration; of more.
    int late_analysis = 0, late_one = 0, late_more = 0;
};

/// Run the scene. @param repeat  Degradations to impose; null: as the budget [ms] requires, 0:
/// none.
[[nodiscard]] DeadlineRun run_deadline(const DeadlineOptions& options, double budget_ms,
                                       const DeadlineRun* repeat);

}  // namespace hawser::bench
