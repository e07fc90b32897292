// SPDX-License-Identifier: Apache-2.0
#include "linear/scalar.h"

#include "factor/ordering.h"
#include "index.h"
#include "linear/pieces.h"

extern "C" {
#include <amd.h>
#if HAWSER_HAVE_METIS
#include <metis.h>
#endif
}

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace hawser::bench {
namespace {

std::vector<std::int32_t> metis(const factor::Pattern& pattern) {
#if HAWSER_HAVE_METIS
    idx_t n = pattern.nodes();
    std::vector<idx_t> start(pattern.start.begin(), pattern.start.end());
    std::vector<idx_t> adjacent(pattern.adjacent.begin(), pattern.adjacent.end());
    std::vector<idx_t> order(at(n)), place(at(n));
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    if (METIS_NodeND(&n, start.data(), adjacent.data(), nullptr, options, order.data(),
                     place.data()) != METIS_OK)
        throw std::runtime_error("METIS failed");
    return {order.begin(), order.end()};
#else
    (void)pattern;
    throw std::runtime_error("METIS is not in this build");
#endif
}

/// Convert the block lower triangle to a scalar matrix by columns, and record the address of each
/// block.
Sparse block_lower(const BlockForm& f, std::vector<BlockWrite>& writes) {
    std::vector<std::int32_t> height(f.kept.size(), 0);  // rows below the diagonal block
    for (const BlockOp& op : f.ops)
        if (op.row != op.col) height[at(op.col)] += op.row_size;
    std::vector<std::int32_t> start(at(f.scalars()) + 1, 0);
    for (std::size_t a = 0; a < f.kept.size(); ++a)
        for (std::int32_t c = f.offset[a]; c < f.offset[a + 1]; ++c)
            start[at(c) + 1] = start[at(c)] + f.offset[a + 1] - c + height[a];
    Sparse m(f.scalars(), f.scalars());
    m.resizeNonZeros(start.back());
    std::copy(start.begin(), start.end(), m.outerIndexPtr());
    std::vector<std::int32_t> depth(f.kept.size(), 0);
    for (const BlockOp& op : f.ops) {  // ascending rows within a column
        const int n = op.col_size, first = f.offset[at(op.col)];
        std::int64_t to = start[at(first)] + depth[at(op.col)];
        writes.emplace_back(op, false, to, 1, n + height[at(op.col)] - 1);
        writes.back().shrink = true;
        for (int c = 0; c < n; ++c) {
            for (int i = op.row == op.col ? c : 0; i < op.row_size; ++i)
                m.innerIndexPtr()[to + i] = f.offset[at(op.row)] + i;
            to += writes.back().stride - c;
        }
        depth[at(op.col)] += op.row_size;
    }
    std::fill(m.valuePtr(), m.valuePtr() + m.nonZeros(), 0.0);
    return m;
}

}  // namespace

std::string name_of(Order order) {
    switch (order) {
        case Order::amd_scalars:
            return "AMD on scalars";
        case Order::amd_blocks:
            return "AMD on blocks";
        case Order::metis_blocks:
            return "METIS on blocks";
        case Order::library:
            return "own";
    }
    return {};
}

std::vector<std::int32_t> order_blocks(const BlockForm& form, Order order) {
    if (order != Order::metis_blocks) return factor::order_nodes(form.pattern);
    std::vector<std::int32_t> result = metis(form.pattern);
    factor::place_rows_after_bodies(form.pattern, result);
    return result;
}

ScalarMatrix::ScalarMatrix(const BlockSystem& system, const BlockForm& form) {
    if (form.condensed) {
        std::vector<BlockWrite> writes;
        lower = block_lower(form, writes);
        // Group equal blocks within stretches whose values stay in cache, like Hawser's pieces.
        constexpr std::size_t kStretch = 512;
        for (std::size_t k = 0; k < writes.size(); k += kStretch) {
            const std::span all(form.ops);
            for (const std::int32_t i :
                 order_alike(all.subspan(k, std::min(kStretch, all.size() - k))))
                writes_.push_back(writes[k + at(i)]);
        }
        return;
    }
    // Use indices instead of values: exact below 2^53, and none is zero.
    lower = system.lower();
    BlockSystem places = system;
    for (std::size_t k = 0; k < places.values.size(); ++k)
        places.values[k] = system.values[k] == 0.0 ? 0.0 : static_cast<double>(k) + 1.0;
    const Sparse marked = places.lower();
    for (Eigen::Index k = 0; k < marked.nonZeros(); ++k)
        source_.push_back(static_cast<std::int64_t>(marked.valuePtr()[k]) - 1);
}

void ScalarMatrix::refresh(const BlockSystem& system, const BlockForm& form,
                           const std::vector<double>& inverse, base::Executor& executor) {
    if (form.condensed) {
        assemble(system, writes_, form.contributions, inverse, lower.valuePtr(), executor);
        return;
    }
    in_pieces(lower.nonZeros(), executor, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k)
            lower.valuePtr()[k] = system.values[at(source_[at(k)])];
    });
}

