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

/// Adding and subtracting this number rounds to the nearest whole number, whose value is in the
/// lowest bits of the sum.
constexpr float kFastWhole = 12582912.0F;                // 1.5 · 2^23
constexpr double kFastWholeDouble = 6755399441055744.0;  // 1.5 · 2^52

HAWSER_FAST Floats floats_at(const float* p) { return *reinterpret_cast<const Floats*>(p); }
HAWSER_FAST void put_floats(float* p, Floats v) { *reinterpret_cast<Floats*>(p) = v; }
/// Return the sum of the lanes, by halves.
HAWSER_FAST double total_of(Floats v) {
#if defined(__AVX512F__)
    v += __builtin_shuffle(v, FloatBits{8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7});
    v += __builtin_shuffle(v, FloatBits{4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11});
#elif defined(__AVX2__)
    v += __builtin_shuffle(v, FloatBits{4, 5, 6, 7, 0, 1, 2, 3});
#endif
    return (static_cast<double>(v[0]) + static_cast<double>(v[1])) +
           (static_cast<double>(v[2]) + static_cast<double>(v[3]));
}

/// Polynomials on [−½, ½]: √2 sin πx as x times a polynomial of x², √2 cos πx as a polynomial of
/// x², and 2^x.
constexpr float kFastSine[] = {4.44288283489F, -7.30824118466F, 3.6062893314F, -0.845765402968F,
                               0.109208754876F};
constexpr float kFastCosine[] = {1.41421349657F, -6.97885098845F, 5.73946117522F, -1.8835630185F,
                                 0.310698256468F};
constexpr float kFastPower[] = {1.00000000055F,    0.693147205736F,   0.240226468912F,
                                0.0555032877851F,  0.00961848889795F, 0.00133999307896F,
                                0.000153458273815F};

/// Polynomial of e^x on [−¼, ¼], with a relative error of 1e-8.
constexpr float kFastExp[] = {1.00000001033F,  0.99999995637F,   0.499996979273F,
                              0.166669130515F, 0.0417964627807F, 0.00831475695214F};

template <int N>
HAWSER_FAST Floats fast_series(const float (&c)[N], Floats x) {
    Floats y = Floats{} + c[N - 1];
    for (int i = N - 2; i >= 0; --i) y = y * x + c[i];
    return y;
}
/// Return 2^x; x is limited to at least −126.
HAWSER_FAST Floats fast_power(Floats x) {
    x = x > -126.0F ? x : Floats{} - 126.0F;
    const Floats shifted = x + kFastWhole,
                 part = fast_series(kFastPower, x - (shifted - kFastWhole));
    return reinterpret_cast<Floats>(reinterpret_cast<FloatBits>(part) +
                                    (reinterpret_cast<FloatBits>(shifted) << 23));
}

void refer(const double* rows, int padded, int groups, double x, double y, float* turns) noexcept {
    const double *kx = rows + marine::kReferenceX * padded,
                 *ky = rows + marine::kReferenceY * padded,
                 *phase = rows + marine::kReferencePhase * padded;
    for (int i = 0; i < groups * marine::kFastGroup; ++i) {
        const double all = kx[i] * x + (ky[i] * y + phase[i]);
        turns[i] = static_cast<float>(all - ((all + kFastWholeDouble) - kFastWholeDouble));
    }
}

