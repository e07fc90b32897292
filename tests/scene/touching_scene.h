// SPDX-License-Identifier: Apache-2.0
#pragma once
/// A valid scene that uses every part of the format for contact.

#include <string_view>

namespace hawser::scene::test {

inline constexpr std::string_view kTouching = R"({
  "version": 1, "name": "touching",
  "settings": {"contact_margin": 0.03},
  "materials": {
    "steel": {"friction": 0.2, "restitution": 0.1, "stiffness": 2e8, "tangential": 0.8,
              "damping_time": 0.02, "rolling": 1e-3, "torsional": 1e-3, "description": "dry"},
    "mud": {"friction": 1, "stiffness": 1e6}
  },
  "material_pairs": [{"between": ["steel", "mud"], "friction": 0.7, "stiffness": 5e5},
                     {"between": ["mud", "default"]}],
  "bodies": [
    {"name": "seabed", "kind": "fixed", "position": [0, 0, -20], "shapes": [
      {"kind": "plane", "name": "mud", "normal": [0, 0, 1], "material": "mud", "groups": "ground"}]},
    {"name": "ship", "position": [0, 0, 0], "mass": 4e6, "box": [40, 9, 4], "gravity": false,
     "shapes": [
      {"kind": "box", "name": "deck", "position": [0, 0, 3.5], "half_size": [40, 9, 0.5],
       "material": "steel", "groups": ["ship", "deck"]},
      {"kind": "cylinder", "name": "roller", "position": [-41, 0, 3.5], "radius": 1, "length": 6,
       "axis": "y", "material": "steel", "groups": ["ship", "deck"], "description": "stern"},
      {"kind": "capsule", "position": [0, 9.5, 0], "radius": 0.5, "length": 20,
       "euler_deg": [0, 0, 10], "groups": "fender"},
      {"kind": "sphere", "position": [40, 0, 0], "radius": 2, "touches": ["ground", "ship"]}]},
    {"name": "quay", "kind": "fixed", "position": [200, 0, 0], "shapes": [
      {"kind": "heightfield", "rows": 2, "columns": 3, "cell": [5, 4], "heights": [0, 1, 0, 1, 2, 1]},
      {"kind": "heightfield", "rows": 3, "columns": 3, "cell": [5, 4], "position": [0, 50, 0],
       "ground": {"slope": [0.1, 0], "height": 0.5, "length": [10, 8]}},
      {"kind": "hull", "vertices": [[0, -40, 0], [1, -40, 0], [0, -39, 0], [0, -40, 1]]},
      {"kind": "mesh", "orientation": [1, 0, 0, 0], "vertices": [[0, 0, 9], [1, 0, 9], [0, 1, 9]],
       "triangles": [[0, 1, 2]]}]},
    {"name": "buoy", "kind": "lump", "position": [-120, 0, -10], "mass": 500,
     "shapes": [{"kind": "sphere", "radius": 0.7},
      {"kind": "segment", "name": "stay", "to": "weight", "radius": 0.03, "groups": "wires"},
      {"kind": "segment", "to": "seabed", "radius": 0.02, "material": "steel", "touches": "ship"}]},
    {"name": "weight", "kind": "lump", "position": [-120, 0, -15], "mass": 300}
  ],
  "line_types": {"wire": {"mass_per_length": 20, "EA": 2e8, "diameter": 0.08}},
  "cables": [
    {"name": "tow", "line_type": "wire", "from": {"body": "ship", "point": [-20, 0, 4.1]},
     "to": {"at": [-100, 0, -19.96]}, "elements": 8,
     "contact": {"material": "steel", "groups": "wires", "touches": ["deck", "ground", "wires"]}},
    {"name": "links", "line_type": "wire", "as": "links", "from": {"body": "ship"},
     "to": {"free": [0, 40, 0]}, "elements": 4, "contact": {"radius": 0.1}}
  ],
  "templates": {
    "block": {
      "parameters": {"size": 1, "stuff": "steel"},
      "bodies": [{"name": "b", "position": [0, 0, 0], "mass": 100, "box": [1, 1, 1],
        "shapes": [{"kind": "box", "name": "s", "half_size": ["${size}", 1, 1],
                    "material": "${stuff}", "groups": "deck"}]}]
    }
  },
  "instances": [{"template": "block", "name": "one", "position": [0, 0, 30]},
                {"template": "block", "name": "two", "position": [0, 0, 40],
                 "parameters": {"size": 2.5, "stuff": "mud"}}],
  "repeat": {"offset": [0, 200, 0], "copies": 2,
             "joins": [{"name": "join", "line_type": "wire", "elements": 3, "contact": {},
                        "from": {"body": "ship"}, "to": {"body": "ship"}}]}
})";

}  // namespace hawser::scene::test
