#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write scenes/sphere_decay.json: a floating sphere released 1 m above rest.

Sphere of IEA OES Task 10 (F. Wendt and others, 2019): radius 5 m, half of it under water of
1000 kg/m3, centre of mass 2 m below its centre. Coefficients of heave: added mass over
(2/3) pi rho a^3, and damping over that times omega. Source: A. Hulme, "The wave forces acting on a
floating hemisphere undergoing forced periodic oscillations", Journal of Fluid Mechanics 121
(1982), table 1.
"""
import json
import math
import pathlib

KA = [0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.5, 3.0,
      4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0]
ADDED = [0.8764, 0.8627, 0.7938, 0.7157, 0.6452, 0.5861, 0.5381, 0.4999, 0.4698, 0.4464, 0.4284,
         0.4047, 0.3924, 0.3871, 0.3864, 0.3884, 0.3988, 0.4111, 0.4322, 0.4471, 0.4574, 0.4647,
         0.4700, 0.4740, 0.4771]
DAMPING = [0.1036, 0.1816, 0.2793, 0.3254, 0.3410, 0.3391, 0.3271, 0.3098, 0.2899, 0.2691, 0.2484,
           0.2096, 0.1756, 0.1469, 0.1229, 0.1031, 0.0674, 0.0452, 0.0219, 0.0116, 0.0066, 0.0040,
           0.0026, 0.0017, 0.0012]
RADIUS, DENSITY, GRAVITY, BELOW = 5.0, 1000.0, 9.81, 2.0


def main() -> None:
    mass = 2.0 / 3.0 * math.pi * DENSITY * RADIUS**3
    omega = [math.sqrt(GRAVITY * ka / RADIUS) for ka in KA]
    plane = DENSITY * GRAVITY * math.pi * RADIUS**2
    tilt = mass * GRAVITY * BELOW
    inertia = 0.4 * mass * RADIUS**2
    scene = {
        "$schema": "../schema/scene-1.json",
        "version": 1,
        "name": "sphere_decay",
        "description": "A floating sphere of 5 m radius (IEA OES Task 10), let go 1 m above rest: "
        "added mass and damping of A. Hulme (1982), memory by convolution. Written by "
        "scripts/make_sphere_decay.py.",
        "settings": {"duration": 40, "step": 0.01},
        "bodies": [{"name": "sphere", "position": [0, 0, 1.0 - BELOW], "mass": round(mass, 3),
                    "inertia": [round(inertia, 1)] * 3}],
        "sea": {
            "depth": 1000,
            "density": DENSITY,
            "hulls": [{
                "body": "sphere",
                "linear": {"height": -BELOW},
                "reference": [0, 0, BELOW],
                "memory": 40,
                "coefficients": {
                    "frequencies": [round(w, 9) for w in omega],
                    "radiation": [{
                        "of": [3, 3],
                        "infinite": round(0.5 * mass, 3),
                        "zero": round(0.8310 * mass, 3),
                        "added_mass": [round(a * mass, 3) for a in ADDED],
                        "damping": [round(b * w * mass, 3) for b, w in zip(DAMPING, omega)],
                    }],
                    "stiffness": [{"of": [3, 3], "value": round(plane, 3)},
                                  {"of": [4, 4], "value": round(tilt, 3)},
                                  {"of": [5, 5], "value": round(tilt, 3)}],
                },
            }],
        },
        "outputs": [{"name": "height", "kind": "pose", "body": "sphere", "component": "z"}],
        "plot": {"motions": ["sphere"]},
    }
    path = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "sphere_decay.json"
    path.write_text(json.dumps(scene, indent=2) + "\n")


main()
