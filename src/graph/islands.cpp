// SPDX-License-Identifier: Apache-2.0
#include "graph/islands.h"

#include <numeric>
#include <utility>

namespace hawser::graph {

void IslandFinder::find(std::span<const std::uint8_t> include,
                        std::span<const std::int32_t> member_begin,
                        std::span<const std::int32_t> members, Islands& out) {
    std::vector<std::int32_t>& root = root_;
    root.resize(include.size());
    std::iota(root.begin(), root.end(), 0);
    auto find = [&](std::int32_t i) {
        while (root[static_cast<std::size_t>(i)] != i) {
            auto& up = root[static_cast<std::size_t>(i)];
            up = root[static_cast<std::size_t>(up)];
            i = up;
        }
        return i;
    };
    for (std::size_t e = 0; e + 1 < member_begin.size(); ++e) {
        std::int32_t first = -1;
        for (std::int32_t k = member_begin[e]; k < member_begin[e + 1]; ++k) {
            const std::int32_t node = members[static_cast<std::size_t>(k)];
            if (!include[static_cast<std::size_t>(node)]) continue;
            if (first < 0) {
                first = find(node);
                continue;
            }
            std::int32_t other = find(node);
            if (other < first) std::swap(other, first);
            root[static_cast<std::size_t>(other)] = first;
        }
    }
    out.count = 0;
    out.label.assign(include.size(), -1);
    for (std::size_t i = 0; i < include.size(); ++i) {
        if (!include[i]) continue;
        const auto r = static_cast<std::size_t>(find(static_cast<std::int32_t>(i)));
        if (out.label[r] < 0) out.label[r] = out.count++;
        out.label[i] = out.label[r];
    }
}

Islands find_islands(std::span<const std::uint8_t> include,
                     std::span<const std::int32_t> member_begin,
                     std::span<const std::int32_t> members) {
    Islands out;
    IslandFinder().find(include, member_begin, members, out);
    return out;
}

}  // namespace hawser::graph
