#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Design and write scenes/anchor_lines.json (numpy only).

The scene: a semi-submersible on eight mooring chains and two anchor handlers. Each of them tows
the rig with a tow wire and holds one more of its chains, with the anchor still on the work wire.
The closed-form elastic catenary gives line lengths for the required tensions, and the thrusts
balance the lines. Newton's method on the lumped model gives the static equilibrium, the reference
for the engine's settled state. Line types, crane, anchor handler and windlass come from
scenes/parts/. The numbers: docs/anchor_lines.md.

Usage:
- scripts/make_anchor_lines.py: print the design and write the scene
- scripts/make_anchor_lines.py --check: print the design; compare it with the stored scene and with
  the settled state
- scripts/make_anchor_lines.py --start: also write the static equilibrium as the state, for
  `hawser settle` to finish
"""

import json
import pathlib
import sys

import numpy as np

import anchor_lines_check as check
from line_statics import G, Statics, hang, rotation, solve_line

ROOT = pathlib.Path(__file__).resolve().parent.parent / "scenes"
STATE = "anchor_lines.settled.json"
RHO = 1025.0  # sea water [kg/m³]
DEPTH = 150.0  # the lines hang free above a bed at this depth; nothing touches it

# Rig: twin pontoons and four columns [m]. Points are in its frame: centre of mass, x to ahts1.
PONTOON, COLUMN_D, COLUMN_AT = (80, 15, 8.5), 13.0, (30, 29)
DRAUGHT, RIG_KG, DECK_Z = 21.0, 20.0, 26.0
RIG_CM_Z = RIG_KG - DRAUGHT
FAIRLEAD = (36.0, 35.0, -11.0)  # mirrored to the four columns
TOW_POINT, CHAIN_POINT = (38.0, -24.0, -5.0), (38.0, 14.0, -11.0)  # ahts2: turned by 180°
DERRICK_MASS, DERRICK_AT = 4.5e5, (1.0, 0.0, 50.0)
RIG_CRANES = {"rig_crane_port": ((0, 34, DECK_Z), 60.0),
              "rig_crane_starboard": ((0, -34, DECK_Z), 240.0)}

# Moorings: headings from the x axis, horizontal tension, lift at the anchor [N].
HEADINGS, MOORING_H, ANCHOR_V, MOORING_N = (30.0, 60.0), 1.0e6, 1.5e4, 82

# Anchor handlers [m]; hull frame: centre of mass, x forward.
SHIP_L, SHIP_B, SHIP_T, SHIP_KG, SHIP_CB, SHIP_CWP = 80.0, 18.0, 6.0, 7.0, 0.65, 0.85
SHIP_GM = (1.45, 95.0)
SHIP_CM_Z = SHIP_KG - SHIP_T
TOW_H, TOW_Y, TOW_N, TOW_SPAN = 3.5e5, -1.75, 64, 440.0
WORK_H, WORK_Y, WORK_N, CHAIN_LENGTH, CHAIN_N = 6.0e5, 1.0, 26, 340.0, 52
# Anchors on the work wires: shackle and pad eye at (∓2.5, 0, 0.6).
ANCHOR_MASS, ANCHOR_ARM, ANCHOR_PITCH = 1.5e4, (2.5, 0.0, 0.6), -16.5
SITE_OFFSET, SITE_TOW_LENGTH, SITE_TOW_N = 1200.0, 1136.0, 60


def read_part(name):
    return json.loads((ROOT / "parts" / f"{name}.json").read_text())


LINES = read_part("lines")["line_types"]
TEMPLATES = {name: read_part(name)["templates"][name] for name in ("crane", "ahts", "windlass")}
AHTS = {b["name"]: b for b in TEMPLATES["ahts"]["bodies"]}
ROLLER = AHTS["roller"]["position"]


def weight(line):
    t = LINES[line]
    return t["mass_per_length"] * t["submerged_factor"] * G


def seg(line, length):
    return weight(line), LINES[line]["EA"], length


def mirrored(p, sx, sy):
    return [p[0] * sx, p[1] * sy, p[2]]


def carried(template, position=(0, 0, 0), yaw_deg=0.0):
    """Return weight [N] and position of a template's bodies on its hull."""
    t, r = TEMPLATES[template], rotation([0, 0, np.radians(yaw_deg)])
    value = lambda m: t["parameters"][m[2:-1]] if isinstance(m, str) else m
    loads = [(value(b["mass"]) * G, np.array(position) + r @ b["position"])
             for b in t["bodies"] if "position" in b]
    for i in t.get("instances", []):
        loads += carried(i["template"], i["position"], i["euler_deg"][2])
    return loads


