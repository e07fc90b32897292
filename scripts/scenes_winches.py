# SPDX-License-Identifier: Apache-2.0
"""Six winches on one deck, each in a mode of its own, with a weight on its wire."""

from scene_writer import write

WEIGHT = 8000 * 9.81  # [N]
WIRE = {"mass_per_length": 4.2, "EA": 4.5e7, "diameter": 0.032, "breaking_load": 6.5e5,
        "axial_damping": 2}
# Unstretched length of 11.2 m of wire under the weight and half its own [m].
LENGTH = 11.2 / (1 + (WEIGHT + 0.5 * 11.2 * 9.81 * WIRE["mass_per_length"]) / WIRE["EA"])


def lift(name, y, **winch):
    """A weight of 8 t that hangs 12 m below a winch on deck, and what of it differs."""
    body = {"name": name, "position": [0, y, 8], "mass": 8000, "box": [0.8, 0.8, 0.8]}
    cable = {"name": f"{name}_wire", "line_type": "wire32", "from": {"at": [0, y, 20]},
             "to": {"body": name, "point": [0, 0, 0.8]}, "elements": 4,
             "length": round(LENGTH, 6)}
    return body, cable, {"name": f"{name}_winch", "cable": f"{name}_wire", "core_radius": 0.3,
                         "width": 1.0, "flange_radius": 0.7, "stored": 200, "inertia": 500,
                         "torque_haul": 5e4, "torque_pay": 5e4, "power": 2e5,
                         "brake_static": 6e4, "band_friction": 0.3, "band_angle": 4.7, **winch}


def main():
    bodies, cables, winches = zip(
        lift("speed", 0, mode="speed", speed=-0.3),
        lift("tension", 4, mode="tension", tension=1.02 * WEIGHT, max_speed=0.3),
        lift("render", 8, mode="render", tension=WEIGHT, deadband=0.1 * WEIGHT),
        lift("hold", 12),
        lift("slip", 16, brake_static=0.9 * WEIGHT * 0.412),
        lift("release", 20, mode="release", release_delay=2, release_load=0.5 * WEIGHT))
    write({
        "name": "winch_modes",
        "description": "Six winches, each with a weight of 8 t: one hauls at 0.3 m/s, one pulls "
                       "with 2 % more than the weight, one stands between 90 and 110 % of it, one "
                       "holds by its brake, the brake of one slips, and one lets go after 2 s.",
        "settings": {"step": 1 / 240, "duration": 6},
        "line_types": {"wire32": WIRE},
        "bodies": list(bodies), "cables": list(cables), "winches": list(winches),
        "plot": {"tensions": [c["name"] for c in cables], "motions": [b["name"] for b in bodies]},
    })


if __name__ == "__main__":
    main()
