// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file numeric.h
/// Values of a factorisation: clear, fill, factor, solve.
///
/// The matrix is written directly into the panels (Symbolic::target gives the address of each
/// block), which factor() then overwrites with L. Between two factorisations the panels must be
/// cleared with clear() and filled again. Matrices with unsymmetric values: unsymmetric.h.

#include "base/executor.h"
#include "base/memory.h"
#include "factor/kernels.h"
#include "factor/partial.h"
#include "factor/piece.h"
#include "factor/symbolic.h"
#include "factor/unsymmetric.h"

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// Writes the values of one piece into zeroed panels. Called from any thread.
struct Fill {
    void (*write)(void* context, int piece, double* panel) noexcept;
    void* context;
    /// Corrects the halves of a piece with unsymmetric fronts. Both enter as write() left the lower
    /// half. Only unsymmetric fronts have an upper half. Optional without them.
    void (*skew)(void* context, int piece, double* panel, double* upper) noexcept = nullptr;
};

/// Factorisation with symmetric values; all panels are filled before any is factored.
class SymmetricNumeric {
  public:
    /// Reserve memory for a structure and a number of threads. Memory only grows.
    /// @throws std::bad_alloc.
    void reserve(const Symbolic& symbolic, int threads) { reserve_buffers(symbolic, threads, 1); }

    /// Set all panels to zero.
    void clear(const Symbolic& symbolic, base::Executor& executor) noexcept;
    /// Set the panels of the changed parts `dirty` to zero.
    void clear(const Symbolic& symbolic, const DirtyParts& dirty,
               base::Executor& executor) noexcept;

    /// Return the panel array. Blocks are column-major at BlockTarget::address with stride ld. Only
    /// the lower triangle of a diagonal block is read.
    [[nodiscard]] double* values() noexcept { return panel_.data(); }

    /// Factor K = L D Lᵀ.
    /// @return number of pivots of the wrong sign or not finite (0 = success).
    [[nodiscard]] int factor(const Symbolic& symbolic, base::Executor& executor) noexcept;
    /// Factor a part again and keep the rest of the last factorisation (partial.h). The structure
    /// must keep its updates.
    /// @return number of wrong pivots in this part.
    [[nodiscard]] int refactor(const Symbolic& symbolic, const DirtyParts& dirty,
                               base::Executor& executor) noexcept;

