// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file form.h
/// The two ways to hand a block system to a solver, and the assembly of its values.
///
/// Saddle: every node is kept. Condensed: rows whose compliance block is diagonal and that touch
/// positive nodes only are eliminated first, which adds Gᵀ Σ⁻¹ G to blocks of the others; the
/// multipliers follow from the velocities. All solvers use the same code for it, so that its time
/// counts the same for each.

#include "base/executor.h"
#include "paper_matrix/block_system.h"

#include <cstdint>
#include <vector>

namespace hawser::bench {

/// Adds G_rowᵀ Σ⁻¹ G_col of one eliminated node to a block.
struct Contribution {
    std::int64_t row_g, col_g;  ///< Addresses of its blocks with the row and the column node.
    std::int32_t sigma;         ///< First scalar of the eliminated node.
    std::int32_t rows;
};

/// How one block of the form is computed, and where it is written.
struct BlockOp {
    std::int32_t row = 0, col = 0;    ///< Kept nodes.
    std::int64_t base = -1;           ///< Address of the block in the system; −1: zero.
    std::int32_t begin = 0, end = 0;  ///< Contributions.
    std::int64_t to = 0;              ///< Address of (0, 0).
    std::int32_t step = 1;            ///< From row i to i + 1.
    std::int32_t stride = 0;          ///< From column c to c + 1, less c if `shrink`.
    std::uint8_t row_size = 0, col_size = 0;
    bool by_rows = false;  ///< The base block is stored by rows of the row node.
    bool shrink = false;   ///< Columns get shorter, as in a lower triangle by columns.
};

struct BlockForm {
    bool condensed = false;
    std::vector<std::int32_t> kept;    ///< Nodes of the system, ascending.
    std::vector<std::int32_t> index;   ///< Kept node of each node of the system, −1: eliminated.
    factor::Pattern pattern;           ///< Of the kept nodes.
    std::vector<std::int32_t> offset;  ///< First scalar of each kept node, one more at the end.
    std::vector<BlockOp> ops;          ///< Blocks of the lower triangle, by column, then row.
    std::vector<Contribution> contributions;

    [[nodiscard]] int scalars() const noexcept { return offset.back(); }
};

[[nodiscard]] BlockForm make_form(const BlockSystem& system, bool condensed);

/// Exchange row and column of the blocks whose row node comes before the column node in an order.
/// @param position  Place of each kept node in the order.
void reorient(std::vector<BlockOp>& ops, std::vector<Contribution>& contributions,
              const std::vector<std::int32_t>& position);

/// 1/Σ of every scalar of the eliminated rows; others are left alone. Sized scalars + 8.
void invert_sigma(const BlockSystem& system, const BlockForm& form, std::vector<double>& inverse,
                  base::Executor& executor);

/// Compute all blocks and write them to `target`; on diagonal blocks the lower triangle only.
void assemble(const BlockSystem& system, const std::vector<BlockOp>& ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target, base::Executor& executor);

}  // namespace hawser::bench
