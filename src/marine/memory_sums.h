// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file memory_sums.h
/// Sums over the past of a hull (radiation.h), compiled once for each instruction set.

///
/// h K lies as it is read, once a step: blocks of eight samples, of each block all pairs, so that
/// one stream comes out of the second cache instead of 21. Past velocities are a ring: a block of
/// it may begin anywhere and goes on behind the ring's end, where the first seven samples stand
/// again.

#include <cstdint>

namespace hawser::marine {

inline constexpr std::int64_t kMemoryBlock = 8;  ///< Samples.

/// Samples with room for whole blocks.
[[nodiscard]] constexpr std::int64_t memory_padded(std::int64_t count) noexcept {
    return (count + kMemoryBlock - 1) / kMemoryBlock * kMemoryBlock;
}
/// Entries of a motion's ring: what stands behind its end counts.
[[nodiscard]] constexpr std::int64_t memory_stride(std::int64_t count) noexcept {
    return count + kMemoryBlock;
}

/// Σ over samples, by instruction set.
struct MemoryKernels {
    /// out[i] += Σ_m k[m] v_j[m], out[j] += Σ_m k[m] v_i[m] (once for i = j) of samples [0, count).
    /// @param k  By block, pair, sample; 0 from `count` on. @param v  Of each motion a ring,
    /// memory_stride() apart. @param newest  Place of sample 0 in it. @param pairs  i, j of each.
    void (*sums)(const double* k, const double* v, std::int64_t count, std::int64_t newest,
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
