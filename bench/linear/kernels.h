// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file kernels.h
/// Vectors of eight doubles for the loops around the solvers, compiled once for each instruction
/// set by the compiler and selected when the program starts.

#include <cstddef>
#include <cstring>

#if defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define HAWSER_BENCH_CLONES \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define HAWSER_BENCH_CLONES
#endif
#define HAWSER_BENCH_INLINE [[gnu::always_inline]] inline
/// Unroll a loop over an array of vectors, which otherwise stays in memory.
#define HAWSER_BENCH_UNROLL _Pragma("GCC unroll 8")

namespace hawser::bench {

using V4 = double __attribute__((vector_size(32)));
using V2 = double __attribute__((vector_size(16)));
/// Two registers of AVX2. g++ lowers one vector of 64 bytes through memory if no register has this
/// size.
struct V8 {
    V4 low, high;
};
HAWSER_BENCH_INLINE V8& operator+=(V8& a, const V8& b) {
    a.low += b.low;
    a.high += b.high;
    return a;
}
HAWSER_BENCH_INLINE V8& operator-=(V8& a, const V8& b) {
    a.low -= b.low;
    a.high -= b.high;
    return a;
}
HAWSER_BENCH_INLINE V8& operator*=(V8& a, const V8& b) {
    a.low *= b.low;
    a.high *= b.high;
    return a;
}
HAWSER_BENCH_INLINE V8& operator*=(V8& a, double b) {
    a.low *= b;
    a.high *= b;
    return a;
}
HAWSER_BENCH_INLINE V8 operator*(const V8& a, const V8& b) {
    return {a.low * b.low, a.high * b.high};
}
HAWSER_BENCH_INLINE V8 operator*(const V8& a, double b) { return {a.low * b, a.high * b}; }

/// Ones in the first n of eight lanes.
inline constexpr double kMask[9][8] = {{},
                                       {1},
                                       {1, 1},
                                       {1, 1, 1},
                                       {1, 1, 1, 1},
                                       {1, 1, 1, 1, 1},
                                       {1, 1, 1, 1, 1, 1},
                                       {1, 1, 1, 1, 1, 1, 1},
                                       {1, 1, 1, 1, 1, 1, 1, 1}};

/// Load eight doubles from an address of any alignment; reads past short blocks.
HAWSER_BENCH_INLINE void load(V8& v, const double* from) {
    using Anywhere = double __attribute__((vector_size(32), aligned(8), may_alias));
    v.low = *reinterpret_cast<const Anywhere*>(from);
    v.high = *reinterpret_cast<const Anywhere*>(from + 4);
}

HAWSER_BENCH_INLINE void load(V4& v, const double* from) {
    using Anywhere = double __attribute__((vector_size(32), aligned(8), may_alias));
    v = *reinterpret_cast<const Anywhere*>(from);
}

/// Number of doubles from which blocks are prefetched: for blocks read in sequence (4 MB), and for
/// others (8 MB). Below it, prefetching costs more than it saves.
inline constexpr std::size_t kNearSize = 524'288, kNearScattered = 1'048'576;

/// Prefetch cache lines.
HAWSER_BENCH_INLINE void fetch(const double* from, int lines) {
    for (int k = 0; k < lines; ++k) __builtin_prefetch(from + 8 * k);
}

/// Load the first N of four doubles.
template <int N>
HAWSER_BENCH_INLINE void store(double* to, const V4& v) {
    static_assert(N <= 4);
    if constexpr (N == 4) {
        std::memcpy(to, &v, sizeof v);
    } else {
        const V2 pair = __builtin_shufflevector(v, v, 0, 1);
        if constexpr (N >= 2) std::memcpy(to, &pair, sizeof pair);
        if constexpr (N == 1) to[0] = pair[0];
        if constexpr (N == 3) to[2] = v[2];
    }
}

/// Set out to the four sums of the lanes of four vectors. (No vector is returned: without AVX this
/// has another calling convention.)
HAWSER_BENCH_INLINE void totals(V4& out, const V4 (&v)[4]) {
    const V4 ab = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6) +
                  __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7);
    const V4 cd = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6) +
                  __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
    out = __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// Load the first N of eight doubles.
template <int N>
HAWSER_BENCH_INLINE void store(double* to, const V8& v) {
    const V4& last = N >= 4 ? v.high : v.low;
    if constexpr (N >= 4) std::memcpy(to, &v.low, sizeof v.low);
    constexpr int kRest = N % 4, kAt = N - kRest;
    if constexpr (kRest >= 2) {
        const V2 pair = __builtin_shufflevector(last, last, 0, 1);
        std::memcpy(to + kAt, &pair, sizeof pair);
    }
    if constexpr (kRest % 2 == 1) to[N - 1] = last[kRest - 1];
}

/// Add the lower and the upper half to sum.
HAWSER_BENCH_INLINE void add_halves(V4& sum, const V8& v) { sum += v.low + v.high; }

}  // namespace hawser::bench
