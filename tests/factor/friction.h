// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file friction.h
/// Block matrices with unsymmetric blocks like those of friction, and functions to fill and factor
/// them.

#include "factor/matrices.h"
#include "factor/unsymmetric.h"

#include <set>

namespace hawser::test {

/// Add s Jᵀ [1 0; μ 1] J on two bodies: a normal and a tangential row, whose force follows that of
/// the normal row. For |μ| < 2 the symmetric part stays definite, so that every pivot has its sign
/// in any order.
inline void add_friction(BlockMatrix& m, Random& random, int a, int b, double mu) {
    const int na = m.pattern.size[static_cast<std::size_t>(a)],
              nb = m.pattern.size[static_cast<std::size_t>(b)];
    const Matrix j = random_matrix(random, 2, na + nb);
    Matrix coupling(2, 2);
    coupling << 1.0, 0.0, mu, 1.0;
    const Matrix k = random.uniform(0.5, 2.0) * j.transpose() * coupling * j;
    m.block(a, a) += k.topLeftCorner(na, na);
    m.block(a, b) += k.topRightCorner(na, nb);
    m.block(b, a) += k.bottomLeftCorner(nb, na);
    m.block(b, b) += k.bottomRightCorner(nb, nb);
}

/// Add a force to the column of a row that is a node of its own, without the symmetric entry. It is
/// small compared with the definite part, so that every pivot has its sign in any order.
inline void add_kept_friction(BlockMatrix& m, Random& random, int body, int row) {
    const int nb = m.pattern.size[static_cast<std::size_t>(body)],
              nr = m.pattern.size[static_cast<std::size_t>(row)];
    m.block(body, row) += 0.05 * random_matrix(random, nb, nr);
}

/// Add friction on `count` random pairs of neighbours, two bodies or a body and a row. @return the
/// nodes of all unsymmetric blocks, pair by pair; fewer if there are no such pairs.
inline std::vector<std::pair<int, int>> add_frictions(BlockMatrix& m, Random& random, int count) {
    std::vector<std::pair<int, int>> pairs, chosen;
    auto body = [&](int v) { return m.pattern.sign[static_cast<std::size_t>(v)] > 0; };
    for (int a = 0; a < m.pattern.nodes(); ++a)
        for (const std::int32_t b : m.pattern.neighbours(a))
            if (body(a) && (b < a || !body(b))) pairs.emplace_back(a, b);
    for (; count > 0 && !pairs.empty(); --count) {
        const auto& pair =
            pairs[static_cast<std::size_t>(random.integer(0, static_cast<int>(pairs.size()) - 1))];
        if (body(pair.second))
            add_friction(m, random, pair.first, pair.second, random.uniform(-1.5, 1.5));
        else
            add_kept_friction(m, random, pair.first, pair.second);
        chosen.push_back(pair);
    }
    return chosen;
}

/// Return the columns of the three blocks of each pair.
inline std::vector<std::int32_t> columns_of(const std::vector<std::pair<int, int>>& pairs) {
    std::vector<std::int32_t> columns;
    for (const auto& [a, b] : pairs) columns.insert(columns.end(), {a, b});
    return columns;
}

/// Write the upper half, transposed, of the columns for which wanted(node) is true.
template <class Wanted>
inline void fill_upper(const BlockMatrix& m, const factor::Symbolic& s, double* upper,
                       Wanted&& wanted) {
    fill_columns(m, s, upper, wanted, true);
}

inline bool in_set(const factor::Symbolic& s, const factor::Unsymmetric& set, int column) {
    return set.is(s.node_front[static_cast<std::size_t>(column)]);
}

/// Write both halves in the form of the public path.
inline void fill_both(const BlockMatrix& m, const factor::Symbolic& s,
                      const factor::Unsymmetric& set, factor::Numeric& numeric,
                      base::Executor& executor) {
    numeric.clear(s, executor);
    fill(m, s, numeric.values());
    numeric.copy_to_upper(s, set, executor);
    fill_upper(m, s, numeric.upper(), [&](int column) { return in_set(s, set, column); });
}

/// Return the entries below the diagonal of each panel of L, or of Uᵀ. Entries above are not used.
inline std::vector<double> entries_below(const factor::Symbolic& s, const double* panel) {
    std::vector<double> entries;
    for (const factor::Front& f : s.fronts)
        for (std::int64_t c = 0; c < f.p && f.batch < 0; ++c)
            for (std::int64_t r = c + 1; r < f.p + f.q; ++r)
                entries.push_back(panel[f.panel + c * f.ld + r]);
    for (const factor::BatchStep& step : s.batch_steps)
        for (std::int64_t r = 1; r < step.p + step.q; ++r)
            for (std::int64_t c = 0; c < std::min<std::int64_t>(r, step.p); ++c)
                for (std::int64_t lane = 0; lane < factor::kLaneCount; ++lane)
                    entries.push_back(
                        panel[step.panel + factor::kLaneCount * (r * step.p + c) + lane]);
    return entries;
}

template <class T>
inline bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), sizeof(T) * a.size()) == 0;
}

/// Solve for a right-hand side with the additional slots that the solver needs; return the bits of
/// the solution.
inline std::vector<double> solve_bits(const factor::Symbolic& s, factor::Numeric& numeric,
                                      base::Executor& executor, std::uint64_t seed) {
    Random random(seed);
    std::vector<double> x(static_cast<std::size_t>(s.scalars) + 8);
    for (double& v : x) v = random.uniform(-1, 1);
    numeric.solve(s, x.data(), executor);
    x.resize(static_cast<std::size_t>(s.scalars));
    return x;
}

}  // namespace hawser::test
