// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dot.h
/// Scalar product of two vectors of n numbers.

#include <cstddef>

namespace hawser::nonsmooth {

[[nodiscard]] inline double dot(const double* a, const double* b, std::size_t n) noexcept {
    // Use four sums: the compiler may not reorder a single one.
    double s[4] = {};
    std::size_t i = 0;
    for (; i + 4 <= n; i += 4)
        for (std::size_t k = 0; k < 4; ++k) s[k] += a[i + k] * b[i + k];
    for (; i < n; ++i) s[0] += a[i] * b[i];
    return (s[0] + s[1]) + (s[2] + s[3]);
}

}  // namespace hawser::nonsmooth
