// SPDX-License-Identifier: Apache-2.0
/// Dense kernels of the multifrontal LDLᵀ and LDU (picture: factor/symbolic.h; second half:
/// factor/unsymmetric.h).
///
/// Column strides are multiples of eight doubles (base/simd.h). Rows past p + q stay zero, so
/// no loop has a remainder smaller than a register. Blocks of kPivotBlock pivot columns are
/// factored one column at a time. A register-blocked product then updates the columns behind
/// kUnscaledColumns pivots. Each entry receives its pivots in order, so its bits depend neither on
/// kPivotBlock nor on kUnscaledColumns.
///
/// An unsymmetric front has two *sides* of one shape: side 0 holds the lower half, side 1 the
/// upper half transposed. With unscaled columns W₀ = L D and W₁ = (D U)ᵀ the Schur complement is
/// C −= L (D U) = L W₁ᵀ, and transposed Cᵀ −= Uᵀ W₀ᵀ. Each side is therefore updated with the
/// unscaled columns of the other side. A symmetric front has one side, which takes both roles.
#include "factor/kernels.h"

#include "base/lanes.h"
#include "base/simd.h"
#include "factor/isa/batch.h"
#include "factor/isa/bits.h"
#include "factor/isa/stream.h"
#include "factor/isa/substitution.h"
#include "factor/isa/with_count.h"
#include "factor/symbolic.h"

namespace hawser::HAWSER_ISA {
namespace {

using factor::FactorView;
using factor::Front;
using factor::Run;

constexpr int kPivotBlock = 8;   // pivot columns with their triangle in registers
using factor::kUnscaledColumns;  // pivot columns factored before the rest is updated
/// Registers of rows, and columns, that a product updates at once: the most accumulators that fit.
struct Tile {
    int parts, columns;
};
#if defined(__AVX512F__)
constexpr Tile kAtOnce = {2, 8};
#elif defined(__AVX2__)
constexpr Tile kAtOnce = {2, 4};
#else
constexpr Tile kAtOnce = {4, 2};
#endif
/// Number of rows computed per step: one register of AVX-512 or AVX2, two of SSE2. Entries above
/// the diagonal and behind the last row are wasted, so short steps are cheaper.
constexpr int kRowStep = kPartLanes > 4 ? kPartLanes : 4;
constexpr int kStepParts = kRowStep / kPartLanes;

/// Return n rounded up to a multiple of kRowStep.
HAWSER_INLINE int round_up_to_step(int n) { return (n + kRowStep - 1) / kRowStep * kRowStep; }

/// The pivot columns of a front.
template <int kSides>
struct Trapezoid {
    double* panel[kSides];  ///< Column stride ld.
    double* w[kSides];      ///< Unscaled columns of the current block, column stride ld.
    long ld;
    long rows;      ///< p + q, rounded up to whole steps
    double* pivot;  ///< 1/D.
    const signed char* sign;
    signed char* wrong;  ///< Marks of wrong pivots, for unsymmetric fronts.

