# SPDX-License-Identifier: Apache-2.0
"""Scenes of the comparison with other engines: chains of rigid links (docs/validation.md)."""

import math

from scene_writer import cylinder, rotation, write

STEP = 1 / 60


def hydrostatic(body, mass, heave, height):
    """Heave spring with damping 0.4 sqrt(k M); roll and pitch 100 m² M, damped by 0.4 of it."""
    return {"name": f"water_{body}", "kind": "hydrostatic", "bodies": [body],
            "heave_stiffness": heave, "heave_damping": 0.4 * math.sqrt(heave * mass),
            "roll_stiffness": 100 * mass, "roll_damping": 40 * mass,
            "pitch_stiffness": 100 * mass, "pitch_damping": 40 * mass, "rest_height": height}


def heavy_hook():
    a = math.radians(20)
    write({
        "name": "heavy_hook",
        "description": "100 links of 1 m and 10 kg with a block of 50 t, released straight at "
                       "20 degrees from the vertical.",
        "settings": {"step": STEP, "duration": 10},
        "line_types": {"link": {"mass_per_length": 10}},
        "bodies": [{"name": "block", "position": [101 * math.sin(a), 0, -101 * math.cos(a)],
                    "orientation": rotation((0, 1, 0), -a), "mass": 5e4, "box": [1, 1, 1]}],
        "cables": [{"name": "chain", "line_type": "link", "as": "links", "radius": 0.05,
                    "from": {"at": [0, 0, 0]}, "to": {"body": "block", "point": [0, 0, 1]},
                    "length": 100, "elements": 100}],
        "plot": {"tensions": ["chain"], "motions": ["block"]},
    })


def hook_conical():
    """heavy_hook in rigid rotation about the vertical at 1 rad/s; x of a link is its axis."""
    a, spin = math.radians(20), [0, 0, 1]
    along = (math.sin(a), 0.0, -math.cos(a))
    q = rotation((0, 1, 0), math.pi / 2 - a)  # turns x to `along`
    bodies, joints = [], []

    def add(name, s, mass, inertia, half, turn):
        bodies.append({"name": name, "position": [s * x for x in along], "orientation": turn,
                       "velocity": [0, s * along[0], 0], "angular_velocity": spin, "mass": mass,
                       "inertia": inertia, "half_size": half})

    before = "world"
    for i in range(100):
        name = f"link{i}"
        add(name, i + 0.5, 10, cylinder(10, 0.05, 1), [0.5, 0.05, 0.05], q)
        joints.append({"name": f"joint{i}", "kind": "ball", "bodies": [before, name],
                       "at": [i * x for x in along]})
        before = name
    box = 5e4 * 2 / 3  # solid cube of half size 1 m
    add("block", 101, 5e4, [box] * 3, [1, 1, 1], rotation((0, 1, 0), -a))
    joints.append({"name": "joint100", "kind": "ball", "bodies": [before, "block"],
                   "at": [100 * x for x in along]})
    write({
        "name": "hook_conical",
        "description": "heavy_hook started as a conical swing: the straight chain at 20 degrees "
                       "rotates as one about the vertical at 1 rad/s.",
        "settings": {"step": STEP, "duration": 60},
        "bodies": bodies, "interactions": joints, "plot": {"motions": ["block"]},
    })


def tow_zigzag():
    n, mass, heave = 200, 4e6, 80 * 18 * 1025 * 9.81
    y = [0.0] + [0.05 * math.sin(math.pi * i / n) + 0.001 * (-1) ** i for i in range(1, n)] + [0.0]
    x = [40.0]
    for i in range(n):  # every link is 2 m long at any slope
        x.append(x[-1] + math.sqrt(4 - (y[i + 1] - y[i]) ** 2))
    ship = {"mass": mass, "box": [40, 9, 4], "gravity": False}
    write({
        "name": "tow_zigzag",
        "description": "A ship pulled with 500 kN tows another by 200 links of 2 m and 50 kg "
                       "that start 5 cm off the line as a sine with a zig-zag of 1 mm, without "
                       "gravity. In a straight line the tension at the second ship is 249.688 "
                       "kN.",
        "settings": {"step": STEP, "duration": 20, "gravity": [0, 0, 0]},
        "line_types": {"link": {"mass_per_length": 25}},
        "bodies": [{"name": "ship1", "position": [x[-1] + 40, 0, 0], **ship,
                    "force": [5e5, 0, 0]},
                   {"name": "ship2", "position": [0, 0, 0], **ship}],
        "interactions": [hydrostatic("ship1", mass, heave, 0),
                         hydrostatic("ship2", mass, heave, 0)],
        "cables": [{"name": "tow", "line_type": "link", "as": "links", "radius": 0.04,
                    "from": {"body": "ship2", "point": [40, 0, 0]},
                    "to": {"body": "ship1", "point": [-40, 0, 0]}, "length": 400, "elements": n,
                    "shape": [[x[i], y[i], 0] for i in range(1, n)]}],
        "plot": {"tensions": ["tow"], "motions": ["ship1", "ship2"]},
    })


