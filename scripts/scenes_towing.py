# SPDX-License-Identifier: Apache-2.0
"""Scenes of winches that pay out long wires: an anchor is lowered and heaved, a tug pays out its tow line."""

from math import asinh, hypot, sqrt

from scene_writer import write

G = 9.81
WIRE = {"mass_per_length": 23, "EA": 2.33e8, "diameter": 0.076, "breaking_load": 3.658e6, "drag": 20}
WEIGHT = 0.87 * WIRE["mass_per_length"] * G  # in water [N/m]
PARTS = ["parts/lines.json"]


def ramp(begin, before, after, steps=20):
    """Change the speed of the winch in small steps over 2 s, so that the wire stays taut."""
    return [{"at": round(begin + 2 * k / steps, 3),
             "set": {"winch.speed": round(before + (after - before) * k / steps, 4)}}
            for k in range(1, steps + 1)]


def payout():
    """The anchor is lowered by 600 m at 1 m/s and heaved again."""
    start, element, anchor = 40.0, 10.0, 13000
    pull = anchor * G + 0.5 * start * WEIGHT
    write({
        "name": "payout",
        "description": "A winch lowers an anchor of 13 t by 600 m at 1 m/s on 76 mm wire, waits "
                       "and heaves it up again: nodes come and go at the drum.",
        "settings": {"duration": 1240}, "include": PARTS,
        "bodies": [{"name": "anchor", "kind": "lump", "position": [0, 0, -start], "mass": anchor,
                    "linear_damping": 4000}],
        "cables": [{"name": "wire", "line_type": "wire76", "from": {"at": [0, 0, 0]},
                    "to": {"body": "anchor"}, "elements": int(start / element),
                    "consistent_mass": True,
                    "length": round(start / (1 + pull / WIRE["EA"]), 6)}],
        "winches": [{"name": "winch", "cable": "wire", "core_radius": 0.6, "width": 2.4,
                     "stored": 900, "inertia": 4e4, "torque_haul": 4e5, "torque_pay": 4e5,
                     "brake_static": 1e6, "band_friction": 0.3, "band_angle": 4.7,
                     "element": element, "mode": "brake"}],
        "timeline": [
            {"at": 0, "set": {"winch.mode": "speed"}}, *ramp(5, 0, 1), *ramp(603, 1, 0),
            *ramp(620, 0, -1), *ramp(1218, -1, 0), {"at": 1230, "set": {"winch.mode": "brake"}}],
        "plot": {"tensions": ["wire"], "motions": ["anchor"]},
    })


# Steady tow: the drag of tug and barge by speed, linear [N s/m].
THRUST, TUG_DRAG, BARGE_DRAG = 5e5, 4e4, 1.6e5
ELEMENT, ON_DECK, OUTBOARD = 5.5, 4, 55  # [m], elements
ROLLER_X, ROLLER_Z, ROLLER_RADIUS = -28.0, 1.5, 1.0  # in the tug's frame [m]


def floating(name, at, mass, half, radii, area, gm, gml, drag, **more):
    """Return a hull and its hydrostatic spring; a tenth of critical damping."""
    inertia = [mass * r * r for r in radii]
    heave, roll, pitch = 1025 * G * area, mass * G * gm, mass * G * gml
    damping = [round(0.2 * sqrt(k * m), -3)
               for k, m in ((heave, mass), (roll, inertia[0]), (pitch, inertia[1]))]
    body = {"name": name, "position": at, "mass": mass, "inertia": inertia, "gravity": False,
            "half_size": half, "linear_damping": [drag, 5 * drag, 0],
            "angular_damping": [0, 0, 0.05 * inertia[2]], **more}
    water = {"name": f"{name}_water", "kind": "hydrostatic", "bodies": [name],
             "heave_stiffness": round(heave), "roll_stiffness": round(roll),
             "pitch_stiffness": round(pitch), "heave_damping": damping[0],
             "roll_damping": damping[1], "pitch_damping": damping[2], "rest_height": at[2]}
    return body, water


def line_at(h, s, whole):
    """Return distances astern and up of the wire s [m] of `whole` behind the roller. It is an
    elastic catenary between two ends of equal height, h its horizontal tension [N]."""
    v0 = -0.5 * WEIGHT * whole
    v = v0 + WEIGHT * s
    x = h / WEIGHT * (asinh(v / h) - asinh(v0 / h)) + h * s / WIRE["EA"]
    z = (hypot(h, v) - hypot(h, v0)) / WEIGHT + (v * v - v0 * v0) / (2 * WEIGHT * WIRE["EA"])
    return x, z


