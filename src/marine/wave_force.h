// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wave_force.h
/// Compute wave forces on a hull from coefficients: first order, mean and slow drift, and the slow
/// position at which they act (hawser/water_hull.h, hawser/hydro.h).

#include <hawser/sea.h>

#include "marine/radiation.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::marine {

class WaveForce {
  public:
    WaveForce() = default;
    /// Create the wave force of a hull.
    /// @throws DefError if the table lacks a direction of the waves at this heading.
    WaveForce(const WaterHull& def, const Sea& sea, double step, double heading);

    [[nodiscard]] bool any() const noexcept { return force_ || drift_; }
    /// Filter position and heading of the hull, to obtain the slowly varying part. @param x, y
    /// Position of the reference [m]. @param heading  Heading of the body [rad].
    void follow(double x, double y, double heading) noexcept;
    /// Compute the wave force at the reference point, in axes of the slowly varying heading.
    /// @return false if the table lacks the direction of a wave.
    [[nodiscard]] bool act(const Sea& sea, const SeaMoment& now, Vec6& out) const noexcept;
    /// Return the heading of the body without its oscillation in waves [rad].
    [[nodiscard]] double heading() const noexcept { return slow(2); }
    void visit_state(StateVisitor& v);
    void check_state(StateRules& rules) const;
    void write_memory(HullMemory& out) const;

  private:
    struct Entry {
        std::array<double, 6> re{}, im{};
        std::array<double, 3> drift{};  ///< Surge, sway, yaw.
    };
    struct Spot {
        std::size_t low = 0, high = 0;
        double fraction = 0.0;
        bool known = false;
    };
    [[nodiscard]] Spot find(double direction) const noexcept;
    [[nodiscard]] double slow(std::size_t k) const noexcept {
        return 4.0 * lag_[2][k] - 3.0 * lag_[3][k];
    }
    void fill(const WaterHull& def, const Sea& sea);

    bool force_ = false, drift_ = false;
    double follow_ = 1.0;  ///< 1 − e^(−h/τ).
    std::vector<double>
        heading_;  ///< Headings of the table, with mirror images and one more to close the circle.
    std::vector<Entry> table_;  ///< By component, then direction.
    std::array<std::array<double, 3>, 4> lag_{};
    std::int64_t begun_ = 0;
};

}  // namespace hawser::marine
