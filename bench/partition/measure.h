// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file measure.h
/// What a partition or an order is worth: exact counts of the factor, and time.

#include "factor/pattern.h"
#include "partition/cases.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hawser::bench {

/// Exact counts of L for an order, without the zeros of merged fronts.
struct FactorCounts {
    std::int64_t nnz = 0, flops = 0;
    std::int64_t path = 0;           ///< Flops on the longest path from a leaf to a root.
    std::vector<std::int64_t> node;  ///< Flops of each node's pivots.
};
[[nodiscard]] FactorCounts count_factor(const factor::Pattern& pattern,
                                        const std::vector<std::int32_t>& order);

/// Median processor time of f() [s]; at least `least` runs.
[[nodiscard]] double median_seconds(const std::function<void()>& f, int least);

/// Processor time of one factorisation and solution on one thread for an order, by the solver
/// itself: median [s].
[[nodiscard]] double factor_seconds(const factor::Pattern& pattern,
                                    const std::vector<std::int32_t>& order, int least);

struct PartRow {
    std::string method;
    double seconds = 0.0;             ///< To make the partition [s].
    int separators = 0, scalars = 0;  ///< Bodies and their scalars between parts.
    int cut = 0;                      ///< Interactions with a body between parts.
    double imbalance = 1.0;           ///< Exact flops of the largest part over the mean.
    double largest = 0.0;             ///< Flops of the dearest body over the mean part.
    double fill = 1.0;                ///< nnz(L) over that of AMD.
    double flops = 1.0;               ///< Flops over those of AMD.
    double makespan = 1.0;            ///< Largest part and all separators, over AMD's flops.
    double factor_ms = 0.0;           ///< One thread.
    FactorCounts counts;
};
[[nodiscard]] PartRow measure_parts(const std::string& method, const PartCase& c,
                                    const std::vector<std::int32_t>& part, int parts,
                                    const FactorCounts& amd);

}  // namespace hawser::bench
