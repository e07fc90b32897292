#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write scenes/anchor_run.json (standard library only).

An anchor is hauled over the stern roller on deck. The load is transferred from its work wire to the
chain in the shark jaw, and the chain is paid out again.

The site is that of anchor_adaptive. ahts1 has guide pins that can be lowered, a shark jaw, and an
anchor that touches its deck and roller. A pendant leads along the anchor from its wire to its chain.
ahts2 has a second tow wire to the other corner of the rig, which crosses its first one just behind
the roller. docs/anchor_run.md explains the numbers.

Usage:
- scripts/make_anchor_run.py: write scenes/anchor_run.json
- scripts/make_anchor_run.py --fine: the same in elements of 2.5 m without resolutions
- scripts/make_anchor_run.py --fine --element chain1=1.25 --to DIR: with elements of this length in
  this line, into another folder, to measure the error of anchor_run_fine
- scripts/make_anchor_run.py --start DIR: without timeline and resolutions into another folder, with
  a start, for `hawser settle` to finish
"""

import argparse
import copy
import json
import math
import pathlib
import shutil

from make_anchor_adaptive import ROOT, dump, placed, resampled, rotated

NAME = "anchor_run"
WIRE_Z, PIN_X, PIN_R = 1.588, -37.0, 0.15  # axis of wires on deck and guide pins of anchor_contact
DECK_Z, PIN_TOP = 1.2, 3.0
WORK_Y, WORK_ELEMENT = 1.0, 2.5  # [m]
JAW = [-36.5, WORK_Y, 2.1]  # position of the shark jaw, on the path of the chain from anchor to roller [m]
JAW_LOAD = 7.35e6  # 750 t [N]
ANCHOR_HALF = [2.5, 1.9, 0.8]  # contact box of the anchor: it passes the pins of the tow wire [m]
PENDANT_Y, PENDANT, PENDANT_ELEMENTS = -1.9, 6.0, 3  # along the anchor's side [m]
CROSS_Y, CROSS_END, ABOVE = -2.6, -24.0, 0.12  # second tow wire: fairlead, rig; over the first [m]
TOW_TENSION, EA = 3.6e5, 2.33e8  # tension of tow2 at rest [N]
THRUST2 = 1.31e6  # two tow wires [N]
SPRINGS = [(25, -5), (-25, 5)]  # lines of the barge: x on ahts1, on the barge [m]
SPRING_EA = 2.76e7  # polyester of 80 mm, as in parts/lines.json [N]
STROP = {"EA": 2.76e7, "breaking_load": 1.971e6}  # polyester of 80 mm, too [N]
# Most of a mooring lies on the bed: four of its first elements of 6.2 m in one, waves of 3.5 s.
MOORING = {"max_length": 25.0, "wave_period": 3.5}
FLANGE = 1.5  # free height for incoming wire [m]


def step(at, what, **done):
    return {"at": at, "description": what} | done


def let_go(at, wire, what, end="last"):
    return step(at, what, detach={"wire": wire, "end": end})


def ends_with_lumps():
    """End lines in a node at the anchor, so that their whole length has contact."""
    out = []
    for wire, x in (("work1", ANCHOR_HALF[0]), ("chain1", -ANCHOR_HALF[0])):
        out += [let_go(0, wire, f"{wire} is let go, to get a shackle"),
                step(0, f"{wire} is shackled to the anchor",
                     attach={"wire": wire, "end": "last", "body": "anchor1", "point": [x, 0, 0.6],
                             "name": f"{wire}_shackle"})]
    return out


def timeline():
    speed = lambda v: {"work1_winch.mode": "speed", "work1_winch.speed": v}
    strop = {"gear": "shackle", "length": 1.0, "mass": 100, "reach": 1.5} | STROP
    return ends_with_lumps() + [
        step(5, "ahts1 goes astern along its wires",
             set={"tow1_winch.mode": "tension", "tow1_winch.tension": 1.5e5,
                  "ahts1/thrust_x": -550000, "ahts1/thrust_y": 35000} | speed(-0.7)),
        step(140, "the guide pins go down", set={"pin_port.up": 0, "pin_starboard.up": 0}),
        step(150, "the anchor comes to the roller: slowly",
             set=speed(-0.4) | {"ahts1/thrust_y": 0}),
        step(200, "the anchor is on deck: the winch stops", set=speed(0)),
        step(212, "the shark jaw takes the chain", set={"jaw.close": 1}),
        step(222, "the work wire is slackened", set=speed(0.3)),
        step(226, "the wire is slack: the winch stops", set=speed(0)),
        let_go(232, "work1", "the work wire is let go by the anchor"),
        let_go(232, "pendant", "the pendant is let go by the anchor", "first"),
        step(232, "wire and pendant are joined",
             join={"wire": "work1", "end": "last", "to": "pendant", "to_end": "first",
                   "name": "wire_strop"} | strop),
        let_go(242, "chain1", "the chain is let go by the anchor"),
        let_go(242, "pendant", "the pendant is let go by the anchor"),
        step(242, "pendant and chain are joined: wire is changed to chain",
             join={"wire": "pendant", "end": "last", "to": "chain1", "to_end": "last",
                   "name": "chain_strop"} | strop),
        step(250, "the wire is hauled in", set=speed(-0.3)),
        step(268, "the wire is hauled tight",
             set={"work1_winch.mode": "tension", "work1_winch.tension": 4e5}),
        step(285, "the winch holds", set=speed(0)),
        step(290, "the shark jaw lets go", set={"jaw.close": 0}),
        step(300, "the chain is run out", set=speed(0.7) | {"ahts1/thrust_x": -450000}),
        step(420, "the chain is out: the winch stops", set=speed(0)),
    ]


def with_gear(template):
    """Change ahts1: guide pins of the work wire become movable pins of the scene. Remove the spare
    wire at the final position of the anchor."""
    t = copy.deepcopy(template)
    hull = next(b for b in t["bodies"] if b["name"] == "hull")
    hull["shapes"] = [s for s in hull["shapes"] if not s["name"].startswith("work_pin")]
    t["cables"] = [c for c in t["cables"] if c["name"] != "spare_wire"]
    return t


def with_two_tows(template):
    """Change ahts2: add guide pins for the second tow wire, like those of the first one."""
    t = copy.deepcopy(template)
    hull = next(b for b in t["bodies"] if b["name"] == "hull")
    for k in (1, 2):
        pin = copy.deepcopy(next(s for s in hull["shapes"] if s["name"] == f"tow_pin{k}"))
        pin["name"] = f"cross_pin{k}"
        pin["position"][1] += CROSS_Y + 1.75
        hull["shapes"].append(pin)
    return t


def along(line, count):
    """Return the inner nodes of a line in equal elements."""
    ways = [0.0]
    for a, b in zip(line, line[1:]):
        ways.append(ways[-1] + math.dist(a, b))
    out, k = [], 0
    for i in range(1, count):
        at = ways[-1] * i / count
        while ways[k + 1] < at:
            k += 1
        share = (at - ways[k]) / (ways[k + 1] - ways[k])
        out.append([a + share * (b - a) for a, b in zip(line[k], line[k + 1])])
    return out, ways[-1]


def crossing_wire(scene, state):
    """Return a wire parallel to tow2 up to its pins, then to the other corner of the rig."""
    tow = next(c for c in scene["cables"] if c["name"] == "tow2")
    n, hull = tow["elements"], state["ahts2/hull"]
    place = lambda p: [a + b for a, b in zip(hull["p"], rotated(hull["q"], p))]
    wire = copy.deepcopy(tow) | {"name": "cross2"}
    wire["from"]["point"][1] = CROSS_Y
    wire["to"]["point"][1] = CROSS_END
    first, pin, last = placed(state, wire["from"]), place([PIN_X, CROSS_Y, WIRE_Z]), placed(
        state, wire["to"])
    line = [first, pin]
    for i in range(1, n):
        x, _, z = state[f"tow2/{i}"]["p"]
        share = (x - pin[0]) / (last[0] - pin[0])
        if share > 0.002:
            line.append([x, pin[1] + share * (last[1] - pin[1]),
                         z + ABOVE * min(1.0, 10 * (1 - share))])
    nodes, way = along(line + [last], n)
    wire["length"] = round(way / (1 + TOW_TENSION / EA), 4)
    wire["shape"] = [[round(x, 4) for x in p] for p in nodes]
    state |= {f"cross2/{i + 1}": {"p": p} for i, p in enumerate(nodes)}
    state["cross2_winch/drum"] = {"p": [0, 0, 0]}
    scene["cables"].append(wire)
    drum = copy.deepcopy(next(w for w in scene["winches"] if w["cable"] == "tow2"))
    scene["winches"].append(drum | {"name": "cross2_winch", "cable": "cross2",
                                    "element": wire["length"] / n})


def pendant(scene, state):
    """Return the slack pendant along the anchor, from its wire to its chain."""
    x, z = ANCHOR_HALF[0], 0.6
    each = PENDANT / PENDANT_ELEMENTS
    aside = x - each / 2
    drop = math.sqrt(each**2 - aside**2)
    nodes = [placed(state, {"body": "anchor1", "point": [s * each / 2, PENDANT_Y, z - drop]})
             for s in (1, -1)]
    scene["cables"].append(
        {"name": "pendant", "line_type": "wire76", "consistent_mass": True,
         "from": {"body": "anchor1", "point": [x, PENDANT_Y, z]},
         "to": {"body": "anchor1", "point": [-x, PENDANT_Y, z]},
         "length": PENDANT, "elements": PENDANT_ELEMENTS,
         "shape": [[round(v, 4) for v in p] for p in nodes],
         "contact": {"material": "wire", "groups": "wires", "touches": "ship"}})
    state |= {f"pendant/{i + 1}": {"p": p} for i, p in enumerate(nodes)}


def deck_gear(scene):
    scene["pins"] = [
        {"name": f"pin_{side}", "on": "ahts1/hull", "from": [PIN_X, WORK_Y + y, DECK_Z],
         "to": [PIN_X, WORK_Y + y, PIN_TOP], "radius": PIN_R, "friction": 0.2, "speed": 0.1,
         "force": 2e5, "material": "roller", "groups": "ship"}
        for side, y in (("port", 0.7), ("starboard", -0.2))]
    scene["stoppers"] = [{"name": "jaw", "on": "ahts1/hull", "point": JAW, "reach": 1.0,
                          "rated_load": JAW_LOAD}]


def lashed_barge(scene):
    """Connect the barge by springs, because friction on fenders alone would not move it."""
    for k, (ship, barge) in enumerate(SPRINGS):
        scene["interactions"].append(
            {"name": f"barge_spring{k + 1}", "kind": "stretch", "bodies": ["ahts1/hull", "barge"],
             "points": [[ship, 9, 2], [barge, -7, 2]], "EA": SPRING_EA})


def changed_lines(scene):
    for c in scene["cables"]:
        if c["name"] in ("tow2", "cross2"):
            c["contact"]["touches"] = ["ship", "wires"]
        if c["name"].startswith("mooring"):
            c["resolution"] |= MOORING
        if c["name"] == "work1":
            del c["resolution"]  # the whole wire runs over the roller
        if c["name"] == "chain1":
            c["contact"] = {"material": "chain", "groups": "wires", "touches": "ship"}


def changed_bodies(scene):
    scene["templates"] |= {"runner": with_gear(scene["templates"]["handler"]),
                           "tower": with_two_tows(scene["templates"]["handler"])}
    del scene["templates"]["handler"]
    for i in scene["instances"]:
        if i["template"] == "handler":
            i["template"] = {"ahts1": "runner", "ahts2": "tower"}[i["name"]]
        if i["name"] == "ahts2":
            i["parameters"]["thrust"] = THRUST2
    for b in scene["bodies"]:
        if b["name"] == "anchor1":
            b["shapes"] = [{"kind": "box", "half_size": ANCHOR_HALF, "material": "anchor",
                            "groups": "deck_cargo", "touches": "ship"}]
    for w in scene["winches"]:
        if w["name"] in ("work1_winch", "tow1_winch"):
            w["flange_radius"] = FLANGE


def made(start, fine, elements=()):
    """Return the scene and the positions of its bodies. Its site is an old version of
    anchor_adaptive: wires touch the rollers without guides."""
    scene = json.loads((ROOT / "parts" / "anchor_run.site.json").read_text())
    state = json.loads((ROOT / "parts" / "anchor_run.site.settled.json").read_text())["bodies"]
    work = next(c for c in scene["cables"] if c["name"] == "work1")
    resampled(work, state, round(work["length"] / WORK_ELEMENT))
    drum = next(w for w in scene["winches"] if w["cable"] == "work1")
    drum["element"] = work["length"] / work["elements"]
    crossing_wire(scene, state)
    pendant(scene, state)
    changed_bodies(scene)
    changed_lines(scene)
    deck_gear(scene)
    lashed_barge(scene)
    for body in [b for b in state if b.startswith("ahts1/spare_wire/")]:
        del state[body]
    if not start:
        state = json.loads((ROOT / f"{NAME}.settled.json").read_text())["bodies"]
        scene["timeline"] = timeline()
    if start or fine:
        for c in scene["cables"]:
            c.pop("resolution", None)
    if fine:
        for c in scene["cables"]:
            if c["name"] not in ("pendant", "work1"):
                resampled(c, state, max(2, round(c["length"] / 2.5)))
        for name, length in elements:
            c = next(c for c in scene["cables"] if c["name"] == name)
            if round(c["length"] / length) != c["elements"]:
                resampled(c, state, round(c["length"] / length))
        for w in scene["winches"]:
            cable = next(c for c in scene["cables"] if c["name"] == w["cable"])
            w["element"] = cable["length"] / cable["elements"]
    return scene, state


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--fine", action="store_true")
    options.add_argument("--start", type=pathlib.Path)
    options.add_argument("--element", action="append", default=[], metavar="LINE=LENGTH",
                         type=lambda text: (text.split("=")[0], float(text.split("=")[1])))
    options.add_argument("--to", type=pathlib.Path)
    given = options.parse_args()
    if given.element and not (given.fine and given.to):
        options.error("--element goes with --fine and --to: scenes/ keeps the frozen ones")
    scene, state = made(given.start is not None, given.fine, given.element)
    name = f"{NAME}_fine" if given.fine else NAME
    scene |= {
        "name": name,
        "description": " ".join(__doc__.split("\n\n")[1].split()) +
                       " See docs/anchor_run.md and scripts/make_anchor_run.py.",
        "settings": {"duration": 600},
        "plot": {"tensions": ["work1", "chain1", "tow2", "cross2"],
                 "motions": ["ahts1/hull", "anchor1"]},
        "outputs": [{"name": f"{body.split('/')[0]}_{c}", "kind": "pose", "body": body,
                     "component": c, "group": body}
                    for body in ("anchor1", "ahts1/hull") for c in ("x", "y", "z", "pitch", "yaw")],
        "state": {"file": f"{name}.settled.json"}}
    folder = given.start or given.to or ROOT
    if folder != ROOT:
        shutil.copytree(ROOT / "parts", folder / "parts", dirs_exist_ok=True)
    if given.start or given.fine:
        (folder / f"{name}.settled.json").write_text(dump(
            {"version": 1, "scene": name, "bodies": state}))
    (folder / f"{name}.json").write_text(dump(scene))
    print(f"{len(scene['cables'])} cables of {sum(c['elements'] for c in scene['cables'])} elements "
          f"beside those on deck, {len(scene['winches'])} winches")


if __name__ == "__main__":
    main()
