// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file report.h
/// Tables, JSON and a picture of the comparison of solvers.

#include "draw/drawing.h"
#include "linear/trial.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace hawser::bench {

/// All results on one problem.
struct ProblemReport {
    std::string name;
    int bodies = 0, scalars = 0, scale = 1;
    double nnz_saddle = 0.0, nnz_condensed = 0.0;  ///< Entries of the lower triangles.
    double reference_correction = -1.0;            ///< −1: no reference was computed.
    std::vector<Result> best, tried;               ///< For each number of threads in turn.
};

/// Print the results of one problem as tables: work, then analysis and size.
void print_report(const ProblemReport& report);

/// Print the gain of more threads: one line for each problem and solver measured with 1 and more.
void print_thread_gain(const std::vector<ProblemReport>& reports);

[[nodiscard]] nlohmann::json to_json(const ProblemReport& report);

/// Draw bars: time of each library over Hawser's for the same problem, one thread, logarithmic.
[[nodiscard]] draw::Drawing ratio_picture(const std::vector<ProblemReport>& reports);

}  // namespace hawser::bench
