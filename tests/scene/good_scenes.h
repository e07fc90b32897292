// SPDX-License-Identifier: Apache-2.0
#pragma once
/// Valid scenes that together use every part of the format.

#include "anchor_scene.h"
#include "touching_scene.h"
#include "vessel_scene.h"

#include <array>
#include <string_view>

namespace hawser::scene::test {

/// Cables of every type, a winch, templates in templates, copies, inputs, pictures.
inline constexpr std::string_view kSite = R"({
  "$schema": "../schema/scene-1.json", "version": 1, "name": "site",
  "description": "A rig, a ship, cables – and a crane.",
  "settings": {"step": 0.0166666667, "duration": 20, "gravity": [0, 0, -9.81], "form": "auto",
               "geometric_stiffness": 1, "rotation_damping": 0.1, "staggered_start": true,
               "refinements": 1},
  "defaults": {"compliance": 1e-11, "damping_time": 0.04},
  "line_types": {
    "chain76": {"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.137,
                "breaking_load": 6.0e6, "drag": 100, "submerged_factor": 0.87, "color": "#445566",
                "description": "stud chain"},
    "wire": {"mass_per_length": 23, "EA": 2.33e8, "EI": 5000, "axial_damping": 0.1,
             "diameter": 0.076}
  },
  "bodies": [
    {"name": "rig", "position": [0, 0, 0], "mass": 2e7, "box": [35, 35, 10], "gravity": false,
     "linear_damping": 2e5, "angular_damping": [1e7, 1e7, 1e7]},
    {"name": "ship", "kind": "rigid", "position": [300, 0, 0], "euler_deg": [0, 0, 90],
     "velocity": [0.1, 0, 0], "angular_velocity": [0, 0, 0.01], "mass": 4e6,
     "inertia": [[1.3e8, 0, 0], [0, 2.1e9, 1e6], [0, 1e6, 2.2e9]], "half_size": [40, 9, 4],
     "gravity": false, "force": [1e5, 0, 0], "torque": [0, 0, 1e3],
     "linear_damping": [1e5, 2e5, 1e5]},
    {"name": "drum", "kind": "scalar", "position": [0.5, 0, 0], "mass": 5000},
    {"name": "hook", "kind": "lump", "position": [300, 0, 30], "mass": 5000},
    {"name": "roller", "position": [300, -40, 0], "mass": 900,
     "cylinder": {"radius": 1.5, "length": 6, "axis": "x"}, "orientation": [1, 0, 0, 0]},
    {"name": "buoy", "position": [150, 50, 0], "mass": 2000, "sphere": 1.5, "gravity": false},
    {"name": "pile", "kind": "fixed", "position": [0, 300, -50]},
    {"name": "tug", "kind": "kinematic", "position": [0, -300, 0], "velocity": [0, -0.1, 0]}
  ],
  "interactions": [
    {"name": "water", "kind": "hydrostatic", "bodies": ["ship"], "heave_stiffness": 1.4e7,
     "roll_stiffness": 4e8, "pitch_stiffness": 4e9, "heave_damping": 1e6, "rest_height": 0},
    {"name": "bearing", "kind": "hinge", "bodies": ["ship", "roller"], "at": [300, -40, 0],
     "axis": [1, 0, 0], "compliance": 1e-10, "damping_time": [0.03, 0.03, 0.03, 0.03, 0.03]},
    {"name": "turn", "kind": "hinge_motor", "bodies": ["ship", "roller"], "axis": [1, 0, 0],
     "speed": 0.1, "force_min": -1e5, "force_max": 1e5},
    {"name": "brake", "kind": "hold", "bodies": ["drum"]},
    {"name": "fall", "kind": "stretch", "bodies": ["ship", "hook"],
     "points": [[0, 0, 50], [0, 0, 0]], "EA": 1e7},
    {"kind": "distance", "bodies": ["buoy", "world"], "length": 60}
  ],
  "cables": [
    {"name": "moor", "line_type": "chain76", "from": {"at": [-400, 0, -100]},
     "to": {"body": "rig", "point": [-35, 0, -5]}, "length": 400, "elements": 12,
     "shape": "catenary"},
    {"name": "tow", "line_type": "wire", "from": {"body": "rig", "point": [35, 0, 0]},
     "to": {"body": "ship", "point": [0, 40, 0]}, "length": 225.5, "elements": 10,
     "tension_only": true, "winch": {"drum": "drum", "radius": 0.8}, "consistent_mass": true,
     "weak": {"at": 1, "breaking_load": 1e5},
     "resolution": {"min_length": 5, "max_length": 40, "sag_error": 0.1, "max_angle": 0.3,
                    "contact_length": 0, "drum_length": 10, "wave_period": 1.5,
                    "points_per_wave": 10, "averaging": 5, "hysteresis": 2, "patience": 1,
                    "max_nodes": 60, "interval": 5, "description": "limits"}},
    {"name": "links", "line_type": {"mass_per_length": 50, "diameter": 0.2}, "as": "links",
     "from": {"body": "rig", "point": [0, 35, 0]}, "to": {"at": [0, 135, 0]}, "elements": 4,
     "offsets": [[0, 0, 0.01], [0, 0, -0.01], [0, 0, 0.01]], "compliance": 1e-12,
     "damping_time": 0.03},
    {"name": "tail", "line_type": "wire", "from": {"body": "hook"},
     "to": {"free": [300, 0, 20]}, "elements": 2, "shape": [[300, 0, 25.5]]}
  ],
  "templates": {
    "crane": {
      "description": "post, boom and hook",
      "parameters": {"boom_mass": 2e4, "reach": 12, "label": "boom", "top": [0, 0, 5],
                     "loose": true},
      "bodies": [
        {"name": "${label}", "position": ["${reach}", 0, 5], "mass": "${boom_mass}",
         "box": [12, 0.5, 0.5], "gravity": "${loose}"},
        {"name": "tip", "kind": "lump", "position": [24, 0, -5], "mass": 500}
      ],
      "interactions": [
        {"name": "pivot", "kind": "hinge", "bodies": ["base", "${label}"], "at": "${top}",
         "axis": [0, 1, 0]}
      ],
      "cables": [
        {"name": "hoist", "line_type": "wire", "from": {"body": "${label}", "point": [12, 0, 0]},
         "to": {"body": "tip"}, "elements": 3, "tension_only": "${loose}"}
      ],
      "instances": [{"template": "weight", "name": "w", "on": "tip", "bind": {"above": "tip"},
                     "parameters": {"kilos": "${boom_mass}"}}],
      "inputs": [{"name": "gust", "body": "tip", "component": "force_x"}],
      "outputs": [{"name": "load", "kind": "tension", "cable": "hoist", "component": "last"}]
    },
    "weight": {
      "parameters": {"kilos": 100},
      "bodies": [{"name": "block", "kind": "lump", "position": [0, 0, -2], "mass": "${kilos}"}],
      "interactions": [{"name": "rod", "kind": "distance", "bodies": ["above", "block"]}]
    }
  },
  "instances": [
    {"template": "crane", "name": "port", "on": "ship", "position": [0, 5, 4],
     "euler_deg": [0, 0, 90], "parameters": {"boom_mass": 15000}, "bind": {"base": "ship"}}
  ],
  "inputs": [
    {"name": "roller.speed", "interaction": "turn", "param": "speed", "min": -1, "max": 1},
    {"name": "thrust", "body": "ship", "component": "force_y", "min": -5e5, "max": 5e5,
     "description": "bow thruster", "local": true, "unit": "N", "group": "ship", "nominal": 5e5,
     "spring": 0},
    {"name": "let_out", "interaction": "brake", "param": "target"}
  ],
  "outputs": [
    {"name": "heading", "kind": "pose", "body": "ship", "component": "yaw", "unit": "rad",
     "group": "ship", "nominal": 3, "description": "of the ship"},
    {"name": "surge", "kind": "velocity", "body": "ship", "point": [40, 0, 0], "component": "x",
     "local": true},
    {"name": "roller", "kind": "coordinate", "interaction": "bearing"},
    {"name": "roller_speed", "kind": "speed", "interaction": "turn", "component": "value"},
    {"name": "roller_torque", "kind": "motor_force", "interaction": "turn"},
    {"name": "bearing_load", "kind": "force", "interaction": "bearing", "component": "row_2"},
    {"name": "tow", "kind": "tension", "cable": "tow", "component": "largest"},
    {"name": "fall", "kind": "tension", "interactions": ["fall"], "component": "first"},
    {"name": "paid_out", "kind": "drum", "cable": "tow", "component": "paid_out"},
    {"name": "wire_left", "kind": "drum", "interaction": "tow/s0", "component": "length"},
    {"name": "gap", "kind": "distance", "bodies": ["rig", "ship"],
     "points": [[35, 0, 0], [-40, 0, 0]]},
    {"name": "way", "kind": "distance", "bodies": ["world", "rig"],
     "points": [[0, 10, 0], [0, 0, 0]]},
    {"name": "slew", "kind": "coordinate", "interaction": "port/pivot"},
    {"name": "residual", "kind": "statistic", "component": "residual"}
  ],
  "repeat": {"offset": [0, 1500, 0], "copies": 2,
             "joins": [{"name": "neighbour", "line_type": "wire", "elements": 5,
                        "from": {"body": "rig", "point": [0, 35, 0]},
                        "to": {"body": "rig", "point": [0, -35, 0]}}]},
  "plot": {"tensions": ["moor", "tow"], "motions": ["rig", "port/boom"],
           "view_box": [-400, -50, -100, 400, 50, 60], "light": "night", "visibility": 2000, "sun_azimuth_deg": 90, "sun_elevation_deg": 30}
})";

