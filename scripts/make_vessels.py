#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write the library of vessels: scenes/parts/vessel_*.json and .obj, and two scenes that use it.

Hulls are closed surfaces of triangles. Their fullness is solved for the displacement and its centre.
Coefficients and sources: docs/vessel_ahts.md, vessel_tug.md, vessel_semi.md, vessel_barge.md.

    scripts/make_vessels.py           write the files
    scripts/make_vessels.py --figures print hydrostatics of the meshes
"""
import json
import math
import pathlib
import sys

SCENES = pathlib.Path(__file__).resolve().parent.parent / "scenes"
RHO, G = 1025.0, 9.81


class Mesh:
    """Triangles, counterclockwise seen from outside."""

    def __init__(self):
        self.vertices, self.triangles = [], []

    def add_box(self, shape, cells):
        """Add the surface of a cube of cells, mapped by shape(a, b, c) of numbers from 0 to 1."""
        base, known, first = len(self.vertices), {}, len(self.triangles)

        def vertex(i, j, k):
            if (i, j, k) not in known:
                known[i, j, k] = len(self.vertices)
                self.vertices.append(tuple(round(v, 4) for v in shape(
                    *(n / m for n, m in zip((i, j, k), cells)))))
            return known[i, j, k]

        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (0, cells[axis]):
                for p in range(cells[u]):
                    for q in range(cells[v]):
                        corner = []
                        for dp, dq in ((0, 0), (1, 0), (1, 1), (0, 1)):
                            at = [0, 0, 0]
                            at[axis], at[u], at[v] = side, p + dp, q + dq
                            corner.append(vertex(*at))
                        # Diagonals to starboard mirror those to port.
                        middle = {0: p, 1: side, 2: q}[axis]
                        if 2 * middle < cells[1]:
                            corner = corner[1:] + corner[:1]
                        if side == 0:
                            corner.reverse()
                        self.triangles += [(corner[0], corner[1], corner[2]),
                                           (corner[0], corner[2], corner[3])]
        assert len(self.vertices) > base and len(self.triangles) > first

    def check(self):
        """Each edge belongs to two triangles, once in each direction; the volume is positive."""
        edges = set()
        for a, b, c in self.triangles:
            for edge in ((a, b), (b, c), (c, a)):
                assert edge not in edges, f"edge {edge} twice"
                edges.add(edge)
        assert all((b, a) in edges for a, b in edges), "open edge"

    def hydrostatics(self):
        """Volume, centre and waterplane of the part below z = 0, where the mesh has a row of
        vertices. Midpoints of edges integrate polynomials of second order exactly."""
        v = x = z = a = lx = ty = tx = 0.0
        for t in self.triangles:
            p = [self.vertices[i] for i in t]
            if max(q[2] for q in p) > 1e-9:
                continue
            u = [p[1][i] - p[0][i] for i in range(3)]
            w = [p[2][i] - p[0][i] for i in range(3)]
            n = 0.5 * (u[0] * w[1] - u[1] * w[0])  # area times n_z
            for i, j in ((0, 1), (1, 2), (2, 0)):
                m = [0.5 * (p[i][k] + p[j][k]) for k in range(3)]
                v += n * m[2] / 3.0
                x += n * m[0] * m[2] / 3.0
                z += n * m[2] ** 2 / 6.0
                a -= n / 3.0
                lx -= n * m[0] / 3.0
                ty -= n * m[1] ** 2 / 3.0
                tx -= n * m[0] ** 2 / 3.0
        lcf = lx / a
        return {"volume": v, "lcb": x / v, "kb_z": z / v, "plane": a, "lcf": lcf,
                "bm_t": ty / v, "bm_l": (tx - a * lcf ** 2) / v}

    def write(self, name, text):
        self.check()
        lines = [f"# {text}", "# Written by scripts/make_vessels.py; origin amidships at the "
                 "design waterline, x ahead, z up."]
        lines += ["v " + " ".join(f"{c:g}" for c in p) for p in self.vertices]
        lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in self.triangles]
        (SCENES / "parts" / name).write_text("\n".join(lines) + "\n")


def ship_mesh(length, beam, draught, freeboard, forecastle, plane, fullness, cells=(28, 6, 8)):
    """A ship: half-breadth B/2 w(ξ) t^p with t from 0 at the keel to 1 at the waterline.
    plane: (stern, stern power, bow power) of w; fullness: p amidships and its slope along ξ."""
    below = round(cells[2] * 0.625)
    stern, stern_power, bow_power = plane

    def width(xi):
        if xi < 0.0:
            return 1.0 - stern * (-xi) ** stern_power
        return 1.0 - 0.97 * xi ** bow_power

    def shape(a, b, c):
        xi = 2.0 * a - 1.0
        row = c * cells[2]
        half = 0.5 * beam * width(xi)
        if row <= below:
            t = (row / below) ** 2
            z = draught * (t - 1.0)
            half *= max(0.08, t) ** max(0.02, fullness[0] + fullness[1] * xi)
        else:
            top = freeboard + (forecastle if xi > 0.55 else 0.0)
            z = top * (row - below) / (cells[2] - below)
        return 0.5 * length * xi, (2.0 * b - 1.0) * half, z

    mesh = Mesh()
    mesh.add_box(shape, cells)
    return mesh


def solve_ship(volume, lcb, plane_area, **form):
    """Find bow power for the waterplane, then fullness for displacement and its centre."""
    stern, stern_power = form.pop("stern")
    bow, p = 2.0, [0.3, 0.1]

    def at(bow, p):
        return ship_mesh(plane=(stern, stern_power, bow), fullness=p, **form)

    for _ in range(40):
        h = at(bow, p).hydrostatics()
        step = 1e-3
        slope = (at(bow + step, p).hydrostatics()["plane"] - h["plane"]) / step
        bow += (plane_area - h["plane"]) / slope
        h = at(bow, p).hydrostatics()
        e = [volume - h["volume"], volume * lcb - h["volume"] * h["lcb"]]
        j = []
        for i in range(2):
            q = list(p)
            q[i] += step
            k = at(bow, q).hydrostatics()
            j.append([(k["volume"] - h["volume"]) / step,
                      (k["volume"] * k["lcb"] - h["volume"] * h["lcb"]) / step])
        d = j[0][0] * j[1][1] - j[1][0] * j[0][1]
        p[0] += (e[0] * j[1][1] - j[1][0] * e[1]) / d
        p[1] += (j[0][0] * e[1] - e[0] * j[0][1]) / d
    mesh = at(bow, p)
    h = mesh.hydrostatics()
    assert abs(h["volume"] / volume - 1.0) < 1e-4 and abs(h["lcb"] - lcb) < 1e-3, h
    return mesh


def strip_estimates(mass, length, beam, draught, volume, inertia):
    """Added mass by simple estimates: surge by H. Söding, sway and yaw of an ellipse's section,
    heave of a half circle's section; roll a fifth of the body's own."""
    sway = 0.5 * math.pi * RHO * draught ** 2 * length
    heave = math.pi / 8.0 * RHO * beam ** 2 * length * 0.8
    return {"surge": 2.7 * RHO * volume ** (5.0 / 3.0) / length ** 2, "sway": sway,
            "yaw": sway * length ** 2 / 14.0, "heave": heave, "roll": 0.2 * inertia[0],
            "pitch": heave * length ** 2 / 16.0}


def damping_of(ratio, mass, stiffness):
    return 2.0 * ratio * math.sqrt(mass * stiffness)


def rounded(x, digits=5):
    if isinstance(x, (list, tuple)):
        return [rounded(v, digits) for v in x]
    if x == 0:
        return 0
    y = float(f"{x:.{digits}g}")
    return int(y) if y == int(y) else y


def vertical(h, mass, added, gm_t, gm_l, ratios):
    """Damping of heave, roll and pitch by ratios of critical damping."""
    weight = RHO * G * h["volume"]
    return [damping_of(ratios[0], mass[0] + added[0], RHO * G * h["plane"]),
            damping_of(ratios[1], mass[1] + added[1], weight * gm_t),
            damping_of(ratios[2], mass[2] + added[2], weight * gm_l)]


def part(name, description, template):
    text = {"version": 1, "templates": {name: {"description": description, **template}}}
    (SCENES / "parts" / f"{name}.json").write_text(dump(text) + "\n")


def dump(value, depth=0):
    """Return JSON with short lists on one line."""
    line = json.dumps(value, ensure_ascii=False)
    if len(line) + depth <= 100:
        return line
    pad, end = " " * (depth + 1), " " * depth
    if isinstance(value, dict):
        inner = ",\n".join(f"{pad}{json.dumps(k)}: {dump(v, depth + 1)}" for k, v in value.items())
        return "{\n" + inner + "\n" + end + "}"
    if isinstance(value, list):
        inner = ",\n".join(pad + dump(v, depth + 1) for v in value)
        return "[\n" + inner + "\n" + end + "]"
    return line


def hull(body, file, centre, added, damping, wind=None):
    entry = {"body": body, "mesh": f"parts/{file}",
             "offset": rounded([-c for c in centre]),
             "added_mass": rounded([0, 0, *added, 0]), "damping": rounded([0, 0, *damping, 0])}
    if wind:
        entry["wind_area"] = wind
    return entry


def figures(name, h, zg, draught):
    print(f"{name}: volume {h['volume']:.1f} m3, LCB {h['lcb']:.3f} m, KB {draught + h['kb_z']:.3f} m, "
          f"waterplane {h['plane']:.1f} m2, LCF {h['lcf']:.3f} m, BM {h['bm_t']:.3f} m, "
          f"GM {h['kb_z'] + h['bm_t'] - zg:.3f} m, GM_L {h['kb_z'] + h['bm_l'] - zg:.2f} m")


def ahts():
    """Anchor handler on the data of T. I. Fossen's supply vessel (MSS, osv.m)."""
    mass, volume, centre = 4976887.5, 4855.5, (-4.5, 0.0, 1.2)
    mesh = solve_ship(volume, centre[0], 1195.2, length=83.0, beam=18.0, draught=5.0, freeboard=3.0,
                      forecastle=5.0, stern=(0.18, 4.0))
    mesh.write("vessel_ahts.obj", "Hull of the anchor handler, 83 m.")
    h = mesh.hydrostatics()
    figures("ahts", h, centre[2], 5.0)
    inertia = [mass * 6.3 ** 2, mass * 20.75 ** 2, mass * 20.75 ** 2]
    added = [8.3e6, 7.48e7, 3.9875e9]
    damping = [5.05272e6, 5.03691e7, 3.63222e9]
    screw = {"propeller": {"series": "ka4_70", "diameter": 3.6, "pitch": 1.2}, "most_rps": 2.5,
             "wake": 0.1, "thrust_deduction": 0.1, "shaft_inertia": 14800, "most_power": 3.5e6,
             "controllable": True, "pitch_time": 12, "ventilates": True}
    at = lambda x, y, z: rounded([x - centre[0], y, z - centre[2]])
    tunnel = lambda name, x, thrust: {"name": name, "kind": "tunnel", "point": at(x, 0, -3.2),
                                      "thrust": thrust, "ramp": 4, "lost_at": 5}
    rudder = lambda name, y, behind: {"name": name, "point": at(-40.2, y, -3.1), "area": 8.5,
                                      "aspect": 1.4, "behind": behind, "hull_increase": 0.2,
                                      "wake": 0.1, "most_angle_deg": 45, "rate_deg": 4}
    boards = [{"name": side, "generators": [{"name": f"{side}_{i}", "power": 3.5e6}
                                            for i in (1, 2)]} for side in ("board_a", "board_b")]
    consumer = lambda name, board, priority, **more: {"name": name, "board": board,
                                                      "priority": priority, **more}
    vessel = {
        "name": "ship", "body": "hull", "origin": rounded([-c for c in centre]), "draught": 5,
        "added_mass": [[6e5, 0, 0, 0, 0, 0], [0, 2e6, 0, 0, 0, -9.1e6], [0] * 6, [0] * 6, [0] * 6,
                       [0, -9.1e6, 0, 0, 0, 1.2416e9]],
        "coriolis": "planar", "damping": [0, 6.97689e4, 0, 0, 0, 1.74e8],
        "resistance": {"linear": 55362, "quadratic": 18131.22},
        "cross_flow": {"length": 83, "beam": 18, "draught": 5},
        "polynomial": {"length": 83, "area": 415, "y": {"v": -0.32, "r": 0.07},
                       "n": {"v": -0.07, "r": -0.07}},
        "wind": {"ship": "offshore_supply", "frontal_area": 230, "lateral_area": 480, "length": 83,
                 "centre": 8, "height": 5},
        "propulsors": [{"name": "port", "point": at(-37.5, 4.5, -3.1), **screw},
                       {"name": "starboard", "point": at(-37.5, -4.5, -3.1), **screw},
                       tunnel("bow1", 37, 3e5), tunnel("bow2", 35, 3e5), tunnel("stern", -33, 1.5e5),
                       {"name": "azimuth", "kind": "azimuth", "point": at(30, 0, -6.5),
                        "thrust": 2e5, "diameter": 2, "astern": 0.7, "ramp": 4,
                        "turn_rate_deg": 12}],
        "rudders": [rudder("rudder_port", 4.5, "port"), rudder("rudder_starboard", -4.5, "starboard")],
        "thruster_losses": True,
        "control": {"mode": "off", "failures": [
            {"name": "board_a", "propulsors": ["port", "bow1", "stern"]},
            {"name": "board_b", "propulsors": ["starboard", "bow2", "azimuth"]}]},
        "power": {"boards": boards, "consumers": [
            consumer("hotel_a", "board_a", 1, power=4e5), consumer("hotel_b", "board_b", 1, power=4e5),
            consumer("bow1", "board_a", 2, power=2.54e6), consumer("bow2", "board_b", 2, power=2.54e6),
            consumer("azimuth", "board_b", 2, power=1.01e6),
            consumer("stern", "board_a", 3, power=9.8e5),
            consumer("port", "board_a", 3), consumer("starboard", "board_b", 3)]}}
    part("vessel_ahts", "Anchor handler of 83 m. Frame: the hull's centre of mass, 1.2 m above the "
         "water, x ahead. The sea of the scene needs its hull: docs/vessel_ahts.md.",
         {"parameters": {"speed": 0},
          "bodies": [{"name": "hull", "mass": mass, "inertia": rounded(inertia),
                      "half_size": [41.5, 9, 4], "velocity": ["${speed}", 0, 0]}],
          "vessels": [vessel]})
    return hull("NAME/hull", "vessel_ahts.obj", centre, added, damping)


