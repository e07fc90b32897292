#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write scenes/anchor_sea.json and its hulls: the site of scenes/anchor_lines.json in a sea.

anchor_lines has three linear springs under each hull and linear drag on its lines. This scene has
hulls of 2,000 triangles, Morison's forces on all lines, and anchors in the water. Its waves of 2.5 m
and 9 s have 200 components, its current is 0.8 m/s. Mass of a hull: its displacement at the draught
of anchor_lines, less cranes, drums and the pull of the lines.
"""
import copy
import json
import math
import pathlib

SCENES = pathlib.Path(__file__).resolve().parent.parent / "scenes"
RHO, G = 1025.0, 9.81
SHIP = {"length": 80.0, "breadth": 18.0, "draught": 6.0, "freeboard": 3.0, "plane": 0.85,
        "block": 0.65}
WATER = {"chain76": {"cd_normal": 2.6, "cd_tangential": 1.4}, "wire76": {"cd_normal": 1.8},
         "poly80": {"cd_normal": 1.6}}


class Mesh:
    """Triangles, counterclockwise seen from outside."""

    def __init__(self):
        self.vertices, self.triangles, self.known = [], [], {}

    def vertex(self, part, x, y, z):
        key = (part, round(x, 6), round(y, 6), round(z, 6))
        if key not in self.known:
            self.vertices.append(key[1:])
            self.known[key] = len(self.vertices)
        return self.known[key]

    def quad(self, a, b, c, d):
        self.triangles += [(a, b, c), (a, c, d)]

    def write(self, name, what):
        lines = [f"# {what}", "# Written by scripts/make_anchor_sea.py; origin amidships at the waterline."]
        lines += ["v {:.6g} {:.6g} {:.6g}".format(*v) for v in self.vertices]
        lines += ["f {} {} {}".format(*t) for t in self.triangles]
        (SCENES / "parts" / name).write_text("\n".join(lines) + "\n")

    def volume(self, top=0.0):
        """Return the volume below z = top, by columns; no triangle may cross z = top."""
        sum_ = 0.0
        for t in self.triangles:
            a, b, c = (self.vertices[i - 1] for i in t)
            if max(a[2], b[2], c[2]) > top + 1e-9:
                continue
            nz = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
            sum_ -= nz * (top - (a[2] + b[2] + c[2]) / 3.0)
        return sum_


def box(mesh, part, centre, half, pieces):
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (-1, 1):
            for i in range(pieces[u]):
                for j in range(pieces[v]):
                    def at(di, dj):
                        p = [0.0, 0.0, 0.0]
                        p[axis] = centre[axis] + side * half[axis]
                        p[u] = centre[u] + half[u] * (2.0 * (i + di) / pieces[u] - 1.0)
                        p[v] = centre[v] + half[v] * (2.0 * (j + dj) / pieces[v] - 1.0)
                        return mesh.vertex(part, *p)
                    q = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)]
                    mesh.quad(*(q if side > 0 else [q[0], q[3], q[2], q[1]]))


def column(mesh, part, x, y, radius, levels, sides):
    rings = [[mesh.vertex(part, x + radius * math.cos(2 * math.pi * k / sides),
                          y + radius * math.sin(2 * math.pi * k / sides), z)
              for k in range(sides)] for z in levels]
    for low, high in zip(rings, rings[1:]):
        for k in range(sides):
            n = (k + 1) % sides
            mesh.quad(low[k], low[n], high[n], high[k])
    bottom, top = mesh.vertex(part, x, y, levels[0]), mesh.vertex(part, x, y, levels[-1])
    for k in range(sides):
        n = (k + 1) % sides
        mesh.triangles += [(bottom, rings[0][n], rings[0][k]), (top, rings[-1][k], rings[-1][n])]


def rig():
    """Pontoons of 80 x 15 x 8.5 m, columns of 13 m, draught 21 m, deck at 13 m."""
    mesh = Mesh()
    for side in (-1, 1):
        box(mesh, f"p{side}", (0.0, 29.0 * side, -21.0 + 4.25), (40.0, 7.5, 4.25), (16, 5, 2))
    # A polygon with the area of the circle.
    sides = 32
    radius = 6.5 * math.sqrt(2 * math.pi / sides / math.sin(2 * math.pi / sides))
    for x in (-30.0, 30.0):
        for y in (-29.0, 29.0):
            column(mesh, f"c{x}{y}", x, y, radius, [-12.5, -4.0, 4.5, 13.0], sides)
    return mesh


def ship():
    """Sections y = b (1 - d^k) below the waterline, walls above; b = B/2 (1 - |2x/L|^m)."""
    mesh = Mesh()
    m = SHIP["plane"] / (1.0 - SHIP["plane"])
    area = SHIP["block"] / SHIP["plane"]
    k = area / (1.0 - area)
    stations, girth = 50, 9
    rings = []
    for i in range(stations):
        x = -0.5 * SHIP["length"] * math.cos(math.pi * i / (stations - 1))
        b = max(0.5 * SHIP["breadth"] * (1.0 - abs(2.0 * x / SHIP["length"]) ** m), 0.05)
        half = [(b, SHIP["freeboard"])]
        for j in range(girth):
            d = math.sin(0.5 * math.pi * j / girth)
            half.append((b * (1.0 - d**k), -SHIP["draught"] * d))
        ring = half + [(0.0, -SHIP["draught"])] + [(-y, z) for y, z in reversed(half)]
        ring = ring[:20]  # without the last of 10 + 1 + 10: see below
        rings.append([(x, y, z) for y, z in ring])
    # 20 corners per ring: port side 10, keel 1, starboard 9 with the deck's edge.
    for i, ring in enumerate(rings):
        ring[19] = (ring[0][0], -ring[0][1], ring[0][2])
        rings[i] = [mesh.vertex("s", *p) for p in ring]
    n = 20
    for one, two in zip(rings, rings[1:]):
        for j in range(n):
            mesh.quad(one[j], one[(j + 1) % n], two[(j + 1) % n], two[j])
    for ring, end in ((rings[0], 0), (rings[-1], 1)):
        x = mesh.vertices[ring[0] - 1][0]
        middle = mesh.vertex("e", x, 0.0, -1.0)
        for j in range(n):
            a, b = ring[j], ring[(j + 1) % n]
            mesh.triangles.append((middle, a, b) if end else (middle, b, a))
    # Orientation by the sign of the volume.
    total = 0.0
    for t in mesh.triangles:
        a, b, c = (mesh.vertices[i - 1] for i in t)
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                  + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6.0
    if total < 0.0:
        mesh.triangles = [(a, c, b) for a, b, c in mesh.triangles]
    return mesh


def in_water(types):
    out = {}
    for name, water in WATER.items():
        line = copy.deepcopy(types[name])
        share = 1.0 - line.pop("submerged_factor")
        line.pop("drag")
        line["displaced_area"] = round(share * line["mass_per_length"] / RHO, 8)
        if name == "chain76":
            line["diameter"] = 0.076
        line.update(water)
        line["description"] += ", Morison"
        out[name + "_sea"] = line
    return out


def spring_force(water, at):
    return water["heave_stiffness"] * (water["rest_height"] - at)


def afloat(body, water, volume, at):
    """Replace the springs of a hull by its own mass."""
    body.pop("gravity")
    body["mass"] = round(RHO * volume - spring_force(water, at) / G)


def main():
    source = json.loads((SCENES / "anchor_lines.json").read_text())
    types = json.loads((SCENES / "parts" / "lines.json").read_text())["line_types"]
    handler = json.loads((SCENES / "parts" / "ahts.json").read_text())["templates"]["ahts"]
    meshes = {"anchor_sea_rig.obj": rig(), "anchor_sea_ahts.obj": ship()}
    for name, mesh in meshes.items():
        assert len(mesh.triangles) == 2000, (name, len(mesh.triangles))
        mesh.write(name, "hull of scenes/anchor_sea.json")
    volume = {"rig": 2 * 80 * 15 * 8.5 + 4 * math.pi * 6.5**2 * 12.5,
              "ahts": meshes["anchor_sea_ahts.obj"].volume()}
    scene = copy.deepcopy(source)
    scene["name"] = "anchor_sea"
    scene["description"] = (
        "The site of anchor_lines in waves of 2.5 m and 9 s and a current of 0.8 m/s: three hulls of "
        "2,000 triangles, Morison's forces on all lines and anchors. Written by "
        "scripts/make_anchor_sea.py; see docs/sea.md.")
    scene["include"] = ["parts/lines.json", "parts/crane.json", "parts/windlass.json"]
    scene["line_types"] = in_water(types)
    springs = {}
    ahts = copy.deepcopy(handler)
    springs["ahts"] = ahts["interactions"].pop(0)
    afloat(ahts["bodies"][0], springs["ahts"], volume["ahts"], 1.0)
    scene["templates"] = {"ahts_sea": ahts}
    springs["rig"] = scene["interactions"].pop(0)
    afloat(scene["bodies"][0], springs["rig"], volume["rig"], -1.0)
    bodies = []
    for body in scene["bodies"]:
        if body["name"].startswith("anchor"):
            bodies.append({"body": body["name"], "volume": round(body.pop("force")[2] / RHO / G, 4),
                           "drag_area": [6.0, 6.0, 9.0], "added_mass": 1.0, "height": 1.6})
            body.pop("linear_damping")
    for instance in scene["instances"]:
        if instance["template"] == "ahts":
            instance["template"] = "ahts_sea"
    for cable in scene["cables"] + scene["repeat"]["joins"]:
        if cable["line_type"] + "_sea" in scene["line_types"]:
            cable["line_type"] += "_sea"

    def hull(body, mesh, height, water, mass, area):
        return {"body": body, "mesh": f"parts/{mesh}", "offset": [0, 0, -height],
                "added_mass": [round(share * mass) for share in area["added"]] + [0, 0, 0],
                "damping": [0, 0, water["heave_damping"], water["roll_damping"],
                            water["pitch_damping"], 0],
                "strips": area["strips"], "drag_area": area["drag"], "wind_area": area["wind"]}
    of_rig = {"added": [0.5, 0.8, 1.0], "drag": [900, 0, 0], "wind": [1500, 1500, 0],
              "strips": [{"from": [-40, y, -16], "to": [40, y, -16], "drag_area": 900, "count": 8}
                         for y in (-29, 29)]}
    of_ship = {"added": [0.05, 0.8, 1.0], "drag": [20, 0, 0], "wind": [250, 700, 0],
               "strips": [{"from": [-40, 0, -4], "to": [40, 0, -4], "drag_area": 480, "count": 16}]}
    rig_mass, ship_mass = RHO * volume["rig"], RHO * volume["ahts"]
    scene["sea"] = {
        "depth": 150, "density": RHO,
        "waves": [{"kind": "jonswap", "height": 2.5, "period": 9, "components": 200,
                   "direction_deg": 30, "spreading": 10}],
        "current": [{"depth": 0, "speed": 0.8, "direction_deg": 20},
                    {"depth": 150, "speed": 0.8, "direction_deg": 20}],
        "bodies": bodies,
        "hulls": [hull("rig", "anchor_sea_rig.obj", -1.0, springs["rig"], rig_mass, of_rig)] +
                 [hull(f"ahts{k}/hull", "anchor_sea_ahts.obj", 1.0, springs["ahts"], ship_mass,
                       of_ship) for k in (1, 2)]}
    (SCENES / "anchor_sea.json").write_text(json.dumps(scene, indent=1) + "\n")
    print("rig", volume["rig"], "ship", volume["ahts"],
          {b["name"]: b["mass"] for b in scene["bodies"]}, ahts["bodies"][0]["mass"])


if __name__ == "__main__":
    main()
