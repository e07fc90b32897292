// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file matrices.h
/// Quasi-definite block matrices for the tests of the solver, and the ways to factor them.

#include "base/executor.h"
#include "factor/kernels.h"
#include "factor/numeric.h"
#include "factor/ordering.h"
#include "factor/symbolic.h"
#include "support/random.h"

#include <Eigen/Dense>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace hawser::test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// A block pattern with values, in the order of the nodes.
struct BlockMatrix {
    factor::Pattern pattern;
    std::vector<int> offset;  ///< First scalar of each node, one more at the end.
    Matrix dense;             ///< Symmetric.

    [[nodiscard]] int scalars() const { return offset.back(); }
    [[nodiscard]] auto block(int a, int b) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        return dense.block(offset[i], offset[j], offset[i + 1] - offset[i],
                           offset[j + 1] - offset[j]);
    }
};

/// Nodes and edges first, values after.
inline BlockMatrix make_blocks(const std::vector<std::int8_t>& size,
                               const std::vector<std::int8_t>& sign,
                               const std::vector<std::pair<int, int>>& edges) {
    BlockMatrix m;
    std::vector<std::int32_t> from, to;
    for (const auto& [a, b] : edges) {
        from.push_back(a);
        to.push_back(b);
    }
    m.pattern = factor::make_pattern(size, sign, from, to);
    m.offset.push_back(0);
    for (std::int8_t s : size) m.offset.push_back(m.offset.back() + s);
    m.dense = Matrix::Zero(m.scalars(), m.scalars());
    return m;
}

inline Matrix random_matrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
    Matrix m(rows, cols);
    for (Eigen::Index j = 0; j < cols; ++j)
        for (Eigen::Index i = 0; i < rows; ++i) m(i, j) = random.uniform(-1, 1);
    return m;
}

inline void set_symmetric(BlockMatrix& m, int a, int b, const Matrix& value) {
    m.block(a, b) = value;
    if (a != b) m.block(b, a) = value.transpose();
}

/// Positive or negative definite with condition about 10: A Aᵀ + E, scaled.
inline Matrix definite(Random& random, int size, double scale, int sign) {
    const Matrix a = random_matrix(random, size, size);
    return sign * scale * (a * a.transpose() + Matrix::Identity(size, size));
}

/// Random quasi-definite matrix: positive blocks couple among themselves only weakly (diagonal
/// dominance keeps that part definite), rows couple to bodies in any way.
inline BlockMatrix random_quasi_definite(Random& random, int nodes, double density) {
    std::vector<std::int8_t> size, sign;
    for (int i = 0; i < nodes; ++i) {
        size.push_back(static_cast<std::int8_t>(random.integer(1, 6)));
        sign.push_back(random.chance(0.6) ? 1 : -1);
    }
    std::vector<std::pair<int, int>> edges;
    for (int i = 0; i < nodes; ++i)
        for (int j = 0; j < i; ++j)
            if (random.chance(density)) edges.emplace_back(i, j);
    BlockMatrix m = make_blocks(size, sign, edges);
    for (int i = 0; i < nodes; ++i) {
        const auto k = static_cast<std::size_t>(i);
        m.block(i, i) = definite(random, size[k], 1.0, sign[k]);
    }
    for (const auto& [i, j] : edges) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        const bool same = sign[a] == sign[b];
        // Gershgorin: at most `nodes` neighbours of six scalars of this size stay below 1.
        const double scale = same ? 0.9 / (6.0 * nodes) : 1.0;
        set_symmetric(m, i, j, scale * random_matrix(random, size[a], size[b]));
    }
    return m;
}

inline void fill(const BlockMatrix& m, const factor::Symbolic& s, double* values) {
    auto put = [&](int row, int column) {
        const factor::BlockTarget t = s.target(row, column);
        const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
        for (int j = 0; j < m.pattern.size[c]; ++j)
            for (int i = 0; i < m.pattern.size[r]; ++i)
                values[t.address + static_cast<std::int64_t>(j) * t.ld + i] =
                    m.dense(m.offset[r] + i, m.offset[c] + j);
    };
    for (int a = 0; a < m.pattern.nodes(); ++a) {
        put(a, a);
        for (std::int32_t b : m.pattern.neighbours(a))
            if (s.position[static_cast<std::size_t>(b)] < s.position[static_cast<std::size_t>(a)])
                put(a, b);
    }
}

inline Vector permuted(const BlockMatrix& m, const factor::Symbolic& s, const Vector& x,
                       bool back) {
    Vector y(x.size());
    for (std::size_t n = 0; n < m.pattern.size.size(); ++n)
        for (int i = 0; i < m.pattern.size[n]; ++i) {
            if (back)
                y[m.offset[n] + i] = x[s.node_offset[n] + i];
            else
                y[s.node_offset[n] + i] = x[m.offset[n] + i];
        }
    return y;
}

struct Solved {
    int wrong = 0;
    Vector x;
};

/// Factor and solve through the public path.
inline Solved solve(const BlockMatrix& m, const factor::Symbolic& s, const Vector& b,
                    base::Executor& executor) {
    factor::Numeric numeric;
    numeric.reserve(s, executor.threads());
    numeric.clear(s, executor);
    fill(m, s, numeric.values());
    Solved out;
    out.wrong = numeric.factor(s, executor);
    Vector y = Vector::Zero(b.size() + 8);
    y.head(b.size()) = permuted(m, s, b, false);
    numeric.solve(s, y.data(), executor);
    out.x = permuted(m, s, y.head(b.size()), true);
    return out;
}

inline Solved solve(const BlockMatrix& m, const Vector& b) {
    base::SerialExecutor serial;
    return solve(m, factor::analyse(m.pattern, factor::order_nodes(m.pattern)), b, serial);
}

/// Largest entry of b − K x over ‖K‖ ‖x‖ + ‖b‖ (infinity norms), in long double.
inline double backward_error(const BlockMatrix& m, const Vector& x, const Vector& b) {
    if (b.size() == 0) return 0.0;
    const LongVector r =
        b.cast<long double>() - m.dense.cast<long double>() * x.cast<long double>();
    const double k = m.dense.cwiseAbs().rowwise().sum().maxCoeff();
    return static_cast<double>(r.cwiseAbs().maxCoeff()) /
           (k * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
}

/// Reference in long double with full pivoting.
inline Vector reference(const BlockMatrix& m, const Vector& b) {
    return Eigen::FullPivLU<LongMatrix>(m.dense.cast<long double>())
        .solve(b.cast<long double>())
        .cast<double>();
}

}  // namespace hawser::test