def tug():
    """Harbour tug with two azimuth thrusters astern."""
    length, beam, draught, volume, centre = 32.0, 11.6, 4.3, 800.0, (-0.6, 0.0, 0.35)
    mass = RHO * volume
    mesh = solve_ship(volume, centre[0], 300.0, length=length, beam=beam, draught=draught,
                      freeboard=1.6, forecastle=1.4, stern=(0.3, 3.0), cells=(20, 6, 8))
    mesh.write("vessel_tug.obj", "Hull of the tug, 32 m.")
    h = mesh.hydrostatics()
    figures("tug", h, centre[2], draught)
    inertia = [mass * (0.35 * beam) ** 2, mass * (0.25 * length) ** 2, mass * (0.25 * length) ** 2]
    e = strip_estimates(mass, length, beam, draught, volume, inertia)
    added = [e["heave"], e["roll"], e["pitch"]]
    damping = vertical(h, [mass, *inertia[:2]], added, h["kb_z"] + h["bm_t"] - centre[2],
                       h["kb_z"] + h["bm_l"] - centre[2], (0.25, 0.08, 0.25))
    at = lambda x, y, z: rounded([x - centre[0], y, z - centre[2]])
    drive = lambda name, y: {
        "name": name, "kind": "azimuth", "point": at(-11.5, y, -4.6),
        "propeller": {"series": "ka4_70", "diameter": 2.6, "pitch": 1.0}, "most_rps": 4.2,
        "wake": 0.05, "thrust_deduction": 0.05, "shaft_inertia": 2900, "most_power": 1.9e6,
        "turn_rate_deg": 12, "ventilates": True, "hull_loss": 0.03}
    vessel = {
        "name": "ship", "body": "hull", "origin": rounded([-c for c in centre]), "draught": draught,
        "added_mass": rounded([e["surge"], e["sway"], 0, 0, 0, e["yaw"]]), "coriolis": "planar",
        "damping": rounded([0, 0.02 * (mass + e["sway"]), 0, 0, 0, 0.05 * (inertia[2] + e["yaw"])]),
        "resistance": {"curve": [[0, 0], [3, 2e4], [5, 7.5e4], [6, 1.5e5], [6.7, 3e5], [7.5, 7e5]]},
        "cross_flow": {"length": length, "beam": beam, "draught": draught},
        "polynomial": {"length": length, "area": rounded(length * draught),
                       "y": {"v": -0.45, "r": 0.08}, "n": {"v": -0.05, "r": -0.09}},
        "wind": {"ship": "tender", "frontal_area": 75, "lateral_area": 150, "length": length,
                 "centre": 2, "height": 3},
        "propulsors": [drive("port", 2.9), drive("starboard", -2.9)], "thruster_losses": True,
        "control": {"mode": "off"}}
    part("vessel_tug", "Tug of 32 m with two azimuth thrusters astern, 70 t of bollard pull. Frame: "
         "the hull's centre of mass, 0.35 m above the water, x ahead. The sea of the scene needs "
         "its hull: docs/vessel_tug.md.",
         {"parameters": {"speed": 0},
          "bodies": [{"name": "hull", "mass": mass, "inertia": rounded(inertia),
                      "half_size": [16, 5.8, 3], "velocity": ["${speed}", 0, 0]}],
          "vessels": [vessel]})
    return hull("NAME/hull", "vessel_tug.obj", centre, added, damping)


