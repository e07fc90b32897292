# SPDX-License-Identifier: Apache-2.0
"""A wire that is hauled until it breaks in its middle, and a pulse along another wire."""

import math

from scene_writer import write

WIRE = {"mass_per_length": 23, "EA": 2.33e8, "diameter": 0.076}


def wire_part():
    """400 m between two decks; the winch hauls until the middle of the wire breaks at 1 MN."""
    write({
        "name": "wire_part",
        "description": "A winch hauls a wire of 404 m between two decks at 0.5 m/s. At 1 MN it "
                       "parts at a weak place in its middle; both halves recoil at "
                       "T/sqrt(EA rho) = 13.7 m/s and fall.",
        "settings": {"step": 1 / 240, "duration": 9},
        "line_types": {"wire76": {**WIRE, "breaking_load": 4e6, "axial_damping": 0.1}},
        "cables": [{"name": "wire", "line_type": "wire76", "from": {"at": [0, 0, 120]},
                    "to": {"at": [400, 0, 120]}, "length": 401.5, "elements": 80,
                    "shape": "hanging", "weak": {"at": 200, "breaking_load": 1e6}}],
        "winches": [{"name": "hauler", "cable": "wire", "core_radius": 0.6, "width": 2.4,
                     "stored": 300, "inertia": 4e4, "torque_haul": 2e6, "torque_pay": 2e6,
                     "power": 2e6, "brake_static": 4e6, "mode": "speed", "speed": -0.5}],
        "plot": {"tensions": ["wire"]},
    })


def wire_pulse():
    """A pulse 120 m long runs from elements of 5 m into elements of 10 m."""
    pull, height, pulse, middle = 1e6, 0.1, 120.0, 300.0
    strain = 1 + pull / WIRE["EA"]

    def shape(begin, spacing, count):
        points = []
        for i in range(1, count):
            x = begin + spacing * i
            off = x - middle
            z = 0.5 * height * (1 + math.cos(2 * math.pi * off / pulse)) \
                if abs(off) < 0.5 * pulse else 0
            points.append([x, 0, round(z, 9)])
        return points

    junction = {"name": "junction", "kind": "lump", "position": [600, 0, 0],
                "mass": round(WIRE["mass_per_length"] / strain * 7.5, 9)}
    common = {"line_type": "wire76", "consistent_mass": True}
    write({
        "name": "wire_pulse",
        "description": "A wire of 23 kg/m at 1 MN, without weight, is let go where it has been "
                       "pulled aside by 10 cm over 120 m: a pulse of 5 cm runs either way at "
                       "sqrt(T/rho) = 209 m/s. One returns from the end upside down, the other "
                       "runs from elements of 5 m into elements of 10 m, which send 0.3 % back.",
        "settings": {"step": 1 / 60, "duration": 6, "gravity": [0, 0, 0]},
        "line_types": {"wire76": WIRE},
        "bodies": [junction],
        "cables": [
            {"name": "fine", **common, "from": {"at": [0, 0, 0]}, "to": {"body": "junction"},
             "length": round(600 / strain, 9), "elements": 120, "shape": shape(0, 5, 120)},
            {"name": "coarse", **common, "from": {"body": "junction"},
             "to": {"at": [1800, 0, 0]}, "length": round(1200 / strain, 9), "elements": 120,
             "shape": shape(600, 10, 120)}],
        "plot": {"tensions": ["fine", "coarse"], "motions": ["fine/84", "junction", "coarse/72"]},
    })


def main():
    wire_part()
    wire_pulse()


if __name__ == "__main__":
    main()
