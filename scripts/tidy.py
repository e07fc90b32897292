#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run clang-tidy on the C++ files that changed.

usage: tidy.py [--build DIR] [--base REF] [--all] [--budget SECONDS] [FILE...]

Changed files are those since the base commit of scripts/affected.py and those of the work tree. The
latest change is checked first. A changed header is checked through sources of its name and sources
that include it directly.
Kernels (src/*/isa) are left out: they use vector extensions of g++ that clang does not support.
Files left when the budget is used up are listed and are no error: a large change must not exceed
the time limit of continuous integration.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from affected import base_commit, git  # noqa: E402

TOOL = "clang-tidy-19"
ROOT = pathlib.Path(__file__).resolve().parent.parent


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

    start = time.monotonic()

    def check(path: str) -> tuple[str, int | None, str]:
        if time.monotonic() - start > options.budget:
            return path, None, ""
        done = subprocess.run([TOOL, "--quiet", "--extra-arg=-Wno-unknown-warning-option",
                               "-p", options.build, path], cwd=ROOT,
                              capture_output=True, text=True)
        return path, done.returncode, done.stdout + (done.stderr if done.returncode else "")

    failed, skipped = [], []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, status, output in pool.map(check, todo):
            if status is None:
                skipped.append(path)
            elif status != 0:
                failed.append(path)
                print(output)
    if skipped:
        print(f"not checked, {options.budget:.0f} s were spent:", *skipped, sep="\n  ")
    print(f"clang-tidy: {len(todo) - len(skipped)} files checked, {len(failed)} with findings, "
          f"{len(skipped)} not checked, {time.monotonic() - start:.0f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
