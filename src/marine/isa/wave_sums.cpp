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

/// Adding and subtracting it leaves the nearest whole number; its lowest bits are that number.
constexpr double kWhole = 6755399441055744.0;  // 1.5 · 2^52

HAWSER_WAVES Wide wide(double x) { return Wide{} + x; }
HAWSER_WAVES Wide at(const double* p) { return *reinterpret_cast<const Wide*>(p); }
HAWSER_WAVES void put(double* p, Wide v) { *reinterpret_cast<Wide*>(p) = v; }
HAWSER_WAVES Wide nearest(Wide x) { return (x + kWhole) - kWhole; }
HAWSER_WAVES double total(Wide v) {
    double sum = 0.0;
    for (int i = 0; i < kWide; ++i) sum += v[i];
    return sum;
}

/// Coefficients of x^n in sin πx, n = 1, 3, …, and cos πx, n = 0, 2, …: (−1)^m π^n/n!.
constexpr double kSine[] = {
    3.14159265358979323846,    -5.16771278004997002925,    2.55016403987734544386,
    -0.599264529320792076888,  0.0821458866111282287988,   -7.37043094571435077722e-3,
    4.66302805767612564421e-4, -2.19153534478302158274e-5, 7.95205400147551278478e-7};
constexpr double kCosine[] = {1.0,
                              -4.93480220054467930942,
                              4.05871212641676821819,
                              -1.33526276885458949588,
                              0.235330630358893204541,
                              -0.0258068913900140600128,
                              1.92957430940392304790e-3,
                              -1.04638104924845707118e-4,
                              4.30306958703294700729e-6,
                              -1.38789524622137721145e-7};
/// (ln 2)^n/n!.
constexpr double kPower[] = {1.0,
                             0.693147180559945309417,
                             0.240226506959100712333,
                             0.0555041086648215799532,
                             9.61812910762847716197e-3,
                             1.33335581464284434235e-3,
                             1.54035303933816099544e-4,
                             1.52527338040598402800e-5,
                             1.32154867901443094884e-6,
                             1.01780860092396997275e-7,
                             7.05491162080112332988e-9,
                             4.44553827187081149760e-10};

template <int N>
HAWSER_WAVES Wide series(const double (&c)[N], Wide x) {
    Wide y = wide(c[N - 1]);
    for (int i = N - 2; i >= 0; --i) y = y * x + c[i];
    return y;
}

/// 2^x; below 2^−1000 that.
HAWSER_WAVES Wide power(Wide x) {
    x = x > -1000.0 ? x : wide(-1000.0);
    const Wide shifted = x + kWhole, whole = shifted - kWhole;
    const WideBits exponent = (reinterpret_cast<WideBits>(shifted) << 52) + (1023LL << 52);
    return series(kPower, x - whole) * reinterpret_cast<Wide>(exponent);
}

double surface(const double* table, int padded, const double* phase, double x, double y,
               double* circle) noexcept {
    const double *kx = table + marine::kTurnsX * padded, *ky = table + marine::kTurnsY * padded,
                 *a = table + marine::kAmplitude * padded;
    Wide sum{};
    for (int i = 0; i < padded; i += kWide) {
        const Wide turns = at(kx + i) * x + (at(ky + i) * y + at(phase + i));
        const Wide f = turns - nearest(turns), f2 = f * f;
        const Wide half_sine = f * series(kSine, f2), half_cosine = series(kCosine, f2);
        const Wide c = 1.0 - 2.0 * (half_sine * half_sine), s = 2.0 * (half_sine * half_cosine);
        put(circle + i, c);
        put(circle + padded + i, s);
        sum += at(a + i) * c;
    }
    return total(sum);
}

marine::WaveSums sums(const double* table, int padded, const double* circle, double z) noexcept {
    const auto row = [&](int r) { return table + r * padded; };
    const double *decay = row(marine::kDecay), *bottom = row(marine::kBottom);
    const double *gx = row(marine::kSpeedX), *gy = row(marine::kSpeedY), *gz = row(marine::kSpeedZ);
    const double *rate = row(marine::kRate), *weight = row(marine::kPressure);
    Wide ux{}, uy{}, uz{}, ax{}, ay{}, az{}, p{};
    for (int i = 0; i < padded; i += kWide) {
        const Wide up = power(at(decay + i) * z), down = at(bottom + i) / up;
        const Wide c = at(circle + i), s = at(circle + padded + i), w = at(rate + i);
        const Wide level = up + down, steep = up - down;
        const Wide lc = level * c, ls = level * s * w, sc = steep * c * w, ss = steep * s;
        ux += lc * at(gx + i);
        uy += lc * at(gy + i);
        uz += ss * at(gz + i);
        ax += ls * at(gx + i);
        ay += ls * at(gy + i);
        az -= sc * at(gz + i);
        p += lc * at(weight + i);
    }
    return {{total(ux), total(uy), total(uz)}, {total(ax), total(ay), total(az)}, total(p)};
}

double pressure(const double* table, int padded, const double* circle, double z) noexcept {
    const double *decay = table + marine::kDecay * padded,
                 *bottom = table + marine::kBottom * padded;
    const double* weight = table + marine::kPressure * padded;
    Wide p{};
    for (int i = 0; i < padded; i += kWide) {
        const Wide up = power(at(decay + i) * z), down = at(bottom + i) / up;
        const Wide level = up + down, lc = level * at(circle + i);
        p += lc * at(weight + i);
    }
    return total(p);
}

#undef HAWSER_WAVES

}  // namespace

extern const marine::WaveKernels kWaveKernels;
const marine::WaveKernels kWaveKernels = {surface, sums, pressure};

}  // namespace hawser::HAWSER_ISA
