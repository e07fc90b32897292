// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dense.h
/// Eigenvalues and linear systems of small dense matrices.
///
/// dense.cpp alone instantiates Eigen's decompositions: g++ 12 needs 1 to 7 s for each.
///
/// Functions on matrices of fixed size or of up to 6 rows allocate no memory. No function reports
/// failure. Results are unspecified if an entry is NaN or infinite, or if an iteration does not
/// converge.

#include <hawser/math.h>

namespace hawser::base {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
/// Matrix of up to 6 rows and columns, stored in place.
using MatUpTo6 = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

// --- Symmetric eigenvalues ----------------------------------------------------------------------
// Eigen::SelfAdjointEigenSolver: Householder tridiagonalisation, then implicit QR steps, at most 30
// a row. It reads the lower triangle only. Eigenvalues ascend.

/// Eigenvalues and orthonormal eigenvectors, one column each, of a symmetric matrix.
template <int N>
struct SymmetricEigen {
    Eigen::Matrix<double, N, 1> values;
    Eigen::Matrix<double, N, N> vectors;
};

/// Compute the eigenvalues of a symmetric n × n matrix, n ≥ 1.
[[nodiscard]] Vec3 symmetric_eigenvalues(const Mat3& a);
[[nodiscard]] Vec6 symmetric_eigenvalues(const Mat6& a);
[[nodiscard]] Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& a);

/// Compute eigenvalues and eigenvectors of a symmetric n × n matrix, n ≥ 1.
[[nodiscard]] SymmetricEigen<3> symmetric_eigen(const Mat3& a);
[[nodiscard]] SymmetricEigen<6> symmetric_eigen(const Mat6& a);
[[nodiscard]] SymmetricEigen<Eigen::Dynamic> symmetric_eigen(const Eigen::MatrixXd& a);

/// Compute eigenvalues and eigenvectors of a symmetric tridiagonal matrix.
/// @param diagonal  n entries. @param beside  n − 1 entries next to the diagonal.
[[nodiscard]] SymmetricEigen<Eigen::Dynamic> tridiagonal_eigen(const Eigen::VectorXd& diagonal,
                                                               const Eigen::VectorXd& beside);

// --- General eigenvalues ------------------------------------------------------------------------

/// Eigenvalues and eigenvectors of length 1, one column each, of a real square matrix. The two
/// eigenvalues of a complex pair are adjacent, the one with positive imaginary part first.
struct GeneralEigen {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;
};

/// Compute eigenvalues and eigenvectors of a real n × n matrix: Eigen::EigenSolver, by the real
/// Schur form, at most 40 QR steps a row.
[[nodiscard]] GeneralEigen general_eigen(const Eigen::MatrixXd& a);

// --- Linear systems -----------------------------------------------------------------------------

/// Minimise ‖a x − b‖ of each column of b by QR with column pivots: Eigen::ColPivHouseholderQR.
/// If the remainder of a column is below ε times the longest column, its unknown is 0.
/// @param a  m × n, m ≥ n. @param b  m × k. @return n × k.
[[nodiscard]] Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// Solve a x = b for a regular a by LU with row pivots: Eigen::PartialPivLU.
[[nodiscard]] Vec3 solve_lu(const Mat3& a, const Vec3& b);

/// Invert a regular matrix by LU with row pivots: Eigen::PartialPivLU.
[[nodiscard]] Mat6 inverse(const Mat6& a);

/// Solve a x = b for a symmetric definite a by L D Lᵀ with diagonal pivots: Eigen::LDLT. It reads
/// the lower triangle of a only.
[[nodiscard]] Vec3 solve_ldlt(const Mat3& a, const Vec3& b);

/// Solve a x = b for a symmetric positive definite a by Cholesky's L Lᵀ: Eigen::LLT. It reads the
/// lower triangle of a only.
/// @param a  n × n. @param b  n × k. @return n × k.
[[nodiscard]] MatUpTo6 solve_cholesky(const MatUpTo6& a, const MatUpTo6& b);

}  // namespace hawser::base
