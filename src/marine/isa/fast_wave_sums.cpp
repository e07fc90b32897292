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
HAWSER_FAST Floats with_sign(Floats x, FloatBits sign) {
    return reinterpret_cast<Floats>(reinterpret_cast<FloatBits>(x) ^ sign);
}

/// Vector of four lanes in single precision, for sums of several vectors at once.
typedef float Four __attribute__((vector_size(16)));
typedef int FourBits __attribute__((vector_size(16)));

/// Return the sum of the groups of four lanes of a vector.
HAWSER_FAST Four quarters_of(Floats v) {
#if defined(__AVX512F__)
    return (__builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7)) +
           (__builtin_shufflevector(v, v, 8, 9, 10, 11) +
            __builtin_shufflevector(v, v, 12, 13, 14, 15));
#elif defined(__AVX2__)
    return __builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7);
#else
    return v;
#endif
}
/// Return the sums of the lanes of four vectors.
HAWSER_FAST Four totals_of(Floats a, Floats b, Floats c, Floats d) {
    const Four p = quarters_of(a), q = quarters_of(b), r = quarters_of(c), s = quarters_of(d);
    const Four pq = __builtin_shuffle(p, q, FourBits{0, 4, 1, 5}) +
                    __builtin_shuffle(p, q, FourBits{2, 6, 3, 7});
    const Four rs = __builtin_shuffle(r, s, FourBits{0, 4, 1, 5}) +
                    __builtin_shuffle(r, s, FourBits{2, 6, 3, 7});
    return __builtin_shuffle(pq, rs, FourBits{0, 1, 4, 5}) +
           __builtin_shuffle(pq, rs, FourBits{2, 3, 6, 7});
}

/// Polynomials on [−½, ½]: cos πx as a polynomial of x², sin πx as x times one, and 2^x.
constexpr float kFastCosine[] = {1.0F, -4.93479538F, 4.05844736F, -1.33206248F, 0.22000809F};
constexpr float kFastSine[] = {3.1415925F, -5.1677022F, 2.54995775F, -0.597625375F, 0.0764338076F};
constexpr float kFastPower[] = {1.00000000055F,    0.693147205736F,   0.240226468912F,
                                0.0555032877851F,  0.00961848889795F, 0.00133999307896F,
                                0.000153458273815F};

/// Polynomials of e^x by degree, on [−b, b] with b of kFastRange: errors of at most 1e-7 of e^x.
constexpr float kFastExp2[] = {1.0F, 1.00001252F, 0.500002086F};
constexpr float kFastExp3[] = {1.0F, 1.00000024F, 0.500124276F, 0.166601315F};
constexpr float kFastExp4[] = {1.0F, 0.999998391F, 0.500001371F, 0.166928843F, 0.0416344032F};
constexpr float kFastExp5[] = {1.0F,         0.999999702F,  0.499991149F,
                               0.166676417F, 0.0419025794F, 0.00829142891F};
constexpr float kFastExp6[] = {1.0F,          1.00000072F,    0.499998391F,  0.166647032F,
                               0.0416793451F, 0.00845267624F, 0.00137372408F};
constexpr float kFastExp7[] = {1.0F,          1.00000036F,    0.500002086F,   0.166662619F,
                               0.0416497998F, 0.00834293105F, 0.00142655708F, 0.000194116597F};
constexpr int kLowestDegree = 2, kHighestDegree = 7;
constexpr float kFastRange[] = {0.01F, 0.06F, 0.16F, 0.35F, 0.6F, 0.9F};

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

void refer(const double* rows, int padded, int groups, double x, double y, float* phase) noexcept {
    const double *kx = rows + marine::kReferenceX * padded,
                 *ky = rows + marine::kReferenceY * padded,
                 *from = rows + marine::kReferencePhase * padded;
    for (int i = 0; i < groups * marine::kFastGroup; ++i) {
        const double turns = kx[i] * x + (ky[i] * y + from[i]);
        phase[i] =
            static_cast<float>(2.0 * (turns - ((turns + kFastWholeDouble) - kFastWholeDouble)));
    }
}

