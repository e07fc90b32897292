#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write scenes/anchor_handling.json and anchor_handling_lower.json: the anchor-handling exercise.

A semi-submersible lies on seven of its eight lines in 150 m of water. The anchor of line 1 hangs at
its fairlead, and the rig crane holds the upper end of its pennant. Anchor handler ahts1 lies stern
to the rig. Anchor handler ahts2 and a tug hold the rig on towlines that cross each other.

The ships, the rig and the crane are those of scenes/parts/ and scenes/crane_knuckle.json. This
script adds decks, rollers, guide pins, shark jaw and winches, and computes the start of each line.
docs/anchor_handling.md has the numbers and their sources.

In scenes/anchor_handling_lower.json the chain is run out to 1,000 m, and the anchor lies on the deck
of ahts1 with the chain in the shark jaw.

Usage:
- scripts/make_anchor_handling.py: write both scenes
- scripts/make_anchor_handling.py --start: without a settled state, for `hawser settle`
- scripts/make_anchor_handling.py --refine STATE: also a start for `hawser settle` from the settled
  state of the light scene
- scripts/make_anchor_handling.py --light DIR: with a tenth of the mooring elements into another
  folder, to try out controls
"""
import argparse
import copy
import json
import math
import pathlib
import shutil

from make_anchor_run import along as equal_elements

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES, EXERCISES = ROOT / "scenes", ROOT / "exercises"
NAME = "anchor_handling"
G, RHO = 9.81, 1025.0
DEPTH = 150.0

# Rig frame: centre of mass, 3 m above the water [m].
RIG_Z, FAIRLEAD = 3.0, (38.0, 35.0, -13.0)
HEADING = math.radians(30.0)  # direction of line 1, counterclockwise from x
LINE_PULL = 627e3  # vertical pull of one mooring line on the rig [N]
MOORING_ELEMENTS = 200
# Line 5, opposite to line 1, is slack until line 1 holds: it lies on the bed in part. Its horizontal
# tension [N].
SLACK_PULL = 3.5e5
TOW_ELEMENT = 4.5  # [m]

# Anchor handlers: frame of vessel_ahts, centre of mass 1.2 m above the water [m]. Deck, roller, pins
# and jaw are those of anchor_run, moved by (3, 0, 0.6).
SHIP_Z, DECK_Z, ROLLER_AT, ROLLER_R = 1.2, 1.8, (-37.0, 0.4), 1.75
WIRE_Z = ROLLER_AT[1] + ROLLER_R + 0.038
PIN_X, PIN_R, PIN_TOP = -34.0, 0.15, 3.6
JAW, JAW_LOAD = [-33.5, 0.0, 2.7], 7.35e6
WINCH_X, HOOK_X = 12.0, -34.0  # of the work winch; end of the work wire at the start
STERN_GAP = 17.0  # from the fairlead to the stern roller [m]
SHIP_AT = STERN_GAP - ROLLER_AT[0]  # from the fairlead to the centre of mass of ahts1 [m]

ANCHOR_MASS, ANCHOR_HALF = 15000.0, [2.5, 1.9, 0.8]
PENNANT, PENNANT_ELEMENTS = 33.0, 13
CHAIN_AT_START, CHAIN_ELEMENT, CHAIN_STORED = 3.0, 5.0, 1400.0
WORK_ELEMENT = 2.5
ANCHOR_DECK_X = -30.0  # of the anchor on deck, in the frame of ahts1 [m]
RUN_OUT = 1000.0  # from the fairlead to the stern roller [m]
RUN_PULL = 4e5  # horizontal tension of the chain that is run out [N]
SOCKET_MASS, SOCKET_R = 400.0, 0.25
WORK_COUNT = round((WINCH_X - HOOK_X) / WORK_ELEMENT)

# Towlines: point on the rig, heading, stretch between the ends, point on the ship [m, degrees].
TOWS = {"tow2": ((38.0, 10.0, 7.3), -25.0, 450.0, (-36.0, 0.0, 3.3)),
        "tow3": ((38.0, -28.0, 5.2), 5.0, 400.0, (-3.0, 0.0, 3.5))}
TOW_TENSION, WIRE_EA, WIRE_WEIGHT = 3.5e5, 2.33e8, 23 * 0.87 * G

CRANE_SCALE = 1.6  # of the knuckle boom of scenes/crane_knuckle.json
CRANE_AT = (29.2, 27.2, 9.0 + 2.0)  # in the frame of the rig [m]
CRANE_HANG = 26.0


def part(name):
    return json.loads((SCENES / "parts" / f"{name}.json").read_text())


def along(distance, height, aside=0.0):
    """Return the point of line 1's vertical plane at a distance from the fairlead."""
    c, s = math.cos(HEADING), math.sin(HEADING)
    return [FAIRLEAD[0] + distance * c - aside * s, FAIRLEAD[1] + distance * s + aside * c, height]


