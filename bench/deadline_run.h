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
inline constexpr int kUncountedSteps = 60;  ///< Steps at the start of a run before memory is warm.
inline constexpr int kExactRow = 10;        ///< Number of exact steps in sequence that counts as a
                                            ///< return to exact steps.
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
    std::vector<Degradation> degradations;  ///< Degradation of each step.
    report::Degradations log;
    std::vector<Vec3> at_end_of_load;  ///< Positions of the boxes.
    std::uint64_t hash = 0;
    double step = 0.0;     ///< h [s]
    int exact_after = -1;  ///< Steps until the first of kExactRow exact steps in sequence.
    /// Steps beyond the budget: with an analysis; with one iteration; with more.
    int late_with_analysis = 0, late_with_one_iteration = 0, late_with_more_iterations = 0;
};

/// Run. @param repeat  Degradations to impose; null: those of the budget. @param budget_ms  0: none
/// [ms].
[[nodiscard]] DeadlineRun run_deadline(const DeadlineOptions& options, double budget_ms,
                                       const DeadlineRun* repeat);

}  // namespace hawser::bench
