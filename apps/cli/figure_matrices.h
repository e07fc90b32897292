// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file figure_matrices.h
/// The matrices of the paper's figures, ordered, counted and factored.

#include "draw/figures/block_graph.h"
#include "elimination_orders.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::cli {

/// One matrix in one order. A split matrix has its parts side by side.
struct OrderedMatrix {
    Ordering ordering = Ordering::natural;
    const draw::BlockGraph* graph = nullptr;
    std::string missing;              ///< Why there is no order; "": there is.
    std::vector<std::int32_t> order;  ///< order[k] = node eliminated k-th.
    draw::FactorBlocks factor;
    draw::MatrixCounts counts;
    /// Of the solver, summed over parts: fronts merged, their zeros counted.
    std::int64_t solver_nnz = 0, solver_matrix_nnz = 0, solver_flops = 0;
    std::vector<double> part_seconds;  ///< Of each part, a whole matrix being one; median.
    int samples = 0;                   ///< Behind the medians, at least.

    [[nodiscard]] double seconds() const;          ///< All parts, one after the other.
    [[nodiscard]] double longest_seconds() const;  ///< Of the part that takes longest.
};

/// @param parts  Parts of the graph, each ordered by itself; 0: the whole as one.
[[nodiscard]] OrderedMatrix order_matrix(const draw::BlockGraph& graph, std::int32_t parts,
                                         Ordering ordering);

/// Measure factorisations in turns, so that whatever disturbs meets all of them: writing the
/// values and factoring, on one thread, by its processor time. Values are drawn; times do not
/// depend on them. A matrix that takes long gets fewer samples. @throws std::runtime_error where a
/// factorisation fails.
/// @param most_flops  Orders that need more are not factored: samples stays 0.
void time_matrices(std::vector<OrderedMatrix*> matrices, int samples, double most_flops);

}  // namespace hawser::cli
