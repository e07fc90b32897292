// SPDX-License-Identifier: Apache-2.0
#pragma once
/// A scene with every key of anchors, stability gauges, overload protection and heave compensation.

#include <string_view>

namespace hawser::scene::test {

inline constexpr std::string_view kAnchors = R"({
  "version": 2, "name": "anchors",
  "settings": {"step": 0.0166666667, "duration": 2},
  "line_types": {"wire": {"mass_per_length": 10, "EA": 1e8, "diameter": 0.05}},
  "bodies": [
    {"name": "hook", "position": [0, 0, -60], "mass": 8000, "box": [1.5, 1.5, 0.5]},
    {"name": "plough", "position": [0, 50, -60], "mass": 9000, "box": [1.5, 1.5, 0.5]},
    {"name": "ship", "position": [300, 0, 0], "mass": 4e6, "gravity": false, "box": [30, 8, 4],
     "linear_damping": 1e6, "angular_damping": 1e9},
    {"name": "load", "position": [300, 20, -40], "mass": 5000, "box": [1, 1, 1]}
  ],
  "cables": [
    {"name": "line", "line_type": "wire", "from": {"body": "hook", "point": [1, 0, 0]},
     "to": {"body": "ship", "point": [-30, 0, 2]}, "elements": 4, "length": 275.5},
    {"name": "fall", "line_type": "wire", "from": {"body": "ship", "point": [0, 20, 5]},
     "to": {"body": "load"}, "elements": 2, "length": 45}
  ],
  "winches": [
    {"name": "hoist", "cable": "fall", "core_radius": 0.4, "width": 1, "stored": 200, "element": 0,
     "inertia": 1000, "brake_static": 1e6, "mode": "heave", "overload_limit": 4e5,
     "overload_retained": 1e4, "heave_speed": 2, "heave_acceleration": 3, "heave_falls": 1,
     "heave_point": {"body": "ship", "point": [0, 20, 5]}}
  ],
  "anchors": [
    {"name": "hold", "body": "hook", "point": [1, 0, 0], "cable": "line", "soil": "sand",
     "type": "stevpris_mk6", "mass": 8100, "fluke_length": 3.5, "first": 0.1, "drag_length": 15,
     "full_depth": 4, "breakout": 0.2, "friction": 0.6, "weight": 6.5e4, "seabed": -60,
     "touch": 0.4, "set_after": 1.5, "drag": 20, "set": true,
     "clay": {"strength": 1000, "gradient": 1500, "chain_width": 0.1, "chain_bearing": 10,
              "chain_friction": 0.2}, "description": "holds"},
    {"name": "dives", "body": "plough", "soil": "soft_clay", "law": "trajectory", "uhc": 5e6,
     "set": true,
     "clay": {"strength": 1500, "gradient": 1750, "fluke_area": 6, "bearing": 8,
              "fluke_angle_deg": 50, "first_depth": 1.5}}
  ],
  "stability": [
    {"name": "gauge", "body": "ship", "cable": "line", "pin": [-28, 2, 4.5], "stern": [-30, 0, 2],
     "thrust_height": -2, "stern_x": -30, "bollard_pull": 1e6, "mass": 4.1e6, "gm": 1.5,
     "most_heel_deg": 12, "deck_edge_deg": 14, "flooding_deg": 40, "residual_area": 0.06,
     "residual_lever": 0.15, "freeboard": 0.4, "gravity": 9.8, "warn": 0.7, "hysteresis": 0.1,
     "description": "on the bridge"}
  ]
})";

}  // namespace hawser::scene::test
