#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write exercises/anchor_over_roller.scene.json.

An anchor handler of 5,000 t (75 x 18 m, still water by a hydrostatic stiffness) has an anchor of 15 t
on its work wire of 76 mm. The anchor hangs over the stern roller, 12 m under water, above a seabed at
60 m. The wire leads along the deck, over the roller and down. Every element carries the anchor's
weight in water, so that it starts almost at rest.
"""
import json
import math
from pathlib import Path

G, RHO, EA = 9.81, 1025.0, 2.33e8
MASS, STEEL = 15000.0, 7850.0
ELEMENT, ROLLER, STERN, AXLE = 4.0, 1.0, -38.0, 2.2

WIRE = json.loads((Path(__file__).resolve().parent.parent / "scenes/parts/lines.json").read_text())
WIRE = WIRE["line_types"]["wire76"]
buoyancy = MASS / STEEL * RHO * G
stretched = ELEMENT * (1.0 + (MASS * G - buoyancy) / EA)
over = 0.4 * ELEMENT
deck = [[round(STERN + over + k * stretched, 4), 0, AXLE + ROLLER] for k in range(8, -1, -1)]
first = stretched - over - 0.5 * math.pi * ROLLER
hanging = [[STERN - ROLLER, 0, round(AXLE - first - k * stretched, 4)] for k in range(4)]
path, top = deck + hanging[:-1], hanging[-1]
half = [1.6, 1.6, 1.0]

scene = {
    "$schema": "../schema/scene-1.json",
    "version": 1,
    "name": "anchor_over_roller",
    "description": " ".join(__doc__.split("\n\n")[1].split()),
    "settings": {"duration": 300},
    "line_types": {"wire76": WIRE},  # like scenes/parts/lines.json
    "materials": {"sand": {}, "steel": {}},
    "material_pairs": [{"between": ["steel", "sand"], "friction": 0.8, "stiffness": 2e6}],
    "bodies": [
        {"name": "ahts", "position": [0, 0, 0], "mass": 5e6, "inertia": [2e8, 2.3e9, 2.4e9],
         "half_size": [37.5, 9, 3], "gravity": False, "force": [-30000, 0, 0],
         "linear_damping": [1e5, 5e5, 0], "angular_damping": [0, 0, 1e9]},
        {"name": "anchor", "position": [top[0], 0, round(top[2] - half[2], 4)], "mass": MASS,
         "box": half, "force": [0, 0, round(buoyancy, 1)], "linear_damping": [8e3, 8e3, 1.2e4],
         "angular_damping": [2e4, 2e4, 2e4],
         "shapes": [{"kind": "box", "half_size": half, "material": "steel"}]},
        {"name": "seabed", "kind": "fixed", "position": [0, 0, -60],
         "shapes": [{"kind": "plane", "material": "sand"}]},
    ],
    "interactions": [
        {"name": "ahts_water", "kind": "hydrostatic", "bodies": ["ahts"], "heave_stiffness": 1.09e7,
         "roll_stiffness": 7.4e7, "pitch_stiffness": 3.9e9, "heave_damping": 4e6,
         "roll_damping": 2.4e7, "pitch_damping": 1.2e9}],
    "cables": [
        {"name": "work", "line_type": "wire76", "from": {"body": "ahts", "point": path[0]},
         "to": {"body": "anchor", "point": [0, 0, half[2]]}, "elements": len(path),
         "consistent_mass": True, "length": ELEMENT * len(path), "shape": path[1:]}],
    "winches": [
        {"name": "winch", "cable": "work", "core_radius": 0.6, "width": 2.4, "stored": 500,
         "inertia": 4e4, "torque_haul": 8e5, "torque_pay": 8e5, "brake_static": 1.5e6,
         "element": ELEMENT, "mode": "brake"}],
    "guides": [
        {"name": "roller", "cable": "work", "on": "ahts", "point": [STERN, 0, AXLE],
         "axis": [0, -1, 0], "radius": ROLLER, "friction": 0.1}],
    "plot": {"tensions": ["work"], "motions": ["anchor", "ahts"]},
}
file = Path(__file__).resolve().parent.parent / "exercises" / "anchor_over_roller.scene.json"
file.write_text(json.dumps(scene, indent=1) + "\n")
