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
    std::string missing;              ///< Reason why there is no order; "": there is one.
    std::vector<std::int32_t> order;  ///< order[k] = node eliminated k-th.
    draw::FactorBlocks factor;
    draw::MatrixCounts counts;
    /// Figures of the solver, summed over parts: fronts are merged, and their zeros count.
    std::int64_t solver_nnz = 0, solver_matrix_nnz = 0, solver_flops = 0;
    std::vector<double> part_seconds;  ///< Median time of each part; a whole matrix is one part.
    int samples = 0;                   ///< Least number of samples of the medians.

    [[nodiscard]] double seconds() const;  ///< Return the time of all parts, one after the other.
    [[nodiscard]] double longest_seconds() const;  ///< Return the largest time of a part.
};

/// Order a matrix.
/// @param parts  Number of parts of the graph, each ordered separately; 0: order the whole graph.
[[nodiscard]] OrderedMatrix order_matrix(const draw::BlockGraph& graph, std::int32_t parts,
                                         Ordering ordering);

/// Measure the factorisations alternately, so that disturbances affect all matrices. A sample
/// writes the values and factors on one thread, and is measured by processor time. Values are
/// random; times do not depend on them. A matrix with long times gets fewer samples. @throws
/// std::runtime_error if a factorisation fails. @param max_flops  Orders that need more are not
/// factored: samples stays 0.
void time_matrices(const std::vector<OrderedMatrix*>& matrices, int samples, double max_flops);

}  // namespace hawser::cli
