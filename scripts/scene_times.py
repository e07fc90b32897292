#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Print step times of the benchmark scenes without inputs, on one and two threads.

    scripts/scene_times.py PROGRAM [--duration 60] [--rounds 3] [SCENE ...]

Columns are wall time and processor time of a step [ms]: median, 99th percentile, maximum. Each is
the lowest of several rounds in turns, because other processes only add time. Measure on an idle
machine; the last line states its load.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = ["bench/scenes/frozen/anchor_lines.json", "bench/scenes/frozen/anchor_contact.json",
          "bench/scenes/frozen/anchor_sea.json", "scenes/anchor_seaway.json"]
THREADS = (1, 2)


def figures_of(program, scene, duration, threads):
    with tempfile.TemporaryDirectory() as folder:
        summary = pathlib.Path(folder) / "summary.json"
        done = subprocess.run([program, "run", scene, "--duration", str(duration), "--quiet",
                               "--threads", str(threads), "--summary", str(summary)],
                              cwd=ROOT, capture_output=True, text=True)
        if done.returncode != 0 or not summary.exists():
            sys.exit(f"{program} run {scene}: exit code {done.returncode}\n{done.stderr}")
        return json.loads(summary.read_text(encoding="utf-8"))


def row_of(rounds):
    """Return the lowest of each figure over the rounds."""
    row = []
    for key in ("step_ms", "step_cpu_ms"):
        for part in ("median", "p99", "max"):
            row.append(min(f[key][part] for f in rounds))
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="*", default=SCENES)
    parser.add_argument("--duration", type=float, default=60.0)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    program = str(pathlib.Path(given.program).resolve())
    print("| scene | threads | median | p99 | worst | median, CPU | p99, CPU | worst, CPU |")
    print("|---|---|---|---|---|---|---|---|")
    runs = [(scene, threads) for scene in given.scenes for threads in THREADS]
    rounds = {run: [] for run in runs}
    for _ in range(given.rounds):
        for scene, threads in runs:
            rounds[scene, threads].append(figures_of(program, scene, given.duration, threads))
    for scene, threads in runs:
        cells = [f"{value:.2f}" for value in row_of(rounds[scene, threads])]
        print(f"| {pathlib.Path(scene).stem} | {threads} | " + " | ".join(cells) + " |")
    print(f"\n{given.duration:g} s a run, {given.rounds} rounds, step 1/60 s, "
          f"load {os.getloadavg()[0]:.2f} at the end, {os.cpu_count()} processors")


if __name__ == "__main__":
    main()
