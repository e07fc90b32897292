# SPDX-License-Identifier: Apache-2.0
"""Write a scene document as JSON with one body, interaction or cable per line."""

import json
import math
import pathlib

SCENES = pathlib.Path(__file__).resolve().parent.parent / "scenes"


def clean(value):
    """Return whole numbers without a fraction, no negative zero; other values unchanged."""
    if isinstance(value, dict):
        return {key: clean(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [clean(item) for item in value]
    if isinstance(value, float):
        if not math.isfinite(value):
            raise ValueError("a scene holds finite numbers only")
        if value == int(value) and abs(value) < 1e6:
            return int(value)
    return value


def write(document):
    """Write scenes/NAME.json, NAME being the document's name."""
    document = clean({"$schema": "../schema/scene-1.json", "version": 1, **document})
    lines = []
    for key, value in document.items():
        if isinstance(value, list) and value and isinstance(value[0], (dict, list)):
            inner = ",\n    ".join(json.dumps(item) for item in value)
            text = f"[\n    {inner}\n  ]"
        elif isinstance(value, dict) and len(json.dumps(value)) > 90:
            inner = ",\n    ".join(f"{json.dumps(k)}: {json.dumps(v)}" for k, v in value.items())
            text = f"{{\n    {inner}\n  }}"
        else:
            text = json.dumps(value)
        lines.append(f"  {json.dumps(key)}: {text}")
    path = SCENES / (document["name"] + ".json")
    path.write_text("{\n" + ",\n".join(lines) + "\n}\n")
    print(path.name)


def rotation(axis, angle):
    """Return the quaternion [w, x, y, z] of a rotation by `angle` [rad] about a unit axis."""
    s = math.sin(angle / 2.0)
    return [math.cos(angle / 2.0), axis[0] * s, axis[1] * s, axis[2] * s]


def cylinder(mass, radius, length):
    """Return the inertia [kg m²] of a solid cylinder along x, about its centre."""
    across = mass * (3.0 * radius**2 + length**2) / 12.0
    return [mass * radius**2 / 2.0, across, across]
