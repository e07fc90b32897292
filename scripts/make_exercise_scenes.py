#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write scenes/subsea_lift.json, berthing.json and girting.json from the library of ships.

subsea_lift: a construction vessel of 83 m under DP in waves of 1.5 m holds a template of 25 t on its
hoist wire over the starboard side, 60 m above the seabed. The hoist winch has heave compensation.
berthing: a barge of 91 m without propulsion drifts before a wind of 18 m/s towards a quay 25 m away.
Two tugs check it with their lines. Two mooring winches on the barge have lines to the quay.
girting: a tug of 32 m with its towing post amidships tows the barge in waves of 1 m.
"""
import copy
import json
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PARTS = ROOT / "scenes/parts"


def template(name):
    return copy.deepcopy(json.loads((PARTS / f"{name}.json").read_text())["templates"][name])


def hull(body, file, offset, added, damping):
    return {"body": body, "mesh": f"parts/{file}.obj", "offset": offset,
            "added_mass": [0, 0, *added, 0], "damping": [0, 0, *damping, 0]}


def ahts(body):
    return hull(body, "vessel_ahts", [4.5, 0, -1.2], [8.3e6, 7.48e7, 3.9875e9],
                [5052700, 50369000, 3632200000])


def write(name, scene):
    file = ROOT / "scenes" / f"{name}.json"
    file.write_text(json.dumps(scene, indent=1) + "\n")


def subsea_lift():
    ship = template("vessel_ahts")
    control = ship["vessels"][0]["control"]
    control.update({"mode": "position", "bandwidth": [0.1, 0.1, 0.2]})
    tip, block, eye, sling = [-8.0, -15.5, 13.0], 2.0, [1.6, 1.6, 1.2], 6.0
    drop = 6.0  # of wire between tip and block
    top = tip[2] + 1.2 - drop
    leg = (sling ** 2 - 2 * 1.6 ** 2) ** 0.5
    return {
        "$schema": "../schema/scene-1.json", "version": 2, "name": "subsea_lift",
        "description": "A construction vessel under DP in waves of 1.5 m with a template of 25 t on "
                       "its hoist wire, above a seabed at 60 m. Scene of the exercise subsea_lift.",
        "settings": {"duration": 900},
        "line_types": {"hoist48": {
            "description": "Steel wire 48 mm", "mass_per_length": 9.6, "EA": 9e7, "EI": 1000,
            "diameter": 0.048, "breaking_load": 1600000.0, "axial_damping": 0.1, "cd_normal": 1.2}},
        "templates": {"csv": ship},
        "materials": {"bed": {}, "steel": {}},
        "material_pairs": [{"between": ["steel", "bed"], "friction": 0.8, "stiffness": 3e6}],
        "instances": [{"template": "csv", "name": "csv", "position": [0, 0, 1.2]}],
        "bodies": [
            {"name": "block", "position": [tip[0], tip[1], round(top, 4)], "mass": 2000,
             "box": [0.35, 0.35, 0.7], "angular_damping": [500, 500, 500]},
            {"name": "template", "position": [tip[0], tip[1], round(top - leg - eye[2], 4)],
             "mass": 25000, "box": [2.0, 2.0, 1.2], "linear_damping": [1500, 1500, 0],
             "angular_damping": [2e4, 2e4, 2e4],
             "shapes": [{"kind": "box", "half_size": [2.0, 2.0, 1.2], "material": "steel"}]},
            {"name": "seabed", "kind": "fixed", "position": [0, 0, -60],
             "shapes": [{"kind": "plane", "material": "bed"}]}],
        "cables": [{"name": "hoist_wire", "line_type": "hoist48",
                    "from": {"body": "csv/hull", "point": tip},
                    "to": {"body": "block", "point": [0, 0, 0]},
                    "length": drop * 0.997, "elements": 3, "consistent_mass": True}],
        "winches": [{"name": "hoist", "cable": "hoist_wire", "core_radius": 0.6, "width": 2,
                     "stored": 300, "inertia": 20000.0, "torque_haul": 800000.0,
                     "torque_pay": 800000.0, "power": 900000.0, "brake_static": 900000.0,
                     "element": 2.0, "mode": "brake", "heave_speed": 2.5}],
        "hooks": [{"name": "hook", "on": "block", "take": "template",
                   "loads": [{"body": "template", "sling_length": sling, "sling_EA": 2e7, "reach": 1.5,
                              "eyes": [[x * eye[0], y * eye[1], eye[2]] for x in (1, -1) for y in (1, -1)]}]}],
        "sea": {"depth": 60, "density": 1025.0,
                "waves": [{"kind": "jonswap", "height": 1.5, "period": 8, "components": 50,
                           "direction_deg": 205, "spreading": 10, "seed": 4}],
                "current": [{"depth": 0, "speed": 0.3, "direction_deg": 180},
                            {"depth": 60, "speed": 0.15, "direction_deg": 180}],
                "wind": {"speed": 8, "direction_deg": 200},
                "bodies": [
                    {"body": "template", "volume": 7.0, "drag_area": [12, 12, 18], "added_mass": 1.6,
                     "height": 2.4},
                    {"body": "block", "volume": 0.25, "drag_area": [0.6, 0.6, 0.4], "added_mass": 0.5,
                     "height": 1.4}],
                "hulls": [ahts("csv/hull")]},
        "outputs": [
            {"name": "load_depth", "kind": "pose", "body": "template", "component": "z"},
            {"name": "sink_speed", "kind": "velocity", "body": "template", "component": "z"},
            {"name": "wire_tension", "kind": "tension", "cable": "hoist_wire", "component": "largest"},
            {"name": "block_z", "kind": "pose", "body": "block", "component": "z"}],
        "plot": {"tensions": ["hoist_wire"], "motions": ["template", "csv/hull"]}}


def berthing():
    barge, tug = template("vessel_barge"), template("vessel_tug")
    barge["bodies"][0]["shapes"] = [
        {"kind": "box", "name": "side", "half_size": [44, 13.7, 2.5], "material": "hull"}]
    tug["vessels"][0]["control"] = {"mode": "joystick"}
    gap, half, line = 25.0, 13.7, 30.0
    face = half + gap
    tugs = {"tug_fore": 30.0, "tug_aft": -30.0}
    rope = {"description": "Rope of HMPE, 56 mm", "mass_per_length": 1.9, "EA": 2e7, "diameter": 0.056,
            "breaking_load": 1500000.0, "axial_damping": 0.1, "cd_normal": 1.2}
    # Bow of the tug to the side of the barge: the tug lies athwart, its bow to the north.
    bow, tug_y = 14.5, -half - line * 0.985 - 14.5
    moorings = {"fore": (40.0, 58.0), "aft": (-40.0, -58.0)}
    return {
        "$schema": "../schema/scene-1.json", "version": 2, "name": "berthing",
        "description": "A barge of 91 m drifts before a wind of 18 m/s to a quay. Two tugs check it, "
                       "two mooring winches have lines ashore. Scene of the exercise berthing.",
        "settings": {"duration": 900},
        "line_types": {"rope56": rope},
        "templates": {"deck_barge": barge, "harbour_tug": tug},
        "materials": {"hull": {}, "fender": {}},
        "material_pairs": [{"between": ["hull", "fender"], "friction": 0.3, "stiffness": 1.5e6}],
        "instances": [
            {"template": "deck_barge", "name": "barge", "position": [0, 0, 1.5]},
            *[{"template": "harbour_tug", "name": name, "position": [x, round(tug_y, 3), 0.35],
               "euler_deg": [0, 0, 90]} for name, x in tugs.items()]],
        "bodies": [
            {"name": "quay", "kind": "fixed", "position": [0, face + 9, -2], "box": [90, 8, 6]},
            *[{"name": f"fender{i}", "kind": "fixed", "position": [x, face, 1.2],
               "shapes": [{"kind": "sphere", "radius": 1.0, "material": "fender"}]}
              for i, x in enumerate((-36, -12, 12, 36), 1)]],
        "cables": [
            *[{"name": f"{name}_line", "line_type": "rope56",
               "from": {"body": f"{name}/hull", "point": [bow, 0, 3.0]},
               "to": {"body": "barge/hull", "point": [x, -half, 1.6]},
               "length": line, "elements": 6, "shape": "catenary"} for name, x in tugs.items()],
            *[{"name": f"{name}_rope", "line_type": "rope56",
               "from": {"body": "barge/hull", "point": [a, half, 2.2]},
               "to": {"at": [b, face + 2, 4.5]},
               "length": round(((b - a) ** 2 + (gap + 2) ** 2 + 1) ** 0.5 * 1.06, 2), "elements": 8,
               "shape": "catenary"} for name, (a, b) in moorings.items()]],
        "winches": [
            {"name": f"{name}_winch", "cable": f"{name}_rope", "core_radius": 0.35, "width": 1.2,
             "stored": 120, "inertia": 1500.0, "torque_haul": 120000.0, "torque_pay": 120000.0,
             "power": 90000.0, "brake_static": 400000.0, "element": 4.0, "mode": "brake"}
            for name in moorings],
        "sea": {"depth": 18, "density": 1025.0,
                "waves": [{"kind": "jonswap", "height": 0.4, "period": 4, "components": 40,
                           "direction_deg": 90, "spreading": 8, "seed": 2}],
                "wind": {"speed": 18, "direction_deg": 90, "gusts": True, "seed": 3},
                "hulls": [
                    hull("barge/hull", "vessel_barge", [0, 0, -1.5], [2.2096e7, 1.744e8, 1.1537e10],
                         [16919000, 229200000, 10230000000]),
                    *[hull(f"{name}/hull", "vessel_tug", [0.6, 0, -0.35], [1386600, 2703300, 88740000],
                           [1290000, 2114300, 79556000]) for name in tugs]]},
        "outputs": [
            {"name": "moved_to_quay", "kind": "pose", "body": "barge/hull", "component": "y"},
            {"name": "approach", "kind": "velocity", "body": "barge/hull", "component": "y"},
            {"name": "barge_heading", "kind": "pose", "body": "barge/hull", "component": "yaw"},
            *[{"name": f"{name}_tension", "kind": "tension", "cable": f"{name}_{kind}",
               "component": "largest"} for name, kind in
              [("tug_fore", "line"), ("tug_aft", "line"), ("fore", "rope"), ("aft", "rope")]]],
        "plot": {"tensions": ["fore_rope", "aft_rope", "tug_fore_line", "tug_aft_line"],
                 "motions": ["barge/hull", "tug_fore/hull", "tug_aft/hull"]}}


def girting():
    tug = template("vessel_tug")
    tug["vessels"][0]["control"] = {"mode": "heading"}
    post = [-2.0, 0, 2.6]
    return {
        "$schema": "../schema/scene-1.json", "version": 2, "name": "girting",
        "description": "A tug of 32 m tows a barge of 91 m on 130 m of wire in waves of 1 m. Its "
                       "towing post is amidships. Scene of the exercise emergency_release.",
        "settings": {"duration": 720},
        "include": ["parts/vessel_barge.json"],
        "line_types": {"tow44": {
            "description": "Steel wire 44 mm", "mass_per_length": 7.9, "EA": 8e7, "EI": 800,
            "diameter": 0.044, "breaking_load": 1500000.0, "axial_damping": 0.1, "cd_normal": 1.2}},
        "templates": {"ocean_tug": tug},
        "instances": [
            {"template": "ocean_tug", "name": "tug", "position": [0, 0, 0.35], "parameters": {"speed": 1.5}},
            {"template": "vessel_barge", "name": "barge", "position": [-178, 0, 1.5],
             "parameters": {"speed": 1.5}}],
        "cables": [{"name": "towline", "line_type": "tow44", "from": {"body": "tug/hull", "point": post},
                    "to": {"body": "barge/hull", "point": [45.7, 0, 0.4]}, "length": 130.4,
                    "elements": 26, "shape": "catenary"}],
        "winches": [{"name": "tow_winch", "cable": "towline", "core_radius": 0.4, "width": 1.4,
                     "stored": 300, "inertia": 6000.0, "torque_haul": 300000.0,
                     "torque_pay": 300000.0, "power": 250000.0, "brake_static": 800000.0,
                     "element": 5.0, "mode": "brake", "overload_limit": 1200000.0}],
        "stability": [{"name": "stability", "body": "tug/hull", "cable": "towline",
                       "pin": [-2.0, 0.6, 2.6], "stern_x": -15.4, "thrust_height": -4.9,
                       "bollard_pull": 700000}],
        "sea": {"depth": 60, "density": 1025.0,
                "waves": [{"kind": "jonswap", "height": 1.0, "period": 7, "components": 40,
                           "direction_deg": 160, "spreading": 8, "seed": 6}],
                "wind": {"speed": 8, "direction_deg": 160},
                "hulls": [
                    hull("barge/hull", "vessel_barge", [0, 0, -1.5], [2.2096e7, 1.744e8, 1.1537e10],
                         [16919000, 229200000, 10230000000]),
                    hull("tug/hull", "vessel_tug", [0.6, 0, -0.35], [1386600, 2703300, 88740000],
                         [1290000, 2114300, 79556000])]},
        "outputs": [
            {"name": "tow_tension", "kind": "tension", "cable": "towline", "component": "largest"},
            {"name": "heel", "kind": "pose", "body": "tug/hull", "component": "roll"},
            {"name": "course", "kind": "pose", "body": "tug/hull", "component": "yaw"},
            {"name": "barge_speed", "kind": "velocity", "body": "barge/hull", "component": "x",
             "local": True},
            {"name": "barge_distance", "kind": "distance", "bodies": ["tug/hull", "barge/hull"],
             "points": [[-15, 0, 2], [45.7, 0, 0.4]]}],
        "plot": {"tensions": ["towline"], "motions": ["tug/hull", "barge/hull"]}}


def tow_gob():
    scene = girting()
    eye, slack = [-15.2, 0, 2.3], 6.0   # of the gob wire at the stern; its length at the start
    scene.update({
        "name": "tow_gob",
        "description": "The tug and barge of girting.json in waves of 2 m, with a gob wire: a ring "
                       "of 150 kg round the towline, held down at the stern by the gob winch. Scene "
                       "of the exercise tow_gob."})
    scene["settings"]["duration"] = 900
    scene["sea"]["waves"][0].update({"height": 2.0, "period": 8})
    scene["sea"]["wind"]["speed"] = 10
    scene["bodies"] = [{"name": "gob_ring", "position": [eye[0] - slack * 0.985, 0, 0.35 + 2.1],
                        "mass": 150, "box": [0.25, 0.12, 0.25], "linear_damping": 200,
                        "angular_damping": [40, 40, 40]}]
    scene["cables"].append({"name": "gob_wire", "line_type": "tow44",
                            "from": {"body": "tug/hull", "point": eye},
                            "to": {"body": "gob_ring", "point": [0.2, 0, 0]}, "length": slack,
                            "elements": 4, "consistent_mass": True})
    scene["winches"].append({"name": "gob_winch", "cable": "gob_wire", "core_radius": 0.25,
                             "width": 0.6, "stored": 40, "inertia": 600.0, "torque_haul": 120000.0,
                             "torque_pay": 120000.0, "power": 120000.0, "brake_static": 800000.0,
                             "element": 1.5, "mode": "brake", "overload_limit": 1200000.0})
    scene["chasers"] = [{"name": "gob", "on": "gob_ring", "reach": 2.0, "friction": 0.15}]
    scene["timeline"] = [{"at": 0.1, "description": "the gob shackle is round the towline",
                          "set": {"gob.close": 1}}]
    scene["outputs"] += [
        {"name": "gob_tension", "kind": "tension", "cable": "gob_wire", "component": "largest"},
        {"name": "barge_course", "kind": "pose", "body": "barge/hull", "component": "yaw"}]
    return scene


if __name__ == "__main__":
    write("tow_gob", tow_gob())
    write("girting", girting())
    write("subsea_lift", subsea_lift())
    write("berthing", berthing())