/// One interaction of every kind.
inline constexpr std::string_view kKinds = R"({
  "version": 1, "name": "kinds",
  "bodies": [
    {"name": "a", "position": [0, 0, 0], "mass": 10, "box": [1, 1, 1]},
    {"name": "b", "position": [2, 0, 0], "mass": 20, "inertia": [1, 2, 2.5]},
    {"name": "c", "position": [4, 0, 0], "mass": 30, "sphere": 0.5},
    {"name": "p", "kind": "lump", "position": [6, 0, 0], "mass": 1},
    {"name": "q", "kind": "lump", "position": [7, 0, 0], "mass": 1},
    {"name": "r", "kind": "lump", "position": [8, 0.1, 0], "mass": 1},
    {"name": "d", "kind": "scalar", "mass": 3},
    {"name": "e", "kind": "scalar", "mass": 2}
  ],
  "interactions": [
    {"name": "ball", "kind": "ball", "bodies": ["a", "b"], "at": [1, 0, 0]},
    {"name": "hinge", "kind": "hinge", "bodies": ["a", "b"], "at": [1, 0, 0], "axis": [0, 0, 2]},
    {"name": "prismatic", "kind": "prismatic", "bodies": ["a", "b"],
     "points": [[1, 0, 0], [-1, 0, 0]], "axis": [1, 0, 0]},
    {"name": "cylindrical", "kind": "cylindrical", "bodies": ["b", "c"], "at": [3, 0, 0],
     "frames": [[1, 0, 0, 0], [1, 0, 0, 0]]},
    {"name": "universal", "kind": "universal", "bodies": ["b", "c"], "at": [3, 0, 0],
     "axes": [[0, 1, 0], [0, 0, 1]]},
    {"name": "lock", "kind": "lock", "bodies": ["world", "a"], "at": [0, 0, 0],
     "compliance": [0, 0, 0, 1e-9, 1e-9, 1e-9]},
    {"name": "distance", "kind": "distance", "bodies": ["b", "c"]},
    {"name": "stretch", "kind": "stretch", "bodies": ["p", "q"], "EA": 1e6, "tension_only": 0,
     "breaking_load": 1e5},
    {"name": "winch_stretch", "kind": "winch_stretch", "bodies": ["c", "p", "d"], "EA": 1e6,
     "radius": 0.5},
    {"name": "bend", "kind": "bend", "bodies": ["p", "q", "r"], "EI": 10, "length": 1},
    {"name": "twist", "kind": "twist", "bodies": ["a", "c"], "GJ": 10, "length": 4,
     "axis": [1, 0, 0]},
    {"name": "hydrostatic", "kind": "hydrostatic", "bodies": ["c"], "heave_stiffness": 1e3,
     "roll_stiffness": 1e3, "pitch_stiffness": 1e3},
    {"name": "hold", "kind": "hold", "bodies": ["d"], "target": 0.1},
    {"name": "hinge_motor", "kind": "hinge_motor", "bodies": ["a", "b"], "axis": [0, 0, 1]},
    {"name": "slide_motor", "kind": "slide_motor", "bodies": ["a", "b"], "axis": [1, 0, 0],
     "speed": 0.2},
    {"name": "scalar_motor", "kind": "scalar_motor", "bodies": ["d"], "speed": 1,
     "compliance": 1e-6},
    {"name": "hinge_range", "kind": "hinge_range", "bodies": ["a", "b"], "axis": [0, 0, 1],
     "min": -1, "max": 1},
    {"name": "slide_range", "kind": "slide_range", "bodies": ["a", "b"], "axis": [1, 0, 0],
     "min": -1, "max": 1},
    {"name": "hinge_friction", "kind": "hinge_friction", "bodies": ["a", "b"], "axis": [0, 0, 1],
     "torque": 5, "loads": [{"interaction": "hinge", "factor": 0.1}]},
    {"name": "slide_friction", "kind": "slide_friction", "bodies": ["a", "b"], "axis": [1, 0, 0],
     "force": 5},
    {"name": "scalar_friction", "kind": "scalar_friction", "bodies": ["d"], "force": 5},
    {"name": "gear", "kind": "gear", "bodies": ["a", "b", "c"], "axis": [0, 0, 1], "teeth_1": 20,
     "teeth_2": -60},
    {"name": "scalar_clutch", "kind": "scalar_clutch", "bodies": ["d", "e"], "force_max": 4},
    {"name": "span", "kind": "span", "bodies": ["c", "p", "d", "e"], "EA": 1e6},
    {"name": "end_span", "kind": "end_span", "bodies": ["c", "p", "d"], "EA": 1e6, "radius": 1},
    {"name": "body_span", "kind": "body_span", "bodies": ["d", "e"], "EA": 1e6, "path": 1, "length": 1},
    {"name": "line_friction", "kind": "line_friction", "bodies": ["d"], "friction": 0.2, "angle": 1}
  ]
})";