def on_ship(point):
    """Return a point of ahts1's frame in the world at the start."""
    return along(SHIP_AT + point[0], SHIP_Z + point[2], point[1])


def rounded(value, digits=4):
    if isinstance(value, (list, tuple)):
        return [rounded(v, digits) for v in value]
    return round(value, digits)


def handler(template):
    """Return the anchor handler with a deck, a stern roller and sides that touch."""
    t = copy.deepcopy(template)
    t["description"] = "Anchor handler of vessel_ahts with deck and stern roller."
    hull = t["bodies"][0]
    hull["shapes"] = [
        {"kind": "box", "name": "deck", "position": [-11, 0, DECK_Z - 0.5],
         "half_size": [24, 8, 0.5], "material": "deck", "groups": "ship"},
        {"kind": "box", "name": "side", "position": [0, 0, -1.2], "half_size": [35, 9, 2.8],
         "material": "deck", "groups": "side", "touches": "rig"}]
    t["bodies"].append(
        {"name": "roller", "position": [ROLLER_AT[0], 0, ROLLER_AT[1]], "mass": 40000,
         "cylinder": {"radius": ROLLER_R, "length": 6, "axis": "y"},
         "angular_damping": [0, 50000, 0],
         "shapes": [{"kind": "cylinder", "radius": ROLLER_R, "length": 6, "axis": "y",
                     "material": "roller", "groups": "ship"}]})
    t["interactions"] = [{"name": "roller_bearing", "kind": "hinge", "bodies": ["hull", "roller"],
                          "at": [ROLLER_AT[0], 0, ROLLER_AT[1]], "axis": [0, 1, 0]}]
    t["vessels"][0]["control"] |= {"mode": "position", "bandwidth": [0.1, 0.1, 0.2]}
    return t


def semi(template):
    """Return the rig on seven lines: its parts touch ships, and ballast stands for line 1."""
    t = copy.deepcopy(template)
    t["description"] = "The rig of vessel_semi without its first line; columns and pontoons touch."
    hull = t["bodies"][0]
    shapes = []
    for y in (-30, 30):
        shapes.append({"kind": "box", "name": f"pontoon{1 if y > 0 else 2}", "position": [0, y, -17],
                       "half_size": [45, 7, 4]})
        for x in (-32, 32):
            shapes.append({"kind": "box", "name": f"column{len(shapes)}", "position": [x, y, -2],
                           "half_size": [6, 6, 11]})
    hull["shapes"] = [s | {"material": "deck", "groups": "rig", "touches": "side"} for s in shapes]
    crane_mass = sum(crane()[k]["mass"] for k in ("column", "boom", "jib", "hook"))
    hull["mass"] = round(hull["mass"] - crane_mass - 2000)
    hull["force"] = [0, 0, round(-LINE_PULL)]
    reach = 12.0  # mean distance of the crane's masses from its axis [m]
    cx = CRANE_AT[0] + reach * math.cos(HEADING)
    cy = CRANE_AT[1] + reach * math.sin(HEADING)
    weight = crane_mass * G
    hull["torque"] = [round(-FAIRLEAD[1] * LINE_PULL + cy * weight),
                      round(FAIRLEAD[0] * LINE_PULL - cx * weight), 0]
    t["cables"] = [c | {"elements": MOORING_ELEMENTS} for c in t["cables"]
                   if c["name"] != "mooring1"]
    slack = next(c for c in t["cables"] if c["name"] == "mooring5")
    fore, end = slack["from"]["point"], slack["to"]["at"]
    end[2] = round(-DEPTH - RIG_Z + 0.0685, 4)
    way = math.dist(fore[:2], end[:2])
    path = bed_path([0.0, fore[2] + RIG_Z], [way, end[2] + RIG_Z], SLACK_PULL)
    full = sum(math.dist(p, q) for p, q in zip(path, path[1:]))
    shape = [[fore[0] + (end[0] - fore[0]) * x / way, fore[1] + (end[1] - fore[1]) * x / way,
              z - RIG_Z] for x, z in equal_elements(path, MOORING_ELEMENTS)[0]]
    slack |= {"length": round(full * (1 - SLACK_PULL / 5.83e8), 3), "shape": rounded(shape),
              "contact": {"material": "chain", "groups": "moorings", "touches": "bed"}}
    del t["vessels"][0]["wind"]  # the wind with its gusts acts through the hull in the sea
    return t


def scaled(value, factor):
    if isinstance(value, list):
        return [scaled(v, factor) for v in value]
    return round(value * factor, 5)


