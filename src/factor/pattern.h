// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pattern.h
/// The block graph of a symmetric quasi-definite matrix.
///
/// A matrix K = [A Gᵀ; G −Σ] with A, Σ positive definite has an LDLᵀ factorisation with diagonal D
/// for every symmetric permutation (Vanderbei, "Symmetric quasidefinite matrices", 1995). The sign
/// of each pivot is known beforehand. Nodes are dense blocks of 1-6 scalars. Edges are the
/// off-diagonal blocks that may be non-zero.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

inline constexpr int kMaxBlock = 6;

struct Pattern {
    std::vector<std::int8_t> size;       ///< Scalars of each node, 1-6.
    std::vector<std::int8_t> sign;       ///< +1: positive pivots, −1: negative.
    std::vector<std::int32_t> start;     ///< nodes + 1 offsets into `adjacent`.
    std::vector<std::int32_t> adjacent;  ///< Neighbours, ascending, both directions, no diagonal.

    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(size.size()); }
    [[nodiscard]] std::span<const std::int32_t> neighbours(int node) const noexcept {
        const auto n = static_cast<std::size_t>(node);
        return {adjacent.data() + start[n], adjacent.data() + start[n + 1]};
    }
    friend bool operator==(const Pattern&, const Pattern&) = default;
};

/// Distributes edges to the nodes of a pattern. A second run on a similar number of edges allocates
/// nothing.
class NeighbourLists {
  public:
    /// Set the neighbours of `pattern`, which has its sizes and signs. Edges as for make_pattern().
    /// @throws std::bad_alloc.
    void set_neighbours(std::span<const std::int32_t> edge_from,
                        std::span<const std::int32_t> edge_to, Pattern& pattern);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    std::vector<std::int32_t> begin_, cursor_, by_column_, sorted_;
};

/// Build a pattern from a list of edges (either direction, duplicates and loops allowed).
/// @cost O(nodes + edges), counting sort.
[[nodiscard]] Pattern make_pattern(std::vector<std::int8_t> size, std::vector<std::int8_t> sign,
                                   std::span<const std::int32_t> edge_from,
                                   std::span<const std::int32_t> edge_to);

}  // namespace hawser::factor
