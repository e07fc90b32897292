// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file factor.h
/// Direct solver for use outside a world: K x = b for a sparse symmetric quasi-definite block
/// matrix K.
///
/// K = [A Gᵀ; G −Σ] with A and Σ positive definite, in any row order. Such systems arise in
/// constrained mechanics, interior-point methods and equality-constrained least squares. K has the
/// factorisation K = L D Lᵀ with diagonal D for every symmetric permutation (Vanderbei, "Symmetric
/// quasidefinite matrices", 1995). The signs of D are known in advance, so that no pivoting is
/// needed. A positive definite matrix is the case without negative nodes. Accuracy decreases if Σ
/// is nearly zero and G is nearly rank-deficient: check residual() and use refine().
///
/// ```
/// hawser::BlockPattern p;                    // three unknowns, one constraint
/// p.size = {3, 1};
/// p.sign = {+1, -1};
/// p.edges = {{1, 0}};                        // a block with the row of node 1, columns of node 0
/// hawser::BlockFactor f;
/// f.analyse(p);
/// std::vector<double> k(f.value_count());    // fill k[f.value_begin(block) …], see below
/// if (f.factor(k) != hawser::Status::ok) …   // the matrix is not quasi-definite
/// f.solve(x);                                // b in, x out
/// ```
/// Block i is the diagonal block of node i, block nodes + e that of edge e. One array contains the
/// values of all blocks in this order, each by rows. Only the lower triangle of a diagonal block is
/// read.
///
/// analyse() and update() may allocate, and throw if the pattern is malformed. The other functions
/// do not allocate or throw, and report by a Status: factor(), refactor(), solve(), multiply(),
/// residual(), refine(). Results are equal to the bit for any number of threads. Use an object from
/// one thread at a time.

#include <hawser/stats.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hawser {

/// Off-diagonal block that may be non-zero.
struct BlockEdge {
    std::int32_t row = 0, column = 0;  ///< Nodes; the block has the rows of node `row`.
};

/// Sparsity pattern of a block matrix: its nodes (diagonal blocks) and edges (off-diagonal blocks).
struct BlockPattern {
    std::vector<std::int8_t> size{};  ///< Number of scalars of each node, 1-6.
    std::vector<std::int8_t> sign{};  ///< Sign of the pivots of each node, +1 or −1.
    std::vector<BlockEdge> edges{};   ///< Each pair of nodes once, in either order.
};

/// Options of a BlockFactor.
struct FactorOptions {
    int threads = 1;  ///< Number of threads, the caller included.
    /// True: keep the update matrices that refactor() needs, in separate memory.
    bool partial = false;
};

/// Figures of the last analysis and factorisation.
struct FactorInfo {
    std::int64_t nodes = 0, scalars = 0;  ///< Numbers of nodes and of unknowns.
    std::int64_t fronts = 0;      ///< Number of fronts (dense matrices) of the factorisation.
    std::int64_t matrix_nnz = 0;  ///< Number of scalars of K, lower triangle.
    std::int64_t factor_nnz = 0;  ///< Number of scalars of L, including zeros of merged fronts.
    std::int64_t flops = 0;       ///< Flops of factor().
    std::int64_t path_flops = 0;  ///< Flops on the longest path from a leaf to a root.
    std::int64_t part_flops = 0;  ///< Flops of the last refactor().
    std::int64_t columns = 0;     ///< Block columns that the last analyse() or update() computed.
    std::int64_t bytes = 0;       ///< Allocated memory [bytes].
    bool planned = true;          ///< True if the last analyse() or update() computed a new order.
    std::int64_t wrong_pivots = 0;  ///< Number of pivots of wrong sign or not finite in the last
                                    ///< factor() or refactor().
};

/// Analysis, factorisation and solution of a block matrix.
class BlockFactor {
  public:
    explicit BlockFactor(const FactorOptions& options = {});
    ~BlockFactor();
    BlockFactor(BlockFactor&&) noexcept;
    BlockFactor& operator=(BlockFactor&&) noexcept;

    /// Analyse a pattern: compute an elimination order with little fill, and all addresses.
    /// @throws std::invalid_argument, std::bad_alloc.
    void analyse(const BlockPattern& pattern);

