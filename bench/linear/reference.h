// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file reference.h
/// Reference solution: an up-looking LDLᵀ of the saddle matrix in long double with rows eliminated
/// after bodies, refined in long double until the correction stops decreasing. It shares only the
/// product of blocks with a vector with the compared solvers.

#include "paper_matrix/block_system.h"

#include <vector>

namespace hawser::bench {

struct ReferenceSolution {
    std::vector<double> x;
    double last_correction = 0.0;  ///< Largest relative change of the last applied refinement.
    double growth = 0.0;           ///< Largest |L|.
};

/// Solve. @throws std::runtime_error at a pivot of the wrong sign.
[[nodiscard]] ReferenceSolution solve_reference(const BlockSystem& system);

/// Return the larger of both relative errors: of velocities over the largest velocity, and of
/// multipliers over the largest multiplier.
[[nodiscard]] double relative_error(const BlockSystem& system, const std::vector<double>& x,
                                    const std::vector<double>& exact);

}  // namespace hawser::bench
