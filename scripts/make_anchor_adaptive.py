#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write scenes/anchor_adaptive.json: the site of anchor_contact with winches and wires whose
resolution follows tension, curvature and contact (standard library only).

Tow and work wires are on winches with layers, which insert nodes as wire is paid out. Inputs such as
ahts1/tow_speed still set the speed of their drums. The wires run over the stern rollers by guides,
because a polygon of 5 m cannot represent a wire on a roller of 1.75 m. All long lines have elements
of at least 5 m. Moorings, chains, tow and work wires have a resolution. Spare lines on deck have new
positions with elements of 5 m. Everything else is anchor_contact and its settled state.

Usage:
- scripts/make_anchor_adaptive.py: write the scene
- scripts/make_anchor_adaptive.py --start FOLDER: write it without resolutions to FOLDER, with a
  start, for `hawser settle` to finish
- scripts/make_anchor_adaptive.py --start FOLDER --element 2.5: the same with all lines in elements
  of 2.5 m, for comparisons
- --no-guides: with wires that touch the rollers instead
"""

import argparse
import copy
import json
import math
import pathlib
import re
import shutil

ROOT = pathlib.Path(__file__).resolve().parent.parent / "scenes"
NAME = "anchor_adaptive"
LEAST = 5.0  # elements [m]
DRUM_R, CORE_R, STORED = 1.2, 0.94, 600.0  # radius to which a drum's rad/s refers
DECK_ELEMENT, DECK_COUNT, DECK_ROW = 5.0, 25, 0.9
DECK_X = (-34.0, -10.0)
G, DECK_Z, DECK_K = 9.81, 1.2, 1e7
ROLLER = (-40.0, -0.2)  # x and z of the stern roller, on the hull
ROLLER_R, ROLLER_MU = 1.788, 0.2  # to the middle of a wire [m]; like wires in contact with rollers
CLEAR = 0.29  # least straight wire from a guide to the next node, in elements
GUIDED = 20  # nodes behind a guide; they compensate that a polygon is shorter than the wire


def rotated(q, p):
    w, x, y, z = q
    m = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return [sum(a * b for a, b in zip(row, p)) for row in m]


def placed(state, end):
    """Return the world point of an end of a cable."""
    body = state[end["body"]]
    turned = rotated(body.get("q", [1, 0, 0, 0]), end.get("point", [0, 0, 0]))
    return [a + b for a, b in zip(body["p"], turned)]


def between(nodes, elements):
    """Divide a line into another number of elements of equal length."""
    out, last = [], len(nodes) - 1
    for k in range(1, elements):
        at = k * last / elements
        i = min(int(at), last - 1)
        out.append([a + (at - i) * (b - a) for a, b in zip(nodes[i], nodes[i + 1])])
    return out


def resampled(cable, state, elements):
    """Set the elements of a cable, with its nodes in the state."""
    name, n = cable["name"], cable["elements"]
    nodes = [placed(state, cable["from"])] + [state[f"{name}/{i}"]["p"] for i in range(1, n)]
    nodes.append(placed(state, cable["to"]))
    for i in range(1, n):
        del state[f"{name}/{i}"]
    shape = between(nodes, elements)
    cable["elements"] = elements
    cable["shape"] = [[round(x, 4) for x in p] for p in shape]
    for i, p in enumerate(shape):
        state[f"{name}/{i + 1}"] = {"p": p}


class Ship:
    """Position of an anchor handler in a state, and points about the axis of its stern roller."""

    def __init__(self, scene, state, name, y):
        self.hull = state[f"{name}/hull"]
        self.axes = [rotated(self.hull["q"], e) for e in ([1, 0, 0], [0, 1, 0], [0, 0, 1])]
        centre = rotated(self.hull["q"], [ROLLER[0], y, ROLLER[1]])
        self.centre = [a + b for a, b in zip(self.hull["p"], centre)]
        self.instance = next(i for i in scene["instances"] if i["name"] == name)

    def local(self, p, origin):
        return [sum((p[k] - origin[k]) * axis[k] for k in range(3)) for axis in self.axes]

    def defined(self, p):
        """Return the point on the ship at its position in the scene definition."""
        x, y, z = self.local(p, self.hull["p"])
        yaw = math.radians(self.instance.get("euler_deg", [0, 0, 0])[2])
        c, s = math.cos(yaw), math.sin(yaw)
        return [a + b for a, b in zip(self.instance["position"],
                                      [c * x - s * y, s * x + c * y, z])]


def straight(p):
    """Return the straight length from a roller to a point about its axis; 0 within the roller."""
    return math.sqrt(max(0.0, p[0]**2 + p[2]**2 - ROLLER_R**2))


def over_roller(a, b):
    """Return the length of wire from a over the roller to b, points about its axis in its plane."""
    ra, rb = math.hypot(a[0], a[2]), math.hypot(b[0], b[2])
    between_them = math.acos((a[0] * b[0] + a[2] * b[2]) / (ra * rb))
    lies = between_them - math.acos(ROLLER_R / ra) - math.acos(ROLLER_R / rb)
    return straight(a) + straight(b) + ROLLER_R * max(lies, 0.0)


def passing(nodes, ship):
    """Return the positions about the roller's axis, and the first node abaft it."""
    about = [ship.local(p, ship.centre) for p in nodes]
    return about, next(i for i, p in enumerate(about) if p[0] < 0.0)


