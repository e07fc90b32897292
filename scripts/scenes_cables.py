# SPDX-License-Identifier: Apache-2.0
"""Scenes of lumped cables and beams with known statics, frequencies or invariants."""

import math

from scene_writer import write


def catenary():
    """Span 80 m, length 100 m: starts as a V of two straight halves (30-40-50) and settles."""
    n = 100
    points = [[40 - 0.8 * (50 - i), 0, -0.6 * i] for i in range(1, 51)]
    points += [[0.8 * i, 0, -30 + 0.6 * (i - 50)] for i in range(51, n)]
    write({
        "name": "catenary",
        "description": "A cable of 100 m between two fixed points 80 m apart at one height, "
                       "started as a V and damped until it hangs as a catenary.",
        "settings": {"step": 1 / 60, "duration": 60},
        "line_types": {"rope": {"mass_per_length": 10, "EA": 1e8, "drag": 10}},
        "cables": [{"name": "rope", "line_type": "rope", "from": {"at": [0, 0, 0]},
                    "to": {"at": [80, 0, 0]}, "length": 100, "elements": n, "shape": points}],
        "plot": {"tensions": ["rope"]},
    })


def hanging_chain():
    """20 elements of 0.5 m hang from the origin, each stretched by the weight below it."""
    n, length, density, stiffness, g = 20, 10.0, 1.0, 1e6, 9.81
    l = length / n
    z, points = 0.0, []
    for i in range(n):
        below = density * l * (n - i - 0.5)
        z -= l * (1 + below * g / stiffness)
        points.append([0, 0, z])
    write({
        "name": "hanging_chain",
        "description": "A chain of 10 m and 1 kg/m hangs from a fixed point in equilibrium; the "
                       "last node is half a node.",
        "settings": {"step": 1 / 240, "duration": 20},
        "line_types": {"chain": {"mass_per_length": density, "EA": stiffness}},
        "cables": [{"name": "chain", "line_type": "chain", "from": {"at": [0, 0, 0]},
                    "to": {"free": points[-1]}, "length": length, "elements": n,
                    "shape": points[:-1]}],
        "plot": {"tensions": ["chain"]},
    })


def taut_string():
    length, tension, stiffness = 100.0, 1e6, 1e9
    write({
        "name": "taut_string",
        "description": "A string of 100 m, 25 kg/m, between fixed points under 1 MN without "
                       "gravity.",
        "settings": {"step": 1 / 240, "duration": 10, "gravity": [0, 0, 0]},
        "line_types": {"string": {"mass_per_length": 25, "EA": stiffness}},
        "cables": [{"name": "string", "line_type": "string", "from": {"at": [0, 0, 0]},
                    "to": {"at": [length, 0, 0]}, "length": length / (1 + tension / stiffness),
                    "elements": 20}],
        "plot": {"tensions": ["string"]},
    })


def beams():
    """Elements of 0.25 m of the beam of the MoorDyn tests: 980.665 N/m, 10 m, EI = 1e7."""
    n, length, ei = 40, 10.0, 1e7
    l = length / n
    beam = {"mass_per_length": 100, "EA": 1e7, "EI": ei, "drag": 1000}
    settings = {"step": 1 / 60, "duration": 20, "gravity": [0, 0, -9.80665]}
    write({
        "name": "cantilever",
        "description": "A beam of 10 m and EI = 1e7 N m² sags under its own weight of 980.665 "
                       "N/m from a clamp. The clamp is a bend with a node inside the wall; only "
                       "half an element bends there, so its length is half an element.",
        "settings": settings,
        "line_types": {"beam": beam},
        "bodies": [{"name": "inside", "kind": "fixed", "position": [-l, 0, 0]}],
        "cables": [{"name": "beam", "line_type": "beam", "from": {"at": [0, 0, 0]},
                    "to": {"free": [length, 0, 0]}, "elements": n, "tension_only": False}],
        "interactions": [{"name": "clamp", "kind": "bend",
                          "bodies": ["inside", "beam/0", "beam/1"], "EI": ei, "length": l / 2}],
        "plot": {"tensions": ["beam"]},
    })
    write({
        "name": "simply_supported",
        "description": "The same beam on two pins. EA = 1e7 N is so small that the pull of the "
                       "pins on the sagging beam does not matter (4e-5 of the bending load).",
        "settings": settings,
        "line_types": {"beam": beam},
        "cables": [{"name": "beam", "line_type": "beam", "from": {"at": [0, 0, 0]},
                    "to": {"at": [length, 0, 0]}, "elements": n, "tension_only": False}],
        "plot": {"tensions": ["beam"]},
    })


