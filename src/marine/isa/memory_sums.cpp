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

/// Samples of all motions that the first cache holds: 6 × 512 × 8 bytes.
constexpr std::int64_t kTile = 512;

/// All pairs of six motions: each sample of a motion is loaded once for all that it meets.
void all_pairs(const double* k, const double* v, std::int64_t stride, std::int64_t count,
               double* out) noexcept {
    Lanes low[6]{}, high[6]{};
    std::int64_t m = 0;
    for (; m + kLanes <= count; m += kLanes) {
        Lanes x[6];
        for (int i = 0; i < 6; ++i) x[i] = load(v + i * stride + m);
        const double* p = k + m;
#pragma GCC unroll 6
        for (int i = 0; i < 6; ++i)
#pragma GCC unroll 6
            for (int j = 0; j <= i; ++j, p += stride) {
                const Lanes both = load(p);
                low[i] += both * x[j];
                if (i != j) high[j] += both * x[i];
            }
    }
    for (int i = 0; i < 6; ++i) out[i] += total_of(low[i] + high[i]);
    for (; m < count; ++m) {
        const double* p = k + m;
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j <= i; ++j, p += stride) {
                out[i] += *p * v[j * stride + m];
                if (i != j) out[j] += *p * v[i * stride + m];
            }
    }
}

void memory_sums(const double* k, const double* v, std::int64_t stride, std::int64_t count,
                 const int* pairs, int pair_count, double* out) noexcept {
    if (pair_count == 21) return all_pairs(k, v, stride, count, out);  // in this order
    for (std::int64_t from = 0; from < count; from += kTile) {
        const std::int64_t end = from + kTile < count ? from + kTile : count;
        for (int p = 0; p < pair_count; ++p) {
            const int i = pairs[2 * p], j = pairs[2 * p + 1];
            const double *kp = k + p * stride, *vi = v + i * stride, *vj = v + j * stride;
            // Two sums each, so that one addition need not wait for the other.
            Lanes a0{}, a1{}, b0{}, b1{};
            std::int64_t m = from;
            for (; m + 2 * kLanes <= end; m += 2 * kLanes) {
                const Lanes k0 = load(kp + m), k1 = load(kp + m + kLanes);
                a0 += k0 * load(vj + m);
                a1 += k1 * load(vj + m + kLanes);
                b0 += k0 * load(vi + m);
                b1 += k1 * load(vi + m + kLanes);
            }
            double a = total_of(a0 + a1), b = total_of(b0 + b1);
            for (; m < end; ++m) {
                a += kp[m] * vj[m];
                b += kp[m] * vi[m];
            }
            out[i] += a;
            if (i != j) out[j] += b;
        }
    }
}

}  // namespace

extern const marine::MemoryKernels kMemoryKernels;
const marine::MemoryKernels kMemoryKernels = {memory_sums};

}  // namespace hawser::HAWSER_ISA
