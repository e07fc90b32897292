// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file tree.h
/// Postorder, supernodes and their amalgamation.
///
/// A supernode is a chain of nodes whose structures nest. Amalgamation then merges a front with
/// the child just before it when a simple model says that the zeros it adds cost less time
/// than the front it saves (Ashcraft, Grimes, "The influence of relaxed supernode partitions
/// on the multifrontal method", 1989).

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

/// Turns columns into fronts; its buffers live as long as it does.
class TreeBuilder {
  public:
    /// Make `order` a postorder of its own tree, children in the sequence they had, and
    /// `position`, its inverse, that of the new one.
    void postorder(const Columns& columns, std::vector<std::int32_t>& order,
                   std::vector<std::int32_t>& position);

    /// Amalgamated supernodes of a postorder. The nodes of a chain (chains.h) are one front,
    /// whatever its shape. @param chain_of  By node, −1: in no chain; empty: there are none.
    /// @param follows  The columns are those of the last call after a Columns::repair(), nodes and
    ///        chains the same: what a node merges with depends on the branch below it alone, and is
    ///        known where that is as it was.
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
        double time;  ///< Of the front alone, < 0: not known yet.
    };
    /// A front when its last pivot so far came to it.
    struct Grown {
        std::int32_t merged;  ///< Fronts that this pivot joined to one.
        std::int32_t nodes, p;
    };
    std::vector<Growing> growing_;
    std::vector<Grown> grown_;         ///< By node.
    std::vector<std::uint8_t> other_;  ///< By position: something below is not as it was.
    std::vector<std::int32_t> up_, size_, end_, post_, front_at_;
};

}  // namespace hawser::factor
