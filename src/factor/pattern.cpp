// SPDX-License-Identifier: Apache-2.0
#include "factor/pattern.h"

#include "base/index.h"
#include "base/memory.h"

#include <utility>

namespace hawser::factor {

void NeighbourLists::set_neighbours(std::span<const std::int32_t> edge_from,
                                    std::span<const std::int32_t> edge_to, Pattern& p) {
    const std::size_t n = p.size.size(), m = edge_from.size();
    // Two counting sorts: bucket by column, then distribute by row; rows come out ascending.
    begin_.assign(n + 1, 0);
    for (std::size_t e = 0; e < m; ++e) {
        if (edge_from[e] == edge_to[e]) continue;
        ++begin_[at(edge_from[e]) + 1];
        ++begin_[at(edge_to[e]) + 1];
    }
    for (std::size_t i = 0; i < n; ++i) begin_[i + 1] += begin_[i];
    by_column_.resize(at(begin_[n]));
    cursor_.assign(begin_.begin(), begin_.end() - 1);
    for (std::size_t e = 0; e < m; ++e) {
        const std::int32_t a = edge_from[e], b = edge_to[e];
        if (a == b) continue;
        by_column_[at(cursor_[at(a)]++)] = b;
        by_column_[at(cursor_[at(b)]++)] = a;
    }
    sorted_.resize(by_column_.size());
    cursor_.assign(begin_.begin(), begin_.end() - 1);
    for (std::size_t a = 0; a < n; ++a)
        for (std::int32_t k = begin_[a]; k < begin_[a + 1]; ++k)
            sorted_[at(cursor_[at(by_column_[at(k)])]++)] = static_cast<std::int32_t>(a);
    p.start.resize(n + 1);
    p.start[0] = 0;
    p.adjacent.resize(sorted_.size());
    std::int32_t to = 0;
    for (std::size_t a = 0; a < n; ++a) {
        std::int32_t last = -1;
        for (std::int32_t k = begin_[a]; k < begin_[a + 1]; ++k) {
            const std::int32_t b = sorted_[at(k)];
            if (b != last) p.adjacent[at(to++)] = b;
            last = b;
        }
        p.start[a + 1] = to;
    }
    p.adjacent.resize(at(to));
}

std::size_t NeighbourLists::bytes() const noexcept {
    return base::bytes(begin_) + base::bytes(cursor_) + base::bytes(by_column_) +
           base::bytes(sorted_);
}

Pattern make_pattern(std::vector<std::int8_t> size, std::vector<std::int8_t> sign,
                     std::span<const std::int32_t> edge_from,
                     std::span<const std::int32_t> edge_to) {
    Pattern p;
    p.size = std::move(size);
    p.sign = std::move(sign);
    NeighbourLists().set_neighbours(edge_from, edge_to, p);
    return p;
}

}  // namespace hawser::factor
