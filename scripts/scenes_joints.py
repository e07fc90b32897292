# SPDX-License-Identifier: Apache-2.0
"""Scenes of joints with dry friction, ends of travel and motors of limited force."""

import math

from scene_writer import write

RESTLESS = {"step": 1 / 240, "duration": 4}


def on_slide(name, y, slope, velocity=0.0, kind="slide_friction", **parameters):
    """A block of 100 kg on a slide that falls by `slope` along x, with an interaction on it."""
    along = [math.cos(slope), 0, -math.sin(slope)]
    body = {"name": name, "position": [0, y, 0], "velocity": [velocity * a for a in along],
            "mass": 100, "inertia": [2, 2, 2], "half_size": [0.2, 0.1, 0.1]}
    at, axis = [0, y, 0], along
    return body, [
        {"name": f"{name}_slide", "kind": "prismatic", "bodies": ["world", name], "at": at,
         "axis": axis},
        {"name": f"{name}_{kind}", "kind": kind, "bodies": ["world", name], "at": at,
         "axis": axis, **parameters}]


def flywheel(name, y, spin, kind, **parameters):
    """A wheel of 3 kg m² on a hinge about x, with an interaction on it."""
    body = {"name": name, "position": [0, y, 2], "angular_velocity": [spin, 0, 0], "mass": 20,
            "inertia": [3, 2, 2], "half_size": [0.05, 0.4, 0.4]}
    at, axis = [0, y, 2], [1, 0, 0]
    return body, [
        {"name": f"{name}_hinge", "kind": "hinge", "bodies": ["world", name], "at": at,
         "axis": axis},
        {"name": f"{name}_{kind}", "kind": kind, "bodies": ["world", name], "axis": axis,
         **parameters}]


def gather(parts):
    bodies, joints = [], []
    for body, of in parts:
        bodies.append(body)
        joints.extend(of)
    return bodies, joints


def joint_friction():
    """Constant friction, by the force of the joint, by the ends of a line around a bollard."""
    slope = math.atan(0.4)
    bodies, joints = gather([
        on_slide("held", 0, slope, loads=[{"interaction": "held_slide", "factor": 0.42}]),
        on_slide("slips", 1, slope, loads=[{"interaction": "slips_slide", "factor": 0.3}]),
        on_slide("stops", 2, 0.0, velocity=2.0, force=300),
        flywheel("coasts", 4, 10.0, "hinge_friction", torque=12),
        flywheel("bearing", 5, 10.0, "hinge_friction",
                 loads=[{"interaction": "bearing_hinge", "factor": 0.02}]),
    ])
    # A line over a bollard: its material passes as a scalar body; each end carries a weight.
    turn, friction = math.pi, 0.3
    share = math.tanh(friction * turn / 2)
    for name, y, ratio in [("grips", 8, 2.5), ("runs", 10, 2.9)]:
        bodies.append({"name": f"{name}_line", "kind": "scalar", "mass": 0.001, "gravity": False})
        for side, mass, radius in [("light", 100, 1.0), ("heavy", 100 * ratio, -1.0)]:
            bodies.append({"name": f"{name}_{side}", "kind": "lump", "mass": mass,
                           "position": [0.5 * radius, y, -5]})
            joints.append({"name": f"{name}_{side}_end", "kind": "winch_stretch",
                           "bodies": ["world", f"{name}_{side}", f"{name}_line"],
                           "points": [[0.5 * radius, y, 0], [0, 0, 0], [0, 0, 0]],
                           "length": 5, "EA": 1e6, "radius": radius, "damping_time": 0.05})
        joints.append({"name": f"{name}_capstan", "kind": "scalar_friction",
                       "bodies": [f"{name}_line"],
                       "loads": [{"interaction": f"{name}_light_end", "factor": share},
                                 {"interaction": f"{name}_heavy_end", "factor": share}]})
    write({
        "name": "joint_friction",
        "description": "Dry friction in joints. Blocks on slides: held by friction 0.42 of the "
                       "slide's force on a slope of 0.4; sliding by 0.3; stopped by 300 N. "
                       "Wheels stopped by 12 N m and by 0.02 m of the bearing's force. Weights "
                       "100 : 250 and 100 : 290 on a line half round a bollard of friction 0.3, "
                       "which holds up to exp(0.3 pi) = 2.566.",
        "settings": {"step": 1 / 240, "duration": 2},
        "bodies": bodies, "interactions": joints,
        "plot": {"motions": ["slips", "stops", "runs_light"]},
    })


def joint_limits():
    """Ends of travel."""
    bodies, joints = gather([
        on_slide("block", 0, 0.5, kind="slide_range", min=-1, max=0.5),
        flywheel("door", 2, 6.0, "hinge_range", min=-1, max=1),
    ])
    bodies.append({"name": "arm", "position": [1, 4, 0], "mass": 10, "inertia": [1, 1, 1],
                   "half_size": [1, 0.05, 0.05]})
    hinge = {"bodies": ["world", "arm"], "axis": [0, 1, 0]}
    joints += [{"name": "arm_hinge", "kind": "hinge", "at": [0, 4, 0], **hinge},
               {"name": "arm_range", "kind": "hinge_range", "min": -2, "max": 0.5, **hinge}]
    write({
        "name": "joint_limits",
        "description": "A block of 100 kg slides down 0.5 m to the end of its slide; a wheel "
                       "turns to the end of its range of 1 rad; an arm of 10 kg falls onto a "
                       "stop 0.5 rad below level.",
        "settings": RESTLESS, "bodies": bodies, "interactions": joints,
        "plot": {"motions": ["block", "arm"]},
    })


def motor_limits():
    """Motors that reach the end of their range of force."""
    bodies, joints = gather([
        on_slide("starts", 0, 0.0, kind="slide_motor", speed=2, force_min=-150, force_max=150),
        on_slide("sinks", 1, 0.5, kind="slide_motor", speed=0, force_min=-400, force_max=400),
        on_slide("stays", 2, 0.5, kind="slide_motor", speed=0, force_min=-480, force_max=480),
        flywheel("spins", 4, 0.0, "hinge_motor", speed=8, force_min=-6, force_max=6),
    ])
    write({
        "name": "motor_limits",
        "description": "Motors of limited force: a block of 100 kg brought to 2 m/s by 150 N; "
                       "blocks on a slope of 0.5 rad, which takes 470 N, held by 480 N and let "
                       "down by 400 N; a wheel of 3 kg m2 brought to 8 rad/s by 6 N m.",
        "settings": RESTLESS, "bodies": bodies, "interactions": joints,
        "plot": {"motions": ["starts", "sinks"]},
    })


def main():
    joint_friction()
    joint_limits()
    motor_limits()
