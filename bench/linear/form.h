// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file form.h
/// The two forms in which solvers get a block system, and the assembly of their values.
///
/// Saddle: every node is kept. Condensed: rows whose compliance block is diagonal and that touch
/// only positive nodes are eliminated first, which adds Gᵀ Σ⁻¹ G to blocks of the others; the
/// multipliers follow from the velocities. All solvers share this code, so that its time is equal
/// for each.

#include "base/executor.h"
#include "paper_matrix/block_system.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::bench {

/// Largest number of eliminated rows that are processed together.
inline constexpr int kMaxRows = 3;

/// Adds Σ g_rowᵀ Σ⁻¹ g_col over 1 … kMaxRows successive eliminated rows of a node to a block.
struct Contribution {
    std::int32_t g[2];   ///< Addresses of the first row's parts with the row node and the column
                         ///< node.
    std::int32_t sigma;  ///< Its scalar.
};

/// Computation of one block of the form. Contributions of one row come first, then those of two,
/// then those of three.
struct BlockOp {
    std::int32_t row = 0, col = 0;      ///< Kept nodes.
    std::int32_t base = -1;             ///< Address of the block in the system; −1: zero.
    std::int32_t begin = 0;             ///< First of its contributions.
    std::int32_t count[kMaxRows] = {};  ///< Number of contributions of one row, two, three.
    std::uint8_t row_size = 0, col_size = 0;
    bool by_rows = false;  ///< The base block is stored by rows of the row node.
};

/// A block and the address to which it is written: half a cache line, as there are many.
struct BlockWrite {
    std::int32_t base = -1, begin = 0;
    std::int32_t count[kMaxRows] = {};
    std::uint32_t to = 0;     ///< Address of (0, 0).
    std::int32_t stride = 0;  ///< From column c to c + 1, less c if `shrink`.
    std::uint8_t row_size : 4 = 0, col_size : 4 = 0;
    std::uint8_t step = 1;     ///< From row i to i + 1.
    bool by_rows : 1 = false;  ///< Base block by rows of the node whose rows are written.
    bool shrink : 1 = false;   ///< Columns get shorter, as in a lower triangle by columns.
    bool turned : 1 = false;   ///< Row and column node were exchanged after the form was made.
    bool diagonal : 1 = false;
    std::uint8_t unused : 4 = 0;  ///< Written with the others to avoid a read.

    BlockWrite() = default;
    /// Make a write operation of a block. @param turn  Write the block transposed. @throws
    /// std::length_error if the address needs more than 32 bits.
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
        for (int k = 0; k < kMaxRows; ++k) count[k] = op.count[k];
        if (address != to) is_out_of_reach();
    }
    [[noreturn]] static void is_out_of_reach();

  private:
    /// Select without a branch: the result is not predictable.
    static std::uint8_t swapped(std::uint8_t a, std::uint8_t b, bool swap) noexcept {
        return static_cast<std::uint8_t>(a ^ ((a ^ b) & -static_cast<int>(swap)));
    }
};
static_assert(sizeof(BlockWrite) == 32);

/// Data of each node for the products with the blocks (sweeps.h), in the order of their use. Rows
/// here have a diagonal compliance block and touch only positive nodes, whether a form eliminates
/// them or not; all other nodes are bodies.
struct SweepTables {
    struct Row {
        std::int32_t scalar, sigma;  ///< First scalar; address of the compliance block.
        std::int32_t end;            ///< End of its terms, which start at the end of the previous
                                     ///< node's.
        std::int32_t rows;
    };
    struct RowTerm {
        std::int32_t g, scalar, size;  ///< Address of the block by rows; the neighbour's scalars.
    };
    struct Body {
        std::int32_t scalar, to;      ///< First scalar in the system, and in the form.
        std::int32_t diagonal, size;  ///< Address of the diagonal block.
        std::int32_t end, other_end;  ///< End of its columns; end of its other neighbours.
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
    std::vector<std::int32_t> offset;  ///< First scalar of each kept node, and the end.
    std::vector<BlockOp> ops;          ///< Blocks of the lower triangle, by column, then row.
    std::vector<std::int32_t> alike;  ///< Indices of `ops`, sorted so that equal shapes and lengths
                                      ///< are adjacent.
    std::vector<Contribution> contributions;
    SweepTables tables;

    [[nodiscard]] int scalars() const noexcept { return offset.back(); }
};

[[nodiscard]] BlockForm make_form(const BlockSystem& system, bool condensed);

/// Sort blocks by shape, then by the number of contributions: loops over equal blocks have
/// predictable ends. @return indices, ascending among equals.
[[nodiscard]] std::vector<std::int32_t> order_alike(std::span<const BlockOp> ops);

/// Make the tables of a form whose nodes and offsets are known. @throws std::length_error if the
/// system is too large for 32-bit addresses.
[[nodiscard]] SweepTables make_tables(const BlockSystem& system, const BlockForm& form);
/// True if the node can be eliminated before all others.
[[nodiscard]] bool can_be_eliminated(const BlockSystem& system, int node);

/// Compute 1/Σ of every scalar of the eliminated rows; other entries are unchanged. Size: scalars +
/// 8.
void invert_sigma(const BlockSystem& system, const BlockForm& form, std::vector<double>& inverse,
                  base::Executor& executor);

/// Compute blocks and write them to `target`; only the lower triangle of diagonal blocks is used.
void assemble(const BlockSystem& system, std::span<const BlockWrite> ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target) noexcept;
/// Compute blocks and write them to `target` with a team.
void assemble(const BlockSystem& system, const std::vector<BlockWrite>& ops,
              const std::vector<Contribution>& contributions, const std::vector<double>& inverse,
              double* target, base::Executor& executor);

}  // namespace hawser::bench