def design():
    """Return the lengths and end points of all lines, rounded to the digits in the scene."""
    d = {"moorings": []}
    # Mooring: given tension and lift at the anchor, the height fixes the length.
    height = DEPTH + RIG_CM_Z + FAIRLEAD[2]
    lengths = np.linspace(100, 1500, 1401)
    z = [hang([seg("chain76", L)], MOORING_H, ANCHOR_V)[1] for L in lengths]
    d["mooring_length"] = round(float(np.interp(height, z, lengths)), 1)
    line = [seg("chain76", d["mooring_length"])]
    span, _, d["mooring_v"] = hang(line, MOORING_H, ANCHOR_V)
    for sx, sy in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        for a in np.radians(HEADINGS):
            f = mirrored(FAIRLEAD, sx, sy)
            at = [f[0] + sx * span * np.cos(a), f[1] + sy * span * np.sin(a), -DEPTH]
            d["moorings"].append((f, [round(float(x), 2) for x in at]))
    # Tow wire, rig to roller.
    end = SHIP_CM_Z + ROLLER[2] - RIG_CM_Z
    length, d["tow_v"] = solve_line(lambda L: [seg("wire76", L)], TOW_SPAN, end - TOW_POINT[2],
                                    TOW_H, TOW_SPAN, -4e4)
    d["tow_length"] = round(length, 2)
    # Chain on the work wire, anchor as a point weight, work wire; from rig to roller.
    in_hand = lambda L: [seg("chain76", CHAIN_LENGTH), 0.87 * ANCHOR_MASS * G, seg("wire76", L)]
    length, d["chain_v"] = solve_line(in_hand, TOW_SPAN - 2 * ANCHOR_ARM[0],
                                      end - CHAIN_POINT[2], WORK_H, 150.0, -3e5)
    d["work_length"] = round(length, 1)
    x, z, _ = hang([seg("chain76", CHAIN_LENGTH)], WORK_H, d["chain_v"])
    x += ANCHOR_ARM[0]
    y = CHAIN_POINT[1] + x / TOW_SPAN * (WORK_Y - CHAIN_POINT[1])
    z += RIG_CM_Z + CHAIN_POINT[2] - ANCHOR_ARM[2]
    d["anchor"] = [round(float(v), 1) for v in (CHAIN_POINT[0] + x, y, z)]
    d["ship_x"] = TOW_POINT[0] + TOW_SPAN - ROLLER[0]
    d["stern_v"] = (hang([seg("wire76", d["tow_length"])], TOW_H, d["tow_v"])[2]
                    + hang(in_hand(d["work_length"]), WORK_H, d["chain_v"])[2])
    d["thrust"] = TOW_H + WORK_H
    return d


def rig_hydrostatics(d):
    """Return GM = KB + I/V − KG from pontoons and columns, and the rest height under all loads."""
    columns = np.pi * COLUMN_D**2
    pontoons = 2 * np.prod(PONTOON)
    above = columns * (DRAUGHT - PONTOON[2])
    volume = pontoons + above
    kb = (pontoons * PONTOON[2] + above * (DRAUGHT + PONTOON[2])) / (2 * volume)
    own = np.pi * COLUMN_D**4 / 16
    mass, heave = round(RHO * volume, -5), round(RHO * G * columns, -4)
    gm = [kb + (columns * COLUMN_AT[i]**2 + own) / volume - RIG_KG for i in (1, 0)]
    load = (8 * d["mooring_v"] - 2 * (d["tow_v"] + d["chain_v"]) + DERRICK_MASS * G
            + len(RIG_CRANES) * sum(w for w, _ in carried("crane")))
    return {"mass": mass, "heave": heave, "gm": gm, "load": load,
            "tilt": [round(mass * G * g, -6) for g in gm],
            "inertia": [round(mass * r * r, -8) for r in (31.0, 32.0, 38.0)],
            "rest": round(RIG_CM_Z + load / heave, 3)}