def crane():
    """Return the crane of scenes/crane_knuckle.json, lengths times CRANE_SCALE, forces times its
    square, torques times its cube."""
    source = json.loads((SCENES / "crane_knuckle.json").read_text())["cranes"][0]
    s, out = CRANE_SCALE, copy.deepcopy(source)
    for key in ("torque", "brake", "friction"):
        out["slew"][key] = round(out["slew"][key] * s**3)
    out["slew"]["speed"] = 0.03
    for key in ("column", "boom", "jib"):
        out[key]["mass"] = round(out[key]["mass"] * s * s)
        for size in ("centre", "half_size", "length", "width", "height"):
            if size in out[key]:
                out[key][size] = scaled(out[key][size], s)
    out["boom_foot"] = scaled(out["boom_foot"], s)
    for key in ("boom_cylinder", "jib_cylinder"):
        c = out[key]
        for size in ("foot", "head", "min_length", "max_length"):
            c[size] = scaled(c[size], s)
        for force in ("push", "pull"):
            c[force] = round(c[force] * s * s)
        c["mass"] = round(c["mass"] * s * s)
    out["hoist"]["drum"] = scaled(out["hoist"]["drum"], s)
    out["hoist"] |= {"pull": 2.5e5, "brake": 4e5, "speed": 0.6}
    out["hook"] = {"mass": 6000, "height": 1.2, "half_size": [0.35, 0.35, 0.6], "hang": CRANE_HANG,
                   "least_hang": 3, "angular_damping": 300}
    out["rating"] = {"curve": [[r * s, round(m)] for r, m in source["rating"]["curve"]]}
    out["loads"] = [{"body": "socket", "eyes": [[0.2, 0, 0]], "sling_length": 2.0, "sling_EA": 2e6,
                     "reach": 1.5}]
    return out | {"name": "rig_crane", "take": "socket", "on": "rig/hull", "point": list(CRANE_AT),
                  "euler_deg": [0, 0, 33.5]}


def crane_tip():
    """Return radius and height of the boom's end over the slewing bearing [m]."""
    c = crane()
    a = math.radians(c["boom_angle_deg"])
    b = math.radians(c["boom_angle_deg"] + c["jib_angle_deg"])
    return (c["boom_foot"][0] + c["boom"]["length"] * math.cos(a) + c["jib"]["length"] * math.cos(b),
            c["boom_foot"][2] + c["boom"]["length"] * math.sin(a) + c["jib"]["length"] * math.sin(b))


def socket_place():
    """Return where the socket of the pennant hangs at the start."""
    radius, height = crane_tip()
    base = [CRANE_AT[0], CRANE_AT[1], CRANE_AT[2] + RIG_Z]
    a = math.radians(33.5)
    return [base[0] + radius * math.cos(a), base[1] + radius * math.sin(a),
            base[2] + height - CRANE_HANG - 1.2 - 2.0 - 0.2]


def sag_line(a, b, length, count, weight):
    """Return the interior nodes of a hanging line: a parabola of its length, at equal fractions."""
    span = math.dist(a, b)
    flat = math.hypot(b[0] - a[0], b[1] - a[1])
    sag = math.sqrt(max(0.0, 3.0 * (length - span) * span / 8.0))
    out = []
    for i in range(1, count):
        f = i / count
        p = [x + f * (y - x) for x, y in zip(a, b)]
        p[2] -= 4.0 * sag * f * (1.0 - f) * flat / max(span, 1e-9)
        out.append(p)
    return out


def catenary(a, b, length, count):
    """Return the interior nodes of a catenary between two points, at equal lengths."""
    dx, dz = math.hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]
    want = math.sqrt(length**2 - dz**2)
    low, high = 1e-3, 50.0
    for _ in range(200):
        mid = 0.5 * (low + high)
        if math.sinh(mid) / mid * dx < want:
            low = mid
        else:
            high = mid
    c = dx / (2.0 * low)  # parameter of the catenary
    x0 = 0.5 * dx - c * math.atanh(dz / length)
    start = c * math.sinh(-x0 / c)
    out = []
    for i in range(1, count):
        s = length * i / count
        x = x0 + c * math.asinh((s + start) / c)
        z = a[2] + c * (math.cosh((x - x0) / c) - math.cosh(x0 / c))
        out.append([a[0] + (b[0] - a[0]) * x / dx, a[1] + (b[1] - a[1]) * x / dx, z])
    return out


def pulling(weight, span, tension, drop):
    """Return the unstretched length of a line with a horizontal tension over a span."""
    c = tension / weight
    half = math.sqrt(drop**2 + (2.0 * c * math.sinh(span / (2.0 * c)))**2)
    return half * (1.0 - tension / WIRE_EA)


