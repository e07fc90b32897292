// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wave_sums.h
/// Sums over the components of waves at a point, compiled once for each instruction set.
///
/// Arrays hold eight components a vector; a surface is summed first, since water is stretched to
/// it. Per component
/// ```
///     f = x k_x/2π + y k_y/2π + phase − (nearest whole number)          turns, in [−½, ½]
///     s, c = sin, cos of 2πf by polynomials of sin, cos of πf, doubled
///     E = 2^(z' k log₂e),   F = e^(−2kd)/E      cosh, sinh k(z'+d) = ½ e^(kd) (E ± F)
/// ```
/// sin and cos are within 1e-12 of what the turns say, E within 2e-13 of itself; turns lose as many
/// digits as there are waves between the point and x = y = 0. Components are summed in an order
/// that depends on the instruction set alone.

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
    kSpeedZ,    ///< a ω/(1 − e^(−2kd)) [m/s].
    kRate,      ///< ω [rad/s].
    kPressure,  ///< a ω²/k / (1 − e^(−2kd)), of p/ρ [m²/s²].
    kWaveRows
};

/// What components add up to, but for the factor of all amplitudes.
struct WaveSums {
    double u[3];  ///< Velocity [m/s].
    double a[3];  ///< Its ∂/∂t [m/s²].
    double p;     ///< Dynamic pressure over density [m²/s²].
};

struct WaveKernels {
    /// Σ a cos θ. @param circle  cos θ and then sin θ of all components, 2 padded entries.
    double (*surface)(const double* table, int padded, const double* phase, double x, double y,
                      double* circle) noexcept;
    /// At z' ≤ 0 for what surface() left in `circle`.
    WaveSums (*sums)(const double* table, int padded, const double* circle, double z) noexcept;
    /// Its p alone, the same bits.
    double (*pressure)(const double* table, int padded, const double* circle, double z) noexcept;
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
