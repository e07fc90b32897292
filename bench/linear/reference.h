// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file reference.h
/// Reference solution: a plain up-looking LDLᵀ of the saddle matrix in long double. Rows are
/// eliminated after bodies. The solution is refined in long double until the correction stops
/// decreasing. It shares only the product of blocks with a vector with the solvers compared.

#include "paper_matrix/block_system.h"

#include <vector>

namespace hawser::bench {

struct ReferenceSolution {
    std::vector<double> x;
    double last_correction = 0.0;  ///< Largest relative change of the last refinement kept.
    double growth = 0.0;           ///< Largest |L|.
};

/// @throws std::runtime_error at a pivot of the wrong sign.
[[nodiscard]] ReferenceSolution solve_reference(const BlockSystem& system);

/// Largest error of velocities over the largest velocity, or of multipliers over the largest
/// multiplier, whichever is larger.
[[nodiscard]] double relative_error(const BlockSystem& system, const std::vector<double>& x,
                                    const std::vector<double>& exact);

}  // namespace hawser::bench
