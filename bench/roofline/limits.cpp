// SPDX-License-Identifier: Apache-2.0
#include "roofline/limits.h"

#include "base/isa.h"
#include "base/memory.h"
#include "linear/timing.h"

#include <algorithm>

namespace hawser::bench {
namespace {

constexpr int kChains = 10;  // latency of 4 cycles, two units: 8 at least

// The loops for one instruction set. Constants come from memory, so that the compiler does not know
// them.
#define HAWSER_LOOPS(isa, attribute, width)                                                   \
    namespace isa {                                                                           \
    typedef double V __attribute__((vector_size(width), aligned(8), may_alias));              \
    attribute __attribute__((noinline)) double multiply_add(long rounds, const double* two) { \
        const V m = V{} + two[0], c = V{} + two[1];                                           \
        V a[kChains];                                                                         \
        for (int k = 0; k < kChains; ++k) a[k] = V{} + static_cast<double>(k);                \
        for (long i = 0; i < rounds; ++i)                                                     \
            for (int k = 0; k < kChains; ++k) a[k] = a[k] * m + c;                            \
        double sum = 0.0;                                                                     \
        for (int k = 0; k < kChains; ++k) sum += a[k][0];                                     \
        return sum;                                                                           \
    }                                                                                         \
    attribute __attribute__((noinline)) double read(const double* p, std::size_t n) {         \
        constexpr std::size_t w = sizeof(V) / sizeof(double);                                 \
        V s[4] = {};                                                                          \
        for (std::size_t i = 0; i + 4 * w <= n; i += 4 * w)                                   \
            for (std::size_t k = 0; k < 4; ++k)                                               \
                s[k] += *reinterpret_cast<const V*>(p + i + k * w);                           \
        return s[0][0] + s[1][0] + s[2][0] + s[3][0];                                         \
    }                                                                                         \
    attribute __attribute__((noinline)) double update(double* p, std::size_t n,               \
                                                      const double* two) {                    \
        constexpr std::size_t w = sizeof(V) / sizeof(double);                                 \
        const V m = V{} + two[0], c = V{} + two[1];                                           \
        for (std::size_t i = 0; i + w <= n; i += w) {                                         \
            V& v = *reinterpret_cast<V*>(p + i);                                              \
            v = v * m + c;                                                                    \
        }                                                                                     \
        return p[0];                                                                          \
    }                                                                                         \
    }
HAWSER_LOOPS(sse2, , 16)
HAWSER_LOOPS(avx2, __attribute__((target("avx2,fma"))), 32)
HAWSER_LOOPS(avx512, __attribute__((target("avx512f,fma"))), 64)
#undef HAWSER_LOOPS

struct Loops {
    double (*multiply_add)(long, const double*);
    double (*read)(const double*, std::size_t);
    double (*update)(double*, std::size_t, const double*);
    int lanes;
};

Loops loops() {
    switch (base::isa()) {
        case base::Isa::avx512:
            return {avx512::multiply_add, avx512::read, avx512::update, 8};
        case base::Isa::avx2:
            return {avx2::multiply_add, avx2::read, avx2::update, 4};
        default:
            return {sse2::multiply_add, sse2::read, sse2::update, 2};
    }
}

/// Return the largest number per second of processor time, of several tries.
template <class F>
double best_rate(double amount, F&& once) {
    constexpr double kTry = 0.01;  // [s]
    volatile double sink = once();
    double best = 0.0;
    for (int k = 0; k < 7; ++k) {
        int times = 0;
        double passed = 0.0;
        for (const double from = thread_seconds(); passed < kTry;
             passed = thread_seconds() - from) {
            sink = once();
            ++times;
        }
        best = std::max(best, times * amount / passed);
    }
    static_cast<void>(sink);
    return best;
}

}  // namespace

double peak_flops() {
    const Loops l = loops();
    const double two[2] = {0.999, 1e-3};
    constexpr long kRounds = 100'000;
    return best_rate(2.0 * kChains * kRounds * l.lanes,
                     [&] { return l.multiply_add(kRounds, two); });
}

Bandwidth bandwidth(std::size_t bytes) {
    const Loops l = loops();
    const double two[2] = {0.999, 1e-3};
    base::Array<double> x(std::max<std::size_t>(bytes / sizeof(double), 4096), 1.0);
    const auto all = static_cast<double>(base::bytes(x));
    return {best_rate(all, [&] { return l.read(x.data(), x.size()); }),
            best_rate(2.0 * all, [&] { return l.update(x.data(), x.size(), two); })};
}

}  // namespace hawser::bench