    void backward(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept;
    /// Solve K x = b in place with the last factorisation. x has the permuted order
    /// (Symbolic::node_offset).
    void solve(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept;

    [[nodiscard]] std::size_t bytes() const noexcept;

  protected:
    /// Return the number of entries of the update matrices: shared ones, and the stacks of all
    /// threads.
    [[nodiscard]] static std::int64_t work_size(const Symbolic& s, int threads) noexcept {
        return s.work_size + (threads - 1) * (s.work_size - s.stack_begin);
    }
    /// Reserve memory.
    /// @param sides  2: with scratch for unsymmetric fronts.
    void reserve_buffers(const Symbolic& symbolic, int threads, int sides);
    template <class Batches, class Fronts>
    void run_tasks(const Symbolic& s, TaskPass pass, base::Executor& executor, Batches&& on_batch,
                   Fronts&& on_fronts) noexcept;
    [[nodiscard]] int count_wrong_pivots(const Symbolic& symbolic) const noexcept;
    [[nodiscard]] FactorView view(const Symbolic& symbolic, int thread) noexcept;
    [[nodiscard]] double* scratch(int thread) noexcept {
        return scratch_.data() + static_cast<std::ptrdiff_t>(thread) * scratch_stride_;
    }

    base::Array<double> panel_, pivot_, work_, carry_, slot_pivot_, slot_y_, scratch_;
    base::Array<int> wrong_pivots_;  ///< One per node, so that the count needs no atomics.
    TaskQueue queue_;
    std::int64_t scratch_stride_ = 0;

    // Data of unsymmetric fronts; empty if none were requested.
    base::Array<double> upper_, upper_work_;
    base::Array<std::uint8_t> kind_;  ///< One per front of the last factorisation: 1 unsymmetric.
    base::Array<std::int8_t>
        wrong_pivot_mark_;      ///< One per scalar; all zero between factorisations.
    bool unsymmetric_ = false;  ///< true if any front is unsymmetric.
};

/// Factorisation with unsymmetric values, and with panels that are filled just before they are
/// factored.
class Numeric : public SymmetricNumeric {
  public:
    /// Size at which a piece ends [doubles]: a fraction of a core's own cache. Set it before
    /// reserve().
    std::int64_t piece_size = 16'384;
    /// Panel size above which no cache holds the panels until they are read again [doubles], 64 MB.
    /// Pieces of batches are then built in a thread's own memory and written past the caches. Set
    /// it before reserve().
    std::int64_t streamed_size = 8'388'608;

    /// Reserve memory for a structure and a number of threads. Memory only grows. Unsymmetric
    /// fronts double the memory of panels and update matrices.
    /// @throws std::bad_alloc.
    void reserve(const Symbolic& symbolic, int threads, bool unsymmetric = false);
    /// Estimate the memory that the first reserve() allocates: panels, update matrices, vectors
    /// [bytes].
    [[nodiscard]] static double bytes_for(const Symbolic& symbolic, int threads,
                                          bool unsymmetric = false) noexcept;

    /// Return the upper half of the unsymmetric fronts, transposed, at the same addresses. Only the
    /// part below the diagonal of a diagonal block is read.
    [[nodiscard]] double* upper() noexcept { return upper_.data(); }
    /// Copy the lower half of all unsymmetric fronts, or only of the dirty ones, to the upper half.
    void copy_to_upper(const Symbolic& symbolic, const Unsymmetric& unsymmetric,
                       base::Executor& executor) noexcept;
    void copy_to_upper(const Symbolic& symbolic, const DirtyParts& dirty,
                       const Unsymmetric& unsymmetric, base::Executor& executor) noexcept;

    /// Factor K = L D Lᵀ, or L D U on the fronts in `unsymmetric`. The set need not outlive the
    /// call.
    /// @return number of pivots of the wrong sign or not finite (0 = success).
    [[nodiscard]] int factor(const Symbolic& symbolic, base::Executor& executor,
                             const Unsymmetric* unsymmetric = nullptr) noexcept;

    /// Return the nodes with wrong pivots in unsymmetric fronts of the last factorisation or
    /// refactorisation, in the order of elimination. Later wrong pivots on the path to the root may
    /// be consequences of the first one.
    [[nodiscard]] std::span<const std::int32_t> nodes_with_wrong_pivots() const noexcept {
        return failed_nodes_;
    }

    /// Factor a part again. A front that has become unsymmetric or symmetric must be dirty.
    /// Therefore pass DirtyParts::find() the columns of all blocks that have become unsymmetric or
    /// symmetric.
    /// @return number of wrong pivots in that part.
    [[nodiscard]] int refactor(const Symbolic& symbolic, const DirtyParts& dirty,
                               base::Executor& executor,
                               const Unsymmetric* unsymmetric = nullptr) noexcept;

    /// Return the pieces of the structure of the last reserve(), batches first.
    [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }

    /// Fill, factor and substitute forward, piece by piece, so that memory is traversed once
    /// instead of three times. backward() completes x.
    /// @return as factor().
    [[nodiscard]] int factor_forward(const Symbolic& symbolic, Fill fill, double* x,
                                     base::Executor& executor,
                                     const Unsymmetric* unsymmetric = nullptr) noexcept;

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void make_pieces(const Symbolic& symbolic);
    void divide_batch(const Symbolic& symbolic, std::int32_t batch);
    void find_stage(const Symbolic& symbolic, int threads);
    [[nodiscard]] int run_batch_piece(const Symbolic& symbolic, int piece, Fill fill, double* x,
                                      int thread) noexcept;
    [[nodiscard]] int run_piece(const Symbolic& symbolic, int piece, Fill fill, double* x,
                                int thread) noexcept;
    void use(const Symbolic& symbolic, const Unsymmetric* set) noexcept;
    void copy_front(const Front& front) noexcept;
    void copy_range(std::int64_t begin, std::int64_t end) noexcept;
    /// Copy the lower half of a piece to its upper half.
    /// @return true if the piece has an upper half.
    bool copy_piece(const Symbolic& symbolic, const Piece& piece) noexcept;
    [[nodiscard]] int find_wrong_pivots(const Symbolic& symbolic, int wrong) noexcept;

    base::Array<double> stage_;  ///< A piece of a batch for each thread, if pieces are streamed.
    std::int64_t stage_stride_ = 0;  ///< 0: pieces are not streamed.
    std::vector<Piece> pieces_;
    std::vector<std::int32_t> task_piece_;    ///< First piece of each node of the graph.
    std::vector<std::int32_t> failed_nodes_;  ///< Nodes of wrong pivots in unsymmetric fronts.
};

}  // namespace hawser::factor
