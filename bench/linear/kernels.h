// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file kernels.h
/// Vectors of eight doubles for the loops around the solvers, compiled once for each instruction
/// set by the compiler and chosen when the program starts.

#include <cstring>

#if defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define HAWSER_BENCH_CLONES \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define HAWSER_BENCH_CLONES
#endif
#define HAWSER_BENCH_INLINE [[gnu::always_inline]] inline
/// Before loops over an array of vectors, which otherwise stays in memory.
#define HAWSER_BENCH_UNROLL _Pragma("GCC unroll 8")

namespace hawser::bench {

using V8 = double __attribute__((vector_size(64)));
using V4 = double __attribute__((vector_size(32)));
using V2 = double __attribute__((vector_size(16)));

/// Ones in the first n of eight places.
inline constexpr double kMask[9][8] = {{},
                                       {1},
                                       {1, 1},
                                       {1, 1, 1},
                                       {1, 1, 1, 1},
                                       {1, 1, 1, 1, 1},
                                       {1, 1, 1, 1, 1, 1},
                                       {1, 1, 1, 1, 1, 1, 1},
                                       {1, 1, 1, 1, 1, 1, 1, 1}};

/// Eight doubles from an address of any alignment; reads past short blocks.
HAWSER_BENCH_INLINE void load(V8& v, const double* from) {
    using Anywhere = double __attribute__((vector_size(64), aligned(8), may_alias));
    v = *reinterpret_cast<const Anywhere*>(from);
}

/// The first N of eight doubles.
template <int N>
HAWSER_BENCH_INLINE void store(double* to, const V8& v) {
    const V4 low = __builtin_shufflevector(v, v, 0, 1, 2, 3);
    const V4 high = __builtin_shufflevector(v, v, 4, 5, 6, 7);
    const V4& last = N >= 4 ? high : low;
    if constexpr (N >= 4) std::memcpy(to, &low, sizeof low);
    constexpr int kRest = N % 4, kAt = N - kRest;
    if constexpr (kRest >= 2) {
        const V2 pair = __builtin_shufflevector(last, last, 0, 1);
        std::memcpy(to + kAt, &pair, sizeof pair);
    }
    if constexpr (kRest % 2 == 1) to[N - 1] = last[kRest - 1];
}

HAWSER_BENCH_INLINE double total(const V8& v) {
    const V4 four =
        __builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7);
    const V2 two =
        __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
    return two[0] + two[1];
}

}  // namespace hawser::bench