/// The smallest useful scene.
inline constexpr std::string_view kPendulum = R"({
  "version": 1, "name": "pendulum",
  "bodies": [{"name": "bob", "kind": "lump", "position": [-1, 0, 0], "mass": 1}],
  "interactions": [{"name": "rod", "kind": "distance", "bodies": ["world", "bob"], "length": 1}],
  "plot": {"motions": ["bob"]}
})";

/// Cables that start at rest, on a seabed, and along a path.
inline constexpr std::string_view kShapes = R"({
  "version": 1, "name": "shapes",
  "line_types": {"wire": {"mass_per_length": 20, "EA": 1e8, "diameter": 0.1}},
  "cables": [
    {"name": "hung", "line_type": "wire", "from": {"at": [0, 0, 0]}, "to": {"at": [80, 0, 0]},
     "length": 100, "elements": 5, "shape": "hanging"},
    {"name": "moored", "line_type": "wire", "from": {"at": [0, 9, -20]}, "to": {"at": [80, 9, 0]},
     "length": 90, "elements": 6, "shape": "catenary",
     "seabed": {"height": -20, "friction": 0.6}},
    {"name": "laid", "line_type": "wire", "from": {"at": [0, 18, -20]}, "to": {"at": [60, 18, 0]},
     "elements": 6, "shape": "laid", "seabed": {"height": -20}},
    {"name": "round", "line_type": "wire", "from": {"at": [0, 27, 0]}, "to": {"at": [9, 36, 0]},
     "elements": 6, "shape": "path", "path": [[9, 27, 0]]}]
})";

