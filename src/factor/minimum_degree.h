// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file minimum_degree.h
/// Minimum degree orders of graphs of up to 2048 nodes, with true degrees in scalars.
///
/// Eliminating a node makes its neighbours a clique (Parter 1961). The next pivot is a node with
/// the fewest neighbours (Tinney, Walker 1967). Graphs of scenes are small enough to store each
/// closed neighbourhood as a row of bits. The rows of all neighbours are united with the row of the
/// pivot by a few vector instructions each. The lists of a quotient graph (AMD) need a step for
/// each entry, and their lengths only bound the degrees. Nodes with equal closed neighbourhoods
/// (twins) are eliminated together (George, Liu, "The evolution of the minimum degree ordering
/// algorithm", 1989). They share one row and count as one node in each other's degree (external
/// degree). Ties go to the node whose degree changed last, then to the smallest index.
///
/// The weight of a node is its number of scalars. A pivot with d scalars around it makes a column
/// of d entries and d²/2 products, whatever the number of nodes. Example: in a net, a string (one
/// row) has 2 neighbours of 6 scalars, and a knot (3 scalars) has 4 of 4. Counted in nodes, strings
/// go first, which leaves 3 scalars per knot. Counted in scalars, knots go first, which leaves 2
/// rows per knot. Weights are divided by their greatest common divisor, so nodes of one size weigh
/// one.

#include "base/memory.h"
#include "factor/kernels.h"
#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// Order nodes by minimum degree. A second run on a graph of similar size allocates nothing.
class MinimumDegree {
  public:
    /// Number of nodes above which lists take less time than rows.
    static constexpr std::int32_t kMaximum = 2048;

    /// Order the nodes of a pattern.
    /// @param order  order[k] = node eliminated k-th.
    /// @cost O(fill · nodes / 512).
    void run(const Pattern& pattern, std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void begin(const Pattern& pattern);
    void set_node_weights(const Pattern& pattern);
    void eliminate(std::int32_t pivot, const Kernels& kernels) noexcept;
    void finish(std::int32_t head) noexcept;
    [[nodiscard]] std::int32_t list_heads(const std::uint64_t* own,
                                          std::uint32_t in_words) noexcept;
    void join_twins(std::int32_t count) noexcept;
    void insert(std::int32_t node) noexcept;
    void remove(std::int32_t node) noexcept;
    [[nodiscard]] std::int32_t list_of(std::int32_t degree) const noexcept {
        return static_cast<std::int32_t>(degree_.size()) + degree;
    }
    [[nodiscard]] std::uint64_t* row(std::int32_t node) noexcept {
        return rows_.data() + static_cast<std::ptrdiff_t>(node) * words_;
    }

    std::int32_t words_ = 0;  ///< Words of a row.
    /// Row of a head: itself and its neighbours, perhaps with eliminated ones.
    base::Array<std::uint64_t> rows_;
    /// Nodes not eliminated; the heads among them (first of its twins).
    base::Array<std::uint64_t> remaining_nodes_, heads_;
    base::Array<std::uint64_t> clique_;  ///< Remaining neighbours of the pivot.
    base::Array<std::uint64_t> heavy_;   ///< Rows of weights_.
    NodeWeights weights_;
    std::vector<std::uint32_t> nonzero_words_;  ///< Non-zero words of the row of each head.
    std::vector<std::int32_t> next_, prev_;  ///< Rings by degree: nodes, then one list per degree.
    /// External degree of a head; its weight with twins.
    std::vector<std::int32_t> degree_, weight_;
    std::vector<std::int32_t> twin_, last_twin_;  ///< Next twin, −1: none; last twin of a head.
    /// Heads adjacent to the pivot, and weights of their rows.
    std::vector<std::int32_t> touched_, sizes_;
    std::vector<std::uint64_t> folds_;  ///< Folds of these rows.
    std::int32_t least_degree_ = 0;     ///< Lower bound of the degrees of all heads.
    std::int32_t* order_ = nullptr;     ///< Next entry of the order to write.
};

}  // namespace hawser::factor
