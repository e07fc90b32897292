// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file simd_float.h
/// Vectors of eight floats: one register on AVX2 and AVX-512, two on SSE2. Names and meanings are
/// those of simd.h, so that a template over the element type finds either by overloading:
/// Lanes<double> is V8, Lanes<float> is F8.

#include "base/simd.h"

namespace hawser::HAWSER_ISA {

#if defined(__AVX2__)

typedef float F8 __attribute__((vector_size(32), aligned(4), may_alias));
typedef int N8 __attribute__((vector_size(32)));

HAWSER_INLINE F8 load(const float* p) { return *reinterpret_cast<const F8*>(p); }
HAWSER_INLINE void store(float* p, const F8& v) { *reinterpret_cast<F8*>(p) = v; }
HAWSER_INLINE float lane(const F8& v, int i) { return v[i]; }
HAWSER_INLINE F8 spread_lane(const F8& v, int i) {
    return __builtin_shuffle(v, N8{i, i, i, i, i, i, i, i});
}
HAWSER_INLINE F8 after_lane(const F8& v, int i) {
    const N8 index = {0, 1, 2, 3, 4, 5, 6, 7};
    const N8 keep = index > i;
    return reinterpret_cast<F8>(reinterpret_cast<N8>(v) & keep);
}
HAWSER_INLINE F8 reciprocal(const F8& v) { return 1.0F / v; }
template <bool kKeep>
HAWSER_INLINE F8 fix_pivot(F8& d, float sign) {
    const N8 finite = d - d == 0.0F, good = (d * sign > 0.0F) & finite;
    d = (kKeep ? (d != 0.0F) & finite : good) ? d : F8{} + sign;
    return good ? F8{} : F8{} + 1.0F;
}

#else

typedef float FloatPart __attribute__((vector_size(16), aligned(4), may_alias));
typedef int FloatMask __attribute__((vector_size(16)));
inline constexpr int kFloatPartLanes = 4, kFloatParts = kLanes / kFloatPartLanes;

struct F8 {
    FloatPart part[kFloatParts];
};

HAWSER_INLINE F8 load(const float* p) {
    F8 v;
    for (int i = 0; i < kFloatParts; ++i)
        v.part[i] = *reinterpret_cast<const FloatPart*>(p + kFloatPartLanes * i);
    return v;
}
HAWSER_INLINE void store(float* p, const F8& v) {
    for (int i = 0; i < kFloatParts; ++i)
        *reinterpret_cast<FloatPart*>(p + kFloatPartLanes * i) = v.part[i];
}
HAWSER_INLINE float lane(const F8& v, int i) {
    return v.part[i / kFloatPartLanes][i % kFloatPartLanes];
}
HAWSER_INLINE F8 spread_lane(const F8& v, int i) {
    float lanes[kLanes];
    store(lanes, v);
    F8 o;
    for (FloatPart& part : o.part) part = FloatPart{} + lanes[i];
    return o;
}
HAWSER_INLINE F8 after_lane(const F8& v, int i) {
    F8 o;
    for (int k = 0; k < kFloatParts; ++k) {
        FloatMask index;
        for (int n = 0; n < kFloatPartLanes; ++n) index[n] = kFloatPartLanes * k + n;
        const FloatMask keep = index > i;
        o.part[k] = reinterpret_cast<FloatPart>(reinterpret_cast<FloatMask>(v.part[k]) & keep);
    }
    return o;
}
#define HAWSER_LANEWISE(op)                                                       \
    HAWSER_INLINE F8 operator op(const F8& a, const F8& b) {                      \
        F8 o;                                                                     \
        for (int i = 0; i < kFloatParts; ++i) o.part[i] = a.part[i] op b.part[i]; \
        return o;                                                                 \
    }
HAWSER_LANEWISE(+)
HAWSER_LANEWISE(-)
HAWSER_LANEWISE(*)
#undef HAWSER_LANEWISE
HAWSER_INLINE F8 operator*(const F8& a, float s) {
    F8 o;
    for (int i = 0; i < kFloatParts; ++i) o.part[i] = a.part[i] * s;
    return o;
}
HAWSER_INLINE F8 operator*(float s, const F8& a) { return a * s; }
HAWSER_INLINE F8& operator+=(F8& a, const F8& b) { return a = a + b; }
HAWSER_INLINE F8& operator-=(F8& a, const F8& b) { return a = a - b; }
HAWSER_INLINE F8 reciprocal(const F8& v) {
    F8 o;
    for (int i = 0; i < kFloatParts; ++i) o.part[i] = 1.0F / v.part[i];
    return o;
}
template <bool kKeep>
HAWSER_INLINE F8 fix_pivot(F8& d, float sign) {
    F8 bad;
    for (int i = 0; i < kFloatParts; ++i) {
        // NOLINTNEXTLINE(misc-redundant-expression): not of what is infinite or no number
        const FloatMask finite = d.part[i] - d.part[i] == 0.0F;
        const FloatMask good = (d.part[i] * sign > 0.0F) & finite;
        const FloatMask keep = kKeep ? (d.part[i] != 0.0F) & finite : good;
        d.part[i] = keep ? d.part[i] : FloatPart{} + sign;
        bad.part[i] = good ? FloatPart{} : FloatPart{} + 1.0F;
    }
    return bad;
}

#endif

template <class Real>
struct LanesOf;
template <>
struct LanesOf<double> {
    typedef V8 Type;
};
template <>
struct LanesOf<float> {
    typedef F8 Type;
};
template <class Real>
using Lanes = typename LanesOf<Real>::Type;

HAWSER_INLINE float sum(const F8& v) {
    return ((lane(v, 0) + lane(v, 4)) + (lane(v, 2) + lane(v, 6))) +
           ((lane(v, 1) + lane(v, 5)) + (lane(v, 3) + lane(v, 7)));
}
/// As sums() of simd.h.
template <int N>
HAWSER_INLINE F8 sums(const F8* v) {
#if defined(__AVX2__)
    const N8 even = {0, 8, 2, 10, 4, 12, 6, 14}, odd = {1, 9, 3, 11, 5, 13, 7, 15};
    const N8 low2 = {0, 1, 8, 9, 4, 5, 12, 13}, high2 = {2, 3, 10, 11, 6, 7, 14, 15};
    const N8 low4 = {0, 1, 2, 3, 8, 9, 10, 11}, high4 = {4, 5, 6, 7, 12, 13, 14, 15};
    F8 pair[4] = {}, quad[2] = {};
    for (int i = 0; i < N; i += 2) {
        const F8 a = v[i], b = i + 1 < N ? v[i + 1] : F8{};
        pair[i / 2] = __builtin_shuffle(a, b, even) + __builtin_shuffle(a, b, odd);
    }
    for (int i = 0; i < 2; ++i)
        quad[i] = __builtin_shuffle(pair[2 * i], pair[2 * i + 1], low2) +
                  __builtin_shuffle(pair[2 * i], pair[2 * i + 1], high2);
    return __builtin_shuffle(quad[0], quad[1], low4) + __builtin_shuffle(quad[0], quad[1], high4);
#else
    float out[kLanes] = {};
    for (int i = 0; i < N; ++i) out[i] = sum(v[i]);
    return load(out);
#endif
}

HAWSER_INLINE F8 gather_lanes(const float* x, const std::int32_t* index) {
#if defined(__AVX512F__)
    const __m256i i = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    const __mmask8 used = _mm256_cmp_epi32_mask(i, _mm256_setzero_si256(), _MM_CMPINT_NLT);
    return _mm256_mmask_i32gather_ps(_mm256_setzero_ps(), used, i, x, 4);
#else
    float v[kLanes];
    for (int i = 0; i < kLanes; ++i) v[i] = index[i] >= 0 ? x[index[i]] : 0.0F;
    return load(v);
#endif
}
HAWSER_INLINE void scatter_lanes(float* x, const std::int32_t* index, const F8& v) {
    for (int i = 0; i < kLanes; ++i)
        if (index[i] >= 0) x[index[i]] = lane(v, i);
}
HAWSER_INLINE F8 load_first(const float* p, int n) {
#if defined(__AVX512F__)
    return _mm256_maskz_loadu_ps(first_mask(n), p);
#else
    float v[kLanes] = {};
    for (int i = 0; i < kLanes && i < n; ++i) v[i] = p[i];
    return load(v);
#endif
}
HAWSER_INLINE void store_lanes(float* p, const F8& v, int begin, int end) {
#if defined(__AVX512F__)
    _mm256_mask_storeu_ps(p, lane_mask(begin, end), v);
#else
    if (begin <= 0 && end >= kLanes) return store(p, v);
    float lanes[kLanes];
    store(lanes, v);
    for (int i = begin > 0 ? begin : 0; i < kLanes && i < end; ++i) p[i] = lanes[i];
#endif
}
HAWSER_INLINE F8 gather_range(const float* x, const std::int32_t* index, int begin, int end) {
    float v[kLanes] = {};
    if (begin <= 0 && end >= kLanes)
        for (int i = 0; i < kLanes; ++i) v[i] = x[index[i]];
    else
        for (int i = begin > 0 ? begin : 0; i < kLanes && i < end; ++i) v[i] = x[index[i]];
    return load(v);
}
HAWSER_INLINE void add_first(float* to, const float* from, int n) {
#if defined(__AVX512F__)
    const __mmask8 keep = first_mask(n);
    const __m256 sum =
        _mm256_add_ps(_mm256_maskz_loadu_ps(keep, to), _mm256_maskz_loadu_ps(keep, from));
    _mm256_mask_storeu_ps(to, keep, sum);
#else
    typedef float Four __attribute__((vector_size(16), aligned(4), may_alias));
    int i = 0;
    if (n >= kLanes) return store(to, load(to) + load(from));
    for (; i + 4 <= n; i += 4)
        *reinterpret_cast<Four*>(to + i) += *reinterpret_cast<const Four*>(from + i);
    for (; i < n; ++i) to[i] += from[i];
#endif
}

/// Lane j of v[i] becomes lane i of v[j].
HAWSER_INLINE void transpose(F8 (&v)[kLanes]) {
#if defined(__AVX2__)
    const N8 even = {0, 8, 2, 10, 4, 12, 6, 14}, odd = {1, 9, 3, 11, 5, 13, 7, 15};
    const N8 low2 = {0, 1, 8, 9, 4, 5, 12, 13}, high2 = {2, 3, 10, 11, 6, 7, 14, 15};
    const N8 low4 = {0, 1, 2, 3, 8, 9, 10, 11}, high4 = {4, 5, 6, 7, 12, 13, 14, 15};
    F8 a[kLanes], b[kLanes];
    for (int i = 0; i < kLanes; i += 2) {
        a[i] = __builtin_shuffle(v[i], v[i + 1], even);
        a[i + 1] = __builtin_shuffle(v[i], v[i + 1], odd);
    }
    for (int i = 0; i < kLanes; i += 4)
        for (int k = 0; k < 2; ++k) {
            b[i + k] = __builtin_shuffle(a[i + k], a[i + k + 2], low2);
            b[i + k + 2] = __builtin_shuffle(a[i + k], a[i + k + 2], high2);
        }
    for (int k = 0; k < 4; ++k) {
        v[k] = __builtin_shuffle(b[k], b[k + 4], low4);
        v[k + 4] = __builtin_shuffle(b[k], b[k + 4], high4);
    }
#else
    float rows[kLanes][kLanes];
    for (int i = 0; i < kLanes; ++i) store(rows[i], v[i]);
    for (int j = 0; j < kLanes; ++j) {
        float column[kLanes];
        for (int i = 0; i < kLanes; ++i) column[i] = rows[i][j];
        v[j] = load(column);
    }
#endif
}

}  // namespace hawser::HAWSER_ISA
