// SPDX-License-Identifier: Apache-2.0
/// Products of a BlockFactor with the values of a matrix, for the comparison with its
/// factorisation.
#include "base/index.h"
#include "world/block_impl.h"

#include <algorithm>
#include <cmath>

namespace hawser {

void BlockFactor::multiply(std::span<const double> values, std::span<const double> x,
                           std::span<double> y) const noexcept {
    const Impl& m = *impl_;
    std::fill(y.begin(), y.end(), 0.0);
    const std::size_t nodes = m.pattern.size.size();
    for (std::size_t v = 0; v < nodes; ++v) {
        const std::int64_t n = m.pattern.size[v], first = m.scalar_begin[v];
        const double* block = values.data() + m.value_begin[v];
        for (std::int64_t i = 0; i < n; ++i)
            for (std::int64_t j = 0; j < n; ++j)
                y[at(first + i)] += block[std::max(i, j) * n + std::min(i, j)] * x[at(first + j)];
    }
    for (std::size_t e = 0; e < m.edges.size(); ++e) {
        const std::size_t r = at(m.edges[e].row), c = at(m.edges[e].column);
        const double* block = values.data() + m.value_begin[nodes + e];
        for (std::int64_t i = 0; i < m.pattern.size[r]; ++i)
            for (std::int64_t j = 0; j < m.pattern.size[c]; ++j) {
                const double k = block[i * m.pattern.size[c] + j];
                y[at(m.scalar_begin[r] + i)] += k * x[at(m.scalar_begin[c] + j)];
                y[at(m.scalar_begin[c] + j)] += k * x[at(m.scalar_begin[r] + i)];
            }
    }
}

double BlockFactor::residual(std::span<const double> values, std::span<const double> x,
                             std::span<const double> b) noexcept {
    Impl& m = *impl_;
    auto largest = [](std::span<const double> v) {
        double most = 0.0, unfit = 0.0;
        for (const double d : v) {
            most = std::max(most, std::abs(d));
            unfit += d - d;  // NaN if d is NaN
        }
        return most + unfit;
    };
    multiply(values, x, m.rest);
    for (std::size_t i = 0; i < b.size(); ++i) m.rest[i] = b[i] - m.rest[i];
    const std::size_t nodes = m.pattern.size.size();
    std::fill(m.row_sum.begin(), m.row_sum.end(), 0.0);
    for (std::size_t k = 0; k < nodes + m.edges.size(); ++k) {
        const bool diagonal = k < nodes;
        const std::size_t r = diagonal ? k : at(m.edges[k - nodes].row);
        const std::size_t c = diagonal ? k : at(m.edges[k - nodes].column);
        const double* block = values.data() + m.value_begin[k];
        for (std::int64_t i = 0; i < m.pattern.size[r]; ++i)
            for (std::int64_t j = 0; j < (diagonal ? i + 1 : m.pattern.size[c]); ++j) {
                const double size = std::abs(block[i * m.pattern.size[c] + j]);
                m.row_sum[at(m.scalar_begin[r] + i)] += size;
                if (!diagonal || j < i) m.row_sum[at(m.scalar_begin[c] + j)] += size;
            }
    }
    const double scale = largest(m.row_sum) * largest(x) + largest(b);
    return scale > 0.0 ? largest(m.rest) / scale : 0.0;
}

Status BlockFactor::refine(std::span<const double> values, std::span<const double> b,
                           std::span<double> x) noexcept {
    Impl& m = *impl_;
    multiply(values, x, m.rest);
    for (std::size_t i = 0; i < b.size(); ++i) m.rest[i] = b[i] - m.rest[i];
    const Status status = solve(m.rest);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += m.rest[i];
    return status;
}

}  // namespace hawser
