// SPDX-License-Identifier: Apache-2.0
#include "linear/reference.h"

#include "factor/ordering.h"
#include "index.h"
#include "linear/scalar.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hawser::bench {
namespace {

using Real = long double;

/// L by columns, without the unit diagonal (Davis, "Algorithm 849: a concise sparse Cholesky
/// factorization package", 2005).
struct LongFactor {
    std::vector<std::int64_t> start;
    std::vector<std::int32_t> row, parent, count, flag, path;
    std::vector<Real> value, d, y;

    void structure(const Permuted& m) {
        const std::size_t n = m.order.size();
        parent.assign(n, -1);
        count.assign(n, 0);
        flag.assign(n, -1);
        for (std::size_t k = 0; k < n; ++k) {
            flag[k] = static_cast<std::int32_t>(k);
            for (std::int32_t p = m.start[k]; p < m.start[k + 1]; ++p)
                for (auto i = at(m.row[at(p)]); flag[i] != static_cast<std::int32_t>(k);
                     i = at(parent[i])) {
                    if (parent[i] < 0) parent[i] = static_cast<std::int32_t>(k);
                    ++count[i];
                    flag[i] = static_cast<std::int32_t>(k);
                }
        }
        start.assign(n + 1, 0);
        for (std::size_t k = 0; k < n; ++k) start[k + 1] = start[k] + count[k];
        row.resize(at(start[n]));
        value.resize(at(start[n]));
        d.assign(n, 0);
        y.assign(n, 0);
        path.resize(n);
    }
    /// Find the columns that row k of L meets, in the order of the tree: path[top, n).
    std::size_t meeting_columns(const Permuted& m, std::size_t k) {
        std::size_t top = m.order.size();
        flag[k] = static_cast<std::int32_t>(k);
        for (std::int32_t p = m.start[k]; p < m.start[k + 1]; ++p) {
            auto i = at(m.row[at(p)]);
            y[i] += m.value[at(p)];
            std::size_t length = 0;
            for (; flag[i] != static_cast<std::int32_t>(k); i = at(parent[i])) {
                path[length++] = static_cast<std::int32_t>(i);
                flag[i] = static_cast<std::int32_t>(k);
            }
            while (length > 0) path[--top] = path[--length];
        }
        return top;
    }
    void numbers(const Permuted& m) {
        const std::size_t n = m.order.size();
        std::fill(count.begin(), count.end(), 0);
        std::fill(flag.begin(), flag.end(), -1);
        for (std::size_t k = 0; k < n; ++k) {
            std::size_t top = meeting_columns(m, k);
            d[k] = y[k];
            y[k] = 0;
            for (; top < n; ++top) {
                const auto i = at(path[top]);
                const Real yi = y[i], l = yi / d[i];
                y[i] = 0;
                std::int64_t p = start[i];
                for (; p < start[i] + count[i]; ++p) y[at(row[at(p)])] -= value[at(p)] * yi;
                d[k] -= l * yi;
                row[at(p)] = static_cast<std::int32_t>(k);
                value[at(p)] = l;
                ++count[i];
            }
        }
    }
    void solve(std::vector<Real>& x) const {
        const std::size_t n = d.size();
        for (std::size_t j = 0; j < n; ++j)
            for (std::int64_t p = start[j]; p < start[j + 1]; ++p)
                x[at(row[at(p)])] -= value[at(p)] * x[j];
        for (std::size_t j = 0; j < n; ++j) x[j] /= d[j];
        for (std::size_t j = n; j-- > 0;)
            for (std::int64_t p = start[j]; p < start[j + 1]; ++p)
                x[j] -= value[at(p)] * x[at(row[at(p)])];
    }
};

/// Compute P (b − K x) from the permuted upper triangle.
std::vector<Real> permuted_residual(const Permuted& m, const std::vector<double>& b,
                                    const std::vector<Real>& x) {
    const std::size_t n = m.order.size();
    std::vector<Real> r(n);
    for (std::size_t k = 0; k < n; ++k) r[k] = b[at(m.order[k])];
    for (std::size_t j = 0; j < n; ++j)
        for (std::int32_t p = m.start[j]; p < m.start[j + 1]; ++p) {
            const auto i = at(m.row[at(p)]);
            const Real v = m.value[at(p)];
            r[i] -= v * x[j];
            if (i != j) r[j] -= v * x[i];
        }
    return r;
}

struct Largest {
    Real body = 0, row = 0;
};
template <class V>
Largest largest(const BlockSystem& s, const V& entry) {
    Largest m;
    for (int a = 0; a < s.pattern.nodes(); ++a)
        for (std::int32_t i = s.offset[at(a)]; i < s.offset[at(a) + 1]; ++i) {
            Real& to = s.positive(a) ? m.body : m.row;
            const Real size = std::abs(static_cast<Real>(entry(at(i))));
            if (!(size <= to)) to = size;  // keeps a NaN
        }
    return m;
}

Real ratio(const Largest& a, const Largest& b) {
    return std::max(b.body > 0 ? a.body / b.body : a.body, b.row > 0 ? a.row / b.row : a.row);
}

}  // namespace

