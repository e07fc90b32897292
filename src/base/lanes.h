// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lanes.h
/// Some lanes of a vector: loads, stores and sums that touch no memory but theirs.

#include "base/simd.h"

#include <cstdint>

namespace hawser::HAWSER_ISA {

#if defined(__AVX512F__)
/// Return the mask of the lanes in [begin, end), limited to 0 … 7.
HAWSER_INLINE __mmask8 lane_mask(int begin, int end) {
    const __m512i index = _mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0);
    return _mm512_cmplt_epi64_mask(index, _mm512_set1_epi64(end)) &
           _mm512_cmpge_epi64_mask(index, _mm512_set1_epi64(begin));
}
HAWSER_INLINE __mmask8 first_mask(int n) {
    return static_cast<__mmask8>(n >= kLanes ? 0xff : (1 << n) - 1);
}
#elif defined(__AVX2__)
/// Return part k of the mask of the first n lanes; n may exceed eight.
HAWSER_INLINE __m256i first_mask(int n, int k) {
    return _mm256_cmpgt_epi64(_mm256_set1_epi64x(n - kPartLanes * k),
                              _mm256_set_epi64x(3, 2, 1, 0));
}
#endif
/// Return 1 in the lanes whose bits are set, 0 in the others.
HAWSER_INLINE V8 bit_lanes(std::uint8_t bits) {
#if defined(__AVX512F__)
    return _mm512_maskz_mov_pd(bits, _mm512_set1_pd(1.0));
#elif defined(__AVX2__)
    const PartMask all = PartMask{} + bits, low = {1, 2, 4, 8}, high = {16, 32, 64, 128};
    const Part one = Part{} + 1.0;
    return {{(all & low) != 0 ? one : Part{}, (all & high) != 0 ? one : Part{}}};
#else
    double v[kLanes];
    for (int i = 0; i < kLanes; ++i) v[i] = (bits >> i) & 1;
    return load(v);
#endif
}
/// Load p[0..n), n > 0; other lanes are zero.
HAWSER_INLINE V8 load_first(const double* p, int n) {
#if defined(__AVX512F__)
    return _mm512_maskz_loadu_pd(first_mask(n), p);
#elif defined(__AVX2__)
    V8 v;
    for (int k = 0; k < kParts; ++k)
        v.part[k] = _mm256_maskload_pd(p + kPartLanes * k, first_mask(n, k));
    return v;
#else
    double v[kLanes] = {};
    for (int i = 0; i < kLanes && i < n; ++i) v[i] = p[i];
    return load(v);
#endif
}
/// True if load_at_least() reads only the requested entries.
#if defined(__AVX512F__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kExactLoads = true;
#else
inline constexpr bool kExactLoads = false;
#endif
/// Load p[0..n), n > 0; the other lanes are undefined. On processors without masks a whole vector
/// is read. Another thread may be writing behind p + n; the result is not used, but the thread
/// sanitizer cannot detect this.
HAWSER_INLINE V8 load_at_least(const double* p, int n) {
    return kExactLoads ? load_first(p, n) : load(p);
}
/// Store lane i in p[i] for begin ≤ i < end.
HAWSER_INLINE void store_lanes(double* p, const V8& v, int begin, int end) {
#if defined(__AVX512F__)
    _mm512_mask_storeu_pd(p, lane_mask(begin, end), v);
#else
    // No masked stores on AVX2: on some processors one takes dozens of cycles.
    if (begin <= 0 && end >= kLanes) return store(p, v);
    double lanes[kLanes];
    store(lanes, v);
    for (int i = begin > 0 ? begin : 0; i < kLanes && i < end; ++i) p[i] = lanes[i];
#endif
}
/// Store the first N lanes at p[0..N), N constant.
template <int N>
HAWSER_INLINE void store_first(double* p, const V8& v) {
    static_assert(N >= 1 && N <= kLanes);
#if defined(__AVX512F__)
    _mm512_mask_storeu_pd(p, first_mask(N), v);
#else
    typedef double V2 __attribute__((vector_size(16), aligned(8), may_alias));
    constexpr int kWhole = N / kPartLanes, kFrom = kWhole * kPartLanes, kRest = N - kFrom;
    for (int k = 0; k < kWhole; ++k) store_part(p + kPartLanes * k, v.part[k]);
    if constexpr (kRest >= 2) {
        const Part& last = v.part[kWhole];
        *reinterpret_cast<V2*>(p + kFrom) = V2{last[0], last[1]};
    }
    if constexpr (kRest % 2 == 1) p[N - 1] = lane(v, N - 1);
#endif
}
/// Set lane i to x[index[i]] for begin ≤ i < end, to 0 elsewhere.
HAWSER_INLINE V8 gather_range(const double* x, const std::int32_t* index, int begin, int end) {
    // Eight loads take half the time of the gather instruction on some processors.
    if (begin <= 0 && end >= kLanes)
        return V8{x[index[0]], x[index[1]], x[index[2]], x[index[3]],
                  x[index[4]], x[index[5]], x[index[6]], x[index[7]]};
#if defined(__AVX512F__)
    const __mmask8 used = lane_mask(begin, end);
    const __m256i i = _mm256_maskz_loadu_epi32(used, index);
    return _mm512_mask_i32gather_pd(_mm512_setzero_pd(), used, i, x, 8);
#elif defined(__AVX2__)
    // Not through memory: a vector load of entries stored separately has to wait.
    auto one = [&](int i) { return i >= begin && i < end ? x[index[i]] : 0.0; };
    V8 v{};
    for (int i = 0; i < kLanes; i += kPartLanes)
        if (begin <= i && end >= i + kPartLanes)
            v.part[i / kPartLanes] =
                Part{x[index[i]], x[index[i + 1]], x[index[i + 2]], x[index[i + 3]]};
        else if (begin < i + kPartLanes && end > i)
            v.part[i / kPartLanes] = Part{one(i), one(i + 1), one(i + 2), one(i + 3)};
    return v;
#else
    double v[kLanes] = {};
    for (int i = begin > 0 ? begin : 0; i < kLanes && i < end; ++i) v[i] = x[index[i]];
    return load(v);
#endif
}
HAWSER_INLINE void add_pair(double* to, const double* from) {
    typedef double V2 __attribute__((vector_size(16), aligned(8), may_alias));
    *reinterpret_cast<V2*>(to) += *reinterpret_cast<const V2*>(from);
}
/// Add from[0..n) to to[0..n), 0 < n ≤ 8.
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
    if (kPartLanes > 2 && (n & 2) != 0) {
        add_pair(to + i, from + i);
        i += 2;
    }
    if ((n & 1) != 0) to[i] += from[i];
