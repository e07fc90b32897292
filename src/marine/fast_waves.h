// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file fast_waves.h
/// Build tables and error bounds of the sums in single precision (fast_wave_sums.h).
/// docs/theory/waves.md has the derivation.
///
/// Errors are relative to significant amplitudes at still water: twice the standard deviation of
/// elevation, velocity, acceleration and pressure. Three sources have a fraction of
/// kKinematicTolerance each:
///
/// 1. **Omitted components.** At a depth ζ, groups from G on are omitted if Σ A_n (e^(−k_n ζ) +
///   e^(−k_n (2d − ζ))) of all their components is at most 1/8 of the tolerance. For a point that
///   is certainly under water, groups may also be omitted from the elevation that stretches its
///   column. The change of z' then has the same bound.
/// 2. **Phases.** The width of a cluster of points is limited: six standard deviations of the
///   rounding of phases are at most 3/8 of the tolerance.
/// 3. **Polynomials, products and sums** have the rest of the tolerance.

#include <hawser/sea.h>

#include "base/memory.h"
#include "marine/fast_wave_sums.h"

#include <span>
#include <vector>

namespace hawser::marine {

/// Error of velocity and acceleration in a step, relative to the significant amplitude.
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
    /// Number of components up to which double precision costs less.
    static constexpr int kFewComponents = 16;

    FastWaves(std::span<const WaveComponent> waves, double depth);

    /// True if sums in single precision are in use.
    [[nodiscard]] bool on() const noexcept { return padded_ > 0; }
    /// Set the phases of all wave components at the time of the step.
    void begin(std::span<const double> phase) noexcept;
    [[nodiscard]] int padded() const noexcept { return padded_; }
    [[nodiscard]] int groups() const noexcept { return padded_ / kFastGroup; }
    [[nodiscard]] FastTable table() const noexcept {
        return {table_.data(), middle_.data(), width_.data(), padded_, gravity_};
    }
    [[nodiscard]] const double* reference() const noexcept { return reference_.data(); }
    /// Return the largest distance of a point from its reference point at which single precision is
    /// accurate enough, if the point uses the first `first` groups of waves [m].
    [[nodiscard]] double reach(int first) const noexcept {
        return reach_[static_cast<std::size_t>(first)];
    }
    [[nodiscard]] double reach() const noexcept { return on() ? reach_.back() : 0.0; }
    /// Return the sum of all amplitudes, an upper bound of the elevation [m].
    [[nodiscard]] double highest() const noexcept { return highest_; }
    /// Return the range of wave groups that must be summed for velocity and acceleration at the
    /// depth `depth`.
    [[nodiscard]] const FastExtent& extent(double depth) const noexcept {
        const double row = depth * rows_per_metre_;
        return extents_[row < kExtentRows - 1 ? static_cast<std::size_t>(row) : kExtentRows - 1];
    }
    /// Return the number of groups to sum for the elevation above points under water at z' = −depth
    /// or deeper.
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

    static constexpr std::size_t kExtentRows = 1024;

    double sea_depth_;
    int padded_ = 0;
    const FastWaveKernels* kernels_;
    double rows_per_metre_ = 0.0;
    double highest_ = 0.0;
    double gravity_ = 0.0;
    std::vector<double> reach_;  ///< Largest distance from the reference by number of groups [m].
    std::vector<std::size_t> order_;    ///< Components by ascending wave number.
    std::vector<WaveComponent> waves_;  ///< In this order.
    base::Array<float> table_, middle_, width_;
    base::Array<double> reference_;
    /// Depth below which a group and all later groups are left out, and their lowest wave number,
    /// by group.
    std::vector<double> below_, stretch_below_, lowest_;
    std::vector<FastExtent> extents_;  ///< By depth: valid from one row to the next.
    SignificantMotion significant_;
};

}  // namespace hawser::marine
