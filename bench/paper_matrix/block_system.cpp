// SPDX-License-Identifier: Apache-2.0
#include "paper_matrix/block_system.h"

#include "index.h"
#include "paper_matrix/dice.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace hawser::bench {
namespace {

/// Compute the address of each adjacency entry, from the list of blocks.
std::vector<std::int64_t> edge_addresses(const factor::Pattern& pattern,
                                         const std::vector<std::int32_t>& high,
                                         const std::vector<std::int32_t>& low,
                                         const std::vector<std::int64_t>& address) {
    std::vector<std::int64_t> edge(pattern.adjacent.size(), -1);
    auto put = [&](std::int32_t a, std::int32_t b, std::int64_t value) {
        const auto n = pattern.neighbours(a);
        const auto k = std::lower_bound(n.begin(), n.end(), b) - n.begin();
        std::int64_t& slot = edge[at(pattern.start[at(a)] + k)];
        if (slot >= 0) throw std::logic_error("a block was given twice");
        slot = value;
    };
    for (std::size_t e = 0; e < high.size(); ++e) {
        put(high[e], low[e], address[e]);
        put(low[e], high[e], address[e]);
    }
    return edge;
}

}  // namespace

double BlockSystem::at(int a, int k, int i, int j) const noexcept {
    const int first = pattern.start[static_cast<std::size_t>(a)] + k;
    const int b = pattern.adjacent[static_cast<std::size_t>(first)];
    const double* block = values.data() + edge[static_cast<std::size_t>(first)];
    return a > b ? block[i * size(b) + j] : block[j * size(a) + i];
}

int BlockSystem::islands() const {
    std::vector<std::int32_t> parent(pattern.size.size());
    std::iota(parent.begin(), parent.end(), 0);
    auto find = [&](std::int32_t i) {
        while (parent[bench::at(i)] != i)
            i = parent[bench::at(i)] = parent[bench::at(parent[bench::at(i)])];
        return i;
    };
    int count = pattern.nodes();
    for (int a = 0; a < pattern.nodes(); ++a)
        for (const std::int32_t b : pattern.neighbours(a)) {
            const std::int32_t i = find(a), j = find(b);
            if (i == j) continue;
            parent[bench::at(std::max(i, j))] = std::min(i, j);
            --count;
        }
    return count;
}

Sparse BlockSystem::lower() const {
    Sparse m(scalars(), scalars());
    std::int64_t entries = 0;
    for (int a = 0; a < pattern.nodes(); ++a) {
        entries += size(a) * (size(a) + 1) / 2;
        for (const std::int32_t b : pattern.neighbours(a)) entries += b > a ? size(a) * size(b) : 0;
    }
    m.reserve(entries);
    for (int a = 0; a < pattern.nodes(); ++a)
        for (int j = 0; j < size(a); ++j) {
            const int column = offset[bench::at(a)] + j;
            m.startVec(column);
            for (int i = j; i < size(a); ++i) {
                const double v = values[bench::at(diagonal[bench::at(a)] + i * size(a) + j)];
                if (v != 0.0 || i == j) m.insertBack(column - j + i, column) = v;
            }
            const auto neighbours = pattern.neighbours(a);
            for (int k = 0; k < static_cast<int>(neighbours.size()); ++k) {
                const int b = neighbours[bench::at(k)];
                if (b < a) continue;
                for (int i = 0; i < size(b); ++i)
                    if (const double v = at(a, k, j, i); v != 0.0)
                        m.insertBack(offset[bench::at(b)] + i, column) = v;
            }
        }
    m.finalize();
    return m;
}

int SystemBuilder::add_node(int size, int sign, std::span<const double> block) {
    size_.push_back(static_cast<std::int8_t>(size));
    sign_.push_back(static_cast<std::int8_t>(sign));
    diagonal_.push_back(static_cast<std::int64_t>(values_.size()));
    values_.insert(values_.end(), block.begin(), block.end());
    return nodes() - 1;
}

int SystemBuilder::add_rows(std::span<const double> sigma) {
    const std::size_t n = sigma.size();
    std::vector<double> block(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i) block[i * n + i] = -sigma[i];
    return add_node(static_cast<int>(n), -1, block);
}

void SystemBuilder::add_block(int high, int low, std::span<const double> block) {
    high_.push_back(high);
    low_.push_back(low);
    address_.push_back(static_cast<std::int64_t>(values_.size()));
    values_.insert(values_.end(), block.begin(), block.end());
}

BlockSystem SystemBuilder::finish(std::string name, std::uint64_t rhs_seed) {
    BlockSystem s;
    s.name = std::move(name);
    s.pattern = factor::make_pattern(std::move(size_), std::move(sign_), high_, low_);
    s.edge = edge_addresses(s.pattern, high_, low_, address_);
    s.diagonal = std::move(diagonal_);
    s.values = std::move(values_);
    s.values.resize(s.values.size() + 8, 0.0);
    s.offset.assign(1, 0);
    for (const std::int8_t size : s.pattern.size) s.offset.push_back(s.offset.back() + size);
    s.bodies = static_cast<int>(std::count(s.pattern.sign.begin(), s.pattern.sign.end(), 1));
    Dice dice(rhs_seed);
    std::vector<double> x(bench::at(s.scalars()));
    for (int a = 0; a < s.pattern.nodes(); ++a)
        for (int i = s.offset[bench::at(a)]; i < s.offset[bench::at(a) + 1]; ++i)
            x[bench::at(i)] = dice.uniform(-1.0, 1.0) * (s.positive(a) ? 1.0 : 1e3);
    s.rhs.resize(x.size());
    multiply(s, x, s.rhs);
    return s;
}

void multiply(const BlockSystem& s, std::span<const double> x, std::span<double> y) {
    std::fill(y.begin(), y.end(), 0.0);
    for (int a = 0; a < s.pattern.nodes(); ++a) {
        const int na = s.size(a);
        const double* xa = x.data() + s.offset[at(a)];
        double* ya = y.data() + s.offset[at(a)];
        const double* d = s.values.data() + s.diagonal[at(a)];
        for (int i = 0; i < na; ++i)
            for (int j = 0; j < na; ++j) ya[i] += d[i * na + j] * xa[j];
        for (int k = s.pattern.start[at(a)]; k < s.pattern.start[at(a) + 1]; ++k) {
            const int b = s.pattern.adjacent[at(k)];
            if (b > a) break;  // the rest of the ascending list is counted at the other end
            const int nb = s.size(b);
            const double* block = s.values.data() + s.edge[at(k)];
            const double* xb = x.data() + s.offset[at(b)];
            double* yb = y.data() + s.offset[at(b)];
            for (int i = 0; i < na; ++i)
                for (int j = 0; j < nb; ++j) {
                    ya[i] += block[i * nb + j] * xb[j];
                    yb[j] += block[i * nb + j] * xa[i];
                }
        }
    }
}

}  // namespace hawser::bench
