// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dense_reference.h
/// Slow and direct dense linear algebra as a reference. Compiled once: Eigen's own solvers of
/// dynamic size take seconds to compile in each source that uses them.

#include <hawser/math.h>

namespace hawser::test {

/// Solve K x = b in long double with complete pivoting. Unknowns past the rank of K are 0.
[[nodiscard]] Eigen::VectorXd solve_dense(const Eigen::MatrixXd& k, const Eigen::VectorXd& b);

/// A = V diag(values) Vᵀ, values unsorted.
struct Spectrum {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;  ///< Orthonormal columns.
};

/// Decompose a symmetric matrix by Jacobi's rotations until it is diagonal: as exact as the
/// rounding of A (Golub and Van Loan, Matrix Computations, section 8.5).
[[nodiscard]] Spectrum spectrum(const Eigen::MatrixXd& symmetric);

}  // namespace hawser::test
