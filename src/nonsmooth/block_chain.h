// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_chain.h
/// Block tridiagonal systems of 3×3 blocks, for the nodes of one wire.

#include <cstddef>

namespace hawser::nonsmooth {

/// A block row of K x = b. Blocks are row-major.
struct ChainBlock {
    double diagonal[9];
    double block_before[9];  ///< To the unknowns of the block row before; of the first row unused.
    double block_behind[9];  ///< To those of the next one; of the last row unused.
    double x[3];             ///< b; then x.
};

/// Solve by block elimination without exchange of pivots. Blocks are overwritten.
/// @return false if a pivot block is singular, or a number is not finite.
[[nodiscard]] bool solve_block_chain(std::size_t n, ChainBlock* rows) noexcept;

}  // namespace hawser::nonsmooth