    /// Analyse a pattern with a given elimination order. The order in use may be an equivalent
    /// postorder of its elimination tree with equal fill.
    /// @param order  order[k]: node that is eliminated k-th. A node of negative sign before all its
    /// positive neighbours reduces accuracy if its diagonal block is nearly zero; see
    /// rows_after_bodies().
    /// @throws std::invalid_argument if it is not a permutation of the nodes.
    void analyse(const BlockPattern& pattern, std::span<const std::int32_t> order);

    /// Update the analysis to a pattern with some different nodes and edges, at a fraction of the
    /// cost. Remaining nodes keep their order; only the structure above the changes is recomputed.
    /// A new order is computed in two cases:
    /// - the flops have increased by a fifth;
    /// - the pattern has up to 2,048 nodes, more than an eighth of them changed, and analyse() was
    ///   called without an order.
    ///
    /// Call factor() with values before the next solve().
    /// @param old_of_new  Previous index of each node; −1: a new node. Empty: nodes keep their
    /// indices, and additional nodes are new.
    /// @throws std::invalid_argument, std::bad_alloc; after the latter, call analyse().
    void update(const BlockPattern& pattern, std::span<const std::int32_t> old_of_new = {});

    /// Return the size of the array of values of all blocks.
    [[nodiscard]] std::int64_t value_count() const noexcept;
    /// Return the offset of a block in the array of values.
    /// @param block  Node i: i; edge e: number of nodes + e.
    [[nodiscard]] std::int64_t value_begin(std::int32_t block) const noexcept;
    /// Return the offset of a node's first scalar in right-hand sides and solutions.
    [[nodiscard]] std::int64_t scalar_begin(std::int32_t node) const noexcept;

    /// Factor K = L D Lᵀ.
    /// @param values  Values of all blocks, value_count() entries.
    /// @return ok; wrong_pivot if a pivot has the wrong sign or is not finite. solve() then uses a
    /// unit pivot instead.
    [[nodiscard]] Status factor(std::span<const double> values) noexcept;

    /// Factor again after changes of some blocks, with results equal to factor() to the bit. Only
    /// the fronts on the paths from these blocks to a root are recomputed. Without
    /// FactorOptions::partial, or without a valid factor of this pattern, it performs a full
    /// factor().
    /// @param values  Values of all blocks. Values of blocks that are not in `changed_blocks` must
    /// equal those of the last call.
    [[nodiscard]] Status refactor(std::span<const double> values,
                                  std::span<const std::int32_t> changed_blocks) noexcept;

    /// Solve K x = b in place.
    /// @param x  b on entry, x on return; info().scalars entries.
    /// @return ok; not_finite if an entry of x is not finite.
    [[nodiscard]] Status solve(std::span<double> x) noexcept;

    /// Multiply y = K x.
    void multiply(std::span<const double> values, std::span<const double> x,
                  std::span<double> y) const noexcept;
    /// Return the relative residual max|b − K x| / (‖K‖ max|x| + max|b|) [1]. ‖K‖ is the largest
    /// row sum of magnitudes. The best value in double precision is about 1e-16.
    [[nodiscard]] double residual(std::span<const double> values, std::span<const double> x,
                                  std::span<const double> b) noexcept;
    /// Refine a solution by one step: x += K⁻¹ (b − K x).
    [[nodiscard]] Status refine(std::span<const double> values, std::span<const double> b,
                                std::span<double> x) noexcept;

    /// Return figures of the last analysis and factorisation.
    [[nodiscard]] FactorInfo info() const noexcept;
    /// Return the elimination order: order()[k] is the node that is eliminated k-th.
    [[nodiscard]] std::span<const std::int32_t> order() const noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Return an approximate minimum degree order of the nodes (P. R. Amestoy, T. A. Davis, I. S. Duff,
/// 1996), with rows_after_bodies(). analyse() orders the nodes outside chains by this method, with
/// exact degrees up to two thousand nodes.
/// @throws std::invalid_argument, std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> minimum_degree_order(const BlockPattern& pattern);

/// Move each node of negative sign that precedes all its positive neighbours directly behind the
/// first of them in an elimination order. Other nodes keep their relative order.
/// @throws std::invalid_argument, std::bad_alloc.
void rows_after_bodies(const BlockPattern& pattern, std::vector<std::int32_t>& order);

}  // namespace hawser
