// SPDX-License-Identifier: Apache-2.0
/// Dense kernels of the multifrontal LDLᵀ (see factor/symbolic.h for the picture).
///
/// Column strides are multiples of eight doubles (base/simd.h), and rows past p + q stay zero,
/// so no loop has a remainder. Blocks of kBlock pivot columns are factored one column at a time,
/// then everything to their right is updated by a register-blocked product.
#include "factor/kernels.h"

#include "base/simd.h"
#include "factor/isa/batch.h"
#include "factor/symbolic.h"

#include <cstring>

namespace hawser::HAWSER_ISA {
namespace {

using factor::FactorView;
using factor::Front;
using factor::Run;

constexpr int kBlock = 8;  // pivot columns factored before the rest is updated

/// Factor the N ≤ 8 columns from k0, a multiple of eight, of a panel of stride ld. w receives
/// the unscaled columns, stride ld, rows as in the panel.
///
/// Rows k0 … k0 + 7 hold the triangle: N sequential pivots, in registers. The vectors of rows
/// below it are then independent of each other: x_c = a_c − Σ_{b<c} L_cb x_b.
template <int N>
inline int factor_block(double* panel, long ld, int k0, double* w, double* pivot,
                        const signed char* sign) {
    int wrong = 0;
    V8 top[N];
    double inverse[N], lower[N][N];
    for (int c = 0; c < N; ++c) top[c] = load(panel + (k0 + c) * ld + k0);
#pragma GCC unroll 8
    for (int c = 0; c < N; ++c) {
        double d = lane(top[c], c);
        // Quasi-definite: the sign is known. !(…) also catches NaN.
        if (!(d * sign[k0 + c] > 0.0) || d - d != 0.0) {
            ++wrong;
            d = sign[k0 + c];
        }
        inverse[c] = 1.0 / d;
        pivot[k0 + c] = inverse[c];
        const V8 l = after_lane(top[c] * inverse[c], c);
#pragma GCC unroll 8
        for (int j = c + 1; j < N; ++j) {
            const double wj = lane(top[c], j);
            lower[j][c] = wj * inverse[c];
            top[j] -= wj * l;
        }
        store(w + c * ld + k0, top[c]);
        store(panel + (k0 + c) * ld + k0, l);
    }
    for (long i = k0 + 8; i < ld; i += 8) {
        V8 x[N];
#pragma GCC unroll 8
        for (int c = 0; c < N; ++c) {
            x[c] = load(panel + (k0 + c) * ld + i);
            for (int b = 0; b < c; ++b) x[c] -= lower[c][b] * x[b];
            store(w + c * ld + i, x[c]);
            store(panel + (k0 + c) * ld + i, x[c] * inverse[c]);
        }
    }
    return wrong;
}

inline int factor_columns(double* panel, long ld, int k0, int count, double* w, double* pivot,
                          const signed char* sign) {
    switch (count) {
        case 1:
            return factor_block<1>(panel, ld, k0, w, pivot, sign);
        case 2:
            return factor_block<2>(panel, ld, k0, w, pivot, sign);
        case 3:
            return factor_block<3>(panel, ld, k0, w, pivot, sign);
        case 4:
            return factor_block<4>(panel, ld, k0, w, pivot, sign);
        case 5:
            return factor_block<5>(panel, ld, k0, w, pivot, sign);
        case 6:
            return factor_block<6>(panel, ld, k0, w, pivot, sign);
        case 7:
            return factor_block<7>(panel, ld, k0, w, pivot, sign);
        default:
            return factor_block<8>(panel, ld, k0, w, pivot, sign);
    }
}

/// C(:, 0..cols) −= L · Wᵀ for `cols` columns whose rows in l and w start at row0. The lower
/// triangle is what counts; rows above it in the same vector are computed and never read.
template <int kCols>
inline void update_columns(double* c, long ldc, const double* l, const double* w, long ld,
                           int depth, int from, int rows) {
    for (int i = from; i < rows; i += 8) {
        V8 acc[kCols];
        for (int j = 0; j < kCols; ++j) acc[j] = load(c + j * ldc + i);
        for (int k = 0; k < depth; ++k) {
            const V8 v = load(l + k * ld + i);
            for (int j = 0; j < kCols; ++j) acc[j] -= v * w[k * ld + j];
        }
        for (int j = 0; j < kCols; ++j) store(c + j * ldc + i, acc[j]);
    }
}

/// Symmetric update of the columns [begin, end) of a matrix whose row r lies at l + r. The last
/// columns go together, however many: a column alone waits for its own chain of sums.
inline void update_block(double* c, long ldc, const double* l, const double* w, long ld, int depth,
                         int begin, int end, int rows) {
    int j = begin;
    auto columns = [&]<int N>() {
        update_columns<N>(c + j * ldc, ldc, l, w + j, ld, depth, j & ~7, rows);
        j += N;
    };
    while (end - j >= 8) columns.template operator()<8>();
    switch (end - j) {
        case 7:
            columns.template operator()<7>();
            break;
        case 6:
            columns.template operator()<6>();
            break;
        case 5:
            columns.template operator()<5>();
            break;
        case 4:
            columns.template operator()<4>();
            break;
        case 3:
            columns.template operator()<3>();
            break;
        case 2:
            columns.template operator()<2>();
            break;
        case 1:
            columns.template operator()<1>();
            break;
        default:
            break;
    }
}

/// to[0..n) += from[0..n). Whole vectors while they end before to + room: their surplus lanes
/// add zero to entries of the same column.
inline void add_run(double* to, const double* from, int n, int room) {
    int i = 0;
    for (; i < n && i + 8 <= room; i += 8)
        store(to + i, load(to + i) + first_lanes(load(from + i), n - i));
    for (; i < n; ++i) to[i] += from[i];
}

/// Add a child's update matrix into the front.
inline void extend_add(const FactorView& view, const Front& child, const Front& front,
                       double* panel, double* update) {
    const double* u = view.work + child.update;
    const Run* end = view.runs + child.run_end;
    for (const Run* run = view.runs + child.run_begin; run != end; ++run) {
        for (int c = 0; c < run->length; ++c) {
            const double* source = u + static_cast<long>(run->from + c) * child.ldu;
            const int column = run->to + c;
            const bool pivot = column < front.p;
            const int height = pivot ? front.ld : front.p + front.ldu;
            double* target =
                pivot ? panel + static_cast<long>(column) * front.ld
                      : update + static_cast<long>(column - front.p) * front.ldu - front.p;
            add_run(target + column, source + run->from + c, run->length - c, height - column);
            for (const Run* r = run + 1; r != end; ++r)
                add_run(target + r->to, source + r->from, r->length, height - r->to);
        }
    }
}

int factor_fronts(const FactorView& view, std::int32_t begin, std::int32_t end,
                  double* scratch) noexcept {
    int wrong = 0;
    for (std::int32_t f = begin; f < end; ++f) {
        const Front& front = view.fronts[f];
        if (front.batch >= 0) continue;
        double* panel = view.panel + front.panel;
        double* update = view.work + front.update;
        std::memset(update, 0,
                    sizeof(double) * static_cast<unsigned long>(front.ldu) *
                        static_cast<unsigned long>(front.q));
        for (std::int32_t c = front.child_begin; c < front.child_end; ++c)
            extend_add(view, view.fronts[view.children[c]], front, panel, update);
        for (int k0 = 0; k0 < front.p; k0 += kBlock) {
            const int k1 = k0 + kBlock < front.p ? k0 + kBlock : front.p;
            wrong += factor_columns(panel, front.ld, k0, k1 - k0, scratch,
                                    view.pivot + front.offset, view.sign + front.offset);
            const double* l = panel + static_cast<long>(k0) * front.ld;
            update_block(panel, front.ld, l, scratch, front.ld, k1 - k0, k1, front.p, front.ld);
            update_block(update, front.ldu, l + front.p, scratch + front.p, front.ld, k1 - k0, 0,
                         front.q, front.ldu);
        }
    }
    return wrong;
}

/// y −= Σ_k L_k y_k, columns in order, for a panel of any height.
inline void forward_panel(const double* panel, long ld, int p, double* y) {
    for (int k = 0; k < p; ++k) {
        const double* column = panel + k * ld;
        const double yk = y[k];
        for (long i = k & ~7; i < ld; i += 8) store(y + i, load(y + i) - yk * load(column + i));
    }
}

/// The same for a panel of NV vectors, with y in registers: each column waits for a lane of the
/// one before it, not for memory.
template <int NV>
inline void forward_panel(const double* panel, int p, double* y) {
    constexpr long kLd = 8 * NV;
    V8 v[NV];
    for (int i = 0; i < NV; ++i) v[i] = load(y + 8 * i);
    const double* column = panel;
#pragma GCC unroll 4
    for (int block = 0; block < NV; ++block) {
        const int count = p - 8 * block < 8 ? p - 8 * block : 8;
        for (int c = 0; c < count; ++c, column += kLd) {
            const V8 yk = spread_lane(v[block], c);
#pragma GCC unroll 4
            for (int i = block; i < NV; ++i) v[i] -= yk * load(column + 8 * i);
        }
    }
    for (int i = 0; i < NV; ++i) store(y + 8 * i, v[i]);
}

void forward_fronts(const FactorView& view, std::int32_t begin, std::int32_t end, double* x,
                    double* scratch) noexcept {
    for (std::int32_t f = begin; f < end; ++f) {
        const Front& front = view.fronts[f];
        if (front.batch >= 0) continue;
        const double* panel = view.panel + front.panel;
        double* y = scratch;
        const int ld = front.ld, p = front.p;
        for (int i = 0; i < p; ++i) y[i] = x[front.offset + i];
        for (int i = p; i < ld; ++i) y[i] = 0.0;
        for (std::int32_t c = front.child_begin; c < front.child_end; ++c) {
            const Front& child = view.fronts[view.children[c]];
            const double* carried = view.carry + child.rows;
            for (std::int32_t r = child.run_begin; r < child.run_end; ++r) {
                const Run& run = view.runs[r];
                for (int i = 0; i < run.length; ++i) y[run.to + i] += carried[run.from + i];
            }
        }
        switch (ld / 8) {
            case 1:
                forward_panel<1>(panel, p, y);
                break;
            case 2:
                forward_panel<2>(panel, p, y);
                break;
            case 3:
                forward_panel<3>(panel, p, y);
                break;
            case 4:
                forward_panel<4>(panel, p, y);
                break;
            default:
                forward_panel(panel, ld, p, y);
                break;
        }
        for (int i = 0; i < p; ++i) x[front.offset + i] = y[i];
        double* carry = view.carry + front.rows;
        for (int i = 0; i < front.q; ++i) carry[i] = y[p + i];
    }
}

/// Columns [k, k + N) of Lᵀ z = y, N ≤ 8, the entries of y behind them being solved.
/// The products with those entries come first and are independent of each other; then the
/// small triangle, in which each entry waits only for the one before it.
template <int N>
inline void backward_block(const double* panel, long ld, int k, double* y) {
    V8 acc[N];
    const int from = (k + N) & ~7;
    // k is a multiple of 8: either the block fills its vector, or rows k … k + N − 1 of that
    // vector belong to the block and must not count.
    double rest[8];
    for (int i = 0; i < 8; ++i) rest[i] = from + i < k + N ? 0.0 : y[from + i];
    const V8 first = load(rest);
    for (int c = 0; c < N; ++c) acc[c] = load(panel + (k + c) * ld + from) * first;
    for (int i = from + 8; i < ld; i += 8) {
        const V8 v = load(y + i);
        for (int c = 0; c < N; ++c) acc[c] += load(panel + (k + c) * ld + i) * v;
    }
    double s[8], z[N];
    sums<N>(acc, s);
    for (int c = N; c-- > 0;) {
        const double* column = panel + (k + c) * ld + k;
        z[c] = y[k + c] - s[c];
        for (int i = N - 1; i > c; --i) z[c] -= column[i] * z[i];
    }
    for (int c = 0; c < N; ++c) y[k + c] = z[c];
}

inline void backward_columns(const double* panel, long ld, int k, int count, double* y) {
    switch (count) {
        case 1:
            backward_block<1>(panel, ld, k, y);
            break;
        case 2:
            backward_block<2>(panel, ld, k, y);
            break;
        case 3:
            backward_block<3>(panel, ld, k, y);
            break;
        case 4:
            backward_block<4>(panel, ld, k, y);
            break;
        case 5:
            backward_block<5>(panel, ld, k, y);
            break;
        case 6:
            backward_block<6>(panel, ld, k, y);
            break;
        case 7:
            backward_block<7>(panel, ld, k, y);
            break;
        default:
            backward_block<8>(panel, ld, k, y);
            break;
    }
}

void backward_fronts(const FactorView& view, std::int32_t begin, std::int32_t end, double* x,
                     double* scratch) noexcept {
    for (std::int32_t f = end; f-- > begin;) {
        const Front& front = view.fronts[f];
        if (front.batch >= 0) continue;
        const double* panel = view.panel + front.panel;
        const double* inverse = view.pivot + front.offset;
        double* y = scratch;
        const int ld = front.ld, p = front.p, n = front.p + front.q;
        const std::int32_t* rows = view.rows + front.rows;
        for (int i = 0; i < p; ++i) y[i] = x[front.offset + i] * inverse[i];
        for (int i = 0; i < front.q; ++i) y[p + i] = x[rows[i]];
        // One vector of slack: a block that ends at ld reads y there against zeros.
        for (int i = n; i < ld + 8; ++i) y[i] = 0.0;
        for (int k = (p - 1) & ~7; k >= 0; k -= 8)
            backward_columns(panel, ld, k, p - k < 8 ? p - k : 8, y);
        for (int i = 0; i < p; ++i) x[front.offset + i] = y[i];
    }
}

}  // namespace

extern const factor::FactorKernels kFactorKernels;
const factor::FactorKernels kFactorKernels = {factor_fronts, forward_fronts, backward_fronts,
                                              factor_batch,  forward_batch,  backward_batch};

}  // namespace hawser::HAWSER_ISA
