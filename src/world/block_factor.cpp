// SPDX-License-Identifier: Apache-2.0
/// Implementation of the public interface to src/factor.
#include "base/index.h"
#include "world/block_impl.h"
#include "world/block_pattern.h"

#include <hawser/world.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hawser {

void BlockFactor::Impl::take(const BlockPattern& p) {
    pattern = world::factor_pattern_of(p);
    edges = p.edges;
    scalar_begin.assign(1, 0);
    value_begin.assign(1, 0);
    for (const std::int8_t size : p.size) {
        scalar_begin.push_back(scalar_begin.back() + size);
        value_begin.push_back(value_begin.back() + size * size);
    }
    for (const BlockEdge& e : edges)
        value_begin.push_back(value_begin.back() + p.size[at(e.row)] * p.size[at(e.column)]);
}

/// Compute the address of each matrix block in the panels of the factor.
void BlockFactor::Impl::assign_addresses() {
    const factor::Symbolic& s = analysis.symbolic();
    numeric.reserve(s, pool.threads());
    dirty.reserve(s);
    const std::size_t nodes = pattern.size.size(), blocks = nodes + edges.size();
    const std::size_t holders = s.fronts.size() + s.batches.size();
    column_of.resize(blocks);
    std::vector<CopyOp> unsorted(blocks);
    holder_begin.assign(holders + 1, 0);
    for (std::size_t b = 0; b < blocks; ++b) {
        CopyOp& op = unsorted[b];
        const auto node = static_cast<std::int32_t>(b);
        const BlockEdge e = b < nodes ? BlockEdge{node, node} : edges[b - nodes];
        const std::int32_t column = factor::DirtyParts::column(s, e.row, e.column);
        const bool turned = column != e.column;
        const factor::BlockTarget t = s.target(turned ? e.column : e.row, column);
        column_of[b] = column;
        const factor::Front& front = s.fronts[at(s.node_front[at(column)])];
        op.holder = front.batch < 0 ? s.node_front[at(column)]
                                    : static_cast<std::int32_t>(s.fronts.size()) + front.batch;
        op.from = value_begin[b];
        op.to = t.address;
        op.step = turned ? t.ld : t.step;
        op.ld = turned ? t.step : t.ld;
        op.rows = pattern.size[at(e.row)];
        op.columns = pattern.size[at(e.column)];
        op.diagonal = b < nodes;
        ++holder_begin[at(op.holder) + 1];
    }
    for (std::size_t g = 0; g < holders; ++g) holder_begin[g + 1] += holder_begin[g];
    ops.resize(blocks);
    std::vector<std::int32_t> cursor(holder_begin.begin(), holder_begin.end() - 1);
    for (const CopyOp& op : unsorted) ops[at(cursor[at(op.holder)]++)] = op;
    columns.resize(blocks);
    factored = false;
    const std::size_t n = at(s.scalars);
    permuted.assign(n + 8, 0.0);  // vector loads read past the end
    rest.assign(n, 0.0);
    row_sum.assign(n, 0.0);
}

void BlockFactor::Impl::copy(const CopyOp& op, const double* values) noexcept {
    const double* from = values + op.from;
    double* to = numeric.values() + op.to;
    for (int i = 0; i < op.rows; ++i)
        for (int j = 0; j < (op.diagonal ? i + 1 : op.columns); ++j)
            to[static_cast<std::int64_t>(i) * op.step + static_cast<std::int64_t>(j) * op.ld] =
                from[i * op.columns + j];
}

/// Copy the matrix blocks of some interactions. @param holders  Indices of the interactions,
/// counted from `first`.
void BlockFactor::Impl::copy_holder_blocks(std::span<const std::int32_t> holders,
                                           std::int32_t first, const double* values) noexcept {
    auto one = [&](int i, int) noexcept {
        const std::size_t g = at(first + holders[at(i)]);
        for (std::int32_t k = holder_begin[g]; k < holder_begin[g + 1]; ++k)
            copy(ops[at(k)], values);
    };
    pool.for_each(static_cast<int>(holders.size()), one);
}

