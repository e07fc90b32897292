// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file matrix_market.h
/// A quasi-definite matrix from a file, as a block system.
///
/// Format: Boisvert, Pozo, Remington, "The Matrix Market exchange formats" (NISTIR 5935, 1996);
/// coordinate, real or integer, symmetric. The sign of a pivot is that of the diagonal entry; an
/// entry that is zero or missing counts as negative, a row without compliance.

#include "paper_matrix/block_system.h"

#include <istream>
#include <string>
#include <vector>

namespace hawser::bench {

/// Lower triangle. @throws std::runtime_error naming the line.
[[nodiscard]] Sparse parse_matrix_market(std::istream& in);

/// Groups of at most six scalars whose columns have entries in the same rows and diagonal entries
/// of the same sign; each group ascending, groups by their first scalar.
[[nodiscard]] std::vector<std::vector<int>> indistinguishable_columns(const Sparse& lower);

/// The block system of the groups, positive nodes first; block sizes of 1-6.
[[nodiscard]] BlockSystem group_blocks(const Sparse& lower,
                                       const std::vector<std::vector<int>>& groups);

/// @param blocks  File of block sizes in the order of the scalars; empty: detect them.
[[nodiscard]] BlockSystem read_matrix_market(const std::string& file, const std::string& blocks);

}  // namespace hawser::bench