def towlines():
    """Return both towlines and the places of their ships."""
    cables, ships = [], {}
    for name, (point, heading, span, end) in TOWS.items():
        a = [point[0], point[1], point[2] + RIG_Z]
        h = math.radians(heading)
        z = {"tow2": SHIP_Z, "tow3": 0.35}[name]
        b = [a[0] + span * math.cos(h), a[1] + span * math.sin(h), z + end[2]]
        length = pulling(WIRE_WEIGHT, span, TOW_TENSION, b[2] - a[2])
        count = round(length / TOW_ELEMENT)
        shape = catenary(b, a, length * (1.0 + TOW_TENSION / WIRE_EA), count)
        ship = {"tow2": "ahts2", "tow3": "tug"}[name]
        ships[ship] = ([b[0] - end[0] * math.cos(h), b[1] - end[0] * math.sin(h), z], heading)
        cables.append({"name": name, "line_type": "wire76_sea",
                       "from": {"body": f"{ship}/hull", "point": list(end)},
                       "to": {"body": "rig/hull", "point": list(point)},
                       "length": round(length, 3), "elements": count, "consistent_mass": True,
                       "shape": rounded(shape),
                       "contact": {"material": "wire", "groups": "tows", "touches": "tows"}})
    return cables, ships


def towing(template, ship, cable, at, heading):
    """Return a template of a ship with its towline, whose tension its DP feeds forward."""
    t = copy.deepcopy(template)
    h = math.radians(heading)

    def local(p):
        d = [p[i] - at[i] for i in range(3)]
        return [d[0] * math.cos(h) + d[1] * math.sin(h),
                -d[0] * math.sin(h) + d[1] * math.cos(h), d[2]]

    cable = copy.deepcopy(cable)
    cable["name"] = "tow"
    cable["from"]["body"], cable["to"]["body"] = "hull", "rig"
    cable["shape"] = [rounded(local(p)) for p in cable["shape"]]
    t["cables"] = [cable]
    t["vessels"][0]["control"] |= {"mode": "position", "lines": ["tow"]}
    t["description"] = f"Part of the library with its towline to the rig: {ship}."
    return t


def crossing(cables):
    """Raise tow3 where it crosses tow2, so that it starts above it."""
    two, three = (c["shape"] for c in cables)
    best = min((math.dist(p[:2], q[:2]), i, j) for i, p in enumerate(two) for j, q in enumerate(three))
    _, i, j = best
    need = two[i][2] + 0.12 + 0.25 - three[j][2]
    if need > 0.0:
        for k, q in enumerate(three):
            part = k / j if k <= j else (len(three) - k) / (len(three) - j)
            q[2] = round(q[2] + need * part, 4)
    return best[0], two[i], three[j], need


def lines():
    """Return the cables of ahts1: work wire, pennant and chain."""
    contact = {"material": "wire", "groups": "wires", "touches": ["ship", "bed"], "to_ends": True}
    length = WINCH_X - HOOK_X
    count = WORK_COUNT
    work = {"name": "work1", "line_type": "wire76_sea", "consistent_mass": True,
            "from": {"body": "ahts1/hull", "point": [WINCH_X, 0, DECK_Z + 0.038]},
            "to": {"free": rounded(on_ship([HOOK_X, 0, DECK_Z + 0.038]))},
            "length": length, "elements": count,
            "shape": [rounded(on_ship([WINCH_X - length * i / count, 0, DECK_Z + 0.038]))
                      for i in range(1, count)],
            "contact": contact}
    socket = socket_place()
    anchor = anchor_place()
    low = [anchor[0], anchor[1], anchor[2] - ANCHOR_HALF[0]]
    top = [socket[0], socket[1], socket[2] - 0.2]
    free = math.dist(low, top)
    pennant = {"name": "pennant", "line_type": "wire76_sea", "consistent_mass": True,
               "from": {"body": "socket", "point": [-0.2, 0, 0]},
               "to": {"body": "anchor1", "point": [2.5, 0, 0.6]},
               "length": PENNANT, "elements": PENNANT_ELEMENTS,
               "shape": rounded(catenary(top, low, max(PENNANT, free * 1.001), PENNANT_ELEMENTS)),
               "contact": contact}
    chain = {"name": "chain1", "line_type": "chain76_sea", "consistent_mass": True,
             "from": {"body": "rig/hull", "point": list(FAIRLEAD)},
             "to": {"body": "anchor1", "point": [-2.5, 0, 0.6]},
             "length": CHAIN_AT_START, "elements": 1, "shape": [],
             "contact": contact | {"material": "chain", "groups": "chains"}}
    del chain["shape"]
    return [work, pennant, chain], socket, free


def anchor_place():
    """Return the place of the anchor, which hangs upright on its chain."""
    return along(0.0, RIG_Z + FAIRLEAD[2] - CHAIN_AT_START - ANCHOR_HALF[0])