def ship_hydrostatics(d):
    mass = round(RHO * SHIP_L * SHIP_B * SHIP_T * SHIP_CB, -4)
    heave = round(RHO * G * SHIP_CWP * SHIP_L * SHIP_B, -4)
    load = d["stern_v"] + sum(w for w, _ in carried("ahts"))
    radii = (0.35 * SHIP_B, 0.25 * SHIP_L, 0.25 * SHIP_L)
    return {"mass": mass, "heave": heave, "gm": SHIP_GM, "load": load,
            "tilt": [round(mass * G * g, -5) for g in SHIP_GM],
            "inertia": [round(mass * r * r, -5) for r in radii],
            "rest": round(SHIP_CM_Z + load / heave, 3)}


def water(v, zeta):
    """Return the `hydrostatic` interaction; zeta: fraction of critical damping."""
    tilt = [2 * zeta * np.sqrt(k * i) for k, i in zip(v["tilt"], v["inertia"])]
    return {"heave_stiffness": v["heave"], "roll_stiffness": v["tilt"][0],
            "pitch_stiffness": v["tilt"][1],
            "heave_damping": round(2 * zeta * np.sqrt(v["heave"] * v["mass"]), -4),
            "roll_damping": round(tilt[0], -6), "pitch_damping": round(tilt[1], -6),
            "rest_height": v["rest"]}


def require_ahts(ship):
    """Check the anchor handler's handwritten template: its numbers must be those of the design."""
    wanted = {"mass": ship["mass"], "inertia": ship["inertia"]} | water(ship, 0.2)
    stored = AHTS["hull"] | TEMPLATES["ahts"]["interactions"][0]
    for key, value in wanted.items():
        if not np.allclose(stored[key], value, rtol=1e-12):
            sys.exit(f"scenes/parts/ahts.json: {key} is {stored[key]}, designed {value}")


# --- the scene --------------------------------------------------------------------------------


def anchor(d, i, s):
    return {"name": f"anchor{i}", "position": mirrored(d["anchor"], s, s),
            "euler_deg": [0, ANCHOR_PITCH, 0 if s > 0 else 180],
            "mass": ANCHOR_MASS, "box": [2.5, 2.5, 0.8],
            "force": [0, 0, round(0.13 * ANCHOR_MASS * G)],
            "linear_damping": 1e4, "angular_damping": 2e4}


def cable(name, line, start, to, length, n, drum, radius):
    return {"name": name, "line_type": line, "from": start, "to": to, "length": length,
            "elements": n, "shape": "catenary", "winch": {"drum": drum, "radius": radius}}


def ship_lines(d, i, s):
    """Return the chain on the work wire, the work wire and the tow wire of anchor handler i."""
    chain = cable(f"chain{i}", "chain76", {"body": "rig", "point": mirrored(CHAIN_POINT, s, s)},
                  {"body": f"anchor{i}", "point": mirrored(ANCHOR_ARM, -1, 1)},
                  CHAIN_LENGTH, CHAIN_N, f"windlass{8 + i}/drum", 0.6)
    roller = lambda y: {"body": f"ahts{i}/roller", "point": [0, y, 0]}
    work = cable(f"work{i}", "wire76", roller(WORK_Y),
                 {"body": f"anchor{i}", "point": ANCHOR_ARM},
                 d["work_length"], WORK_N, f"ahts{i}/work_drum", 1.2)
    tow = cable(f"tow{i}", "wire76", roller(TOW_Y),
                {"body": "rig", "point": mirrored(TOW_POINT, s, s)},
                d["tow_length"], TOW_N, f"ahts{i}/tow_drum", 1.2)
    return [chain, work, tow]


