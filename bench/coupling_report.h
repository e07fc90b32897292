// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling_report.h
/// Printed and stored results of hawser-bench coupling.

#include "coupling_measure.h"
#include "coupling_simulated.h"
#include "coupling_stiffness.h"
#include "verdict.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace hawser::bench::split {

using Json = nlohmann::ordered_json;

/// Measurements of one way to couple.
struct ModeFigures {
    Mode mode;
    Quality quality;
    Stiffness stiffness;  ///< Zeros for exact coupling, which has no cuts, and if not measured.
    std::vector<Timed> timed;  ///< By number of threads.
    SimulatedStep simulated;
};

/// Return one row of results. Figures that a mode does not have are null: errors at cuts for exact
/// coupling, the spectral radius of a run that diverged.
[[nodiscard]] Json row_of(const ModeFigures& f, const CouplingOptions& o);
void print_row(const ModeFigures& f);
/// Print the simulated steps of one thread, and their difference from steps on two threads.
void print_simulated(const std::vector<ModeFigures>& modes, const CouplingOptions& o);
/// Compare the first mode, exact, with the fastest split that remained stable. The bar on two
/// threads is 15 %.
Json compare_exact(const std::vector<ModeFigures>& modes, const std::string& scene,
                   const CouplingOptions& o, Verdict& verdict);

}  // namespace hawser::bench::split