Status BlockFactor::Impl::finish(int wrong_pivots) noexcept {
    wrong = wrong_pivots;
    return wrong == 0 ? Status::ok : Status::wrong_pivot;
}

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
    const Impl::Awake awake(m.pool);
    m.analysis.set_fixed_order(false);
    m.analysis.plan(m.pattern);
    m.report = {};
    m.report.replanned = true;
    m.report.columns = m.pattern.nodes();
    m.assign_addresses();
}

void BlockFactor::analyse(const BlockPattern& pattern, std::span<const std::int32_t> order) {
    Impl& m = *impl_;
    world::check_order(pattern, order);
    m.take(pattern);
    const Impl::Awake awake(m.pool);
    m.analysis.set_fixed_order(true);
    m.analysis.plan(m.pattern, factor::Elimination{{order.begin(), order.end()}, {}});
    m.report = {};
    m.report.replanned = true;
    m.report.columns = m.pattern.nodes();
    m.assign_addresses();
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
    if (m.report.replanned) m.analysis.set_fixed_order(false);
    m.assign_addresses();
}

std::int64_t BlockFactor::value_count() const noexcept { return impl_->value_begin.back(); }
std::int64_t BlockFactor::value_begin(std::int32_t block) const noexcept {
    return impl_->value_begin[at(block)];
}
std::int64_t BlockFactor::scalar_begin(std::int32_t node) const noexcept {
    return impl_->scalar_begin[at(node)];
}

Status BlockFactor::factor(std::span<const double> values) noexcept {
    Impl& m = *impl_;
    assert(static_cast<std::int64_t>(values.size()) == value_count());
    const Impl::Awake awake(m.pool);
    const factor::Symbolic& s = m.analysis.symbolic();
    m.numeric.clear(s, m.pool);
    constexpr std::int64_t kChunk = 256;
    const auto count = static_cast<std::int64_t>(m.ops.size());
    auto fill = [&](int i, int) noexcept {
        const std::int64_t end = std::min(count, (i + 1) * kChunk);
        for (std::int64_t k = i * kChunk; k < end; ++k) m.copy(m.ops[at(k)], values.data());
    };
    m.pool.for_each(static_cast<int>((count + kChunk - 1) / kChunk), fill);
    m.factored = true;
    return m.finish(m.numeric.factor(s, m.pool));
}

Status BlockFactor::refactor(std::span<const double> values,
                             std::span<const std::int32_t> changed_blocks) noexcept {
    Impl& m = *impl_;
    assert(static_cast<std::int64_t>(values.size()) == value_count());
    // A factor must exist to start from. A wrong pivot elsewhere in it would go unreported.
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
    m.numeric.clear(s, m.dirty, m.pool);
    m.copy_holder_blocks(m.dirty.fronts, 0, values.data());
    m.copy_holder_blocks(m.dirty.batches, static_cast<std::int32_t>(s.fronts.size()),
                         values.data());
    return m.finish(m.numeric.refactor(s, m.dirty, m.pool));
}

Status BlockFactor::solve(std::span<double> x) noexcept {
    Impl& m = *impl_;
    assert(x.size() + 8 == m.permuted.size());
    const Impl::Awake awake(m.pool);
    const factor::Symbolic& s = m.analysis.symbolic();
    for (std::size_t v = 0; v < m.pattern.size.size(); ++v)
        std::copy_n(x.data() + m.scalar_begin[v], m.pattern.size[v],
                    m.permuted.data() + s.node_offset[v]);
    m.numeric.solve(s, m.permuted.data(), m.pool);
    bool finite = true;
    for (std::size_t v = 0; v < m.pattern.size.size(); ++v)
        for (std::int64_t i = 0; i < m.pattern.size[v]; ++i) {
            const double value = m.permuted[at(s.node_offset[v] + i)];
            x[at(m.scalar_begin[v] + i)] = value;
            finite &= std::isfinite(value);
        }
    return finite ? Status::ok : Status::not_finite;
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
    info.bytes = static_cast<std::int64_t>(
        m.analysis.bytes() + m.numeric.bytes() + base::bytes(m.ops) + base::bytes(m.column_of) +
        base::bytes(m.value_begin) + base::bytes(m.permuted) + base::bytes(m.edges));
    return info;
}

std::span<const std::int32_t> BlockFactor::order() const noexcept {
    return impl_->analysis.symbolic().order;
}

}  // namespace hawser
