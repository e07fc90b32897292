// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling_report.h
/// What hawser-bench coupling prints and keeps of its runs.

#include "coupling_measure.h"
#include "coupling_simulated.h"
#include "coupling_stiffness.h"
#include "verdict.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace hawser::bench::split {

using Json = nlohmann::ordered_json;

/// What was measured of one way to couple.
struct ModeFigures {
    Mode mode;
    Quality quality;
    Stiffness stiffness;       ///< Of exact coupling, which has no cuts, and where left out: zeros.
    std::vector<Timed> timed;  ///< By number of threads.
    SimulatedStep simulated;
};

/// What a mode does not have is null: exact coupling no cuts to be off at, a run that was lost no
/// spectral radius.
[[nodiscard]] Json row_of(const ModeFigures& f, const CouplingOptions& o);
void print_row(const ModeFigures& f);
/// What the simulation of the steps of one thread says, and how far from two threads it is.
void print_simulated(const std::vector<ModeFigures>& modes, const CouplingOptions& o);
/// Exact, the first of all, beside the fastest split that stayed: the bar on two threads is 15 %.
Json compare_exact(const std::vector<ModeFigures>& modes, const std::string& scene,
                   const CouplingOptions& o, Verdict& verdict);

}  // namespace hawser::bench::split
