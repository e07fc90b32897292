# SPDX-License-Identifier: Apache-2.0
"""Print checks of the scene anchor_lines; see make_anchor_lines.py."""

import json

import numpy as np

from line_statics import G, rotation, solve_line

ROWS = {"ball": 3, "hinge": 5, "prismatic": 5, "universal": 4, "lock": 6, "hydrostatic": 3,
        "hold": 1, "hinge_motor": 1, "slide_motor": 1, "scalar_motor": 1,
        "slide_range": 1}
UNKNOWNS = {"rigid": 6, "scalar": 1}


def yaw(r):
    return np.degrees(np.arctan2(r[1, 0], r[0, 0]))


def report(vessels, thrust, st, index, springs, sc, lines):
    print("vessel  mass[t]  GM_T  GM_L  load[kN]  dry periods heave/roll/pitch [s]")
    for name, v in vessels.items():
        periods = [2 * np.pi * np.sqrt(a / b)
                   for a, b in zip([v["mass"]] + v["inertia"], [v["heave"]] + v["tilt"])]
        print(f"{name:6} {v['mass'] / 1e3:8.0f} {v['gm'][0]:5.2f} {v['gm'][1]:5.1f} "
              f"{v['load'] / 1e3:9.0f}  " + " ".join(f"{x:5.1f}" for x in periods))
    print(f"thrust of each anchor handler {thrust / 1e3:.0f} kN = {thrust / G / 1e3:.0f} t")
    for name, i in index.items():
        x, r = st.bodies[i]["x"], st.bodies[i]["R"]
        print(f"{name:8} at {x.round(3)} m, roll {np.degrees(r[2, 1]):.3f}, "
              f"pitch {np.degrees(-r[2, 0]):.3f}, yaw {yaw(r):.3f} deg")
    for c in sc["cables"]:
        first, n = springs[c["name"]]
        t = [st.tension(first + k) / 1e3 for k in range(n)]
        z = min(st.point(e)[2] for k in range(n) for e in st.springs[first + k][:2])
        margin = lines[c["line_type"]]["breaking_load"] / 1e3 / max(t)
        print(f"{c['name']:9} length {c['length']:6.1f} m, element {c['length'] / n:.2f} m, "
              f"tension {min(t):6.1f} to {max(t):6.1f} kN, breaking load / tension {margin:4.1f}, "
              f"lowest {z:.1f} m")


def count(sc, templates, lines):
    """Return the sizes that the engine must report."""
    groups, queue = [sc], list(sc["instances"])
    while queue:
        groups.append(templates[queue.pop()["template"]])
        queue += groups[-1].get("instances", [])
    every = lambda key: [x for g in groups for x in g.get(key, [])]
    kinds = [b.get("kind", "rigid") for b in every("bodies")]
    joints, cables = every("interactions"), every("cables")
    elements = sum(c["elements"] for c in cables)
    nodes = elements - len(cables)
    bends = sum(c["elements"] - 1 for c in cables if lines[c["line_type"]]["EI"] > 0)
    unknowns = sum(UNKNOWNS[k] for k in kinds) + 3 * nodes
    rows = sum(ROWS[i["kind"]] for i in joints) + elements + 2 * bends
    print(f"moving bodies {len(kinds) + nodes}: rigid {kinds.count('rigid')}, "
          f"scalar {kinds.count('scalar')}, lumps {nodes}")
    print(f"interactions {len(joints) + elements + bends}: joints and drives {len(joints)}, "
          f"stretch {elements}, bend {bends}")
    print(f"equations {unknowns + rows} = {unknowns} velocity unknowns + {rows} rows")


def site_tow(st, rig, line, span, length):
    """Return the tension of the line between two sites and its displacement of the last rig."""
    w, ea, _ = line
    low, high = 1e3, 1e6
    for _ in range(60):  # the longer the line, the smaller the tension
        h = np.sqrt(low * high)
        found, _ = solve_line(lambda L: [(w, ea, L)], span, 0.0, h, 1.01 * span, -w * span / 2)
        low, high = (h, high) if found > length else (low, h)
    body = st.bodies[rig]
    before = body["x"].copy()
    body["force"] = body["force"] + [0, h, 0]
    body["loads"].append((w * length / 2, np.array([0, 38.0, -8.0])))
    st.solve()
    sag = h / w * (np.cosh(w * span / 2 / h) - 1)
    print(f"site_tow: horizontal tension {h / 1e3:.1f} kN, sag {sag:.0f} m; the last rig of a "
          f"row moves by {np.linalg.norm(body['x'] - before):.3f} m")