def scene(d, rig):
    derrick = [DERRICK_AT[0], DERRICK_AT[1], RIG_CM_Z + DERRICK_AT[2]]
    bodies = [
        {"name": "rig", "position": [0, 0, RIG_CM_Z], "mass": rig["mass"],
         "inertia": rig["inertia"], "gravity": False, "half_size": [40, 36, 13],
         "linear_damping": [3e5, 3e5, 0], "angular_damping": [0, 0, 6e8]},
        {"name": "derrick", "position": derrick, "mass": DERRICK_MASS, "box": [7, 7, 24]},
    ] + [anchor(d, i, s) for i, s in ((1, 1), (2, -1))]
    interactions = [
        {"name": "rig_water", "kind": "hydrostatic", "bodies": ["rig"]} | water(rig, 0.15),
        {"name": "derrick_feet", "kind": "lock", "bodies": ["rig", "derrick"],
         "at": [derrick[0], derrick[1], RIG_CM_Z + DECK_Z]},
    ]
    instances = [{"template": "windlass", "name": f"windlass{i + 1}"} for i in range(10)]
    instances += [{"template": "crane", "name": name, "on": "rig", "position": p,
                   "euler_deg": [0, 0, slew], "bind": {"base": "rig"}}
                  for name, (p, slew) in RIG_CRANES.items()]
    instances += [{"template": "ahts", "name": f"ahts{i}",
                   "position": [s * d["ship_x"], 0, SHIP_CM_Z],
                   "euler_deg": [0, 0, 0 if s > 0 else 180],
                   "parameters": {"thrust": d["thrust"]}} for i, s in ((1, 1), (2, -1))]
    cables = [cable(f"mooring{i}", "chain76", {"body": "rig", "point": f}, {"at": at},
                    d["mooring_length"], MOORING_N, f"windlass{i}/drum", 0.6)
              for i, (f, at) in enumerate(d["moorings"], 1)]
    cables += ship_lines(d, 1, 1) + ship_lines(d, 2, -1)
    site_tow = {"name": "site_tow", "line_type": "poly80",
                 "from": {"body": "rig", "point": [0, 38, -8]},
                 "to": {"body": "rig", "point": [0, -38, -8]},
                 "length": SITE_TOW_LENGTH, "elements": SITE_TOW_N}
    return {
        "$schema": "../schema/scene-1.json", "version": 2, "name": "anchor_lines",
        "description": "A semi-submersible on eight mooring chains; two anchor handlers tow and "
                       "hold two more of its chains, anchors on the work wires. "
                       "See docs/anchor_lines.md and scripts/make_anchor_lines.py.",
        "settings": {"duration": 60},
        "include": [f"parts/{p}.json" for p in ("lines", "crane", "ahts", "windlass")],
        "bodies": bodies, "interactions": interactions, "instances": instances, "cables": cables,
        "repeat": {"offset": [0, SITE_OFFSET, 0], "joins": [site_tow]},
        "plot": {"tensions": ["mooring1", "chain1", "work1", "tow1"],
                 "motions": ["rig", "ahts1/hull", "ahts2/hull"]},
    }


