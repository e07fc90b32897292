// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ordering.h
/// Compute the order of elimination.
///
/// The method is minimum degree on the graph of blocks, which is 4-6 times smaller than the graph
/// of scalars. Degrees count scalars. They are exact up to MinimumDegree::kMaximum nodes
/// (minimum_degree.h). For larger graphs they are bounds (approximate_degree.h; the AMD library if
/// all nodes have one size).
///
/// A repair for stability follows: a negative node (constraint rows) comes after at least one of
/// its positive neighbours. With compliance near zero its own diagonal is not a usable pivot (Gill,
/// Saunders, Shinnerl, "On the stability of Cholesky factorization for symmetric quasidefinite
/// systems", 1996).

#include "factor/approximate_degree.h"
#include "factor/chains.h"
#include "factor/minimum_degree.h"
#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// Order and chains of a matrix: chains first, then minimum degree on the other nodes, with each
/// chain replaced by a clique of its boundary.
struct Elimination {
    std::vector<std::int32_t> order;
    Chains chains;
    friend bool operator==(const Elimination&, const Elimination&) = default;
};

/// Computes orders. A second run on a pattern of similar size allocates nothing.
class Orderer {
  public:
    /// Order nodes by minimum degree.
    /// @param order  order[k] = node eliminated k-th.
    /// @throws std::bad_alloc.
    void order(const Pattern& pattern, std::vector<std::int32_t>& order);
    /// Order nodes by approximate minimum degree that counts nodes (the AMD library), for any
    /// number of nodes.
    /// @throws std::bad_alloc.
    void order_by_amd(const Pattern& pattern, std::vector<std::int32_t>& order);
    /// Find chains, then order the other nodes by minimum degree.
    /// @throws std::bad_alloc.
    void plan(const Pattern& pattern, std::vector<std::int32_t>& order, Chains& chains);
    /// Reorder so that each row is eliminated after its bodies (place_rows_after_bodies()).
    void place_rows(const Pattern& pattern, std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void find_boundaries(const Pattern& pattern, const Chains& chains);
    void build_pattern_without_chains(const Pattern& pattern, const Chains& chains);

    ChainFinder chains_;
    MinimumDegree minimum_degree_;
    ApproximateDegree amd_;
    std::vector<std::int32_t> work_;                    ///< Scratch of AMD.
    std::vector<std::int32_t> position_, head_, next_;  ///< Scratch of place_rows().
    // Pattern and data of the nodes outside chains.
    Pattern remaining_pattern_;
    std::vector<std::int32_t> index_outside_chains_, nodes_outside_, outside_order_;
    std::vector<std::int32_t> boundary_,
        boundary_begin_;  ///< Boundary of each chain: indices into rest_.
    std::vector<std::int32_t> touch_, touch_next_, mark_;
};

/// Order nodes by approximate minimum degree.
/// @return order[k] = node eliminated k-th.
/// @throws std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> order_nodes(const Pattern& pattern);
[[nodiscard]] Elimination plan_elimination(const Pattern& pattern);

/// Move every negative node that precedes all its positive neighbours: its new position is directly
/// behind the first of them. Other nodes keep their relative order.
void place_rows_after_bodies(const Pattern& pattern, std::vector<std::int32_t>& order);

}  // namespace hawser::factor
