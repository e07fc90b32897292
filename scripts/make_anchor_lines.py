#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Design and write scenes/anchor_lines.json and the templates it includes (numpy only).

The scene: a semi-submersible on eight mooring chains; two anchor handlers, each towing at the
rig with a tow wire and holding one more of its chains, with the anchor still on the work wire.
Line lengths are chosen for wanted tensions with the closed-form elastic catenary, the thrusts
balance the lines, and Newton's method on the lumped model gives the static equilibrium, with
which the engine's settled state can be compared. docs/anchor_lines.md explains every number.

    scripts/make_anchor_lines.py            print the design, write the files under scenes/
    scripts/make_anchor_lines.py --check    print the design, compare with scenes/*.settled.json
"""

import json
import pathlib
import sys

import numpy as np

from anchor_lines_parts import AHTS, CRANE, CRANE_LOADS, LINES, WINDLASS
from line_statics import G, Statics, hang, rotation, solve_line

RHO = 1025.0      # sea water [kg/m³]
DEPTH = 150.0     # the lines hang free above a bed at this depth; nothing touches it
SCENES = pathlib.Path(__file__).resolve().parent.parent / "scenes"

# Rig: twin-pontoon, four-column drilling semi-submersible.
PONTOON, COLUMN_D, COLUMN_AT, DRAUGHT, RIG_KG, DECK_Z = (80, 15, 8.5), 13.0, (30, 29), 21.0, 20.0, 26.0
RIG_CM_Z = RIG_KG - DRAUGHT
FAIRLEAD = (36.0, 35.0, -11.0)                    # body frame; mirrored to the four columns
TOW_POINT, CHAIN_POINT = (38.0, -24.0, -5.0), (38.0, 14.0, -11.0)
DERRICK = (4.5e5, (1.0, 0.0, 50.0))
RIG_CRANES = {"rig_crane_port": ((0, 34, DECK_Z), 60.0), "rig_crane_starboard": ((0, -34, DECK_Z), 240.0)}
MOORING_HEADINGS, MOORING_H, ANCHOR_V, MOORING_N = (30.0, 60.0), 1.0e6, 1.5e4, 80

# Anchor handlers; the hull's frame has its origin at the centre of mass, x forward.
SHIP_KG, SHIP_T, SHIP_L, SHIP_B, SHIP_CB, SHIP_CWP, SHIP_GM, SHIP_GML = 7.0, 6.0, 80.0, 18.0, 0.65, 0.85, 1.45, 95.0
SHIP_CM_Z = SHIP_KG - SHIP_T
ROLLER, ROLLER_MASS = (-40.0, 0.0, -0.2), 4.0e4
DECK_ANCHORS = (3.0e4, (-20.0, -4.0, 2.0))
SHIP_CRANE = ((4.0, 7.0, 1.0), 200.0)
TOW_H, TOW_Y, TOW_N, TOW_SPAN = 3.5e5, 1.75, 64, 440.0
WORK_H, WORK_Y, CHAIN_L, CHAIN_N, WORK_N = 6.0e5, -1.0, 340.0, 52, 26
ANCHOR_MASS, ANCHOR_ARM, ANCHOR_PITCH = 1.5e4, (2.5, 0.0, 0.6), -16.5  # shackle and pad eye at (∓2.5, 0, 0.6)
SITE_OFFSET, MESSENGER_L, MESSENGER_N = 1200.0, 1136.0, 60


def weight(line):
    t = LINES[line]
    return t["mass_per_length"] * t["submerged_factor"] * G


def seg(line, length):
    return weight(line), LINES[line]["EA"], length


def mirrored(p, sx, sy):
    return [p[0] * sx, p[1] * sy, p[2]]


def design():
    """Lengths and end points of all lines, rounded to what is written in the scene."""
    d = {"moorings": []}
    # Mooring: given h and the lift at the anchor, the height fixes the length.
    w, ea, _ = seg("chain76", 0)
    height = DEPTH + RIG_CM_Z + FAIRLEAD[2]
    lengths = np.linspace(100, 1500, 1401)
    z = [hang([(w, ea, L)], MOORING_H, ANCHOR_V)[1] for L in lengths]
    d["mooring_length"] = round(float(np.interp(height, z, lengths)), 1)
    span, _, d["mooring_v"] = hang([(w, ea, d["mooring_length"])], MOORING_H, ANCHOR_V)
    for sx, sy in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        for a in np.radians(MOORING_HEADINGS):
            f = mirrored(FAIRLEAD, sx, sy)
            at = [round(f[0] + sx * span * np.cos(a), 2), round(f[1] + sy * span * np.sin(a), 2), -DEPTH]
            d["moorings"].append((f, at))
    # Tow wire, rig to roller.
    rise = SHIP_CM_Z + ROLLER[2] - (RIG_CM_Z + TOW_POINT[2])
    L, d["tow_v0"] = solve_line(lambda L: [seg("wire76", L)], TOW_SPAN, rise, TOW_H, TOW_SPAN, -4e4)
    d["tow_length"] = round(L, 2)
    # Chain in hand, anchor, work wire, rig to roller (the anchor as a point weight).
    rise = SHIP_CM_Z + ROLLER[2] - (RIG_CM_Z + CHAIN_POINT[2])
    anchor = 0.87 * ANCHOR_MASS * G
    L, d["chain_v0"] = solve_line(
        lambda L: [seg("chain76", CHAIN_L), anchor, seg("wire76", L)],
        TOW_SPAN - 2 * ANCHOR_ARM[0], rise, WORK_H, 150.0, -3e5)
    d["work_length"] = round(L, 1)
    d["ship_x"] = TOW_POINT[0] + TOW_SPAN - ROLLER[0]
    x, z, _ = hang([seg("chain76", CHAIN_L)], WORK_H, d["chain_v0"])
    y = CHAIN_POINT[1] + (x + ANCHOR_ARM[0]) / TOW_SPAN * (-WORK_Y - CHAIN_POINT[1])
    d["anchor"] = [round(CHAIN_POINT[0] + x + ANCHOR_ARM[0], 1), round(y, 1),
                   round(RIG_CM_Z + CHAIN_POINT[2] + z - ANCHOR_ARM[2], 1)]
    _, _, v = hang([seg("wire76", d["tow_length"])], TOW_H, d["tow_v0"])
    _, _, vw = hang([seg("chain76", CHAIN_L), anchor, seg("wire76", d["work_length"])], WORK_H, d["chain_v0"])
    d["stern_v"] = v + vw
    d["thrust"] = TOW_H + WORK_H
    return d


def vessels(d):
    """Hydrostatics. Vessels and what they carry are as built at their settled height."""
    crane = sum(w for w, _ in CRANE_LOADS)
    columns = 4 * np.pi * COLUMN_D**2 / 4
    pontoons = 2 * np.prod(PONTOON)
    volume = pontoons + columns * (DRAUGHT - PONTOON[2])
    kb = (pontoons * PONTOON[2] / 2 + columns * (DRAUGHT - PONTOON[2]) * (DRAUGHT + PONTOON[2]) / 2) / volume
    own = 4 * np.pi * COLUMN_D**4 / 64
    m = round(RHO * volume, -5)
    gm = [kb + (columns * COLUMN_AT[i]**2 + own) / volume - RIG_KG for i in (1, 0)]
    k = round(RHO * G * columns, -4)
    load = 8 * d["mooring_v"] - 2 * (d["tow_v0"] + d["chain_v0"]) + DERRICK[0] * G + 2 * crane
    rig = {"mass": m, "k": k, "gm": gm, "tilt": [round(m * G * g, -6) for g in gm],
           "inertia": [round(m * r * r, -8) for r in (31.0, 32.0, 38.0)], "load": load,
           "rest": round(RIG_CM_Z + load / k, 3)}
    volume = SHIP_L * SHIP_B * SHIP_T * SHIP_CB
    m, k = round(RHO * volume, -4), round(RHO * G * SHIP_CWP * SHIP_L * SHIP_B, -4)
    load = d["stern_v"] + crane + (ROLLER_MASS + DECK_ANCHORS[0]) * G
    ship = {"mass": m, "k": k, "gm": [SHIP_GM, SHIP_GML], "load": load,
            "tilt": [round(m * G * g, -5) for g in (SHIP_GM, SHIP_GML)],
            "inertia": [round(m * r * r, -5) for r in (0.35 * SHIP_B, 0.25 * SHIP_L, 0.25 * SHIP_L)],
            "rest": round(SHIP_CM_Z + load / k, 3)}
    return rig, ship


# --- the scene -------------------------------------------------------------------------------


def hydrostatic(body, v, zeta):
    heave = 2 * zeta * np.sqrt(v["k"] * v["mass"])
    tilt = [2 * zeta * np.sqrt(k * i) for k, i in zip(v["tilt"], v["inertia"])]
    return {"name": f"{body}_water", "kind": "hydrostatic", "bodies": [body],
            "heave_stiffness": v["k"], "roll_stiffness": v["tilt"][0], "pitch_stiffness": v["tilt"][1],
            "heave_damping": round(heave, -4), "roll_damping": round(tilt[0], -6),
            "pitch_damping": round(tilt[1], -6), "rest_height": v["rest"]}


def scene(d, rig, ship):
    bodies = [
        {"name": "rig", "position": [0, 0, RIG_CM_Z], "mass": rig["mass"], "inertia": rig["inertia"],
         "gravity": False, "half_size": [40, 36, 13], "linear_damping": [3e5, 3e5, 0],
         "angular_damping": [0, 0, 6e8]},
        {"name": "derrick", "position": [DERRICK[1][0], DERRICK[1][1], RIG_CM_Z + DERRICK[1][2]],
         "mass": DERRICK[0], "box": [7, 7, 24]},
    ]
    interactions = [
        hydrostatic("rig", rig, 0.15),
        {"name": "derrick_feet", "kind": "lock", "bodies": ["rig", "derrick"], "at": [DERRICK[1][0], 0, DECK_Z + RIG_CM_Z]},
    ]
    cables, instances = [], []

    def chain(name, drum, point, to, length, n):
        instances.append({"template": "windlass", "name": drum})
        cables.append({"name": name, "line_type": "chain76", "from": {"body": "rig", "point": point}, "to": to,
                       "length": length, "elements": n, "shape": "catenary",
                       "winch": {"drum": f"{drum}/drum", "radius": 0.6}})

    for i, (f, at) in enumerate(d["moorings"], 1):
        chain(f"mooring{i}", f"windlass{i}", f, {"at": at}, d["mooring_length"], MOORING_N)
    for name, (p, slew) in RIG_CRANES.items():
        instances.append({"template": "crane", "name": name, "on": "rig", "position": list(p),
                          "euler_deg": [0, 0, slew], "bind": {"base": "rig"}})
    for i, s in ((1, 1), (2, -1)):
        instances.append({"template": "ahts", "name": f"ahts{i}", "position": [s * d["ship_x"], 0, SHIP_CM_Z],
                          "euler_deg": [0, 0, 0 if s > 0 else 180], "parameters": {"thrust": s * d["thrust"]}})
        anchor = {"name": f"anchor{i}", "position": [s * d["anchor"][0], s * d["anchor"][1], d["anchor"][2]],
                  "euler_deg": [0, ANCHOR_PITCH, 0 if s > 0 else 180],
                  "mass": ANCHOR_MASS, "box": [2.5, 2.5, 0.8],
                  "force": [0, 0, round(0.13 * ANCHOR_MASS * G)],
                  "linear_damping": 1e4, "angular_damping": 2e4}
        bodies.append(anchor)
        shackle, eye = mirrored(ANCHOR_ARM, -1, 1), list(ANCHOR_ARM)
        chain(f"chain{i}", f"windlass{8 + i}", mirrored(CHAIN_POINT, s, s),
              {"body": f"anchor{i}", "point": shackle}, CHAIN_L, CHAIN_N)
        for kind, y, length, n, to in (
                ("work", WORK_Y * -1, d["work_length"], WORK_N, {"body": f"anchor{i}", "point": eye}),
                ("tow", TOW_Y * -1, d["tow_length"], TOW_N, {"body": "rig", "point": mirrored(TOW_POINT, s, s)})):
            at = {"body": f"ahts{i}/roller", "point": [0, y, 0]}
            cables.append({"name": f"{kind}{i}", "line_type": "wire76", "from": at, "to": to, "length": length,
                           "elements": n, "shape": "catenary",
                           "winch": {"drum": f"ahts{i}/{kind}_drum", "radius": 1.2}})
    join = {"name": "messenger", "line_type": "poly80", "from": {"body": "rig", "point": [0, 38, -8]},
            "to": {"body": "rig", "point": [0, -38, -8]}, "length": MESSENGER_L, "elements": MESSENGER_N,
            "shape": "catenary"}
    return {
        "$schema": "../schema/scene-1.json", "version": 1, "name": "anchor_lines",
        "description": "A semi-submersible on eight mooring chains; two anchor handlers hold two more of its "
                       "chains, anchors on the work wire, and tow. Written by scripts/make_anchor_lines.py; "
                       "explained in docs/anchor_lines.md. Frozen.",
        "settings": {"duration": 60},
        "include": ["parts/lines.json", "parts/crane.json", "parts/ahts.json", "parts/windlass.json"],
        "bodies": bodies, "interactions": interactions, "instances": instances, "cables": cables,
        "repeat": {"offset": [0, SITE_OFFSET, 0], "joins": [join]},
        "plot": {"tensions": ["mooring1", "chain1", "work1", "tow1"], "motions": ["rig", "ahts1/hull", "ahts2/hull"]},
    }


# --- statics ---------------------------------------------------------------------------------


def to_statics(sc, rig, ship):
    """The scene as points, bodies and springs; carried bodies are dead weights on their hull."""
    st = Statics()
    crane = lambda p, slew: [(w, np.array(p) + rotation([0, 0, np.radians(slew)]) @ a) for w, a in CRANE_LOADS]
    loads = [(DERRICK[0] * G, DERRICK[1])]
    for p, slew in RIG_CRANES.values():
        loads += crane(p, slew)
    index = {"rig": st.add_body([0, 0, RIG_CM_Z], heave=(rig["k"], rig["rest"]), tilt=rig["tilt"], loads=loads)}
    loads = crane(*SHIP_CRANE) + [(ROLLER_MASS * G, ROLLER), (DECK_ANCHORS[0] * G, DECK_ANCHORS[1])]
    for inst in sc["instances"]:
        if inst["template"] == "ahts":
            index[inst["name"] + "/roller"] = st.add_body(
                inst["position"], np.radians(inst["euler_deg"][2]), [inst["parameters"]["thrust"], 0, 0],
                (ship["k"], ship["rest"]), ship["tilt"], loads)
    for b in sc["bodies"]:
        if b["name"].startswith("anchor"):
            net = b["mass"] * G - b["force"][2]
            index[b["name"]] = st.add_body(b["position"], np.radians(b["euler_deg"][2]), loads=[(net, (0, 0, 0))])
    springs = {}
    for c in sc["cables"]:
        ends = []
        for e in (c["from"], c["to"]):
            if "at" in e:
                ends.append(("fixed", e["at"]))
            else:
                arm = np.array(e["point"], float) + (ROLLER if "roller" in e["body"] else 0)
                ends.append(("body", index[e["body"]], tuple(arm)))
        t, n = LINES[c["line_type"]], c["elements"]
        p, q = st.point(ends[0]), st.point(ends[1])
        sag = (c["length"] > np.linalg.norm(q - p)) * np.sqrt(max(0, c["length"]**2 - (q - p) @ (q - p)) * 0.2)
        chain = [ends[0]]
        for k in range(1, n):
            u = k / n
            chain.append(("node", st.add_node(p + (q - p) * u - [0, 0, sag * 4 * u * (1 - u)],
                                              weight(c["line_type"]) * c["length"] / n)))
        chain.append(ends[1])
        st.lines.append((len(st.nodes) - (n - 1), len(st.nodes)))
        first = len(st.springs)
        for a, b in zip(chain, chain[1:]):
            st.add_spring(a, b, c["length"] / n, t["EA"])
        springs[c["name"]] = (first, n)
    return st, index, springs


def report(d, rig, ship, st, index, springs):
    print("vessel  mass[t]  GM_T  GM_L  load[kN]  dry periods heave/roll/pitch [s]")
    for name, v in (("rig", rig), ("ahts", ship)):
        t = [2 * np.pi * np.sqrt(a / b) for a, b in zip([v["mass"]] + v["inertia"], [v["k"]] + v["tilt"])]
        print(f"{name:6} {v['mass']/1e3:8.0f} {v['gm'][0]:5.2f} {v['gm'][1]:5.1f} {v['load']/1e3:9.0f}  " + " ".join(f"{x:5.1f}" for x in t))
    print(f"thrust of each anchor handler {d['thrust']/1e3:.0f} kN = {d['thrust']/G/1e3:.0f} t")
    for name, i in index.items():
        b = st.bodies[i]
        r = b["R"]
        print(f"{name:14} x {b['x'].round(3)}  roll {np.degrees(r[2, 1]):.3f} pitch {np.degrees(-r[2, 0]):.3f} "
              f"yaw {np.degrees(np.arctan2(r[1, 0], r[0, 0])):.3f} deg")
    for name, (first, n) in springs.items():
        t = [st.tension(first + k) for k in range(n)]
        z = min(st.point(e)[2] for k in range(n) for e in st.springs[first + k][:2])
        line = "chain76" if name[0] in "mc" else "wire76"
        print(f"{name:10} length {st.springs[first][2]*n:7.2f} m, element {st.springs[first][2]:.2f} m, tension "
              f"{min(t)/1e3:7.1f} .. {max(t)/1e3:7.1f} kN, MBL/T {LINES[line]['breaking_load']/max(t):4.1f}, lowest {z:.1f} m")


ROWS = {"ball": 3, "hinge": 5, "prismatic": 5, "universal": 4, "lock": 6, "hydrostatic": 3, "hold": 1,
        "hinge_motor": 1, "slide_motor": 1, "scalar_motor": 1}
UNKNOWNS = {"rigid": 6, "scalar": 1}


def count(sc, ahts):
    """Sizes as the engine has to report them."""
    groups = [sc] + [{"ahts": ahts, "crane": CRANE, "windlass": WINDLASS}[i["template"]] for i in sc["instances"]]
    groups += [CRANE for i in sc["instances"] if i["template"] == "ahts"]
    bodies = sum(len(g.get("bodies", [])) for g in groups)
    unknowns = sum(UNKNOWNS[b.get("kind", "rigid")] for g in groups for b in g.get("bodies", []))
    joints = [i for g in groups for i in g.get("interactions", [])]
    cables = [c for g in groups for c in g.get("cables", [])]
    elements = sum(c["elements"] for c in cables)
    nodes = elements - len(cables)
    bends = sum(c["elements"] - 1 for c in cables if LINES[c["line_type"]]["EI"] > 0)
    rows = sum(ROWS[i["kind"]] for i in joints) + elements + 2 * bends
    print(f"moving bodies {bodies + nodes} (rigid and scalar {bodies}, lumps {nodes}), cable elements {elements}")
    print(f"interactions {len(joints) + elements + bends} (joints and drives {len(joints)}, stretch {elements}, bend {bends})")
    print(f"equations {unknowns + 3 * nodes + rows} = {unknowns + 3 * nodes} velocity unknowns + {rows} rows")


def messenger(st, index):
    """What the line between two sites does to them: its tension, and the shift of a rig at the end of a row."""
    span, (w, ea, _) = SITE_OFFSET - 76.0, seg("poly80", 0)
    low, high = 1e3, 1e6
    for _ in range(60):  # the longer the line, the smaller the tension
        h = np.sqrt(low * high)
        length, _ = solve_line(lambda L: [(w, ea, L)], span, 0.0, h, 1.01 * span, -w * span / 2)
        low, high = (h, high) if length > MESSENGER_L else (low, h)
    rig = st.bodies[index["rig"]]
    before = rig["x"].copy()
    rig["force"] = rig["force"] + [0, h, 0]
    rig["loads"].append((w * MESSENGER_L / 2, np.array([0, 38.0, -8.0])))
    st.solve()
    sag = h / w * (np.cosh(w * span / 2 / h) - 1)
    print(f"messenger: horizontal tension {h/1e3:.1f} kN, sag {sag:.0f} m, moves the last rig of a row by "
          f"{np.linalg.norm(rig['x'] - before):.3f} m")


def check_settled(st, index, springs):
    """Compare with the pose of every rigid body and line node that the engine settled to."""
    state = json.loads((SCENES / "anchor_lines.settled.json").read_text())["bodies"]
    for name, i in index.items():
        b, other = st.bodies[i], state[name.replace("/roller", "/hull")]
        q = other["q"]
        yaw = np.degrees(np.arctan2(2 * (q[0] * q[3] + q[1] * q[2]), 1 - 2 * (q[2]**2 + q[3]**2)))
        mine = np.degrees(np.arctan2(b["R"][1, 0], b["R"][0, 0]))
        print(f"{name:14} engine − statics: position {(np.array(other['p']) - b['x']).round(4)} m, yaw {yaw - mine:+.4f} deg")
    for name, (first, n) in springs.items():
        off = max(np.linalg.norm(st.point(st.springs[first + k][1]) - np.array(state[f"{name}/{k + 1}"]["p"]))
                  for k in range(n - 1))
        print(f"{name:14} engine − statics: nodes up to {off:.4f} m apart")


def dump(value, indent=0, width=110):
    """JSON with short lists and objects on one line."""
    flat = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, (dict, list)) or len(flat) + indent <= width:
        return flat
    pad, items = " " * (indent + 2), []
    if isinstance(value, dict):
        items = [f"{json.dumps(k)}: {dump(v, indent + 2)}" for k, v in value.items()]
    else:
        items = [dump(v, indent + 2) for v in value]
    a, b = "{}" if isinstance(value, dict) else "[]"
    return a + "\n" + ",\n".join(pad + i for i in items) + "\n" + " " * indent + b


def plain(v):
    """Numbers as people write them: 950000, not 950000.0."""
    if isinstance(v, dict):
        return {k: plain(x) for k, x in v.items()}
    if isinstance(v, (list, tuple)):
        return [plain(x) for x in v]
    if isinstance(v, (float, np.floating)):
        return int(v) if float(v).is_integer() and abs(v) < 1e15 else float(v)
    return v


def main():
    d = design()
    rig, ship = vessels(d)
    sc = scene(d, rig, ship)
    hull = hydrostatic("hull", ship, 0.2)
    hull["name"] = "water"
    ahts = AHTS(ship, hull, ROLLER, ROLLER_MASS, DECK_ANCHORS, SHIP_CRANE)
    st, index, springs = to_statics(sc, rig, ship)
    st.solve()
    report(d, rig, ship, st, index, springs)
    for inst in sc["instances"]:  # start the vessels where they will lie
        if inst["template"] == "ahts":
            xy = st.bodies[index[inst["name"] + "/roller"]]["x"][:2]
            inst["position"][:2] = [round(float(x), 2) for x in xy]
    count(sc, ahts)
    if "--check" in sys.argv:
        check_settled(st, index, springs)
        return
    messenger(st, index)
    parts = {"lines": {"line_types": LINES}, "crane": {"templates": {"crane": CRANE}},
             "ahts": {"templates": {"ahts": ahts}}, "windlass": {"templates": {"windlass": WINDLASS}}}
    (SCENES / "parts").mkdir(parents=True, exist_ok=True)
    for name, part in parts.items():
        (SCENES / "parts" / f"{name}.json").write_text(dump(plain({"version": 1} | part)) + "\n")
    (SCENES / "anchor_lines.json").write_text(dump(plain(sc)) + "\n")


if __name__ == "__main__":
    main()