def clear_of_roller(cable, state, ship, count):
    """Return a number of elements near `count` for which no node is at the roller."""
    nodes = [placed(state, cable["from"])]
    nodes += [state[f"{cable['name']}/{i}"]["p"] for i in range(1, cable["elements"])]
    nodes.append(placed(state, cable["to"]))
    least = CLEAR * cable["length"] / count
    for change in (0, -1, 1, -2, 2, -3, 3, -4, 4):
        shape = between(nodes, count + change)
        about, behind = passing([nodes[0]] + shape, ship)
        if min(straight(about[behind - 1]), straight(about[behind])) > least:
            return count + change
    raise SystemExit(f"{cable['name']}: a node lies at the roller with {count} elements or so")


def guide(cable, state, ship, name, friction):
    """Add a guide on the roller. The wire keeps its length around it: nodes behind move up."""
    wire = cable["name"]
    nodes = [placed(state, cable["from"])]
    nodes += [list(state[f"{wire}/{i}"]["p"]) for i in range(1, cable["elements"])]
    about, behind = passing(nodes, ship)
    a, b = about[behind - 1], about[behind]
    more = over_roller(a, b) - math.hypot(a[0] - b[0], a[2] - b[2])
    top = [c + 0.9 * ROLLER_R * z for c, z in zip(ship.centre, ship.axes[2])]
    for i in range(behind, min(behind + GUIDED, len(nodes))):
        to = nodes[i - 1] if i > behind else top
        way = [q - p for p, q in zip(nodes[i], to)]
        share = more * (1 - (i - behind) / GUIDED) / math.hypot(*way)
        state[f"{wire}/{i}"]["p"] = [p + share * w for p, w in zip(nodes[i], way)]
    for i in range(1, len(nodes)):
        p = state[f"{wire}/{i}"]["p"]
        where = ship.defined(p) if i < behind + 6 else p
        cable["shape"][i - 1] = [round(x, 4) for x in where]
    # An element at a guide has the length of its path there, at any requested resolution.
    cable["length"] = round(cable["length"] - more, 4)
    state[f"{wire}_roller/slide"] = {"p": [0, 0, 0]}
    # On the hull: a roller with two wires does not turn.
    return {"name": f"{wire}_roller", "cable": wire, "on": f"{name}/hull",
            "point": [ROLLER[0], cable["from"]["point"][1], ROLLER[1]], "axis": [0, 1, 0], "radius": -ROLLER_R,
            "friction": friction}


def zigzag(x, y, z, side):
    """Return the nodes of a line in parallel rows along x."""
    nodes, way = [[x, y, z]], -1
    for _ in range(DECK_COUNT):
        px, py, _ = nodes[-1]
        if DECK_X[0] <= px + way * DECK_ELEMENT <= DECK_X[1]:
            nodes.append([px + way * DECK_ELEMENT, py, z])
            continue
        way = -way
        across = math.sqrt(DECK_ELEMENT**2 - DECK_ROW**2)
        nodes.append([px + way * across, py + side * DECK_ROW, z])
    return [[round(v, 5) for v in p] for p in nodes]


def deck_lines(template, lines, state):
    for cable in template["cables"]:
        line = lines[cable["line_type"]]
        old = cable["elements"]
        start = cable["from"]["point"]
        sunk = line["mass_per_length"] * DECK_ELEMENT * G / DECK_K
        z = DECK_Z + line["diameter"] / 2 - sunk
        nodes = zigzag(start[0], start[1], z, -1 if start[1] < 0 else 1)
        cable |= {"from": {"body": "hull", "point": nodes[0]}, "to": {"free": nodes[-1]},
                  "length": DECK_COUNT * DECK_ELEMENT, "elements": DECK_COUNT,
                  "shape": nodes[1:-1]}
        for ship in ("ahts1", "ahts2"):
            hull = state[f"{ship}/hull"]
            for i in range(1, old + 1):
                del state[f"{ship}/{cable['name']}/{i}"]
            for i, p in enumerate(nodes[1:]):
                at = [a + b for a, b in zip(hull["p"], rotated(hull["q"], p))]
                state[f"{ship}/{cable['name']}/{i + 1}"] = {"p": at}


