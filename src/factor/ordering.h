// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ordering.h
/// The order of elimination.
///
/// Minimum degree on the graph of blocks, which is 4-6 times smaller than the graph of scalars.
/// Degrees count scalars. Up to MinimumDegree::kMost nodes they are exact (minimum_degree.h), above
/// they are bounds (approximate_degree.h; the AMD library if all nodes have one size). Then one
/// repair that stability needs: a negative node (constraint rows) comes after at least one of its
/// positive neighbours, because with compliance near zero its own diagonal is no pivot at all
/// (Gill, Saunders, Shinnerl, "On the stability of Cholesky factorization for symmetric
/// quasidefinite systems", 1996).

#include "factor/approximate_degree.h"
#include "factor/chains.h"
#include "factor/minimum_degree.h"
#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// Order and chains of a matrix: chains first, then minimum degree on what is left, in which each
/// chain stands as a clique of its boundary.
struct Elimination {
    std::vector<std::int32_t> order;
    Chains chains;
    friend bool operator==(const Elimination&, const Elimination&) = default;
};

/// Makes orders; a used one needs no memory for a pattern of about the same size.
class Orderer {
  public:
    /// Minimum degree. @param order  order[k] = node eliminated k-th. @throws std::bad_alloc.
    void order(const Pattern& pattern, std::vector<std::int32_t>& order);
    /// Approximate minimum degree that counts nodes (the AMD library), for any number of nodes.
    /// @throws std::bad_alloc.
    void order_by_amd(const Pattern& pattern, std::vector<std::int32_t>& order);
    /// Chains, then minimum degree. @throws std::bad_alloc.
    void plan(const Pattern& pattern, std::vector<std::int32_t>& order, Chains& chains);
    /// See place_rows_after_bodies().
    void place_rows(const Pattern& pattern, std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void find_boundaries(const Pattern& pattern, const Chains& chains);
    void find_rest(const Pattern& pattern, const Chains& chains);

    ChainFinder chains_;
    MinimumDegree small_;
    ApproximateDegree large_;
    std::vector<std::int32_t> work_;                    ///< Of AMD.
    std::vector<std::int32_t> position_, head_, next_;  ///< Of place_rows().
    // What chains leave.
    Pattern left_;
    std::vector<std::int32_t> rest_of_, rest_, left_order_;
    std::vector<std::int32_t> boundary_, boundary_begin_;  ///< Of each chain, numbers in rest_.
    std::vector<std::int32_t> touch_, touch_next_, mark_;
};

/// Approximate minimum degree. @return order[k] = node eliminated k-th. @throws std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> order_nodes(const Pattern& pattern);
[[nodiscard]] Elimination plan_elimination(const Pattern& pattern);

/// Move every negative node that precedes all its positive neighbours to just behind the first
/// of them. Other nodes keep their relative order.
void place_rows_after_bodies(const Pattern& pattern, std::vector<std::int32_t>& order);

}  // namespace hawser::factor