def to_statics(sc, d, rig, ship):
    """Convert the scene to points, bodies and springs; carried bodies are weights on their hull."""
    st = Statics()
    loads = [(DERRICK_MASS * G, DERRICK_AT)]
    for p, slew in RIG_CRANES.values():
        loads += carried("crane", p, slew)
    index = {"rig": st.add_body([0, 0, RIG_CM_Z], heave=(rig["heave"], rig["rest"]),
                                tilt=rig["tilt"], loads=loads)}
    for i, s in ((1, 1), (2, -1)):
        index[f"ahts{i}"] = st.add_body(
            [s * d["ship_x"], 0, SHIP_CM_Z], 0 if s > 0 else np.pi, [s * d["thrust"], 0, 0],
            (ship["heave"], ship["rest"]), ship["tilt"], carried("ahts"))
        a = anchor(d, i, s)
        index[f"anchor{i}"] = st.add_body(a["position"], np.radians(a["euler_deg"][2]),
                                          loads=[(ANCHOR_MASS * G - a["force"][2], (0, 0, 0))])

    def end(e):
        if "at" in e:
            return "fixed", e["at"]
        arm = np.array(e["point"], float) + (ROLLER if "roller" in e["body"] else 0)
        return "body", index[e["body"].split("/")[0]], tuple(arm)

    springs = {c["name"]: st.add_line(end(c["from"]), end(c["to"]), c["length"], c["elements"],
                                      *seg(c["line_type"], 0)[:2]) for c in sc["cables"]}
    return st, index, springs


# --- output -----------------------------------------------------------------------------------


def lay_site_tow(join, st, rig):
    """Find the equilibrium of the line between two sites with this rig's position. Given as
    points: a catenary of rigid elements would start slack and fall 1 m."""
    b = st.bodies[rig]
    ends = [b["x"] + b["R"] @ join[e]["point"] for e in ("from", "to")]
    ends[1] = ends[1] + [0, SITE_OFFSET, 0]
    line = Statics()
    line.add_line(("fixed", ends[0]), ("fixed", ends[1]), join["length"], join["elements"],
                  *seg(join["line_type"], 0)[:2])
    line.solve()
    join["shape"] = [[round(float(x), 4) for x in p] for p in line.nodes]


def plain(v):
    """Write whole numbers without a fraction: 950000, not 950000.0."""
    if isinstance(v, dict):
        return {k: plain(x) for k, x in v.items()}
    if isinstance(v, (list, tuple)):
        return [plain(x) for x in v]
    if isinstance(v, (float, np.floating)):
        return int(v) if float(v).is_integer() else float(v)
    return v


def dump(value, indent=0, width=100):
    """Return JSON with short lists and objects on one line."""
    flat = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, (dict, list)) or len(flat) + indent <= width:
        return flat
    pad = " " * (indent + 2)
    if isinstance(value, dict):
        items = [f"{json.dumps(k)}: {dump(v, indent + 2, width)}" for k, v in value.items()]
    else:
        items = [dump(v, indent + 2, width) for v in value]
    a, b = "{}" if isinstance(value, dict) else "[]"
    return a + "\n" + ",\n".join(pad + i for i in items) + "\n" + " " * indent + b


def main():
    d = design()
    rig, ship = rig_hydrostatics(d), ship_hydrostatics(d)
    require_ahts(ship)
    sc = scene(d, rig)
    st, index, springs = to_statics(sc, d, rig, ship)
    st.solve()
    check.report({"rig": rig, "ahts": ship}, d["thrust"], st, index, springs, sc, LINES)
    check.count(sc, TEMPLATES, LINES)
    lay_site_tow(sc["repeat"]["joins"][0], st, index["rig"])
    for inst in sc["instances"]:  # start the vessels at their equilibrium
        if inst["template"] == "ahts":
            xy = st.bodies[index[inst["name"]]]["x"][:2]
            inst["position"][:2] = [round(float(x), 2) for x in xy]
    if "--start" in sys.argv:
        check.write_start(ROOT / STATE, sc, st, index, springs, TEMPLATES)
    if (ROOT / STATE).exists():
        sc["state"] = {"file": STATE}
    text = dump(plain(sc)) + "\n"
    if "--check" in sys.argv:
        same = (ROOT / "anchor_lines.json").read_text() == text
        print("scenes/anchor_lines.json is " + ("as designed" if same else "NOT as designed"))
        check.compare(st, index, springs, ROOT / STATE)
        sys.exit(not same)
    check.site_tow(st, index["rig"], seg("poly80", 0), SITE_OFFSET - 76.0, SITE_TOW_LENGTH)
    (ROOT / "anchor_lines.json").write_text(text)


if __name__ == "__main__":
    main()
