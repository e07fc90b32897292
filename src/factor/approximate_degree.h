// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file approximate_degree.h
/// Approximate minimum degree with weighted nodes, for graphs too large for minimum_degree.h.
///
/// Quotient graph of Amestoy, Davis, Duff, "An approximate minimum degree ordering algorithm",
/// 1996: a pivot becomes an *element*, the list L_p of its neighbours, in place of the clique. A
/// variable i has the degree
///
///   d_i = min(d_i(before) + |L_p \ i|, |A_i \ i| + |L_p \ i| + Σ_e |L_e \ L_p|, left − |i|),
///
/// an upper bound of its true degree. |·| is the sum of weights here: a node weighs its scalars
/// (why: minimum_degree.h), where the AMD library counts nodes. |L_e \ L_p| follows for all
/// elements e from one pass over the lists of L_p. Elements with L_e ⊆ L_p are absorbed, variables
/// with equal lists are joined, variables with no neighbour outside L_p are eliminated with the
/// pivot.
///
/// Nodes with more than 100 √n neighbours come last: their lists would be read at each pivot.

#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// A used one needs no memory for a graph of about the same size.
class ApproximateDegree {
  public:
    /// @param order  order[k] = node eliminated k-th. @throws std::bad_alloc.
    void run(const Pattern& pattern, std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void begin(const Pattern& pattern);
    void insert(std::int32_t node) noexcept;
    void remove(std::int32_t node) noexcept;
    void finish(std::int32_t variable) noexcept;
    void make_room(std::int32_t pivot) noexcept;
    void form_element(std::int32_t pivot) noexcept;
    void gather(std::int32_t pivot, std::int32_t list, std::int32_t begin,
                std::int32_t end) noexcept;
    void measure_elements(std::int32_t pivot) noexcept;
    void shorten_lists(std::int32_t pivot) noexcept;
    bool shorten(std::int32_t pivot, std::int32_t variable) noexcept;
    void join_twins(std::int32_t pivot) noexcept;
    void join_bucket(std::int32_t first) noexcept;
    void close_element(std::int32_t pivot) noexcept;

    /// Lists of all nodes: of a variable its elements, then variables; of an element its variables.
    std::vector<std::int32_t> lists_;
    std::vector<std::int32_t> start_, length_, elements_;
    /// Of a variable: its weight with its twins', negative in the element being formed, 0 once it
    /// is gone. Of an element: 0.
    std::vector<std::int32_t> weight_;
    std::vector<std::int32_t> degree_;              ///< Of an element: weight of its list.
    std::vector<std::int32_t> head_, next_, prev_;  ///< Variables by degree.
    std::vector<std::int64_t> mark_;                ///< 0: an absorbed element, or a variable.
    std::vector<std::int32_t> twin_, last_twin_;
    std::vector<std::int32_t> twin_mark_;             ///< Lists that are being compared.
    std::vector<std::int32_t> bucket_, bucket_next_;  ///< Variables by a sum of their lists.
    std::vector<std::int32_t> dense_;
    std::int64_t stamp_ = 0;
    std::int32_t free_ = 0;   ///< End of what is used of lists_.
    std::int32_t least_ = 0;  ///< No variable has a smaller degree.
    std::int32_t left_ = 0;   ///< Weight of the variables.
    std::int32_t* order_ = nullptr;
};

}  // namespace hawser::factor
