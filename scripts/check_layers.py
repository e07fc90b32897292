#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check the includes of rooms, and a few rules for every file.

The table of layers is in docs/architecture.md, section "Layers". Each row names folders and the
rooms (folders of src/, apps/live, apps/validate) that they may include in addition to themselves.
A header instead of a room is the only header of this room that they may include. Further rules:
  - The folder include/hawser includes the standard library, Eigen and itself only.
  - Rooms of the library include no foreign library except Eigen (and AMD in factor).
  - In rooms, own headers are spelled "room/file.h".
  - Every C++, Python, shell and CMake file names its licence in the first lines.
  - No C++ file is longer than 600 lines (aim: 400, unless it is one algorithm).
  - Modules of a room (a header with its source) do not include each other in circles. Rooms with
    circles are in CIRCLES with the number of modules in them, which may only decrease.
  - No file contains a path of a private machine, or the option -march=native.
"""
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import structure  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "docs/architecture.md"
MAX_LINES = 600
LICENCE = "SPDX-License-Identifier: Apache-2.0"
# Rooms above the library: they may use foreign libraries and only the public headers.
USERS = {"scene", "record", "verify", "session", "report", "draw", "validate", "live", "export",
         "exercise", "debrief"}
# Rooms in apps/: a program each, or a part of one with tests of its own.
APP_ROOMS = {"live", "validate"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
# Number of modules in circles within their room.
CIRCLES: dict[str, int] = {}
LONG_FUNCTION, LONG_FILE = 70, 400  # lines
# The verifier compares kinds itself, because it shares no code with the solver.
ASKING = {"src/model/", "src/verify/"}
# Headers of the C++ library have no dot and no slash.
STANDARD = re.compile(r"^[a-z_0-9]+$")
SYSTEM = re.compile(r"^(immintrin|x86intrin|cpuid|cxxabi|pthread|sched|unistd|time|errno|signal|"
                    r"sys/[a-z]+|linux/[a-z]+)\.h$")
MACHINE_PATH = re.compile(r"(?<![\w.)}])/(?:work|home/\w+|root)/")


def read_table() -> dict[str, set[str]]:
    """Return folder -> rooms, and headers of rooms, that it may include, from "## Layers"."""
    section = TABLE.read_text(encoding="utf-8").split("\n## Layers\n", 1)[1].split("\n## ", 1)[0]
    table: dict[str, set[str]] = {}
    for line in section.splitlines():
        cells = [c.strip() for c in line.strip().strip("|").split("|")]
        if not line.startswith("|") or len(cells) != 2 or set(cells[0]) <= set("-: "):
            continue
        if cells[0] == "folder":
            continue
        names = re.findall(r"[a-z_]+(?:/[a-z_]+\.h)?", cells[1])
        for folder in re.findall(r"[a-z_]+", cells[0]):
            table[folder] = set(names)
    return table


def layer_of(path: str) -> str:
    parts = path.split("/")
    return parts[1] if parts[0] in ("src", "include") or is_room(path) else parts[0]


def is_room(path: str) -> bool:
    """Return true for a file of a room."""
    parts = path.split("/")
    return len(parts) > 2 and (parts[0] == "src" or (parts[0] == "apps" and parts[1] in APP_ROOMS))


def check_include(path: str, kind: str, name: str, allowed: set[str], rooms: set[str]) -> str:
    """Return the fault of one include, or the empty string."""
    layer, top = layer_of(path), name.split("/")[0]
    if path.startswith("include/"):
        if kind == '"':
            return "a public header includes with <hawser/...> only"
        if top in ("hawser", "Eigen") or STANDARD.match(name):
            return ""
        return "a public header may include the standard library, Eigen and hawser only"
    if kind == '"':
        if top in rooms and "/" in name:
            if top == layer or top in allowed or name in allowed or "all" in allowed:
                return ""
            doors = [a for a in allowed if a.startswith(f"{top}/")]
            return f"{layer} may include {doors[0]} only" if doors else \
                f"{layer} may not include {top}"
        if is_room(path):
            return 'write "room/file.h"'
        return ""
    if top == "hawser":
        return ""
    if path.startswith("src/") and layer not in USERS:
        own = layer == "factor" and name == "amd.h"
        if not (own or top == "Eigen" or STANDARD.match(name) or SYSTEM.match(name)):
            return "the library uses no foreign header but Eigen"
    return ""


def check_cxx(path: str, text: str, table: dict[str, set[str]]) -> list[str]:
    found = []
    lines = text.count("\n")
    if lines > MAX_LINES:
        found.append(f"{path}: {lines} lines, at most {MAX_LINES}")
    layer = layer_of(path)
    if is_room(path) and layer not in table:
        return found + [f"{path}: room {layer} is missing in the table of docs/architecture.md"]
    rooms = {r for r in table if r not in ("apps", "python", "fmu", "tests", "bench", "all")}
    for match in INCLUDE.finditer(text):
        wrong = check_include(path, *match.groups(), table.get(layer, set()), rooms)
        if wrong:
            line = text.count("\n", 0, match.start()) + 1
            found.append(f"{path}:{line}: {match.group(2)}: {wrong}")
    return found


def check_file(path: str, table: dict[str, set[str]]) -> list[str]:
    try:
        text = (ROOT / path).read_text(encoding="utf-8")
    except (UnicodeDecodeError, FileNotFoundError, IsADirectoryError):
        return []
    found = []
    name = pathlib.PurePath(path)
    if name.suffix in (".cpp", ".h", ".py", ".sh", ".cmake") or name.name == "CMakeLists.txt":
        if LICENCE not in "\n".join(text.splitlines()[:3]):
            found.append(f"{path}: first lines lack '{LICENCE}'")
    if name.suffix in (".cpp", ".h"):
        found += check_cxx(path, text, table)
    for match in MACHINE_PATH.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        found.append(f"{path}:{line}: path of one machine: {match.group(0)}")
    if name.suffix in (".txt", ".cmake", ".json") and re.search(r"^[^#\n]*-march=native", text,
                                                               re.MULTILINE):
        found.append(f"{path}: asks for -march=native; use run-time dispatch")
    return found


def read_sources(files: list[str]) -> dict[str, str]:
    """Return the texts of the C++ sources of the library and the program."""
    return {path: (ROOT / path).read_text(encoding="utf-8") for path in files
            if path.endswith((".cpp", ".h")) and path.startswith(("src/", "apps/", "include/"))
            and (ROOT / path).is_file()}


def check_circles(sources: dict[str, str]) -> tuple[list[str], int]:
    """Return the rooms with more modules in circles than allowed, and the number of circles."""
    rooms: dict[str, dict[str, str]] = {}
    for path, text in sources.items():
        if is_room(path):
            rooms.setdefault(layer_of(path), {})[path.split("/", 1)[1]] = text
    found, count = [], 0
    for room, texts in sorted(rooms.items()):
        parts = structure.circles(structure.module_edges(texts))
        count += len(parts)
        modules = sum(len(part) for part in parts)
        if modules > CIRCLES.get(room, 0):
            names = "; ".join(", ".join(part) for part in parts)
            found.append(f"room {room}: {modules} modules include each other in circles, at most "
                         f"{CIRCLES.get(room, 0)}: {names}")
    return found, count


def print_shape(sources: dict[str, str], circles: int, listed: bool) -> None:
    """Print the structure figures with limits."""
    kinds = structure.kinds_of(sources["include/hawser/interactions.h"])
    long = [f"{path}:{line}: {name} has {lines} lines" for path, text in sources.items()
            for name, line, lines in structure.functions(text) if lines > LONG_FUNCTION]
    large = [f"{path}: {lines} lines" for path, text in sources.items()
             if (lines := text.count("\n")) > LONG_FILE]
    asking = [f"{path}: asks for a kind" for path, text in sources.items()
              if not path.startswith(tuple(ASKING)) and structure.asks_for_kind(text, kinds)]
    print(f"circles within rooms: {circles}")
    for what, lines in ((f"functions above {LONG_FUNCTION} lines", long),
                        (f"files above {LONG_FILE} lines", large),
                        ("files outside model that ask for a kind", asking)):
        print(f"{what}: {len(lines)}")
        if listed:
            print(*(f"  {line}" for line in sorted(lines)), sep="\n")


def main() -> int:
    if set(sys.argv[1:]) - {"--list"}:
        print("usage: scripts/check_layers.py [--list]    --list: name what is counted")
        return 2
    table = read_table()
    if len(table) < 10:
        print(f"{TABLE}: the table of layers was not understood")
        return 1
    files = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout.splitlines()
    found = [line for path in sorted(set(files)) for line in check_file(path, table)]
    sources = read_sources(files)
    too_many, circles = check_circles(sources)
    found += too_many
    print(*found, sep="\n", end="\n" if found else "")
    print_shape(sources, circles, "--list" in sys.argv)
    print(f"layers: {len(files)} files checked, {len(found)} findings")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
