#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Compare exports of a recording with the recording, by separate code.

    scripts/check_export.py RUN.hwr [RUN.glb] [RUN.pvd]

- The recording is read by docs/recording.md.
- The .glb is read by the glTF 2.0 specification.
- The .vtp is read by VTK's own reader (Debian's python3-vtk9).

Poses of bodies and tensions of wires in every exported frame must equal the recording's numbers in
single precision. Recordings of scenes whose bodies or nodes change (chunks BODS, WIRE) are rejected.
"""
import json
import struct
import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

FLOATS = {0: 7, 1: 3, 2: 1, 3: 0, 4: 7}


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def get(self, form):
        out = struct.unpack_from("<" + form, self.data, self.at)
        self.at += struct.calcsize("<" + form)
        return out if len(out) > 1 else out[0]

    def text(self):
        n = self.get("I")
        self.at += n
        return self.data[self.at - n:self.at].decode()


class Recording:
    def __init__(self, file):
        data = Path(file).read_bytes()
        assert data[:8] == b"HAWSERRC", "no recording"
        at, self.frames = 12, []
        while at < len(data):
            kind, n = data[at:at + 4], struct.unpack_from("<I", data, at + 4)[0]
            payload = data[at + 8:at + 8 + n]
            at += 12 + n
            if kind == b"LAYT":
                self.layout(Reader(payload))
            elif kind == b"FRAM":
                self.frames.append(payload)
            elif kind in (b"BODS", b"WIRE"):
                sys.exit(f"{file}: bodies or nodes come and go: not compared here")

    def layout(self, r):
        self.bodies, self.cables = [], []
        for _ in range(r.get("I")):
            name, kind = r.text(), r.get("B")
            r.get("3d")
            self.bodies.append((name, kind, np.array(r.get("3d")), np.array(r.get("4d"))))
        for _ in range(r.get("I")):
            name, _line = r.text(), r.text()
            ea = r.get("3d")[0]
            nodes = [r.get("i") for _ in range(r.get("I"))]
            r.get("6d")
            self.cables.append((name, ea, nodes, r.get("I")))

    def time(self, i):
        return struct.unpack_from("<d", self.frames[i], 8)[0]

    def frame(self, i):
        """Return time, {body: (position, quaternion w x y z)}, [tension of each element]."""
        r = Reader(self.frames[i])
        _step, time = r.get("q"), r.get("d")
        r.get("Q3d")
        values = np.frombuffer(r.data, "<f4", offset=r.at)
        poses, at = {}, 0
        for k, (_, kind, start, turn) in enumerate(self.bodies):
            n = FLOATS[kind]
            p, q = start.copy(), turn
            p[:min(n, 3)] += values[at:at + min(n, 3)]
            if n == 7:
                q = values[at + 3:at + 7]
            poses[k] = (p, q)
            at += n
        return time, poses, values[at:]


def check_glb(recording, file):
    data = Path(file).read_bytes()
    size = struct.unpack_from("<I", data, 12)[0]
    doc, buffer = json.loads(data[20:20 + size]), data[28 + size:]

    def numbers(index):
        a = doc["accessors"][index]
        v = doc["bufferViews"][a["bufferView"]]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[a["type"]]
        return np.frombuffer(buffer, "<f4", a["count"] * width, v["byteOffset"]).reshape(-1, width)

    animation = doc["animations"][0]
    channels = {}
    for c in animation["channels"]:
        s = animation["samplers"][c["sampler"]]
        channels[doc["nodes"][c["target"]["node"]]["name"], c["target"]["path"]] = (s["input"], s["output"])
    times = numbers(next(iter(channels.values()))[0])[:, 0]
    start = recording.time(0)
    by_time = {np.float32(recording.time(i) - start): i for i in range(len(recording.frames))}
    some = slice(None, None, max(1, len(times) // 400))
    chosen = [by_time[t] for t in times[some]]
    names = {name: k for k, (name, *_rest) in enumerate(recording.bodies)}
    frames = [recording.frame(i) for i in chosen]
    compared = 0
    for (name, path), (_, output) in channels.items():
        if name in names and path in ("translation", "rotation"):
            got = numbers(output)[some]
            k = names[name]
            want = np.array([f[1][k][0] if path == "translation" else np.roll(f[1][k][1], -1)
                             for f in frames]).astype("<f4")
        elif "@" in name:
            cable, joint = name.rsplit("@", 1)
            nodes = next(c[2] for c in recording.cables if c[0] == cable)
            nodes = [n for n in nodes if recording.bodies[n][1] != 2]
            if recording.bodies[nodes[int(joint)]][1] != 1:
                continue  # an end on a body: a point of its frame
            got = numbers(output)[some]
            want = np.array([f[1][nodes[int(joint)]][0] for f in frames]).astype("<f4")
        else:
            continue
        assert got.shape == want.shape and np.array_equal(got, want), (name, path)
        compared += got.size
    print(f"{file}: {len(chosen)} of {len(times)} frames, {compared} numbers equal")


def check_vtk(recording, file):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    folder, compared, count = Path(file).parent, 0, 0
    by_time = {round(recording.time(i), 9): i for i in range(len(recording.frames))}
    for item in ElementTree.parse(file).getroot().iter("DataSet"):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(folder / item.get("file")))
        reader.Update()
        poly = reader.GetOutput()
        assert reader.GetErrorCode() == 0 and poly.GetNumberOfCells() > 0
        cells = {name: vtk_to_numpy(poly.GetCellData().GetArray(name))
                 for name in ("kind", "index", "tension", "strain", "orientation", "parted")}
        time, poses, tensions = recording.frame(by_time[round(float(item.get("timestep")), 9)])
        points = vtk_to_numpy(poly.GetPoints().GetData())
        verts = vtk_to_numpy(poly.GetVerts().GetConnectivityArray())
        for cell in np.flatnonzero(cells["kind"] == 0):
            position, turn = poses[cells["index"][cell]]
            assert np.array_equal(points[verts[cell]], position), (time, cell)
            assert np.array_equal(cells["orientation"][cell], np.float32(turn)), (time, cell)
            compared += 7
        first, wire = 0, cells["kind"] == 2
        for w, (name, ea, nodes, elements) in enumerate(recording.cables):
            own = np.flatnonzero(wire & (cells["index"] == w))
            want = tensions[first:first + elements][-len(own):] if len(own) else []
            assert np.array_equal(cells["tension"][own], want), (time, name)
            if ea > 0:
                assert np.array_equal(cells["strain"][own], (want.astype("f8") / ea).astype("f4"))
            first += elements
            compared += 2 * len(own)
        count += 1
    print(f"{file}: {count} frames, {compared} numbers equal")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    recording = Recording(sys.argv[1])
    for file in sys.argv[2:]:
        (check_glb if file.endswith(".glb") else check_vtk)(recording, file)


if __name__ == "__main__":
    main()
