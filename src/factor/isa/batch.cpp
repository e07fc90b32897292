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

constexpr int kTile = 3;

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

/// Where the update slots of a step come from: the slot that held it in the step before.
struct Shift {
    int body, window, before;  ///< Scalars of a body; of the window; update slots before.
    /// −1: new in this step.
    [[nodiscard]] int from(int slot) const {
        if (slot < window) return slot + body < window && before > 0 ? slot + body : -1;
        return slot < before ? slot : -1;
    }
};

/// next = shifted window − L21 D L21ᵀ, lower triangle, `most` vectors a row.
inline void update_window(const Columns& m, const BatchStep& step, const Shift& shift,
                          const double* window, double* next, long most) {
    const double* l = m.panel + step.p * m.stride;
    const double* u = m.u + step.p * m.stride;
    for (int i = 0; i < step.q; i += kTile)
        with_size(step.q - i, [&]<int NI>() {
            for (int j = 0; j <= i; j += kTile)
                with_size(step.q - j, [&]<int NJ>() {
                    V8 acc[NI][NJ];
                    for (int a = 0; a < NI; ++a)
                        for (int b = 0; b < NJ; ++b) {
                            const int r = shift.from(i + a), c = shift.from(j + b);
                            acc[a][b] =
                                r >= 0 && c >= 0
                                    ? load(window + 8 * ((r > c ? r : c) * most + (r > c ? c : r)))
                                    : V8{};
                        }
                    tile<NI, NJ>(acc, l + i * m.stride, u + j * m.stride, m.stride, step.p);
                    for (int a = 0; a < NI; ++a)
                        for (int b = 0; b < NJ; ++b)
                            store(next + 8 * ((i + a) * most + j + b), acc[a][b]);
                });
        });
}

/// Add what earlier units left on this step's body.
inline void add_window(double* panel, const BatchStep& step, const Shift& shift,
                       const double* window, long most) {
    auto add = [&](int row, int column, int slot) {
        double* to = panel + 8 * (static_cast<long>(row) * step.p + column);
        store(to, load(to) + load(window + 8 * (slot * most + column)));
    };
    for (int j = 0; j < shift.body; ++j) {
        for (int i = j; i < shift.body; ++i) add(i, j, i);
        for (int i = 0; i < step.q; ++i)
            if (const int slot = shift.from(i); slot >= 0) add(step.p + i, j, slot);
    }
}

/// Hand the last window to the parents' side, lane by lane.
void store_tails(const FactorView& view, const Batch& batch, const double* window, long most) {
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
                column[i] = window[8 * (r * most + c) + lane];
            }
            // Whole vectors are added into the parent.
            for (int i = front.q; i < front.ldu; ++i) column[i] = 0.0;
        }
    }
}

}  // namespace

int factor_batch(const FactorView& view, const Batch& batch, double* scratch) noexcept {
    const long most = batch.most_q;
    double* window = scratch;
    double* next = window + 8 * most * most;
    double* u = next + 8 * most * most;
    V8 bad{};
    Shift shift{batch.body, batch.window, 0};
    for (std::int32_t k = batch.step_begin; k < batch.step_end; ++k) {
        const BatchStep& step = view.batch_steps[k];
        const Columns m{view.panel + step.panel, u, 8L * step.p, view.slot_pivot + 8 * step.slot,
                        view.slot_sign + step.slot};
        const int n = step.p + step.q;
        if (shift.before > 0) add_window(m.panel, step, shift, window, most);
        for (int c = 0; c < step.p; c += kTile)
            with_size(step.p - c, [&]<int N>() { factor_columns<N>(m, c, n, bad); });
        update_window(m, step, shift, window, next, most);
        double* swap = window;
        window = next;
        next = swap;
        shift.before = step.q;
    }
    store_tails(view, batch, window, most);
    return static_cast<int>(sum(bad)) - static_cast<int>(batch.unused);
}

/// y_p = L11⁻¹ (x_p + carried), carried −= L21 y_p.
void forward_batch(const FactorView& view, const Batch& batch, const double* x,
                   double* scratch) noexcept {
    double* carried = scratch;
    double* next = carried + 8 * batch.most_q;
    Shift shift{batch.body, batch.window, 0};
    for (std::int32_t k = batch.step_begin; k < batch.step_end; ++k) {
        const BatchStep& step = view.batch_steps[k];
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
        for (int i = 0; i < step.q; i += kTile)
            with_size(step.q - i, [&]<int N>() {
                V8 v[N][1];
                for (int a = 0; a < N; ++a) {
                    const int slot = shift.from(i + a);
                    v[a][0] = slot >= 0 ? load(carried + 8 * slot) : V8{};
                }
                tile<N, 1>(v, panel + 8L * (p + i) * p, y, 8L * p, p);
                for (int a = 0; a < N; ++a) store(next + 8 * (i + a), v[a][0]);
            });
        double* swap = carried;
        carried = next;
        next = swap;
        shift.before = step.q;
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
