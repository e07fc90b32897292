#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write scenes/anchor_seaway.json: the site of anchor_contact in the sea of anchor_sea.

Hulls float by the pressure on their meshes and radiate waves: heave, roll and pitch have a damping
B(w) and its memory. Waves of 2.5 m and 9 s and a current of 0.8 m/s act on lines, anchors and hulls.
Chain lies on the seabed, wires run over stern rollers, cargo lies on deck, and a barge moves on its
fenders. docs/anchor_seaway.md explains the numbers.

Usage: scripts/make_anchor_seaway.py
"""
import copy
import json
import math

from make_anchor_sea import G, RHO, SCENES, afloat, in_water, ship

TYPES = ("chain76", "wire76")
BARGE_HALF, BARGE_FREEBOARD = (30.0, 7.0), 3.0
# Frequency at which a hull radiates most [rad/s].
RADIATES = {"rig": 0.5, "ahts": 0.8, "barge": 1.0}
MEMORY = 20.0  # length of the memory of a hull [s]


def line_types(types):
    """Morison's coefficients on the diameter that touches the seabed."""
    out = in_water(types)
    for name in TYPES:
        line = out[name + "_sea"]
        nominal, touching = line["diameter"], types[name]["diameter"]
        for key in ("cd_normal", "cd_tangential"):
            if key in line:
                line[key] = round(line[key] * nominal / touching, 6)
        line["diameter"] = touching
    return {name: out[name] for name in (t + "_sea" for t in TYPES)}


def radiation(water, peak):
    """Damping 4 b s^2/(1 + s^2)^2 of heave, roll and pitch, s = w/peak, at most b at the peak. Its
    memory is K = 2 b peak (1 - peak t) e^(-peak t), its added mass -(2 b/peak) (s^2 - 1)/(1 + s^2)^2
    plus `added_mass`, the one of infinite frequency."""
    steps = [0.1 + 0.1 * i for i in range(20)] + [2.2 + 0.25 * i for i in range(24)]
    pairs = []
    for mode, key in ((3, "heave"), (4, "roll"), (5, "pitch")):
        b = water[f"{key}_damping"]
        shape = [1.0 / (1.0 + s * s) ** 2 for s in steps]
        pairs.append({
            "of": [mode, mode], "infinite": 0, "zero": round(2 * b / peak),
            "added_mass": [round(-2 * b / peak * (s * s - 1) * d) for s, d in zip(steps, shape)],
            "damping": [round(4 * b * s * s * d) for s, d in zip(steps, shape)]})
    return {"frequencies": [round(peak * s, 6) for s in steps], "radiation": pairs}


def hull(body, mesh, offset, added, water, peak, area):
    return {"body": body, "mesh": mesh, "offset": [0, 0, offset], "added_mass": added + [0, 0, 0],
            "strips": area["strips"], "drag_area": area["drag"], "wind_area": area["wind"],
            "coefficients": radiation(water, peak), "radiation": "convolution", "memory": MEMORY}


def take(interactions, name):
    found = next(i for i in interactions if i["name"] == name)
    interactions.remove(found)
    return found


def in_the_water(bodies):
    """Anchors have a displacement instead of a lift and linear damping."""
    out = []
    for body in bodies:
        if "anchor" not in body["name"]:
            continue
        out.append({"body": body["name"], "volume": round(body.pop("force")[2] / RHO / G, 4),
                    "drag_area": [6.0, 6.0, 9.0], "added_mass": 1.0, "height": 1.6})
        body.pop("linear_damping")
    return out


def barge_hull(body, water):
    """A box that displaces the barge's mass."""
    body.pop("gravity")
    body["half_size"] = body.pop("box")
    half_x, half_y = BARGE_HALF
    mass = body["mass"]
    body["inertia"] = [round(mass / 3 * (half_y**2 + 3.0**2)), round(mass / 3 * (half_x**2 + 3.0**2)),
                       round(mass / 3 * (half_x**2 + half_y**2))]
    draught = mass / (RHO * 4 * half_x * half_y)
    half_z = round(0.5 * (draught + BARGE_FREEBOARD), 5)
    mesh = {"box": [half_x, half_y, half_z], "pieces": [12, 4, 3]}
    area = {"strips": [{"from": [-30, 0, -1], "to": [30, 0, -1], "drag_area": 140, "count": 10}],
            "drag": [15, 0, 0], "wind": [45, 180, 0]}
    return hull("barge", mesh, round(BARGE_FREEBOARD - half_z, 5),
                [round(f * mass) for f in (0.05, 0.5, 1.2)], water, RADIATES["barge"], area)


def text_of(scene):
    """One line for each entry of a list or object of the scene."""
    lines = []
    for key, value in scene.items():
        one = json.dumps(value)
        if isinstance(value, (list, dict)) and len(one) > 100:
            entries = ([json.dumps(v) for v in value] if isinstance(value, list) else
                       [f"{json.dumps(k)}: {json.dumps(v)}" for k, v in value.items()])
            ends = "[]" if isinstance(value, list) else "{}"
            one = ends[0] + "\n  " + ",\n  ".join(entries) + "\n " + ends[1]
        lines.append(f" {json.dumps(key)}: {one}")
    return "{\n" + ",\n".join(lines) + "\n}\n"


def main():
    contact = json.loads((SCENES / "anchor_contact.json").read_text())
    sea = json.loads((SCENES / "anchor_sea.json").read_text())["sea"]
    types = json.loads((SCENES / "parts" / "lines.json").read_text())["line_types"]
    scene = copy.deepcopy(contact)
    scene["name"] = "anchor_seaway"
    scene["description"] = (
        "The site of anchor_contact in waves of 2.5 m and 9 s and a current of 0.8 m/s: hulls float "
        "by pressure and remember the waves that they radiate, chain lies on the seabed, cargo on "
        "deck. See docs/anchor_seaway.md and scripts/make_anchor_seaway.py.")
    scene["settings"]["duration"] = 600
    scene["line_types"] |= line_types(types)
    for cable in scene["cables"]:
        if cable["line_type"] in TYPES:
            cable["line_type"] += "_sea"
    in_scene = {b["name"]: b for b in scene["bodies"]}
    water = {"rig": take(scene["interactions"], "rig_water"),
             "barge": take(scene["interactions"], "barge_water"),
             "ahts": take(scene["templates"]["handler"]["interactions"], "water")}
    handler = next(b for b in scene["templates"]["handler"]["bodies"] if b["name"] == "hull")
    afloat(handler, water["ahts"], ship().volume(), 1.0)
    afloat(in_scene["rig"], water["rig"], 2 * 80 * 15 * 8.5 + 4 * math.pi * 6.5**2 * 12.5, -1.0)
    hulls = []
    for of in sea["hulls"]:
        kind = "rig" if of["body"] == "rig" else "ahts"
        area = {"strips": of["strips"], "drag": of["drag_area"], "wind": of["wind_area"]}
        hulls.append(hull(of["body"], of["mesh"], of["offset"][2], of["added_mass"][:3],
                          water[kind], RADIATES[kind], area))
    hulls.append(barge_hull(in_scene["barge"], water["barge"]))
    scene["sea"] = {"depth": sea["depth"], "density": sea["density"], "waves": sea["waves"],
                    "current": sea["current"], "bodies": in_the_water(scene["bodies"]),
                    "hulls": hulls}
    state = scene.pop("state")  # the last key, as in the other scenes
    scene["state"] = state
    (SCENES / "anchor_seaway.json").write_text(text_of(scene))
    print({b["name"]: b["mass"] for b in scene["bodies"] if "mass" in b}, handler["mass"])


if __name__ == "__main__":
    main()
