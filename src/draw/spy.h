// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file spy.h
/// Draw the nonzero scalars of the matrix and of its factor.

#include "draw/drawing.h"

#include <hawser/hawser.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hawser::draw {

/// Blocks of the factor below the diagonal, by column, in elimination order.
struct FactorBlocks {
    std::vector<std::int64_t> start;  ///< Offsets of the columns in `row`, nodes + 1 entries.
    std::vector<std::int32_t> row;    ///< Elimination position of each block row, ascending.
    std::vector<bool> fill;           ///< True if the block is fill: not in the matrix.
};

/// Eliminate the block graph symbolically. The rows of a column are its neighbours in the graph,
/// and the rows of all columns whose first row is this column. Source: George and Liu, "Computer
/// Solution of Large Sparse Positive Definite Systems", 1981.
/// @throws std::runtime_error if there are more than `limit` blocks.
[[nodiscard]] FactorBlocks factor_blocks(const SystemView& view, std::int64_t limit = 50'000'000);
/// Eliminate neighbours in compressed rows symbolically, in any order.
[[nodiscard]] FactorBlocks factor_blocks(std::span<const std::int32_t> start,
                                         std::span<const std::int32_t> adjacent,
                                         std::span<const std::int32_t> order,
                                         std::int64_t limit = 50'000'000);

/// Draw the matrix in the order of the scene on the left, and its factor in elimination order on
/// the right. Fill has a colour of its own.
[[nodiscard]] Drawing plot_spy(const SystemView& view, const FactorBlocks& factor,
                               const std::string& title, const std::string& parameters);

}  // namespace hawser::draw
