// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file memory_sums.h
/// Sum over the past motion of a hull (radiation.h), compiled once for each instruction set.

///
/// h K is stored in the order in which a step reads it: blocks of eight samples, with all pairs in
/// each block. One stream is then read from the second-level cache instead of 21. Past velocities
/// are a ring buffer. Its first seven samples are repeated behind its end, so that a block may
/// begin at any sample.

#include <cstdint>

namespace hawser::marine {

inline constexpr std::int64_t kMemoryBlock = 8;  ///< Samples.

/// Return the number of samples, rounded up to whole blocks.
[[nodiscard]] constexpr std::int64_t memory_padded(std::int64_t count) noexcept {
    return (count + kMemoryBlock - 1) / kMemoryBlock * kMemoryBlock;
}
/// Return the stride of the rings of motions: samples, and the repeated samples behind the end.
[[nodiscard]] constexpr std::int64_t memory_stride(std::int64_t count) noexcept {
    return count + kMemoryBlock;
}

/// Sums over samples, by instruction set.
struct MemoryKernels {
    /// Compute out[i] += Σ_m k[m] v_j[m] and out[j] += Σ_m k[m] v_i[m] (once for i = j) over the
    /// samples [0, count). @param k  By block, pair, sample; 0 from `count` on. @param v  Ring of
    /// each motion, memory_stride() entries each. @param newest  Index of sample 0 in the ring.
    /// @param pairs  i and j of each pair.
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
