// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scalar.h
/// A form as a scalar matrix for the libraries, and the orders to choose from. The matrix is
/// permuted before, so that no library permutes values at each factorisation.

#include "linear/form.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::bench {

enum class Order : std::uint8_t { amd_scalars, amd_blocks, metis_blocks, library };
[[nodiscard]] std::string name_of(Order order);

/// Compute the elimination order of the kept nodes: order[k] = node. @throws if METIS is not in
/// this build.
[[nodiscard]] std::vector<std::int32_t> order_blocks(const BlockForm& form, Order order);

/// Lower triangle of a form in its natural order. Its construction is not timed: users of a library
/// have it.
class ScalarMatrix {
  public:
    ScalarMatrix(const BlockSystem& system, const BlockForm& form);
    /// Read values from the blocks.
    void refresh(const BlockSystem& system, const BlockForm& form,
                 const std::vector<double>& inverse, base::Executor& executor);
    /// Compute order[k] = scalar eliminated k-th. Timed as a part of analysis.
    [[nodiscard]] std::vector<std::int32_t> order_scalars(const BlockForm& form, Order order) const;

    Sparse lower;

  private:
    std::vector<BlockWrite> writes_;    ///< Condensed form: writes of blocks.
    std::vector<std::int64_t> source_;  ///< Saddle form: address of each value in the system.
};

enum class Triangle : std::uint8_t { lower, upper, full };

/// P K Pᵀ by columns, rows ascending, with the index of the source of each value.
struct Permuted {
    std::vector<std::int32_t> order, start, row, source;
    std::vector<double> value;

    void build(const Sparse& lower, std::vector<std::int32_t> order_, Triangle triangle);
    /// Gather the values of the natural lower triangle to `to`; their number is the size of `row`.
    void gather(const Sparse& lower, double* to, base::Executor& executor) const;
    [[nodiscard]] int size() const noexcept { return static_cast<int>(order.size()); }
};

}  // namespace hawser::bench