def tow_payout():
    """The tow line runs over the roller from the winch on deck to the barge."""
    speed = THRUST / (TUG_DRAG + BARGE_DRAG)
    pull = THRUST - TUG_DRAG * speed
    height = 0.5
    top_x, top_z = ROLLER_X, height + ROLLER_Z + ROLLER_RADIUS + 0.5 * WIRE["diameter"]
    winch_x, winch_z = top_x + ON_DECK * ELEMENT, top_z - 0.4
    # On deck it is lower than the roller's top, so that it turns by 5 degrees there.
    nodes = [(winch_x + (top_x - winch_x) * k / ON_DECK, winch_z + (top_z - winch_z) * k / ON_DECK)
             for k in range(1, ON_DECK + 1)]
    astern = [line_at(pull, k * ELEMENT, OUTBOARD * ELEMENT) for k in range(1, OUTBOARD + 1)]
    nodes += [(top_x - x, top_z + z) for x, z in astern]
    end_x, end_z = nodes.pop()
    tug, tug_water = floating(
        "tug", [0, 0, height], 1.5e6, [30, 7, 4], (5, 15, 15), 500, 1.2, 50, TUG_DRAG,
        force=[THRUST, 0, 0], velocity=[speed, 0, 0])
    bow = [45, 0, 2]
    barge, barge_water = floating(
        "barge", [round(end_x - bow[0], 4), 0, round(end_z - bow[2], 4)], 6e6,
        [45, 12.5, 4], (8, 26, 26), 2000, 8, 150, BARGE_DRAG, velocity=[speed, 0, 0])
    roller = {"name": "roller", "position": [ROLLER_X, 0, height + ROLLER_Z],
              "mass": 20000, "cylinder": {"radius": ROLLER_RADIUS, "length": 6, "axis": "y"},
              "angular_damping": [0, 20000, 0], "velocity": [speed, 0, 0],
              "shapes": [{"kind": "cylinder", "radius": ROLLER_RADIUS, "length": 6, "axis": "y",
                          "material": "roller", "groups": "ship"}]}
    write({
        "name": "tow_payout",
        "description": "A tug of 1,500 t tows a barge of 6,000 t with 500 kN of thrust on 300 m "
                       "of 76 mm wire, from the winch on deck over the stern roller. It pays out "
                       "50 m more at 1 m/s, brakes, and settles.",
        "settings": {"duration": 400}, "include": PARTS,
        "materials": {"wire": {}, "roller": {}},
        "material_pairs": [{"between": ["wire", "roller"], "friction": 0.2, "stiffness": 1e7}],
        "bodies": [tug, roller, barge],
        "interactions": [tug_water, barge_water, {
            "name": "roller_bearing", "kind": "hinge", "bodies": ["tug", "roller"],
            "at": roller["position"], "axis": [0, 1, 0]}],
        "cables": [{"name": "tow", "line_type": "wire76",
                    "from": {"body": "tug", "point": [winch_x, 0, round(winch_z - height, 4)]},
                    "to": {"body": "barge", "point": bow},
                    "elements": ON_DECK + OUTBOARD, "consistent_mass": True,
                    "length": (ON_DECK + OUTBOARD) * ELEMENT,
                    "shape": [[round(x, 4), 0, round(z, 4)] for x, z in nodes],
                    "contact": {"material": "wire", "groups": "wires", "touches": "ship"}}],
        "winches": [{"name": "winch", "cable": "tow", "core_radius": 0.6, "width": 2.4,
                     "stored": 900, "inertia": 4e4, "torque_haul": 1.5e6, "torque_pay": 1.5e6,
                     "brake_static": 3e6, "band_friction": 0.3, "band_angle": 4.7,
                     "element": ELEMENT, "mode": "brake"}],
        "timeline": [{"at": 20, "set": {"winch.mode": "speed", "winch.speed": 1}},
                     {"at": 70, "set": {"winch.mode": "brake"}}],
        "plot": {"tensions": ["tow"], "motions": ["tug", "barge"]},
    })


def main():
    payout()
    tow_payout()


if __name__ == "__main__":
    main()
