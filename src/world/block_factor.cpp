// SPDX-License-Identifier: Apache-2.0
/// The public face of src/factor.
#include "world/block_factor.h"

#include "base/index.h"
#include "world/block_pattern.h"

#include <hawser/world.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hawser {

BlockFactor::BlockFactor(const FactorOptions& options) {
    check_environment();
    impl_ = std::make_unique<Impl>(options);
    analyse({});
}
BlockFactor::~BlockFactor() = default;
BlockFactor::BlockFactor(BlockFactor&&) noexcept = default;
BlockFactor& BlockFactor::operator=(BlockFactor&&) noexcept = default;

void BlockFactor::analyse(const BlockPattern& pattern) {
    Impl& m = *impl_;
    m.take(pattern);
    m.forget();
    const Impl::Awake awake(m.pool);
    m.analysis.keep_order(false);
    m.analysis.plan(m.pattern);
    m.report = {};
    m.report.replanned = true;
    m.report.columns = m.pattern.nodes();
    m.place();
}

void BlockFactor::analyse(const BlockPattern& pattern, std::span<const std::int32_t> order) {
    Impl& m = *impl_;
    world::check_order(pattern, order);
    m.take(pattern);
    m.forget();
    const Impl::Awake awake(m.pool);
    m.analysis.keep_order(true);
    m.analysis.plan(m.pattern, factor::Elimination{{order.begin(), order.end()}, {}});
    m.report = {};
    m.report.replanned = true;
    m.report.columns = m.pattern.nodes();
    m.place();
}

void BlockFactor::update(const BlockPattern& pattern, std::span<const std::int32_t> old_of_new) {
    Impl& m = *impl_;
    const auto before = static_cast<std::int32_t>(m.pattern.size.size());
    if (!old_of_new.empty()) {
        if (old_of_new.size() != pattern.size.size())
            throw std::invalid_argument("block pattern: old numbers and nodes differ in number");
        std::vector<bool> seen(at(before), false);
        for (const std::int32_t old : old_of_new) {
            if (old < -1 || old >= before || (old >= 0 && seen[at(old)]))
                throw std::invalid_argument("block pattern: old numbers must be some of 0 to " +
                                            std::to_string(before - 1) + ", each once, or -1");
            if (old >= 0) seen[at(old)] = true;
        }
    }
    const Impl::Awake awake(m.pool);
    m.take(pattern);
    m.report = m.analysis.update(m.pattern, old_of_new);
    if (m.report.replanned) m.analysis.keep_order(false);
    m.place();
}

std::int64_t BlockFactor::value_count() const noexcept { return impl_->value_begin.back(); }
std::int64_t BlockFactor::value_begin(std::int32_t block) const noexcept {
    return impl_->value_begin[at(block)];
}
std::int64_t BlockFactor::scalar_begin(std::int32_t node) const noexcept {
    return impl_->scalar_begin[at(node)];
}

Status BlockFactor::Impl::finish(int wrong_pivots) noexcept {
    wrong = wrong_pivots;
    return wrong == 0 ? Status::ok : Status::wrong_pivot;
}

Status BlockFactor::Impl::factor_full(const double* values) noexcept {
    const factor::Symbolic& s = analysis.symbolic();
    numeric.clear(s, pool);
    copy_all([&](std::size_t k) noexcept { copy(k, values); });
    factored = true;
    return finish(numeric.factor(s, pool));
}

Status BlockFactor::factor(std::span<const double> values) noexcept {
    Impl& m = *impl_;
    assert(static_cast<std::int64_t>(values.size()) == value_count());
    const Impl::Awake awake(m.pool);
    if (!m.mixed) return m.factor_full(values.data());
    m.mixed->single = false;
    if (!m.worth_trying()) return m.factor_full(values.data());
    m.mixed->residual.keep(values, m.pool);
    return m.factor_single() ? Status::ok : m.fall_back();
}

