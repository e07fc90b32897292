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

namespace hawser::bench {

using V8 = double __attribute__((vector_size(64)));

/// Eight doubles from an address of any alignment; reads past short blocks.
HAWSER_BENCH_INLINE void load(V8& v, const double* from) { std::memcpy(&v, from, sizeof v); }

}  // namespace hawser::bench
