// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wave_sums.h
/// Sum over the components of waves at a point, compiled once for each instruction set.
///
/// Arrays have groups of eight components. Surfaces are summed first, because they define the
/// stretched z' of the water. For each component
/// ```
///     f = x k_x/2π + y k_y/2π + phase − (nearest whole number)          turns, in [−½, ½]
///     h = √2 sin πf,   cos 2πf = 1 − h²,   sin 2πf = h · √2 cos πf
///     E = 2^(z' k log₂e),   F = e^(−2kd)/E      cosh, sinh k(z'+d) = ½ e^(kd) (E ± F)
/// ```
/// are computed by polynomials. A hull needs no sine. A deep point needs few, because omitted
/// components need none. sin and cos are accurate to 2e-13 for given turns, E and 1/E to a relative
/// 1e-12. Turns lose as many digits as there are waves between the point and x = y = 0.
///
/// **Omitted components.** F of a group is omitted if all its F are below 2^−54 E, which changes
/// no bit of E ± F. Whole groups are omitted if all their E are below 2^−44. The error of
/// velocity, acceleration and pressure is then at most 2 · 2^−44 = 1.2e-13 of the sum of amplitudes
/// at the surface, less than the error of E. The surface uses all components everywhere.
///
/// The order of sums depends on the instruction set only. Points are processed one by one, or
/// kWavePoints at a time, so that the operations of other points fill the time in which one point
/// waits for the sum of its surface.

namespace hawser::marine {

/// Rows of the table, each of `padded` entries; padding is 0.
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
    kNothingBelow,  ///< For the first of a group: z' below which all its E are below 2^−44 [m].
    kDeepAbove,     ///< z' above which all its F are below 2^−54 E, all E above 2^−1000 [m].
    kWaveRows
};

/// Sums over components, without the common factor of amplitudes.
struct WaveSums {
    double u[3];  ///< Velocity [m/s].
    double a[3];  ///< Its ∂/∂t [m/s²].
    double p;     ///< Dynamic pressure over density [m²/s²].
};

/// Number of points of WaveKernels::many.
inline constexpr int kWavePoints = 4;

/// Kernels for n points; arrays have n entries.
struct WaveKernel {
    /// Compute Σ a cos θ. @param circle  Output: h and then f of all components, 2 × padded entries
    /// per point.
    void (*surface)(const double* table, int padded, const double* phase, const double* x,
                    const double* y, double* circle, double* sum) noexcept;
    /// Compute velocity and acceleration at z' ≤ 0 from `circle` of surface(); zero at z' = −∞.
    void (*sums)(const double* table, int padded, const double* circle, const double* z,
                 WaveSums* out) noexcept;
    /// Compute the pressure p only.
    void (*pressure)(const double* table, int padded, const double* circle, const double* z,
                     double* out) noexcept;
};
struct WaveKernels {
    WaveKernel one, many;
};

/// Return the kernels for the instruction set in use.
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
