// SPDX-License-Identifier: Apache-2.0
#pragma once
/// A scene with every key of a vessel.

#include <string_view>

namespace hawser::scene::test {

/// A published ship in a template and its copies, and a ship by explicit coefficients.
inline constexpr std::string_view kVessels = R"({
  "version": 1, "name": "vessels",
  "settings": {"step": 0.0166666667, "duration": 2},
  "bodies": [
    {"name": "hull", "position": [0, 500, 0], "velocity": [5, 0, 0], "mass": 5e6, "gravity": false,
     "box": [40, 9, 5]}
  ],
  "vessels": [
    {"name": "tug", "body": "hull", "origin": [1, 0, -1], "draught": 5, "density": 1020,
     "added_mass": [3e5, 4e6, 5e6, 5e7, 1e9, 1e9], "coriolis": "planar",
     "damping": [[0, 0, 0, 0, 0, 0], [0, 7e4, 0, 0, 0, 1e4], [0, 0, 5e6, 0, 0, 0],
                 [0, 0, 0, 5e7, 0, 0], [0, 0, 0, 0, 3e9, 0], [0, 1e4, 0, 0, 0, 1e8]],
     "restoring": [0, 0, 1e7, 1e8, 5e9, 0],
     "resistance": {"curve": [[0, 0], [4, 5e4], [8, 3e5]], "linear": 1e3, "quadratic": 1e2,
                    "blend": 1.5},
     "cross_flow": {"length": 80, "beam": 18, "draught": 5, "drag": 0.7},
     "polynomial": {"length": 80, "area": 400, "speed": 0, "most_turn": 1.2, "scale": "speed",
                    "factor": 1e-3, "rudder_to_port": true, "own_coriolis": false,
                    "x": {"vr": 2, "0": 0}, "y": {"v": -100, "d": 1}, "k": {"f": -0.01},
                    "n": {"v": -50, "r": -30, "vvr": -10}},
     "mmg": {"diameter": 2.5, "length": 80, "k0": 0.3, "k1": -0.28, "k2": -0.14,
             "thrust_deduction": 0.2, "wake": 0.3, "wake_port": 1.5, "wake_star": 1.1,
             "propeller_x": -0.48, "rudder_area": 8, "height_share": 0.7,
             "steering_deduction": 0.3, "hull_increase": 0.3, "hull_x": -0.45, "rudder_x": -0.5,
             "wake_ratio": 1.1, "slipstream": 0.5, "lift_slope": 2.7, "inflow_x": -0.7,
             "straight_port": 0.4, "straight_star": 0.6},
     "steering": {"most_angle_deg": 30, "rate_deg": 3, "lag": 0.5, "rps": 2, "most_rps": 3,
                  "shaft_lag": 4},
     "wind": {"ship": "tender", "frontal_area": 150, "lateral_area": 400, "length": 82,
              "centre": 3, "height": 4},
     "propulsors": [
       {"name": "main", "point": [-38, 0, -3], "astern": 0.7,
        "propeller": {"series": "wageningen_b", "diameter": 3, "pitch": 1.1, "area": 0.65,
                      "blades": 4},
        "most_rps": 3, "wake": 0.2, "thrust_deduction": 0.15, "shaft_inertia": 2e4,
        "response": 2, "most_torque": 3e5, "most_power": 3e6, "controllable": true,
        "pitch_time": 12, "ramp": 1},
       {"name": "az", "kind": "azimuth", "point": [-30, 0, -4],
        "propeller": {"series": "ka4_70", "diameter": 2}, "most_rps": 4, "ramp": 3,
        "turn_rate_deg": 10, "most_angle_deg": 90},
       {"name": "bow", "kind": "tunnel", "point": [35, 0, -3], "thrust": 1e5, "lost_at": 4}],
     "rudders": [{"name": "flap", "point": [-42, 0, -3], "area": 9, "aspect": 1.7, "behind": "main",
                  "covered": 0.9, "slipstream": 0.6, "wake": 0.2, "hull_increase": 0.2,
                  "stall_deg": 30, "most_angle_deg": 45, "rate_deg": 4}],
     "description": "every key"}
  ],
  "templates": {"tanker": {
    "bodies": [{"name": "hull", "mass": 2.255e8, "box": [150, 24, 12], "gravity": false,
                "velocity": [6.85, 0, 0]}],
    "vessels": [{"name": "ship", "body": "hull", "ship": "esso_190k", "depth": 23}]}},
  "instances": [{"template": "tanker", "name": "a", "position": [0, 0, 0]},
                {"template": "tanker", "name": "b", "position": [0, -500, 0]}],
  "sea": {"depth": 23, "current": [{"depth": 0, "speed": 1, "direction_deg": 45}],
          "wind": {"speed": 12, "direction_deg": 180}},
  "inputs": [{"name": "helm", "signal": "a/ship.rudder", "min": -0.5, "max": 0.5}],
  "timeline": [{"at": 0.5, "set": {"a/ship.rudder": 0.3, "tug.az": 1, "tug.az_angle": 0.5,
                                   "tug.main_pitch": -0.5}}],
  "repeat": {"offset": [2000, 0, 0], "copies": 2}
})";

}  // namespace hawser::scene::test