/// A crane of each kind, one of them in a template.
inline constexpr std::string_view kCranes = R"({
  "version": 1, "name": "cranes",
  "bodies": [{"name": "quay", "kind": "fixed"},
             {"name": "box", "kind": "lump", "position": [-2.98, 16.91, 4], "mass": 5000},
             {"name": "collar", "position": [80, 0, 4], "mass": 1500, "sphere": 0.5}],
  "cranes": [
    {"name": "knuckle", "kind": "knuckle_boom", "on": "quay", "point": [0, 0, 2],
     "euler_deg": [0, 0, 90], "description": "typical",
     "slew": {"torque": 4e5, "brake": 6e5, "friction": 2e4, "speed": 0.06, "angle_deg": 10},
     "column": {"mass": 14000, "centre": [0, 0, 2], "half_size": [1, 1, 2]},
     "boom_foot": [0.5, 0, 4],
     "boom": {"length": 15, "mass": 9000, "centre": 7, "width": 1.2, "height": 1.6},
     "boom_angle_deg": 65,
     "boom_cylinder": {"foot": [1.8, 0, 0.8], "head": [6, 0, -0.9], "min_length": 5.6,
       "max_length": 8.9, "push": 3.2e6, "pull": 1.6e6, "speed": 0.1, "stiffness": 2e8,
       "mass": 600},
     "jib": {"length": 11, "mass": 5000, "width": 0.8, "height": 1},
     "jib_angle_deg": -85,
     "jib_cylinder": {"foot": [6, 0, -0.8], "head": [2.5, 0, -0.3], "min_length": 6.9,
       "max_length": 11, "push": 1.8e6, "pull": 9e5, "speed": 0.12, "stiffness": 1.2e8,
       "mass": 400},
     "hoist": {"falls": 2, "EA": 6.4e7, "efficiency": 0.98, "sheave_radius": 0.36,
       "sheave_inertia": 8, "drum": [2.5, 0, 1.3], "drum_radius": 0.45, "drum_inertia": 900,
       "pull": 1.8e5, "brake": 3e5, "speed": 0.5, "breaking_load": 9.5e5, "damping_time": 0.05},
     "hook": {"mass": 800, "height": 1.2, "half_size": [0.35, 0.25, 0.6], "hang": 6.8,
       "least_hang": 2, "angular_damping": 10},
     "rating": {"curve": [[14, 25000], [18, 23000]], "warning": 0.8, "overload": 0.9, "hold": 1,
       "filter": 1, "cut_out": true},
     "loads": [{"body": "box", "eyes": [[0, 0, 0]], "sling_length": 4, "sling_EA": 2e7,
       "reach": 0.3, "breaking_load": 1e6}],
     "take": "box", "ramp": 6.5}],
  "templates": {"lattice": {
    "parameters": {"falls": 3, "angle": 75},
    "cranes": [
      {"name": "crane", "kind": "lattice", "on": "base", "point": [0, 50, 3],
       "slew": {"torque": 8e6, "brake": 1.2e7, "speed": 0.02},
       "column": {"mass": 250000, "half_size": [7, 4, 3]},
       "boom_foot": [1.5, 0, 2],
       "boom": {"length": 60, "mass": 60000, "width": 3.2, "height": 2.8},
       "boom_angle_deg": "${angle}", "least_angle_deg": 15, "most_angle_deg": 84,
       "gantry": [-8, 0, 16], "bridle_mass": 3000, "pendant_length": 34, "pendant_EA": 2e9,
       "pendant_breaking_load": 9e6,
       "luffing": {"falls": 16, "EA": 9.5e7, "drum": [-6, 0, 4], "drum_radius": 0.6,
         "drum_inertia": 4000, "pull": 5e5, "brake": 8e5, "speed": 0.1},
       "hoist": {"falls": "${falls}", "EA": 1.2e8, "drum": [-3, 0, 3], "drum_radius": 0.7,
         "drum_inertia": 8000, "pull": 6e5, "brake": 9e5, "speed": 0.1},
       "hook": {"mass": 12000, "height": 3, "hang": 43.5}}],
    "outputs": [{"name": "fall", "kind": "tension", "interactions": ["crane/hoist/part2"],
                 "component": "first"}]}},
  "instances": [{"template": "lattice", "name": "big", "parameters": {"angle": 74},
                 "bind": {"base": "quay"}}],
  "stoppers": [{"name": "jaw", "on": "quay", "point": [40, 0, 1], "rated_load": 7e6},
    {"name": "stopper", "on": "quay", "point": [40, 2, 1], "outboard": [0, -1, 0], "reach": 0.8,
     "rated_load": 3e6, "pitch": 0.6, "closed": true, "description": "for chain"}],
  "pins": [{"name": "pin", "on": "quay", "from": [45, 0, 0], "to": [45, 0, 2], "radius": 0.15},
    {"name": "other_pin", "on": "quay", "from": [45, 1, 0], "to": [45, 1, 2], "radius": 0.15,
     "friction": 0.15, "efficiency": 0.98, "speed": 0.2, "force": 3e5, "density": 7800,
     "margin": 0.5, "up": false, "touches": "default", "description": "down at the start"}],
  "hooks": [{"name": "lifter", "on": "quay", "point": [60, 0, 8], "strength": 5e5, "latch": 1e3,
    "loads": [{"body": "box", "eyes": [[0, 0, 0]], "sling_length": 2,
               "sling_EA": 2e7, "reach": 0.5, "breaking_load": 3e5}], "description": "a spare"}],
  "chasers": [{"name": "ring", "on": "collar", "point": [0, 0, 0.2], "reach": 0.6, "friction": 0.25,
    "arrives": 1.5, "element": 5, "closed": false, "description": "open"}],
  "outputs": [{"name": "turn", "kind": "coordinate", "interaction": "knuckle/slew"}],
  "repeat": {"offset": [200, 0, 0], "copies": 2}
})";

