// SPDX-License-Identifier: Apache-2.0
/// Dense kernels of the multifrontal LDLᵀ (see factor/symbolic.h for the picture).
///
/// Column strides are multiples of eight doubles (base/simd.h), and rows past p + q stay zero,
/// so no loop has a remainder. Blocks of kBlock pivot columns are factored one column at a time,
/// then everything to their right is updated by a register-blocked product.
#include "factor/kernels.h"

#include "base/simd.h"
#include "factor/isa/batch.h"
#include "factor/isa/substitution.h"
#include "factor/symbolic.h"

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

/// C(:, 0..cols) −= L · Wᵀ for `cols` columns whose rows in l and w start at row0, or C = −L · Wᵀ
/// where C holds nothing yet. The lower triangle is what counts; rows above it in the same vector
/// are computed and never read.
template <int kCols, bool kFirst>
inline void update_columns(double* c, long ldc, const double* l, const double* w, long ld,
                           int depth, int from, int rows) {
    for (int i = from; i < rows; i += 8) {
        V8 acc[kCols];
        for (int j = 0; j < kCols; ++j) acc[j] = kFirst ? V8{} : load(c + j * ldc + i);
        for (int k = 0; k < depth; ++k) {
            const V8 v = load(l + k * ld + i);
            for (int j = 0; j < kCols; ++j) acc[j] -= v * w[k * ld + j];
        }
        for (int j = 0; j < kCols; ++j) store(c + j * ldc + i, acc[j]);
    }
}

/// Symmetric update of the columns [begin, end) of a matrix whose row r lies at l + r. The last
/// columns go together, however many: a column alone waits for its own chain of sums.
template <bool kFirst>
inline void update_block(double* c, long ldc, const double* l, const double* w, long ld, int depth,
                         int begin, int end, int rows) {
    int j = begin;
    auto columns = [&]<int N>() {
        update_columns<N, kFirst>(c + j * ldc, ldc, l, w + j, ld, depth, j & ~7, rows);
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

/// to(0..rows, 0..columns) += from(0..rows, 0..columns).
inline void add_block(double* to, long ld_to, const double* from, long ld_from, int rows,
                      int columns) {
    for (int i = 0; i < rows; i += 8) {
        for (int c = 0; c < columns; ++c)
            add_first(to + c * ld_to + i, from + c * ld_from + i, rows - i);
    }
}

/// Add the columns of children's update matrices that are pivots of the front, or those that are
/// not. A run of columns meets the runs of rows at and behind it in dense blocks; the triangle
/// above the diagonal of the first comes along and is never read.
template <bool kPivots>
inline void extend_add(const FactorView& view, const Front& front, double* panel, double* update) {
    const long ld = kPivots ? front.ld : front.ldu;
    double* target = kPivots ? panel : update - front.p - static_cast<long>(front.p) * ld;
    for (std::int32_t i = front.child_begin; i < front.child_end; ++i) {
        const Front& child = view.fronts[view.children[i]];
        const double* u = view.update(child.update);
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

int factor_fronts(const FactorView& view, std::int32_t begin, std::int32_t end,
                  double* scratch) noexcept {
    int wrong = 0;
    for (std::int32_t f = begin; f < end; ++f) {
        const Front& front = view.fronts[f];
        if (front.batch >= 0) continue;
        double* panel = view.panel + front.panel;
        double* update = view.update(front.update);
        extend_add<true>(view, front, panel, update);
        for (int k0 = 0; k0 < front.p; k0 += kBlock) {
            const int k1 = k0 + kBlock < front.p ? k0 + kBlock : front.p;
            wrong += factor_columns(panel, front.ld, k0, k1 - k0, scratch,
                                    view.pivot + front.offset, view.sign + front.offset);
            const double* l = panel + static_cast<long>(k0) * front.ld;
            if (k1 < front.p)
                update_block<false>(panel, front.ld, l, scratch, front.ld, k1 - k0, k1, front.p,
                                    front.ld);
            if (k0 == 0)
                update_block<true>(update, front.ldu, l + front.p, scratch + front.p, front.ld,
                                   k1 - k0, 0, front.q, front.ldu);
            else
                update_block<false>(update, front.ldu, l + front.p, scratch + front.p, front.ld,
                                    k1 - k0, 0, front.q, front.ldu);
        }
        extend_add<false>(view, front, panel, update);
    }
    return wrong;
}

}  // namespace

extern const factor::FactorKernels kFactorKernels;
const factor::FactorKernels kFactorKernels = {factor_fronts, forward_fronts, backward_fronts,
                                              factor_batch,  forward_batch,  backward_batch};

}  // namespace hawser::HAWSER_ISA
