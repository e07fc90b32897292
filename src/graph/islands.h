// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file islands.h
/// Connected components of the interaction graph by union-find with path halving.
/// Roots are the smallest index of their component, so the numbering is canonical.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

struct Islands {
    std::vector<std::int32_t> label;  ///< Island of each node, −1 for nodes left out.
    std::int32_t count = 0;
};

/// Finds islands; a used one needs no memory for a graph of about the same size.
class IslandFinder {
  public:
    /// As find_islands(). @throws std::bad_alloc.
    void find(std::span<const std::uint8_t> include, std::span<const std::int32_t> member_begin,
              std::span<const std::int32_t> members, Islands& out);
    [[nodiscard]] std::size_t bytes() const noexcept {
        return root_.capacity() * sizeof(std::int32_t);
    }

  private:
    std::vector<std::int32_t> root_;
};

/// @param include       Node takes part (moves); others neither join nor belong.
/// @param member_begin  edges + 1 offsets into `members`: the nodes of each hyperedge.
[[nodiscard]] Islands find_islands(std::span<const std::uint8_t> include,
                                   std::span<const std::int32_t> member_begin,
                                   std::span<const std::int32_t> members);

}  // namespace hawser::graph
