// SPDX-License-Identifier: Apache-2.0
/// Kernels of batches (see factor/batches.h for the picture): every scalar is a vector of eight
/// lanes, so no loop has a remainder and no pivot waits for another lane.
#include "base/simd.h"
#include "factor/kernels.h"
#include "factor/symbolic.h"

namespace hawser::HAWSER_ISA {
namespace {

using factor::Batch;
using factor::BatchStep;
using factor::FactorView;
using factor::Front;

using factor::kTile;

constexpr int kTileSize = 8 * kTile * kTile;  // doubles

/// acc(i, j) −= Σ_k a(i, k) b(j, k), rows `stride` doubles apart.
template <int NI, int NJ>
HAWSER_INLINE void tile(V8 (&acc)[NI][NJ], const double* a, const double* b, long stride,
                        int depth) {
    for (int k = 0; k < depth; ++k) {
        V8 l[NI], u[NJ];
        for (int i = 0; i < NI; ++i) l[i] = load(a + i * stride + 8 * k);
        for (int j = 0; j < NJ; ++j) u[j] = load(b + j * stride + 8 * k);
        for (int i = 0; i < NI; ++i)
            for (int j = 0; j < NJ; ++j) acc[i][j] -= l[i] * u[j];
    }
}

/// Call f with the tile sizes as constants.
template <class F>
HAWSER_INLINE void with_size(int n, F&& f) {
    switch (n) {
        case 1:
            f.template operator()<1>();
            break;
        case 2:
            f.template operator()<2>();
            break;
        default:
            f.template operator()<3>();
            break;
    }
}

/// One column block of a step's panel.
struct Columns {
    double* panel;  ///< n rows of p vectors: A, overwritten with L.
    double* u;      ///< Likewise: L D.
    long stride;    ///< 8 p.
    double* pivot;  ///< p vectors: 1/D.
    const signed char* sign;
};

/// Factor columns [c, c + N) of the panel, rows to n.
template <int N>
inline void factor_columns(const Columns& m, int c, int n, V8& bad) {
    V8 inverse[N], lower[N][N];
    {
        V8 a[N][N];
        for (int i = 0; i < N; ++i)
            for (int j = 0; j < N; ++j) a[i][j] = load(m.panel + (c + i) * m.stride + 8 * (c + j));
        tile<N, N>(a, m.panel + c * m.stride, m.u + c * m.stride, m.stride, c);
        for (int j = 0; j < N; ++j) {
            V8 d = a[j][j];
            bad += fix_pivot(d, m.sign[c + j]);
            inverse[j] = reciprocal(d);
            store(m.pivot + 8 * (c + j), inverse[j]);
            for (int i = j + 1; i < N; ++i) {
                const V8 x = a[i][j];
                lower[i][j] = x * inverse[j];
                store(m.panel + (c + i) * m.stride + 8 * (c + j), lower[i][j]);
                store(m.u + (c + i) * m.stride + 8 * (c + j), x);
                for (int k = j + 1; k <= i; ++k) a[i][k] -= lower[i][j] * a[k][j];
            }
        }
    }
    for (int r = c + N; r < n; r += kTile) {
        with_size(n - r, [&]<int R>() {
            V8 a[R][N];
            double* row = m.panel + r * m.stride;
            for (int i = 0; i < R; ++i)
                for (int j = 0; j < N; ++j) a[i][j] = load(row + i * m.stride + 8 * (c + j));
            tile<R, N>(a, row, m.u + c * m.stride, m.stride, c);
            for (int i = 0; i < R; ++i)
                for (int j = 0; j < N; ++j) {
                    for (int k = 0; k < j; ++k) a[i][j] -= lower[j][k] * a[i][k];
                    store(m.u + (r + i) * m.stride + 8 * (c + j), a[i][j]);
                    store(row + i * m.stride + 8 * (c + j), a[i][j] * inverse[j]);
                }
        });
    }
}

/// Where the update slots of a step come from, in tiles: the tile that held them before.
struct Shift {
    int body, window, before;  ///< Tiles of a body; of the window; of the update slots before.
    /// −1: new in this step.
    [[nodiscard]] int from(int tile) const {
        if (tile < window) return tile + body < window && before > 0 ? tile + body : -1;
        return tile < before ? tile : -1;
    }
};

/// Tile (i, j), i ≥ j, of a window.
HAWSER_INLINE long tile_at(int i, int j) {
    return kTileSize * (static_cast<long>(i) * (i + 1) / 2 + j);
}

/// next = shifted window − L21 D L21ᵀ.
inline void update_window(const Columns& m, const BatchStep& step, const Shift& shift,
                          const double* window, double* next) {
    const double* l = m.panel + step.p * m.stride;
    const double* u = m.u + step.p * m.stride;
    for (int i = 0; i < step.q / kTile; ++i) {
        const int row = shift.from(i);
        for (int j = 0; j <= i; ++j) {
            const int column = shift.from(j);
            V8 acc[kTile][kTile];
            if (row < 0 || column < 0) {
                for (auto& r : acc)
                    for (V8& v : r) v = V8{};
            } else {
                const double* old = window + tile_at(row, column);
                for (int a = 0; a < kTile; ++a)
                    for (int b = 0; b < kTile; ++b) acc[a][b] = load(old + 8 * (kTile * a + b));
            }
            tile<kTile, kTile>(acc, l + kTile * i * m.stride, u + kTile * j * m.stride, m.stride,
                               step.p);
            double* to = next + tile_at(i, j);
            for (int a = 0; a < kTile; ++a)
                for (int b = 0; b < kTile; ++b) store(to + 8 * (kTile * a + b), acc[a][b]);
        }
    }
}

/// Add what earlier units left on this step's body.
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
            if (const int row = shift.from(i); row >= 0)
                add(step.p + kTile * i, kTile * j, window + tile_at(row, j), kTile);
    }
}