def barge():
    """Cargo barge of 300 feet with raked ends and two skegs."""
    length, beam, draught, depth, centre = 91.4, 27.4, 4.0, 6.1, (0.0, 0.0, 1.5)
    levels = [-draught, -2.7, -1.35, 0.0, depth - draught]

    def shape(a, b, c):
        z = levels[round(c * 4)]
        half = 0.5 * length - 7.0 * max(0.0, -z) / draught
        return (2.0 * a - 1.0) * half, (b - 0.5) * beam, z

    mesh = Mesh()
    mesh.add_box(shape, (20, 6, 4))
    mesh.write("vessel_barge.obj", "Hull of the barge, 91.4 m.")
    h = mesh.hydrostatics()
    figures("barge", h, centre[2], draught)
    mass = RHO * h["volume"]
    inertia = [mass * (0.35 * beam) ** 2, mass * (0.26 * length) ** 2, mass * (0.26 * length) ** 2]
    e = strip_estimates(mass, length, beam, draught, h["volume"], inertia)
    added = [e["heave"], e["roll"], e["pitch"]]
    damping = vertical(h, [mass, *inertia[:2]], added, h["kb_z"] + h["bm_t"] - centre[2],
                       h["kb_z"] + h["bm_l"] - centre[2], (0.3, 0.1, 0.3))
    wall = 0.5 * RHO * beam * draught
    vessel = {
        "name": "ship", "body": "hull", "origin": rounded([-c for c in centre]), "draught": draught,
        "added_mass": rounded([e["surge"], e["sway"], 0, 0, 0, e["yaw"]]), "coriolis": "planar",
        "damping": rounded([0, 0.01 * (mass + e["sway"]), 0, 0, 0, 0.03 * (inertia[2] + e["yaw"])]),
        "resistance": {"linear": 0, "quadratic": rounded(0.3 * wall)},
        "cross_flow": {"length": length, "beam": beam, "draught": draught},
        "polynomial": {"length": length, "area": rounded(length * draught),
                       "y": {"v": -0.35, "r": 0.03}, "n": {"v": 0.0, "r": -0.07}},
        "wind": {"ship": "cargo", "frontal_area": 60, "lateral_area": 195, "length": length,
                 "height": 1.1}}
    part("vessel_barge", "Cargo barge of 91.4 m, without propulsion. Frame: the hull's centre of "
         "mass, 1.5 m above the water, x ahead. The sea of the scene needs its hull: "
         "docs/vessel_barge.md.",
         {"parameters": {"speed": 0},
          "bodies": [{"name": "hull", "mass": rounded(mass, 8), "inertia": rounded(inertia),
                      "half_size": [45.7, 13.7, 3.05], "velocity": ["${speed}", 0, 0]}],
          "vessels": [vessel]})
    return hull("NAME/hull", "vessel_barge.obj", centre, added, damping)


