// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file tree.h
/// Postorder, supernodes and their amalgamation.
///
/// A supernode is a chain of nodes whose structures nest. Amalgamation merges a front with the
/// child just before it if this saves time by a simple model. The added zeros must cost less than
/// the saved front (Ashcraft, Grimes, "The influence of relaxed supernode partitions on the
/// multifrontal method", 1989).

#include "factor/columns.h"
#include "factor/pattern.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

struct Supernodes {
    std::vector<std::int32_t> begin;   ///< fronts + 1 positions: pivots of each front.
    std::vector<std::int32_t> parent;  ///< Front, −1 at a root.
    std::vector<std::int32_t> p;       ///< Pivot scalars.
};

/// Turns columns into fronts and keeps its buffers.
class TreeBuilder {
  public:
    /// Make `order` a postorder of its own tree, with children in their former sequence, and update
    /// `position`, its inverse.
    void postorder(const Columns& columns, std::vector<std::int32_t>& order,
                   std::vector<std::int32_t>& position);

    /// Compute the amalgamated supernodes of a postorder. The nodes of a chain (chains.h) are one
    /// front of any shape.
    /// @param chain_of  By node, −1: in no chain; empty: no chains.
    /// @param follows  True if the columns result from the last call and a Columns::repair(), with
    ///        the same nodes and chains. Merging depends on the branch below a node alone, so
    ///        unchanged branches are reused.
    void grow_fronts(const Pattern& pattern, const Columns& columns,
                     std::span<const std::int32_t> order, std::span<const std::int32_t> position,
                     std::span<const std::int32_t> chain_of, bool follows, Supernodes& out);

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    struct Growing {
        std::int32_t begin, end;  ///< Pivot positions.
        std::int32_t p, q;        ///< Pivot and update scalars.
        std::int32_t parent;      ///< Position of the last pivot's parent.
        std::int32_t chain;
        double time;  ///< Time of the front alone, < 0: not computed yet.
    };
    /// State of a front after its last pivot joined.
    struct Grown {
        std::int32_t merged;  ///< Number of fronts that this pivot merged.
        std::int32_t nodes, p;
    };
    std::vector<Growing> growing_;
    std::vector<Grown> front_size_;    ///< By node.
    std::vector<std::uint8_t> other_;  ///< By position: 1 if a node below changed.
    std::vector<std::int32_t> up_, size_, end_, post_, front_at_;
};

}  // namespace hawser::factor