/// Hand the last window to the parents' side, lane by lane.
void store_tails(const FactorView& view, const Batch& batch, const double* window) {
    for (int lane = 0; lane < factor::kLaneCount; ++lane) {
        if (batch.front[lane] < 0) continue;
        const Front& front = view.fronts[batch.front[lane]];
        const std::int32_t* slot = view.tail_slot + front.rows;
        double* update = view.work + front.update;
        for (int j = 0; j < front.q; ++j) {
            double* column = update + static_cast<long>(j) * front.ldu;
            for (int i = j; i < front.q; ++i) {
                const int r = slot[i] > slot[j] ? slot[i] : slot[j];
                const int c = slot[i] > slot[j] ? slot[j] : slot[i];
                column[i] = window[tile_at(r / kTile, c / kTile) +
                                   8 * (kTile * (r % kTile) + c % kTile) + lane];
            }
        }
    }
}

}  // namespace

int factor_batch(const FactorView& view, const Batch& batch, double* scratch) noexcept {
    const long tiles = batch.most_q / kTile;
    double* window = scratch;
    double* next = window + kTileSize * (tiles * (tiles + 1) / 2);
    double* u = next + kTileSize * (tiles * (tiles + 1) / 2);
    V8 bad{};
    Shift shift{batch.body / kTile, batch.window / kTile, 0};
    for (std::int32_t k = batch.step_begin; k < batch.step_end; ++k) {
        const BatchStep& step = view.batch_steps[k];
        const Columns m{view.panel + step.panel, u, 8L * step.p, view.slot_pivot + 8 * step.slot,
                        view.slot_sign + step.slot};
        const int n = step.p + step.q;
        if (shift.before > 0) add_window(m.panel, step, shift, window);
        for (int c = 0; c < step.p; c += kTile)
            with_size(step.p - c, [&]<int N>() { factor_columns<N>(m, c, n, bad); });
        update_window(m, step, shift, window, next);
        double* swap = window;
        window = next;
        next = swap;
        shift.before = step.q / kTile;
    }
    store_tails(view, batch, window);
    return static_cast<int>(sum(bad)) - static_cast<int>(batch.unused);
}

/// y_p = L11⁻¹ (x_p + carried), carried −= L21 y_p.
/// Ask for the panel that comes some steps later: what is known long before need not be waited
/// for. The substitutions read each entry once, and large factors come from memory.
HAWSER_INLINE void ask_for_panel(const FactorView& view, const BatchStep& step) {
    const double* panel = view.panel + step.panel;
    const long size = 8L * step.p * (step.p + step.q);
    for (long i = 0; i < size; i += 8) __builtin_prefetch(panel + i);
}
constexpr int kAhead = 2;  // steps

