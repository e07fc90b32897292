// SPDX-License-Identifier: Apache-2.0
#include "base/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace hawser::base {
namespace {

template <class Matrix>
auto values_of(const Matrix& a) {
    return Eigen::SelfAdjointEigenSolver<Matrix>(a, Eigen::EigenvaluesOnly).eigenvalues().eval();
}

template <int N, class Matrix>
SymmetricEigen<N> eigen_of(const Matrix& a) {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(a);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace

Vec3 symmetric_eigenvalues(const Mat3& a) { return values_of(a); }
Vec6 symmetric_eigenvalues(const Mat6& a) { return values_of(a); }
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& a) { return values_of(a); }

SymmetricEigen<3> symmetric_eigen(const Mat3& a) { return eigen_of<3>(a); }
SymmetricEigen<6> symmetric_eigen(const Mat6& a) { return eigen_of<6>(a); }
SymmetricEigen<Eigen::Dynamic> symmetric_eigen(const Eigen::MatrixXd& a) {
    return eigen_of<Eigen::Dynamic>(a);
}

SymmetricEigen<Eigen::Dynamic> tridiagonal_eigen(const Eigen::VectorXd& diagonal,
                                                 const Eigen::VectorXd& beside) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, beside);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

GeneralEigen general_eigen(const Eigen::MatrixXd& a) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return a.colPivHouseholderQr().solve(b);
}

Vec3 solve_lu(const Mat3& a, const Vec3& b) { return a.partialPivLu().solve(b); }

Mat6 inverse(const Mat6& a) { return a.inverse(); }

Vec3 solve_ldlt(const Mat3& a, const Vec3& b) { return a.ldlt().solve(b); }

MatUpTo6 solve_cholesky(const MatUpTo6& a, const MatUpTo6& b) { return a.llt().solve(b); }

}  // namespace hawser::base
