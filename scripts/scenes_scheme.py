# SPDX-License-Identifier: Apache-2.0
"""Scenes of one or two bodies: pendulums and the properties of the time stepper."""

import math

from scene_writer import write


def pendulum(name, angle_deg, text):
    a = math.radians(angle_deg)
    x, z = (-1.0, 0.0) if angle_deg == 90 else (-math.sin(a), -math.cos(a))
    write({
        "name": name,
        "description": text,
        "settings": {"step": 1 / 120, "duration": 10},
        "bodies": [{"name": "bob", "kind": "lump", "position": [x, 0, z], "mass": 1}],
        "interactions": [{"name": "rod", "kind": "distance", "bodies": ["world", "bob"],
                          "length": 1, "compliance": 1e-12}],
        "plot": {"motions": ["bob"]},
    })


def one_lump(name, text, settings, length, x, more):
    write({
        "name": name,
        "description": text,
        "settings": settings,
        "bodies": [{"name": "bob", "kind": "lump", "position": x, "mass": 1}],
        "interactions": [{"name": "spring", "kind": "distance", "bodies": ["world", "bob"],
                          "length": length, **more}],
        "plot": {"motions": ["bob"]},
    })


def main():
    pendulum("pendulum", 90, "Point mass of 1 kg on a rigid rod of 1 m, released from the "
             "horizontal at x = -1 (IFToMM benchmark A01).")
    pendulum("pendulum_30", 30, "Point mass on a rigid rod of 1 m, released 30 degrees from "
             "the vertical.")
    pendulum("pendulum_small", 0.1, "Point mass on a rigid rod of 1 m, released 0.1 degrees "
             "from the vertical.")
    one_lump("scheme_static", "1 kg hangs on a soft distance row: at rest the violation is the "
             "compliance times the force, for any step.",
             {"step": 1 / 60, "duration": 60, "staggered_start": False}, 1, [0, 0, -1],
             {"compliance": 1e-3, "damping_time": 0.05})
    one_lump("scheme_decay", "A rigid distance row starts 1 m too long without gravity and comes "
             "back with the double root 1/3.",
             {"step": 1 / 60, "duration": 1, "gravity": [0, 0, 0], "staggered_start": False},
             10, [11, 0, 0], {"compliance": 0, "damping_time": 1 / 30})
    one_lump("scheme_oscillator", "1 kg on a spring of 1 kN/m along x without gravity or damping.",
             {"step": 1 / 60, "duration": 10, "gravity": [0, 0, 0]},
             100, [100.05, 0, 0], {"compliance": 1e-3, "damping_time": 0})
    write({
        "name": "scheme_chain",
        "description": "Three masses in line on undamped springs without gravity: a linear "
                       "system with three modes.",
        "settings": {"step": 1 / 60, "duration": 10, "gravity": [0, 0, 0]},
        "defaults": {"damping_time": 0},
        "bodies": [{"name": f"m{i}", "kind": "lump", "position": [x, 0, 0], "mass": m}
                   for i, x, m in ((1, 1.02, 1.0), (2, 1.97, 2.0), (3, 3.01, 0.5))],
        "interactions": [{"name": f"s{i}", "kind": "distance", "bodies": [a, b], "length": 1,
                          "compliance": c, "damping_time": 0}
                         for i, a, b, c in ((1, "world", "m1", 1e-3), (2, "m1", "m2", 3e-4),
                                            (3, "m2", "m3", 1e-5))],
        "plot": {"motions": ["m3"]},
    })