void forward_batch(const FactorView& view, const Batch& batch, const double* x,
                   double* scratch) noexcept {
    double* carried = scratch;
    double* next = carried + 8 * batch.most_q;
    Shift shift{batch.body / kTile, batch.window / kTile, 0};
    for (std::int32_t k = batch.step_begin; k < batch.step_end; ++k) {
        const BatchStep& step = view.batch_steps[k];
        if (view.distant && k + kAhead < batch.step_end)
            ask_for_panel(view, view.batch_steps[k + kAhead]);
        const double* panel = view.panel + step.panel;
        double* y = view.slot_y + 8 * step.slot;
        const std::int32_t* index = view.slot_index + 8 * step.slot;
        const int p = step.p;
        for (int i = 0; i < p; ++i) {
            V8 v = gather_lanes(x, index + 8 * i);
            if (i < batch.body && shift.before > 0) v += load(carried + 8 * i);
            const double* row = panel + 8L * i * p;
            for (int j = 0; j < i; ++j) v -= load(row + 8 * j) * load(y + 8 * j);
            store(y + 8 * i, v);
        }
        for (int i = 0; i < step.q; i += kTile) {
            const int from = shift.from(i / kTile);
            V8 v[kTile][1];
            for (int a = 0; a < kTile; ++a)
                v[a][0] = from >= 0 ? load(carried + 8 * (kTile * from + a)) : V8{};
            tile<kTile, 1>(v, panel + 8L * (p + i) * p, y, 8L * p, p);
            for (int a = 0; a < kTile; ++a) store(next + 8 * (i + a), v[a][0]);
        }
        double* swap = carried;
        carried = next;
        next = swap;
        shift.before = step.q / kTile;
    }
    for (int lane = 0; lane < factor::kLaneCount; ++lane) {
        if (batch.front[lane] < 0) continue;
        const Front& front = view.fronts[batch.front[lane]];
        const std::int32_t* slot = view.tail_slot + front.rows;
        for (int i = 0; i < front.q; ++i) view.carry[front.rows + i] = carried[8 * slot[i] + lane];
    }
}

/// x_p = L11⁻ᵀ (D⁻¹ y_p − L21ᵀ x_behind).
void backward_batch(const FactorView& view, const Batch& batch, double* x,
                    double* scratch) noexcept {
    double* behind = scratch;
    const int q = batch.most_q;
    for (int i = 0; i < q; ++i) store(behind + 8 * i, V8{});
    for (int lane = 0; lane < factor::kLaneCount; ++lane) {
        if (batch.front[lane] < 0) continue;
        const Front& front = view.fronts[batch.front[lane]];
        const std::int32_t* slot = view.tail_slot + front.rows;
        for (int i = 0; i < front.q; ++i) behind[8 * slot[i] + lane] = x[view.rows[front.rows + i]];
    }
    double* z = behind + 8 * q;
    for (std::int32_t k = batch.step_end; k-- > batch.step_begin;) {
        const BatchStep& step = view.batch_steps[k];
        if (view.distant && k - kAhead >= batch.step_begin)
            ask_for_panel(view, view.batch_steps[k - kAhead]);
        const double* panel = view.panel + step.panel;
        const double* y = view.slot_y + 8 * step.slot;
        const double* pivot = view.slot_pivot + 8 * step.slot;
        const int p = step.p;
        for (int j = 0; j < p; j += kTile)
            with_size(p - j, [&]<int N>() {
                V8 v[N];
                for (int a = 0; a < N; ++a)
                    v[a] = load(y + 8 * (j + a)) * load(pivot + 8 * (j + a));
                const double* column = panel + 8L * p * p + 8 * j;
                for (int i = 0; i < step.q; ++i, column += 8L * p) {
                    const V8 b = load(behind + 8 * i);
                    for (int a = 0; a < N; ++a) v[a] -= load(column + 8 * a) * b;
                }
                for (int a = 0; a < N; ++a) store(z + 8 * (j + a), v[a]);
            });
        for (int i = p; i-- > 0;) {
            const V8 zi = load(z + 8 * i);
            const double* row = panel + 8L * i * p;
            for (int j = 0; j < i; ++j) store(z + 8 * j, load(z + 8 * j) - load(row + 8 * j) * zi);
            scatter_lanes(x, view.slot_index + 8 * (step.slot + i), zi);
        }
        // This body now leads the window.
        for (int i = batch.window; i-- > batch.body;)
            store(behind + 8 * i, load(behind + 8 * (i - batch.body)));
        for (int i = 0; i < batch.body; ++i) store(behind + 8 * i, load(z + 8 * i));
    }
}

}  // namespace hawser::HAWSER_ISA
