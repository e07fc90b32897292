# SPDX-License-Identifier: Apache-2.0
"""Scenes of contact and friction with closed forms (docs/validation.md)."""

import math

from scene_writer import rotation, write

STEP, G = 1 / 60, 9.81
GROUND = {"name": "ground", "kind": "fixed", "shapes": [{"kind": "plane"}]}


def rock(stiffness, friction, **more):
    """Return the contact material of a scene: `stiffness` [N/m] of one point."""
    return {"material_pairs": [{"between": ["default", "default"], "friction": friction,
                                "stiffness": stiffness, **more}]}


def solid_box(name, position, half, mass, **more):
    return {"name": name, "position": position, "mass": mass, "box": half,
            "shapes": [{"kind": "box", "half_size": half}], **more}


def incline(name, text, slope, friction, duration):
    """Eight boxes on eight slopes that fall towards headings 45° apart. Each slope is turned
    about a horizontal axis, so that world and box see the heading under different angles."""
    mass, half, k = 1000.0, (0.5, 0.5, 0.25), 1e7
    angle = math.atan(slope)
    depth = mass * G * math.cos(angle) / (4 * k)
    bodies = []
    for i in range(8):
        fall = math.radians(45 * i)
        axis = (-math.sin(fall), math.cos(fall), 0.0)
        up = (math.sin(angle) * math.cos(fall), math.sin(angle) * math.sin(fall), math.cos(angle))
        foot, turn = (10.0 * i, 0.0, 0.0), rotation(axis, angle)
        bodies.append({"name": f"slope{i}", "kind": "fixed", "position": foot, "orientation": turn,
                       "shapes": [{"kind": "plane", "groups": f"slope{i}"}]})
        box = solid_box(f"box{i}", [f + (half[2] - depth) * u for f, u in zip(foot, up)], half,
                        mass, orientation=turn)
        box["shapes"][0] |= {"groups": "boxes", "touches": f"slope{i}"}
        bodies.append(box)
    write({"name": name, "description": text, "settings": {"step": STEP, "duration": duration},
           **rock(k, friction), "bodies": bodies, "plot": {"motions": ["box0", "box1"]}})


def inclines():
    incline("incline", "Eight boxes on slopes of eight headings at 95 % of the slope at which "
            "they would slide: they stay.", 0.95 * 0.5, 0.5, 100)
    incline("incline_slide", "Eight boxes on slopes of eight headings, steeper than friction "
            "holds: they slide with g (sin a - mu cos a).", 0.75, 0.5, 2)


def wall(name, rows, friction, pushed, text):
    """Bricks of 2 t without joints between neighbours of a row. `rows`: (number of bricks, x of
    the first) from below. `pushed`: {(row, brick): (direction, times mu m g)}; a pushed brick has
    drag, so that it moves at about 2 to 10 cm/s."""
    mass, half, pitch, k = 2000.0, (0.75, 0.375, 0.37), 1.6, 1e8 / 0.7
    limit = friction * mass * G
    above, bodies = 0, [GROUND]
    for r, (count, first) in enumerate(rows):
        bodies_above = sum(n for n, _ in rows[r:])  # weight on this row, evenly spread
        depth = bodies_above * mass * G / (8 * count * k)
        above += 2 * half[2] - depth
        for i in range(count):
            brick = solid_box(f"brick{r}_{i}", [first + i * pitch, 0, above - half[2]], half, mass)
            if (r, i) in pushed:
                direction, times = pushed[r, i]
                brick["force"] = [round(times * limit * d, 3) for d in direction]
                brick["linear_damping"] = 5e4
            bodies.append(brick)
    write({"name": name, "description": text,
           "settings": {"step": STEP, "duration": 2, "contact_margin": 0.01},
           **rock(k, friction), "bodies": bodies,
           "plot": {"motions": ["brick0_0", f"brick{len(rows) - 1}_0"]}})


def walls():
    along, across = (1, 0, 0), (0, 1, 0)
    pitch = 1.6
    # A third of a brick from row to row: the brick at an end stands on three quarters of itself.
    rows = [(9, 0.4 * (r % 2)) for r in range(10)]
    push = {(9, i): (along, 1.1) for i in range(9)} | {(8, i): (across, 2.4) for i in (2, 4, 6)}
    wall("wall_648", rows, 0.5, push,
         "90 bricks of 2 t in 10 rows, 648 contact points, friction 0.5. The top row is pushed "
         "along the wall and three bricks below it across, beyond what friction holds.")
    rows = [(10 - r % 2, pitch / 2 * (r % 2)) for r in range(14)]
    push = {(13, i): (along, 1.1) for i in range(9)} | {(12, i): (across, 2.4) for i in (2, 4, 6)}
    wall("wall_976", rows, 0.3, push,
         "133 bricks of 2 t in 14 rows of 10 and 9, 976 contact points, friction 0.3. The top row "
         "is pushed along the wall and three bricks below it across, beyond what friction holds.")


