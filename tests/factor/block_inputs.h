// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_inputs.h
/// Matrices as a user of hawser/factor.h gives them.

#include "factor/matrices.h"

#include <hawser/factor.h>

#include <limits>
#include <vector>

namespace hawser::test {

/// The values as a user gives them.
inline std::vector<double> values_of(BlockMatrix& m, const BlockPattern& p, const BlockFactor& f) {
    std::vector<double> values(static_cast<std::size_t>(f.value_count()));
    auto put = [&](std::size_t block, int a, int b) {
        const Matrix k = m.block(a, b);
        auto at = static_cast<std::size_t>(f.value_begin(static_cast<std::int32_t>(block)));
        for (Eigen::Index i = 0; i < k.rows(); ++i)
            for (Eigen::Index j = 0; j < k.cols(); ++j)
                // What is not read may hold anything.
                values[at++] = a == b && j > i ? std::numeric_limits<double>::quiet_NaN() : k(i, j);
    };
    for (std::size_t v = 0; v < p.size.size(); ++v)
        put(v, static_cast<int>(v), static_cast<int>(v));
    for (std::size_t e = 0; e < p.edges.size(); ++e)
        put(p.size.size() + e, p.edges[e].row, p.edges[e].column);
    return values;
}

inline BlockPattern pattern_of(const BlockMatrix& m, Random& random) {
    BlockPattern p;
    p.size = m.pattern.size;
    p.sign = m.pattern.sign;
    for (int a = 0; a < m.pattern.nodes(); ++a)
        for (const std::int32_t b : m.pattern.neighbours(a))
            if (b < a) p.edges.push_back(random.chance(0.5) ? BlockEdge{a, b} : BlockEdge{b, a});
    random.shuffle(p.edges);
    return p;
}

inline BlockMatrix draw_matrix(Random& random, int seed) {
    return seed % 2 == 0 ? wires(random, 8, 40) : random_quasi_definite(random, 40, 0.08);
}

}  // namespace hawser::test