void fast_surface(const marine::FastTable& table, int groups, const float* turns, const float* dx,
                  const float* dy, float* circle, double* sum) noexcept {
    constexpr int kPoints = marine::kWavePoints;
    const int padded = table.padded;
    const float *kx = table.row(marine::kFastTurnsX), *ky = table.row(marine::kFastTurnsY),
                *a = table.row(marine::kFastAmplitude);
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

/// e^(−k ζ) of the middle wave numbers of the first groups, for all points of a batch at once.
struct GroupPowers {
    alignas(64) float of[marine::kWavePoints][marine::kMaxFastGroups];

    HAWSER_FAST GroupPowers(const float* middle, int groups, const float* depth) {
        for (int g = 0; g < groups; g += kFloats) {
            const Floats rate = floats_at(middle + g);
#pragma GCC unroll 4
            for (int p = 0; p < marine::kWavePoints; ++p)
                put_floats(of[p] + g, fast_power(rate * depth[p]));
        }
    }
};
/// Method to compute e^(−k ζ) of a group. With δ = k − k of the group's middle: `near` multiplies
/// the middle's value by a series in δ ζ; `far` uses δ ζ/4 and two squarings; `alone` computes each
/// component.
enum class Falling { near, far, alone };
constexpr float kNearest = 0.25F, kFarthest = 1.0F;

/// Return e^(−k ζ) of the components from i on, relative to their group's middle unless `alone`.
template <Falling By>
HAWSER_FAST Floats falling(const marine::FastTable& table, int i, float depth) {
    if constexpr (By == Falling::alone)
        return fast_power(floats_at(table.row(marine::kFastDecay) + i) * depth);
    const Floats offset = floats_at(table.row(marine::kFastOffset) + i);
    if constexpr (By == Falling::near) return fast_series(kFastExp, offset * depth);
    Floats root = fast_series(kFastExp, offset * (0.25F * depth));
    root *= root;
    return root * root;
}

struct FastSums {
    Floats u[3]{}, a[3]{};
};

/// Add one group. @tparam Bottom  Include its mirror image below the bottom. @param middle  e^(−k
/// ζ) of the group's middle, or 1.
template <Falling By, bool Bottom>
HAWSER_FAST void add_group(const marine::FastTable& table, int group, const float* circle,
                           float depth, float middle, FastSums& to) {
    const int begin = group * marine::kFastGroup;
#pragma GCC unroll 4
    for (int i = begin; i < begin + marine::kFastGroup; i += kFloats) {
        const auto at = [&](marine::FastRow r)
                            __attribute__((always_inline)) { return floats_at(table.row(r) + i); };
        const Floats h = floats_at(circle + i), f = floats_at(circle + table.padded + i);
        const Floats c = 1.0F - h * h, s = h * fast_series(kFastCosine, f * f);
        const Floats up = falling<By>(table, i, depth) * middle;
        Floats level = up, steep = up;
        if constexpr (Bottom) {
            const Floats down = at(marine::kFastBottom) / up;
            level += down;
            steep -= down;
        }
        const Floats lc = level * c, ls = level * s, sc = steep * c, ss = steep * s;
        to.u[0] += lc * at(marine::kFastSpeedX);
        to.u[1] += lc * at(marine::kFastSpeedY);
        to.u[2] += ss * at(marine::kFastSpeedZ);
        to.a[0] += ls * at(marine::kFastRateX);
        to.a[1] += ls * at(marine::kFastRateY);
        to.a[2] -= sc * at(marine::kFastRateZ);
    }
}

/// Add the groups [begin, end) at one point.
template <bool Bottom>
HAWSER_FAST void add_groups(const marine::FastTable& table, int begin, int end, const float* circle,
                            float depth, const float* middle, FastSums& to) {
    for (int g = begin; g < end; ++g) {
        const float separation = table.width[g] * depth;
        if (separation <= kNearest)
            add_group<Falling::near, Bottom>(table, g, circle, depth, middle[g], to);
        else if (separation <= kFarthest)
            add_group<Falling::far, Bottom>(table, g, circle, depth, middle[g], to);
        else
            add_group<Falling::alone, Bottom>(table, g, circle, depth, 1.0F, to);
    }
}

/// Convert depths to single precision; slots beyond `count` repeat the last one.
HAWSER_FAST int first_depths(const marine::FastExtent* of, const double* depth, int count,
                             float* out) {
    int groups = 0;
    for (int p = 0; p < marine::kWavePoints; ++p) {
        const int from = p < count ? p : count - 1;
        out[p] = static_cast<float>(depth[from]);
        groups = of[from].groups > groups ? of[from].groups : groups;
    }
    return groups;
}

void fast_sums(const marine::FastTable& table, const marine::FastExtent* of, const float* circle,
               const double* depth, int count, marine::WaveSums* out) noexcept {
    float down[marine::kWavePoints];
    const int groups = first_depths(of, depth, count, down);
    const GroupPowers middle(table.middle, groups, down);
    for (int p = 0; p < count; ++p) {
        FastSums all;
        const float* const own = circle + 2 * p * table.padded;
        add_groups<true>(table, 0, of[p].bottom, own, down[p], middle.of[p], all);
        add_groups<false>(table, of[p].bottom, of[p].groups, own, down[p], middle.of[p], all);
        for (int k = 0; k < 3; ++k) {
            out[p].u[k] = total_of(all.u[k]);
            out[p].a[k] = total_of(all.a[k]);
        }
        out[p].p = 0.0;
    }
}

/// Add the pressure of one group at all points of a batch.
template <Falling By, bool Bottom>
HAWSER_FAST void add_pressure(const marine::FastTable& table, int group, const float* circle,
                              const float* depth, const GroupPowers& middle, Floats* to) {
    const int begin = group * marine::kFastGroup;
#pragma GCC unroll 4
    for (int i = begin; i < begin + marine::kFastGroup; i += kFloats) {
        const Floats weight = floats_at(table.row(marine::kFastPressure) + i);
#pragma GCC unroll 4
        for (int p = 0; p < marine::kWavePoints; ++p) {
            const Floats h = floats_at(circle + 2 * p * table.padded + i);
            Floats level = falling<By>(table, i, depth[p]);
            if constexpr (By != Falling::alone) level *= middle.of[p][group];
            if constexpr (Bottom) level += floats_at(table.row(marine::kFastBottom) + i) / level;
            to[p] += level * ((1.0F - h * h) * weight);
        }
    }
}

/// Add the pressure of the groups [begin, end) at all points. @param deepest  Depth of the deepest
/// point.
template <bool Bottom>
HAWSER_FAST void add_pressures(const marine::FastTable& table, int begin, int end,
                               const float* circle, const float* depth, float deepest,
                               const GroupPowers& middle, Floats* to) {
    for (int g = begin; g < end; ++g) {
        const float separation = table.width[g] * deepest;
        if (separation <= kNearest)
            add_pressure<Falling::near, Bottom>(table, g, circle, depth, middle, to);
        else if (separation <= kFarthest)
            add_pressure<Falling::far, Bottom>(table, g, circle, depth, middle, to);
        else
            add_pressure<Falling::alone, Bottom>(table, g, circle, depth, middle, to);
    }
}

void fast_pressure(const marine::FastTable& table, const marine::FastExtent* of,
                   const float* circle, const double* depth, int count, double* out) noexcept {
    float down[marine::kWavePoints], deepest = 0.0F;
    const int groups = first_depths(of, depth, count, down);
    int bottom = 0;
    for (int p = 0; p < count; ++p) {
        bottom = of[p].bottom > bottom ? of[p].bottom : bottom;
        deepest = down[p] > deepest ? down[p] : deepest;
    }
    const GroupPowers middle(table.middle, groups, down);
    Floats all[marine::kWavePoints]{};
    add_pressures<true>(table, 0, bottom, circle, down, deepest, middle, all);
    add_pressures<false>(table, bottom, groups, circle, down, deepest, middle, all);
    for (int p = 0; p < count; ++p) out[p] = total_of(all[p]);
}

#undef HAWSER_FAST

}  // namespace

extern const marine::FastWaveKernels kFastWaveKernels;
const marine::FastWaveKernels kFastWaveKernels = {refer, fast_surface, fast_sums, fast_pressure};

}  // namespace hawser::HAWSER_ISA