SEABED, ON_SEABED = -100.1, 186.8  # height of the floor, length of line that lies on it [m]


def on_seabed(x, y):
    """Return the nodes of a mooring line that lies straight on the floor, its axis at -100 m. It
    then hangs as a catenary of a = 100 m up to its end (±35, ±35, 0)."""
    end_x, end_y = math.copysign(35, x), math.copysign(35, y)
    span = math.hypot(end_x - x, end_y - y)
    nodes = []
    for i in range(1, 90):
        s = 4.0 * i
        along, z = s, -100.0
        if s > ON_SEABED:
            s -= ON_SEABED
            along, z = ON_SEABED + 100 * math.asinh(s / 100), math.hypot(100, s) - 200
        nodes.append([x + (end_x - x) * along / span, y + (end_y - y) * along / span, z])
    return nodes


def mooring(title, description, seabed):
    rig, ship = 2e7, 4e6
    x = 433.155
    line = {"line_type": "wire", "as": "links", "radius": 0.1, "length": 360, "elements": 90,
            "shape": "catenary"}
    cables = []
    for sx, sy, corner in ((1, 1, "ne"), (-1, 1, "nw"), (-1, -1, "sw"), (1, -1, "se")):
        for i, (ax, ay) in enumerate(((302.109, 208.462), (208.462, 302.109))):
            more = {"shape": on_seabed(sx * ax, sy * ay), "contact": {}} if seabed else {}
            cables.append({"name": f"mooring_{corner}{i + 1}", **line, **more,
                           "from": {"at": [sx * ax, sy * ay, -100]},
                           "to": {"body": "rig", "point": [sx * 35, sy * 35, 0]}})
    for name, s in (("east", 1), ("west", -1)):
        cables.append({"name": f"tow_{name}", **line,
                       "from": {"body": "rig", "point": [s * 35, 0, 0]},
                       "to": {"body": f"ship_{name}", "point": [-s * 40, 0, 0]}})
    bodies = [{"name": "rig", "position": [0, 0, 0], "mass": rig, "box": [35, 35, 10],
               "gravity": False, "linear_damping": 2e5}]
    for name, s in (("east", 1), ("west", -1)):
        bodies.append({"name": f"ship_{name}", "position": [s * x, 0, 0], "mass": ship,
                       "box": [40, 9, 4], "gravity": False, "force": [s * 5e5, 0, 0],
                       "linear_damping": 1e5})
    heave = 80 * 18 * 1025 * 9.81
    touching = {}
    if seabed:
        bodies.append({"name": "seabed", "kind": "fixed", "position": [0, 0, SEABED],
                       "shapes": [{"kind": "plane"}]})
        touching["material_pairs"] = [{"between": ["default", "default"], "friction": 0.5,
                                       "stiffness": 1e7}]
    write({
        "name": title, "description": description,
        "settings": {"step": STEP, "duration": 20},
        "line_types": {"wire": {"mass_per_length": 50, "drag": 5}},
        **touching,
        "bodies": bodies,
        "interactions": [hydrostatic("rig", rig, 0.3 * 70 * 70 * 1025 * 9.81, 0),
                         hydrostatic("ship_east", ship, heave, 0),
                         hydrostatic("ship_west", ship, heave, 0)],
        "cables": cables,
        "plot": {"tensions": ["mooring_ne1", "tow_east"],
                 "motions": ["rig", "ship_east", "ship_west"]},
    })


def main():
    heavy_hook()
    hook_conical()
    tow_zigzag()
    mooring("mooring", "A rig of 20,000 t on eight mooring lines, pulled by two ships of 4,000 t "
            "with 500 kN each on tow lines. Lines of 90 rigid links of 4 m and 200 kg "
            "start as catenaries.", False)
    mooring("mooring_seabed", "The scene mooring with a floor 100.1 m below: 186.8 m of every "
            "mooring line lie on it, friction 0.5.", True)
