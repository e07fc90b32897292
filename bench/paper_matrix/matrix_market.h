// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file matrix_market.h
/// Read a quasi-definite matrix from a file as a block system, by the code of the example
/// examples/matrix_market.

#include "matrix_market/market.h"
#include "paper_matrix/block_system.h"

#include <string>
#include <vector>

namespace hawser::bench {

using market::indistinguishable_columns;
using market::parse_matrix_market;

/// Make the block system of the groups, positive nodes first; block sizes of 1-6.
[[nodiscard]] BlockSystem group_blocks(const Sparse& lower,
                                       const std::vector<std::vector<int>>& groups);

/// Read a file. @param blocks  File of block sizes in the order of the scalars; empty: detect them.
[[nodiscard]] BlockSystem read_matrix_market(const std::string& file, const std::string& blocks);

}  // namespace hawser::bench
