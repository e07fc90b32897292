# SPDX-License-Identifier: Apache-2.0
"""Line types and templates of scenes/anchor_lines.json: crane, anchor handler, windlass.

Numbers and their sources: docs/anchor_lines.md.
"""

import numpy as np

G = 9.81

LINES = {
    # Stud link chain, 76 mm, grade R4.
    "chain76": {"description": "Stud link chain 76 mm, R4", "mass_per_length": 126.5, "EA": 5.83e8, "EI": 1.0e4, "diameter": 0.137, "breaking_load": 6.0e6,
                "axial_damping": 0.1, "drag": 30, "submerged_factor": 0.87, "color": "#4a4e57"},
    # Steel wire 6x19 IWRC, 76 mm.
    "wire76": {"description": "Steel wire 6x19 IWRC 76 mm, in water", "mass_per_length": 23.0, "EA": 2.33e8, "EI": 5.0e3, "diameter": 0.076, "breaking_load": 3.658e6,
               "axial_damping": 0.1, "drag": 20, "submerged_factor": 0.87, "color": "#b0552f"},
    # Steel wire 6x19 IWRC, 26 mm, in air.
    "hoist26": {"description": "Steel wire 6x19 IWRC 26 mm, in air", "mass_per_length": 2.70, "EA": 2.73e7, "EI": 0, "diameter": 0.026, "breaking_load": 4.28e5,
                "axial_damping": 0.1, "drag": 0.05, "submerged_factor": 1, "color": "#222222"},
    # Polyester rope, 80 mm: 679 d² kg/m, EA 14 MBL; density 1380 kg/m³ in sea water.
    "poly80": {"description": "Polyester rope 80 mm, in water", "mass_per_length": 4.35, "EA": 2.76e7, "EI": 0, "diameter": 0.08, "breaking_load": 1.971e6,
               "axial_damping": 0.1, "drag": 15, "submerged_factor": 0.257, "color": "#2f7fb0"},
}

WINDLASS = {
    "description": "Windlass of a mooring chain, held by its brake; coordinate in rad, positive pays out.",
    "bodies": [{"name": "drum", "kind": "scalar", "mass": 2.0e4}],
    "interactions": [{"name": "brake", "kind": "hold", "bodies": ["drum"], "target": 0}],
    "inputs": [{"name": "angle", "interaction": "brake", "param": "target", "min": -50, "max": 50}],
}


def r4(v):
    return [round(float(x), 4) for x in v]


def crane():
    """Knuckle-boom crane, 23 t. Template frame: foot of the pedestal on deck, boom along x."""
    boom_deg, jib_deg = 40.0, -15.0
    u = np.array([np.cos(np.radians(boom_deg)), 0, np.sin(np.radians(boom_deg))])
    v = np.array([np.cos(np.radians(jib_deg)), 0, np.sin(np.radians(jib_deg))])
    n, m = np.array([-u[2], 0, u[0]]), np.array([-v[2], 0, v[0]])
    heel, knuckle = np.array([0.5, 0, 5.0]), np.array([0.5, 0, 5.0]) + 11 * u
    tip = knuckle + 7 * v
    hook = tip - [0, 0, 8.0 + 0.5]
    bodies = [
        {"name": "tower", "position": [0, 0, 2.5], "mass": 9000, "cylinder": {"radius": 1.0, "length": 5, "axis": "z"}},
        {"name": "boom", "position": r4(heel + 5.5 * u), "euler_deg": [0, -boom_deg, 0], "mass": 6500, "box": [5.5, 0.5, 0.6]},
        {"name": "jib", "position": r4(knuckle + 3.5 * v), "euler_deg": [0, -jib_deg, 0], "mass": 2800, "box": [3.5, 0.35, 0.4]},
        {"name": "hook", "position": r4(hook), "mass": "${hook_mass}", "box": [0.4, 0.4, 0.5],
         "linear_damping": 50, "angular_damping": 50},
        {"name": "hoist", "kind": "scalar", "mass": 200},
    ]
    joints = [
        {"name": "slew", "kind": "hinge", "bodies": ["base", "tower"], "at": [0, 0, 0], "axis": [0, 0, 1]},
        {"name": "slew_motor", "kind": "hinge_motor", "bodies": ["base", "tower"], "axis": [0, 0, 1],
         "speed": 0, "force_min": -1.5e6, "force_max": 1.5e6},
        {"name": "heel", "kind": "hinge", "bodies": ["tower", "boom"], "at": r4(heel), "axis": [0, 1, 0]},
        {"name": "knuckle", "kind": "hinge", "bodies": ["boom", "jib"], "at": r4(knuckle), "axis": [0, 1, 0]},
        {"name": "hoist_motor", "kind": "scalar_motor", "bodies": ["hoist"], "speed": 0, "force_min": -6e4, "force_max": 6e4},
    ]
    inputs = [{"name": "slew_speed", "interaction": "slew_motor", "param": "speed", "min": -0.1, "max": 0.1},
              {"name": "hoist_speed", "interaction": "hoist_motor", "param": "speed", "min": -3, "max": 3}]
    # The two luffing cylinders: foot, head, masses of barrel and rod, bodies at foot and head.
    for name, foot, head, mb, mr, a, b in (
            ("luff", np.array([1.3, 0, 1.8]), heel + 4.5 * u - 0.6 * n, 900, 600, "tower", "boom"),
            ("fold", heel + 5.0 * u - 0.5 * n, knuckle + 2.0 * v - 0.6 * m, 350, 250, "boom", "jib")):
        length = np.linalg.norm(head - foot)
        c = (head - foot) / length
        pitch = -float(np.degrees(np.arctan2(c[2], c[0])))
        bl, rl = 0.6 * length, 0.6 * length
        for part, at, mass, l, r in (("barrel", foot + c * bl / 2, mb, bl, 0.2), ("rod", head - c * rl / 2, mr, rl, 0.1)):
            bodies.append({"name": f"{name}_{part}", "position": r4(at), "euler_deg": [0, round(pitch, 4), 0], "mass": mass,
                           "cylinder": {"radius": r, "length": round(l, 3), "axis": "x"}})
        joints += [
            {"name": f"{name}_foot", "kind": "universal", "bodies": [a, f"{name}_barrel"],
             "at": r4(foot), "axes": [[0, 1, 0], r4([-c[2], 0, c[0]])]},
            {"name": f"{name}_bore", "kind": "prismatic", "bodies": [f"{name}_barrel", f"{name}_rod"], "at": r4(foot + c * bl), "axis": r4(c)},
            {"name": f"{name}_head", "kind": "ball", "bodies": [f"{name}_rod", b], "at": r4(head)},
            {"name": f"{name}_motor", "kind": "slide_motor", "bodies": [f"{name}_barrel", f"{name}_rod"], "at": r4(foot + c * bl),
             "axis": r4(c), "speed": 0, "force_min": -2e6, "force_max": 2e6}]
        inputs.append({"name": f"{name}_speed", "interaction": f"{name}_motor", "param": "speed", "min": -0.2, "max": 0.2})
    wire = {"name": "wire", "line_type": "hoist26", "from": {"body": "jib", "point": [3.5, 0, 0]},
            "to": {"body": "hook", "point": [0, 0, 0.5]}, "length": 8, "elements": 6,
            "winch": {"drum": "hoist", "radius": 0.3}}
    loads = [((2500 if b["name"] == "hook" else b["mass"]) * G, np.array(b["position"])) for b in bodies if "position" in b]
    return {"description": "Knuckle-boom crane of 23 t. Frame: foot of the pedestal on deck, z up, boom along x; bind \"base\" "
                           "to the hull that carries it.",
            "parameters": {"hook_mass": 2500}, "bodies": bodies, "interactions": joints, "cables": [wire], "inputs": inputs}, loads


