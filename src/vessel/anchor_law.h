// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file anchor_law.h
/// Compute the holding capacity of a drag-embedment anchor (hawser/anchor.h).

#include <hawser/anchor.h>

#include <vector>

namespace hawser::vessel {

/// Capacity as a function of drag distance and line angle. The definition must have no open
/// defaults.
class AnchorCapacity {
  public:
    explicit AnchorCapacity(const AnchorDef& def);

    /// Return the strength at a drag distance: UHC g(x), or T of the trajectory [N].
    [[nodiscard]] double strength_at(double drag) const noexcept;
    /// Return the depth of the point below the seabed [m].
    [[nodiscard]] double depth(double drag) const noexcept;
    /// Return the reduction of the capacity by the angle of the line, in the soil [1].
    [[nodiscard]] double line_factor(double drag, double angle) const noexcept;
    /// Return H(x, θ) [N].
    [[nodiscard]] double capacity(double drag, double angle) const noexcept;

  private:
    void integrate();
    [[nodiscard]] double pull_at(double z) const noexcept;
    [[nodiscard]] double bearing_above(double z) const noexcept;
    [[nodiscard]] double slope_at(double z) const noexcept;

    AnchorDef def_;
    std::vector<double> depth_;  ///< z at multiples of kStep; empty: exponential law.
};

}  // namespace hawser::vessel
