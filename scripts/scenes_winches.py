# SPDX-License-Identifier: Apache-2.0
"""Scene of six winches on one deck, each in another mode with a weight on its wire, and a
windlass whose chain jumps."""

from scene_writer import write

WEIGHT = 8000 * 9.81  # [N]
WIRE = {"mass_per_length": 4.2, "EA": 4.5e7, "diameter": 0.032, "breaking_load": 6.5e5,
        "axial_damping": 2}
# Unstretched length of 11.2 m of wire under the weight and half its own [m].
LENGTH = 11.2 / (1 + (WEIGHT + 0.5 * 11.2 * 9.81 * WIRE["mass_per_length"]) / WIRE["EA"])


def lift(name, y, **winch):
    """A weight of 8 t that hangs 12 m below a winch on deck, with changed keys."""
    body = {"name": name, "position": [0, y, 8], "mass": 8000, "box": [0.8, 0.8, 0.8]}
    cable = {"name": f"{name}_wire", "line_type": "wire32", "from": {"at": [0, y, 20]},
             "to": {"body": name, "point": [0, 0, 0.8]}, "elements": 4,
             "length": round(LENGTH, 6)}
    return body, cable, {"name": f"{name}_winch", "cable": f"{name}_wire", "core_radius": 0.3,
                         "width": 1.0, "flange_radius": 0.7, "stored": 200, "inertia": 500,
                         "torque_haul": 5e4, "torque_pay": 5e4, "power": 2e5,
                         "brake_static": 6e4, "band_friction": 0.3, "band_angle": 4.7, **winch}


BAR = 0.076  # Bar diameter of the stud link chain [m].
CHAIN = {"mass_per_length": round(21.9e3 * BAR ** 2, 3), "EA": round(1.01e11 * BAR ** 2),
         "diameter": BAR, "link": 4 * BAR, "breaking_load": 4.88e6, "axial_damping": 2,
         "drag": 100, "submerged_factor": 0.87, "color": "#445566",
         "description": "Stud link chain of 76 mm, grade R3: 21.9e3 d^2 kg/m, 1.01e11 d^2 N "
                        "(OrcaFlex documentation), links of 4 d."}


def chain_gypsy():
    """A ship drifts on 76 mm chain until the chain jumps on the windlass."""
    links = 12  # an element
    length = 30 * links * CHAIN["link"]
    depth, touch = 30.0, 0.5 * BAR
    write({
        "name": "chain_gypsy",
        "description": "A windlass with a gypsy of five pockets pays out 76 mm chain for 20 s, "
                       "and its brake holds it. The ship drifts off at 0.8 m/s, the chain comes "
                       "off the bottom and taut, and above 800 kN it jumps on the gypsy, by a "
                       "pocket of two links at a time.",
        "settings": {"step": 1 / 240, "duration": 60},
        "line_types": {"chain76": CHAIN},
        "materials": {"bed": {}, "chain": {}},
        "material_pairs": [{"between": ["chain", "bed"], "friction": 0.7, "stiffness": 85187}],
        "bodies": [
            {"name": "seabed", "kind": "fixed",
             "shapes": [{"kind": "plane", "name": "bed", "material": "bed"}]},
            {"name": "ship", "kind": "kinematic", "position": [95, 0, depth], "velocity": [0.8, 0, 0],
             "half_size": [40, 9, 4]}],
        "cables": [{"name": "chain", "line_type": "chain76", "from": {"body": "ship",
                                                                     "point": [-40, 0, 4]},
                    "to": {"at": [-40, 0, touch]}, "length": round(length, 6),
                    "elements": 30, "shape": "hanging",
                    "seabed": {"height": 0, "friction": 0.7},
                    "contact": {"radius": touch, "material": "chain"}}],
        "winches": [{"name": "windlass", "cable": "chain", "stored": 300, "inertia": 2e4,
                     "gypsy": {"pockets": 5, "jump_load": 8e5, "jump_friction": 3e5,
                               "locker_fall": 6},
                     "torque_haul": 3e5, "torque_pay": 3e5, "brake_static": 1e6,
                     "mode": "speed", "speed": 0.5}],
        "timeline": [{"at": 20, "set": {"windlass.mode": "brake"}}],
        "plot": {"tensions": ["chain"], "motions": ["ship"]},
    })


def winch_modes():
    """One winch in each mode."""
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


def main():
    winch_modes()
    chain_gypsy()


if __name__ == "__main__":
    main()
