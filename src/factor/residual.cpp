// SPDX-License-Identifier: Apache-2.0
#include "factor/residual.h"

#include "base/index.h"
#include "factor/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace hawser::factor {
namespace {

constexpr int kBias = 1023, kMantissa = 52;

/// Power of two of the scale for a diagonal entry.
int scale_exponent(double diagonal) noexcept {
    if (diagonal == 0.0 || !std::isfinite(diagonal)) return 0;
    const auto bits = std::bit_cast<std::uint64_t>(diagonal) >> kMantissa & 0x7ff;
    return -((static_cast<int>(bits) - kBias) >> 1);
}
double power_of_two(int k) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + kBias) << kMantissa);
}

}  // namespace

void BlockResidual::reserve(const BlockPattern& p) {
    nodes_ = p.size.size();
    const std::size_t all = nodes_ + p.edges.size();
    blocks_.resize(all);
    value_.assign(1, 0);
    scalar_.assign(1, 0);
    term_.assign(nodes_ + 1, 0);
    for (std::size_t v = 0; v < nodes_; ++v) {
        blocks_[v] = {p.size[v], p.size[v]};
        scalar_.push_back(scalar_.back() + p.size[v]);
        ++term_[v + 1];
    }
    for (std::size_t e = 0; e < p.edges.size(); ++e) {
        const BlockEdge& edge = p.edges[e];
        blocks_[nodes_ + e] = {p.size[at(edge.row)], p.size[at(edge.column)]};
        ++term_[at(edge.row) + 1];
        ++term_[at(edge.column) + 1];
    }
    for (const Block& b : blocks_) value_.push_back(value_.back() + b.rows * b.columns);
    for (std::size_t v = 0; v < nodes_; ++v) term_[v + 1] += term_[v];
    terms_.resize(at(term_.back()));
    std::vector<std::int64_t> next(term_.begin(), term_.end() - 1);
    auto add = [&](std::int32_t node, std::int32_t other, std::int64_t value) {
        terms_[at(next[at(node)]++)] = {value, static_cast<std::int32_t>(scalar_[at(other)]),
                                        p.size[at(other)]};
    };
    // A row of a block as it is given is a column of the same block turned round.
    const std::int64_t turned = value_.back();
    for (std::size_t v = 0; v < nodes_; ++v) {
        const auto node = static_cast<std::int32_t>(v);
        add(node, node, turned + value_[v]);
    }
    for (std::size_t e = 0; e < p.edges.size(); ++e) {
        const BlockEdge& edge = p.edges[e];
        add(edge.row, edge.column, turned + value_[nodes_ + e]);
        add(edge.column, edge.row, value_[nodes_ + e]);
    }
    store_.resize(std::max(store_.size(), at(2 * value_.back() + 8)));
    sizes_.resize(at(base::chunks(nodes_, kNodes)));
}

/// Diagonal blocks are given by their lower triangle and kept whole.
void BlockResidual::turn(std::size_t block) noexcept {
    const Block b = blocks_[block];
    const double* from = store_.data() + value_[block];
    double* to = store_.data() + value_.back() + value_[block];
    for (int i = 0; i < b.rows; ++i)
        for (int j = 0; j < b.columns; ++j) {
            const bool upper = block < nodes_ && j > i;
            to[j * b.rows + i] = upper ? from[j * b.columns + i] : from[i * b.columns + j];
        }
}

void BlockResidual::keep(std::span<const double> values, base::Executor& executor) noexcept {
    auto take = [&](int task, int) noexcept {
        const std::size_t begin = at(task) * kBlocks,
                          end = std::min(begin + kBlocks, blocks_.size());
        std::copy(values.data() + value_[begin], values.data() + value_[end],
                  store_.data() + value_[begin]);
        for (std::size_t k = begin; k < end; ++k) turn(k);
    };
    executor.for_each(base::chunks(blocks_.size(), kBlocks), take);
}

void BlockResidual::keep(std::span<const double> values, std::int32_t block) noexcept {
    std::copy(values.data() + value_[at(block)], values.data() + value_[at(block) + 1],
              store_.data() + value_[at(block)]);
    turn(at(block));
}

void BlockResidual::find_scale(double* scale, base::Executor& executor) const noexcept {
    auto find = [&](int task, int) noexcept {
        const std::size_t begin = at(task) * kNodes, end = std::min(begin + kNodes, nodes_);
        for (std::size_t v = begin; v < end; ++v)
            for (int i = 0; i < blocks_[v].rows; ++i)
                scale[scalar_[v] + i] =
                    power_of_two(scale_exponent(store_[at(value_[v] + i * (blocks_[v].rows + 1))]));
    };
    executor.for_each(base::chunks(nodes_, kNodes), find);
}

int BlockResidual::off_scale(const double* scale, std::int32_t node) const noexcept {
    const std::size_t v = at(node);
    int most = 0;
    for (int i = 0; i < blocks_[v].rows; ++i) {
        const int now = std::ilogb(scale[scalar_[v] + i]);
        const int best = scale_exponent(store_[at(value_[v] + i * (blocks_[v].rows + 1))]);
        most = std::max(most, std::abs(now - best));
    }
    return most;
}

ResidualSize BlockResidual::run(const double* scale, const double* x, const double* b, double guard,
                                double* r, base::Executor& executor) noexcept {
    const ResidualView view{
        term_.data(), terms_.data(), scalar_.data(), store_.data(), scale, x, b, r, guard};
    auto rows = [&](int task, int) noexcept {
        const std::size_t begin = at(task) * kNodes, end = std::min(begin + kNodes, nodes_);
        sizes_[at(task)] = factor_kernels().residual(view, static_cast<std::int32_t>(begin),
                                                     static_cast<std::int32_t>(end));
    };
    const int tasks = base::chunks(nodes_, kNodes);
    executor.for_each(tasks, rows);
    ResidualSize all;
    double unfit = 0.0;  // of what is not finite: no number
    for (int t = 0; t < tasks; ++t) {
        const ResidualSize& one = sizes_[at(t)];
        all = {std::max(all.error, one.error), std::max(all.size, one.size)};
        unfit += one.error - one.error;
    }
    all.error += unfit;
    return all;
}

std::size_t BlockResidual::bytes() const noexcept {
    return base::bytes(blocks_) + base::bytes(value_) + base::bytes(scalar_) + base::bytes(term_) +
           base::bytes(terms_) + base::bytes(store_) + base::bytes(sizes_);
}

}  // namespace hawser::factor
