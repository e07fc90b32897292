// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_control.h
/// The key `control` of vessels (hawser/vessel_control.h).

#include <hawser/fields.h>
#include <hawser/vessel.h>

#include "scene/description.h"

#include <vector>

namespace hawser::scene {

/// Numbers of the control; keys that end in _deg are degrees in scenes.
struct ControlTable {
    static constexpr FieldInfo<VesselControl> kNumbers[] = {
        {"damping", &VesselControl::damping, "1", "1", "Damping ratio.", 0.01, 10.0},
        {"integral", &VesselControl::integral, "1", "0.1",
         "Integral gain over bandwidth times proportional gain.", 0.0, 1.0},
        {"filter", &VesselControl::filter, "s", "30", "Time constant of orders.", 0.0, 1e4},
        {"wave_period", &VesselControl::wave_period, "s", "8",
         "Period of the waves that the observer filters out.", 1.0, 60.0},
        {"wind_filter", &VesselControl::wind_filter, "s", "5",
         "Time constant of feed-forward of wind and lines.", 0.0, 1e4},
        {"position_alarm", &VesselControl::position_alarm, "m", "5",
         "Offset of the event position_lost.", 0.01, 1e4},
        {"heading_alarm_deg", &VesselControl::heading_alarm, "deg", "10",
         "The same of the heading.", 0.01, 180.0},
        {"consequence_alarm", &VesselControl::consequence_alarm, "1", "0.02",
         "Shortfall of the event failure_critical.", 1e-4, 1.0},
        {"azimuth_cost", &VesselControl::azimuth_cost, "1", "1",
         "Cost of thrust of azimuths over other thrusters.", 1e-3, 1e3}};
};

/// Read an object whose form has been checked. @throws SceneError.
[[nodiscard]] VesselControl read_vessel_control(Description& out, const Scope& scope,
                                                const Json& json, BodyId body,
                                                const std::vector<PropulsorDef>& propulsors,
                                                const SourceLocation& location);

}  // namespace hawser::scene
