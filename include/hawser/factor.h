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

/// Graph of a block matrix; dimensionless.
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

/// Figures of the last analysis.
struct FactorInfo {
    std::int64_t nodes = 0, scalars = 0;
    std::int64_t fronts = 0;      ///< Number of fronts (dense matrices) of the factorisation.
    std::int64_t matrix_nnz = 0;  ///< Scalars of the lower triangle of K.
    std::int64_t factor_nnz = 0;  ///< Scalars of L, with zeros of merged fronts.
    std::int64_t flops = 0;       ///< Flops of factor().
    std::int64_t path_flops = 0;  ///< Flops on the longest path from a leaf to a root.
    std::int64_t part_flops = 0;  ///< Flops of the last refactor().
    std::int64_t columns = 0;     ///< Block columns that the last analyse() or update() computed.
    std::int64_t bytes = 0;       ///< Allocated memory [bytes].
    bool planned = true;          ///< True if the last analyse() or update() computed a new order.
    std::int64_t wrong_pivots = 0;  ///< Wrong pivots in the last factor() or refactor().
};

/// Analysis, factorisation and solution of a block matrix.
class BlockFactor {
  public:
    explicit BlockFactor(const FactorOptions& options = {});
    ~BlockFactor();
    BlockFactor(BlockFactor&&) noexcept;
    BlockFactor& operator=(BlockFactor&&) noexcept;

    /// Compute the elimination order and all addresses.
    /// @throws std::invalid_argument, std::bad_alloc.
    void analyse(const BlockPattern& pattern);

    /// Compute all addresses for a given elimination order, or for an equivalent postorder of its
    /// tree with equal fill. Fronts are merged as usual.
    /// @param order  order[k] = node eliminated k-th. A negative node before all its positive
    /// neighbours reduces accuracy if its own block is nearly zero; see rows_after_bodies().
    /// @throws std::invalid_argument if it is not a permutation of the nodes.
    void analyse(const BlockPattern& pattern, std::span<const std::int32_t> order);

    /// Update the analysis to a pattern with some different nodes and edges, at a fraction of the
    /// cost. Remaining nodes keep their order; only the structure above the changes is recomputed.
    /// A new order is computed when the flops have increased by a fifth. Unless analyse() received
    /// the order, it is also computed if more than an eighth of up to 2,048 nodes changed. Call
    /// factor() with values before the next solve().
    /// @param old_of_new  Previous index of each node, −1: new. Empty: nodes keep their indices,
    /// additional ones are new.
    /// @throws std::invalid_argument, std::bad_alloc; after the latter, call analyse().
    void update(const BlockPattern& pattern, std::span<const std::int32_t> old_of_new = {});

    /// Return the size of the array of values.
    [[nodiscard]] std::int64_t value_count() const noexcept;
    /// Return the offset of a block in the array of values.
    [[nodiscard]] std::int64_t value_begin(std::int32_t block) const noexcept;
    /// Return the offset of a node's first scalar in right-hand sides and solutions.
    [[nodiscard]] std::int64_t scalar_begin(std::int32_t node) const noexcept;

    /// Factor K = L D Lᵀ.
    /// @param values  Array of value_count() values.
    /// @return wrong_pivot if a pivot has the wrong sign or is not finite; solve() then uses a unit
    /// pivot instead.
    [[nodiscard]] Status factor(std::span<const double> values) noexcept;

    /// Factor again after changes of some blocks, with results equal to the bit to factor(). Only
    /// fronts on their paths to a root are recomputed. Without FactorOptions::partial, or without a
    /// valid factor of this pattern, it performs a full factor().
    /// @param values  All values; blocks not in `changed_blocks` must be those of the last call.
    [[nodiscard]] Status refactor(std::span<const double> values,
                                  std::span<const std::int32_t> changed_blocks) noexcept;

    /// Solve K x = b in place.
    /// @param x  b on entry, x on return, info().scalars values.
    /// @return not_finite if a result is not finite.
    [[nodiscard]] Status solve(std::span<double> x) noexcept;

    /// Multiply y = K x.
    void multiply(std::span<const double> values, std::span<const double> x,
                  std::span<double> y) const noexcept;
    /// Return the residual max|b − K x| / (‖K‖ max|x| + max|b|), ‖K‖ the largest row sum of
    /// magnitudes. At best it is about 1e-16.
    [[nodiscard]] double residual(std::span<const double> values, std::span<const double> x,
                                  std::span<const double> b) noexcept;
    /// Refine a solution by one step: x += K⁻¹ (b − K x).
    [[nodiscard]] Status refine(std::span<const double> values, std::span<const double> b,
                                std::span<double> x) noexcept;

    /// Return figures of the last analysis and factorisation.
    [[nodiscard]] FactorInfo info() const noexcept;
    /// Return the present elimination order: order()[k] = node eliminated k-th.
    [[nodiscard]] std::span<const std::int32_t> order() const noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Return an approximate minimum degree order (Amestoy, Davis, Duff 1996) of the nodes, with rows
/// after bodies. Nodes outside chains get this order in analyse(), with exact degrees up to two
/// thousand nodes.
/// @throws std::invalid_argument, std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> minimum_degree_order(const BlockPattern& pattern);

/// Move every negative node that precedes all its positive neighbours directly behind the first of
/// them. Other nodes keep their relative order.
/// @throws std::invalid_argument, std::bad_alloc.
void rows_after_bodies(const BlockPattern& pattern, std::vector<std::int32_t>& order);

}  // namespace hawser
