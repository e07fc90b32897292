// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file measure.h
/// Quality of a partition or an order: exact counts of the factor, and time.

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

/// Number of flops beyond which no factorisation is timed: some seconds each and gigabytes. An
/// order that eliminates the hub of a large star early leaves a dense matrix.
constexpr std::int64_t kMaxFlops = 100'000'000'000;

/// Return the median processor time of f() [s]; at least `least` runs.
[[nodiscard]] double median_seconds(const std::function<void()>& f, int least);

/// Return the median processor time of one factorisation by the solver on one thread for an order
/// [s].
[[nodiscard]] double factor_seconds(const factor::Pattern& pattern,
                                    const std::vector<std::int32_t>& order, int least);

/// Return factor_seconds() in ms, with a number of runs by the size of the case; NaN if `counts`
/// exceed kMaxFlops.
[[nodiscard]] double factor_ms(const PartCase& c, const std::vector<std::int32_t>& order,
                               const FactorCounts& counts);

/// Return the cost of each node's pivots inside a part, as costs of a next partition. Nodes between
/// parts are expensive because they come last: they get the mean of their neighbours inside. Others
/// are as counted.
[[nodiscard]] std::vector<std::int64_t> inside_costs(const factor::Pattern& pattern,
                                                     const std::vector<std::int32_t>& part,
                                                     const std::vector<std::int64_t>& counted);

struct PartRow {
    std::string method;
    double seconds = 0.0;             ///< Time of the partition [s].
    int separators = 0, scalars = 0;  ///< Bodies and their scalars between parts.
    int cut = 0;                      ///< Interactions with a body between parts.
    double imbalance = 1.0;           ///< Exact flops of the largest part over the mean.
    double largest = 0.0;             ///< Flops of the most expensive body over the mean part.
    double fill = 1.0;                ///< nnz(L) over that of AMD.
    double flops = 1.0;               ///< Flops over those of AMD.
    double makespan = 1.0;            ///< Largest part and all separators, over AMD's flops.
    double factor_ms = 0.0;           ///< One thread; NaN: not timed, see kMaxFlops.
    FactorCounts counts;
};
[[nodiscard]] PartRow measure_parts(const std::string& method, const PartCase& c,
                                    const std::vector<std::int32_t>& part, int parts,
                                    const FactorCounts& amd);

}  // namespace hawser::bench
