// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file spy.h
/// Pictures of which scalars of the matrix and of its factor are not zero.

#include "draw/drawing.h"

#include <hawser/hawser.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hawser::draw {

/// Blocks of the factor below the diagonal, by column, in elimination order.
struct FactorBlocks {
    std::vector<std::int64_t> start;  ///< nodes + 1 offsets into `row`.
    std::vector<std::int32_t> row;    ///< Elimination position of each block row, ascending.
    std::vector<bool> fill;           ///< Not in the matrix: came from the elimination.
};

/// Eliminate the block graph symbolically: the rows of a column are its own neighbours and the
/// rows of the columns whose first row it is (George and Liu, "Computer Solution of Large
/// Sparse Positive Definite Systems", 1981).
/// @throws std::runtime_error beyond `limit` blocks.
[[nodiscard]] FactorBlocks factor_blocks(const SystemView& view, std::int64_t limit = 50'000'000);
/// Symbolic elimination of neighbours in compressed rows, in any order.
[[nodiscard]] FactorBlocks factor_blocks(std::span<const std::int32_t> start,
                                         std::span<const std::int32_t> adjacent,
                                         std::span<const std::int32_t> order,
                                         std::int64_t limit = 50'000'000);

/// Left the matrix in the order of the scene, right its factor in elimination order with the
/// fill in a colour of its own.
[[nodiscard]] Drawing plot_spy(const SystemView& view, const FactorBlocks& factor,
                               const std::string& title, const std::string& parameters);

}  // namespace hawser::draw
