#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write scenes/anchor_contact.json: the site of anchor_lines with contact (numpy only).

Moorings continue along the seabed to embedded anchors. The lines of the anchor handlers run from
their winches over the stern roller. Spare chain, wire and anchors lie on deck. A barge lies
alongside the first anchor handler, on fenders. The numbers: docs/anchor_contact.md.

Usage:

    scripts/make_anchor_contact.py            write the scene
    scripts/make_anchor_contact.py --start    also write a start near its equilibrium as the state,
                                              for `hawser settle` to finish.

The start comes from the settled state of anchor_lines. Hanging parts of the lines keep their
positions. The chain on the seabed has the tension of the touch-down, at the depth at which the
bed carries its weight.
"""

import copy
import json
import pathlib
import sys

import numpy as np

from make_anchor_lines import dump, plain

ROOT = pathlib.Path(__file__).resolve().parent.parent / "scenes"
STATE = "anchor_contact.settled.json"
G = 9.81
WEIGHT = 0.87  # weight of steel in water over that in air
CHAIN_D, CHAIN_M, CHAIN_EA = 0.137, 126.5, 5.83e8
ON_BED = 76  # elements of each mooring beyond the anchor point of anchor_lines
BED_K = 1e5  # stiffness of the bed per area of chain [N/m³]
ANCHOR, ANCHOR_HALF, ANCHOR_K = 15000.0, (2.5, 2.5, 0.8), 1e6
# Hull frame of the anchor handler [m].
DECK_Z, ROLLER_AT, ROLLER_R = 1.2, (-40.0, -0.2), 1.75
WINCH_X, WIRE_D = -8.0, 0.076
WIRE_Z = ROLLER_AT[1] + ROLLER_R + WIRE_D / 2
DECK_K = 1e7
PIN_X, PIN_R, WORK_Y, TOW_Y = -37.0, 0.15, 1.0, -1.75  # guide pins, two to a wire
FLAKE, ROWS, PITCH = 20, 5, 1.2  # elements of a flake, flakes, length of an element
BARGE, BARGE_HALF, FENDER_K, FENDER_R = 2.0e6, (30.0, 7.0, 3.0), 1e6, 0.6
PRESS = 2e5  # barge on fenders [N]


def numbered(state, name, count):
    return np.array([state[f"{name}/{i}"]["p"] for i in range(1, count)])


def mooring_shape(rig_end, nodes, anchor, length, elements):
    """Return the interior nodes of the lengthened mooring. The chain leaves the old anchor point
    with its tension there. The tension loses the weight of each node until it is horizontal; then
    the chain lies straight."""
    element = length / elements
    last = anchor - nodes[-1]
    stretched = np.linalg.norm(last)
    tension = CHAIN_EA * (stretched / element - 1)
    horizontal = tension * np.hypot(last[0], last[1]) / stretched
    lift = -tension * last[2] / stretched
    heading = last[:2] / np.hypot(last[0], last[1])
    out, at, weight = list(nodes) + [anchor], anchor, CHAIN_M * element * WEIGHT * G
    for _ in range(ON_BED):
        lift = max(0.0, lift - weight)
        t = np.hypot(horizontal, lift)
        step = element * (1 + t / CHAIN_EA) / t
        at = at + step * np.array([horizontal * heading[0], horizontal * heading[1], -lift])
        out.append(at)
    return out[:-1], out[-1], heading, horizontal


def moorings(scene, state, cables, bodies, interactions):
    floor = []
    for cable in [c for c in scene["cables"] if c["name"].startswith("mooring")]:
        nodes = numbered(state, cable["name"], cable["elements"])
        shape, end, heading, pull = mooring_shape(None, nodes, np.array(cable["to"]["at"]),
                                                  cable["length"], cable["elements"])
        element = cable["length"] / cable["elements"]
        floor.append(end[2])
        number = cable["name"][7:]
        anchor = f"sea_anchor{number}"
        cable = copy.deepcopy(cable)
        cable["length"] = round(cable["length"] + ON_BED * element, 4)
        cable["elements"] += ON_BED
        cable["shape"] = [[round(float(x), 4) for x in p] for p in shape]
        cable["contact"] = {"material": "chain", "groups": "lines", "touches": "bed"}
        cables.append(cable)
        bodies.append((anchor, end, heading, pull, cable))
    axis = float(np.mean(floor))
    weight = CHAIN_M * element * WEIGHT * G
    bed = axis - CHAIN_D / 2 + weight / (BED_K * CHAIN_D * element)
    bed = round(bed, 3)
    out = []
    for anchor, end, heading, pull, cable in bodies:
        sunk = WEIGHT * ANCHOR * G / (4 * ANCHOR_K)
        z = bed + ANCHOR_HALF[2] - sunk
        yaw = np.arctan2(heading[1], heading[0])
        centre = [float(end[0] + ANCHOR_HALF[0] * heading[0]),
                  float(end[1] + ANCHOR_HALF[0] * heading[1]), z]
        eye = float(end[2] - z)
        out.append({"name": anchor, "position": [round(c, 4) for c in centre],
                    "euler_deg": [0, 0, round(float(np.degrees(yaw)), 6)], "mass": ANCHOR,
                    "box": ANCHOR_HALF, "force": [0, 0, round((1 - WEIGHT) * ANCHOR * G)],
                    "linear_damping": 1e4, "angular_damping": 2e4,
                    "shapes": [{"kind": "box", "half_size": ANCHOR_HALF, "material": "anchor",
                                "groups": "anchors", "touches": "bed"}]})
        cable["to"] = {"body": anchor, "point": [-ANCHOR_HALF[0], 0, round(eye, 4)]}
        hold = [centre[0] + 6.5 * heading[0], centre[1] + 6.5 * heading[1], float(end[2])]
        interactions.append({"name": f"{anchor}_flukes", "kind": "distance",
                             "bodies": [anchor, "world"],
                             "points": [[ANCHOR_HALF[0], 0, round(eye, 4)],
                                        [round(h, 4) for h in hold]]})
    return bed, out


def flakes(x, y, z, step, rows=ROWS):
    """Return the nodes of a line in parallel flakes along x."""
    nodes = []
    for r in range(rows):
        row = [[x - k * PITCH, y + r * step, z] for k in range(FLAKE + 1)]
        nodes += row if r % 2 == 0 else row[::-1]
    return nodes


def deck_line(name, line, material, mass, d, x, y, step, end):
    z = DECK_Z + d / 2 - mass * PITCH * G / DECK_K
    nodes = flakes(x, y, z, step)
    nodes = [[round(v, 5) for v in p] for p in nodes]
    return {"name": name, "line_type": line, "from": {"body": "hull", "point": nodes[0]},
            "to": {"free": nodes[-1]}, "length": (len(nodes) - 1) * PITCH,
            "elements": len(nodes) - 1, "shape": nodes[1:-1],
            "contact": {"material": material, "groups": "deck_lines", "touches": "ship"}}


def handler(template):
    """Return the anchor handler with a deck, a roller with contact, and the objects on deck."""
    t = copy.deepcopy(template)
    t["description"] = "Anchor handler of anchor_lines with deck, roller and deck cargo that touch."
    body = {b["name"]: b for b in t["bodies"]}
    body["hull"]["shapes"] = [
        {"kind": "box", "name": "deck", "position": [-18, 0, DECK_Z - 0.5],
         "half_size": [20, 8, 0.5], "material": "deck", "groups": "ship"},
        {"kind": "box", "name": "side", "half_size": [35, 9, 3], "material": "deck",
         "groups": "side", "touches": "fenders"}]
    for line, y in (("work", WORK_Y), ("tow", TOW_Y)):
        body["hull"]["shapes"] += [
            {"kind": "capsule", "name": f"{line}_pin{k + 1}", "radius": PIN_R, "length": 2,
             "axis": "z", "position": [PIN_X, y + s * (PIN_R + WIRE_D / 2 + 0.01), WIRE_Z],
             "material": "roller", "groups": "ship"} for k, s in enumerate((-1, 1))]
    body["hull"]["force"] = ["${thrust}", "${side}", 0]
    t["parameters"]["side"] = 0
    body["roller"]["shapes"] = [{"kind": "cylinder", "radius": ROLLER_R, "length": 6, "axis": "y",
                                 "material": "roller", "groups": "ship"}]
    sunk = ANCHOR * G / (4 * DECK_K)
    lashed = body["deck_anchors"]
    t["bodies"].remove(lashed)
    for k, y in enumerate((-4.5, 4.5)):
        t["bodies"].append({"name": f"deck_anchor{k + 1}", "position":
                            [-5, y, DECK_Z + ANCHOR_HALF[2] - sunk], "mass": ANCHOR,
                            "box": ANCHOR_HALF, "shapes": [
                                {"kind": "box", "half_size": ANCHOR_HALF, "material": "anchor",
                                 "groups": "deck_cargo", "touches": "ship"}]})
    t["interactions"] = [i for i in t["interactions"] if i["name"] != "lashing"]
    t["cables"] = [
        deck_line("spare_chain", "deck_chain", "chain", CHAIN_M, CHAIN_D, -10.0, -3.0, -PITCH, 0),
        deck_line("spare_wire", "deck_wire", "wire", 23.0, WIRE_D, -10.0, 2.0, PITCH, 0)]
    return t


def turned(q):
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def over_roller(cable, state, ship, deck_y):
    """Return the line of an anchor handler from its winch over the roller. The part astern is that
    of anchor_lines, raised at the roller from its axis to its top."""
    hull = state[f"{ship}/hull"]
    r = turned(hull["q"])
    place = lambda p: np.array(hull["p"]) + r @ np.array(p, float)
    n, element = cable["elements"], cable["length"] / cable["elements"]
    nodes = numbered(state, cable["name"], n)
    lift = place([0, 0, WIRE_Z]) - place([0, 0, ROLLER_AT[1]])
    astern = [p + lift * (1 - (k + 1) / n) for k, p in enumerate(nodes)]
    # On deck with the tension at the roller, up to about the winch.
    first = np.linalg.norm(nodes[1] - nodes[0])
    at = np.array(hull["p"])
    local = r.T @ (astern[0] - at)
    along = local[0] + np.sqrt(first**2 - (WIRE_Z - local[2])**2 - (deck_y - local[1])**2)
    on_deck = round((WINCH_X - along) / first)
    start = [along + on_deck * first, deck_y, WIRE_Z]
    shape = [place([along + k * first, deck_y, WIRE_Z]) for k in range(on_deck - 1, -1, -1)]
    shape += astern
    cable = copy.deepcopy(cable)
    cable["from"] = {"body": f"{ship}/hull", "point": [round(v, 4) for v in start]}
    cable["length"] = round(cable["length"] + on_deck * element, 4)
    cable["elements"] = n + on_deck
    cable["shape"] = [[round(float(v), 4) for v in p] for p in shape]
    cable["contact"] = {"material": "wire", "groups": "wires", "touches": "ship"}
    return cable


def barge(state):
    """Return the barge alongside the first anchor handler to port, pressed on three fenders."""
    hull = np.array(state["ahts1/hull"]["p"])
    squeeze = PRESS / 3 / FENDER_K
    y = hull[1] + 9 + 2 * FENDER_R - squeeze + BARGE_HALF[1]
    fenders = [{"kind": "capsule", "name": f"fender{k + 1}", "radius": FENDER_R, "length": 3,
                "axis": "z", "position": [x, -BARGE_HALF[1] - FENDER_R, 0],
                "material": "fender", "groups": "fenders", "touches": "side"}
               for k, x in enumerate((-20, 0, 20))]
    heave = 1025 * G * 4 * BARGE_HALF[0] * BARGE_HALF[1]
    inertia = BARGE / 3 * np.array([BARGE_HALF[1]**2, BARGE_HALF[0]**2])
    body = {"name": "barge", "position": [round(float(hull[0]), 3), round(float(y), 4), 0],
            "mass": BARGE, "box": BARGE_HALF, "gravity": False, "force": [0, -PRESS, 0],
            "linear_damping": [5e4, 2e5, 0], "angular_damping": [0, 0, 1e8], "shapes": fenders}
    tilt = BARGE * G * np.array([3.0, 60.0])
    water = {"name": "barge_water", "kind": "hydrostatic", "bodies": ["barge"],
             "heave_stiffness": round(heave), "roll_stiffness": round(tilt[0]),
             "pitch_stiffness": round(tilt[1]),
             "heave_damping": round(0.4 * np.sqrt(heave * BARGE)),
             "roll_damping": round(0.4 * np.sqrt(tilt[0] * inertia[0])),
             "pitch_damping": round(0.4 * np.sqrt(tilt[1] * inertia[1])), "rest_height": 0}
    return body, water


def start(state, text):
    """Return the positions of all bodies: of anchor_lines, on deck with the hull, or designed."""
    out = {n: {"p": b["p"]} | ({"q": b["q"]} if "q" in b else {}) for n, b in state.items()
           if not n.endswith("deck_anchors")}
    for c in text["cables"]:
        for name in [n for n in out if n.startswith(c["name"] + "/")]:
            del out[name]
        out |= {f"{c['name']}/{i + 1}": {"p": p} for i, p in enumerate(c["shape"])}
    for b in text["bodies"]:
        if b["name"].startswith("sea_anchor") or b["name"] == "barge":
            half = np.radians(b.get("euler_deg", [0, 0, 0])[2]) / 2
            out[b["name"]] = {"p": b["position"], "q": [np.cos(half), 0, 0, np.sin(half)]}
    for ship in ("ahts1", "ahts2"):
        hull = state[f"{ship}/hull"]
        place = lambda p: (np.array(hull["p"]) + turned(hull["q"]) @ np.array(p, float)).tolist()
        for b in text["templates"]["handler"]["bodies"]:
            if b["name"].startswith("deck_anchor"):
                out[f"{ship}/{b['name']}"] = {"p": place(b["position"]), "q": hull["q"]}
        for c in text["templates"]["handler"]["cables"]:
            nodes = c["shape"] + [c["to"]["free"]]
            out |= {f"{ship}/{c['name']}/{i + 1}": {"p": place(p)} for i, p in enumerate(nodes)}
    return {"version": 1, "scene": "anchor_contact", "bodies": plain(out)}


def materials():
    soil = BED_K * CHAIN_D * 6.218
    pair = lambda a, b, mu, k: {"between": [a, b], "friction": mu, "stiffness": k}
    names = ("bed", "chain", "wire", "anchor", "deck", "roller", "fender")
    return {n: {} for n in names}, [
        pair("chain", "bed", 0.7, round(soil)), pair("anchor", "bed", 0.8, ANCHOR_K),
        pair("chain", "deck", 0.3, DECK_K), pair("wire", "deck", 0.25, DECK_K),
        pair("wire", "roller", 0.2, DECK_K), pair("anchor", "deck", 0.4, DECK_K),
        pair("fender", "deck", 0.3, FENDER_K)]


def with_handler(instance):
    if instance["template"] != "ahts":
        return instance
    side = {"side": PRESS} if instance["name"] == "ahts1" else {}
    return instance | {"template": "handler", "parameters": instance["parameters"] | side}


def main():
    scene = json.loads((ROOT / "anchor_lines.json").read_text())
    state = json.loads((ROOT / "anchor_lines.settled.json").read_text())["bodies"]
    template = json.loads((ROOT / "parts" / "ahts.json").read_text())["templates"]["ahts"]
    cables, bodies, interactions = [], [], []
    bed, anchors = moorings(scene, state, cables, bodies, interactions)
    for c in scene["cables"]:
        if c["name"][:3] in ("wor", "tow"):
            ship = "ahts" + c["name"][-1]
            cables.append(over_roller(c, state, ship, c["from"]["point"][1]))
        elif not c["name"].startswith("mooring"):
            n = c["elements"]
            shape = numbered(state, c["name"], n)
            cables.append(c | {"shape": [[round(float(v), 4) for v in p] for p in shape]})
    alongside, water = barge(state)
    seabed = {"name": "seabed", "kind": "fixed", "position": [0, 0, bed],
              "shapes": [{"kind": "plane", "material": "bed", "groups": "bed"}]}
    values, pairs = materials()
    rope = {"EI": 0, "submerged_factor": 1}
    lines = {"deck_chain": {"description": "chain76 lying on deck, in air", "EA": CHAIN_EA,
                            "mass_per_length": CHAIN_M, "diameter": CHAIN_D} | rope,
             "deck_wire": {"description": "wire76 lying on deck, in air", "EA": 2.33e8,
                           "mass_per_length": 23, "diameter": WIRE_D} | rope}
    text = {
        "$schema": "../schema/scene-1.json", "version": 2, "name": "anchor_contact",
        "description": "The site of anchor_lines with moorings on the seabed, lines over stern "
                       "rollers, chain, wire and anchors on deck, and a barge on fenders. "
                       "See docs/anchor_contact.md and scripts/make_anchor_contact.py.",
        "settings": {"duration": 60},
        "include": [f"parts/{p}.json" for p in ("lines", "crane", "windlass")],
        "line_types": lines, "materials": values, "material_pairs": pairs,
        "templates": {"handler": handler(template)},
        "bodies": scene["bodies"] + [seabed, alongside] + anchors,
        "interactions": scene["interactions"] + [water] + interactions,
        "instances": [with_handler(i) for i in scene["instances"]],
        "cables": cables,
        "plot": {"tensions": ["mooring1", "chain1", "work1", "tow1"],
                 "motions": ["rig", "ahts1/hull", "barge"]},
    }
    text["state"] = {"file": STATE}
    if "--start" in sys.argv:
        (ROOT / STATE).write_text(json.dumps(start(state, text), indent=1) + "\n")
    (ROOT / "anchor_contact.json").write_text(dump(plain(text)) + "\n")
    count = sum(c["elements"] for c in cables)
    print(f"bed at {bed} m, {len(cables)} cables of {count} elements beside those on deck")


if __name__ == "__main__":
    main()
