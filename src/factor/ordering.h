// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ordering.h
/// The order of elimination.
///
/// Approximate minimum degree (Amestoy, Davis, Duff, "An approximate minimum degree ordering
/// algorithm", 1996; the AMD library) on the graph of blocks, which is 4-6 times smaller than
/// the graph of scalars. Then one repair that stability needs: a negative node (constraint
/// rows) comes after at least one of its positive neighbours, because with compliance near
/// zero its own diagonal is no pivot at all (Gill, Saunders, Shinnerl, "On the stability of
/// Cholesky factorization for symmetric quasidefinite systems", 1996).

#include "factor/chains.h"
#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// @return order[k] = node eliminated k-th. @throws std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> order_nodes(const Pattern& pattern);

/// Order and chains of a matrix: chains first, then approximate minimum degree on what is left,
/// in which each chain stands as a clique of its boundary.
struct Elimination {
    std::vector<std::int32_t> order;
    Chains chains;
    friend bool operator==(const Elimination&, const Elimination&) = default;
};
[[nodiscard]] Elimination plan_elimination(const Pattern& pattern);

/// Move every negative node that precedes all its positive neighbours to just behind the first
/// of them. Other nodes keep their relative order.
void place_rows_after_bodies(const Pattern& pattern, std::vector<std::int32_t>& order);

}  // namespace hawser::factor
