# SPDX-License-Identifier: Apache-2.0
"""Scenes of rigid bodies: the IFToMM benchmark mechanisms, spinning bodies, a slider-crank.

The relative-rotation damping of joints is off in these scenes. It is of first order in the step,
and the scenes measure the convergence of the scheme without it.
"""

import math

from scene_writer import rotation, write


def hinge(name, a, b, at, axis):
    return {"name": name, "kind": "hinge", "bodies": [a, b], "at": at, "axis": axis}


def n_four_bar(windows):
    """IFToMM A02: parallelogram windows of links of 1 m, 1 kg; upright, top at 1 m/s."""
    across, along = 1 / 12, 1e-3  # slender rods; the second has no effect on plane motion
    bodies, joints = [], []
    for i in range(windows + 1):
        bodies.append({"name": f"v{i}", "position": [i, 0, 0.5], "velocity": [0.5, 0, 0],
                       "angular_velocity": [0, 1, 0], "mass": 1,
                       "inertia": [across, across, along], "half_size": [0.03, 0.03, 0.5]})
    for i in range(windows):
        bodies.append({"name": f"h{i}", "position": [i + 0.5, 0, 1], "velocity": [1, 0, 0],
                       "mass": 1, "inertia": [along, across, across],
                       "half_size": [0.5, 0.03, 0.03]})
    y = [0, 1, 0]
    for i in range(windows + 1):
        joints.append(hinge(f"base{i}", "world", f"v{i}", [i, 0, 0], y))
        if i < windows:
            joints.append(hinge(f"left{i}", f"v{i}", f"h{i}", [i, 0, 1], y))
        if i > 0:
            joints.append(hinge(f"right{i}", f"h{i - 1}", f"v{i}", [i, 0, 1], y))
    write({
        "name": "n_four_bar",
        "description": "Two four-bar windows of links of 1 m and 1 kg, upright, the top moving "
                       "at 1 m/s (IFToMM benchmark A02, N = 2). All bars are in line twice a "
                       "turn: the pose is singular there.",
        "settings": {"step": 1 / 960, "duration": 10},
        "bodies": bodies, "interactions": joints, "plot": {"motions": ["h0"]},
    })


def bricard():
    """IFToMM A04: six-bar loop, 5 moving rods of 1 m, 1 kg, 0.1 m square; 1 degree of freedom."""
    points = [(0, 0, 0), (1, 0, 0), (1, -1, 0), (1, -1, 1), (0, -1, 1), (0, 0, 1)]
    axes = [(0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0)]
    along, across = 0.01 / 6, (1 + 0.01) / 12
    bodies, joints = [], []
    for i in range(5):
        a, b = points[i], points[i + 1]
        d = [abs(q - p) for p, q in zip(a, b)]
        bodies.append({"name": f"rod{i}", "position": [(p + q) / 2 for p, q in zip(a, b)],
                       "mass": 1, "inertia": [along if x else across for x in d],
                       "half_size": [0.5 if x else 0.05 for x in d]})
    names = ["world"] + [b["name"] for b in bodies] + ["world"]
    for i in range(6):
        joints.append(hinge(f"joint{i}", names[i], names[i + 1], points[i], axes[i]))
    write({
        "name": "bricard",
        "description": "Bricard's mechanism: five rods of 1 m, 1 kg, 0.1 m square and the ground "
                       "in a loop of six hinges, one degree of freedom with one redundant row "
                       "(IFToMM benchmark A04).",
        "settings": {"step": 1 / 960, "duration": 10, "gravity": [0, -9.81, 0]},
        "bodies": bodies, "interactions": joints, "plot": {"motions": ["rod2"]},
    })


def andrews_squeezer():
    """Seven-body mechanism with the constants of the Test Set for IVP Solvers (Bari, CWI)."""
    m = [.04325, .00365, .02373, .00706, .07050, .00706, .05498]
    inertia = [2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5]
    xa, ya, xb, yb, xc, yc = -.06934, -.00227, -.03635, .03273, .014, .072
    c0, l0, torque = 4530.0, .07785, .033
    d, da, e, ea, rr, ra = .028, .0115, .02, .01421, .007, .00092
    ss, sa, sb, sc, sd = .035, .01874, .01043, .018, .02
    ta, tb, u, ua, ub, zf, zt, fa = .02308, .00916, .04, .01228, .00449, .02, .04, .01421
    beta, theta, gamma = -0.06171389001427645, 0.0, 0.4552798191630704
    phi, delta = 0.22266839016588588, 0.48736497954384255
    omega, epsilon = -0.22266839016588588, 1.2305474445498212
    # Absolute angle of each body, its base point and its centre of mass in the frame of the base.
    g = (xa + zt * math.cos(delta), ya + zt * math.sin(delta))
    h = (xa + u * math.sin(epsilon), ya - u * math.cos(epsilon))
    f = (rr * math.cos(beta), rr * math.sin(beta))
    angle = [beta, beta + theta, gamma, phi + delta, delta, omega + epsilon, epsilon]
    base = [(0, 0), f, (xb, yb), g, (xa, ya), h, (xa, ya)]
    centre = [(ra, 0), (-da, 0), (sb, -sa), (0, -(e - ea)), (ta, tb), (zf - fa, 0), (ub, -ua)]
    far = [(rr, 0), (-d, 0), (0, -ss), (0, -e), (zt, 0), (zf, 0), (0, -u)]

    def place(i, local):
        c, s = math.cos(angle[i]), math.sin(angle[i])
        return (base[i][0] + c * local[0] - s * local[1], base[i][1] + s * local[0] + c * local[1])

    meet = place(1, far[1])  # where bodies 2, 3, 4 and 6 meet
    for i in (2, 3, 5):  # consistent initial values: the three loops close
        assert math.dist(meet, place(i, far[i])) < 1e-15, (i, place(i, far[i]), meet)
    bodies = []
    for i in range(7):
        body = {"name": f"k{i + 1}", "position": [*place(i, centre[i]), 0],
                "orientation": rotation((0, 0, 1), angle[i]), "mass": m[i],
                "inertia": [inertia[i]] * 3, "half_size": [.004, .004, .001]}
        if i == 0:
            body["torque"] = [0, 0, torque]
        bodies.append(body)
    z = [0, 0, 1]

    def at(p):
        return [*p, 0]

    joints = [hinge("o", "world", "k1", [0, 0, 0], z), hinge("f", "k1", "k2", at(f), z),
              hinge("b", "world", "k3", [xb, yb, 0], z), hinge("e3", "k2", "k3", at(meet), z),
              hinge("e4", "k2", "k4", at(meet), z), hinge("e6", "k2", "k6", at(meet), z),
              hinge("g", "k4", "k5", at(g), z), hinge("h", "k6", "k7", at(h), z),
              hinge("a5", "world", "k5", [xa, ya, 0], z),
              hinge("a7", "world", "k7", [xa, ya, 0], z),
              {"name": "spring", "kind": "stretch", "bodies": ["world", "k3"],
               "points": [[xc, yc, 0], [sd - sb, sa - sc, 0]], "length": l0, "EA": c0 * l0,
               "damping_time": 0, "tension_only": 0}]
    write({
        "name": "andrews_squeezer",
        "description": "Andrews' squeezing mechanism: seven bodies in a plane, three loops, a "
                       "spring and a constant driving torque, with the constants of the Test Set "
                       "for IVP Solvers.",
        "settings": {"step": 2e-6, "duration": 0.03, "gravity": [0, 0, 0]},
        # The published joints are rigid: at 1e-12 these small parts would deform by 1e-7.
        "defaults": {"compliance": 1e-15},
        "bodies": bodies, "interactions": joints, "plot": {"motions": ["k1", "k3"]},
    })


