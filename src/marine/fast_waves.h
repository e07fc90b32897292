// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file fast_waves.h
/// Tables and error bounds of the sums in single precision (fast_wave_sums.h); derivation in
/// docs/theory/waves.md.
///
/// Errors are relative to significant amplitudes: twice the standard deviation of elevation,
/// velocity, acceleration and pressure at still water. Each of three parts has its share of
/// kKinematicTolerance:
///
/// 1. **Components left out.** Groups from G on are left out at a depth ζ where
///    Σ A_n (e^(−k_n ζ) + e^(−k_n (2d − ζ))) of all their components is at most 1/8 of the
///    tolerance. A point that is certainly under water may also leave groups out of the elevation
///    that stretches its column, where the change of z' by that has the same bound.
/// 2. **Phases.** A cluster of points is at most as wide as six standard deviations of the rounding
///    of phases allow for 3/8 of the tolerance.
/// 3. **Polynomials, products and sums** take the rest.

#include <hawser/sea.h>

#include "base/memory.h"
#include "marine/fast_wave_sums.h"

#include <span>
#include <vector>

namespace hawser::marine {

/// Error of kinematics in a step, over the significant amplitude.
inline constexpr double kKinematicTolerance = 1e-5;

/// Significant amplitudes at still water.
struct SignificantMotion {
    double elevation = 0.0;     ///< Hs/2 [m].
    double velocity = 0.0;      ///< [m/s].
    double acceleration = 0.0;  ///< [m/s²].
    double pressure = 0.0;      ///< Over density [m²/s²].
};

class FastWaves {
  public:
    /// Components up to which double precision costs less.
    static constexpr int kFewComponents = 16;

    FastWaves(std::span<const WaveComponent> waves, double depth);

    /// False: use sums in double precision.
    [[nodiscard]] bool on() const noexcept { return padded_ > 0; }
    /// Phases of a moment, by component of the sea.
    void begin(std::span<const double> phase) noexcept;
    [[nodiscard]] int padded() const noexcept { return padded_; }
    [[nodiscard]] int groups() const noexcept { return padded_ / kFastGroup; }
    [[nodiscard]] FastTable table() const noexcept {
        return {table_.data(), middle_.data(), width_.data(), padded_};
    }
    [[nodiscard]] const double* reference() const noexcept { return reference_.data(); }
    /// Largest distance of a point from its reference, of points that take some first groups [m].
    [[nodiscard]] double reach(int first) const noexcept {
        return reach_[static_cast<std::size_t>(first)];
    }
    [[nodiscard]] double reach() const noexcept { return on() ? reach_.back() : 0.0; }
    /// Σ a: no surface is further from still water [m].
    [[nodiscard]] double highest() const noexcept { return highest_; }
    /// Groups that kinematics take at z' = −depth.
    [[nodiscard]] const FastExtent& extent(double depth) const noexcept {
        const double row = depth * rows_per_metre_;
        return extents_[row < kExtents - 1 ? static_cast<std::size_t>(row) : kExtents - 1];
    }
    /// Groups that stretch a column, for points at z' = −depth and below that are under water.
    [[nodiscard]] int stretching_groups(double depth) const noexcept {
        return extent(depth).stretching;
    }
    [[nodiscard]] const FastWaveKernels& kernels() const noexcept { return *kernels_; }
    [[nodiscard]] const SignificantMotion& significant() const noexcept { return significant_; }

  private:
    void sort(std::span<const WaveComponent> waves);
    void fill_tables();
    void find_depths();
    void list_extents();
    [[nodiscard]] double reach_of(std::size_t components) const;

    static constexpr std::size_t kExtents = 1024;

    double sea_depth_;
    int padded_ = 0;
    const FastWaveKernels* kernels_;
    double rows_per_metre_ = 0.0;
    double highest_ = 0.0;
    std::vector<double> reach_;         ///< By number of groups.
    std::vector<std::size_t> order_;    ///< Components by ascending wave number.
    std::vector<WaveComponent> waves_;  ///< In this order.
    base::Array<float> table_, middle_, width_;
    base::Array<double> reference_;
    /// By group: depth from which it and all behind it are left out, and lowest wave number.
    std::vector<double> below_, stretch_below_, lowest_;
    std::vector<FastExtent> extents_;  ///< By depth: valid from one row to the next.
    SignificantMotion significant_;
};

}  // namespace hawser::marine
