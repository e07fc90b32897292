// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file factors.h
/// Benefit of a partition for the solver: factorisation and solution with its separators last.

#include "partition/cases.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace hawser::bench {

/// Time of a factorisation and a solution by hawser/factor.h [s]: the first decile of many samples
/// in turns.
struct FactorTimes {
    int threads = 1;
    double ours = 0.0;   ///< Separators of Hawser's parts last.
    double metis = 0.0;  ///< Separators of METIS's parts last.
    double amd = 0.0;    ///< AMD's order, without parts.
};

/// Measure and print times for one thread and two; empty without METIS. @param turns  Number of
/// turns of twenty each.
[[nodiscard]] std::vector<FactorTimes> compare_factors(const PartCase& c, int parts, int turns);
[[nodiscard]] nlohmann::json factor_json(const std::vector<FactorTimes>& times);

}  // namespace hawser::bench
