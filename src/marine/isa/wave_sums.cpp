// SPDX-License-Identifier: Apache-2.0
#include "marine/wave_sums.h"

namespace hawser::HAWSER_ISA {
namespace {

#if defined(__AVX512F__)
inline constexpr int kWide = 8;
#elif defined(__AVX2__)
inline constexpr int kWide = 4;
#else
inline constexpr int kWide = 2;
#endif
typedef double Wide __attribute__((vector_size(8 * kWide), aligned(8), may_alias));
typedef long long WideBits __attribute__((vector_size(8 * kWide)));

#define HAWSER_WAVES __attribute__((always_inline)) inline

/// Adding and subtracting this number rounds to the nearest whole number, whose value is in the
/// lowest bits of the sum.
constexpr double kWhole = 6755399441055744.0;  // 1.5 · 2^52

HAWSER_WAVES Wide wide(double x) { return Wide{} + x; }
HAWSER_WAVES Wide at(const double* p) { return *reinterpret_cast<const Wide*>(p); }
HAWSER_WAVES void put(double* p, Wide v) { *reinterpret_cast<Wide*>(p) = v; }
HAWSER_WAVES Wide nearest(Wide x) { return (x + kWhole) - kWhole; }
/// Return the sum of the lanes, computed by halves, which has shorter chains of dependent additions
/// than lane by lane.
HAWSER_WAVES double total(Wide v) {
#if defined(__AVX512F__)
    v += __builtin_shuffle(v, WideBits{4, 5, 6, 7, 0, 1, 2, 3});
    v += __builtin_shuffle(v, WideBits{2, 3, 0, 1, 6, 7, 4, 5});
#elif defined(__AVX2__)
    v += __builtin_shuffle(v, WideBits{2, 3, 0, 1});
#endif
    return v[0] + v[1];
}

/// √2 sin πx by x times a polynomial of x², √2 cos πx by one, on [−½, ½], and 2^x on [−½, ½]: of
/// least largest error (E. Y. Remez, 1934), 5.6e-14, 2.7e-15, and 7.7e-13 of itself.
constexpr double kSine[] = {4.44288293815670089076,   -7.30824949974630486219,
                            3.60647656069062062396,   -0.847487819102954839891,
                            0.116169810675770803476,  -0.0104127661667969753803,
                            6.30990864176938645016e-4};
constexpr double kCosine[] = {1.4142135623730923162,     -6.97886419963747896365,
                              5.73988573482896462511,    -1.88834671327269377006,
                              0.332807709709477096265,   -0.0364959479624694756614,
                              2.72642126754923938611e-3, -1.42011802834944805728e-4};
constexpr double kPower[] = {
    0.999999999999762472387,   0.693147180546513971081,   0.240226506988794009563,
    0.0555041093934254551006,  9.61812854300172890279e-3, 1.33334520613189394721e-3,
    1.54038516781752192946e-4, 1.53097376819832824241e-5, 1.31758699810774136402e-6};
/// 2^x where 2^−x is taken off it: 1.3e-14 of itself, so that nothing goes through the bottom.
constexpr double kBothPowers[] = {1.00000000000001276259,    0.693147180559871003406,
                                  0.24022650695649648308,    0.0555041086686843597865,
                                  9.61812919206783770658e-3, 1.33335576177540377478e-3,
                                  1.54034349477274192129e-4, 1.52529847675855848052e-5,
                                  1.32594056845120586105e-6, 1.01503484135483493477e-7};

template <int N>
HAWSER_WAVES Wide series(const double (&c)[N], Wide x) {
    Wide y = wide(c[N - 1]);
    for (int i = N - 2; i >= 0; --i) y = y * x + c[i];
    return y;
}
/// Evaluate a polynomial that consists of every second coefficient, in powers of x².
template <int First, int N>
HAWSER_WAVES Wide every_second(const double (&c)[N], Wide square) {
    constexpr int kLastCoefficient = N - 1 - (N - 1 - First) % 2;
    Wide y = wide(c[kLastCoefficient]);
    for (int i = kLastCoefficient - 2; i >= First; i -= 2) y = y * square + c[i];
    return y;
}

HAWSER_WAVES Wide scaled(Wide x, WideBits exponent) {
    return reinterpret_cast<Wide>(reinterpret_cast<WideBits>(x) + exponent);
}
/// Return 2^(a b) for a b ≥ −1000.
HAWSER_WAVES Wide power(Wide a, double b) {
    const Wide shifted = a * b + kWhole;
    return scaled(series(kPower, a * b - (shifted - kWhole)), reinterpret_cast<WideBits>(shifted)
                                                                  << 52);
}
/// Compute 2^x and 2^−x; x is limited to at least −1000.
HAWSER_WAVES void powers(Wide x, Wide& up, Wide& down) {
    x = x > -1000.0 ? x : wide(-1000.0);
    const Wide shifted = x + kWhole, rest = x - (shifted - kWhole), square = rest * rest,
               even = every_second<0>(kBothPowers, square),
               odd = rest * every_second<1>(kBothPowers, square);
    const WideBits exponent = reinterpret_cast<WideBits>(shifted) << 52;
    up = scaled(even + odd, exponent);
    down = scaled(even - odd, -exponent);
}

/// Number of components that share bounds of depth, for any length of vectors.
constexpr int kDepthGroup = 8;

template <int N>
void surface(const double* table, int padded, const double* phase, const double* x, const double* y,
             double* circle, double* sum) noexcept {
    const double *kx = table + marine::kTurnsX * padded, *ky = table + marine::kTurnsY * padded,
                 *a = table + marine::kAmplitude * padded;
    Wide all[N]{};
    for (int i = 0; i < padded; i += kWide) {
        const Wide along = at(kx + i), across = at(ky + i), from = at(phase + i), high = at(a + i);
#pragma GCC unroll 8
        for (int p = 0; p < N; ++p) {
            const Wide turns = along * x[p] + (across * y[p] + from);
            const Wide f = turns - nearest(turns), h = f * series(kSine, f * f);
            double* const to = circle + 2 * p * padded + i;
            put(to, h);
            put(to + padded, f);
            all[p] += high * (1.0 - h * h);
        }
    }
    for (int p = 0; p < N; ++p) sum[p] = total(all[p]);
}

template <int N>
void sums(const double* table, int padded, const double* circle, const double* z,
          marine::WaveSums* out) noexcept {
    const auto row = [&](int r) { return table + r * padded; };
    const double *decay = row(marine::kDecay), *bottom = row(marine::kBottom);
    const double *gx = row(marine::kSpeedX), *gy = row(marine::kSpeedY), *gz = row(marine::kSpeedZ);
    const double *rate = row(marine::kRate), *weight = row(marine::kPressure);
    const double *nothing = row(marine::kNothingBelow), *deep = row(marine::kDeepAbove);
    for (int p = 0; p < N; ++p) {
        const double* const from = circle + 2 * p * padded;
        Wide ux{}, uy{}, uz{}, ax{}, ay{}, az{}, all{};
        for (int g = 0; g < padded; g += kDepthGroup) {
            if (!(z[p] > nothing[g])) continue;
            const bool no_bottom = z[p] > deep[g];
#pragma GCC unroll 4
            for (int i = g; i < g + kDepthGroup; i += kWide) {
                const Wide h = at(from + i), f = at(from + padded + i), w = at(rate + i);
                const Wide c = 1.0 - h * h, s = h * series(kCosine, f * f);
                Wide lc, ls, sc, ss;
                if (no_bottom) {
                    const Wide up = power(at(decay + i), z[p]);
                    lc = sc = up * c;
                    ls = ss = up * s;
                } else {
                    Wide up, down;
                    powers(at(decay + i) * z[p], up, down);
                    down *= at(bottom + i);
                    const Wide level = up + down, steep = up - down;
                    lc = level * c;
                    ls = level * s;
                    sc = steep * c;
                    ss = steep * s;
                }
                ls *= w;
                sc *= w;
                ux += lc * at(gx + i);
                uy += lc * at(gy + i);
                uz += ss * at(gz + i);
                ax += ls * at(gx + i);
                ay += ls * at(gy + i);
                az -= sc * at(gz + i);
                all += lc * at(weight + i);
            }
        }
        out[p] = {{total(ux), total(uy), total(uz)}, {total(ax), total(ay), total(az)}, total(all)};
    }
}

template <int N>
void pressure(const double* table, int padded, const double* circle, const double* z,
              double* out) noexcept {
    const double *decay = table + marine::kDecay * padded,
                 *bottom = table + marine::kBottom * padded,
                 *weight = table + marine::kPressure * padded;
    const double *nothing = table + marine::kNothingBelow * padded,
                 *deep = table + marine::kDeepAbove * padded;
    for (int p = 0; p < N; ++p) {
        const double* const from = circle + 2 * p * padded;
        Wide all{};
        for (int g = 0; g < padded; g += kDepthGroup) {
            if (!(z[p] > nothing[g])) continue;
            const bool no_bottom = z[p] > deep[g];
#pragma GCC unroll 4
            for (int i = g; i < g + kDepthGroup; i += kWide) {
                const Wide h = at(from + i);
                Wide level;
                if (no_bottom) {
                    level = power(at(decay + i), z[p]);
                } else {
                    Wide up, down;
                    powers(at(decay + i) * z[p], up, down);
                    level = up + at(bottom + i) * down;
                }
                all += level * (1.0 - h * h) * at(weight + i);
            }
        }
        out[p] = total(all);
    }
}

template <int N>
constexpr marine::WaveKernel kernel_of() {
    return {surface<N>, sums<N>, pressure<N>};
}

#undef HAWSER_WAVES

}  // namespace

extern const marine::WaveKernels kWaveKernels;
const marine::WaveKernels kWaveKernels = {kernel_of<1>(), kernel_of<marine::kWavePoints>()};

}  // namespace hawser::HAWSER_ISA
