// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file factor.h
/// The direct solver by itself: K x = b for a sparse symmetric quasi-definite K in blocks.
///
/// K = [A Gᵀ; G −Σ] with A and Σ positive definite, in any order of its rows: the systems of
/// constrained mechanics, of interior-point methods, of equality-constrained least squares. Such
/// a matrix has K = L D Lᵀ with diagonal D for every symmetric permutation (Vanderbei, "Symmetric
/// quasidefinite matrices", 1995), and D has the sign known beforehand; no pivoting is needed.
/// Positive definite matrices are the case without negative nodes. Accuracy suffers where Σ is
/// nearly zero and G nearly loses rank: look at residual() and refine().
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
/// Blocks have numbers: the diagonal block of node i is block i, that of edge e is block
/// nodes + e. Values of all blocks stand in one array, block after block, each by rows; of a
/// diagonal block the lower triangle is read.
///
/// analyse() and update() may allocate, and throw where the pattern is malformed. factor(),
/// refactor(), solve(), multiply(), residual() and refine() are the warm path: they allocate
/// nothing, throw nothing, and report by status. Results have the same bits for any number of
/// threads. An object is used by one thread at a time.

#include <hawser/stats.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hawser {

/// A block off the diagonal that may be non-zero.
struct BlockEdge {
    std::int32_t row = 0, column = 0;  ///< Nodes; the block has the rows of `row`.
};

/// The graph of a block matrix. Numbers are without unit.
struct BlockPattern {
    std::vector<std::int8_t> size{};  ///< Scalars of each node, 1-6.
    std::vector<std::int8_t> sign{};  ///< Of each node: +1 positive pivots, −1 negative.
    std::vector<BlockEdge> edges{};   ///< Each pair of nodes once, in either direction.
};

struct FactorOptions {
    int threads = 1;  ///< That share the work, the caller included.
    /// Keep what refactor() needs: update matrices get memory of their own instead of sharing it.
    bool partial = false;
};

/// Figures of the last analysis.
struct FactorInfo {
    std::int64_t nodes = 0, scalars = 0;
    std::int64_t fronts = 0;        ///< Dense pieces of the factorisation.
    std::int64_t matrix_nnz = 0;    ///< Scalars of the lower triangle of K.
    std::int64_t factor_nnz = 0;    ///< Scalars of L, zeros of merged fronts included.
    std::int64_t flops = 0;         ///< Of factor().
    std::int64_t path_flops = 0;    ///< On the longest path from a leaf to a root.
    std::int64_t part_flops = 0;    ///< Of the last refactor().
    std::int64_t columns = 0;       ///< Block columns that the last analyse() or update() computed.
    std::int64_t bytes = 0;         ///< Memory held.
    bool planned = true;            ///< The last analyse() or update() made a new order.
    std::int64_t wrong_pivots = 0;  ///< Of the last factor() or refactor().
};

/// Analyses, factors, solves.
class BlockFactor {
  public:
    explicit BlockFactor(const FactorOptions& options = {});
    ~BlockFactor();
    BlockFactor(BlockFactor&&) noexcept;
    BlockFactor& operator=(BlockFactor&&) noexcept;

    /// Order of elimination and all addresses. @throws std::invalid_argument, std::bad_alloc.
    void analyse(const BlockPattern& pattern);

    /// All addresses for this order of elimination, or one equivalent to it: a postorder of its
    /// tree, with the same fill. Fronts are merged as always.
    /// @param order  order[k] = node eliminated k-th. A negative node before all its positive
    ///        neighbours costs digits where its own block is nearly zero: rows_after_bodies().
    /// @throws std::invalid_argument where it is not a permutation of the nodes.
    void analyse(const BlockPattern& pattern, std::span<const std::int32_t> order);

    /// Follow to a pattern that differs by some nodes and edges, in a fraction of the time: nodes
    /// that stay keep their order, and only the structure above the changes is computed again.
    /// The order is made anew when the flops have grown by a fifth, and, unless it was given to
    /// analyse(), at once where more than an eighth of up to 2,048 nodes changed. Values must be
    /// given to factor() before the next solve().
    /// @param old_of_new  For each node of the pattern its number in the last one, −1: new. Empty:
    ///        nodes keep their numbers, further ones are new.
    /// @throws std::invalid_argument, std::bad_alloc; only analyse() helps after the latter.
    void update(const BlockPattern& pattern, std::span<const std::int32_t> old_of_new = {});

    /// Doubles in the array of values.
    [[nodiscard]] std::int64_t value_count() const noexcept;
    /// Where the values of a block begin.
    [[nodiscard]] std::int64_t value_begin(std::int32_t block) const noexcept;
    /// First scalar of a node in right-hand sides and solutions, which go node by node.
    [[nodiscard]] std::int64_t scalar_begin(std::int32_t node) const noexcept;

    /// K = L D Lᵀ. @param values  value_count() of them.
    /// @return wrong_pivot if a pivot has the wrong sign or is not finite; solve() then solves
    ///         with a unit pivot in its place.
    [[nodiscard]] Status factor(std::span<const double> values) noexcept;

    /// What factor() gives, bit for bit, after the values of some blocks changed, all others being
    /// those of the last call: only fronts on their paths to the root are computed again. Does what
    /// factor() does without FactorOptions::partial, and where no good factor of this pattern is
    /// there.
    [[nodiscard]] Status refactor(std::span<const double> values,
                                  std::span<const std::int32_t> changed_blocks) noexcept;

    /// K x = b, in place; info().scalars of them. @return not_finite if a result is.
    [[nodiscard]] Status solve(std::span<double> x) noexcept;

    /// y = K x.
    void multiply(std::span<const double> values, std::span<const double> x,
                  std::span<double> y) const noexcept;
    /// max|b − K x| / (‖K‖ max|x| + max|b|), ‖K‖ the largest sum of a row's magnitudes: about 1e-16
    /// at best.
    [[nodiscard]] double residual(std::span<const double> values, std::span<const double> x,
                                  std::span<const double> b) noexcept;
    /// One step of refinement: x += K⁻¹ (b − K x).
    [[nodiscard]] Status refine(std::span<const double> values, std::span<const double> b,
                                std::span<double> x) noexcept;

    [[nodiscard]] FactorInfo info() const noexcept;
    /// Of elimination, as it is now: order()[k] = node eliminated k-th.
    [[nodiscard]] std::span<const std::int32_t> order() const noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Approximate minimum degree (Amestoy, Davis, Duff 1996) on the nodes, rows after bodies. With
/// all that is in no chain analyse() does the same, up to two thousand nodes with the true degrees.
/// @throws std::invalid_argument, std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> minimum_degree_order(const BlockPattern& pattern);

/// Move every negative node that precedes all its positive neighbours to just behind the first of
/// them; others keep their relative order. @throws std::invalid_argument, std::bad_alloc.
void rows_after_bodies(const BlockPattern& pattern, std::vector<std::int32_t>& order);

}  // namespace hawser