ReferenceSolution solve_reference(const BlockSystem& s) {
    Permuted m;
    std::vector<std::int32_t> order;
    for (const std::int32_t a : factor::order_nodes(s.pattern))
        for (std::int32_t i = s.offset[at(a)]; i < s.offset[at(a) + 1]; ++i) order.push_back(i);
    const Sparse lower = s.lower();
    m.build(lower, std::move(order), Triangle::upper);
    for (std::size_t k = 0; k < m.value.size(); ++k) m.value[k] = lower.valuePtr()[m.source[k]];
    LongFactor f;
    f.structure(m);
    f.numbers(m);
    const std::size_t n = f.d.size();
    std::vector<signed char> sign(n);
    for (int a = 0; a < s.pattern.nodes(); ++a)
        std::fill(sign.begin() + s.offset[at(a)], sign.begin() + s.offset[at(a) + 1],
                  s.positive(a) ? 1 : -1);
    for (std::size_t k = 0; k < n; ++k)
        if (!(f.d[k] * sign[at(m.order[k])] > 0))
            throw std::runtime_error("reference: a pivot of the wrong sign");
    ReferenceSolution result;
    for (const Real v : f.value)
        result.growth = std::max(result.growth, static_cast<double>(std::abs(v)));
    std::vector<Real> x(n, 0), natural(n, 0), change(n);
    Real before = 2;
    for (int turn = 0; turn < 8; ++turn) {
        std::vector<Real> dx = permuted_residual(m, s.rhs, x);
        f.solve(dx);
        for (std::size_t k = 0; k < n; ++k) {
            change[at(m.order[k])] = dx[k];
            natural[at(m.order[k])] = x[k] + dx[k];
        }
        const Real now = ratio(largest(s, [&](std::size_t i) { return change[i]; }),
                               largest(s, [&](std::size_t i) { return natural[i]; }));
        if (turn > 0 && !(now < 0.5L * before)) break;
        for (std::size_t k = 0; k < n; ++k) x[k] += dx[k];
        result.last_correction = static_cast<double>(now);
        before = now;
        if (now < 1e-18L) break;
    }
    result.x.resize(n);
    for (std::size_t k = 0; k < n; ++k) result.x[at(m.order[k])] = static_cast<double>(x[k]);
    return result;
}

double relative_error(const BlockSystem& s, const std::vector<double>& x,
                      const std::vector<double>& exact) {
    return static_cast<double>(ratio(largest(s, [&](std::size_t i) { return x[i] - exact[i]; }),
                                     largest(s, [&](std::size_t i) { return exact[i]; })));
}

}  // namespace hawser::bench