/// Compute a cos(phase) of each component at all points of a batch, and the sum, which is the
/// elevation.
/// @tparam Sines  True: also store f, from which add_group() computes sines.
template <bool Sines>
HAWSER_FAST void surface_of(const marine::FastTable& table, int groups, const float* phase,
                            const float* dx, const float* dy, float* circle, double* sum) {
    constexpr int kPoints = marine::kWavePoints;
    const int padded = table.padded;
    const float *kx = table.row(marine::kFastPhaseX), *ky = table.row(marine::kFastPhaseY),
                *a = table.row(marine::kFastAmplitude);
    Floats all[kPoints]{};
    for (int i = 0; i < groups * marine::kFastGroup; i += kFloats) {
        const Floats along = floats_at(kx + i), across = floats_at(ky + i),
                     from = floats_at(phase + i), high = floats_at(a + i);
#pragma GCC unroll 4
        for (int p = 0; p < kPoints; ++p) {
            // n half-turns and f in [−½, ½] of one: cos π(n + f) = (−1)^n cos πf.
            const Floats t = along * dx[p] + (across * dy[p] + from), shifted = t + kFastWhole,
                         f = t - (shifted - kFastWhole);
            const FloatBits sign = reinterpret_cast<FloatBits>(shifted) << 31;
            const Floats c = with_sign(high, sign) * fast_series(kFastCosine, f * f);
            float* const to = circle + 2 * p * padded + i;
            put_floats(to, c);
            if constexpr (Sines) put_floats(to + padded, with_sign(f, sign));
            all[p] += c;
        }
    }
    static_assert(kPoints == 4);
    const Four sums = totals_of(all[0], all[1], all[2], all[3]);
    for (int p = 0; p < kPoints; ++p) sum[p] = static_cast<double>(sums[p]);
}
void fast_surface(const marine::FastTable& table, int groups, const float* phase, const float* dx,
                  const float* dy, float* circle, double* sum) noexcept {
    surface_of<true>(table, groups, phase, dx, dy, circle, sum);
}
void fast_elevation(const marine::FastTable& table, int groups, const float* phase, const float* dx,
                    const float* dy, float* circle, double* sum) noexcept {
    surface_of<false>(table, groups, phase, dx, dy, circle, sum);
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

/// Return the decay e^(−k ζ) with depth of the wave components from i on, divided by the value in
/// the middle of their group.
/// @tparam Degree  Degree of the polynomial. Above kHighestDegree each component is computed by
/// 2^x, without division by the middle.
template <int Degree>
HAWSER_FAST Floats decay_factor(const marine::FastTable& table, int i, float depth) {
    if constexpr (Degree > kHighestDegree)
        return fast_power(floats_at(table.row(marine::kFastDecay) + i) * depth);
    const Floats x = floats_at(table.row(marine::kFastOffset) + i) * depth;
    if constexpr (Degree == 2) return fast_series(kFastExp2, x);
    if constexpr (Degree == 3) return fast_series(kFastExp3, x);
    if constexpr (Degree == 4) return fast_series(kFastExp4, x);
    if constexpr (Degree == 5) return fast_series(kFastExp5, x);
    if constexpr (Degree == 6) return fast_series(kFastExp6, x);
    return fast_series(kFastExp7, x);
}

/// A degree as a type.
template <int Degree>
struct DegreeOf {
    static constexpr int value = Degree;
};
/// Call f with the smallest degree that is valid for |x| ≤ `most`, as DegreeOf.
template <int Degree = kLowestDegree, class F>
HAWSER_FAST void by_degree(float most, const F& f) {
    if constexpr (Degree > kHighestDegree) {
        f(DegreeOf<Degree>{});
    } else {
        if (most <= kFastRange[Degree - kLowestDegree]) return f(DegreeOf<Degree>{});
        by_degree<Degree + 1>(most, f);
    }
}

struct FastSums {
    Floats u[3]{}, a[3]{};
};

/// Add the contribution of one group of components. @tparam Bottom  True: include the mirror image
/// below the bottom. @param middle  e^(−k ζ) of the group's middle.
template <int Degree, bool Bottom>
HAWSER_FAST void add_group(const marine::FastTable& table, int group, const float* circle,
                           float depth, float middle, FastSums& to) {
    const int begin = group * marine::kFastGroup;
#pragma GCC unroll 4
    for (int i = begin; i < begin + marine::kFastGroup; i += kFloats) {
        const auto at = [&](marine::FastRow r)
                            __attribute__((always_inline)) { return floats_at(table.row(r) + i); };
        const Floats c = floats_at(circle + i), f = floats_at(circle + table.padded + i);
        const Floats s = f * fast_series(kFastSine, f * f);
        Floats up = decay_factor<Degree>(table, i, depth);
        if constexpr (Degree <= kHighestDegree) up *= middle;
        Floats level = up, steep = up;
        if constexpr (Bottom) {
            const Floats down = at(marine::kFastBottom) / up;
            level += down;
            steep -= down;
        }
        const Floats lc = level * c, ls = level * s, sc = Bottom ? steep * c : lc,
                     ss = Bottom ? steep * s : ls;
        to.u[0] += lc * at(marine::kFastSpeedX);
        to.u[1] += lc * at(marine::kFastSpeedY);
        to.u[2] += ss * at(marine::kFastSpeedZ);
        to.a[0] += ls * at(marine::kFastRateX);
        to.a[1] += ls * at(marine::kFastRateY);
        to.a[2] -= sc * at(marine::kFastRateZ);
    }
}

/// Add the contributions of the groups [begin, end) at one point.
template <bool Bottom>
HAWSER_FAST void add_groups(const marine::FastTable& table, int begin, int end, const float* circle,
                            float depth, const float* middle, FastSums& to) {
    for (int g = begin; g < end; ++g)
        by_degree(table.width[g] * depth, [&](auto degree) __attribute__((always_inline)) {
            add_group<decltype(degree)::value, Bottom>(table, g, circle, depth, middle[g], to);
        });
}

/// Convert depths to single precision. Slots beyond `count` repeat the last depth.
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
        const Four first = totals_of(all.u[0], all.u[1], all.u[2], all.a[0]),
                   second = totals_of(all.a[1], all.a[2], Floats{}, Floats{});
        for (int k = 0; k < 3; ++k) out[p].u[k] = static_cast<double>(first[k]);
        out[p].a[0] = static_cast<double>(first[3]);
        out[p].a[1] = static_cast<double>(second[0]);
        out[p].a[2] = static_cast<double>(second[1]);
        out[p].p = 0.0;
    }
}

