// SPDX-License-Identifier: Apache-2.0
/// Substitution with the fronts of a multifrontal LDLᵀ or LDU (picture: factor/symbolic.h).
///
/// Blocks have up to eight pivots, and their number is a constant of the loops. The triangle of a
/// block is a chain of dependent operations and stays in one vector. The rows below it are
/// independent vectors. Vectors start at multiples of eight rows of the panel, so one vector may
/// contain the last pivots and the first update rows.
#include "factor/isa/substitution.h"

#include "base/lanes.h"
#include "base/simd.h"
#include "factor/isa/with_count.h"
#include "factor/symbolic.h"

#include <cstdint>

namespace hawser::HAWSER_ISA {
namespace {

using factor::FactorView;
using factor::Front;
using factor::Run;

constexpr int kPivotBlock = 8;
// Distances of prefetches: in panels [bytes], in tables [fronts].
constexpr long kPrefetchDistance = 8192;
constexpr std::int32_t kFrontsAhead = 6;

/// Load a vector of a panel and prefetch the vector `kBytes` further on; 0: no prefetch. Panels
/// larger than a core's cache need it. Columns are short and backward substitution descends in
/// addresses, so the hardware prefetcher does not follow. A core has at most a dozen pending
/// requests and drops further ones, hence one prefetch per vector.
template <long kBytes>
HAWSER_INLINE V8 load_ahead(const double* p) {
    // Computed as an integer, because the address may lie outside the array.
    if constexpr (kBytes != 0)
        __builtin_prefetch(
            reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(p) + kBytes));
    return load(p);
}

/// Prefetch the panel of the front `kFrontsAhead` positions further on, and the other data of the
/// present front.
template <bool kUp>
HAWSER_INLINE void prefetch_front(const FactorView& view, const Front& front, const double* x) {
    constexpr int kCacheLine = 64;
    const char* const further =
        reinterpret_cast<const char*>(kUp ? &front + kFrontsAhead : &front - kFrontsAhead);
    for (int i = 0; i < static_cast<int>(sizeof(Front)); i += kCacheLine)
        __builtin_prefetch(further + i);
    __builtin_prefetch(x + front.offset);
    if constexpr (kUp) {
        constexpr int kPrefetchStride = kCacheLine / sizeof(double);
        for (int i = 0; i < front.q; i += kPrefetchStride)
            __builtin_prefetch(view.carry + front.rows + i);
        __builtin_prefetch(view.runs + front.run_begin);
    } else {
        constexpr int kPrefetchStride = kCacheLine / sizeof(*view.rows);
        for (int i = 0; i < front.q; i += kPrefetchStride)
            __builtin_prefetch(view.rows + front.rows + i);
        __builtin_prefetch(view.pivot + front.offset);
    }
}

/// Solve pivots [k, k + N) of L y = y, then subtract L y from the rows behind them.
/// @param put  Called with each result: put(row, vector).
template <int N, long kBytes, class Put>
HAWSER_INLINE void forward_block(const double* panel, long ld, int k, const double* y, Put&& put) {
    const double* column = panel + k * ld;
    V8 v = load(y + k), pivot[N];
    for (int c = 0; c < N; ++c) {
        pivot[c] = spread_lane(v, c);
        v -= pivot[c] * load_ahead<kBytes>(column + c * ld + k);
    }
    put(k, v);
    for (int i = k + 8; i < ld; i += 8) {
        V8 acc = load(y + i);
        for (int c = 0; c < N; ++c) acc -= pivot[c] * load_ahead<kBytes>(column + c * ld + i);
        put(i, acc);
    }
}

/// Compute the right-hand side y of a front: its part of x plus the updates that its children
/// carry, in whole vectors.
inline void gather_forward(const FactorView& view, const Front& front, const double* x, double* y) {
    for (int i = 0; i < front.ld; i += 8)
        store(y + i, i < front.p ? load_first(x + front.offset + i, front.p - i) : V8{});
    for (std::int32_t c = front.child_begin; c < front.child_end; ++c) {
        const Front& child = view.fronts[view.children[c]];
        const double* carried = view.carry + child.rows;
        const Run* end = view.runs + child.run_end;
        for (const Run* run = view.runs + child.run_begin; run != end; ++run)
            for (int i = 0; i < run->length; i += 8)
                add_first(y + run->to + i, carried + run->from + i, run->length - i);
    }
}

/// Solve columns [k, k + N) of U z = y with Uᵀ in the panel, after the rows behind them are solved,
/// from vector `from` on. The independent products with these rows are computed first. The small
/// triangle follows, in which each entry depends only on the entry before it. z enters with y_k …
/// and returns z_k ….
template <int N, long kBytes>
HAWSER_INLINE void backward_block(const double* panel, long ld, int k, int from, const double* y,
                                  double* z) {
    V8 acc[N];
    const double* column = panel + k * ld;
    constexpr int kColumnGroup = 8 / kParts;  // columns with sums that fit in registers
#pragma GCC unroll 8
    for (int first = 0; first < N; first += kColumnGroup) {
        const int last = first + kColumnGroup < N ? first + kColumnGroup : N;
        for (int c = first; c < last; ++c) acc[c] = V8{};
        for (int i = from; i < ld; i += 8) {
            const V8 v = load(y + i);
            for (int c = first; c < last; ++c)
                acc[c] += load_ahead<kBytes>(column + c * ld + i) * v;
        }
    }
    const V8 s = sums<N>(acc);
    double solved[N];  // in registers: all indices are constants after unrolling
#pragma GCC unroll 8
    for (int c = N - 1; c >= 0; --c) {
        double zc = z[c] - lane(s, c);
#pragma GCC unroll 8
        for (int i = N - 1; i > c; --i) zc -= column[c * ld + k + i] * solved[i];
        z[c] = solved[c] = zc;
    }
}

template <long kBytes>
void forward(const FactorView& view, std::int32_t begin, std::int32_t end, double* x,
             double* scratch) noexcept {
    for (std::int32_t f = begin; f < end; ++f) {
        const Front& front = view.fronts[f];
        if (front.batch >= 0) continue;
        const double* panel = view.panel + front.panel;
        const int p = front.p, n = front.p + front.q;
        if (kBytes != 0 && f + 2 * kFrontsAhead < end)
            prefetch_front<true>(view, view.fronts[f + kFrontsAhead], x);
        double* xf = x + front.offset;
        double* y = scratch;
        gather_forward(view, front, x, y);
        int k = 0;
        for (; p - k > kPivotBlock; k += kPivotBlock)
            forward_block<kPivotBlock, kBytes>(panel, front.ld, k, y, [&](int i, const V8& v) {
                store(i == k ? xf + i : y + i, v);
            });
        double* carry = view.carry + front.rows - p;
        with_count(p - k, [&]<int N>() {
            forward_block<N, kBytes>(panel, front.ld, k, y, [&](int i, const V8& v) {
                if (i == k) store_lanes(xf + i, v, 0, N);
                store_lanes(carry + i, v, i == k ? N : 0, n - i);
            });
        });
    }
}

template <long kBytes>
void backward(const FactorView& view, std::int32_t begin, std::int32_t end, double* x,
              double* scratch) noexcept {
    for (std::int32_t f = end; f-- > begin;) {
        const Front& front = view.fronts[f];
        if (front.batch >= 0) continue;
        const double* panel = (view.is_unsymmetric(f) ? view.upper : view.panel) + front.panel;
        const double* inverse = view.pivot + front.offset;
        const int ld = front.ld, p = front.p, n = front.p + front.q;
        if (kBytes != 0 && f - 2 * kFrontsAhead >= begin)
            prefetch_front<false>(view, view.fronts[f - kFrontsAhead], x);
        double* xf = x + front.offset;
        double* y = scratch;
        const std::int32_t* rows = view.rows + front.rows - p;
        // Zeros fill the vector shared by the last pivots and update rows, and all slots behind
        // them.
        for (int i = p & ~7; i < ld; i += 8) store(y + i, gather_range(x, rows + i, p - i, n - i));
        int k = (p - 1) & ~7, from = p & ~7;
        with_count(p - k, [&]<int N>() {
            double z[8] = {};
            for (int c = 0; c < N; ++c) z[c] = xf[k + c] * inverse[k + c];
            backward_block<N, kBytes>(panel, ld, k, from, y, z);
            for (int c = 0; c < N; ++c) xf[k + c] = z[c];
            if (k > 0)
                for (int c = 0; c < N; ++c) y[k + c] = z[c];
        });
        for (k -= kPivotBlock; k >= 0; k -= kPivotBlock) {
            double z[8];
            for (int c = 0; c < kPivotBlock; ++c) z[c] = xf[k + c] * inverse[k + c];
            backward_block<kPivotBlock, kBytes>(panel, ld, k, k + kPivotBlock, y, z);
            for (int c = 0; c < kPivotBlock; ++c) xf[k + c] = y[k + c] = z[c];
        }
    }
}

}  // namespace

// Substitute forward in the fronts [begin, end). The lambdas of the functions that it calls belong
// to this file alone, so that g++ inlines them.
void forward_fronts(const FactorView& view, std::int32_t begin, std::int32_t end, double* x,
                    double* scratch) noexcept {
    view.distant ? forward<kPrefetchDistance>(view, begin, end, x, scratch)
                 : forward<0>(view, begin, end, x, scratch);
}

void backward_fronts(const FactorView& view, std::int32_t begin, std::int32_t end, double* x,
                     double* scratch) noexcept {
    view.distant ? backward<-kPrefetchDistance>(view, begin, end, x, scratch)
                 : backward<0>(view, begin, end, x, scratch);
}

}  // namespace hawser::HAWSER_ISA