/// Water and wind: waves of every kind, a cable of two line types, bodies, hulls, copies.
inline constexpr std::string_view kSea = R"({
  "version": 1, "name": "sea",
  "line_types": {
    "chain": {"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.076, "cd_normal": 2.6,
              "cd_tangential": 1.4, "ca_normal": 1, "ca_tangential": 0.1, "displaced_area": 0.016},
    "rope": {"mass_per_length": 5, "EA": 1e7, "diameter": 0.08, "cd_normal": 1.8}},
  "bodies": [
    {"name": "box", "mass": 205000, "box": [5, 5, 2]},
    {"name": "wedge", "position": [40, 0, 0], "mass": 5125, "box": [1, 1, 3]},
    {"name": "buoy", "kind": "lump", "position": [20, 20, 0], "mass": 400},
    {"name": "pier", "position": [80, 0, 0.5], "mass": 50000, "box": [2, 2, 2]}],
  "cables": [
    {"name": "line", "from": {"body": "box"}, "to": {"free": [30, 0, -20]},
     "sections": [{"line_type": "chain", "length": 20, "elements": 4},
                  {"line_type": "rope", "length": 20, "elements": 5}]}],
  "sea": {
    "depth": 60, "density": 1020, "gauge": [3, 4], "convective": true, "description": "off Bergen",
    "level": [{"time": 0, "level": -0.5}, {"time": 3600, "level": 0.5}],
    "waves": [{"kind": "regular", "height": 1, "period": 12, "direction_deg": 90, "phase_deg": 30},
              {"kind": "jonswap", "height": 2, "period": 8, "gamma": 2, "spreading": 5,
               "components": 60, "seed": 4, "lowest": 0.6, "highest": 3},
              {"kind": "pierson_moskowitz", "height": 1, "period": 5, "components": 40}],
    "current": [{"depth": 0, "speed": 1, "direction_deg": 10}, {"depth": 30, "speed": 0.2}],
    "wind": {"speed": 10, "direction_deg": 45, "gusts": true, "components": 50, "seed": 2,
             "density": 1.2},
    "bodies": [{"body": "buoy", "drag_area": 1, "wind_area": [0.5, 0.5, 0.2], "volume": 1,
                "added_mass": [0.5, 0.5, 0.7], "height": 1.1}],
    "hulls": [{"body": "box", "mesh": {"box": [5, 5, 2], "pieces": [2, 2, 1]},
               "offset": [0, 0, 0.1], "added_mass": [1e4, 1e4, 1e5, 1e5, 1e5, 1e5],
               "damping": [1e4, 1e4, 1e5, 1e5, 1e5, 1e5], "drag_area": 20, "wind_area": 10},
              {"body": "wedge", "scale": 2, "wave_pressure": false,
               "mesh": {"vertices": [[0, 0, -1], [1, 0, 1], [-1, 1, 1], [-1, -1, 1]],
                        "triangles": [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]]}},
              {"body": "pier", "linear": {"height": 0.5, "weight": 4.9e5}, "reference": [0, 0, -0.5],
               "excitation": "full", "drift": true, "coriolis": false, "slow_time": 10,
               "radiation": "state_space", "memory": 20, "order": 4, "constant_period": 8,
               "strips": [{"from": [-2, 0, 0], "to": [2, 0, 0], "axis": [0, 2, 0],
                           "drag_area": 4, "count": 3}],
               "coefficients": {
                 "frequencies": [0.3, 0.6, 0.9, 1.2, 1.8],
                 "radiation": [{"of": [3, 3], "infinite": 2e4, "zero": 3e4,
                                "added_mass": [3e4, 2.8e4, 2.5e4, 2.2e4, 2e4],
                                "damping": [2e3, 6e3, 9e3, 7e3, 2e3]},
                               {"of": [1, 5], "added_mass": [1, 1, 1, 1, 1]}],
                 "headings_deg": [0, 90, 180, 270],
                 "excitation": [{"of": 3, "heading": 1, "re": [1e5, 9e4, 7e4, 5e4, 2e4],
                                 "im": [0, 1e3, 2e3, 3e3, 4e3]}],
                 "scattering": [{"of": 3, "heading": 1, "re": [1, 1, 1, 1, 1],
                                 "im": [0, 0, 0, 0, 0]}],
                 "drift_forces": [{"of": 1, "heading": 0, "values": [0, 10, 100, 400, 500]}],
                 "stiffness": [{"of": [3, 3], "value": 1e5}, {"of": [4, 4], "value": 1e6},
                               {"of": [5, 5], "value": 1e6}]}}],
    "rods": [{"body": "wedge", "from": [0, 0, -4], "to": [0, 0, 6], "diameter": 0.5},
             {"body": "box", "from": [-5, 0, -2], "to": [5, 0, -2], "diameter": 0.3,
              "displaced_area": 0, "cd_normal": 1, "cd_tangential": 0.1, "ca_normal": 0.9,
              "ca_tangential": 0.2, "segments": 4}]},
  "inputs": [{"name": "waves", "signal": "sea.waves", "min": 0, "max": 2}],
  "timeline": [{"at": 2, "set": {"sea.current": 0.5}}],
  "repeat": {"offset": [200, 0, 0], "copies": 2}
})";

inline constexpr std::array<std::string_view, 9> kGoodScenes = {
    kSite, kKinds, kPendulum, kTouching, kShapes, kCranes, kSea, kVessels, kAnchors};

}  // namespace hawser::scene::test
