// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file minimum_degree.h
/// Minimum degree orders of graphs of up to two thousand nodes, with the true degrees, in scalars.
///
/// Eliminating a node makes its neighbours a clique (Parter 1961); next comes one with the fewest
/// neighbours (Tinney, Walker 1967). Graphs of scenes are small enough to be held as rows of bits,
/// a closed neighbourhood each: the rows of all neighbours are then united with that of the pivot,
/// some vector instructions for each, where the lists of a quotient graph (AMD) take a step for
/// each entry, and their lengths are but bounds of the degrees. Nodes of one closed neighbourhood
/// are eliminated together (George, Liu, "The evolution of the minimum degree ordering algorithm",
/// 1989): they have one row, and count as one when the degree of either is taken (external
/// degree). Ties go to the node whose degree changed last, then to the smallest.
///
/// A node weighs its scalars: a pivot with d scalars around it makes a column of d entries and d²/2
/// products, whatever the number of nodes. In a net, a string (one row) has 2 neighbours of 6
/// scalars and a knot (3 scalars) has 4 of 4: counted in nodes strings go first, which leaves 3
/// scalars a knot, counted in scalars knots go first, which leaves 2 rows a knot. Weights are
/// divided by their greatest common divisor, so that nodes of one size weigh one.

#include "base/memory.h"
#include "factor/kernels.h"
#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// A used one needs no memory for a graph of about the same size.
class MinimumDegree {
  public:
    /// Nodes beyond which lists take less time than rows.
    static constexpr std::int32_t kMost = 2048;

    /// @param order  order[k] = node eliminated k-th. @cost O(fill · nodes / 512).
    void run(const Pattern& pattern, std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void begin(const Pattern& pattern);
    void weigh(const Pattern& pattern);
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

    std::int32_t words_ = 0;           ///< Of a row.
    base::Array<std::uint64_t> rows_;  ///< Of a head: itself and its neighbours, gone ones perhaps.
    base::Array<std::uint64_t> left_, heads_;  ///< Not eliminated; of these the first of twins.
    base::Array<std::uint64_t> clique_;        ///< Neighbours of the pivot that are left.
    base::Array<std::uint64_t> heavy_;         ///< Rows of weights_.
    NodeWeights weights_;
    std::vector<std::uint32_t> in_words_;        ///< Of a head: words of its row that are not zero.
    std::vector<std::int32_t> next_, prev_;      ///< Rings, by degree: nodes, then a list for each.
    std::vector<std::int32_t> degree_, weight_;  ///< Of a head: external degree; twins and itself.
    std::vector<std::int32_t> twin_, last_twin_;  ///< The next one, −1: none; of a head.
    std::vector<std::int32_t> touched_, sizes_;  ///< Heads beside the pivot, weights of their rows.
    std::vector<std::uint64_t> folds_;           ///< Of these rows.
    std::int32_t least_ = 0;                     ///< No head has a smaller degree.
    std::int32_t* order_ = nullptr;              ///< Where the next one goes.
};

}  // namespace hawser::factor
