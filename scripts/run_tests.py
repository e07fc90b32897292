#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Build and run the tests of a tier, and print the ten slowest suites.

usage: scripts/run_tests.py [--tier quick|full|long] [--preset PRESET] [--jobs N]
                            [--since COMMIT | --folders NAME...]

Options:
- --tier: a tier includes the smaller ones; HAWSER_SEED=N repeats the seed of a random suite
- --since: only tests that the changes since COMMIT can reach (scripts/affected.py)
- --folders: only tests/NAME...

The preset must have been configured. Prints wall and processor time of building and running. Exit
codes: 0 all passed, 1 a test failed, 2 the build failed or there is nothing to run.
"""
from __future__ import annotations

import argparse
import collections
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import affected  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
TIERS = ["quick", "full", "long"]
SLOWEST = 10


class Clock:
    """Wall and processor time since its creation, including child processes."""

    def __init__(self) -> None:
        self.wall, self.processor = time.monotonic(), self.used()

    @staticmethod
    def used() -> float:
        use = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
        return sum(u.ru_utime + u.ru_stime for u in use)

    def __str__(self) -> str:
        return f"{time.monotonic() - self.wall:.0f} s, processor {self.used() - self.processor:.0f} s"


def targets(folders: list[str] | None, tier: str) -> list[str]:
    """Return the targets for the tests. Tests of larger tiers start hawser-bench, too."""
    if folders is None:
        return ["hawser_quick_tests" if tier == "quick" else "hawser_full_tests"]
    return [f"hawser_test_{f}" for f in folders]


def slowest_suites(path: pathlib.Path) -> list[str]:
    """Return the lines of a table of the suites with the largest processor time."""
    wall: dict[str, float] = collections.defaultdict(float)
    processor: dict[str, float] = collections.defaultdict(float)
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else []:
        program, suite, *times = line.split()
        name = f"{program.removeprefix('hawser_test_')}.{suite}"
        wall[name] += float(times[0])
        processor[name] += float(times[1])
    order = sorted(processor, key=processor.__getitem__, reverse=True)[:SLOWEST]
    return [f"  {wall[n]:7.1f} s wall {processor[n]:7.1f} s processor  {n}" for n in order]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--tier", choices=TIERS, default="quick")
    parser.add_argument("--preset", default="release")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument("--since", metavar="COMMIT")
    chosen.add_argument("--folders", nargs="+", metavar="NAME")
    options = parser.parse_args()

    folders, everything = options.folders, not options.folders
    if options.since:
        base = affected.base_commit(options.since)
        changed = affected.folders_of(affected.changed_files(base))
        everything = affected.EVERYTHING in changed
        folders = [f for f in affected.tests_of(changed)
                   if options.tier != "quick" or f not in affected.FULL_ONLY]
        print(f"changed since {base[:8]}: {' '.join(sorted(changed)) or 'nothing'}")
        print(f"tests that this reaches: {' '.join(folders) or 'none'}", flush=True)
        if not folders and "scripts" not in changed:
            return 0
    if everything:
        folders = None
    unknown = set(folders or []) - set(affected.test_folders())
    if unknown:
        print(f"no folder tests/{', tests/'.join(sorted(unknown))}", file=sys.stderr)
        return 2

    build = ROOT / "build" / options.preset
    if not (build / "build.ninja").exists():
        print(f"run first: cmake --preset {options.preset}", file=sys.stderr)
        return 2
    clock = Clock()
    names = targets(folders, options.tier)
    if names and subprocess.run(["cmake", "--build", build, "-j", str(options.jobs), "--target",
                                 *names], cwd=ROOT).returncode != 0:
        return 2
    print(f"=== build: {clock}", flush=True)

    clock = Clock()
    labels = "|".join(TIERS[:TIERS.index(options.tier) + 1])
    command = ["ctest", "--preset", options.preset, "-L", f"^({labels})$", "-j", str(options.jobs),
               "--output-on-failure", "--no-tests=error"]
    if folders is not None:
        entries = [re.escape(f) + r"\." for f in folders]
        if options.since:
            entries.append(r"scripts$")
        command += ["-R", f"^({'|'.join(entries)})"]
    with tempfile.TemporaryDirectory() as folder:
        times = pathlib.Path(folder) / "times"
        environment = dict(os.environ, HAWSER_TIER=options.tier, HAWSER_TEST_TIMES=str(times))
        status = subprocess.run(command, cwd=ROOT, env=environment).returncode
        print(f"=== tests: {clock}; slowest suites:")
        print(*slowest_suites(times), sep="\n", flush=True)
    return 0 if status == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
