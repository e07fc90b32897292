// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file matrices.h
/// Quasi-definite block matrices for tests of the solver, and functions to factor them.

#include "base/executor.h"
#include "factor/analyse.h"
#include "factor/kernels.h"
#include "factor/numeric.h"
#include "factor/ordering.h"
#include "factor/symbolic.h"
#include "support/dense_reference.h"
#include "support/random.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace hawser::test {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// A block pattern with values, in the order of the nodes.
struct BlockMatrix {
    factor::Pattern pattern;
    std::vector<int> offset;  ///< First scalar of each node, and the end.
    Matrix dense;             ///< The symmetric matrix.

    [[nodiscard]] int scalars() const { return offset.back(); }
    [[nodiscard]] auto block(int a, int b) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        return dense.block(offset[i], offset[j], offset[i + 1] - offset[i],
                           offset[j + 1] - offset[j]);
    }
};

/// Make a pattern from nodes and edges; values are set later.
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

/// Make a positive or negative definite matrix with condition about 10: A Aᵀ + E, scaled.
inline Matrix definite(Random& random, int size, double scale, int sign) {
    const Matrix a = random_matrix(random, size, size);
    return sign * scale * (a * a.transpose() + Matrix::Identity(size, size));
}

/// Make a random quasi-definite matrix. Positive blocks couple weakly to each other: diagonal
/// dominance keeps their part definite. Rows couple to bodies in any way.
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
        // Gershgorin: at most `nodes` neighbours of six scalars of this size sum to less than 1.
        const double scale = same ? 0.9 / (6.0 * nodes) : 1.0;
        set_symmetric(m, i, j, scale * random_matrix(random, size[a], size[b]));
    }
    return m;
}

/// Make hubs with random links, joined by wires of any length. Each wire has one size of bodies.
/// Variants: with or without bending over two neighbours, with or without rows, attached to a hub,
/// free at an end, with a row of its own at an end.
inline BlockMatrix wires(Random& random, int max_wires, int longest) {
    std::vector<std::int8_t> size, sign;
    std::vector<std::pair<int, int>> edges;
    auto node = [&](int scalars, int s) {
        size.push_back(static_cast<std::int8_t>(scalars));
        sign.push_back(static_cast<std::int8_t>(s));
        return static_cast<int>(size.size()) - 1;
    };
    std::vector<int> hubs;
    for (int i = random.integer(1, 5); i > 0; --i) {
        hubs.push_back(node(6, 1));
        if (hubs.size() > 1 && random.chance(0.5)) edges.emplace_back(hubs[0], hubs.back());
    }
    for (int wire = random.integer(1, max_wires); wire > 0; --wire) {
        const int length = random.integer(1, longest), scalars = random.chance(0.5) ? 3 : 6;
        const bool bends = random.chance(0.5), rows = random.chance(0.6);
        const int hub = hubs[static_cast<std::size_t>(
                      random.integer(0, static_cast<int>(hubs.size()) - 1))],
                  deck = random.chance(0.2) ? hub : -1;
        std::vector<int> bodies;
        auto join = [&](int a, int b) {
            edges.emplace_back(a, b);
            if (!rows) return;
            const int row = node(random.chance(0.9) ? 3 : random.integer(1, 5), -1);
            edges.emplace_back(row, a);
            edges.emplace_back(row, b);
            if (bends && bodies.size() > 2 && random.chance(0.5))
                edges.emplace_back(row, bodies[bodies.size() - 3]);
        };
        for (int i = 0; i < length; ++i) {
            bodies.push_back(node(scalars, 1));
            if (i > 0) join(bodies[bodies.size() - 2], bodies.back());
            if (bends && i > 1) edges.emplace_back(bodies[bodies.size() - 3], bodies.back());
            if (deck >= 0 && random.chance(0.6)) edges.emplace_back(deck, bodies.back());
        }
        if (random.chance(0.7)) join(bodies.front(), hub);
        if (random.chance(0.7)) join(bodies.back(), hubs[0]);
        if (random.chance(0.3)) edges.emplace_back(bodies.front(), node(3, -1));
        if (random.chance(0.1)) edges.emplace_back(bodies[bodies.size() / 2], hubs.back());
    }
    BlockMatrix m = make_blocks(size, sign, edges);
    for (int i = 0; i < m.pattern.nodes(); ++i) {
        const auto a = static_cast<std::size_t>(i);
        m.block(i, i) = definite(random, size[a], 1.0, sign[a]);
        for (std::int32_t j : m.pattern.neighbours(i)) {
            if (j < i) continue;
            const auto b = static_cast<std::size_t>(j);
            const bool same = sign[a] == sign[b];
            const auto most = static_cast<double>(
                std::max(m.pattern.neighbours(i).size(), m.pattern.neighbours(j).size()));
            const double scale = same ? 0.9 / (6.0 * most) : 1.0;
            set_symmetric(m, i, j, scale * random_matrix(random, size[a], size[b]));
        }
    }
    return m;
}

/// Write the blocks of the columns for which wanted(node) is true: the lower half or the transposed
/// upper one.
template <class Wanted>
inline void fill_columns(const BlockMatrix& m, const factor::Symbolic& s, double* values,
                         Wanted&& wanted, bool upper = false) {
    auto put = [&](int row, int column) {
        if (!wanted(column)) return;
        const factor::BlockTarget t = s.target(row, column);
        const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
        for (int j = 0; j < m.pattern.size[c]; ++j)
            for (int i = 0; i < m.pattern.size[r]; ++i) {
                const int k = m.offset[r] + i, l = m.offset[c] + j;
                values[t.address + static_cast<std::int64_t>(j) * t.ld +
                       static_cast<std::int64_t>(i) * t.step] =
                    upper ? m.dense(l, k) : m.dense(k, l);
            }
    };
    for (int a = 0; a < m.pattern.nodes(); ++a) {
        put(a, a);
        for (std::int32_t b : m.pattern.neighbours(a))
            if (s.position[static_cast<std::size_t>(b)] < s.position[static_cast<std::size_t>(a)])
                put(a, b);
    }
}

inline void fill(const BlockMatrix& m, const factor::Symbolic& s, double* values) {
    fill_columns(m, s, values, [](int) { return true; });
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
    return solve(m, factor::analyse(m.pattern, factor::plan_elimination(m.pattern)), b, serial);
}

/// Return the largest entry of b − K x over ‖K‖ ‖x‖ + ‖b‖ (infinity norms), in long double.
inline double backward_error(const BlockMatrix& m, const Vector& x, const Vector& b) {
    if (b.size() == 0) return 0.0;
    long double most = 0.0L;
    for (Eigen::Index i = 0; i < b.size(); ++i) {
        long double r = b[i];
        for (Eigen::Index j = 0; j < x.size(); ++j)
            r -= static_cast<long double>(m.dense(i, j)) * x[j];
        most = std::max(most, std::abs(r));
    }
    const double k = m.dense.cwiseAbs().rowwise().sum().maxCoeff();
    return static_cast<double>(most) / (k * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
}

/// Solve in long double with full pivoting, as a reference.
inline Vector reference(const BlockMatrix& m, const Vector& b) { return solve_dense(m.dense, b); }

}  // namespace hawser::test
