// SPDX-License-Identifier: Apache-2.0
#include "marine/fast_wave_sums.h"

namespace hawser::HAWSER_ISA {
namespace {

#if defined(__AVX512F__)
inline constexpr int kFloats = 16;
#elif defined(__AVX2__)
inline constexpr int kFloats = 8;
#else
inline constexpr int kFloats = 4;
#endif
typedef float Floats __attribute__((vector_size(4 * kFloats), aligned(4), may_alias));
typedef int FloatBits __attribute__((vector_size(4 * kFloats)));

#define HAWSER_FAST __attribute__((always_inline)) inline

/// Adding and subtracting it leaves the nearest whole number; its lowest bits are that number.
constexpr float kFastWhole = 12582912.0F;           // 1.5 · 2^23
constexpr double kFastWholeDouble = 6755399441055744.0;  // 1.5 · 2^52

HAWSER_FAST Floats floats_at(const float* p) { return *reinterpret_cast<const Floats*>(p); }
HAWSER_FAST void put_floats(float* p, Floats v) { *reinterpret_cast<Floats*>(p) = v; }
/// Sum of the lanes in double precision, in a fixed order.
HAWSER_FAST double total_of(Floats v) {
    double sum[2] = {};
    for (int i = 0; i < kFloats; i += 2) {
        sum[0] += static_cast<double>(v[i]);
        sum[1] += static_cast<double>(v[i + 1]);
    }
    return sum[0] + sum[1];
}

/// √2 sin πx by x times a polynomial of x², √2 cos πx by one, on [−½, ½], and 2^x on [−½, ½].
constexpr float kFastSine[] = {4.44288283489F, -7.30824118466F, 3.6062893314F, -0.845765402968F,
                               0.109208754876F};
constexpr float kFastCosine[] = {1.41421349657F, -6.97885098845F, 5.73946117522F, -1.8835630185F,
                                 0.310698256468F};
constexpr float kFastPower[] = {1.00000007165F,    0.693146967067F,   0.240221197247F,
                                0.0555071325874F, 0.00967554136335F, 0.00132764778088F};

template <int N>
HAWSER_FAST Floats fast_series(const float (&c)[N], Floats x) {
    Floats y = Floats{} + c[N - 1];
    for (int i = N - 2; i >= 0; --i) y = y * x + c[i];
    return y;
}
/// 2^x; below x = −126 that of −126.
HAWSER_FAST Floats fast_power(Floats x) {
    x = x > -126.0F ? x : Floats{} - 126.0F;
    const Floats shifted = x + kFastWhole, part = fast_series(kFastPower, x - (shifted - kFastWhole));
    return reinterpret_cast<Floats>(reinterpret_cast<FloatBits>(part) +
                                    (reinterpret_cast<FloatBits>(shifted) << 23));
}

void refer(const double* rows, int padded, int groups, double x, double y, float* turns) noexcept {
    const double *kx = rows + marine::kReferenceX * padded, *ky = rows + marine::kReferenceY * padded,
                 *phase = rows + marine::kReferencePhase * padded;
    for (int i = 0; i < groups * marine::kFastGroup; ++i) {
        const double all = kx[i] * x + (ky[i] * y + phase[i]);
        turns[i] = static_cast<float>(all - ((all + kFastWholeDouble) - kFastWholeDouble));
    }
}

void fast_surface(const float* table, int padded, int groups, const float* turns, const float* dx,
                  const float* dy, float* circle, double* sum) noexcept {
    constexpr int kPoints = marine::kWavePoints;
    const float *kx = table + marine::kFastTurnsX * padded,
                *ky = table + marine::kFastTurnsY * padded,
                *a = table + marine::kFastAmplitude * padded;
    Floats all[kPoints]{};
    for (int i = 0; i < groups * marine::kFastGroup; i += kFloats) {
        const Floats along = floats_at(kx + i), across = floats_at(ky + i),
                     from = floats_at(turns + i), high = floats_at(a + i);
#pragma GCC unroll 4
        for (int p = 0; p < kPoints; ++p) {
            const Floats t = along * dx[p] + (across * dy[p] + from);
            const Floats f = t - ((t + kFastWhole) - kFastWhole),
                         h = f * fast_series(kFastSine, f * f);
            float* const to = circle + 2 * p * padded + i;
            put_floats(to, h);
            put_floats(to + padded, f);
            all[p] += high * (1.0F - h * h);
        }
    }
    for (int p = 0; p < kPoints; ++p) sum[p] = total_of(all[p]);
}

struct FastSums {
    Floats u[3]{}, a[3]{};
};

/// Groups [begin, end); with the mirror image below the bottom or without.
template <bool Bottom>
HAWSER_FAST void add_groups(const float* table, int padded, int begin, int end,
                            const float* circle, float depth, FastSums& to) {
    const auto row = [&](int r) __attribute__((always_inline)) { return table + r * padded; };
    const float *decay = row(marine::kFastDecay), *bottom = row(marine::kFastBottom);
    const float *ux = row(marine::kFastSpeedX), *uy = row(marine::kFastSpeedY),
                *uz = row(marine::kFastSpeedZ), *ax = row(marine::kFastRateX),
                *ay = row(marine::kFastRateY), *az = row(marine::kFastRateZ);
    for (int i = begin * marine::kFastGroup; i < end * marine::kFastGroup; i += kFloats) {
        const Floats h = floats_at(circle + i), f = floats_at(circle + padded + i);
        const Floats c = 1.0F - h * h, s = h * fast_series(kFastCosine, f * f);
        const Floats exponent = floats_at(decay + i) * depth, up = fast_power(exponent);
        Floats level = up, steep = up;
        if constexpr (Bottom) {
            const Floats down = fast_power(floats_at(bottom + i) - exponent);
            level += down;
            steep -= down;
        }
        const Floats lc = level * c, ls = level * s, sc = steep * c, ss = steep * s;
        to.u[0] += lc * floats_at(ux + i);
        to.u[1] += lc * floats_at(uy + i);
        to.u[2] += ss * floats_at(uz + i);
        to.a[0] += ls * floats_at(ax + i);
        to.a[1] += ls * floats_at(ay + i);
        to.a[2] -= sc * floats_at(az + i);
    }
}

void fast_sums(const float* table, int padded, marine::FastExtent of, const float* circle,
               double depth, marine::WaveSums& out) noexcept {
    FastSums all;
    const auto down = static_cast<float>(depth);
    add_groups<true>(table, padded, 0, of.bottom, circle, down, all);
    add_groups<false>(table, padded, of.bottom, of.groups, circle, down, all);
    for (int k = 0; k < 3; ++k) {
        out.u[k] = total_of(all.u[k]);
        out.a[k] = total_of(all.a[k]);
    }
    out.p = 0.0;
}

template <bool Bottom>
HAWSER_FAST void add_pressures(const float* table, int padded, int begin, int end,
                               const float* circle, float depth, Floats& to) {
    const float *decay = table + marine::kFastDecay * padded,
                *bottom = table + marine::kFastBottom * padded,
                *weight = table + marine::kFastPressure * padded;
    for (int i = begin * marine::kFastGroup; i < end * marine::kFastGroup; i += kFloats) {
        const Floats h = floats_at(circle + i), exponent = floats_at(decay + i) * depth;
        Floats level = fast_power(exponent);
        if constexpr (Bottom) level += fast_power(floats_at(bottom + i) - exponent);
        to += level * (1.0F - h * h) * floats_at(weight + i);
    }
}

double fast_pressure(const float* table, int padded, marine::FastExtent of, const float* circle,
                     double depth) noexcept {
    Floats all{};
    const auto down = static_cast<float>(depth);
    add_pressures<true>(table, padded, 0, of.bottom, circle, down, all);
    add_pressures<false>(table, padded, of.bottom, of.groups, circle, down, all);
    return total_of(all);
}

#undef HAWSER_FAST

}  // namespace

extern const marine::FastWaveKernels kFastWaveKernels;
const marine::FastWaveKernels kFastWaveKernels = {refer, fast_surface, fast_sums, fast_pressure};

}  // namespace hawser::HAWSER_ISA
