// SPDX-License-Identifier: Apache-2.0
/// Decompositions of base/dense.h against the identities that define them.
#include "base/dense.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Random& random, int rows, int columns) {
    MatrixXd m(rows, columns);
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) m(i, j) = random.uniform(-1.0, 1.0);
    return m;
}

MatrixXd random_symmetric(Random& random, int n) {
    const MatrixXd m = random_matrix(random, n, n);
    return m + m.transpose();
}

/// Make a diagonally dominant matrix with a condition number of at most 3.
MatrixXd random_definite(Random& random, int n) {
    return random_symmetric(random, n) + 4.0 * n * MatrixXd::Identity(n, n);
}

/// Check A V = V Λ, VᵀV = 1, ascending values, and that values alone are the same.
template <class Matrix>
void check_symmetric(const Matrix& a) {
    const auto eigen = base::symmetric_eigen(a);
    const MatrixXd vectors = eigen.vectors;
    const VectorXd values = eigen.values;
    const Eigen::Index n = a.rows();
    const MatrixXd rest = MatrixXd(a) * vectors - vectors * MatrixXd(values.asDiagonal());
    EXPECT_LT(rest.norm(), 1e-13 * static_cast<double>(n));
    EXPECT_LT((vectors.transpose() * vectors - MatrixXd::Identity(n, n)).norm(), 1e-13);
    for (Eigen::Index i = 1; i < n; ++i) EXPECT_LE(values[i - 1], values[i]);
    EXPECT_LT((VectorXd(base::symmetric_eigenvalues(a)) - values).norm(), 1e-13);
}

TEST(Dense, DecomposesSymmetricMatrices) {
    Random random(1);
    for (int k = 0; k < 20; ++k) {
        check_symmetric(Mat3(random_symmetric(random, 3)));
        check_symmetric(base::Mat6(random_symmetric(random, 6)));
        check_symmetric(random_symmetric(random, 1 + k));
    }
}

TEST(Dense, DecomposesTridiagonalMatrices) {
    Random random(2);
    constexpr int n = 9;
    const VectorXd diagonal = random_matrix(random, n, 1), beside = random_matrix(random, n - 1, 1);
    MatrixXd a = diagonal.asDiagonal();
    for (int i = 0; i + 1 < n; ++i) a(i, i + 1) = a(i + 1, i) = beside[i];
    const auto eigen = base::tridiagonal_eigen(diagonal, beside);
    const MatrixXd rest = a * eigen.vectors - eigen.vectors * MatrixXd(eigen.values.asDiagonal());
    EXPECT_LT(rest.norm(), 1e-13);
    EXPECT_LT((base::symmetric_eigenvalues(a) - eigen.values).norm(), 1e-13);
}

TEST(Dense, DecomposesGeneralMatrices) {
    Random random(3);
    for (int n = 1; n < 12; ++n) {
        const MatrixXd a = random_matrix(random, n, n);
        const base::GeneralEigen eigen = base::general_eigen(a);
        for (int i = 0; i < n; ++i) {
            const Eigen::VectorXcd v = eigen.vectors.col(i);
            EXPECT_NEAR(v.norm(), 1.0, 1e-13);
            EXPECT_LT((a * v.real() - (eigen.values[i] * v).real()).norm(), 1e-12);
            EXPECT_LT((a * v.imag() - (eigen.values[i] * v).imag()).norm(), 1e-12);
        }
    }
}

TEST(Dense, SolvesLinearSystems) {
    Random random(4);
    for (int k = 0; k < 20; ++k) {
        const Mat3 a = random_definite(random, 3);
        const Vec3 b = random.vector(1.0);
        EXPECT_LT((a * base::solve_lu(a, b) - b).norm(), 1e-14);
        EXPECT_LT((a * base::solve_ldlt(a, b) - b).norm(), 1e-14);
        const base::Mat6 m = random_definite(random, 6);
        EXPECT_LT((m * base::inverse(m) - base::Mat6::Identity()).norm(), 1e-14);
        const int n = 1 + k % 6;
        const base::MatUpTo6 d = random_definite(random, n), r = random_matrix(random, n, n);
        EXPECT_LT((d * base::solve_cholesky(d, r) - r).norm(), 1e-14);
    }
}

TEST(Dense, LeavesResidualsSquareToColumns) {
    Random random(5);
    for (int n = 1; n < 6; ++n) {
        const MatrixXd a = random_matrix(random, 20, n), b = random_matrix(random, 20, 3);
        const MatrixXd x = base::least_squares(a, b);
        EXPECT_LT((a.transpose() * (a * x - b)).norm(), 1e-13);
    }
}

TEST(Dense, SetsUnknownsOfDependentColumnsToZero) {
    Random random(6);
    MatrixXd a = random_matrix(random, 20, 3);
    a.col(2) = a.col(0);
    const MatrixXd b = random_matrix(random, 20, 1);
    const MatrixXd x = base::least_squares(a, b);
    EXPECT_LT((a.transpose() * (a * x - b)).norm(), 1e-13);
    EXPECT_EQ(x(0, 0) * x(2, 0), 0.0);
}

}  // namespace
}  // namespace hawser::test
