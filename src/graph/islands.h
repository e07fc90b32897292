// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file islands.h
/// Find connected components of the interaction graph by union-find with path halving. The root of
/// a component is its smallest index, so the numbering is canonical.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::graph {

struct Islands {
    std::vector<std::int32_t> label;  ///< Island of each node, −1 for excluded nodes.
    std::int32_t count = 0;
};

/// Finder of islands. Its buffer is reused: a second graph of about equal size needs no allocation.
class IslandFinder {
  public:
    /// Find the islands of a graph, see find_islands(). Arrays are reused. @throws std::bad_alloc.
    void find(std::span<const std::uint8_t> include, std::span<const std::int32_t> member_begin,
              std::span<const std::int32_t> members, Islands& out);
    [[nodiscard]] std::size_t bytes() const noexcept {
        return root_.capacity() * sizeof(std::int32_t);
    }

  private:
    std::vector<std::int32_t> root_;
};

/// Return the islands of a graph.
/// @param include       Nonzero if the node takes part (it moves); other nodes neither join islands
/// nor belong to one.
/// @param member_begin  Offsets of the hyperedges in `members`, edges + 1 entries.
/// @param members       Nodes of each hyperedge.
[[nodiscard]] Islands find_islands(std::span<const std::uint8_t> include,
                                   std::span<const std::int32_t> member_begin,
                                   std::span<const std::int32_t> members);

}  // namespace hawser::graph