def compare(st, index, springs, file):
    """Compare the statics with the settled state of the engine."""
    state = json.loads(file.read_text())["bodies"]
    for name, i in index.items():
        x, r = st.bodies[i]["x"], st.bodies[i]["R"]
        s = state[name + "/hull" if name.startswith("ahts") else name]
        w, a, b, c = s["q"]
        engine_yaw = np.degrees(np.arctan2(2 * (w * c + a * b), 1 - 2 * (b * b + c * c)))
        off = np.array(s["p"]) - x
        print(f"{name:9} engine - statics: {off.round(4)} m, yaw {engine_yaw - yaw(r):+.4f} deg")
    for name, (first, n) in springs.items():
        off = [np.linalg.norm(st.point(st.springs[first + k][1]) - state[f"{name}/{k + 1}"]["p"])
               for k in range(n - 1)]
        print(f"{name:9} engine - statics: nodes up to {max(off):.4f} m apart")


def quaternion(r):
    """Return [w, x, y, z] of a rotation matrix: eigenvector of Bar-Itzhack (2000), any angle."""
    k = np.array([
        [r[0, 0] + r[1, 1] + r[2, 2], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
        [0, r[0, 0] - r[1, 1] - r[2, 2], r[1, 0] + r[0, 1], r[0, 2] + r[2, 0]],
        [0, 0, r[1, 1] - r[0, 0] - r[2, 2], r[2, 1] + r[1, 2]],
        [0, 0, 0, r[2, 2] - r[0, 0] - r[1, 1]]])
    return np.linalg.eigh(np.triu(k) + np.triu(k, 1).T)[1][:, -1]


def turn(euler_deg):
    x, y, z = np.radians(euler_deg)
    return rotation([0, 0, z]) @ rotation([0, y, 0]) @ rotation([x, 0, 0])


def write_start(file, sc, st, index, springs, templates):
    """Write the static equilibrium as a state, from which the engine settles in a few seconds."""
    bodies = {}

    def put(owner, name, position, r):
        """Place a body at a point of its owner's frame."""
        b = st.bodies[owner]
        bodies[name] = {"p": (b["x"] + b["R"] @ position).tolist(),
                        "q": quaternion(b["R"] @ r).tolist()}

    def put_template(owner, prefix, template, origin, r):
        for b in templates[template]["bodies"]:
            if b.get("kind") == "scalar":
                bodies[prefix + b["name"]] = {"p": [0, 0, 0]}
            else:
                at = origin + r @ b.get("position", [0, 0, 0])
                put(owner, prefix + b["name"], at, r @ turn(b.get("euler_deg", [0, 0, 0])))
        for c in templates[template].get("cables", []):  # the hook's wire, straight
            jib, hook = (np.array(bodies[prefix + c[e]["body"]]["p"]) for e in ("from", "to"))
            top = jib + turn_of(bodies[prefix + c["from"]["body"]]["q"]) @ c["from"]["point"]
            end = hook + turn_of(bodies[prefix + c["to"]["body"]]["q"]) @ c["to"]["point"]
            for k in range(1, c["elements"]):
                at = top + (end - top) * k / c["elements"]
                bodies[f"{prefix}{c['name']}/{k}"] = {"p": at.tolist()}
        for i in templates[template].get("instances", []):
            put_template(owner, f"{prefix}{i['name']}/", i["template"],
                         origin + r @ i["position"], r @ turn(i["euler_deg"]))

    for i in sc["instances"]:
        owner = index.get(i["name"], index["rig"])
        place = [0, 0, 0] if i["name"] in index else i.get("position", [0, 0, 0])
        angle = [0, 0, 0] if i["name"] in index else i.get("euler_deg", [0, 0, 0])
        put_template(owner, i["name"] + "/", i["template"], np.array(place, float), turn(angle))
    for b in sc["bodies"]:
        owner = index.get(b["name"], index["rig"])
        start = np.array(sc["bodies"][0]["position"], float)
        local = np.zeros(3) if b["name"] in index else b["position"] - start
        put(owner, b["name"], local, np.eye(3))
    for name, (first, n) in springs.items():
        for k in range(n - 1):
            bodies[f"{name}/{k + 1}"] = {"p": st.point(st.springs[first + k][1]).tolist()}
    file.write_text(json.dumps({"version": 1, "scene": sc["name"], "bodies": bodies}, indent=1))


def turn_of(q):
    w, v = q[0], np.array(q[1:])
    k = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.eye(3) + 2 * w * k + 2 * k @ k