def deck_lines(distance):
    """Return the lines with the anchor on the deck of ahts1, the stern at a distance [m], and the
    places of anchor and socket in the frame of the ship."""
    z = DECK_Z + 0.076
    anchor, eye = [ANCHOR_DECK_X, 0, DECK_Z + ANCHOR_HALF[2]], ANCHOR_DECK_X + 2.5 + PENNANT
    socket = [eye, 0, DECK_Z + SOCKET_R]
    work, pennant, chain = lines()[0]
    hook = socket[0] + 0.2 + 2.0
    deck = lambda x, height=z: on_ship([x, 0, height])
    length = WINCH_X - hook
    work |= {"to": {"free": rounded(deck(hook))}, "length": round(length, 4), "elements": 3}
    del work["shape"]
    share = lambda i: i / PENNANT_ELEMENTS
    pennant["shape"] = [rounded(deck(socket[0] - 0.2 + share(i) * (ANCHOR_DECK_X + 2.7 - socket[0]),
                                     socket[2] + share(i) * (anchor[2] + 0.6 - socket[2])))
                        for i in range(1, PENNANT_ELEMENTS)]
    # Over the roller, higher than its top by the rise of a chord of an element.
    top = [ROLLER_AT[0], 0, ROLLER_AT[1] + ROLLER_R + 0.5]
    path = bed_path([0.0, RIG_Z + FAIRLEAD[2]], [SHIP_AT + top[0] - 1.6, SHIP_Z + top[2] - 0.6],
                    RUN_PULL)
    path += [[SHIP_AT + top[0], SHIP_Z + top[2]],
             [SHIP_AT + ANCHOR_DECK_X - 2.5, SHIP_Z + anchor[2] + 0.6]]
    full = sum(math.dist(a, b) for a, b in zip(path, path[1:]))
    count = round(full / CHAIN_ELEMENT)
    chain |= {"length": round(full * (1 - RUN_PULL / 5.83e8), 3), "elements": count,
              "shape": [rounded(along(p[0], p[1])) for p in equal_elements(path, count)[0]]}
    return [work, pennant, chain], anchor, socket


def bed_path(a, b, pull):
    """Return points (distance, height) of a chain between two ends over the bed, at a horizontal
    tension: two catenaries and the bed between them."""
    weight = 126.5 * (1 - RHO / 7850.0) * G
    c, bed = pull / weight, -DEPTH + 0.0685
    side = lambda end: [(c * math.asinh(s / c), bed + math.sqrt(c * c + s * s) - c) for s in
                        (math.sqrt((end - bed)**2 + 2 * (end - bed) * c) * i / 60
                         for i in range(61))]
    left, right = side(a[1]), side(b[1])
    reach = left[-1][0] + right[-1][0]
    assert reach < b[0] - a[0], f"chain hangs free: {reach:.0f} m"
    out = [[a[0] + left[-1][0] - x, z] for x, z in reversed(left)]
    return out + [[b[0] - right[-1][0] + x, z] for x, z in right]


def bodies(socket):
    anchor = anchor_place()
    c, s = math.cos(HEADING / 2), math.sin(HEADING / 2)
    # x of both bodies: the anchor's down, the socket's up; y across line 1.
    r = math.sqrt(0.5)
    down = [c * r, -s * r, c * r, s * r]
    up = [c * r, s * r, -c * r, s * r]
    off = 0.6  # the eyes are so far off the anchor's axis
    place = [anchor[0] - off * math.cos(HEADING), anchor[1] - off * math.sin(HEADING), anchor[2]]
    return [
        {"name": "anchor1", "position": rounded(place), "orientation": down,
         "mass": ANCHOR_MASS, "box": [2.5, 2.5, 0.8],
         "shapes": [{"kind": "box", "half_size": ANCHOR_HALF, "material": "anchor",
                     "groups": "anchors", "touches": ["ship", "bed"]}]},
        {"name": "socket", "position": rounded(socket), "orientation": up, "mass": SOCKET_MASS,
         "sphere": SOCKET_R, "angular_damping": [200, 200, 200],
         "shapes": [{"kind": "sphere", "radius": SOCKET_R, "material": "anchor",
                     "groups": "anchors", "touches": ["ship", "bed"]}]},
        {"name": "seabed", "kind": "fixed", "position": [0, 0, -DEPTH],
         "shapes": [{"kind": "plane", "material": "bed", "groups": "bed"}]}]


def line_types():
    wet = {"cd_normal": 1.2}
    return {
        "wire76_sea": {"description": "Steel wire 6x19 IWRC 76 mm", "mass_per_length": 23,
                       "EA": WIRE_EA, "EI": 5000, "diameter": 0.076, "breaking_load": 3658000,
                       "axial_damping": 0.1, "color": "#b0552f"} | wet,
        "chain76_sea": {"description": "Stud link chain 76 mm, R4", "mass_per_length": 126.5,
                        "EA": 583000000, "diameter": 0.137, "breaking_load": 6000000,
                        "axial_damping": 0.1, "cd_normal": 2.6, "cd_tangential": 1.4,
                        "color": "#4a4e57"}}