std::vector<std::int32_t> ScalarMatrix::order_scalars(const BlockForm& form, Order order) const {
    std::vector<std::int32_t> result(at(lower.rows()));
    if (order == Order::amd_scalars) {
        if (amd_order(static_cast<int>(lower.rows()), lower.outerIndexPtr(), lower.innerIndexPtr(),
                      result.data(), nullptr, nullptr) < 0)
            throw std::runtime_error("AMD failed");
        return result;
    }
    result.clear();
    for (const std::int32_t a : order_blocks(form, order))
        for (std::int32_t i = form.offset[at(a)]; i < form.offset[at(a) + 1]; ++i)
            result.push_back(i);
    return result;
}

void Permuted::build(const Sparse& lower, std::vector<std::int32_t> order_, Triangle triangle) {
    order = std::move(order_);
    const std::size_t n = order.size();
    std::vector<std::int32_t> place(n);
    for (std::size_t k = 0; k < n; ++k) place[at(order[k])] = static_cast<std::int32_t>(k);
    // Two counting sorts: by row, then by column, so that rows ascend within each column.
    struct Entry {
        std::int32_t row, col, source;
    };
    std::vector<Entry> entries, sorted;
    entries.reserve(at(lower.nonZeros()) * (triangle == Triangle::full ? 2 : 1));
    for (int j = 0; j < lower.outerSize(); ++j)
        for (std::int32_t k = lower.outerIndexPtr()[j]; k < lower.outerIndexPtr()[j + 1]; ++k) {
            std::int32_t r = place[at(lower.innerIndexPtr()[k])], c = place[at(j)];
            if ((triangle == Triangle::lower) == (r < c)) std::swap(r, c);
            entries.push_back({r, c, k});
            if (triangle == Triangle::full && r != c) entries.push_back({c, r, k});
        }
    sorted.resize(entries.size());
    auto pass = [&](auto key) {
        start.assign(n + 1, 0);
        for (const Entry& e : entries) ++start[at(key(e)) + 1];
        std::partial_sum(start.begin(), start.end(), start.begin());
        std::vector<std::int32_t> cursor(start.begin(), start.end() - 1);
        for (const Entry& e : entries) sorted[at(cursor[at(key(e))]++)] = e;
        entries.swap(sorted);
    };
    pass([](const Entry& e) { return e.row; });
    pass([](const Entry& e) { return e.col; });
    row.resize(entries.size());
    source.resize(entries.size());
    value.assign(entries.size(), 0.0);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        row[k] = entries[k].row;
        source[k] = entries[k].source;
    }
}

void Permuted::gather(const Sparse& lower, double* to, base::Executor& executor) const {
    const double* from = lower.valuePtr();
    in_pieces(static_cast<std::int64_t>(source.size()), executor,
              [&](std::int64_t begin, std::int64_t end) {
                  for (std::int64_t k = begin; k < end; ++k) to[k] = from[source[at(k)]];
              });
}

}  // namespace hawser::bench
