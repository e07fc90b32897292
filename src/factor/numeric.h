// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file numeric.h
/// Values of a factorisation: reset, fill, factor, solve.
///
/// The matrix is written straight into the panels (Symbolic::target gives each block's
/// address), which factor() then overwrites with L. Between two factorisations the panels
/// must be cleared with clear() and filled again. Matrices with unsymmetric values: unsymmetric.h.

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
    /// Corrects the halves of a piece with unsymmetric fronts, which come equal as write() left
    /// the lower one. Only those fronts have an upper half. Not needed without them.
    void (*skew)(void* context, int piece, double* panel, double* upper) noexcept = nullptr;
};

/// Symmetric values, all panels filled before any is factored.
class SymmetricNumeric {
  public:
    /// Make room for a structure and for that many threads; grows only. @throws std::bad_alloc.
    void reserve(const Symbolic& symbolic, int threads) { make_room(symbolic, threads, 1); }

    /// Zero the panels.
    void clear(const Symbolic& symbolic, base::Executor& executor) noexcept;
    /// Zero the panels of a part.
    void clear(const Symbolic& symbolic, const DirtyParts& dirty,
               base::Executor& executor) noexcept;

    /// Panel array; blocks are column-major at BlockTarget::address with stride ld. Of a
    /// diagonal block only the lower triangle is read.
    [[nodiscard]] double* values() noexcept { return panel_.data(); }

    /// K = L D Lᵀ. @return number of pivots of the wrong sign or not finite (0 = success).
    [[nodiscard]] int factor(const Symbolic& symbolic, base::Executor& executor) noexcept;
    /// The factorisation of a part, the rest being that of the last one (partial.h). The structure
    /// has its updates kept. @return wrong pivots in that part.
    [[nodiscard]] int refactor(const Symbolic& symbolic, const DirtyParts& dirty,
                               base::Executor& executor) noexcept;

    void backward(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept;
    /// K x = b in place, as last factored; x is in the permuted order (Symbolic::node_offset).
    void solve(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept;

    [[nodiscard]] std::size_t bytes() const noexcept;

  protected:
    /// Entries of the update matrices: those of all, and a stack for each thread.
    [[nodiscard]] static std::int64_t work_size(const Symbolic& s, int threads) noexcept {
        return s.work_size + (threads - 1) * (s.work_size - s.stack_begin);
    }
    /// @param sides  2: scratch for unsymmetric fronts.
    void make_room(const Symbolic& symbolic, int threads, int sides);
    template <class Batches, class Fronts>
    void run_tasks(const Symbolic& s, TaskPass pass, base::Executor& executor, Batches&& on_batch,
                   Fronts&& on_fronts) noexcept;
    [[nodiscard]] int count_wrong(const Symbolic& symbolic) const noexcept;
    [[nodiscard]] FactorView view(const Symbolic& symbolic, int thread) noexcept;
    [[nodiscard]] double* scratch(int thread) noexcept {
        return scratch_.data() + static_cast<std::ptrdiff_t>(thread) * scratch_stride_;
    }

    base::Array<double> panel_, pivot_, work_, carry_, slot_pivot_, slot_y_, scratch_;
    base::Array<int> wrong_;  ///< One a node, so that the count needs no atomics.
    TaskQueue queue_;
    std::int64_t scratch_stride_ = 0;

    // Of unsymmetric fronts; empty where no room was asked for.
    base::Array<double> upper_, upper_work_;
    base::Array<std::uint8_t> kind_;       ///< One a front, as last factored: 1 unsymmetric.
    base::Array<std::int8_t> wrong_mark_;  ///< One a scalar; all zero between factorisations.
    bool unsymmetric_ = false;             ///< Any front is.
};

/// With unsymmetric values, and with panels that are filled just before they are factored.
class Numeric : public SymmetricNumeric {
  public:
    /// From this size on a piece ends [doubles]: a share of a core's own cache. To be set before
    /// reserve().
    std::int64_t piece_size = 16'384;
    /// Panels above this size [doubles], 64 MB, stay in no cache until they are read again: pieces
    /// of batches are made in a thread's own memory and written past the caches. To be set before
    /// reserve().
    std::int64_t streamed_size = 8'388'608;

    /// Make room for a structure and for that many threads; grows only. With room for unsymmetric
    /// fronts, the panels and update matrices take twice the memory. @throws std::bad_alloc.
    void reserve(const Symbolic& symbolic, int threads, bool unsymmetric = false);
    /// About what reserve() takes from nothing: panels, update matrices, vectors [bytes].
    [[nodiscard]] static double bytes_for(const Symbolic& symbolic, int threads,
                                          bool unsymmetric = false) noexcept;

    /// The upper half of the unsymmetric fronts, transposed, at the same addresses. Of a diagonal
    /// block only what lies below its diagonal there is read.
    [[nodiscard]] double* upper() noexcept { return upper_.data(); }
    /// Make the upper half of the unsymmetric fronts equal to the lower one, or of the dirty
    /// ones among them.
    void copy_to_upper(const Symbolic& symbolic, const Unsymmetric& unsymmetric,
                       base::Executor& executor) noexcept;
    void copy_to_upper(const Symbolic& symbolic, const DirtyParts& dirty,
                       const Unsymmetric& unsymmetric, base::Executor& executor) noexcept;

    /// K = L D Lᵀ, or L D U on the fronts named by `unsymmetric`; the set need not outlive the
    /// call. @return number of pivots of the wrong sign or not finite (0 = success).
    [[nodiscard]] int factor(const Symbolic& symbolic, base::Executor& executor,
                             const Unsymmetric* unsymmetric = nullptr) noexcept;

    /// Nodes with wrong pivots in unsymmetric fronts met by the last factorisation or
    /// refactorisation, in the order of elimination. Pivots after the first wrong one of a
    /// subtree's path may be wrong for its sake.
    [[nodiscard]] std::span<const std::int32_t> wrong_nodes() const noexcept {
        return wrong_nodes_;
    }

    /// Factor a part anew. A front that is unsymmetric now and was not, or the other way round,
    /// must be dirty: it is if the columns given to DirtyParts::find() include those of all blocks
    /// that became unsymmetric or symmetric. @return wrong pivots in that part.
    [[nodiscard]] int refactor(const Symbolic& symbolic, const DirtyParts& dirty,
                               base::Executor& executor,
                               const Unsymmetric* unsymmetric = nullptr) noexcept;

    /// Pieces of the structure last given to reserve(), batches first.
    [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }

    /// Fill, factor and substitute forward, piece by piece: one pass through memory instead of
    /// three. backward() completes x. @return as factor().
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
    /// @return whether the piece has an upper half.
    bool copy_piece(const Symbolic& symbolic, const Piece& piece) noexcept;
    [[nodiscard]] int find_wrong(const Symbolic& symbolic, int wrong) noexcept;

    base::Array<double> stage_;  ///< A piece of a batch for each thread, where they are streamed.
    std::int64_t stage_stride_ = 0;  ///< 0: they are not.
    std::vector<Piece> pieces_;
    std::vector<std::int32_t> task_piece_;   ///< First piece of each node of the graph.
    std::vector<std::int32_t> wrong_nodes_;  ///< In unsymmetric fronts.
};

}  // namespace hawser::factor
