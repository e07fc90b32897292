// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file simd.h
/// Vectors of eight doubles in GNU vector notation: one register on AVX-512, two on AVX2,
/// four on SSE2. For code compiled per instruction set (see small.h).

#include "base/small.h"

// The vectors never cross a function boundary that is not inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace hawser::HAWSER_ISA {

typedef double V8 __attribute__((vector_size(64), aligned(8), may_alias));
typedef long long I8 __attribute__((vector_size(64)));

inline constexpr int kLanes = 8;  ///< Arrays read by load() need this many entries of slack.

__attribute__((always_inline)) inline V8 load(const double* p) {
    return *reinterpret_cast<const V8*>(p);
}
__attribute__((always_inline)) inline void store(double* p, const V8& v) {
    *reinterpret_cast<V8*>(p) = v;
}
/// v with the lanes from `count` on set to zero (whatever they held).
__attribute__((always_inline)) inline V8 first_lanes(const V8& v, int count) {
    const I8 index = {0, 1, 2, 3, 4, 5, 6, 7};
    const I8 keep = index < static_cast<long long>(count);
    return reinterpret_cast<V8>(reinterpret_cast<I8>(v) & keep);
}
/// Sum of the lanes, in a fixed order.
__attribute__((always_inline)) inline double sum(const V8& v) {
    return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}
/// Lane k of the result is the sum of the lanes of v[k].
__attribute__((always_inline)) inline V8 sums(const V8* v) {
    const I8 even = {0, 8, 2, 10, 4, 12, 6, 14}, odd = {1, 9, 3, 11, 5, 13, 7, 15};
    const I8 low2 = {0, 1, 8, 9, 4, 5, 12, 13}, high2 = {2, 3, 10, 11, 6, 7, 14, 15};
    const I8 low4 = {0, 1, 2, 3, 8, 9, 10, 11}, high4 = {4, 5, 6, 7, 12, 13, 14, 15};
    V8 pair[4], quad[2];
    for (int i = 0; i < 4; ++i)
        pair[i] = __builtin_shuffle(v[2 * i], v[2 * i + 1], even) +
                  __builtin_shuffle(v[2 * i], v[2 * i + 1], odd);
    for (int i = 0; i < 2; ++i)
        quad[i] = __builtin_shuffle(pair[2 * i], pair[2 * i + 1], low2) +
                  __builtin_shuffle(pair[2 * i], pair[2 * i + 1], high2);
    return __builtin_shuffle(quad[0], quad[1], low4) + __builtin_shuffle(quad[0], quad[1], high4);
}

}  // namespace hawser::HAWSER_ISA
