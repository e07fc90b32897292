// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file placer.h
/// Addresses of the blocks of a form in the panels of Hawser's factorisation.

#include "factor/numeric.h"
#include "factor/repair.h"
#include "linear/form.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace hawser::bench {

/// Assigns an address in the panels to every block of a form. Blocks of a piece are adjacent, as
/// pieces end where fronts end. Within a piece, which stays in cache while it is filled, equal
/// blocks follow each other. A used placer allocates nothing for a form of about the same size.
class Placer {
  public:
    using Range = std::pair<std::size_t, std::size_t>;

    /// Assign addresses. @param of_piece  By piece: begin and end of its blocks in `ops`. @throws
    /// std::length_error if the panels need more than 32 bits.
    void place(const BlockForm& form, const factor::Analysis& analysis,
               const std::vector<factor::Piece>& pieces, std::vector<BlockWrite>& ops,
               std::vector<Range>& of_piece, base::Executor& executor);

  private:
    /// Data of a node.
    struct Place {
        std::int64_t column;    ///< Address of its first column.
        std::int32_t ld, row;   ///< Leading dimension of its front; row in it.
        std::int32_t position;  ///< Position in the order of elimination.
        std::int32_t group;     ///< Its front; for a node of a chain: its step, after all fronts.
    };
    void find_nodes(const factor::Symbolic& s, const std::vector<factor::Piece>& pieces);
    void sort(const BlockForm& form, base::Executor& executor);
    void assign_group_addresses(const BlockForm& form, const factor::Analysis& analysis,
                                std::size_t begin, std::size_t end, std::int32_t* row,
                                BlockWrite* ops) const;

    std::vector<Place> places_;                                   ///< By node.
    std::vector<std::pair<std::int64_t, std::int32_t>> by_slot_;  ///< By rank: panel, piece.
    std::vector<std::int32_t> rank_;                              ///< By group: rank of the piece.
    std::vector<std::int32_t> next_;    ///< By rank: end of the blocks of the piece.
    std::vector<std::int32_t> start_;   ///< By group: end of its blocks in index_.
    std::vector<std::int32_t> column_;  ///< By block: node of its column times two, plus 1 if
                                        ///< transposed.
    std::vector<std::int32_t> index_;   ///< Blocks by group.
    std::vector<std::int32_t> to_;      ///< By block: final position.
    std::vector<std::int32_t> row_;     ///< By node, for each thread: its row in a front.
};

}  // namespace hawser::bench
