// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file placer.h
/// Addresses of the blocks of a form in the panels of the factorisation.

#include "factor/numeric.h"
#include "factor/repair.h"
#include "linear/form.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace hawser::bench {

/// Computes the address of every block of a form in the panels. Blocks of a piece are consecutive,
/// since pieces end at ends of fronts. A piece remains in the cache while it is filled; within it,
/// equal blocks are consecutive. A used placer allocates nothing for a form of similar size.
class Placer {
  public:
    using Range = std::pair<std::size_t, std::size_t>;

    /// @param of_piece  By piece: begin and end of its blocks in `ops`.
    /// @throws std::length_error if the panels need more than 32 bits.
    void place(const BlockForm& form, const factor::Analysis& analysis,
               const std::vector<factor::Piece>& pieces, std::vector<BlockWrite>& ops,
               std::vector<Range>& of_piece, base::Executor& executor);

  private:
    /// Data of a node for its blocks.
    struct Place {
        std::int64_t column;    ///< Address of its first column.
        std::int32_t ld, row;   ///< Leading dimension of its front; row in it.
        std::int32_t position;  ///< In the order of elimination.
        std::int32_t group;     ///< Its front; of a chain's node: its step, behind all fronts.
    };
    void find_nodes(const factor::Symbolic& s, const std::vector<factor::Piece>& pieces);
    void sort(const BlockForm& form, base::Executor& executor);
    void place_groups(const BlockForm& form, const factor::Analysis& analysis, std::size_t begin,
                      std::size_t end, std::int32_t* row, BlockWrite* ops) const;

    std::vector<Place> places_;                                    ///< By node.
    std::vector<std::pair<std::int64_t, std::int32_t>> by_place_;  ///< By rank: panel, piece.
    std::vector<std::int32_t> rank_;                               ///< By group: of the piece.
    std::vector<std::int32_t> next_;    ///< By rank: end of the blocks of the piece.
    std::vector<std::int32_t> start_;   ///< By group: end of its blocks in index_.
    std::vector<std::int32_t> column_;  ///< By block: its column's node twice, 1 more if turned.
    std::vector<std::int32_t> index_;   ///< Blocks by group.
    std::vector<std::int32_t> to_;      ///< New index of each block.
    std::vector<std::int32_t> row_;     ///< By node, for each thread: its row in a front.
};

}  // namespace hawser::bench