def stack(name, top, stiffness, text):
    boxes = [solid_box(f"box{i}", [0, 0, 0.5 + i], (0.5, 0.5, 0.5), 1.0 if i < 9 else top)
             for i in range(10)]
    write({"name": name, "description": text, "settings": {"step": STEP, "duration": 10},
           **rock(stiffness, 0.5), "bodies": [GROUND, *boxes],
           "plot": {"motions": ["box0", "box9"]}})


def stacks():
    stack("box_stack", 1e3, 1e8, "Nine boxes of 1 kg and 1 m with one of 1,000 kg on top. They "
          "start without penetration; the contacts give 0.25 mm in all.")
    stack("box_stack_1e6", 1e6, 1e11, "box_stack with 1,000,000 kg on top and contacts 1,000 "
          "times as stiff: they give 0.25 mm in all.")


def trapezium(inner, outer, half_angle, depth, density):
    """Return a wedge between two radii: distance of its centre of mass from the centre of the arch.
    Further vertices (z outwards), mass and inertia about its centre of mass. Exact: polygon moments
    by Green's theorem."""
    s, c = math.sin(half_angle), math.cos(half_angle)
    corner = [(-inner * s, inner * c), (inner * s, inner * c), (outer * s, outer * c),
              (-outer * s, outer * c)]
    area = first = xx = zz = 0.0
    for (x0, z0), (x1, z1) in zip(corner, corner[1:] + corner[:1]):
        w = x0 * z1 - x1 * z0
        area += w / 2
        first += w * (z0 + z1) / 6
        xx += w * (x0 * x0 + x0 * x1 + x1 * x1) / 12
        zz += w * (z0 * z0 + z0 * z1 + z1 * z1) / 12
    mean = first / area
    zz -= area * mean * mean
    mass = density * area * depth
    yy = depth * depth / 12
    inertia = [mass * (yy + zz / area), mass * (xx + zz) / area, mass * (yy + xx / area)]
    vertices = [[x, y, z - mean] for y in (-depth / 2, depth / 2) for x, z in corner]
    return mean, vertices, mass, inertia


def arch():
    count, inner, outer, depth = 13, 4.5, 5.7, 1.5
    half = math.pi / (2 * count)
    mean, vertices, mass, inertia = trapezium(inner, outer, half, depth, 2400)
    bodies = [GROUND]
    for i in range(count):
        a = (2 * i + 1) * half - math.pi / 2  # from the vertical, to the right
        bodies.append({"name": f"stone{i}", "position": [mean * math.sin(a), 0, mean * math.cos(a)],
                       "orientation": rotation((0, 1, 0), a), "mass": mass, "inertia": inertia,
                       "half_size": [mean * math.sin(half), depth / 2, (outer - inner) / 2],
                       "shapes": [{"kind": "hull", "vertices": vertices}]})
    write({"name": "arch", "description": "A round arch of 13 stones, 9 m wide inside and 1.2 m "
           "thick (0.235 of the mean radius; it stands from 0.108 on), friction 0.7.",
           "settings": {"step": STEP, "duration": 10, "contact_margin": 0.01},
           **rock(1e9, 0.7), "bodies": bodies, "plot": {"motions": ["stone0", "stone6"]}})


def belt():
    depth = 3 * 100 * G / (4 * 1e6)
    bodies = [{"name": "belt", "kind": "kinematic", "velocity": [2, 0, 0],
               "shapes": [{"kind": "plane"}]},
              solid_box("box", [0, 5, 0.25 - depth / 3], (0.5, 0.5, 0.25), 100.0)]
    bodies += [solid_box(f"stack{i}", [0, 0, 0.25 + 0.5 * i - depth * (1, 5 / 3, 2)[i]],
                         (0.5, 0.5, 0.25), 100.0) for i in range(3)]
    write({"name": "belt", "description": "A box and a stack of three are put at rest on a belt "
           "that runs at 2 m/s. Both reach its speed after v/(mu g) = 0.510 s.",
           "settings": {"step": STEP, "duration": 3},
           **rock(1e6, 0.4), "bodies": bodies, "plot": {"motions": ["box", "stack2"]}})


