// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file memory_sums.h
/// Sums over the past of a hull (radiation.h), compiled once for each instruction set.

#include <cstdint>

namespace hawser::marine {

/// Σ over samples, by instruction set.
struct MemoryKernels {
    /// out[i] += Σ_m k[m] v_j[m], out[j] += Σ_m k[m] v_i[m] (once for i = j) of samples [0, count).
    /// @param k  Of each pair, `stride` apart. @param v  Of each motion, `stride` apart.
    /// @param pairs  i, j of each.
    void (*sums)(const double* k, const double* v, std::int64_t stride, std::int64_t count,
                 const int* pairs, int pair_count, double* out) noexcept;
};
[[nodiscard]] const MemoryKernels& memory_kernels() noexcept;

}  // namespace hawser::marine

namespace hawser::sse2 {
extern const marine::MemoryKernels kMemoryKernels;
}
namespace hawser::avx2 {
extern const marine::MemoryKernels kMemoryKernels;
}
namespace hawser::avx512 {
extern const marine::MemoryKernels kMemoryKernels;
}
