// SPDX-License-Identifier: Apache-2.0
#include "factor/pattern.h"

#include <cstddef>

namespace hawser::factor {

Pattern make_pattern(std::vector<std::int8_t> size, std::vector<std::int8_t> sign,
                     std::span<const std::int32_t> edge_from,
                     std::span<const std::int32_t> edge_to) {
    Pattern p;
    const std::size_t n = size.size(), m = edge_from.size();
    p.size = std::move(size);
    p.sign = std::move(sign);

    // Two counting sorts: bucket by column, then deal out by row; rows come out ascending.
    std::vector<std::int32_t> count(n + 1, 0);
    for (std::size_t e = 0; e < m; ++e) {
        if (edge_from[e] == edge_to[e]) continue;
        ++count[static_cast<std::size_t>(edge_from[e]) + 1];
        ++count[static_cast<std::size_t>(edge_to[e]) + 1];
    }
    for (std::size_t i = 0; i < n; ++i) count[i + 1] += count[i];
    std::vector<std::int32_t> by_column(static_cast<std::size_t>(count[n]));
    std::vector<std::int32_t> cursor(count.begin(), count.end() - 1);
    for (std::size_t e = 0; e < m; ++e) {
        const std::int32_t a = edge_from[e], b = edge_to[e];
        if (a == b) continue;
        by_column[static_cast<std::size_t>(cursor[static_cast<std::size_t>(a)]++)] = b;
        by_column[static_cast<std::size_t>(cursor[static_cast<std::size_t>(b)]++)] = a;
    }
    std::vector<std::int32_t> sorted(by_column.size());
    cursor.assign(count.begin(), count.end() - 1);
    for (std::size_t a = 0; a < n; ++a)
        for (std::int32_t k = count[a]; k < count[a + 1]; ++k) {
            const auto b = static_cast<std::size_t>(by_column[static_cast<std::size_t>(k)]);
            sorted[static_cast<std::size_t>(cursor[b]++)] = static_cast<std::int32_t>(a);
        }
    p.start.assign(n + 1, 0);
    p.adjacent.reserve(sorted.size());
    for (std::size_t a = 0; a < n; ++a) {
        std::int32_t last = -1;
        for (std::int32_t k = count[a]; k < count[a + 1]; ++k) {
            const std::int32_t b = sorted[static_cast<std::size_t>(k)];
            if (b != last) p.adjacent.push_back(b);
            last = b;
        }
        p.start[a + 1] = static_cast<std::int32_t>(p.adjacent.size());
    }
    return p;
}

}  // namespace hawser::factor
