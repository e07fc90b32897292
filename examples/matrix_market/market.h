// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file market.h
/// A symmetric matrix from a file, and its division into blocks.
///
/// Format: Boisvert, Pozo, Remington, "The Matrix Market exchange formats" (NISTIR 5935, 1996);
/// coordinate, real or integer, symmetric.

#include <Eigen/Sparse>

#include <istream>
#include <string>
#include <vector>

namespace market {

using Sparse = Eigen::SparseMatrix<double>;  ///< By columns, 32-bit indices.

/// Return the lower triangle. @throws std::runtime_error with the line.
[[nodiscard]] Sparse parse_matrix_market(std::istream& in);
/// Read the lower triangle from a file. @throws std::runtime_error with file and line.
[[nodiscard]] Sparse read_lower(const std::string& file);

/// @return true if the diagonal entry, and thus the pivot, is positive. An entry that is zero or
/// missing counts as negative: a row without compliance.
[[nodiscard]] bool positive(const Sparse& lower, int scalar);

/// Return groups of at most six scalars. Their columns have entries in the same rows and diagonal
/// entries of the same sign. Scalars of a group ascend; groups are sorted by their first scalar.
[[nodiscard]] std::vector<std::vector<int>> indistinguishable_columns(const Sparse& lower);

/// Read groups of consecutive scalars from a file of their sizes, 1-6.
[[nodiscard]] std::vector<std::vector<int>> read_block_sizes(const std::string& file, int scalars);

/// Read the numbers of a file; a Matrix Market array header is allowed.
[[nodiscard]] std::vector<double> read_vector(const std::string& file, int scalars);

}  // namespace market