def semi():
    """Semi-submersible of two pontoons and four columns on eight lines of chain."""
    draught, deck, pontoon, column = 18.0, 12.0, (90.0, 14.0, 8.0), 12.0
    px, py, centre = 32.0, 30.0, (0.0, 0.0, 3.0)
    mesh = Mesh()
    for side in (-1, 1):
        y = side * py
        mesh.add_box(lambda a, b, c, y=y: (pontoon[0] * (a - 0.5), y + pontoon[1] * (b - 0.5),
                                           -draught + pontoon[2] * c), (12, 2, 2))
        for x in (-px, px):
            levels = [-draught + pontoon[2], -5.0, 0.0, 0.5 * deck, deck]
            mesh.add_box(lambda a, b, c, x=x, y=y: (x + column * (a - 0.5), y + column * (b - 0.5),
                                                    levels[round(4 * c)]), (2, 2, 4))
    mesh.write("vessel_semi.obj", "Pontoons and columns of the semi-submersible.")
    h = mesh.hydrostatics()
    figures("semi", h, centre[2], draught)
    mass = RHO * h["volume"] - SEMI_LINES / G
    inertia = [mass * 30.0 ** 2, mass * 31.0 ** 2, mass * 36.0 ** 2]
    wet = RHO * 2.0 * pontoon[0] * pontoon[1] * pontoon[2]
    added = [1.0 * wet, 1.0 * wet * py ** 2, 1.0 * wet * pontoon[0] ** 2 / 12.0]
    damping = vertical(h, [mass, *inertia[:2]], added, h["kb_z"] + h["bm_t"] - centre[2],
                       h["kb_z"] + h["bm_l"] - centre[2], (0.05, 0.05, 0.05))
    # Drag areas: columns 1.3 with a shielding of 0.8, pontoons 0.9 along and 1.0 across, 0.75.
    shafts = 4.0 * column * (draught - pontoon[2]) * 1.3 * 0.8
    along = shafts + 2.0 * pontoon[1] * pontoon[2] * 0.9
    across = shafts + 2.0 * pontoon[0] * pontoon[2] * 0.75
    scale = pontoon[0] * draught
    points = [[d, *rounded([-along / scale * math.cos(math.radians(d)),
                            -across / scale * math.sin(math.radians(d)),
                            -0.02 * math.sin(math.radians(2 * d))], 4)] for d in range(0, 181, 15)]
    sway = 0.9 * wet + 4.0 * RHO * column ** 2 * (draught - pontoon[2])
    vessel = {
        "name": "rig", "body": "hull", "origin": rounded([-c for c in centre]), "draught": draught,
        "added_mass": rounded([0.15 * wet + 4.0 * RHO * column ** 2 * (draught - pontoon[2]), sway,
                               0, 0, 0, 1.0 * wet * 30.0 ** 2]), "coriolis": "none",
        "damping": rounded([0.02 * mass * 0.06, 0.02 * mass * 0.06, 0, 0, 0, 0.05 * inertia[2] * 0.1]),
        "current": {"length": pontoon[0], "draught": draught, "points": points},
        "wind": {"ship": "drilling", "frontal_area": 1700, "lateral_area": 1900, "length": 90,
                 "height": 22}}
    lines = []
    for i, angle in enumerate((30, 60, 120, 150, 210, 240, 300, 330)):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        x, y = math.copysign(38.0, c), math.copysign(35.0, s)
        lines.append({"name": f"mooring{i + 1}", "line_type": "vessel_chain76",
                      "from": {"body": "hull", "point": rounded([x, y, -10.0 - centre[2]])},
                      "to": {"at": rounded([x + 700 * c, y + 700 * s, -150 - centre[2]])},
                      "length": SEMI_LENGTH, "elements": 48, "shape": "catenary"})
    text = {"version": 1,
            "line_types": {"vessel_chain76": {
                "description": "Stud link chain 76 mm, R4", "mass_per_length": 126.5,
                "EA": 583000000, "EI": 10000, "diameter": 0.137, "breaking_load": 6000000,
                "axial_damping": 0.1,
                "cd_normal": 2.6, "cd_tangential": 1.4, "color": "#4a4e57"}},
            "templates": {"vessel_semi": {
                "description": "Semi-submersible on eight lines of chain in 150 m of water. Frame: "
                "the hull's centre of mass, 3 m above the water. The sea of the scene needs its "
                "hull: docs/vessel_semi.md.",
                "bodies": [{"name": "hull", "mass": rounded(mass, 8), "inertia": rounded(inertia),
                            "half_size": [45, 37, 15]}],
                "vessels": [vessel], "cables": lines}}}
    (SCENES / "parts" / "vessel_semi.json").write_text(dump(text) + "\n")
    return hull("NAME/hull", "vessel_semi.obj", centre, added, damping)