Status BlockFactor::refactor(std::span<const double> values,
                             std::span<const std::int32_t> changed_blocks) noexcept {
    Impl& m = *impl_;
    assert(static_cast<std::int64_t>(values.size()) == value_count());
    // There must be a factor to start from; a wrong pivot elsewhere in it would go unreported.
    if (!m.options.partial || !m.factored || m.wrong != 0 ||
        changed_blocks.size() > m.columns.size()) {
        m.part_flops = m.analysis.symbolic().flops;
        return factor(values);
    }
    const Impl::Awake awake(m.pool);
    const factor::Symbolic& s = m.analysis.symbolic();
    for (std::size_t k = 0; k < changed_blocks.size(); ++k)
        m.columns[k] = m.column_of[at(changed_blocks[k])];
    m.dirty.find(s, {m.columns.data(), changed_blocks.size()});
    m.part_flops = m.dirty.flops;
    if (m.single()) {
        if (m.refactor_single(values, changed_blocks)) return Status::ok;
        m.part_flops = s.flops;
        return m.fall_back();
    }
    m.numeric.clear(s, m.dirty, m.pool);
    auto copy = [&](std::size_t k) noexcept { m.copy(k, values.data()); };
    m.copy_groups(m.dirty.fronts, 0, copy);
    m.copy_groups(m.dirty.batches, static_cast<std::int32_t>(s.fronts.size()), copy);
    return m.finish(m.numeric.refactor(s, m.dirty, m.pool));
}

Status BlockFactor::Impl::solve_full(double* x) noexcept {
    const factor::Symbolic& s = analysis.symbolic();
    for (std::size_t v = 0; v < pattern.size.size(); ++v)
        std::copy_n(x + scalar_begin[v], pattern.size[v], permuted.data() + s.node_offset[v]);
    numeric.solve(s, permuted.data(), pool);
    bool finite = true;
    for (std::size_t v = 0; v < pattern.size.size(); ++v)
        for (std::int64_t i = 0; i < pattern.size[v]; ++i) {
            const double value = permuted[at(s.node_offset[v] + i)];
            x[scalar_begin[v] + i] = value;
            finite &= std::isfinite(value);
        }
    return finite ? Status::ok : Status::not_finite;
}

Status BlockFactor::solve(std::span<double> x) noexcept {
    Impl& m = *impl_;
    assert(x.size() + 8 == m.permuted.size());
    const Impl::Awake awake(m.pool);
    if (m.single()) return m.solve_mixed(x);
    if (m.mixed) m.mixed->refinements = 0;
    return m.solve_full(x.data());
}

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
        double most = 0.0, unfit = 0.0;  // the latter of what is not finite: no number
        for (const double d : v) {
            most = std::max(most, std::abs(d));
            unfit += d - d;
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
    return scale == 0.0 ? 0.0 : largest(m.rest) / scale;
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

FactorInfo BlockFactor::info() const noexcept {
    const Impl& m = *impl_;
    const factor::Symbolic& s = m.analysis.symbolic();
    FactorInfo info;
    info.nodes = m.pattern.nodes();
    info.scalars = s.scalars;
    info.fronts = static_cast<std::int64_t>(s.fronts.size());
    info.matrix_nnz = s.matrix_nnz;
    info.factor_nnz = s.factor_nnz;
    info.flops = s.flops;
    info.path_flops = s.critical_flops;
    info.part_flops = m.part_flops;
    info.columns = m.report.columns;
    info.planned = m.report.replanned;
    info.wrong_pivots = m.wrong;
    if (m.mixed) {
        info.single = m.mixed->single;
        info.fallbacks = m.mixed->fallbacks;
        info.refinements = m.mixed->refinements;
        info.bytes = static_cast<std::int64_t>(m.mixed->bytes());
    }
    info.bytes += static_cast<std::int64_t>(
        m.analysis.bytes() + m.numeric.bytes() + base::bytes(m.ops) + base::bytes(m.column_of) +
        base::bytes(m.value_begin) + base::bytes(m.permuted) + base::bytes(m.edges));
    return info;
}

std::span<const std::int32_t> BlockFactor::order() const noexcept {
    return impl_->analysis.symbolic().order;
}

}  // namespace hawser
