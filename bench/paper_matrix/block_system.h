// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_system.h
/// A quasi-definite linear system K x = b in blocks: the common input of all compared solvers.
///
/// K = [A Gᵀ; G −Σ]. Positive nodes (bodies) have diagonal blocks and couplings A; negative nodes
/// (rows of interactions) have G and the diagonal Σ. A block is stored once by rows, for the pair
/// (higher, lower) of node numbers, with the rows of the higher node. Entry (i, j) is at address +
/// i · size(lower) + j. Thus a row of G is contiguous.

#include "factor/pattern.h"

#include <Eigen/Sparse>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hawser::bench {

using Sparse = Eigen::SparseMatrix<double>;  ///< Scalar matrix by columns, 32-bit indices.

struct BlockSystem {
    std::string name;
    factor::Pattern pattern;
    std::vector<std::int32_t> offset;    ///< First scalar of each node, and the end.
    std::vector<std::int64_t> diagonal;  ///< Address of each diagonal block, full and symmetric.
    std::vector<std::int64_t> edge;      ///< Address of the block of each pattern.adjacent entry.
    std::vector<double> values;          ///< Blocks; 8 more numbers at the end, for vector loads.
    std::vector<double> rhs;
    int bodies = 0;  ///< Number of positive nodes, for costs per body.

    [[nodiscard]] int scalars() const noexcept { return offset.back(); }
    [[nodiscard]] int size(int node) const noexcept {
        return pattern.size[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] bool positive(int node) const noexcept {
        return pattern.sign[static_cast<std::size_t>(node)] > 0;
    }
    /// Return entry (i, j) of the block with the rows of node a and the columns of node b; k is the
    /// index of b among the neighbours of a.
    [[nodiscard]] double at(int a, int k, int i, int j) const noexcept;

    /// Count connected components of the block graph.
    [[nodiscard]] int islands() const;
    /// Return the lower triangle in the scalar order of the nodes. Exact zeros in off-diagonal
    /// blocks, and off the diagonal of Σ, are left out: libraries get the sparser form.
    [[nodiscard]] Sparse lower() const;
};

/// Collects nodes and blocks in any order.
class SystemBuilder {
  public:
    /// Add a node with its symmetric diagonal block. @return node.
    int add_node(int size, int sign, std::span<const double> block);
    /// Add a body with its inertia, dof × dof. @return node.
    int add_body(int dof, std::span<const double> inertia) { return add_node(dof, 1, inertia); }
    /// Add rows of an interaction with compliance sigma > 0 each; G follows by add_block().
    int add_rows(std::span<const double> sigma);
    /// Add the block with the rows of `high` and the columns of `low` < high, by rows. Each pair at
    /// most once.
    void add_block(int high, int low, std::span<const double> block);
    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(size_.size()); }

    /// Make the system. @param rhs_seed  Seed of the right-hand side, whose solution has velocities
    /// of about 1 m/s and multipliers of about 1e3 N s.
    [[nodiscard]] BlockSystem finish(std::string name, std::uint64_t rhs_seed);

  private:
    std::vector<std::int8_t> size_, sign_;
    std::vector<std::int64_t> diagonal_, address_;
    std::vector<std::int32_t> high_, low_;
    std::vector<double> values_;
};

/// Compute y = K x from the blocks.
void multiply(const BlockSystem& system, std::span<const double> x, std::span<double> y);

}  // namespace hawser::bench