def spinning():
    write({
        "name": "dzhanibekov",
        "description": "A free body that spins about its middle axis and turns over again and "
                       "again.",
        "settings": {"step": 1 / 120, "duration": 20, "gravity": [0, 0, 0]},
        "bodies": [{"name": "nut", "position": [0, 0, 0], "angular_velocity": [.01, 5, .01],
                    "mass": 1, "inertia": [1, 2, 3], "half_size": [1, .6, .3]}],
        "plot": {"motions": ["nut"]},
    })
    # Steady precession about z at rate p with the axis at 60 degrees from the vertical:
    # I1 p² cos a - I3 s p + m g l = 0 gives the spin s; I1 about the tip.
    mass, l, i1, i3, p, a, g = 1.0, 0.3, 0.1, 0.2, 2.0, math.radians(60), 9.81
    s = ((i1 + mass * l * l) * p * p * math.cos(a) + mass * g * l) / (i3 * p)
    axis = (math.sin(a), 0.0, math.cos(a))
    w = [(s - p * math.cos(a)) * x for x in axis]
    w[2] += p
    write({
        "name": "heavy_top",
        "description": "A symmetric top on its tip, started so that its axis stays 60 degrees "
                       "from the vertical and precesses at 2 rad/s.",
        "settings": {"step": 1 / 120, "duration": 10},
        "bodies": [{"name": "top", "position": [l * x for x in axis],
                    "orientation": rotation((0, 1, 0), a),
                    "velocity": [0, p * l * axis[0], 0], "angular_velocity": w,
                    "mass": mass, "inertia": [i1, i1, i3], "half_size": [.3, .3, .05]}],
        "interactions": [{"name": "tip", "kind": "ball", "bodies": ["world", "top"],
                          "at": [0, 0, 0]}],
        "plot": {"motions": ["top"]},
    })


def slider_crank():
    r, l, speed = 0.1, 0.3, 0.5
    axis = [0, -1, 0]  # a positive angle lifts the crank from x towards z
    write({
        "name": "slider_crank",
        "description": "A crank of 0.1 m driven at 0.5 rad/s, a rod of 0.3 m and a slider "
                       "along x.",
        "settings": {"step": 1 / 960, "duration": 12.6},
        "bodies": [
            {"name": "crank", "position": [r / 2, 0, 0], "velocity": [0, 0, speed * r / 2],
             "angular_velocity": [0, -speed, 0], "mass": 1, "inertia": [1e-4, 1e-3, 1e-3],
             "half_size": [r / 2, .01, .01]},
            {"name": "rod", "position": [r + l / 2, 0, 0], "velocity": [0, 0, speed * r / 2],
             "angular_velocity": [0, speed * r / l, 0], "mass": 2, "inertia": [2e-4, .015, .015],
             "half_size": [l / 2, .01, .01]},
            {"name": "slider", "position": [r + l, 0, 0], "mass": 1, "inertia": [1e-3] * 3,
             "half_size": [.03, .02, .02]}],
        "interactions": [
            hinge("main", "world", "crank", [0, 0, 0], axis),
            hinge("pin", "crank", "rod", [r, 0, 0], axis),
            hinge("wrist", "rod", "slider", [r + l, 0, 0], axis),
            {"name": "guide", "kind": "prismatic", "bodies": ["world", "slider"],
             "at": [r + l, 0, 0], "axis": [1, 0, 0]},
            {"name": "motor", "kind": "hinge_motor", "bodies": ["world", "crank"],
             "axis": axis, "speed": speed}],
        "plot": {"motions": ["slider"]},
    })


def main():
    n_four_bar(2)
    bricard()
    andrews_squeezer()
    spinning()
    slider_crank()