def materials():
    pair = lambda a, b, mu, k: {"between": [a, b], "friction": mu, "stiffness": k}
    names = ("bed", "chain", "wire", "anchor", "deck", "roller")
    return {n: {} for n in names}, [
        pair("chain", "bed", 0.7, 68500), pair("anchor", "bed", 0.8, 1e6),
        pair("wire", "bed", 0.5, 40000),
        pair("chain", "deck", 0.3, 1e7), pair("wire", "deck", 0.25, 1e7),
        pair("wire", "roller", 0.2, 1e7), pair("chain", "roller", 0.3, 1e7),
        pair("anchor", "roller", 0.4, 1e7), pair("anchor", "deck", 0.4, 1e7)]


def hull_entry(body, kind):
    """Return the hull in the sea of a vessel of the library, as in scenes/."""
    of = {"ahts": "tow_barge", "semi": "semi_moored", "tug": "semi_moored"}[kind]
    hulls = json.loads((SCENES / f"{of}.json").read_text())["sea"]["hulls"]
    found = next(h for h in hulls if h["body"].startswith(kind))
    return found | {"body": body, "mesh": f"parts/vessel_{kind}.obj"}


def sea():
    rig = hull_entry("rig/hull", "semi") | {"wind_area": [1700, 1900, 0]}
    current = [{"depth": d, "speed": 0.6, "direction_deg": 150} for d in (0, DEPTH)]
    return {"depth": DEPTH, "density": RHO,
            "waves": [{"kind": "jonswap", "height": 2.5, "period": 9, "components": 60,
                       "direction_deg": 210, "spreading": 10, "seed": 1}],
            "current": current,
            "wind": {"speed": 10, "direction_deg": 150, "gusts": True, "seed": 1},
            "bodies": [{"body": "anchor1", "volume": 1.9108, "drag_area": [6, 6, 9],
                        "added_mass": 1.0, "height": 1.6},
                       {"body": "socket", "volume": 0.05, "drag_area": [0.2, 0.2, 0.2],
                        "added_mass": 0.5, "height": 0.5}],
            "hulls": [rig, hull_entry("ahts1/hull", "ahts"), hull_entry("ahts2/hull", "ahts"),
                      hull_entry("tug/hull", "tug")]}


def winches():
    ahts = {"core_radius": 0.94, "width": 2.4, "inertia": 80000, "torque_haul": 3e6,
            "torque_pay": 3e6, "power": 1.5e6, "brake_static": 5e6, "mode": "brake"}
    return [
        ahts | {"name": "work_winch", "cable": "work1", "stored": 800, "element": WORK_ELEMENT,
                "flange_radius": 1.6, "heave_speed": 2},
        ahts | {"name": "tow2_winch", "cable": "ahts2/tow", "stored": 800, "element": TOW_ELEMENT,
                "overload_limit": 1.2e6},
        ahts | {"name": "tow3_winch", "cable": "tug/tow", "stored": 600, "element": TOW_ELEMENT,
                "overload_limit": 9e5},
        {"name": "windlass", "cable": "chain1", "stored": CHAIN_STORED, "element": CHAIN_ELEMENT,
         "core_radius": 0.6, "width": 30, "inertia": 60000, "torque_haul": 1.3e6,
         "torque_pay": 1.3e6, "power": 1.2e6, "brake_static": 2.4e6, "mode": "brake"}]


def deck_gear():
    pins = [{"name": f"pin_{side}", "on": "ahts1/hull", "from": [PIN_X, y, DECK_Z],
             "to": [PIN_X, y, PIN_TOP], "radius": PIN_R, "friction": 0.2, "speed": 0.1,
             "force": 2e5, "material": "roller", "groups": "ship", "up": False}
            for side, y in (("port", 0.9), ("starboard", -0.9))]
    hook = {"name": "work_hook", "on": f"work1/{WORK_COUNT}",
            "loads": [{"body": "socket", "eyes": [[0.2, 0, 0]], "sling_length": 1.0,
                       "sling_EA": 2e8, "reach": 3.0}]}
    jaw = {"name": "jaw", "on": "ahts1/hull", "point": JAW, "reach": 1.5, "rated_load": JAW_LOAD}
    return pins, [jaw], [hook]


