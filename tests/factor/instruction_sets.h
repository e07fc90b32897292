// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file instruction_sets.h
/// Kernels of every compiled instruction set, and whether this processor has it.

#include "factor/isa/lanes.h"
#include "factor/kernels.h"

#include <vector>

namespace hawser::test {

struct Set {
    const char* name;
    bool available;
    const factor::Kernels* kernels;
    const char* (*wrong_lanes)();
};

inline std::vector<Set> sets() {
    __builtin_cpu_init();
    [[maybe_unused]] const bool avx2 =
        __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    [[maybe_unused]] const bool avx512 =
        avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
    return {
        {"sse2", true, &sse2::kKernels, &sse2::wrong_lanes},
#if !defined(HAWSER_NO_AVX2)
        {"avx2", avx2, &avx2::kKernels, &avx2::wrong_lanes},
#endif
#if !defined(HAWSER_NO_AVX512)
        {"avx512", avx512, &avx512::kKernels, &avx512::wrong_lanes},
#endif
    };
}

}  // namespace hawser::test
