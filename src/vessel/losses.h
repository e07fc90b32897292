// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file losses.h
/// Compute the losses of propulsors at the beginning of a step (hawser/vessel_propulsion.h).

#include <hawser/sea.h>
#include <hawser/vessel.h>

#include "vessel/actuators.h"

#include <memory>
#include <vector>

namespace hawser::vessel {

/// Water surface above the propulsors of a vessel.
class Surface {
  public:
    /// Create the surface from the sea of the world. Without propulsors that ventilate it is not
    /// used.
    Surface(const World& world, const VesselDef& def);
    /// Set the time at which height() evaluates the waves.
    void update(const World& world, double time) noexcept;
    /// Return the height z of the water surface [m].
    [[nodiscard]] double height(double x, double y) const noexcept;

  private:
    std::shared_ptr<const Sea> sea_;  ///< Null: still water.
    SeaMoment moment_;
    double still_level_ = 0.0;
};

/// True if a definition has any losses.
[[nodiscard]] bool has_losses(const VesselDef& def) noexcept;
/// Multiply `thrust_fraction` of each propulsor by the fraction that remains in the races of the
/// others.
void apply_race_losses(const std::vector<Propulsor>& propulsors,
                       std::vector<PropulsorState>& states, double density) noexcept;
/// Return the fraction of thrust that remains for an azimuth whose race flows under the hull.
[[nodiscard]] double thrust_fraction_under_hull(const Propulsor& propulsor,
                                                const PropulsorState& s) noexcept;

}  // namespace hawser::vessel
