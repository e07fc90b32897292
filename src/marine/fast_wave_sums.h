// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file fast_wave_sums.h
/// Sums over the components of waves in single precision, compiled once for each instruction set.
///
/// Formulas are those of wave_sums.h. Three things differ:
///
/// - **Phases** are computed in double precision at one reference point of a cluster of points, and
///   reduced to [−1, 1] half-turns. A point of the cluster adds k_x dx/π + k_y dy/π in single
///   precision, so that the error grows with the size of the cluster, not with the distance from
///   the origin. With n half-turns and a rest f in [−½, ½], cos θ = (−1)^n cos πf.
/// - **Components are sorted** by wave number, in groups of kFastGroup. A point takes the first
///   groups alone; fast_waves.h derives from its depth how many.
/// - **Polynomials** (E. Y. Remez, 1934) have errors of single precision: cos πf and sin πf of
///   degree 8 and 9, 5e-8 and 8e-9; 2^x of degree 6, 2e-9 of itself.
/// - **Decay**: e^(−kζ) is that of the middle of a group times e^x. The degree of its polynomial, 2
///   to 7, follows from the largest |x| of the group: the error is 1e-7 of e^x.
/// - **Pressure** over density is g Σ (e^(−kζ) + e^(−2kd + kζ)) a cos θ/(1 + e^(−2kd)), because
///   ω² = g k tanh kd. Its terms are those of the elevation.
///
/// Sums are taken in an order that depends on the instruction set alone.

#include "marine/wave_sums.h"

namespace hawser::marine {

/// Number of components of a group: one vector of AVX-512, two of AVX2.
inline constexpr int kFastGroup = 16;
/// Number of groups of the largest sea, padded to a vector of AVX-512.
inline constexpr int kMaxFastGroups = 32;

/// Rows of the table in single precision, each of `padded` entries; padding is 0.
enum FastRow : int {
    kFastPhaseX,  ///< k_x/π [1/m].
    kFastPhaseY,
    kFastAmplitude,  ///< a [m].
    kFastDecay,      ///< −k log₂e [1/m].
    kFastOffset,     ///< −(k − k of the middle of its group) [1/m].
    kFastBottom,     ///< e^(−2kd).
    kFastPressure,   ///< 1/(1 + e^(−2kd)).
    // Factors of a cos θ:
    kFastSpeedX,  ///< ω k_x/k / (1 − e^(−2kd)) [1/s].
    kFastSpeedY,
    kFastRateZ,  ///< ω²/(1 − e^(−2kd)) [1/s²].
    // Factors of sin θ:
    kFastSpeedZ,  ///< a ω/(1 − e^(−2kd)) [m/s].
    kFastRateX,   ///< a ω² k_x/k / (1 − e^(−2kd)) [m/s²].
    kFastRateY,
    kFastRows
};

/// Rows in double precision, for references.
enum FastReferenceRow : int { kReferenceX, kReferenceY, kReferencePhase, kReferenceRows };

/// Numbers of leading groups to sum at a depth.
struct FastExtent {
    int groups = 0;      ///< That kinematics take.
    int bottom = 0;      ///< Number of leading groups that the bottom changes.
    int stretching = 0;  ///< Groups for the elevation of points under water; at least `groups`.
};

/// Table in single precision.
struct FastTable {
    const float* rows;    ///< kFastRows of `padded`.
    const float* middle;  ///< −k log₂e of the middle of each group, kMaxFastGroups [1/m].
    const float* width;   ///< Largest |k − k of the middle| of each group [1/m].
    int padded;
    double gravity;  ///< g = ω²/(k tanh kd) of every component [m/s²].

    [[nodiscard]] const float* row(FastRow r) const noexcept { return rows + r * padded; }
};

struct FastWaveKernels {
    /// Compute the phases of the leading groups at (x, y), in half-turns reduced to [−1, 1]. @param
    /// rows  kReferenceRows rows of `padded` entries, in turns.
    void (*refer)(const double* rows, int padded, int groups, double x, double y,
                  float* phase) noexcept;
    /// Compute Σ a cos θ of the leading groups at kWavePoints points. @param dx, dy  Distances from
    /// the reference [m]. @param circle  Output: a cos θ, then (−1)^n f of each component, 2 ×
    /// padded entries per point.
    void (*surface)(const FastTable& table, int groups, const float* phase, const float* dx,
                    const float* dy, float* circle, double* sum) noexcept;
    /// Same as surface(), but leave the second half of `circle` of each point as it is.
    void (*elevation)(const FastTable& table, int groups, const float* phase, const float* dx,
                      const float* dy, float* circle, double* sum) noexcept;
    /// Compute velocity and acceleration at 1 to kWavePoints points. @param circle  Output of
    /// surface(). @param depth  −z' ≥ 0 of each point. The pressures of `out` are set to 0.
    void (*sums)(const FastTable& table, const FastExtent* of, const float* circle,
                 const double* depth, int count, WaveSums* out) noexcept;
    /// Compute dynamic pressure over density at 1 to kWavePoints points. @param circle  Output of
    /// surface() or elevation().
    void (*pressure)(const FastTable& table, const FastExtent* of, const float* circle,
                     const double* depth, int count, double* out) noexcept;
};

/// Return the kernels for the instruction set in use.
[[nodiscard]] const FastWaveKernels& fast_wave_kernels() noexcept;

}  // namespace hawser::marine

namespace hawser::sse2 {
extern const marine::FastWaveKernels kFastWaveKernels;
}
namespace hawser::avx2 {
extern const marine::FastWaveKernels kFastWaveKernels;
}
namespace hawser::avx512 {
extern const marine::FastWaveKernels kFastWaveKernels;
}