def euler_column():
    write({
        "name": "euler_column",
        "description": "A pinned column of 10 m, EI = 1e5 N m², pressed between fixed points by "
                       "its own excess of length. Its load is EA (1 - 10 m / length).",
        "settings": {"step": 1 / 480, "duration": 10, "gravity": [0, 0, 0]},
        "line_types": {"column": {"mass_per_length": 1, "EA": 1e9, "EI": 1e5}},
        "cables": [{"name": "column", "line_type": "column", "from": {"at": [0, 0, 0]},
                    "to": {"at": [0, 0, 10]}, "length": 10.00008, "elements": 10,
                    "tension_only": False}],
        "plot": {"tensions": ["column"]},
    })


def cable_momentum():
    write({
        "name": "cable_momentum",
        "description": "Two bodies joined by a bending cable drift and tumble without gravity, "
                       "with a hinged arm on one and a ball-jointed one on the other: nothing "
                       "outside acts on them.",
        "settings": {"step": 1 / 60, "duration": 60, "gravity": [0, 0, 0]},
        "line_types": {"rope": {"mass_per_length": 2, "EA": 1e6, "EI": 50}},
        "bodies": [
            {"name": "a", "position": [0, 0, 0], "velocity": [0.5, 1, 0.2],
             "angular_velocity": [0.3, -0.2, 0.5], "mass": 400, "box": [0.5, 0.4, 0.3]},
            {"name": "arm", "position": [-1.5, 0, 0], "velocity": [0.5, 0.25, -0.1],
             "angular_velocity": [0.3, -0.2, 0.5], "mass": 40, "box": [1, 0.1, 0.1]},
            {"name": "b", "position": [21, 0, 0], "velocity": [0.8, -0.5, 0.4],
             "angular_velocity": [-0.4, 0.1, 0.2], "mass": 300, "box": [0.5, 0.5, 0.5]},
            {"name": "ball", "position": [22.5, 0, 0], "velocity": [0.8, -0.2, 0.25],
             "angular_velocity": [-0.4, 0.1, 0.2], "mass": 60, "sphere": 0.3}],
        "cables": [{"name": "rope", "line_type": "rope",
                    "from": {"body": "a", "point": [0.5, 0, 0]},
                    "to": {"body": "b", "point": [-0.5, 0, 0]}, "elements": 40}],
        "interactions": [
            {"name": "elbow", "kind": "hinge", "bodies": ["a", "arm"], "at": [-0.5, 0, 0],
             "axis": [0, 1, 0]},
            {"name": "socket", "kind": "ball", "bodies": ["b", "ball"], "at": [21.5, 0, 0]}],
        "plot": {"tensions": ["rope"], "motions": ["a", "b"]},
    })


def cable_spin():
    """A ring of 12 masses, radius 2 m, with an initial rotation about a tilted axis."""
    n, radius, tilt = 12, 2.0, math.radians(30)
    spin = (0.0, 1.5 * math.sin(tilt), 1.5 * math.cos(tilt))
    bodies, elements = [], []
    for i in range(n):
        x, y = radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n)
        bodies.append({"name": f"m{i}", "kind": "lump", "position": [x, y, 0],
                       "velocity": [0.3 - spin[2] * y, spin[2] * x, -spin[1] * x],
                       "mass": 1 + i % 3})
        elements.append({"name": f"s{i}", "kind": "stretch",
                         "bodies": [f"m{i}", f"m{(i + 1) % n}"], "EA": 1e4, "tension_only": 0})
    write({
        "name": "cable_spin",
        "description": "A closed ring of 12 unequal masses on elastic lines, thrown with a spin: "
                       "nothing outside acts on it.",
        "settings": {"step": 1 / 60, "duration": 60, "gravity": [0, 0, 0]},
        "bodies": bodies, "interactions": elements, "plot": {"motions": ["m0"]},
    })


def main():
    cable_spin()
    catenary()
    hanging_chain()
    taut_string()
    beams()
    euler_column()
    cable_momentum()
