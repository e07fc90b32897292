#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write the control files of exercises/anchor_handling*.json (standard library only).

Values change at the times of the plans below. DP orders move along line 1 in steps of 5 s.
docs/anchor_handling.md explains the phases.
"""
import json
import math
import pathlib

EXERCISES = pathlib.Path(__file__).resolve().parent.parent / "exercises"
# Modes of ship and winches.
POSITION, SPEED, TENSION, BRAKE = 3, 0, 1, 3
HEADING = math.radians(30.0)  # direction of line 1, counterclockwise from x
FAIRLEAD = (38.0, 35.0)
ASIDE = 1.97  # fairlead of the settled rig, to port of the line [m]


class Plan:
    """Changes of inputs over time."""

    def __init__(self):
        self.rows = {}

    def at(self, time, **values):
        self.rows.setdefault(round(time, 3), {}).update(values)

    def place(self, time, distance):
        """Order the ship's reference point to a distance from the fairlead [m]."""
        c, s = math.cos(HEADING), math.sin(HEADING)
        self.at(time, x_order=round(FAIRLEAD[0] + distance * c - ASIDE * s, 3),
                y_order=round(FAIRLEAD[1] + distance * s + ASIDE * c, 3))

    def sail(self, time, start, end, speed, every=5.0):
        """Move the order along the line. Return the time at its end."""
        count = max(1, round(abs(end - start) / speed / every))
        for i in range(1, count + 1):
            self.place(time + (i - 1) * every, start + (end - start) * i / count)
        return time + count * every

    def write(self, name, text):
        names = []
        for values in self.rows.values():
            names += [n for n in values if n not in names]
        lines = [f"# Passes exercises/{name}.json: hawser exercise exercises/{name}.json --control "
                 "FILE", f"# {text}", "time," + ",".join(names)]
        for time in sorted(self.rows):
            values = self.rows[time]
            lines.append(",".join([f"{time:g}"] + [str(values.get(n, "")) for n in names]))
        (EXERCISES / f"{name}.control.csv").write_text("\n".join(lines) + "\n")


def from_the_rig():
    """Return the plan of the whole exercise."""
    p = Plan()
    p.at(0, mode=POSITION, work_mode=BRAKE, windlass_mode=BRAKE, hook=0, crane_hook=1, jaw_close=0,
         luff=0, knuckle=0, hoist=0, slew=0, heading_order=round(-HEADING, 4), port_pin=0,
         starboard_pin=0)
    p.place(0, 56.5)
    # Boom down, jib up and to starboard: the socket comes over the centre of the stern roller. The
    # hook takes it.
    p.at(3, luff=-0.06, knuckle=0.06, hoist=0.1, slew=-0.012)
    p.at(5, slew=0)
    p.at(8, hook=1)
    p.at(15, luff=0, knuckle=0, hoist=0)
    # The crane holds the socket until the winch has hauled it over the deck: legs of hooks do not
    # touch the roller.
    p.at(22, work_mode=SPEED, work_speed=-0.5, hoist=-0.1)
    p.at(36, crane_hook=0, hoist=0)
    p.at(38, hoist=0.4, luff=0.08)
    p.at(54, hoist=0, luff=0)
    # Pennant between the guide pins; the ship moves off, the windlass pays out.
    p.at(40, work_speed=0, port_pin=1, starboard_pin=1)
    p.at(45, windlass_mode=SPEED, windlass_speed=0.6)
    t = p.sail(36, 56.5, 136.5, 0.7)
    p.at(t, windlass_speed=0, windlass_pull=200000, windlass_mode=TENSION)
    # Haul. The pins guide the pennant until the anchor is at the roller; they need 18 s to go down.
    p.at(t + 2, work_speed=-0.6)
    p.at(t + 32, port_pin=0, starboard_pin=0)
    p.at(t + 38, work_speed=-0.3)
    p.at(243, work_speed=0)
    p.at(247, jaw_close=1)
    p.at(252, work_speed=0.3)
    p.at(256, work_speed=0)
    return p


def lower(p, t, hold=0):
    """Add the phases from the anchor on deck on, from a time [s]. The hook lets go `hold` seconds
    later, because the chain of a ship that drops back takes longer to tighten."""
    p.at(t + 8, work_mode=TENSION, work_pull=300000)
    p.at(t + 20, jaw_close=0)
    p.at(t + 28, work_mode=SPEED, work_speed=0.4)
    p.at(t + 56, work_speed=1.2)
    p.at(t + 165, work_speed=0.5)
    # Slack for the work wire, while the windlass hauls to 1.7 MN.
    p.at(t + 212, work_speed=1.0)
    p.at(t + 215, windlass_pull=800000)
    p.at(t + 225, windlass_pull=1100000)
    p.at(t + 235, windlass_pull=1400000)
    p.at(t + 245, windlass_pull=1700000)
    p.at(t + 250, work_speed=0)
    p.at(t + hold + 300, hook=0)
    p.at(t + hold + 304, work_speed=-1)
    p.at(t + hold + 330, work_speed=0)


def first_minute(plan):
    """Write the first minute by the signals of the scene, for `hawser run`."""
    exercise = json.loads((EXERCISES / "anchor_handling.json").read_text())
    signal = {i["name"]: i["signal"] for i in exercise["inputs"]}
    rows = {t: v for t, v in plan.rows.items() if t < 60}
    names = []
    for values in rows.values():
        names += [n for n in values if n not in names]
    lines = ["# First minute of exercises/anchor_handling.control.csv, by the signals of the scene.",
             "time," + ",".join(signal[n] for n in names)]
    for time in sorted(rows):
        lines.append(",".join([f"{time:g}"] + [str(rows[time].get(n, "")) for n in names]))
    (EXERCISES.parent / "scenes" / "anchor_handling.control.csv").write_text(
        "\n".join(lines) + "\n")


def main():
    whole = from_the_rig()
    whole.at(258, windlass_pull=300000)
    t = whole.sail(260, 136.5, 1052.0, 1.2)
    lower(whole, t + 60, hold=30)
    whole.write("anchor_handling", "Modes of winches: 0 speed, 1 tension, 3 brake; of the ship: 3 DP.")
    first_minute(whole)
    part = Plan()
    part.at(0, mode=POSITION, work_mode=BRAKE, hook=1, jaw_close=1)
    lower(part, 0)
    part.write("anchor_handling_lower",
               "Modes of winches: 0 speed, 1 tension, 3 brake; of the ship: 3 DP.")


if __name__ == "__main__":
    main()
