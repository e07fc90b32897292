#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compare the time of a step between two programs, on the same scene files, in turns.

usage: scripts/compare_speed.py BEFORE AFTER [--runs 11] [--duration S] [SCENE...]

BEFORE and AFTER are programs `hawser` of two builds. Prints for each scene the median step of both
[ms] (median over the runs), their ratio, and whether the hashes of the final states are equal.
Exit code 1 if a ratio is above --limit (default 1.03).
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = ["scenes/heavy_hook", "scenes/tow_zigzag", "bench/scenes/frozen/anchor_lines",
          "bench/scenes/frozen/anchor_contact", "bench/scenes/frozen/anchor_sea",
          "scenes/anchor_seaway"]


def run(program: str, scene: str, duration: float) -> tuple[float, str]:
    """Return the median processor time of a step [ms] and the hash of the final state."""
    with tempfile.TemporaryDirectory() as folder:
        summary = pathlib.Path(folder) / "summary.json"
        done = subprocess.run([program, "run", scene, "--duration", str(duration), "--quiet",
                               "--summary", str(summary)], cwd=ROOT, capture_output=True, text=True)
        if not summary.exists():
            sys.exit(f"{program} run {scene}: exit code {done.returncode}\n{done.stderr}")
        figures = json.loads(summary.read_text(encoding="utf-8"))
    return figures["step_cpu_ms"]["median"], figures["state_hash"]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("scenes", nargs="*", default=[f"{s}.json" for s in SCENES])
    parser.add_argument("--runs", type=int, default=11)
    parser.add_argument("--duration", type=float, default=5.0)
    parser.add_argument("--limit", type=float, default=1.03)
    options = parser.parse_intermixed_args()
    programs = [str(pathlib.Path(p).resolve()) for p in (options.before, options.after)]
    slow = 0
    for scene in options.scenes:
        times: list[list[float]] = [[], []]
        hashes = ["", ""]
        for turn in range(options.runs):
            for side in (0, 1) if turn % 2 == 0 else (1, 0):
                median, hashes[side] = run(programs[side], scene, options.duration)
                times[side].append(median)
        before, after = (statistics.median(t) for t in times)
        ratio = after / before
        slow += ratio > options.limit
        print(f"{pathlib.Path(scene).stem:24} {before:9.4f} {after:9.4f} ms  ratio {ratio:.3f}  "
              f"state {'equal' if hashes[0] == hashes[1] else 'differs'}", flush=True)
    return 1 if slow else 0


if __name__ == "__main__":
    sys.exit(main())