def handler(template):
    """Return the anchor handler without bare drums, because the scene defines its winches."""
    t = copy.deepcopy(template)
    t["bodies"] = [b for b in t["bodies"] if b["name"] not in ("tow_drum", "work_drum")]
    t["interactions"] = [i for i in t["interactions"]
                         if i["name"] not in ("tow_winch", "work_winch")]
    inputs = []
    for i in t["inputs"]:
        if i["name"] in ("tow_speed", "work_speed"):
            line = i["name"][:-6]
            i = {"name": i["name"], "signal": "${" + line + "_winch}.speed", "factor": DRUM_R,
                 "min": i["min"], "max": i["max"]}
        inputs.append(i)
    t["inputs"] = inputs
    t["parameters"] |= {"tow_winch": "tow_winch", "work_winch": "work_winch"}
    return t


def winch(cable, end_element):
    """Return a winch with wire in the fourth layer, at about the radius in anchor_contact."""
    return {"name": f"{cable}_winch", "cable": cable, "core_radius": CORE_R, "width": 2.4,
            "stored": STORED, "inertia": 80000,
            "element": end_element, "mode": "speed", "speed": 0, "torque_haul": 5e6,
            "torque_pay": 5e6}


def resolution(name):
    out = {"min_length": LEAST, "max_length": 4 * LEAST, "patience": 3}
    if name.startswith("mooring"):
        out["contact_length"] = 0  # not required on a horizontal bed
    return out


def elements_of(cable, element):
    if element:
        return max(2, round(cable["length"] / element))
    finest = int(cable["length"] / LEAST)
    over_roller = cable["name"][:3] in ("tow", "wor")
    return finest if over_roller else min(cable["elements"], finest)


def dump(data):
    """Return JSON with lists of numbers on one line."""
    text = json.dumps(data, indent=1)
    return re.sub(r"\[\s+([-\d.e+,\s]+?)\s+\]",
                  lambda m: "[" + re.sub(r"\s+", " ", m.group(1)) + "]", text) + "\n"


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--start", type=pathlib.Path)
    options.add_argument("--element", type=float)
    options.add_argument("--no-guides", action="store_true")
    given = options.parse_args()
    scene = json.loads((ROOT / "anchor_contact.json").read_text())
    state = json.loads((ROOT / "anchor_contact.settled.json").read_text())["bodies"]
    deck_lines(scene["templates"]["handler"], scene["line_types"], state)
    scene["templates"]["handler"] = handler(scene["templates"]["handler"])
    winches, guides = [], []
    for cable in scene["cables"]:
        count = elements_of(cable, given.element)
        guided = cable["name"][:3] in ("tow", "wor") and not given.no_guides
        if guided:
            name = f"ahts{cable['name'][-1]}"
            ship = Ship(scene, state, name, cable["from"]["point"][1])
            count = clear_of_roller(cable, state, ship, count)
        if count != cable["elements"]:
            resampled(cable, state, count)
        if guided:
            # Settle without friction there: with it any tension within e^±μθ would be at rest.
            guides.append(guide(cable, state, ship, name, 0 if given.start else ROLLER_MU))
        cable["consistent_mass"] = True
        if not given.start:
            cable["resolution"] = resolution(cable["name"])
        if cable["name"][:3] in ("tow", "wor"):
            drum = cable.pop("winch")["drum"]
            del state[drum]
            state[f"{cable['name']}_winch/drum"] = {"p": [0, 0, 0]}
            winches.append(winch(cable["name"], cable["length"] / cable["elements"]))
    for instance in scene["instances"]:
        if instance["template"] == "handler":
            number = instance["name"][-1]
            instance["parameters"] |= {f"{line}_winch": f"{line}{number}_winch"
                                       for line in ("tow", "work")}
    scene["winches"] = winches
    if guides:
        scene["guides"] = guides
    scene["name"] = NAME
    scene["description"] = (
        "The site of anchor_contact with winches for tow and work wires, and lines whose nodes come "
        "and go by tension, curvature and contact. See docs/anchor_adaptive.md and "
        "scripts/make_anchor_adaptive.py.")
    folder = given.start or ROOT
    scene["state"] = {"file": f"{NAME}.settled.json"}
    if given.start:
        shutil.copytree(ROOT / "parts", folder / "parts", dirs_exist_ok=True)
        (folder / f"{NAME}.settled.json").write_text(dump(
            {"version": 1, "scene": NAME, "bodies": state}))
    (folder / f"{NAME}.json").write_text(dump(scene))
    print(f"{len(scene['cables'])} cables of {sum(c['elements'] for c in scene['cables'])} elements "
          f"beside those on deck, {len(winches)} winches")


if __name__ == "__main__":
    main()
