// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file unsymmetric.h
/// Matrices with a symmetric pattern and some blocks with unsymmetric values: K = L D U, with unit
/// triangles L and U, on the fronts and the schedule of LDLᵀ.
///
/// A front is *unsymmetric* if it contains such a block or if one of its children is unsymmetric,
/// because the update matrix of such a child is unsymmetric. All ancestors of an unsymmetric front
/// are therefore unsymmetric. A batch of
/// chains (batches.h) is one unit, but parents of its chains without such blocks stay symmetric.
/// All other fronts stay LDLᵀ with U = Lᵀ at unchanged cost.
///
/// The lower half of the matrix is written to the panels as usual. The upper half, transposed, is
/// written to a second array of the same layout: block (column, row), transposed, at the address
/// Symbolic::target(row, column). Both halves of a symmetric front would be equal, and the second
/// is neither written nor read.
///
/// ```
/// numeric.reserve(symbolic, threads, true); unsymmetric.reserve(symbolic);
/// ...
/// unsymmetric.find(symbolic, columns);           // of all blocks with unsymmetric values
/// numeric.clear(symbolic, executor); fill the symmetric part of the values;
/// numeric.copy_to_upper(symbolic, unsymmetric, executor);
/// correct values() and upper() where the blocks are unsymmetric;
/// numeric.factor(symbolic, executor, &unsymmetric); numeric.solve(symbolic, x, executor);
/// ```
/// Limits: there is no pivoting. Numeric::nodes_with_wrong_pivots() lists the nodes with a pivot of
/// another sign than Symbolic::sign. Strong friction causes such pivots. If the normal of a sliding
/// contact leans against the axes by more than its friction angle, the first pivot of the body's
/// block is negative. The block as a whole is regular. Such a pivot is used unless it is zero, and
/// refinement on the residual restores the lost digits.
///
/// In an unsymmetric front with symmetric values the arithmetic of the lower half is that of LDLᵀ
/// and gives the same bits.

#include "factor/symbolic.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

struct Piece;

/// The set of unsymmetric fronts.
class Unsymmetric {
  public:
    /// Reserve memory for any set of unsymmetric fronts of this structure, so that find() allocates
    /// nothing.
    /// @throws std::bad_alloc.
    void reserve(const Symbolic& symbolic);

    /// Mark the fronts of a set of columns and of all their ancestors. Columns are nodes in any
    /// order, with duplicates: DirtyParts::column() of each block. @cost O(marked fronts).
    void find(const Symbolic& symbolic, std::span<const std::int32_t> columns) noexcept;

    [[nodiscard]] bool is(std::int32_t front) const noexcept {
        return mark_[static_cast<std::size_t>(front)] != 0;
    }
    [[nodiscard]] bool is_batch(std::int32_t batch) const noexcept {
        return batch_mark_[static_cast<std::size_t>(batch)] != 0;
    }
    /// Return true if any of a piece's panels has a second half.
    /// @cost O(fronts of the piece).
    [[nodiscard]] bool is_piece(const Symbolic& symbolic, const Piece& piece) const noexcept;
    [[nodiscard]] bool empty() const noexcept { return fronts.empty() && batches.empty(); }

    /// Return one mark per front, 1: unsymmetric. All chains of an unsymmetric batch are marked.
    [[nodiscard]] const std::vector<std::uint8_t>& marks() const noexcept { return mark_; }

    std::vector<std::int32_t> fronts;   ///< Unsymmetric fronts without chains, unordered.
    std::vector<std::int32_t> batches;  ///< Unordered.
    /// Flops of a full factorisation with this set; an unsymmetric front counts twice.
    std::int64_t flops = 0;

  private:
    std::vector<std::uint8_t> mark_, batch_mark_;
    std::vector<std::int32_t> marked_;  ///< Non-zero entries of mark_.
};

}  // namespace hawser::factor
