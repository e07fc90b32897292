// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file factors.h
/// Benefit of a partition for the solver: factorisation and solution with its separators last.

#include "partition/cases.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace hawser::bench {

/// Time of a factorisation and a solution by hawser/factor.h [s]: the lowest tenth of many samples,
/// taken alternately.
struct FactorTimes {
    int threads = 1;
    double ours = 0.0;   ///< With separators of our parts last.
    double metis = 0.0;  ///< Those of METIS's.
    double amd = 0.0;    ///< With the order of AMD, without parts.
};

/// Compare and print the times on one thread and two; empty without METIS. @param turns  Number of
/// turns, each of twenty calls.
[[nodiscard]] std::vector<FactorTimes> compare_factors(const PartCase& c, int parts, int turns);
[[nodiscard]] nlohmann::json factor_json(const std::vector<FactorTimes>& times);

}  // namespace hawser::bench
