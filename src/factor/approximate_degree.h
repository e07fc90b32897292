// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file approximate_degree.h
/// Approximate minimum degree with weighted nodes, for graphs too large for minimum_degree.h.
///
/// Quotient graph of Amestoy, Davis, Duff, "An approximate minimum degree ordering algorithm",
/// 1996. A pivot becomes an *element*: the list L_p of its neighbours replaces the clique. A
/// variable i has the degree
///
///   d_i = min(d_i(before) + |L_p \ i|, |A_i \ i| + |L_p \ i| + Σ_e |L_e \ L_p|, left − |i|),
///
/// an upper bound of its true degree. Here |·| is the sum of weights. The weight of a node is its
/// number of scalars (see minimum_degree.h), while the AMD library counts nodes. One pass over the
/// lists of L_p gives |L_e \ L_p| for all elements e. Elements with L_e ⊆ L_p are absorbed.
/// Variables with equal lists are joined. Variables without a neighbour outside L_p are eliminated
/// with the pivot.
///
/// Nodes with more than 100 √n neighbours come last, because each pivot would read their lists.

#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// Order nodes by approximate minimum degree. A second run on a graph of similar size allocates
/// nothing.
class ApproximateDegree {
  public:
    /// Order the nodes of a pattern.
    /// @param order  order[k] = node eliminated k-th.
    /// @throws std::bad_alloc.
    void run(const Pattern& pattern, std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void begin(const Pattern& pattern);
    void insert(std::int32_t node) noexcept;
    void remove(std::int32_t node) noexcept;
    void finish(std::int32_t variable) noexcept;
    void compact_if_needed(std::int32_t pivot) noexcept;
    void form_element(std::int32_t pivot) noexcept;
    void gather(std::int32_t pivot, std::int32_t list, std::int32_t begin,
                std::int32_t end) noexcept;
    void measure_elements(std::int32_t pivot) noexcept;
    void shorten_lists(std::int32_t pivot) noexcept;
    bool remove_covered_entries(std::int32_t pivot, std::int32_t variable) noexcept;
    void join_twins(std::int32_t pivot) noexcept;
    void join_bucket(std::int32_t first) noexcept;
    void close_element(std::int32_t pivot) noexcept;

    /// Lists of all nodes. A variable lists its elements, then its variables; an element lists its
    /// variables.
    std::vector<std::int32_t> lists_;
    std::vector<std::int32_t> start_, length_, elements_;
    /// Weight of a variable with its twins: negative in the element being formed, 0 after
    /// elimination. Elements: 0.
    std::vector<std::int32_t> weight_;
    /// Degree of a variable; for an element the weight of its list.
    std::vector<std::int32_t> degree_;
    std::vector<std::int32_t> head_, next_, prev_;  ///< Variables by degree.
    std::vector<std::int64_t> mark_;                ///< 0: an absorbed element, or a variable.
    std::vector<std::int32_t> twin_, last_twin_;
    std::vector<std::int32_t> twin_mark_;  ///< Last variable whose list marked each node.
    std::vector<std::int32_t> bucket_, bucket_next_;  ///< Variables by a sum of their lists.
    std::vector<std::int32_t> dense_nodes_;
    std::int64_t mark_stamp_ = 0;
    std::int32_t free_ = 0;              ///< End of the used part of lists_.
    std::int32_t least_degree_ = 0;      ///< Lower bound of the degrees of all variables.
    std::int32_t remaining_weight_ = 0;  ///< Total weight of the remaining variables.
    std::int32_t* order_ = nullptr;
};

}  // namespace hawser::factor
