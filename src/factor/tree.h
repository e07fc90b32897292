// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file tree.h
/// Elimination tree, structure of the columns, supernodes and their amalgamation.
///
/// Tree: Liu, "The role of elimination trees in sparse factorization" (1990), with path
/// compression. Structure: struct(k) = neighbours after k ∪ struct of its children. A
/// supernode is a chain of nodes whose structures nest. Amalgamation then merges a front with
/// the child just before it when a simple model says that the zeros it adds cost less time
/// than the front it saves (Ashcraft, Grimes, "The influence of relaxed supernode partitions
/// on the multifrontal method", 1989).

#include "factor/pattern.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

struct Supernodes {
    std::vector<std::int32_t> begin;      ///< fronts + 1 positions: pivots of each front.
    std::vector<std::int32_t> parent;     ///< Front, −1 at a root.
    std::vector<std::int32_t> row_begin;  ///< fronts + 1 offsets into rows.
    std::vector<std::int32_t> rows;       ///< Update nodes of each front as positions, ascending.
};

/// Parent of each position in the elimination tree; −1 at a root.
[[nodiscard]] std::vector<std::int32_t> elimination_tree(const Pattern& pattern,
                                                         const std::vector<std::int32_t>& order);

/// Build the tree, turn `order` into a postorder of it, and form amalgamated supernodes. The
/// nodes of a chain (chains.h) are one front, whatever its shape. @param chain_of by node, −1: in
/// no chain; empty: there are none.
[[nodiscard]] Supernodes build_tree(const Pattern& pattern, std::vector<std::int32_t>& order,
                                    const std::vector<std::int32_t>& chain_of = {});

}  // namespace hawser::factor