    [[nodiscard]] static constexpr int other(int side) { return kSides - 1 - side; }
};

/// Factor the N ≤ 8 columns from k0, a multiple of eight. `w` receives the unscaled columns, with
/// rows as in the panel.
///
/// Rows k0 … k0 + 7 hold the triangle: N sequential pivots in registers. The vectors of rows below
/// it are then independent: x_c = a_c − Σ_{b<c} U_bc x_b, with Uᵀ for L on side 1.
template <int N, int kSides>
inline int factor_block(const Trapezoid<kSides> t, int k0) {
    const long ld = t.ld;
    int wrong_pivots = 0;
    V8 top[kSides][N];
    double inverse[N], diagonal[N], scaled[kSides][N][N];
    for (int s = 0; s < kSides; ++s)
        for (int c = 0; c < N; ++c) top[s][c] = load(t.panel[s] + (k0 + c) * ld + k0);
    // Pivots are kept apart from their columns: each waits only for a division and one product.
    for (int c = 0; c < N; ++c) diagonal[c] = t.panel[0][(k0 + c) * ld + k0 + c];
#pragma GCC unroll 8
    for (int c = 0; c < N; ++c) {
        double d = diagonal[c];
        // The sign is known, see Symbolic::sign. The form !(…) also detects NaN.
        if (!(d * t.sign[k0 + c] > 0) || d - d != 0) {
            ++wrong_pivots;
            if constexpr (kSides == 2) t.wrong[k0 + c] = 1;
            // In unsymmetric fronts the other sign may be correct, see unsymmetric.h.
            if (kSides == 1 || d == 0 || d - d != 0) d = t.sign[k0 + c];
        }
        inverse[c] = double{1} / d;
        t.pivot[k0 + c] = inverse[c];
        V8 l[kSides];
        for (int s = 0; s < kSides; ++s) l[s] = after_lane(top[s][c] * inverse[c], c);
#pragma GCC unroll 8
        for (int j = c + 1; j < N; ++j) {
            double wj[kSides];
            for (int s = 0; s < kSides; ++s) {
                wj[s] = lane(top[s][c], j);
                scaled[s][j][c] = wj[s] * inverse[c];
            }
            for (int s = 0; s < kSides; ++s) top[s][j] -= wj[t.other(s)] * l[s];
            diagonal[j] -= (wj[0] * wj[t.other(0)]) * inverse[c];
        }
        for (int s = 0; s < kSides; ++s) {
            store(t.w[s] + c * ld + k0, top[s][c]);
            store(t.panel[s] + (k0 + c) * ld + k0, l[s]);
        }
    }
    for (int s = 0; s < kSides; ++s) {
        double *panel = t.panel[s] + k0 * ld, *w = t.w[s];
        for (long i = k0 + 8; i < t.rows; i += kRowStep) {
            Part x[N][kStepParts];
#pragma GCC unroll 8
            for (int c = 0; c < N; ++c)
                for (int h = 0; h < kStepParts; ++h) {
                    const long at = c * ld + i + kPartLanes * h;
                    x[c][h] = load_part(panel + at);
                    for (int b = 0; b < c; ++b) x[c][h] -= scaled[t.other(s)][c][b] * x[b][h];
                    store_part(w + at, x[c][h]);
                    store_part(panel + at, x[c][h] * inverse[c]);
                }
        }
    }
    return wrong_pivots;
}

template <int kSides>
inline int factor_columns(const Trapezoid<kSides> t, int k0, int count) {
    int wrong_pivots = 0;
    with_count(count, [&]<int N>() { wrong_pivots = factor_block<N>(t, k0); });
    return wrong_pivots;
}

/// Compute kRegisters registers of rows of C −= L · Wᵀ, or of C = −L · Wᵀ if kFirst.
template <int kCols, int kRegisters, bool kFirst>
HAWSER_INLINE void update_rows(double* c, long ldc, const double* l, const double* w, long ld,
                               int depth) {
    Part acc[kRegisters][kCols];
    for (int r = 0; r < kRegisters; ++r)
        for (int j = 0; j < kCols; ++j)
            acc[r][j] = kFirst ? Part{} : load_part(c + j * ldc + kPartLanes * r);
    for (int k = 0; k < depth; ++k) {
        Part v[kRegisters];
        for (int r = 0; r < kRegisters; ++r) v[r] = load_part(l + k * ld + kPartLanes * r);
        for (int j = 0; j < kCols; ++j)
            for (int r = 0; r < kRegisters; ++r) acc[r][j] -= v[r] * w[k * ld + j];
    }
    for (int r = 0; r < kRegisters; ++r)
        for (int j = 0; j < kCols; ++j) store_part(c + j * ldc + kPartLanes * r, acc[r][j]);
}

/// Compute C(:, 0..cols) −= L · Wᵀ for `cols` columns with rows from row0 in l and w. Only the
/// lower triangle is valid. Rows above it in the same step are computed and never read.
template <int kCols, bool kFirst>
inline void update_columns(double* c, long ldc, const double* l, const double* w, long ld,
                           int depth, int from, int rows) {
    int i = from;
    constexpr int kRowsAtOnce = kPartLanes * kAtOnce.parts;
    for (; i + kRowsAtOnce <= rows; i += kRowsAtOnce)
        update_rows<kCols, kAtOnce.parts, kFirst>(c + i, ldc, l + i, w, ld, depth);
    for (; i < rows; i += kRowStep)
        update_rows<kCols, kStepParts, kFirst>(c + i, ldc, l + i, w, ld, depth);
}

/// Update the columns [begin, end) of one side of a matrix with row r at l + r. The last columns
/// are updated together, because a single column would be limited by the latency of its sums.
template <bool kFirst>
inline void update_block(double* c, long ldc, const double* l, const double* w, long ld, int depth,
                         int begin, int end, int rows) {
    int j = begin;
    auto columns = [&]<int N>() {
        update_columns<N, kFirst>(c + j * ldc, ldc, l, w + j, ld, depth, j & ~(kRowStep - 1), rows);
        j += N;
    };
    while (end - j >= kAtOnce.columns) columns.template operator()<kAtOnce.columns>();
    if (end > j) with_count(end - j, columns);
}

/// Add the block `from` of rows × columns entries to the block `to`.
inline void add_block(double* to, long ld_to, const double* from, long ld_from, int rows,
                      int columns) {
    for (int i = 0; i < rows; i += 8)
        with_count(rows - i, [&]<int N>() {
            for (int c = 0; c < columns; ++c)
                add_first<N>(to + c * ld_to + i, from + c * ld_from + i);
        });
}

/// Add columns of the children's update matrices to the front: those that are pivots of the front
/// (kPivots), or the others. A run of consecutive columns and the runs of rows at and behind it
/// form dense blocks. The triangle above the diagonal of the first block is copied and never read.
/// Both sides receive the same values of a symmetric child.
template <bool kPivots, int kSide>
inline void extend_add(const FactorView& view, const Front& front, double* panel, double* update) {
    const long ld = kPivots ? front.ld : front.ldu;
    double* target = kPivots ? panel : update - front.p - static_cast<long>(front.p) * ld;
    for (std::int32_t i = front.child_begin; i < front.child_end; ++i) {
        const std::int32_t id = view.children[i];
        const Front& child = view.fronts[id];
        const double* u = kSide == 1 && view.unsymmetric[id] != 0 ? view.upper_update(child.update)
                                                                  : view.update(child.update);
        const Run* end = view.runs + child.run_end;
        const Run* run = view.runs + child.run_begin;
        if constexpr (!kPivots)
            while (run != end && run->to < front.p) ++run;
        for (; run != end && (!kPivots || run->to < front.p); ++run) {
            double* to = target + run->to * ld;
            const double* from = u + static_cast<long>(run->from) * child.ldu;
            for (const Run* r = run; r != end; ++r)
                add_block(to + r->to, ld, from + r->from, child.ldu, r->length, run->length);
        }
    }
}

/// Apply the pivot columns [d0, d1) to the columns and the update matrix behind them, on one side.
/// @param w  Unscaled columns of the other side.
inline void update_behind_pivots(const Front& front, double* panel, double* update, const double* w,
                                 int d0, int d1) {
    const double* l = panel + static_cast<long>(d0) * front.ld;
    if (d1 < front.p)
        update_block<false>(panel, front.ld, l, w, front.ld, d1 - d0, d1, front.p,
                            round_up_to_step(front.p + front.q));
    if (d0 == 0)
        update_block<true>(update, front.ldu, l + front.p, w + front.p, front.ld, d1 - d0, 0,
                           front.q, round_up_to_step(front.q));
    else
        update_block<false>(update, front.ldu, l + front.p, w + front.p, front.ld, d1 - d0, 0,
                            front.q, round_up_to_step(front.q));
}

/// Factor the pivot columns [d0, d1), at most kUnscaledColumns. Each block is written once, because
/// it first receives the updates of all blocks before it.
template <int kSides>
inline int factor_deep(const Trapezoid<kSides> t, int d0, int d1) {
    int wrong_pivots = 0;
    for (int k0 = d0; k0 < d1; k0 += kPivotBlock) {
        const int k1 = k0 + kPivotBlock < d1 ? k0 + kPivotBlock : d1;
        Trapezoid<kSides> block = t;
        for (int s = 0; s < kSides; ++s) {
            if (k0 > d0)
                update_block<false>(t.panel[s], t.ld, t.panel[s] + d0 * t.ld, t.w[t.other(s)], t.ld,
                                    k0 - d0, k0, k1, static_cast<int>(t.rows));
            block.w[s] += (k0 - d0) * t.ld;
        }
        wrong_pivots += factor_columns(block, k0, k1 - k0);
    }
    return wrong_pivots;
}

template <int kSides>
inline int factor_front(const FactorView& view, const Front& front, double* scratch) {
    Trapezoid<kSides> t{{view.panel + front.panel},
                        {scratch},
                        front.ld,
                        round_up_to_step(front.p + front.q),
                        view.pivot + front.offset,
                        view.sign + front.offset,
                        nullptr};
    double* update[kSides] = {view.update(front.update)};
    if constexpr (kSides == 2) {
        t.panel[1] = view.upper + front.panel;
        t.w[1] = scratch + kUnscaledColumns * t.ld;
        t.wrong = view.wrong + front.offset;
        update[1] = view.upper_update(front.update);
    }
    int wrong_pivots = 0;
    extend_add<true, 0>(view, front, t.panel[0], update[0]);
    if constexpr (kSides == 2) extend_add<true, 1>(view, front, t.panel[1], update[1]);
    for (int d0 = 0; d0 < front.p; d0 += kUnscaledColumns) {
        const int d1 = d0 + kUnscaledColumns < front.p ? d0 + kUnscaledColumns : front.p;
        wrong_pivots += factor_deep(t, d0, d1);
        for (int s = 0; s < kSides; ++s)
            update_behind_pivots(front, t.panel[s], update[s], t.w[t.other(s)], d0, d1);
    }
    extend_add<false, 0>(view, front, t.panel[0], update[0]);
    if constexpr (kSides == 2) extend_add<false, 1>(view, front, t.panel[1], update[1]);
    return wrong_pivots;
}

int factor_fronts(const FactorView& view, std::int32_t begin, std::int32_t end,
                  double* scratch) noexcept {
    int wrong_pivots = 0;
    for (std::int32_t f = begin; f < end; ++f) {
        const Front& front = view.fronts[f];
        if (front.batch >= 0) continue;
        if (view.is_unsymmetric(f)) {
            wrong_pivots += factor_front<2>(view, front, scratch);
            continue;
        }
        wrong_pivots += factor_front<1>(view, front, scratch);
    }
    return wrong_pivots;
}

}  // namespace

extern const factor::Kernels kKernels;
const factor::Kernels kKernels = {factor_fronts, forward_fronts, backward_fronts, factor_batch,
                                  forward_batch, backward_batch, unite_rows,      stream};

}  // namespace hawser::HAWSER_ISA
