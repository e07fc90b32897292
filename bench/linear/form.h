// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file form.h
/// The two forms in which a block system is passed to a solver, and the assembly of its values.
///
/// Saddle: every node is kept. Condensed: rows with a diagonal compliance block that touch only
/// positive nodes are eliminated first. This adds Gᵀ Σ⁻¹ G to blocks of the others. The multipliers
/// follow from the velocities. All solvers use the same code for it, so that its time is equal for
/// each.

#include "base/executor.h"
#include "paper_matrix/block_system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::bench {

/// Largest number of eliminated rows processed together.
inline constexpr int kMostRows = 3;

/// Adds Σ g_rowᵀ Σ⁻¹ g_col over 1 … kMostRows successive eliminated rows of a node to a block.
struct Contribution {
    /// Addresses of the blocks of the first row with the row node and the column node.
    std::int32_t g[2];
    std::int32_t sigma;  ///< Its scalar.
};

/// Computation of one block of the form. Contributions of one row come first, then those of two,
/// then those of three.
struct BlockOp {
    std::int32_t row = 0, col = 0;       ///< Kept nodes.
    std::int32_t base = -1;              ///< Address of the block in the system; −1: zero.
    std::int32_t begin = 0;              ///< Its contributions.
    std::int32_t count[kMostRows] = {};  ///< Contributions of one row, of two, of three.
    std::uint8_t row_size = 0, col_size = 0;
    bool by_rows = false;  ///< The base block is stored by rows of the row node.
};

/// A block and the address to which it is written: half a cache line, since there are many.
struct BlockWrite {
    std::int32_t base = -1, begin = 0;
    std::int32_t count[kMostRows] = {};
    std::uint32_t to = 0;     ///< Address of (0, 0).
    std::int32_t stride = 0;  ///< From column c to c + 1, less c if `shrink`.
    std::uint8_t row_size : 4 = 0, col_size : 4 = 0;
    std::uint8_t step = 1;     ///< From row i to i + 1.
    bool by_rows : 1 = false;  ///< Base block stored by rows of the row node.
    bool shrink : 1 = false;   ///< Columns get shorter, as in a lower triangle by columns.
    /// Row node and column node have been exchanged since the form was made.
    bool turned : 1 = false;
    bool diagonal : 1 = false;
    /// Written together with the others, so that no read is needed first.
    std::uint8_t unused : 4 = 0;

    BlockWrite() = default;
    /// @param turn  The block is written transposed. @throws std::length_error if the address needs
    /// more than 32 bits.
    BlockWrite(const BlockOp& op, bool turn, std::int64_t address, int row_step, int column_stride)
        : base(op.base),
          begin(op.begin),
          to(static_cast<std::uint32_t>(address)),
          stride(column_stride),
          row_size(swapped(op.row_size, op.col_size, turn)),
          col_size(swapped(op.col_size, op.row_size, turn)),
          step(static_cast<std::uint8_t>(row_step)),
          by_rows(op.by_rows != turn),
          turned(turn),
          diagonal(op.row == op.col) {
        for (int k = 0; k < kMostRows; ++k) count[k] = op.count[k];
        if (address != to) out_of_reach();
    }
    [[noreturn]] static void out_of_reach();

  private:
    /// Exchange without a branch, which the processor could not predict.
    static std::uint8_t swapped(std::uint8_t a, std::uint8_t b, bool swap) noexcept {
        return static_cast<std::uint8_t>(a ^ ((a ^ b) & -static_cast<int>(swap)));
    }
};
static_assert(sizeof(BlockWrite) == 32);

/// Data of each node for the products with blocks (sweeps.h), in the order of use. Rows here have a
/// diagonal compliance block and touch only positive nodes, whether a form eliminates them or not.
/// All other nodes are bodies.
struct SweepTables {
    struct Row {
        std::int32_t scalar, sigma;  ///< Its first scalar; address of its compliance block.
        std::int32_t end;  ///< End of its terms; they begin at the end of the previous ones.
        std::int32_t rows;
    };
    struct RowTerm {
        std::int32_t g, scalar, size;  ///< Address of the block by rows; the neighbour's scalars.
    };
    struct Body {
        std::int32_t scalar, to;      ///< First scalar in the system, in the form.
        std::int32_t diagonal, size;  ///< Address of the diagonal block.
        std::int32_t end, other_end;  ///< Ends of its columns and of its other neighbours.
    };
    struct Column {
        std::int32_t g, scalar;  ///< Address of the part of one row; scalar of the row.
    };
    struct Other {
        std::int32_t block, scalar, size;  ///< A block with another body.
        bool by_rows;
    };
    std::vector<Row> rows;
    std::vector<RowTerm> row_terms;
    std::vector<Body> bodies;
    std::vector<Column> columns;
    std::vector<Other> others;
    std::vector<std::int32_t> row_to;  ///< Saddle form: first scalar of each row in the form.
};

struct BlockForm {
    bool condensed = false;
    std::vector<std::int32_t> kept;    ///< Nodes of the system, ascending.
    std::vector<std::int32_t> index;   ///< Kept node of each node of the system, −1: eliminated.
    factor::Pattern pattern;           ///< Pattern of the kept nodes.
    std::vector<std::int32_t> offset;  ///< First scalar of each kept node, one more at the end.
    std::vector<BlockOp> ops;          ///< Blocks of the lower triangle, by column, then row.
    std::vector<std::int32_t> alike;  ///< Indices of `ops`, those of one shape and length together.
    std::vector<Contribution> contributions;
    SweepTables tables;

    [[nodiscard]] int scalars() const noexcept { return offset.back(); }
};

[[nodiscard]] BlockForm make_form(const BlockSystem& system, bool condensed);

/// Return an order of blocks by shape, then by number of contributions. The ends of loops over
/// equal blocks are then predictable. @return indices, ascending among equal blocks.
[[nodiscard]] std::vector<std::int32_t> order_alike(std::span<const BlockOp> ops);

/// Make the tables of a form with known nodes and offsets. @throws std::length_error if the system
/// is too large for 32-bit addresses.
[[nodiscard]] SweepTables make_tables(const BlockSystem& system, const BlockForm& form);
/// @return true if the node can be eliminated before all others.
[[nodiscard]] bool can_be_eliminated(const BlockSystem& system, int node);

/// 1/Σ of every scalar of the eliminated rows; others are left alone. Sized scalars + 8.
void invert_sigma(const BlockSystem& system, const BlockForm& form, std::vector<double>& inverse,
                  base::Executor& executor);

/// Compute blocks and write them to `target`; of diagonal blocks the lower triangle counts.
void assemble(const BlockSystem& system, std::span<const BlockWrite> ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target) noexcept;
/// Compute blocks and write them to `target` with a team.
void assemble(const BlockSystem& system, const std::vector<BlockWrite>& ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target, base::Executor& executor);

}  // namespace hawser::bench
