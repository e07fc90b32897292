// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file fraction_of.h
/// Quantiles of measurements.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hawser::bench {

/// Return the quantile of a fraction, such as 0.5 for the median; 0 if empty.
inline double fraction_of(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

}  // namespace hawser::bench
