// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lanes.h
/// Some lanes of a vector: loads, stores and sums that touch no memory but theirs.

#include "base/simd.h"

#include <cstdint>

namespace hawser::HAWSER_ISA {

#if defined(__AVX512F__)
/// Lanes in [begin, end), which may lie outside 0 … 7.
HAWSER_INLINE __mmask8 lane_mask(int begin, int end) {
    const __m512i index = _mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0);
    return _mm512_cmplt_epi64_mask(index, _mm512_set1_epi64(end)) &
           _mm512_cmpge_epi64_mask(index, _mm512_set1_epi64(begin));
}
HAWSER_INLINE __mmask8 first_mask(int n) {
    return static_cast<__mmask8>(n >= kLanes ? 0xff : (1 << n) - 1);
}
#endif
/// 1 in the lanes whose bits are set, 0 in the others.
HAWSER_INLINE V8 bit_lanes(std::uint8_t bits) {
#if defined(__AVX512F__)
    return _mm512_maskz_mov_pd(bits, _mm512_set1_pd(1.0));
#else
    double v[kLanes];
    for (int i = 0; i < kLanes; ++i) v[i] = (bits >> i) & 1;
    return load(v);
#endif
}
/// p[0..n), n > 0; zero in other lanes.
HAWSER_INLINE V8 load_first(const double* p, int n) {
#if defined(__AVX512F__)
    return _mm512_maskz_loadu_pd(first_mask(n), p);
#else
    double v[kLanes] = {};
    for (int i = 0; i < kLanes && i < n; ++i) v[i] = p[i];
    return load(v);
#endif
}
/// Does load_at_least() read what it is asked for, and nothing behind it?
#if defined(__AVX512F__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kExactLoads = true;
#else
inline constexpr bool kExactLoads = false;
#endif
/// p[0..n), n > 0; other lanes hold anything. Without masks a whole vector is read: another thread
/// may be writing what lies behind p + n, which is not used; the thread sanitizer cannot know.
HAWSER_INLINE V8 load_at_least(const double* p, int n) {
    return kExactLoads ? load_first(p, n) : load(p);
}
/// p[i] = lane i for begin ≤ i < end.
HAWSER_INLINE void store_lanes(double* p, const V8& v, int begin, int end) {
#if defined(__AVX512F__)
    _mm512_mask_storeu_pd(p, lane_mask(begin, end), v);
#else
    if (begin <= 0 && end >= kLanes) return store(p, v);
    double lanes[kLanes];
    store(lanes, v);
    for (int i = begin > 0 ? begin : 0; i < kLanes && i < end; ++i) p[i] = lanes[i];
#endif
}
/// Lane i = x[index[i]] for begin ≤ i < end, 0 elsewhere.
HAWSER_INLINE V8 gather_range(const double* x, const std::int32_t* index, int begin, int end) {
    // Eight loads take half the time of the gather instruction on some processors.
    if (begin <= 0 && end >= kLanes)
        return V8{x[index[0]], x[index[1]], x[index[2]], x[index[3]],
                  x[index[4]], x[index[5]], x[index[6]], x[index[7]]};
#if defined(__AVX512F__)
    const __mmask8 used = lane_mask(begin, end);
    const __m256i i = _mm256_maskz_loadu_epi32(used, index);
    return _mm512_mask_i32gather_pd(_mm512_setzero_pd(), used, i, x, 8);
#else
    double v[kLanes] = {};
    for (int i = begin > 0 ? begin : 0; i < kLanes && i < end; ++i) v[i] = x[index[i]];
    return load(v);
#endif
}
/// to[0..n) += from[0..n), n > 0, at most eight of them.
HAWSER_INLINE void add_first(double* to, const double* from, int n) {
#if defined(__AVX512F__)
    const __mmask8 keep = first_mask(n);
    const __m512d sum =
        _mm512_add_pd(_mm512_maskz_loadu_pd(keep, to), _mm512_maskz_loadu_pd(keep, from));
    _mm512_mask_storeu_pd(to, keep, sum);
#else
    int i = 0;
    if (n > kLanes) n = kLanes;
    for (; i + kPartLanes <= n; i += kPartLanes)
        *reinterpret_cast<Part*>(to + i) += *reinterpret_cast<const Part*>(from + i);
    for (; i < n; ++i) to[i] += from[i];
#endif
}

/// out[0..N) += the first N lanes of v; N = 1, 3 or 6. Nothing else is touched.
template <int N>
HAWSER_INLINE void add_lanes(double* out, const V8& v) {
    typedef double V2 __attribute__((vector_size(16), aligned(8), may_alias));
    typedef double V4 __attribute__((vector_size(32), aligned(8), may_alias));
    double lanes[8];
    store(lanes, v);
    if constexpr (N == 6) {
        *reinterpret_cast<V4*>(out) += *reinterpret_cast<const V4*>(lanes);
        *reinterpret_cast<V2*>(out + 4) += *reinterpret_cast<const V2*>(lanes + 4);
    } else {
        for (int i = 0; i < N; ++i) out[i] += lanes[i];
    }
}

}  // namespace hawser::HAWSER_ISA