/// Add the pressure of one group at all points of a batch.
template <int Degree, bool Bottom>
HAWSER_FAST void add_pressure(const marine::FastTable& table, int group, const float* circle,
                              const float* depth, const GroupPowers& middle, Floats* to) {
    const int begin = group * marine::kFastGroup;
    constexpr bool kOver = Degree <= kHighestDegree && !Bottom;  // over the middle, until the end
    Floats part[marine::kWavePoints]{};
#pragma GCC unroll 4
    for (int i = begin; i < begin + marine::kFastGroup; i += kFloats) {
#pragma GCC unroll 4
        for (int p = 0; p < marine::kWavePoints; ++p) {
            const Floats c = floats_at(circle + 2 * p * table.padded + i);
            Floats level = decay_factor<Degree>(table, i, depth[p]);
            if constexpr (Bottom) {
                if constexpr (Degree <= kHighestDegree) level *= middle.of[p][group];
                level += floats_at(table.row(marine::kFastBottom) + i) / level;
                level *= floats_at(table.row(marine::kFastPressure) + i);
            }
            part[p] += level * c;
        }
    }
#pragma GCC unroll 4
    for (int p = 0; p < marine::kWavePoints; ++p)
        to[p] += kOver ? middle.of[p][group] * part[p] : part[p];
}

/// Add the pressure of the groups [begin, end) at all points. @param deepest  Depth of the deepest
/// point.
template <bool Bottom>
HAWSER_FAST void add_pressures(const marine::FastTable& table, int begin, int end,
                               const float* circle, const float* depth, float deepest,
                               const GroupPowers& middle, Floats* to) {
    for (int g = begin; g < end; ++g)
        by_degree(table.width[g] * deepest, [&](auto degree) __attribute__((always_inline)) {
            add_pressure<decltype(degree)::value, Bottom>(table, g, circle, depth, middle, to);
        });
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
    static_assert(marine::kWavePoints == 4);
    const Four sums = totals_of(all[0], all[1], all[2], all[3]);
    for (int p = 0; p < count; ++p) out[p] = table.gravity * static_cast<double>(sums[p]);
}

#undef HAWSER_FAST

}  // namespace

extern const marine::FastWaveKernels kFastWaveKernels;
const marine::FastWaveKernels kFastWaveKernels = {refer, fast_surface, fast_elevation, fast_sums,
                                                  fast_pressure};

}  // namespace hawser::HAWSER_ISA
