// SPDX-License-Identifier: Apache-2.0
/// Factorisation of batches (picture: factor/batches.h). An unsymmetric batch has two sides. Each
/// is updated with the unscaled columns of the other, as in kernels.cpp.
#include "factor/isa/batch.h"

#include "factor/isa/batch_parts.h"
#include "factor/isa/rigid_steps.h"
#include "factor/kernels.h"

#include <cstring>
#include <utility>

namespace hawser::HAWSER_ISA {
namespace {

using factor::Batch;
using factor::BatchStep;
using factor::FactorView;
using factor::Front;

/// One column block of a step's panel.
template <int kSides>
struct Columns {
    double* panel[kSides];  ///< n rows of p vectors: A, overwritten with L or Uᵀ.
    double* w[kSides];      ///< n rows of p vectors: L D or (D U)ᵀ.
    long stride;            ///< 8 p.
    double* pivot;          ///< p vectors: 1/D.
    const signed char* sign;
    const std::int32_t* index;  ///< Index of each pivot in `wrong`, for an unsymmetric batch.
    signed char* wrong;         ///< Marks of wrong pivots, for an unsymmetric batch.

    [[nodiscard]] static constexpr int other(int side) { return kSides - 1 - side; }
};

/// Mark the lanes with a wrong pivot in column c of the matrix m. Padding is not marked.
HAWSER_INLINE void mark_wrong_pivots(const Columns<2>& m, int c, const V8& bad) {
    if (!any(bad)) return;
    for (int lane_ = 0; lane_ < factor::kLaneCount; ++lane_)
        if (const std::int32_t i = m.index[8 * c + lane_]; i >= 0 && lane(bad, lane_) != 0)
            m.wrong[i] = 1;
}

/// Pivots of some columns in one register of lanes.
template <int N, int kSides>
struct Triangle {
    Part inverse[N], scaled[kSides][N][N];
};

/// Factor the triangle of columns [c, c + N) in register h of the lanes.
/// @return as fix_pivot(), for each pivot.
template <int N, int kSides>
HAWSER_INLINE void factor_triangle(const Columns<kSides>& m, int c, int h, Triangle<N, kSides>& t,
                                   V8 (&bad)[N]) {
    const long from = c * m.stride + kPartLanes * h;
    Part a[kSides][N][N];
    for (int s = 0; s < kSides; ++s) {
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < N; ++j)
                a[s][i][j] = load_part(m.panel[s] + from + i * m.stride + 8 * (c + j));
        tile<N, N>(a[s], m.w[s] + from, m.panel[m.other(s)] + from, m.stride, c);
    }
    for (int j = 0; j < N; ++j) {
        Part d = a[0][j][j];
        set_part(bad[j], h, fix_pivot < kSides == 2 > (d, m.sign[c + j]));
        t.inverse[j] = reciprocal(d);
        store_part(m.pivot + 8 * (c + j) + kPartLanes * h, t.inverse[j]);
        for (int i = j + 1; i < N; ++i) {
            for (int s = 0; s < kSides; ++s) {
                const long at = from + i * m.stride + 8 * (c + j);
                const Part x = a[s][i][j];
                t.scaled[s][i][j] = x * t.inverse[j];
                store_part(m.panel[s] + at, t.scaled[s][i][j]);
                store_part(m.w[s] + at, x);
            }
            for (int s = 0; s < kSides; ++s)
                for (int k = j + 1; k <= i; ++k)
                    a[s][i][k] -= t.scaled[m.other(s)][k][j] * a[s][i][j];
        }
    }
}

/// Solve rows [r, r + R) below the triangle of factor_triangle().
template <int R, int N, int kSides>
HAWSER_INLINE void solve_below(const Columns<kSides>& m, int c, int r, int h,
                               const Triangle<N, kSides>& t) {
    for (int s = 0; s < kSides; ++s) {
        const int lanes = kPartLanes * h;
        double *row = m.panel[s] + r * m.stride + lanes, *w = m.w[s] + r * m.stride + lanes;
        Part a[R][N];
        for (int i = 0; i < R; ++i)
            for (int j = 0; j < N; ++j) a[i][j] = load_part(row + i * m.stride + 8 * (c + j));
        tile<R, N>(a, w, m.panel[m.other(s)] + c * m.stride + lanes, m.stride, c);
        for (int j = 0; j < N; ++j)
            for (int i = 0; i < R; ++i) {
                for (int k = 0; k < j; ++k) a[i][j] -= t.scaled[m.other(s)][j][k] * a[i][k];
                store_part(w + i * m.stride + 8 * (c + j), a[i][j]);
                store_part(row + i * m.stride + 8 * (c + j), a[i][j] * t.inverse[j]);
            }
    }
}

/// Factor columns [c, c + N) of the panel, rows to n.
template <int N, int kSides>
inline void factor_columns(const Columns<kSides> m, int c, int n, V8& bad) {
    Triangle<N, kSides> t[kParts];
    V8 wrong_pivots[N];
    for (int h = 0; h < kParts; ++h) factor_triangle<N, kSides>(m, c, h, t[h], wrong_pivots);
    for (int j = 0; j < N; ++j) {
        if constexpr (kSides == 2) mark_wrong_pivots(m, c + j, wrong_pivots[j]);
        bad += wrong_pivots[j];
    }
    for (int r = c + N; r < n; r += kTile)
        with_size(n - r, [&]<int R>() {
            for (int h = 0; h < kParts; ++h) solve_below<R, N, kSides>(m, c, r, h, t[h]);
        });
}

/// Compute the window of the next step: the window of this step, shifted, minus L21 W21ᵀ. `l` and
/// `w` point to the first update row.
inline void update_window(const double* l, const double* w, long stride, const BatchStep& step,
                          const Shift& shift, const double* window, double* next) {
    for (int i = 0; i < step.q / kTile; ++i) {
        const int row = shift.earlier_tile(i);
        for (int j = 0; j <= i; ++j) {
            const int column = shift.earlier_tile(j);
            const double* old = row < 0 || column < 0 ? nullptr : window + tile_at(row, column);
            for (int h = 0; h < kParts; ++h) {
                const int lanes = kPartLanes * h;
                Part acc[kTile][kTile];
                for (int a = 0; a < kTile; ++a)
                    for (int b = 0; b < kTile; ++b)
                        acc[a][b] =
                            old == nullptr ? Part{} : load_part(old + 8 * (kTile * a + b) + lanes);
                tile<kTile, kTile>(acc, l + kTile * i * stride + lanes,
                                   w + kTile * j * stride + lanes, stride, step.p);
                double* to = next + tile_at(i, j) + lanes;
                for (int a = 0; a < kTile; ++a)
                    for (int b = 0; b < kTile; ++b) store_part(to + 8 * (kTile * a + b), acc[a][b]);
            }
        }
    }
}

/// Add the updates of earlier bodies of the chain to the panel of this step's body.
inline void add_window(double* panel, const BatchStep& step, const Shift& shift,
                       const double* window) {
    auto add = [&](int row, int column, const double* from, int right) {
        for (int a = 0; a < kTile; ++a)
            for (int b = 0; b < kTile && b <= a + right; ++b) {
                double* to = panel + 8 * ((row + a) * static_cast<long>(step.p) + column + b);
                store(to, load(to) + load(from + 8 * (kTile * a + b)));
            }
    };
    for (int j = 0; j < shift.body; ++j) {
        for (int i = j; i < shift.body; ++i)
            add(kTile * i, kTile * j, window + tile_at(i, j), i == j ? 0 : kTile);
        for (int i = 0; i < step.q / kTile; ++i)
            if (const int row = shift.earlier_tile(i); row >= 0)
                add(step.p + kTile * i, kTile * j, window + tile_at(row, j), kTile);
    }
}

/// Offsets of a slot in a window, as a row and as a column. Entry (r, c), r ≥ c, of lane 0 is at
/// the sum of both.
struct SlotRecord {
    std::int32_t row, column;
};
constexpr int kRecordSize = sizeof(SlotRecord) / sizeof(double);  ///< Size in doubles.

/// Store the SlotRecord of each slot.
inline void write_slot_records(int slots, double* room) {
    for (int i = 0; i < slots; ++i) {
        const SlotRecord p{
            static_cast<std::int32_t>(tile_at(i / kTile, 0)) + kLanes * kTile * (i % kTile),
            static_cast<std::int32_t>(tile_at(0, i / kTile)) + kLanes * (i % kTile)};
        std::memcpy(room + kRecordSize * i, &p, sizeof p);
    }
}
HAWSER_INLINE SlotRecord read_slot_record(const double* room, int slot) {
    SlotRecord p;
    std::memcpy(&p, room + kRecordSize * slot, sizeof p);
    return p;
}

/// Store the last window of a batch as update matrices of the parent fronts, lane by lane. The rows
/// of a parent have another order than the slots. An entry whose slots are exchanged belongs to the
/// other side.
/// @param room  Buffer with a SlotRecord for each slot.
template <int kSides>
inline void store_tails(const FactorView& view, const Batch& batch, double* const (&window)[kSides],
                        double* room) {
    write_slot_records(batch.max_q, room);
    for (int lane = 0; lane < factor::kLaneCount; ++lane) {
        if (batch.front[lane] < 0) continue;
        const Front& front = view.fronts[batch.front[lane]];
        const std::int32_t* slot = view.tail_slot + front.rows;
        double* update[kSides] = {view.work + front.update};
        if constexpr (kSides == 2) update[1] = view.upper_work + front.update;
        for (int j = 0; j < front.q; ++j) {
            const long column = static_cast<long>(j) * front.ldu;
            const SlotRecord at_j = read_slot_record(room, slot[j]);
            for (int i = j; i < front.q; ++i) {
                const SlotRecord at_i = read_slot_record(room, slot[i]);
                const bool turned = at_i.row < at_j.row;
                const long entry =
                    lane + (turned ? at_j.row + at_i.column : at_i.row + at_j.column);
                update[0][column + i] = window[kSides == 2 && turned][entry];
                if constexpr (kSides == 2) update[1][column + i] = window[!turned][entry];
            }
        }
    }
}

/// Return the sum of the integers in a vector.
HAWSER_INLINE int count(const V8& v) { return static_cast<int>(sum(v)); }

template <int kSides>
inline int factor_steps(const FactorView& view, const Batch& batch, std::int32_t begin,
                        std::int32_t end, double* scratch) {
    const long tiles = batch.max_q / kTile, size = kTileSize * (tiles * (tiles + 1) / 2);
    const long turned = (begin - batch.step_begin) % 2;  // windows are swapped at each step
    double *window[kSides], *next[kSides];
    Columns<kSides> m{};
    for (int s = 0; s < kSides; ++s) {
        double* room = scratch + s * factor::batch_windows(batch);
        window[s] = room + turned * size;
        next[s] = room + (1 - turned) * size;
        m.w[s] = room + 2 * size;
    }
    V8 bad{};
    Shift shift = shift_before(view, batch, begin);
    auto swap_windows = [&] {
        for (int s = 0; s < kSides; ++s) std::swap(window[s], next[s]);
    };
    bool begun = false;  // true if this step's pivots are eliminated
    for (std::int32_t k = begin; k < end; ++k) {
        const BatchStep& step = view.batch_steps[k];
        if (kManyRegisters && kSides == 1 && is_rigid(view, batch, k)) {
            const RigidStep rigid = rigid_step(view, k, m.w[0]);
            if (!begun) begin_rigid(rigid, shift, window[0], bad);
            begun = k + 1 < end && is_rigid(view, batch, k + 1);
            const RigidStep following = begun ? rigid_step(view, k + 1, m.w[0]) : rigid;
            finish_rigid(rigid, begun ? &following : nullptr, shift, window[0], next[0], bad);
            swap_windows();
            shift.before = step.q / kTile;
            continue;
        }
        m.panel[0] = view.panel + step.panel;
        m.stride = 8L * step.p;
        m.pivot = view.slot_pivot + 8 * step.slot;
        m.sign = view.slot_sign + step.slot;
        if constexpr (kSides == 2) {
            m.panel[1] = view.upper + step.panel;
            m.index = view.slot_index + 8 * step.slot;
            m.wrong = view.wrong;
        }
        const int n = step.p + step.q;
        if (shift.before > 0)
            for (int s = 0; s < kSides; ++s) add_window(m.panel[s], step, shift, window[s]);
        for (int c = 0; c < step.p; c += kTile)
            with_size(step.p - c, [&]<int N>() { factor_columns<N>(m, c, n, bad); });
        const long below = step.p * m.stride;
        for (int s = 0; s < kSides; ++s)
            update_window(m.panel[s] + below, m.w[m.other(s)] + below, m.stride, step, shift,
                          window[s], next[s]);
        swap_windows();
        shift.before = step.q / kTile;
    }
    if (end < batch.step_end) return count(bad);
    store_tails(view, batch, window, next[0]);
    return count(bad) - static_cast<int>(batch.unused);
}

}  // namespace

int factor_batch(const FactorView& view, const Batch& batch, std::int32_t begin, std::int32_t end,
                 double* scratch) noexcept {
    if (view.is_unsymmetric(batch.front[0]))
        return factor_steps<2>(view, batch, begin, end, scratch);
    return factor_steps<1>(view, batch, begin, end, scratch);
}

}  // namespace hawser::HAWSER_ISA