#endif
}
/// Add N entries. N is known to the compiler, so no branch depends on it at run time.
template <int N>
HAWSER_INLINE void add_first(double* to, const double* from) {
    static_assert(N >= 1 && N <= kLanes);
#if defined(__AVX512F__)
    add_first(to, from, N);
#else
    constexpr int kWhole = N / kPartLanes * kPartLanes, kRest = N - kWhole;
    for (int i = 0; i < kWhole; i += kPartLanes)
        *reinterpret_cast<Part*>(to + i) += *reinterpret_cast<const Part*>(from + i);
    if constexpr (kRest >= 2) add_pair(to + kWhole, from + kWhole);
    if constexpr (kRest % 2 == 1) to[N - 1] += from[N - 1];
#endif
}

/// Add the first N lanes of v to out[0..N); N = 1, 3 or 6. No other entry is read or written.
template <int N>
HAWSER_INLINE void add_lanes(double* out, const V8& v) {
    double lanes[8];
    store(lanes, v);
    if constexpr (N == 6) {
        typedef double V4 __attribute__((vector_size(32), aligned(8), may_alias));
        *reinterpret_cast<V4*>(out) += *reinterpret_cast<const V4*>(lanes);
        add_pair(out + 4, lanes + 4);
    } else {
        for (int i = 0; i < N; ++i) out[i] += lanes[i];
    }
}

}  // namespace hawser::HAWSER_ISA
