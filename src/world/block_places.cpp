// SPDX-License-Identifier: Apache-2.0
/// Places of blocks in the panels, and the values that are copied there.
#include "base/index.h"
#include "world/block_factor.h"
#include "world/block_pattern.h"

#include <algorithm>

namespace hawser {

void BlockFactor::Impl::take(const BlockPattern& p) {
    pattern = world::graph_of(p);
    if (mixed) mixed->residual.reserve(p);
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

/// Where each block goes.
void BlockFactor::Impl::place() {
    const factor::Symbolic& s = analysis.symbolic();
    numeric.reserve(s, pool.threads());
    if (mixed) mixed->reserve(s, pool.threads());
    dirty.reserve(s);
    const std::size_t nodes = pattern.size.size(), blocks = nodes + edges.size();
    const std::size_t groups = s.fronts.size() + s.batches.size();
    column_of.resize(blocks);
    std::vector<CopyOp> unsorted(blocks);
    group_begin.assign(groups + 1, 0);
    for (std::size_t b = 0; b < blocks; ++b) {
        CopyOp& op = unsorted[b];
        const auto node = static_cast<std::int32_t>(b);
        const BlockEdge e = b < nodes ? BlockEdge{node, node} : edges[b - nodes];
        const std::int32_t column = factor::DirtyParts::column(s, e.row, e.column);
        const bool turned = column != e.column;
        const factor::BlockTarget t = s.target(turned ? e.column : e.row, column);
        column_of[b] = column;
        const factor::Front& front = s.fronts[at(s.node_front[at(column)])];
        op.group = front.batch < 0 ? s.node_front[at(column)]
                                   : static_cast<std::int32_t>(s.fronts.size()) + front.batch;
        op.from = value_begin[b];
        op.to = t.address;
        op.step = turned ? t.ld : t.step;
        op.ld = turned ? t.step : t.ld;
        op.rows = pattern.size[at(e.row)];
        op.columns = pattern.size[at(e.column)];
        op.diagonal = b < nodes;
        ++group_begin[at(op.group) + 1];
    }
    for (std::size_t g = 0; g < groups; ++g) group_begin[g + 1] += group_begin[g];
    ops.resize(blocks);
    std::vector<std::int32_t> cursor(group_begin.begin(), group_begin.end() - 1);
    if (mixed) mixed->scalars.resize(blocks);
    for (std::size_t b = 0; b < blocks; ++b) {
        const CopyOp& op = unsorted[b];
        const std::size_t k = at(cursor[at(op.group)]++);
        ops[k] = op;
        if (!mixed) continue;
        const auto node = static_cast<std::int32_t>(b);
        const BlockEdge e = b < nodes ? BlockEdge{node, node} : edges[b - nodes];
        mixed->scalars[k] = {static_cast<std::int32_t>(scalar_begin[at(e.row)]),
                             static_cast<std::int32_t>(scalar_begin[at(e.column)])};
    }
    columns.resize(blocks);
    factored = false;
    const std::size_t n = at(s.scalars);
    permuted.assign(n + 8, 0.0);  // vector loads read past the end
    rest.assign(n, 0.0);
    row_sum.assign(n, 0.0);
}

void BlockFactor::Impl::copy(std::size_t k, const double* values) noexcept {
    const CopyOp& op = ops[k];
    const double* from = values + op.from;
    double* to = numeric.values() + op.to;
    for (int i = 0; i < op.rows; ++i)
        for (int j = 0; j < (op.diagonal ? i + 1 : op.columns); ++j)
            to[static_cast<std::int64_t>(i) * op.step + static_cast<std::int64_t>(j) * op.ld] =
                from[i * op.columns + j];
}

/// Copy block k of S K S, rounded.
void BlockFactor::Impl::copy_scaled(std::size_t k) noexcept {
    const CopyOp& op = ops[k];
    const double* from = mixed->residual.values().data() + op.from;
    const double* row = mixed->scale.data() + mixed->scalars[k].row;
    const double* column = mixed->scale.data() + mixed->scalars[k].column;
    float* to = mixed->numeric.values() + op.to;
    for (int i = 0; i < op.rows; ++i)
        for (int j = 0; j < (op.diagonal ? i + 1 : op.columns); ++j)
            to[static_cast<std::int64_t>(i) * op.step + static_cast<std::int64_t>(j) * op.ld] =
                static_cast<float>(from[i * op.columns + j] * row[i] * column[j]);
}

}  // namespace hawser