# Vertical pull of the eight lines on the semi-submersible at rest in still water [N], and their
# length [m].
SEMI_LINES, SEMI_LENGTH = 5.02e6, 725.0


def named(entry, name):
    return {**entry, "body": f"{name}/hull"}


def main():
    hulls = {"ahts": ahts(), "tug": tug(), "semi": semi(), "barge": barge()}
    if "--figures" in sys.argv:
        for name, entry in hulls.items():
            print(name, json.dumps(entry))
    sea = {"depth": 150, "density": RHO,
           "waves": [{"kind": "jonswap", "height": 2.5, "period": 9, "components": 60,
                      "direction_deg": 200, "spreading": 10}],
           "current": [{"depth": 0, "speed": 0.5, "direction_deg": 120},
                       {"depth": 150, "speed": 0.5, "direction_deg": 120}],
           "wind": {"speed": 8, "direction_deg": 150}}
    tow = {"$schema": "../schema/scene-1.json", "version": 2, "name": "tow_barge",
           "description": "An anchor handler tows a barge of 91 m on 500 m of wire in waves of "
           "2.5 m, a current of 0.5 m/s and wind, with fixed orders. Written by "
           "scripts/make_vessels.py; docs/vessel_ahts.md, docs/vessel_barge.md.",
           "include": ["parts/vessel_ahts.json", "parts/vessel_barge.json"],
           "settings": {"step": 0.016666666666666666, "duration": 600},
           "line_types": {"tow76": {
               "description": "Steel wire 6x19 IWRC 76 mm", "mass_per_length": 23, "EA": 233000000,
               "EI": 5000, "diameter": 0.076, "breaking_load": 3658000, "axial_damping": 0.1,
               "cd_normal": 1.2}},
           "instances": [{"template": "vessel_ahts", "name": "ahts", "position": [0, 0, 1.2],
                          "parameters": {"speed": 1.5}},
                         {"template": "vessel_barge", "name": "barge", "position": [-575, 0, 1.5],
                          "parameters": {"speed": 1.5}}],
           "cables": [{"name": "towline", "line_type": "tow76",
                       "from": {"body": "ahts/hull", "point": [-36, 0, 3.3]},
                       "to": {"body": "barge/hull", "point": [45.7, 0, 0.4]}, "length": 495,
                       "elements": 30, "shape": "catenary"}],
           "sea": {**sea, "hulls": [named(hulls["ahts"], "ahts"), named(hulls["barge"], "barge")]},
           "timeline": [
               {"at": 0, "set": {"ahts/ship.port": 0.75, "ahts/ship.starboard": 0.75}},
               {"at": 300, "set": {"ahts/ship.rudder_port": 0.1, "ahts/ship.rudder_starboard": 0.1}},
               {"at": 360, "set": {"ahts/ship.rudder_port": 0, "ahts/ship.rudder_starboard": 0}}],
           "plot": {"tensions": ["towline"], "motions": ["ahts/hull", "barge/hull"]}}
    (SCENES / "tow_barge.json").write_text(dump(tow) + "\n")
    rig = {"$schema": "../schema/scene-1.json", "version": 2, "name": "semi_moored",
           "description": "A semi-submersible on eight lines of chain in waves of 2.5 m, current "
           "and wind; a tug pushes past it. Written by scripts/make_vessels.py; "
           "docs/vessel_semi.md, docs/vessel_tug.md.",
           "include": ["parts/vessel_semi.json", "parts/vessel_tug.json"],
           "settings": {"step": 0.016666666666666666, "duration": 120},
           "instances": [{"template": "vessel_semi", "name": "semi", "position": [0, 0, 3]},
                         {"template": "vessel_tug", "name": "tug", "position": [-150, -90, 0.35]}],
           "sea": {**sea, "hulls": [named(hulls["semi"], "semi"), named(hulls["tug"], "tug")]},
           "timeline": [{"at": 0, "set": {"tug/ship.port": 0.7, "tug/ship.starboard": 0.7}},
                        {"at": 60, "set": {"tug/ship.port_angle": 0.4,
                                           "tug/ship.starboard_angle": 0.4}}],
           "plot": {"tensions": ["semi/mooring1"], "motions": ["semi/hull", "tug/hull"]}}
    (SCENES / "semi_moored.json").write_text(dump(rig) + "\n")


if __name__ == "__main__":
    main()
