# SPDX-License-Identifier: Apache-2.0
"""Scenes of wires and chains with contact (docs/validation.md)."""

import math

from scene_writer import write
from scenes_contact import G, STEP


def wire_cylinder():
    """The wire touches at the middles of its elements, which are tangents of the cylinder 180°/32
    apart. The first and the last tangent are vertical and continue as the straight parts."""
    turns, straight, touch, load, EA = 32, 24, 1.02, 1e3, 1e6
    angle = math.pi / turns
    corner, element = touch / math.cos(angle / 2), 2 * touch * math.tan(angle / 2)
    arc = [[corner * math.cos((k + 0.5) * angle), 0, corner * math.sin((k + 0.5) * angle)]
           for k in range(turns)]
    below = [-element * (k + 0.5) for k in range(straight + 1)]
    nodes = ([[touch, 0, z] for z in reversed(below[1:-1])] + [[touch, 0, below[0]]] + arc
             + [[-touch, 0, z] for z in below[:-1]])
    # arc[0] is half an element above the first touching point, below[0] half one below it.
    end = below[-1]
    write({
        "name": "wire_cylinder",
        "description": "A wire is pulled at 5 cm/s over half the circumference of a fixed "
                       "cylinder against 1 kN, without gravity; friction 0.3. The pull is "
                       "e^(0.3 pi) = 2.566 times the load.",
        "settings": {"step": 1 / 240, "duration": 10, "gravity": [0, 0, 0]},
        "line_types": {"wire": {"mass_per_length": 20, "EA": EA, "diameter": 0.04}},
        "material_pairs": [{"between": ["default", "default"], "friction": 0.3, "stiffness": 1e6}],
        "bodies": [{"name": "cylinder", "kind": "fixed", "shapes": [
                        {"kind": "cylinder", "radius": 1, "length": 1, "axis": "y"}]},
                   {"name": "load", "position": [touch, 0, end], "mass": 100, "sphere": 0.2,
                    "force": [0, 0, -load]},
                   {"name": "pull", "kind": "kinematic", "position": [-touch, 0, end],
                    "velocity": [0, 0, -0.05]}],
        "cables": [{"name": "wire", "line_type": "wire", "from": {"body": "load"},
                    "to": {"body": "pull"}, "shape": nodes,
                    # The tension of the load along the whole wire avoids a fall at the start.
                    "length": (len(nodes) + 1) * element / (1 + load / EA), "contact": {}}],
        "plot": {"tensions": ["wire"], "motions": ["load"]},
    })


def chain_pile():
    """Flakes of chain on deck, the second layer across the first, dropped from 5 cm."""
    flakes, per, l, d = 6, 8, 0.25, 0.1
    k, weight = 2e5, 20 * l * G
    low, high = d / 2 - weight / k, 3 * d / 2 + 0.05
    nodes = []
    for i in range(flakes):
        row = [[j * l - per * l / 2, (i - flakes / 2 + 0.5) * l, low] for j in range(per + 1)]
        nodes += row if i % 2 == 0 else row[::-1]
    x, y, _ = nodes[-1]
    nodes.append([x - 0.6 * l, y + 0.6 * l, (low + high) / 2])  # from one layer up to the next
    for i in range(flakes):
        row = [[x + (i - flakes / 2) * l, (j - per / 2) * l, high] for j in range(per, -1, -1)]
        nodes += row if i % 2 == 0 else row[::-1]
    # The layers are stacked: x of the second one about zero.
    shift = sum(n[0] for n in nodes[-flakes * (per + 1):]) / (flakes * (per + 1))
    for n in nodes[-flakes * (per + 1):]:
        n[0] -= shift
    nodes[flakes * (per + 1)] = [(a + b) / 2 for a, b in zip(nodes[flakes * (per + 1) - 1],
                                                            nodes[flakes * (per + 1) + 1])]
    write({
        "name": "chain_pile",
        "description": "Chain of 20 kg/m flaked on a deck, a second layer of it across the first "
                       "falls from 5 cm.",
        "settings": {"step": STEP, "duration": 5, "contact_margin": 0.02},
        "line_types": {"chain": {"mass_per_length": 20, "EA": 1e7, "diameter": d}},
        "material_pairs": [{"between": ["default", "default"], "friction": 0.5, "stiffness": k}],
        "bodies": [{"name": "deck", "kind": "fixed", "position": [0, 0, -0.5],
                    "shapes": [{"kind": "box", "half_size": [5, 5, 0.5]}]}],
        "cables": [{"name": "chain", "line_type": "chain", "from": {"free": nodes[0]},
                    "to": {"free": nodes[-1]}, "shape": nodes[1:-1], "contact": {}}],
        "plot": {"motions": []},
    })


def anchor_drag():
    """A chain lies on sand from an anchor to a tug at the height of the chain's end."""
    l, n, d, m, w = 2.0, 60, 0.137, 126.5, 0.87
    k_soil = 1e5 * d * l  # of a node [N/m]
    depth = m * l * w * G / k_soil
    mass, half = 15000.0, (2.5, 2.5, 0.8)
    sunk = 0.87 * mass * G / (4 * 1e6)
    z = d / 2 - depth
    start = half[0]
    write({
        "name": "anchor_drag",
        "description": "An anchor of 15 t is dragged over sand at 0.3 m/s by 120 m of chain that "
                       "lies on it. Friction 0.8 (anchor), 0.7 (chain).",
        "settings": {"step": STEP, "duration": 20},
        "line_types": {"chain76": {"mass_per_length": m, "EA": 5.83e8, "EI": 1e4, "diameter": d,
                                   "drag": 30, "submerged_factor": w}},
        "materials": {"sand": {}, "chain": {}, "anchor": {}},
        "material_pairs": [
            {"between": ["chain", "sand"], "friction": 0.7, "stiffness": k_soil},
            {"between": ["anchor", "sand"], "friction": 0.8, "stiffness": 1e6}],
        "bodies": [
            {"name": "seabed", "kind": "fixed", "position": [80, 0, 0], "shapes": [
                {"kind": "heightfield", "rows": 21, "columns": 41, "cell": [5, 5],
                 "material": "sand"}]},
            {"name": "anchor", "position": [0, 0, half[2] - sunk], "mass": mass, "box": half,
             "force": [0, 0, 0.13 * mass * G], "shapes": [
                 {"kind": "box", "half_size": half, "material": "anchor"}]},
            {"name": "tug", "kind": "kinematic", "position": [start + n * l, 0, z],
             "velocity": [0.3, 0, 0]}],
        "cables": [{"name": "chain", "line_type": "chain76", "elements": n,
                    "from": {"body": "anchor", "point": [start, 0, z - half[2] + sunk]},
                    "to": {"body": "tug"}, "contact": {"material": "chain"}}],
        "plot": {"tensions": ["chain"], "motions": ["anchor"]},
    })


def main():
    wire_cylinder()
    chain_pile()
    anchor_drag()


if __name__ == "__main__":
    main()
