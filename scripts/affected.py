#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""List the folders that a change touches and the tests that it can reach.

usage: scripts/affected.py [--since COMMIT] [--print WHAT]

The change: all commits since COMMIT and the uncommitted files. Without --since the base commit is
  1. the merge base with origin/main, if it is older than HEAD; else
  2. the last commit that is at least six hours older than HEAD; else
  3. none: everything counts as changed.
Everything also counts as changed if files of src/base, src/model or of the build changed.

Folder A uses folder B if the table of layers (docs/architecture.md) permits A to include B. It also
does if A includes a public header that B implements. A test folder is reached by a change if it uses a
changed folder directly or through others.

Values of --print:
- summary: base commit, changed folders, reached test folders (default)
- base: hash of the base commit, empty if there is none
- changed: changed folders; `everything` if all count
- tests: reached test folders, nearest first
- sanitized: test folders for the sanitizers, without those that start the program. These are
  folders that use a changed folder directly. Readers of foreign bytes and base rooms are always
  included.
"""
from __future__ import annotations

import argparse
import functools
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import check_layers  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
HOURS = 6
EVERYTHING = "everything"
# Rooms in the order of the libraries, each built upon those before. A public header is implemented
# by the rooms of the first group that include it; the headers in hawser/hawser.h by the library.
SYSTEMS = {"wire", "crane", "marine", "vessel"}
CLIENTS = [{"scene"}, {"session", "record", "verify", "exercise"},
           {"report", "draw", "export", "debrief"}, {"live"}, {"validate"}]
# Files whose change affects every test.
BUILD = re.compile(r"^(cmake/|CMakeLists\.txt$|CMakePresets\.json$|Makefile$|\.ci/|examples/|"
                   r"tests/consumer/|scripts/(packages\.txt|install_packages\.sh|affected\.py)$)")
BASE_ROOMS = {"base", "model"}
# Tests of readers and of base rooms: sanitizers run them after each change.
ALWAYS_SANITIZED = {"files", "scene", "record", "live", "exercise", "model", "runtime", "factor",
                    "graph"}
# Tests that start the program. The gate does not build an instrumented one; check-full does.
PROGRAM_TESTS = {"cli", "validate", "golden"}
# Folders without quick tests: see HAWSER_FULL_TESTS in cmake/HawserTests.cmake.
FULL_ONLY = {"bench", "slow"}
DATA = {"scenes", "exercises", "schema", "docs"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.MULTILINE)


def git(*arguments: str) -> list[str]:
    """Return the lines that git prints; none if it fails."""
    done = subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True)
    return done.stdout.splitlines() if done.returncode == 0 else []


def base_commit(given: str | None = None) -> str | None:
    """Return the first commit of the comparison, see above. None: there is no such commit."""
    if given:
        found = git("rev-parse", "--verify", "--quiet", f"{given}^{{commit}}")
        if not found:
            sys.exit(f"affected.py: git knows no commit '{given}'")
        return found[0]
    head = git("rev-parse", "HEAD")
    base = git("merge-base", "HEAD", "origin/main")
    if base and base != head:
        return base[0]
    time = git("log", "-1", "--format=%ct", "HEAD")
    if not time:
        return None
    old = git("rev-list", "-1", f"--before={int(time[0]) - HOURS * 3600}", "HEAD")
    return old[0] if old else None


def changed_files(base: str | None) -> list[str] | None:
    """Return the files changed since the base commit, uncommitted ones included. None: all."""
    if base is None:
        return None
    names = git("diff", "--name-only", "--no-renames", base)
    names += git("ls-files", "--others", "--exclude-standard")
    return sorted(set(names))


@functools.cache
def texts(folder: str) -> dict[str, str]:
    """Path -> text of the C++ files below a folder."""
    return {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8")
            for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".cpp", ".h")}


def included(sources: dict[str, str]) -> tuple[set[str], set[str]]:
    """Return names that texts include: own headers "ROOM/FILE.h", public headers <hawser/NAME>."""
    found = {match for text in sources.values() for match in INCLUDE.findall(text)}
    return ({name for kind, name in found if kind == '"' and "/" in name},
            {name.removeprefix("hawser/") for kind, name in found if name.startswith("hawser/")})


def with_support(sources: dict[str, str]) -> dict[str, str]:
    """Return the texts of a test folder and of the files of tests/support that they include."""
    support = texts("tests/support")
    taken = dict(sources)
    while True:
        names = {name for name in included(taken)[0] if name.startswith("support/")}
        more = {path: text for path, text in support.items() if path not in taken and
                (path.removeprefix("tests/").rsplit(".", 1)[0] + ".h") in names}
        if not more:
            return taken
        taken.update(more)


@functools.cache
def room_paths() -> dict[str, str]:
    """Room -> its folder."""
    own = {path.name: f"src/{path.name}" for path in (ROOT / "src").iterdir() if path.is_dir()}
    return own | {room: f"apps/{room}" for room in check_layers.APP_ROOMS}


def rooms() -> set[str]:
    return set(room_paths())


@functools.cache
def umbrella() -> frozenset[str]:
    """Return the public headers that hawser/hawser.h includes, directly or through others."""
    found: set[str] = set()
    front = {"hawser.h"}
    while front:
        found |= front
        front = {name.removeprefix("hawser/") for header in front
                 for kind, name in INCLUDE.findall((ROOT / "include/hawser" / header).read_text())
                 if name.startswith("hawser/")} - found
    return frozenset(found)


@functools.cache
def implementers(header: str) -> frozenset[str]:
    """Return the rooms that implement a public header."""
    library = [rooms() - SYSTEMS.union(*CLIENTS), SYSTEMS]
    for group in library if header in umbrella() else [*library, *CLIENTS]:
        found = {room for room in group if header in included(texts(room_paths()[room]))[1]}
        if found:
            return frozenset(found)
    return frozenset({"world"})


@functools.cache
def used_by_including(header: str) -> frozenset[str]:
    """Return rooms that implement a public header or one that it includes, also through others."""
    path = ROOT / "include/hawser" / header
    found = set(implementers(header)) if path.exists() else set()
    for kind, name in INCLUDE.findall(path.read_text(encoding="utf-8")) if path.exists() else []:
        if kind == "<" and name.startswith("hawser/"):
            found |= used_by_including(name.removeprefix("hawser/"))
    return frozenset(found)


def test_folders() -> list[str]:
    """Return the folders of tests/ that become test executables."""
    return sorted(path.name for path in (ROOT / "tests").iterdir()
                  if path.is_dir() and path.name not in ("support", "consumer", "scripts")
                  and any(path.rglob("*.cpp")))


@functools.cache
def uses() -> dict[str, set[str]]:
    """Folder -> folders that it uses directly.

    Test folders are called tests/NAME; each file of tests/support stands for itself.
    """
    table = check_layers.read_table()
    graph: dict[str, set[str]] = {}
    for room in rooms():
        graph[room] = {name.split("/")[0] for name in table.get(room, set())} & rooms()
        for header in included(texts(room_paths()[room]))[1]:
            graph[room] |= used_by_including(header)
    graph["apps"] = rooms()
    graph["bench"] = rooms()
    for name in test_folders():
        sources = with_support(texts(f"tests/{name}"))
        quoted, public = included(sources)
        used = {header.split("/")[0] for header in quoted} & rooms()
        for header in public:
            used |= used_by_including(header)
        text = "\n".join(sources.values())
        used |= {folder for folder in DATA if f"{folder}/" in text}
        used |= {path for path in sources if path.startswith("tests/support/")}
        if "HAWSER_BIN_DIR" in text:  # starts the programs
            used |= {"apps", "scenes", "exercises"}
        if name == "bench":
            used.add("bench")
        graph[f"tests/{name}"] = used
    for name, used in graph.items():
        used.discard(name)
    return graph


def folders_of(files: list[str] | None) -> set[str]:
    """Return the changed folders; {EVERYTHING} if all tests are affected."""
    if files is None:
        return {EVERYTHING}
    found = set()
    for path in files:
        parts = path.split("/")
        if BUILD.match(path) or (parts[0] == "src" and parts[1] in BASE_ROOMS):
            return {EVERYTHING}
        if check_layers.is_room(path):
            found.add(parts[1])
        elif path.startswith("include/hawser/"):
            found |= implementers(path.removeprefix("include/hawser/"))
        elif path.startswith("tests/support/"):
            found.add(path)
        elif parts[0] == "tests" and len(parts) > 2:
            found.add("/".join(parts[:2]))
        elif parts[0] in ("apps", "bench", "scripts") or parts[0] in DATA:
            found.add(parts[0])
    return found


def distances(changed: set[str]) -> dict[str, int]:
    """Folder -> length of the shortest chain of uses to a changed folder; 0 for the changed."""
    graph = uses()
    reached = {name: 0 for name in changed}
    front = set(changed)
    while front:
        step = 1 + min(reached[name] for name in front)
        front = {name for name, used in graph.items() if name not in reached and used & front}
        reached.update({name: step for name in front})
    return reached


def tests_of(changed: set[str], most: int | None = None) -> list[str]:
    """Return the test folders within `most` uses (None: any) of changed folders, nearest first.

    The folder tests/X of a changed room X comes first.
    """
    if EVERYTHING in changed:
        return test_folders()
    reached = distances(changed)
    found = [t for t in test_folders()
             if f"tests/{t}" in reached and (most is None or reached[f"tests/{t}"] <= most
                                             or t in changed)]
    if "apps" in changed:
        found += [t for t in ("cli", "validate") if t not in found and t in test_folders()]
    return sorted(found, key=lambda t: (t not in changed, reached.get(f"tests/{t}", 0), t))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--since", metavar="COMMIT", help="base commit of the change")
    parser.add_argument("--print", dest="what", default="summary",
                        choices=["summary", "base", "changed", "tests", "sanitized"])
    options = parser.parse_args()
    base = base_commit(options.since)
    changed = folders_of(changed_files(base))
    if options.what == "base":
        print(base or "")
    elif options.what == "changed":
        print(*sorted(changed))
    elif options.what == "tests":
        print(*tests_of(changed))
    elif options.what == "sanitized":
        print(*sorted(ALWAYS_SANITIZED.union(tests_of(changed, 1)) - FULL_ONLY - PROGRAM_TESTS))
    else:
        subject = git("log", "-1", "--format=%h %ci %s", base) if base else []
        print(f"base commit: {subject[0] if subject else 'none'}")
        print(f"changed folders: {' '.join(sorted(changed)) or 'none'}")
        print(f"reached test folders: {' '.join(tests_of(changed)) or 'none'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
