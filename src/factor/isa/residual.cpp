// SPDX-License-Identifier: Apache-2.0
/// b − K x of some nodes (see factor/residual.h): a node's rows are the lanes of as many vectors as
/// they need, and each column of its blocks is added as a whole. Lanes behind its rows hold
/// anything until the end.
#include "factor/isa/residual.h"

#include "base/simd.h"

namespace hawser::HAWSER_ISA {
namespace {

// Most nodes have three or six rows: V8 would be half empty.
#if defined(__AVX2__)
constexpr int kWidth = 4;
#else
constexpr int kWidth = 2;
#endif
typedef double Rows __attribute__((vector_size(8 * kWidth), aligned(8), may_alias));
typedef long long Bits __attribute__((vector_size(8 * kWidth)));
constexpr int kMostVectors = (6 + kWidth - 1) / kWidth;

HAWSER_INLINE Rows rows_at(const double* p) { return *reinterpret_cast<const Rows*>(p); }
HAWSER_INLINE Rows magnitude(const Rows& v) {
    return reinterpret_cast<Rows>(reinterpret_cast<Bits>(v) & 0x7fff'ffff'ffff'ffffLL);
}
HAWSER_INLINE Rows larger(const Rows& a, const Rows& b) { return a > b ? a : b; }
/// v with zeros in the lanes from `count` on.
HAWSER_INLINE Rows first_rows(const Rows& v, int count) {
    Bits index;
    for (int i = 0; i < kWidth; ++i) index[i] = i;
    return reinterpret_cast<Rows>(reinterpret_cast<Bits>(v) & (index < count));
}

/// Largest of each lane so far.
struct Largest {
    Rows error{}, size{};
    Rows unfit{};  ///< Zero; no number from the first ratio on that is not finite.
};

/// One node whose rows need so many vectors.
template <int kVectors>
HAWSER_INLINE void run_node(const factor::ResidualView& view, std::int32_t node, int rows,
                            Largest& most) {
    const std::int64_t first = view.scalar[node];
    Rows left[kVectors], total[kVectors];
    for (int n = 0; n < kVectors; ++n) {
        left[n] = rows_at(view.b + first + n * kWidth);
        total[n] = magnitude(left[n]);
    }
    for (std::int64_t t = view.term[node]; t < view.term[node + 1]; ++t) {
        const factor::ResidualTerm& term = view.terms[t];
        const double* k = view.values + term.value;
        const double* x = view.x + term.scalar;
        for (int j = 0; j < term.columns; ++j, k += rows)
            for (int n = 0; n < kVectors; ++n) {
                const Rows product = rows_at(k + n * kWidth) * x[j];
                left[n] -= product;
                total[n] += magnitude(product);
            }
    }
    for (int n = 0; n < kVectors; ++n) {
        const int count = rows - n * kWidth;
        double* r = view.r + first + n * kWidth;
        if (count >= kWidth)
            *reinterpret_cast<Rows*>(r) = left[n];
        else
            for (int i = 0; i < count; ++i) r[i] = left[n][i];
        const Rows scale = rows_at(view.scale + first + n * kWidth);
        const Rows scaled = first_rows(magnitude(left[n]) * scale, count);
        const Rows full = first_rows(total[n] * scale, count) + view.guard;
        const Rows ratio = scaled / full;
        most.error = larger(ratio, most.error);
        most.size = larger(scaled, most.size);
        most.unfit += (ratio - ratio) + (full - full);  // nothing is little beside infinity
    }
}

}  // namespace

factor::ResidualSize residual(const factor::ResidualView& view, std::int32_t begin,
                              std::int32_t end) noexcept {
    Largest most;
    for (std::int32_t v = begin; v < end; ++v) {
        const int rows = static_cast<int>(view.scalar[v + 1] - view.scalar[v]);
        if (rows <= kWidth)
            run_node<1>(view, v, rows, most);
        else if (rows <= 2 * kWidth)
            run_node<2>(view, v, rows, most);
        else
            run_node<kMostVectors>(view, v, rows, most);
    }
    factor::ResidualSize all;
    for (int i = 0; i < kWidth; ++i) {
        if (most.error[i] > all.error) all.error = most.error[i];
        if (most.size[i] > all.size) all.size = most.size[i];
    }
    for (int i = 0; i < kWidth; ++i) all.error += most.unfit[i];
    return all;
}

}  // namespace hawser::HAWSER_ISA
