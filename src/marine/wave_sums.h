// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wave_sums.h
/// Sums over the components of waves at a point, compiled once for each instruction set.
///
/// Arrays hold eight components a group; surfaces are summed first, since water is stretched to
/// them. Per component
/// ```
///     f = x k_x/2π + y k_y/2π + phase − (nearest whole number)          turns, in [−½, ½]
///     h = √2 sin πf,   cos 2πf = 1 − h²,   sin 2πf = h · √2 cos πf
///     E = 2^(z' k log₂e),   F = e^(−2kd)/E      cosh, sinh k(z'+d) = ½ e^(kd) (E ± F)
/// ```
/// by polynomials. A hull needs no sine, a deep point few: only what is not left out takes one.
/// sin and cos are within 2e-13 of what the turns say, E and 1/E within 1e-12 of themselves; turns
/// lose as many digits as there are waves between the point and x = y = 0.
///
/// **What is left out.** F of a group in which all are below 2^−54 E, which changes no bit of
/// E ± F, and whole groups in which all E are below 2^−44: of speeds, accelerations and pressures
/// at most 2 · 2^−44 = 1.2e-13 of what their components' amplitudes add up to at the surface, less
/// than E is off. The surface takes all components everywhere.
///
/// Components are summed in an order that depends on the instruction set alone. Points are taken
/// one by one, or kWavePoints at a time: from surface to pressure a point waits for its sum, while
/// others go on.

namespace hawser::marine {

/// Rows of the table, each of `padded` entries; those of padding are 0.
enum WaveRow : int {
    kTurnsX,     ///< k_x/2π [1/m].
    kTurnsY,     ///< k_y/2π [1/m].
    kAmplitude,  ///< a [m].
    kDecay,      ///< k log₂e [1/m].
    kBottom,     ///< e^(−2kd).
    kSpeedX,     ///< a ω k_x/k / (1 − e^(−2kd)) [m/s].
    kSpeedY,
    kSpeedZ,        ///< a ω/(1 − e^(−2kd)) [m/s].
    kRate,          ///< ω [rad/s].
    kPressure,      ///< a ω²/k / (1 − e^(−2kd)), of p/ρ [m²/s²].
    kNothingBelow,  ///< At the first of a group: z' below which all its E are below 2^−44 [m].
    kDeepAbove,     ///< z' above which all its F are below 2^−54 E, all E above 2^−1000 [m].
    kWaveRows
};

/// What components add up to, but for the factor of all amplitudes.
struct WaveSums {
    double u[3];  ///< Velocity [m/s].
    double a[3];  ///< Its ∂/∂t [m/s²].
    double p;     ///< Dynamic pressure over density [m²/s²].
};

/// Points that WaveKernels::many takes.
inline constexpr int kWavePoints = 4;

/// For n points, arrays of n entries.
struct WaveKernel {
    /// Σ a cos θ. @param circle  h and then f of all components, 2 padded entries a point.
    void (*surface)(const double* table, int padded, const double* phase, const double* x,
                    const double* y, double* circle, double* sum) noexcept;
    /// At z' ≤ 0 for what surface() left in `circle`; at −∞ there is nothing.
    void (*sums)(const double* table, int padded, const double* circle, const double* z,
                 WaveSums* out) noexcept;
    /// Its p alone.
    void (*pressure)(const double* table, int padded, const double* circle, const double* z,
                     double* out) noexcept;
};
struct WaveKernels {
    WaveKernel one, many;
};

/// For the instruction set in use.
[[nodiscard]] const WaveKernels& wave_kernels() noexcept;

}  // namespace hawser::marine

namespace hawser::sse2 {
extern const marine::WaveKernels kWaveKernels;
}
namespace hawser::avx2 {
extern const marine::WaveKernels kWaveKernels;
}
namespace hawser::avx512 {
extern const marine::WaveKernels kWaveKernels;
}
