// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file islands.h
/// Connected components of the interaction graph by union-find with path halving.
/// Roots are the smallest index of their component, so the numbering is canonical.

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

struct Islands {
    std::vector<std::int32_t> label;  ///< Island of each node, −1 for nodes left out.
    std::int32_t count = 0;
};

/// @param include       Node takes part (moves); others neither join nor belong.
/// @param member_begin  edges + 1 offsets into `members`: the nodes of each hyperedge.
[[nodiscard]] Islands find_islands(std::span<const std::uint8_t> include,
                                   std::span<const std::int32_t> member_begin,
                                   std::span<const std::int32_t> members);

}  // namespace hawser::graph
