#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run clang-tidy on the C++ files that changed.

usage: tidy.py [--build DIR] [--base REF] [--all] [--budget SECONDS] [FILE...]

Changed files are those since the base commit of scripts/affected.py and those of the work tree. The
latest change is checked first. A changed header is checked through sources of its name and sources
that include it directly.
Kernels (src/*/isa) are left out: they use vector extensions of g++ that clang does not support.

Reading headers takes most of the time of clang-tidy. It therefore checks up to 12 sources with the
same compiler options as one unit, which includes them. A unit that does not compile (two sources
may define the same name) is checked source by source.
Files left when the budget is used up are counted by folder and are no error: a large change must not exceed
the time limit of continuous integration.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from affected import base_commit, git  # noqa: E402

TOOL = "clang-tidy-19"
ROOT = pathlib.Path(__file__).resolve().parent.parent
BATCH = 12  # sources of a unit
# Sources of a unit count as headers, whose findings a filter selects. A local name may be one of
# namespace scope in another source of the unit.
UNIT_OPTIONS = ["--extra-arg=-Wno-shadow",
                r"--header-filter=.*/(include/hawser|src|apps|bench|tests|examples)/.*\.(h|cpp)$",
                "--checks=-bugprone-suspicious-include"]


def changed_files(base: str | None) -> list[str]:
    """Return changed files that still exist, the latest change first."""
    if base is None:
        return git("ls-files")
    names = git("diff", "--name-only", "HEAD")
    names += git("log", "--format=", "--name-only", f"{base}..HEAD")
    there = set(git("diff", "--name-only", "--diff-filter=d", base))
    return [name for name in dict.fromkeys(names) if name in there]


def sources_to_check(changed: list[str], compiled: list[str]) -> list[str]:
    """Return compiled sources that changed, or whose direct includes or own header changed."""
    headers = {name for name in changed if name.endswith(".h")}
    spelled = {h.split("/", 1)[1] for h in headers if "/" in h}
    chosen = []
    for source in compiled:
        text = (ROOT / source).read_text(encoding="utf-8")
        own = str(pathlib.PurePath(source).with_suffix(".h"))
        includes = any(f'"{s}"' in text or f"<{s}>" in text for s in spelled)
        if source in changed or own in headers or includes:
            chosen.append(source)
    # Sources of the library first: others read JSON, options and test frameworks, a minute each.
    # Then changed files, the latest leading: they matter most when the budget ends.
    rank = {name: k for k, name in enumerate(changed)}
    return sorted(
        chosen, key=lambda s: (not s.startswith("src/"), rank.get(s, len(rank)), s))


def batches(todo: list[str], commands: list[dict]) -> list[list[str]]:
    """Group sources by compiler options and test configuration. Keeps the order of first sources."""
    options = {os.path.relpath(c["file"], ROOT): re.sub(r" -o \S+ -c \S+$", "", c["command"])
               for c in commands}
    full, growing = [], {}
    for source in todo:
        key = (options[source], source.startswith("tests/"))
        batch = growing.get(key)
        if batch is None or len(batch) == BATCH:
            growing[key] = batch = []
            full.append(batch)
        batch.append(source)
    return full


def write_units(groups: list[list[str]], commands: list[dict], build: pathlib.Path) -> list[str]:
    """Write a source and a compile command per group. Return the paths of the sources."""
    folder = build / "tidy"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "tests").mkdir(parents=True)
    shutil.copy(ROOT / "tests/.clang-tidy", folder / "tests")
    by_file = {os.path.relpath(c["file"], ROOT): c for c in commands}
    units, written = [], []
    for number, group in enumerate(groups):
        test = group[0].startswith("tests/")
        unit = folder / ("tests" if test else "") / f"unit{number}.cpp"
        unit.write_text("".join(f'#include "{ROOT / source}"\n' for source in group))
        command = by_file[group[0]]
        written.append({"directory": command["directory"], "file": str(unit),
                        "command": command["command"].replace(command["file"], str(unit))})
        units.append(str(unit))
    (folder / "compile_commands.json").write_text(json.dumps(written))
    return units


def run_tool(build: pathlib.Path, path: str, more: list[str]) -> tuple[int, str]:
    """Run clang-tidy on one source. Return its exit status and output."""
    done = subprocess.run([TOOL, "--quiet", "--extra-arg=-Wno-unknown-warning-option", *more,
                           "-p", str(build), path], cwd=ROOT, capture_output=True, text=True)
    return done.returncode, done.stdout + (done.stderr if done.returncode else "")


def check_group(build: pathlib.Path, group: list[str], unit: str) -> tuple[int, str]:
    """Check the sources of a group as one unit, or one by one if the unit does not compile."""
    if len(group) > 1:
        status, output = run_tool(build / "tidy", unit, UNIT_OPTIONS)
        if "[clang-diagnostic-error" not in output:
            return status, output
    results = [run_tool(build, source, []) for source in group]
    return max(status for status, _ in results), "".join(output for _, output in results)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default="build/relassert", help="folder of compile_commands.json")
    parser.add_argument("--base", help="compare with this commit")
    parser.add_argument("--all", action="store_true", help="check every compiled file")
    parser.add_argument("--budget", type=float, default=1e9, help="start no file after this [s]")
    parser.add_argument("files", nargs="*")
    options = parser.parse_args()

    commands = json.loads((ROOT / options.build / "compile_commands.json").read_text())
    compiled = sorted({os.path.relpath(c["file"], ROOT) for c in commands})
    compiled = [c for c in compiled if not c.startswith(("..", "build/")) and "/isa/" not in c]
    if options.files:
        todo = [f for f in compiled if f in options.files]
    elif options.all:
        todo = compiled
    else:
        todo = sources_to_check(changed_files(base_commit(options.base)), compiled)

    build = ROOT / options.build
    groups = batches(todo, commands)
    units = write_units(groups, commands, build)
    start = time.monotonic()

    def check(number: int) -> tuple[int | None, str]:
        if time.monotonic() - start > options.budget:
            return None, ""
        return check_group(build, groups[number], units[number])

    failed, skipped, checked = 0, [], 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for group, (status, output) in zip(groups, pool.map(check, range(len(groups)))):
            if status is None:
                skipped += group
                continue
            checked += len(group)
            if status != 0:
                failed += 1
                print(output, flush=True)
    if skipped:
        folders = collections.Counter(os.path.dirname(name) for name in skipped)
        print(f"not checked, {options.budget:.0f} s were spent:",
              ", ".join(f"{folder} ({count})" for folder, count in sorted(folders.items())))
    print(f"clang-tidy: {checked} files checked in units of up to {BATCH}, {failed} units with "
          f"findings, {len(skipped)} files not checked, {time.monotonic() - start:.0f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
