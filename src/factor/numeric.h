// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file numeric.h
/// Values of a factorisation: reset, fill, factor, solve.
///
/// The matrix is written straight into the panels (Symbolic::target gives each block's
/// address), which factor() then overwrites with L. Between two factorisations the panels
/// must be cleared with clear() and filled again.

#include "base/executor.h"
#include "base/memory.h"
#include "factor/kernels.h"
#include "factor/partial.h"
#include "factor/symbolic.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// Panels that are filled, factored and substituted together while they are in the cache: a batch
/// of chains, or some fronts in a row.
struct Piece {
    std::int64_t panel_begin, panel_end;  ///< Offsets in the panel array; pieces are apart.
    std::int32_t begin, end;              ///< Fronts; of a batch: its index, twice.
};

/// Writes the values of one piece into zeroed panels. Called from any thread.
struct Fill {
    void (*write)(void* context, int piece, double* panel) noexcept;
    void* context;
};

class Numeric {
  public:
    /// Make room for a structure and for that many threads; grows only. @throws std::bad_alloc.
    void reserve(const Symbolic& symbolic, int threads);

    /// Zero the panels.
    void clear(const Symbolic& symbolic, base::Executor& executor) noexcept;

    /// Panel array; blocks are column-major at BlockTarget::address with stride ld. Of a
    /// diagonal block only the lower triangle is read.
    [[nodiscard]] double* values() noexcept { return panel_.data(); }

    /// K = L D Lᵀ. @return number of pivots of the wrong sign or not finite (0 = success).
    [[nodiscard]] int factor(const Symbolic& symbolic, base::Executor& executor) noexcept;

    /// Zero the panels of a part.
    void clear(const Symbolic& symbolic, const DirtyParts& dirty,
               base::Executor& executor) noexcept;
    /// The factorisation of a part, the rest being that of the last one (partial.h). The structure
    /// has its updates kept. @return wrong pivots in that part.
    [[nodiscard]] int refactor(const Symbolic& symbolic, const DirtyParts& dirty,
                               base::Executor& executor) noexcept;

    /// Pieces of the structure last given to reserve(), batches first.
    [[nodiscard]] const std::vector<Piece>& pieces() const noexcept { return pieces_; }

    /// Fill, factor and substitute forward, piece by piece: one pass through memory instead of
    /// three. backward() completes x. @return as factor().
    [[nodiscard]] int factor_forward(const Symbolic& symbolic, Fill fill, double* x,
                                     base::Executor& executor) noexcept;
    void backward(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept;

    /// K x = b in place; x is in the permuted order (Symbolic::node_offset).
    void solve(const Symbolic& symbolic, double* x, base::Executor& executor) noexcept;

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void cut_pieces(const Symbolic& symbolic);
    [[nodiscard]] int run_piece(const Symbolic& symbolic, int piece, Fill fill, double* x,
                                int thread) noexcept;
    [[nodiscard]] FactorView view(const Symbolic& symbolic, int thread) noexcept;
    [[nodiscard]] double* scratch(int thread) noexcept {
        return scratch_.data() + static_cast<std::ptrdiff_t>(thread) * scratch_stride_;
    }

    base::Array<double> panel_, pivot_, work_, carry_, slot_pivot_, slot_y_, scratch_;
    std::vector<Piece> pieces_;
    std::vector<std::int32_t> task_piece_;  ///< First piece of each task, then of the top.
    base::Array<int> wrong_;  ///< One a batch or task, so that the count needs no atomics.
    std::int64_t scratch_stride_ = 0;
};

}  // namespace hawser::factor
