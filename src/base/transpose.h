// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file transpose.h
/// Conversion of records in memory to one record per lane, and back.

#include "base/simd.h"

namespace hawser::HAWSER_ISA {

#if !defined(__AVX512F__)
/// Transpose as many registers as a register has lanes: lane j of p[i] becomes lane i of p[j].
HAWSER_INLINE void transpose(Part (&p)[kPartLanes]) {
#if defined(__AVX2__)
    const PartMask even = {0, 4, 2, 6}, odd = {1, 5, 3, 7};
    const PartMask first2 = {0, 1, 4, 5}, last2 = {2, 3, 6, 7};
    const Part a = __builtin_shuffle(p[0], p[1], even), b = __builtin_shuffle(p[0], p[1], odd),
               c = __builtin_shuffle(p[2], p[3], even), d = __builtin_shuffle(p[2], p[3], odd);
    p[0] = __builtin_shuffle(a, c, first2);
    p[1] = __builtin_shuffle(b, d, first2);
    p[2] = __builtin_shuffle(a, c, last2);
    p[3] = __builtin_shuffle(b, d, last2);
#else
    const Part a = p[0], b = p[1];
    p[0] = __builtin_shufflevector(a, b, 0, 2);
    p[1] = __builtin_shufflevector(a, b, 1, 3);
#endif
}
#endif

/// Transpose eight vectors: lane j of v[i] becomes lane i of v[j].
HAWSER_INLINE void transpose(V8 (&v)[kLanes]) {
#if defined(__AVX512F__)
    const I8 even = {0, 8, 2, 10, 4, 12, 6, 14}, odd = {1, 9, 3, 11, 5, 13, 7, 15};
    const I8 low2 = {0, 1, 8, 9, 4, 5, 12, 13}, high2 = {2, 3, 10, 11, 6, 7, 14, 15};
    const I8 low4 = {0, 1, 2, 3, 8, 9, 10, 11}, high4 = {4, 5, 6, 7, 12, 13, 14, 15};
    V8 a[kLanes], b[kLanes];
    for (int i = 0; i < kLanes; i += 2) {  // pairs of rows
        a[i] = __builtin_shuffle(v[i], v[i + 1], even);
        a[i + 1] = __builtin_shuffle(v[i], v[i + 1], odd);
    }
    for (int i = 0; i < kLanes; i += 4)  // fours
        for (int k = 0; k < 2; ++k) {
            b[i + k] = __builtin_shuffle(a[i + k], a[i + k + 2], low2);
            b[i + k + 2] = __builtin_shuffle(a[i + k], a[i + k + 2], high2);
        }
    for (int k = 0; k < 4; ++k) {
        v[k] = __builtin_shuffle(b[k], b[k + 4], low4);
        v[k + 4] = __builtin_shuffle(b[k], b[k + 4], high4);
    }
#else
    // Square blocks of one register: transpose two opposite ones and exchange them.
    for (int i = 0; i < kParts; ++i)
        for (int j = i; j < kParts; ++j) {
            Part above[kPartLanes], below[kPartLanes];
            for (int k = 0; k < kPartLanes; ++k) {
                above[k] = v[kPartLanes * i + k].part[j];
                below[k] = v[kPartLanes * j + k].part[i];
            }
            transpose(above);
            transpose(below);
            for (int k = 0; k < kPartLanes; ++k) {
                v[kPartLanes * i + k].part[j] = below[k];
                v[kPartLanes * j + k].part[i] = above[k];
            }
        }
#endif
}
/// Return lanes 1 to 7 of v, then `next`.
HAWSER_INLINE V8 shift_in(const V8& v, double next) {
#if defined(__AVX512F__)
    const V8 last = {next, next, next, next, next, next, next, next};
    return __builtin_shuffle(v, last, I8{1, 2, 3, 4, 5, 6, 7, 8});
#else
    V8 o;
    for (int k = 0; k < kParts; ++k) {
        const Part after = k + 1 < kParts ? v.part[k + 1] : Part{} + next;
#if defined(__AVX2__)
        o.part[k] = __builtin_shuffle(v.part[k], after, PartMask{1, 2, 3, 4});
#else
        o.part[k] = __builtin_shufflevector(v.part[k], after, 1, 2);
#endif
    }
    return o;
#endif
}
/// Load three consecutive entries lane by lane: v[k] = p[k], p[3 + k] … p[21 + k].
HAWSER_INLINE void load_threes(const double* p, V8 (&v)[3]) {
#if defined(__AVX512F__)
    const V8 a = load(p), b = load(p + 8), c = load(p + 16);
    v[0] = __builtin_shuffle(__builtin_shuffle(a, b, I8{0, 3, 6, 9, 12, 15, 0, 0}), c,
                             I8{0, 1, 2, 3, 4, 5, 10, 13});
    v[1] = __builtin_shuffle(__builtin_shuffle(a, b, I8{1, 4, 7, 10, 13, 0, 0, 0}), c,
                             I8{0, 1, 2, 3, 4, 8, 11, 14});
    v[2] = __builtin_shuffle(__builtin_shuffle(a, b, I8{2, 5, 8, 11, 14, 0, 0, 0}), c,
                             I8{0, 1, 2, 3, 4, 9, 12, 15});
#else
    for (int k = 0; k < kParts; ++k) {
        const double* from = p + 3 * kPartLanes * k;
        const Part a = load_part(from), b = load_part(from + kPartLanes),
                   c = load_part(from + 2 * kPartLanes);
#if defined(__AVX2__)  // x y z x, y z x y, z x y z
        v[0].part[k] = __builtin_shuffle(__builtin_shuffle(a, b, PartMask{0, 3, 6, 6}), c,
                                         PartMask{0, 1, 2, 5});
        v[1].part[k] = __builtin_shuffle(__builtin_shuffle(a, b, PartMask{1, 4, 7, 7}), c,
                                         PartMask{0, 1, 2, 6});
        v[2].part[k] = __builtin_shuffle(__builtin_shuffle(a, b, PartMask{2, 5, 5, 5}), c,
                                         PartMask{0, 1, 4, 7});
#else                  // x y, z x, y z
        v[0].part[k] = __builtin_shufflevector(a, b, 0, 3);
        v[1].part[k] = __builtin_shufflevector(a, c, 1, 2);
        v[2].part[k] = __builtin_shufflevector(b, c, 0, 3);
#endif
    }
#endif
}
/// Arrange eight triples (x, y, z) consecutively: out[r] has the entries from 8 r on.
HAWSER_INLINE void as_threes(const V8& x, const V8& y, const V8& z, V8 (&out)[3]) {
#if defined(__AVX512F__)
    out[0] = __builtin_shuffle(__builtin_shuffle(x, y, I8{0, 8, 0, 1, 9, 0, 2, 10}), z,
                               I8{0, 1, 8, 3, 4, 9, 6, 7});
    out[1] = __builtin_shuffle(__builtin_shuffle(x, y, I8{0, 3, 11, 0, 4, 12, 0, 5}), z,
                               I8{10, 1, 2, 11, 4, 5, 12, 7});
    out[2] = __builtin_shuffle(__builtin_shuffle(x, y, I8{13, 0, 6, 14, 0, 7, 15, 0}), z,
                               I8{0, 13, 2, 3, 14, 5, 6, 15});
#else
    for (int k = 0; k < kParts; ++k) {
        const Part a = x.part[k], b = y.part[k], c = z.part[k];
        auto put = [&](int i, const Part& p) {
            out[(3 * k + i) / kParts].part[(3 * k + i) % kParts] = p;
        };
#if defined(__AVX2__)
        put(0, __builtin_shuffle(__builtin_shuffle(a, b, PartMask{0, 4, 4, 1}), c,
                                 PartMask{0, 1, 4, 3}));
        put(1, __builtin_shuffle(__builtin_shuffle(a, b, PartMask{5, 5, 2, 6}), c,
                                 PartMask{0, 5, 2, 3}));
        put(2, __builtin_shuffle(__builtin_shuffle(a, b, PartMask{3, 3, 7, 7}), c,
                                 PartMask{6, 1, 2, 7}));
#else
        put(0, __builtin_shufflevector(a, b, 0, 2));
        put(1, __builtin_shufflevector(c, a, 0, 3));
        put(2, __builtin_shufflevector(b, c, 1, 3));
#endif
    }
#endif
}

/// Load N values for each of eight lanes, N = 1, 2 or 3: v[k] = p[k], p[N + k] …; and store them.
template <int N>
HAWSER_INLINE void load_every(const double* p, V8 (&v)[N]) {
    static_assert(N >= 1 && N <= 3);
    if constexpr (N == 3) {
        load_threes(p, v);
    } else if constexpr (N == 1) {
        v[0] = load(p);
    } else {
#if defined(__AVX512F__)
        const V8 a = load(p), b = load(p + 8);
        v[0] = __builtin_shuffle(a, b, I8{0, 2, 4, 6, 8, 10, 12, 14});
        v[1] = __builtin_shuffle(a, b, I8{1, 3, 5, 7, 9, 11, 13, 15});
#else
        for (int k = 0; k < kParts; ++k) {
            const double* from = p + 2 * kPartLanes * k;
            const Part a = load_part(from), b = load_part(from + kPartLanes);
#if defined(__AVX2__)
            v[0].part[k] = __builtin_shuffle(a, b, PartMask{0, 2, 4, 6});
            v[1].part[k] = __builtin_shuffle(a, b, PartMask{1, 3, 5, 7});
#else
            v[0].part[k] = __builtin_shufflevector(a, b, 0, 2);
            v[1].part[k] = __builtin_shufflevector(a, b, 1, 3);
#endif
        }
#endif
    }
}
template <int N>
HAWSER_INLINE void store_every(double* p, const V8 (&v)[N]) {
    if constexpr (N == 3) {
        V8 out[3];
        as_threes(v[0], v[1], v[2], out);
        for (int r = 0; r < 3; ++r) store(p + kLanes * r, out[r]);
    } else if constexpr (N == 1) {
        store(p, v[0]);
    } else {
#if defined(__AVX512F__)
        store(p, __builtin_shuffle(v[0], v[1], I8{0, 8, 1, 9, 2, 10, 3, 11}));
        store(p + 8, __builtin_shuffle(v[0], v[1], I8{4, 12, 5, 13, 6, 14, 7, 15}));
#else
        for (int k = 0; k < kParts; ++k) {
            double* to = p + 2 * kPartLanes * k;
            const Part a = v[0].part[k], b = v[1].part[k];
#if defined(__AVX2__)
            store_part(to, __builtin_shuffle(a, b, PartMask{0, 4, 1, 5}));
            store_part(to + kPartLanes, __builtin_shuffle(a, b, PartMask{2, 6, 3, 7}));
#else
            store_part(to, __builtin_shufflevector(a, b, 0, 2));
            store_part(to + kPartLanes, __builtin_shufflevector(a, b, 1, 3));
#endif
        }
#endif
    }
}

/// Load eight consecutive entries of eight records, one record per lane: v[k] = base[from[0] + k] …
/// base[from[7] + k].
HAWSER_INLINE void load_lanes(const double* base, const std::int32_t* from, V8 (&v)[kLanes]) {
    for (int i = 0; i < kLanes; ++i) v[i] = load(base + from[i]);
    transpose(v);
}

/// Return true if eight records of N entries are contiguous in memory.
template <int N>
[[nodiscard]] HAWSER_INLINE bool are_contiguous(const std::int32_t* from) {
    std::int32_t off = 0;
    for (int l = 1; l < kLanes; ++l) off |= from[l] - from[0] - N * l;
    return off == 0;
}
/// Load the first three entries of eight records. @param in_a_row  are_contiguous<3>(from).
HAWSER_INLINE void load_lanes_of_three(const double* base, const std::int32_t* from, bool in_a_row,
                                       V8 (&v)[3]) {
    if (in_a_row) return load_threes(base + from[0], v);
    V8 t[kLanes];
    load_lanes(base, from, t);
    for (int k = 0; k < 3; ++k) v[k] = t[k];
}

}  // namespace hawser::HAWSER_ISA
