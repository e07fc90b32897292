// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file simd.h
/// Vectors of eight doubles: one register on AVX-512, two on AVX2, four on SSE2. For code
/// compiled per instruction set (see small.h).

#include "base/small.h"

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

#include <cstdint>

namespace hawser::HAWSER_ISA {

inline constexpr int kLanes = 8;  ///< Arrays read by load() need this many entries of slack.

#define HAWSER_INLINE __attribute__((always_inline)) inline

#if defined(__AVX512F__)

typedef double V8 __attribute__((vector_size(64), aligned(8), may_alias));
typedef long long I8 __attribute__((vector_size(64)));
typedef double W8 __attribute__((vector_size(64)));  ///< V8 as an argument of templates.
typedef V8 Part;                                     ///< One register of a V8.
inline constexpr int kPartLanes = kLanes, kParts = 1;

HAWSER_INLINE Part part_of(const V8& v, int) { return v; }
HAWSER_INLINE void set_part(V8& v, int, const Part& p) { v = p; }
HAWSER_INLINE V8 load(const double* p) { return *reinterpret_cast<const V8*>(p); }
HAWSER_INLINE void store(double* p, const V8& v) { *reinterpret_cast<V8*>(p) = v; }
HAWSER_INLINE double lane(const V8& v, int i) { return v[i]; }
/// Return v with the lanes from `count` on set to zero, whatever they contain.
HAWSER_INLINE V8 first_lanes(const V8& v, int count) {
    const I8 index = {0, 1, 2, 3, 4, 5, 6, 7};
    const I8 keep = index < static_cast<long long>(count);
    return reinterpret_cast<V8>(reinterpret_cast<I8>(v) & keep);
}

/// Set every lane to lane i of v.
HAWSER_INLINE V8 spread_lane(const V8& v, int i) {
    const long long k = i;
    return __builtin_shuffle(v, I8{k, k, k, k, k, k, k, k});
}
/// Return v with the lanes up to and including i set to zero.
HAWSER_INLINE V8 after_lane(const V8& v, int i) {
    const I8 index = {0, 1, 2, 3, 4, 5, 6, 7};
    const I8 keep = index > static_cast<long long>(i);
    return reinterpret_cast<V8>(reinterpret_cast<I8>(v) & keep);
}
HAWSER_INLINE V8 reciprocal(const V8& v) { return 1.0 / v; }
HAWSER_INLINE V8 positive_part(const V8& v) { return v > 0.0 ? v : V8{}; }
/// Return a > b ? x : y, lane by lane.
HAWSER_INLINE V8 select_greater(const V8& a, const V8& b, const V8& x, const V8& y) {
    return a > b ? x : y;
}
// Return √v lane by lane. This avoids _mm512_sqrt_pd, inside which g++ 12 warns falsely.
HAWSER_INLINE V8 root(const V8& v) { return _mm512_maskz_sqrt_pd(0xff, v); }
/// Replace pivots that have the wrong sign or are not finite by `sign`. With kKeep, finite pivots
/// other than zero are left unchanged.
/// @return 1 in lanes with the wrong sign or a value that is not finite.
template <bool kKeep>
HAWSER_INLINE V8 fix_pivot(V8& d, double sign) {
    const I8 finite = d - d == 0.0, good = (d * sign > 0.0) & finite;
    d = (kKeep ? (d != 0.0) & finite : good) ? d : V8{} + sign;
    return good ? V8{} : V8{} + 1.0;
}
/// Gather x[index] lane by lane; 0 if the index is negative.
HAWSER_INLINE V8 gather_lanes(const double* x, const std::int32_t* index) {
    const __m256i i = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    const __mmask8 used = _mm256_cmp_epi32_mask(i, _mm256_setzero_si256(), _MM_CMPINT_NLT);
    return _mm512_mask_i32gather_pd(_mm512_setzero_pd(), used, i, x, 8);
}
/// Store x[index] = v, lane by lane, except lanes with a negative index.
HAWSER_INLINE void scatter_lanes(double* x, const std::int32_t* index, const V8& v) {
    const __m256i i = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    const __mmask8 used = _mm256_cmp_epi32_mask(i, _mm256_setzero_si256(), _MM_CMPINT_NLT);
    _mm512_mask_i32scatter_pd(x, used, i, v, 8);
}

#else

// The compiler lowers 64-byte vectors on narrower machines through memory; a struct of
// registers does not suffer that.
#if defined(__AVX2__)
typedef double Part __attribute__((vector_size(32), aligned(8), may_alias));
typedef long long PartMask __attribute__((vector_size(32)));
#else
typedef double Part __attribute__((vector_size(16), aligned(8), may_alias));
typedef long long PartMask __attribute__((vector_size(16)));
#endif
inline constexpr int kPartLanes = sizeof(Part) / sizeof(double), kParts = kLanes / kPartLanes;

struct V8 {
    Part part[kParts];
};
using W8 = V8;

HAWSER_INLINE Part part_of(const V8& v, int k) { return v.part[k]; }
HAWSER_INLINE void set_part(V8& v, int k, const Part& p) { v.part[k] = p; }
HAWSER_INLINE V8 load(const double* p) {
    V8 v;
    for (int i = 0; i < kParts; ++i) v.part[i] = *reinterpret_cast<const Part*>(p + kPartLanes * i);
    return v;
}
HAWSER_INLINE void store(double* p, const V8& v) {
    for (int i = 0; i < kParts; ++i) *reinterpret_cast<Part*>(p + kPartLanes * i) = v.part[i];
}
HAWSER_INLINE double lane(const V8& v, int i) { return v.part[i / kPartLanes][i % kPartLanes]; }
HAWSER_INLINE V8 first_lanes(const V8& v, int count) {
    V8 o;
    for (int i = 0; i < kParts; ++i) {
        PartMask index;
        for (int k = 0; k < kPartLanes; ++k) index[k] = kPartLanes * i + k;
        const PartMask keep = index < static_cast<long long>(count);
        o.part[i] = reinterpret_cast<Part>(reinterpret_cast<PartMask>(v.part[i]) & keep);
    }
    return o;
}
HAWSER_INLINE V8 spread_lane(const V8& v, int i) {
    V8 o;
#if defined(__AVX2__)
    const long long n = i % kPartLanes;
    o.part[0] = o.part[1] = __builtin_shuffle(v.part[i / kPartLanes], PartMask{n, n, n, n});
#else
    double lanes[kLanes];
    store(lanes, v);
    for (int k = 0; k < kParts; ++k) o.part[k] = Part{} + lanes[i];
#endif
    return o;
}
HAWSER_INLINE V8 after_lane(const V8& v, int i) {
    V8 o;
    for (int k = 0; k < kParts; ++k) {
        PartMask index;
        for (int n = 0; n < kPartLanes; ++n) index[n] = kPartLanes * k + n;
        const PartMask keep = index > static_cast<long long>(i);
        o.part[k] = reinterpret_cast<Part>(reinterpret_cast<PartMask>(v.part[k]) & keep);
    }
    return o;
}
#define HAWSER_LANEWISE(op)                                                  \
    HAWSER_INLINE V8 operator op(const V8& a, const V8& b) {                 \
        V8 o;                                                                \
        for (int i = 0; i < kParts; ++i) o.part[i] = a.part[i] op b.part[i]; \
        return o;                                                            \
    }
HAWSER_LANEWISE(+)
HAWSER_LANEWISE(-)
HAWSER_LANEWISE(*)
#undef HAWSER_LANEWISE
HAWSER_INLINE V8 operator*(const V8& a, double s) {
    V8 o;
    for (int i = 0; i < kParts; ++i) o.part[i] = a.part[i] * s;
    return o;
}
HAWSER_INLINE V8 operator*(double s, const V8& a) { return a * s; }
HAWSER_INLINE V8 operator+(const V8& a, double s) {
    V8 o;
    for (int i = 0; i < kParts; ++i) o.part[i] = a.part[i] + s;
    return o;
}
HAWSER_INLINE V8 positive_part(const V8& v) {
    V8 o;
    for (int i = 0; i < kParts; ++i) o.part[i] = v.part[i] > 0.0 ? v.part[i] : Part{};
    return o;
}
HAWSER_INLINE V8 operator-(const V8& a) {
    V8 o;
    for (int i = 0; i < kParts; ++i) o.part[i] = -a.part[i];
    return o;
}
/// Return a > b ? x : y, lane by lane.
HAWSER_INLINE V8 select_greater(const V8& a, const V8& b, const V8& x, const V8& y) {
    V8 o;
    for (int i = 0; i < kParts; ++i) o.part[i] = a.part[i] > b.part[i] ? x.part[i] : y.part[i];
    return o;
}
HAWSER_INLINE V8 root(const V8& v) {
    V8 o;
    for (int i = 0; i < kParts; ++i)
#if defined(__AVX2__)
        o.part[i] = __builtin_ia32_sqrtpd256(v.part[i]);
#else
        o.part[i] = __builtin_ia32_sqrtpd(v.part[i]);
#endif
    return o;
}
HAWSER_INLINE V8& operator+=(V8& a, const V8& b) { return a = a + b; }
HAWSER_INLINE V8& operator-=(V8& a, const V8& b) { return a = a - b; }
HAWSER_INLINE V8 operator/(double s, const V8& v) {
    V8 o;
    for (int i = 0; i < kParts; ++i) o.part[i] = s / v.part[i];
    return o;
}
HAWSER_INLINE V8 reciprocal(const V8& v) { return 1.0 / v; }
HAWSER_INLINE Part reciprocal(const Part& v) { return 1.0 / v; }
template <bool kKeep>
HAWSER_INLINE Part fix_pivot(Part& d, double sign) {
    // NOLINTNEXTLINE(misc-redundant-expression): false for infinities and NaN
    const PartMask finite = d - d == 0.0;
    const PartMask good = (d * sign > 0.0) & finite;
    const PartMask keep = kKeep ? (d != 0.0) & finite : good;
    d = keep ? d : Part{} + sign;
    return good ? Part{} : Part{} + 1.0;
}
template <bool kKeep>
HAWSER_INLINE V8 fix_pivot(V8& d, double sign) {
    V8 bad;
    for (int i = 0; i < kParts; ++i) bad.part[i] = fix_pivot<kKeep>(d.part[i], sign);
    return bad;
}
HAWSER_INLINE V8 gather_lanes(const double* x, const std::int32_t* index) {
    auto one = [&](int i) { return index[i] >= 0 ? x[index[i]] : 0.0; };
    V8 v;
    for (int k = 0; k < kParts; ++k)
#if defined(__AVX2__)
        v.part[k] = Part{one(4 * k), one(4 * k + 1), one(4 * k + 2), one(4 * k + 3)};
#else
        v.part[k] = Part{one(2 * k), one(2 * k + 1)};
#endif
    return v;
}
HAWSER_INLINE void scatter_lanes(double* x, const std::int32_t* index, const V8& v) {
    for (int i = 0; i < kLanes; ++i)
        if (index[i] >= 0) x[index[i]] = lane(v, i);
}

#endif

HAWSER_INLINE Part load_part(const double* p) { return *reinterpret_cast<const Part*>(p); }
HAWSER_INLINE void store_part(double* p, const Part& v) { *reinterpret_cast<Part*>(p) = v; }

/// True if any lane is not zero (NaN included).
HAWSER_INLINE bool any(const V8& v) {
#if defined(__AVX512F__)
    return _mm512_test_epi64_mask(_mm512_castpd_si512(v), _mm512_set1_epi64(0x7fffffffffffffff)) !=
           0;
#else
    PartMask found = v.part[0] != 0.0;
    for (int k = 1; k < kParts; ++k) found |= v.part[k] != 0.0;
#if defined(__AVX2__)
    return __builtin_ia32_movmskpd256(reinterpret_cast<Part>(found)) != 0;
#else
    return __builtin_ia32_movmskpd(reinterpret_cast<Part>(found)) != 0;
#endif
#endif
}
// Return √v. This and the next functions are scalar versions, for templates over vectors and
// numbers.
HAWSER_INLINE double root(double v) { return __builtin_sqrt(v); }
HAWSER_INLINE double select_greater(double a, double b, double x, double y) {
    return a > b ? x : y;
}
HAWSER_INLINE bool any(double v) { return v != 0.0; }
HAWSER_INLINE double positive_part(double v) { return v > 0.0 ? v : 0.0; }
HAWSER_INLINE double zero(double) { return 0.0; }
HAWSER_INLINE double one(double) { return 1.0; }
HAWSER_INLINE V8 zero(const V8&) { return V8{}; }
HAWSER_INLINE V8 one(const V8&) { return V8{} + 1.0; }
/// Return a constant of the type of the first argument.
template <class T>
HAWSER_INLINE T constant(const T& like, double value) {
    return zero(like) + value;
}
template <class T>
HAWSER_INLINE V3T<T> select_greater(const T& a, const T& b, const V3T<T>& x, const V3T<T>& y) {
    return {select_greater(a, b, x.x, y.x), select_greater(a, b, x.y, y.y),
            select_greater(a, b, x.z, y.z)};
}
HAWSER_INLINE W8 norm(const V3T<W8>& a) { return root(dot(a, a)); }
/// Return the sum of the lanes, added in a fixed order.
HAWSER_INLINE double sum(const V8& v) {
    return ((lane(v, 0) + lane(v, 4)) + (lane(v, 2) + lane(v, 6))) +
           ((lane(v, 1) + lane(v, 5)) + (lane(v, 3) + lane(v, 7)));
}
/// Return the largest of the lanes.
HAWSER_INLINE double largest(const V8& v) {
#if defined(__AVX512F__)
    const I8 others[] = {
        {4, 5, 6, 7, 0, 1, 2, 3}, {2, 3, 0, 1, 6, 7, 4, 5}, {1, 0, 3, 2, 5, 4, 7, 6}};
    V8 most = v;
    for (const I8& other : others) {
        const V8 turned = __builtin_shuffle(most, other);
        most = most > turned ? most : turned;
    }
    return lane(most, 0);
#else
    double most = lane(v, 0);
    for (int i = 1; i < kLanes; ++i)
        if (lane(v, i) > most) most = lane(v, i);
    return most;
#endif
}
/// Return a vector whose lane k is the sum of the lanes of v[k], for k < N; other lanes are 0.
template <int N>
HAWSER_INLINE V8 sums(const V8* v) {
#if defined(__AVX512F__)
    const I8 even = {0, 8, 2, 10, 4, 12, 6, 14}, odd = {1, 9, 3, 11, 5, 13, 7, 15};
    const I8 low2 = {0, 1, 8, 9, 4, 5, 12, 13}, high2 = {2, 3, 10, 11, 6, 7, 14, 15};
    const I8 low4 = {0, 1, 2, 3, 8, 9, 10, 11}, high4 = {4, 5, 6, 7, 12, 13, 14, 15};
    V8 pair[4] = {}, quad[2] = {};
    for (int i = 0; i < N; i += 2) {
        const V8 a = v[i], b = i + 1 < N ? v[i + 1] : V8{};
        pair[i / 2] = __builtin_shuffle(a, b, even) + __builtin_shuffle(a, b, odd);
    }
    for (int i = 0; i < 2; ++i)
        quad[i] = __builtin_shuffle(pair[2 * i], pair[2 * i + 1], low2) +
                  __builtin_shuffle(pair[2 * i], pair[2 * i + 1], high2);
    return __builtin_shuffle(quad[0], quad[1], low4) + __builtin_shuffle(quad[0], quad[1], high4);
#else
    // The halves of each vector first, then lanes two apart, then neighbours: the order of sum().
    V8 out{};
#if defined(__AVX2__)
    const PartMask first2 = {0, 1, 4, 5}, last2 = {2, 3, 6, 7};
    const PartMask even = {0, 4, 2, 6}, odd = {1, 5, 3, 7};
    for (int k = 0; k < (N + 3) / 4; ++k) {
        Part half[4];
        for (int i = 0; i < 4; ++i)
            half[i] = 4 * k + i < N ? v[4 * k + i].part[0] + v[4 * k + i].part[1] : Part{};
        Part two[2];
        for (int i = 0; i < 2; ++i)
            two[i] = __builtin_shuffle(half[i], half[i + 2], first2) +
                     __builtin_shuffle(half[i], half[i + 2], last2);
        out.part[k] =
            __builtin_shuffle(two[0], two[1], even) + __builtin_shuffle(two[0], two[1], odd);
    }
#else
    for (int k = 0; k < (N + 1) / 2; ++k) {
        Part two[2] = {};
        for (int i = 0; i < 2 && 2 * k + i < N; ++i) {
            const Part* p = v[2 * k + i].part;
            two[i] = (p[0] + p[2]) + (p[1] + p[3]);
        }
        out.part[k] = __builtin_shufflevector(two[0], two[1], 0, 2) +
                      __builtin_shufflevector(two[0], two[1], 1, 3);
    }
#endif
    return out;
#endif
}

}  // namespace hawser::HAWSER_ISA