def wedge():
    """Half angle 10°; its faces lie on the two slopes. Pushed by 5 times its weight, it keeps
    a part of that force after its release, because mu > tan(half angle)."""
    a, height, width, mass = math.radians(10), 1.0, 0.5, 100.0
    bottom, top = 0.1, 0.1 + height * math.tan(a)
    vertices = [[sx * x, sy * width, z] for x, z in ((bottom, -height / 2), (top, height / 2))
                for sx in (-1, 1) for sy in (-1, 1)]
    middle = (bottom + top) / 2  # at half height, where the slopes are placed
    slopes = [{"name": name, "kind": "fixed", "position": [s * middle, 0, 0],
               "shapes": [{"kind": "plane", "normal": [-s * math.cos(a), 0, math.sin(a)]}]}
              for name, s in (("left", -1), ("right", 1))]
    body = {"name": "wedge", "mass": mass, "box": [middle, width, height / 2],
            "shapes": [{"kind": "hull", "vertices": vertices}]}
    write({"name": "wedge", "description": "A wedge of 10 degrees half angle stands in a groove; "
           "friction 0.5 is above tan 10 = 0.176, so that it jams when the input `push` (N, up) "
           "presses it down. Up, push stays below the weight of 981 N: the wedge cannot fly.",
           "settings": {"step": STEP, "duration": 5},
           **rock(1e7, 0.5), "bodies": [*slopes, body],
           "inputs": [{"name": "push", "body": "wedge", "component": "force_z", "min": -1e6,
                       "max": 900}],
           "plot": {"motions": ["wedge"]}})


def painleve():
    """tan(angle) = 2, at which the paradox needs the least friction: 4/3."""
    length, radius, mass = 2.0, 0.01, 1.0
    c, s = 1 / math.sqrt(5), 2 / math.sqrt(5)
    along = mass * length**2 / 12
    k = 1e6
    rod = {"name": "rod", "position": [0, 0, length / 2 * s + radius - mass * G / k],
           "orientation": rotation((0, 1, 0), math.atan2(-s, c)), "velocity": [-1, 0, 0],
           "mass": mass, "inertia": [mass * radius**2 / 2, along, along],
           "half_size": [length / 2, radius, radius],
           "shapes": [{"kind": "capsule", "radius": radius, "length": length}]}
    write({"name": "painleve", "description": "Painleve's rod: 2 m, 1 kg, at an angle of atan 2, "
           "its lower end slides at 1 m/s so that friction turns it into the ground. Friction 1.6 "
           "is above 4/3: the rigid problem has no solution or two.",
           "settings": {"step": 1 / 240, "duration": 1, "contact_margin": 0.003},
           **rock(k, 1.6), "bodies": [GROUND, rod], "plot": {"motions": ["rod"]}})


def spinning_disk():
    radius, thickness, mass, k = 0.5, 0.1, 10.0, 1e6
    depth = mass * G / (4 * k)
    disk = {"mass": mass, "cylinder": {"radius": radius, "length": thickness, "axis": "z"},
            "shapes": [{"kind": "cylinder", "radius": radius, "length": thickness, "axis": "z"}]}
    bodies = [GROUND,
              {"name": "spin", "position": [0, 0, thickness / 2 - depth],
               "angular_velocity": [0, 0, 20], **disk},
              {"name": "both", "position": [0, 3, thickness / 2 - depth], "velocity": [2, 0, 0],
               "angular_velocity": [0, 0, 10], **disk}]
    write({"name": "spinning_disk", "description": "Two disks on the ground, friction 0.2: one "
           "spins, one spins and slides. They rest on points of their rims, so that the first "
           "slows with 2 mu g/R; the second stops sliding and spinning at the same time.",
           "settings": {"step": 1 / 240, "duration": 4},
           **rock(k, 0.2), "bodies": bodies, "plot": {"motions": ["spin", "both"]}})


def rolling_sphere():
    radius, mass, k, v = 0.5, 10.0, 1e6, 7.0
    bodies = [GROUND]
    for i in range(8):
        a = math.radians(45 * i)
        bodies.append({"name": f"ball{i}",
                       "position": [3 * math.cos(a), 3 * math.sin(a), radius - mass * G / k],
                       "velocity": [v * math.cos(a), v * math.sin(a), 0], "mass": mass,
                       "sphere": radius, "shapes": [{"kind": "sphere", "radius": radius}]})
    write({"name": "rolling_sphere", "description": "Eight balls slide away at 7 m/s in headings "
           "45 degrees apart, friction 0.2. They roll from t = 2v/(7 mu g) = 1.019 s on, at 5 m/s.",
           "settings": {"step": 1 / 240, "duration": 2},
           **rock(k, 0.2), "bodies": bodies, "plot": {"motions": ["ball0", "ball1"]}})


def bouncing_ball():
    write({"name": "bouncing_ball", "description": "A ball falls 1 m and bounces with restitution "
           "0.8: to 0.64, 0.4096, ... m.",
           "settings": {"step": 1 / 240, "duration": 4},
           **rock(1e7, 0.3, restitution=0.8),
           "bodies": [GROUND, {"name": "ball", "position": [0, 0, 1.1], "mass": 1, "sphere": 0.1,
                               "shapes": [{"kind": "sphere", "radius": 0.1}]}],
           "plot": {"motions": ["ball"]}})


def main():
    inclines()
    walls()
    stacks()
    arch()
    belt()
    wedge()
    painleve()
    spinning_disk()
    rolling_sphere()
    bouncing_ball()


if __name__ == "__main__":
    main()