def outputs():
    pose = lambda name, body, component, group, point=None: {
        "name": name, "kind": "pose", "body": body, "component": component, "group": group} | (
            {"point": point} if point else {})
    tension = lambda name, cable, component="largest": {
        "name": name, "kind": "tension", "cable": cable, "component": component, "group": "lines"}
    return [
        {"name": "hook_to_socket", "kind": "distance", "bodies": [f"work1/{WORK_COUNT}", "socket"],
         "group": "deck"},
        pose("socket_z", "socket", "z", "deck"), pose("anchor_z", "anchor1", "z", "anchor"),
        {"name": "anchor_to_jaw", "kind": "distance", "bodies": ["anchor1", "ahts1/hull"],
         "points": [[-2.5, 0, 0.6], JAW], "group": "anchor"},
        {"name": "anchor_to_deck", "kind": "distance", "bodies": ["anchor1", "ahts1/hull"],
         "points": [[0, 0, 0], [-30, 0, DECK_Z + 0.8]], "group": "anchor"},
        {"name": "stern_to_rig", "kind": "distance", "bodies": ["ahts1/hull", "rig/hull"],
         "points": [[ROLLER_AT[0], 0, 0], list(FAIRLEAD)], "group": "bridge"},
        {"name": "anchor_to_rig", "kind": "distance", "bodies": ["anchor1", "rig/hull"],
         "points": [[-2.5, 0, 0.6], list(FAIRLEAD)], "group": "anchor"},
        {"name": "rig_offset", "kind": "distance", "bodies": ["rig/hull", "world"],
         "points": [[0, 0, 0], [0, 0, RIG_Z]], "group": "rig"},
        pose("rig_x", "rig/hull", "x", "rig"), pose("rig_y", "rig/hull", "y", "rig"),
        pose("ahts1_heading", "ahts1/hull", "yaw", "bridge"),
        tension("chain_tension", "chain1", "first"), tension("work_tension", "work1"),
        tension("pennant_tension", "pennant"), tension("tow2_tension", "ahts2/tow"),
        tension("tow3_tension", "tug/tow")]


def run_out(scene, distance):
    """Change the scene: the chain is run out, its anchor on deck with the chain in the jaw."""
    cables, anchor, socket = deck_lines(distance)
    scene["cables"][:3] = cables
    c, s = math.cos(HEADING / 2), math.sin(HEADING / 2)
    for body, at in (("anchor1", anchor), ("socket", socket)):
        b = next(b for b in scene["bodies"] if b["name"] == body)
        b |= {"position": rounded(on_ship(at)), "orientation": [c, 0, 0, s]}
    count = cables[0]["elements"]
    scene["hooks"][0] |= {"on": f"work1/{count}", "take": "socket"}
    scene["stoppers"][0]["closed"] = True
    del scene["cranes"][0]["take"]
    for o in scene["outputs"]:
        if o["name"] == "hook_to_socket":
            o["bodies"][0] = f"work1/{count}"
    used = sum(math.dist(a, b) for a, b in zip(cables[2]["shape"], cables[2]["shape"][1:]))
    scene["winches"][3]["stored"] = CHAIN_STORED - round(used)
    scene["winches"][3] |= {"mode": "tension", "tension": RUN_PULL + 1.5e5}


def made(start, distance=None):
    global SHIP_AT
    if distance:
        SHIP_AT = distance - ROLLER_AT[0]
    tows, ships = towlines()
    cross = crossing(tows)
    own, socket, free = lines()
    values, pairs = materials()
    pins, jaws, hooks = deck_gear()
    ahts = part("vessel_ahts")["templates"]["vessel_ahts"]
    tug = part("vessel_tug")["templates"]["vessel_tug"]
    tow = {c["name"]: c for c in tows}
    place = lambda name, template, at, heading: {
        "template": template, "name": name, "position": rounded(at),
        "euler_deg": [0, 0, heading]}
    chain = part("vessel_semi")["line_types"]
    scene = {
        "$schema": "../schema/scene-1.json", "version": 2, "name": NAME,
        "description": " ".join(__doc__.split("\n\n")[1].split()) +
                       " docs/anchor_handling.md, scripts/make_anchor_handling.py.",
        "settings": {"duration": 2400},
        "line_types": chain | line_types(), "materials": values, "material_pairs": pairs,
        "templates": {"handler": handler(ahts),
                      "tower": towing(ahts, "ahts2", tow["tow2"], *ships["ahts2"]),
                      "tug": towing(tug, "tug", tow["tow3"], *ships["tug"]),
                      "semi": semi(part("vessel_semi")["templates"]["vessel_semi"])},
        "bodies": bodies(socket),
        "instances": [place("rig", "semi", [0, 0, RIG_Z], 0),
                      place("ahts1", "handler", on_ship([0, 0, 0]), math.degrees(HEADING)),
                      place("ahts2", "tower", *ships["ahts2"]) | {"bind": {"rig": "rig/hull"}},
                      place("tug", "tug", *ships["tug"]) | {"bind": {"rig": "rig/hull"}}],
        "cables": own, "winches": winches(), "pins": pins, "stoppers": jaws,
        "hooks": hooks, "cranes": [crane() | {"loads": crane()["loads"]}],
        "anchors": [{"name": "ground", "body": "anchor1", "cable": "chain1", "soil": "medium_clay",
                     "type": "stevpris_mk6", "touch": 3.0}],
        "stability": [
            {"name": "gauge1", "body": "ahts1/hull", "cable": "work1",
             "other_cables": ["pennant", "chain1"], "pin": [PIN_X, 0.3, WIRE_Z],
             "stern": [-37, 0, DECK_Z], "bollard_pull": 1.2e6},
            {"name": "gauge2", "body": "ahts2/hull", "cable": "ahts2/tow", "pin": [-36, 0.5, 3.3],
             "stern": [-37, 0, DECK_Z], "bollard_pull": 1.2e6}],
        "sea": sea(), "outputs": outputs(),
        "plot": {"tensions": ["chain1", "work1", "ahts2/tow", "tug/tow"],
                 "motions": ["rig/hull", "ahts1/hull", "ahts2/hull", "tug/hull", "anchor1"]}}
    if distance:
        run_out(scene, distance)
    if not start:
        scene["state"] = {"file": f"{NAME}.settled.json"}
    return scene, cross, free


