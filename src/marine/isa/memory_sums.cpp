// SPDX-License-Identifier: Apache-2.0
#include "marine/memory_sums.h"

namespace hawser::HAWSER_ISA {
namespace {

#if defined(__AVX512F__)
inline constexpr int kLanes = 8;
#elif defined(__AVX2__)
inline constexpr int kLanes = 4;
#else
inline constexpr int kLanes = 2;
#endif
typedef double Lanes __attribute__((vector_size(8 * kLanes), aligned(8), may_alias));

__attribute__((always_inline)) inline Lanes load(const double* p) {
    return *reinterpret_cast<const Lanes*>(p);
}
__attribute__((always_inline)) inline double total_of(Lanes v) {
    double sum = 0.0;
    for (int i = 0; i < kLanes; ++i) sum += v[i];
    return sum;
}

using marine::kMemoryBlock;

/// Number of blocks of a tile: six motions and their pairs fit into the first-level cache.
constexpr std::int64_t kTileBlocks = 16;

/// Compute the memory sums of all pairs of six motions. Each sample of a motion is loaded once for
/// all its pairs.
void all_pairs(const double* k, const double* v, std::int64_t count, std::int64_t newest,
               double* out) noexcept {
    const std::int64_t stride = marine::memory_stride(count);
    Lanes low[6]{}, high[6]{};
    std::int64_t at = newest;
    for (std::int64_t m = 0; m < count; m += kMemoryBlock, k += 21 * kMemoryBlock) {
        for (int part = 0; part < kMemoryBlock; part += kLanes) {
            Lanes x[6];
            for (int i = 0; i < 6; ++i) x[i] = load(v + i * stride + at + part);
            const double* p = k + part;
#pragma GCC unroll 6
            for (int i = 0; i < 6; ++i)
#pragma GCC unroll 6
                for (int j = 0; j <= i; ++j, p += kMemoryBlock) {
                    const Lanes both = load(p);
                    low[i] += both * x[j];
                    if (i != j) high[j] += both * x[i];
                }
        }
        at += kMemoryBlock;
        if (at >= count) at -= count;
    }
    for (int i = 0; i < 6; ++i) out[i] += total_of(low[i] + high[i]);
}

/// Compute the memory sums of some pairs of motions, whose blocks are contiguous in the ring.
void some_pairs(const double* k, const double* v, std::int64_t stride, std::int64_t blocks,
                const int* pairs, int pair_count, double* out) noexcept {
    const std::int64_t next = pair_count * kMemoryBlock;
    for (int p = 0; p < pair_count; ++p) {
        const int i = pairs[2 * p], j = pairs[2 * p + 1];
        const double *kp = k + p * kMemoryBlock, *vi = v + i * stride, *vj = v + j * stride;
        Lanes a{}, b{};
        for (std::int64_t m = 0; m < blocks; ++m, kp += next)
            for (int part = 0; part < kMemoryBlock; part += kLanes) {
                const Lanes both = load(kp + part);
                a += both * load(vj + m * kMemoryBlock + part);
                b += both * load(vi + m * kMemoryBlock + part);
            }
        out[i] += total_of(a);
        if (i != j) out[j] += total_of(b);
    }
}

void memory_sums(const double* k, const double* v, std::int64_t count, std::int64_t newest,
                 const int* pairs, int pair_count, double* out) noexcept {
    if (pair_count == 21) return all_pairs(k, v, count, newest, out);  // in this order
    const std::int64_t all = (count + kMemoryBlock - 1) / kMemoryBlock;
    std::int64_t at = newest;
    for (std::int64_t done = 0; done < all;) {
        const std::int64_t to_end = (count - at + kMemoryBlock - 1) / kMemoryBlock;
        std::int64_t blocks = all - done < kTileBlocks ? all - done : kTileBlocks;
        if (to_end < blocks) blocks = to_end;
        some_pairs(k + done * pair_count * kMemoryBlock, v + at, marine::memory_stride(count),
                   blocks, pairs, pair_count, out);
        done += blocks;
        at += blocks * kMemoryBlock;
        if (at >= count) at -= count;
    }
}

}  // namespace

extern const marine::MemoryKernels kMemoryKernels;
const marine::MemoryKernels kMemoryKernels = {memory_sums};

}  // namespace hawser::HAWSER_ISA