CRANE, CRANE_LOADS = crane()


def AHTS(ship, water, roller, roller_mass, deck_anchors, crane_at):
    """Anchor handler of 80 m. Template frame: the hull's, at its centre of mass, x forward."""
    return {
        "description": "Anchor handler of 80 m. Frame: the hull's, at its centre of mass, x forward. thrust: along x of "
                       "the world [N].",
        "parameters": {"thrust": 0},
        "bodies": [
            {"name": "hull", "mass": ship["mass"], "inertia": ship["inertia"], "gravity": False, "half_size": [40, 9, 4],
             "force": ["${thrust}", 0, 0], "linear_damping": [6e4, 2e5, 0], "angular_damping": [0, 0, 1.5e8]},
            {"name": "roller", "position": list(roller), "mass": roller_mass, "cylinder": {"radius": 1.75, "length": 6, "axis": "y"},
             "angular_damping": [0, 5e4, 0]},
            {"name": "tow_drum", "kind": "scalar", "mass": 8e4},
            {"name": "work_drum", "kind": "scalar", "mass": 8e4},
            {"name": "deck_anchors", "position": list(deck_anchors[1]), "mass": deck_anchors[0], "box": [2.5, 2.5, 0.8]},
        ],
        "interactions": [
            water,
            {"name": "roller_bearing", "kind": "hinge", "bodies": ["hull", "roller"], "at": list(roller), "axis": [0, 1, 0]},
            {"name": "tow_winch", "kind": "scalar_motor", "bodies": ["tow_drum"], "speed": 0, "force_min": -6e6, "force_max": 6e6},
            {"name": "work_winch", "kind": "scalar_motor", "bodies": ["work_drum"], "speed": 0, "force_min": -6e6, "force_max": 6e6},
            {"name": "lashing", "kind": "lock", "bodies": ["hull", "deck_anchors"],
             "at": [deck_anchors[1][0], deck_anchors[1][1], deck_anchors[1][2] - 0.8]},
        ],
        "instances": [
            {"template": "crane", "name": "crane", "on": "hull", "position": list(crane_at[0]),
             "euler_deg": [0, 0, crane_at[1]], "bind": {"base": "hull"}},
        ],
        "inputs": [
            {"name": "tow_speed", "interaction": "tow_winch", "param": "speed", "min": -0.8, "max": 0.8},
            {"name": "work_speed", "interaction": "work_winch", "param": "speed", "min": -0.8, "max": 0.8},
            {"name": "thrust_x", "body": "hull", "component": "force_x", "min": -1.8e6, "max": 1.8e6},
            {"name": "thrust_y", "body": "hull", "component": "force_y", "min": -6e5, "max": 6e5},
        ],
    }
