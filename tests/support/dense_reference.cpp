// SPDX-License-Identifier: Apache-2.0
#include "support/dense_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace hawser::test {
namespace {

using Real = long double;
using Index = Eigen::Index;

/// Rows of a square matrix in sequence; `at(i, j)`.
template <class T>
struct Square {
    explicit Square(Index size) : n(size), entry(static_cast<std::size_t>(size * size)) {}
    T& operator()(Index i, Index j) { return entry[static_cast<std::size_t>(i * n + j)]; }
    Index n;
    std::vector<T> entry;
};

/// Move the largest entry of the remaining matrix to (step, step).
void pivot(Square<Real>& a, std::vector<Real>& y, std::vector<Index>& column, Index step) {
    Index row = step, col = step;
    for (Index i = step; i < a.n; ++i)
        for (Index j = step; j < a.n; ++j)
            if (std::abs(a(i, j)) > std::abs(a(row, col))) {
                row = i;
                col = j;
            }
    for (Index j = 0; j < a.n; ++j) std::swap(a(step, j), a(row, j));
    std::swap(y[static_cast<std::size_t>(step)], y[static_cast<std::size_t>(row)]);
    for (Index i = 0; i < a.n; ++i) std::swap(a(i, step), a(i, col));
    std::swap(column[static_cast<std::size_t>(step)], column[static_cast<std::size_t>(col)]);
}

/// Rotate in the plane of p and q so that a(p, q) becomes zero.
void rotate(Square<double>& a, Square<double>& v, Index p, Index q) {
    const double theta = 0.5 * (a(q, q) - a(p, p)) / a(p, q);
    const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
    const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
    const double move = t * a(p, q);
    for (Index k = 0; k < a.n; ++k) {
        if (k != p && k != q) {
            const double kp = a(k, p), kq = a(k, q);
            a(k, p) = a(p, k) = c * kp - s * kq;
            a(k, q) = a(q, k) = s * kp + c * kq;
        }
        const double vp = v(k, p), vq = v(k, q);
        v(k, p) = c * vp - s * vq;
        v(k, q) = s * vp + c * vq;
    }
    a(p, p) -= move;
    a(q, q) += move;
    a(p, q) = a(q, p) = 0.0;
}

}  // namespace

Eigen::VectorXd solve_dense(const Eigen::MatrixXd& k, const Eigen::VectorXd& b) {
    const Index n = k.rows();
    Square<Real> a(n);
    std::vector<Real> y(b.data(), b.data() + b.size());
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) a(i, j) = k(i, j);
    std::vector<Index> column(static_cast<std::size_t>(n));
    std::iota(column.begin(), column.end(), Index{0});
    const auto at = [&](Index i) -> Real& { return y[static_cast<std::size_t>(i)]; };

    Index rank = 0;
    for (; rank < n; ++rank) {
        pivot(a, y, column, rank);
        if (a(rank, rank) == 0.0L) break;
        for (Index i = rank + 1; i < n; ++i) {
            const Real factor = a(i, rank) / a(rank, rank);
            if (factor == 0.0L) continue;
            for (Index j = rank + 1; j < n; ++j) a(i, j) -= factor * a(rank, j);
            at(i) -= factor * at(rank);
        }
    }
    Eigen::VectorXd x(n);
    for (Index i = 0; i < n; ++i) x[i] = 0.0;
    for (Index i = rank; i-- > 0;) {
        for (Index j = i + 1; j < rank; ++j) at(i) -= a(i, j) * at(j);
        at(i) /= a(i, i);
        x[column[static_cast<std::size_t>(i)]] = static_cast<double>(at(i));
    }
    return x;
}

Spectrum spectrum(const Eigen::MatrixXd& symmetric) {
    constexpr int kSweeps = 60;  // converges quadratically: about ten are sufficient
    const Index n = symmetric.rows();
    Square<double> a(n), v(n);
    for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) a(i, j) = 0.5 * (symmetric(i, j) + symmetric(j, i));
        v(i, i) = 1.0;
    }
    bool changed = true;
    for (int sweep = 0; changed; ++sweep) {
        if (sweep == kSweeps) throw std::runtime_error("Jacobi's rotations do not converge");
        changed = false;
        for (Index p = 0; p < n; ++p)
            for (Index q = p + 1; q < n; ++q) {
                // A rotation would change neither eigenvalue nor its vector.
                const double small = 1e-18 * (std::abs(a(p, p)) + std::abs(a(q, q)));
                if (std::abs(a(p, q)) <= small) continue;
                rotate(a, v, p, q);
                changed = true;
            }
    }
    Spectrum out{Eigen::VectorXd(n), Eigen::MatrixXd(n, n)};
    for (Index j = 0; j < n; ++j) {
        out.values[j] = a(j, j);
        for (Index i = 0; i < n; ++i) out.vectors(i, j) = v(i, j);
    }
    return out;
}

}  // namespace hawser::test