def turned(q, v):
    """Rotate a vector by a quaternion w, x, y, z."""
    w, u = q[0], q[1:]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                          a[0] * b[1] - a[1] * b[0]]
    c = [a + w * b for a, b in zip(cross(u, v), v)]
    return [b + 2.0 * a for a, b in zip(cross(u, c), v)]


def refined(bodies, scene):
    """Return the state of the scene from one of its coarse form: lines are divided anew."""
    out = {name: {"p": b["p"]} | ({"q": b["q"]} if "q" in b else {}) for name, b in bodies.items()}
    place = lambda body, point: [a + b for a, b in zip(
        bodies[body]["p"], turned(bodies[body]["q"], point))]
    lines = [("rig/", c) for c in scene["templates"]["semi"]["cables"]]
    lines += [(f"{ship}/", scene["templates"][t]["cables"][0])
              for ship, t in (("ahts2", "tower"), ("tug", "tug"))]
    for front, cable in lines:
        name = front + cable["name"]
        count = sum(1 for b in bodies if b.startswith(name + "/"))
        to = cable["to"]
        end = (place("rig/hull", to["point"]) if "body" in to else
               [to["at"][0], to["at"][1], to["at"][2] + RIG_Z])
        nodes = ([place(front + "hull", cable["from"]["point"])] +
                 [bodies[f"{name}/{i + 1}"]["p"] for i in range(count)] + [end])
        for i in range(count):
            del out[f"{name}/{i + 1}"]
        # Elements of another length sink into the bed by another depth. The upper one of the
        # crossing lines keeps its distance.
        n = cable["elements"]
        lift = lambda i: 0.06 * min(1.0, i / 10, (n - i) / 10) if front == "tug/" else 0.0
        low = -DEPTH + 0.01 if cable["name"] == "mooring5" else -2 * DEPTH
        out |= {f"{name}/{i}": {"p": rounded([p[0], p[1], max(p[2] + lift(i), low)], 6)}
                for i, p in enumerate(equal_elements(nodes, n)[0], 1)}
    return {"version": 1, "scene": NAME, "bodies": out}


def dump(value, depth=0):
    """Return JSON with short values on one line."""
    line = json.dumps(value)
    if len(line) + depth <= 120:
        return line
    pad, end = " " * (depth + 1), " " * depth
    if isinstance(value, dict):
        inner = ",\n".join(f"{pad}{json.dumps(k)}: {dump(v, depth + 1)}" for k, v in value.items())
        return "{\n" + inner + "\n" + end + "}"
    if isinstance(value, list):
        inner = ",\n".join(pad + dump(v, depth + 1) for v in value)
        return "[\n" + inner + "\n" + end + "]"
    return line


def written(folder, scene):
    (folder / f"{scene['name']}.json").write_text(dump(scene) + "\n")


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--start", action="store_true", help="without a settled state")
    options.add_argument("--refine", type=pathlib.Path, help="settled state of the light scene")
    options.add_argument("--light", type=pathlib.Path, help="folder for coarse scenes")
    given = options.parse_args()
    folder = SCENES
    if given.light:
        global MOORING_ELEMENTS, TOW_ELEMENT
        MOORING_ELEMENTS, TOW_ELEMENT = 20, 15.0
        folder = given.light / "scenes"
        shutil.copytree(SCENES / "parts", folder / "parts", dirs_exist_ok=True)
    scene, cross, free = made(given.start)
    lower, _, _ = made(True, RUN_OUT)
    lower["name"] = f"{NAME}_lower"
    if given.light:
        scene["sea"]["waves"][0]["components"] = 30
        lower["sea"]["waves"][0]["components"] = 30
    written(folder, scene)
    written(folder, lower)
    if given.refine:
        light = json.loads(given.refine.read_text())["bodies"]
        (folder / f"{NAME}.settled.json").write_text(dump(refined(light, scene)) + "\n")
    print(f"towlines cross at {cross[1]} and {cross[2]}, raised by {max(0, cross[3]):.2f} m; pennant "
          f"of {PENNANT} m between points {free:.2f} m apart; socket at {rounded(socket_place(), 2)}")


if __name__ == "__main__":
    main()
