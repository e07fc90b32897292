// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling_report.h
/// Output of hawser-bench coupling.

#include "coupling_measure.h"
#include "coupling_simulated.h"
#include "coupling_stiffness.h"
#include "verdict.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace hawser::bench::split {

using Json = nlohmann::ordered_json;

/// Results of one coupling.
struct ModeFigures {
    Mode mode;
    Quality quality;
    Stiffness stiffness;       ///< Zeros for exact coupling, which has no cuts, and if not
                               ///< measured.
    std::vector<Timed> timed;  ///< By number of threads.
    SimulatedStep simulated;
};

/// Return a row. Missing values are null: defects of exact coupling, the spectral radius of a run
/// that diverged.
[[nodiscard]] Json row_of(const ModeFigures& f, const CouplingOptions& o);
void print_row(const ModeFigures& f);
/// Print the simulation from steps of one thread, and its difference from two threads.
void print_simulated(const std::vector<ModeFigures>& modes, const CouplingOptions& o);
/// Compare exact, the first mode, with the fastest stable split: the bar on two threads is 15 %.
Json compare_exact(const std::vector<ModeFigures>& modes, const std::string& scene,
                   const CouplingOptions& o, Verdict& verdict);

}  // namespace hawser::bench::split
