#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measure the fraction of inserted faults that the quick tests detect (mutation testing).

usage: scripts/mutants.py [--seed COMMIT] [--count 60] [--list] [--only ID,...] [--report FILE] ...

A fault is one change of one function body below src. Faults are spread over all folders of src, at
least one each and the rest by lines of code. The five kinds have about equal numbers:
- sign: + and - exchanged, += and -= exchanged, unary minus removed
- constant: number changed: n to n + 1, n > 7 to n / 4, x to 2 x, tolerances to 1000 x
- index: [i] to [i + 1], x() to y(), front() and back() exchanged, loop bound off by one
- condition: comparison negated, && and || exchanged, condition of if or while negated
- call: statement removed that consists of one call
The seed and the sources determine the faults. Sites without observable effect are left out:
assertions, reservations, traces, hashes, error texts, code for one instruction set. Headers that
many sources include are used last: their rebuild takes longer than the limit.

Faults are inserted into a copy of the work tree, build/mutants/tree, with its own build folder. For
each fault, the quick tests of one test folder after another are built and run, nearest first
(scripts/affected.py). This ends when a test fails, crashes or does not end, or after --limit
seconds. A fault that does not compile is replaced by the next site of the same folder and kind.
On a machine with other work, --slack multiplies the time limits.

Results are JSON lines, by default in build/mutants/SEED.jsonl; a later run with the same seed
continues there. The file tests/equivalent_faults.txt lists faults without effect as "ID reason", at
most four for a seed; they do not count. Exit status 0: the score reaches --bar.
"""
from __future__ import annotations

import argparse
import collections
import contextlib
import dataclasses
import fcntl
import hashlib
import json
import math
import os
import pathlib
import queue
import re
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import affected  # noqa: E402
import structure  # noqa: E402

ROOT = affected.ROOT
HOME = ROOT / "build/mutants"
TREE, BUILD, BASELINE = HOME / "tree", HOME / "build", HOME / "baseline.json"
KINDS = ["sign", "constant", "index", "condition", "call"]
LEFT_OUT = ("apps/live/fallback/", "src/runtime/pool_costs.cpp")  # the latter measures durations
FREE_NUMBERS = "apps/validate/"  # numbers there are mostly parameters of cases and tolerances
WIDE = 60  # compilations; headers that more of them read are used last
MAX_EQUIVALENT = 4
NEVER = math.inf
# No WERROR: a removed call can leave a parameter unused. NO_SHARED: a program is not linked again
# if only code of the shared library changes.
CONFIGURE = ["cmake", "-S", str(TREE), "-B", str(BUILD), "-G", "Ninja",
             "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_SHARED_LIBS=ON", "-DHAWSER_UNITY=ON",
             "-DHAWSER_BENCH=OFF", "-DHAWSER_BENCH_LIBRARIES=OFF", "-DHAWSER_WERROR=OFF",
             "-DCMAKE_LINK_DEPENDS_NO_SHARED=ON"]
ENVIRONMENT = {**os.environ, "HAWSER_TIER": "quick", "GTEST_COLOR": "no", "GTEST_FAIL_FAST": "1"}
for variable in ("HAWSER_SEED", "HAWSER_TEST_TIMES", "HAWSER_ISA"):
    ENVIRONMENT.pop(variable, None)
# Lines of ctest: a test starts; a test has ended, with its result and duration.
STARTED = re.compile(r"^ *Start +\d+: (.+?) *$", re.MULTILINE)
ENDED = re.compile(r"Test +#\d+: (.+?) \.+(.*?) +([\d.]+) sec")

# The rules rely on the spaces and line breaks that clang-format writes.
BALANCED = r"(?>[^();]|\((?>[^();]|\((?>[^();]|\([^();]*\))*\))*\))*"
UNARY = r"(?:(?<=[(\[{!])|(?<=[,=?:<>+*/&|] )|(?<=return ))-"
# Rule -> kind of its faults and pattern, whose group 1 changes; see changed().
RULES = {rule: (kind, re.compile(pattern)) for rule, kind, pattern in (
    ("binary", "sign", r"(?<=[\w)\]])\s([-+]=?)\s"),
    ("unary", "sign", rf"({UNARY})(?=[a-zA-Z_(]|[1-9]|0\.\d*[1-9])"),
    ("number", "constant",
     rf"(?<![\w.])((?:{UNARY})?(?:\d+\.?\d*(?:[eE][-+]?\d+)?|0[xX][\da-fA-F]+)[uUlLzZ]*)(?![\w'])"),
    ("index", "index", r"(?<=[\w)\]])\[([^][;{]+)\]"),
    ("element", "index", r"(?:\.|->)(x|y|z|front|back)\(\)"),
    ("first", "index", r"\bfor \([^;()]*= (0);(?!\s[\w.]+ <=? \d\d)"),
    ("last", "index", r"\bfor \([^;]*;\s[\w.]+( )<=? (?!\d\d)"),
    ("comparison", "condition", r"\s(==|!=|<=?|>=?|&&|\|\|)\s"),
    ("branch", "condition", rf"\b(?:if|while) \(({BALANCED})\)"),
    ("call", "call", r"(?:(?<=[;{}])|\)|\belse)\s+"
     rf"((?:\w+(?:\([^();]*\)|\[[^][;]*\])*(?:::|\.|->))*(\w+)\({BALANCED}\);)"))}
NEGATED = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">", "&&": "||",
           "||": "&&"}
SWAPPED = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
ELEMENTS = {"x": "y", "y": "z", "z": "x", "front": "back", "back": "front"}
FOR = re.compile(r"\bfor \((?>[^()]|\((?>[^()]|\([^()]*\))*\))*$")
ARRAY = re.compile(r"\s*(?!return|else|throw)(?:[\w:]+[*&]* )+\*?\w+(?:\[[^]]*\])*"
                   r"(?:, \*?\w+(?:\[[^]]*\])*)*|.*\bnew [\w:]+", re.DOTALL)
COLOUR = re.compile(r"\s*\d+(?:, \d+){2,3}\s*")
# Code without fault: for some machines, returns that only satisfy the compiler, labels.
APART = [re.compile(pattern, re.DOTALL | re.MULTILINE) for pattern in (
    r"^(?P<off>#if[^\n]*(?:__AVX|__SSE|__x86|_HAVE_).*?^#endif)",
    r"^( *)switch \([^\n]*\{\n(?:\1 [^\n]*\n|\n)*\1\}\n\s*(?P<off>return[^;]*);",
    r"\b(?P<off>default:\s*return[^;]*);", r"\b(?P<off>case (?:[^:?]|::)*:)(?!:)",
    rf"\b(?P<off>if constexpr \({BALANCED}\))")]
# Statements, functions, conditions and calls in which a fault has no effect to observe.
QUIET_STATEMENT = re.compile(
    r"assert|reserve|shrink_to_fit|reserve_more|capacity|prefetch|[tT]race|[sS]topwatch|[tT]imer\b|"
    r"chrono|clock\b|noexcept|alignas|alignof|kAlign|[hH]uge|memory_order|fence|likely|[hH]ash|"
    r"\boperator\b|\bcrc|checksum|\benum\b|\busing\b|\bgrain|chunk_?size|\broom\b|scratch|"
    r"\bbytes\(")
QUIET_FUNCTION = re.compile(r"\b(?:\w*bytes|(?:reserve_more|reserve|prefetch|assert)\w*|what|"
                            r"\w*(?:trace|hash)\w*)$")
QUIET_CONDITION = re.compile(r"threads?\b|parallel|serial|\bpool")
QUIET_CALL = re.compile(r"(?:\w*closed?|\w*flush|f?sync|free|destroy\w*|lock|unlock|yield|wait\w*|"
                        r"notify_\w+|sleep\w*|announce|begin_node|pause|[A-Z0-9_]+|ignore\w*|"
                        r"static_cast\w*|pthread_\w+)$")
ERROR_TEXT = re.compile(r"\b(?:refuse\w*|fail|warn|\w+_error|throw_\w+)\(|\bthrow\b")


@dataclasses.dataclass
class Site:
    """A possible fault: text[begin:end] becomes `new`."""
    path: str
    text: str = dataclasses.field(repr=False)
    function: str
    kind: str
    begin: int
    end: int
    new: str

    def __post_init__(self) -> None:
        start = self.text.rfind("\n", 0, self.begin) + 1
        stop = (self.text.find("\n", self.end) + 1 or len(self.text) + 1) - 1
        self.line, self.column = self.text.count("\n", 0, start) + 1, self.begin - start + 1
        self.folder, self.id = self.path.split("/")[1], ""
        tail = self.text[self.end:stop]
        self.before = " ".join((self.text[start:self.end] + tail).split())
        self.after = " ".join((self.text[start:self.begin] + self.new + tail).split())


def masked(text: str) -> str:
    """Blank comments, strings, directives and code without fault; fill template arguments."""
    code = structure.blank(re.sub(r"(?<=\d)'(?=\d)", "0", text))
    for pattern in APART:
        for match in pattern.finditer(text if pattern is APART[0] else code):
            first, last = match.span("off")
            code = code[:first] + re.sub(r"[^\n]", " ", code[first:last]) + code[last:]
    while True:  # the innermost first
        new = re.sub(r"(?<=[\w\]])<[^<>;{}]*>", lambda m: re.sub(r"[^\n]", "_", m.group()), code)
        if new == code:
            return code
        code = new


def changed_number(word: str, before: str, after: str) -> str | None:
    """Change a literal that stands between two texts. None: a change often has no effect."""
    minus, digits, suffix = re.fullmatch(r"(-?)(.+?)([uUlLzZ]*)", word.replace("'", "")).groups()
    if re.fullmatch(r"0|[1-9]\d*", digits):
        n = int(digits)
        if minus:  # -n becomes -n + 1
            return f"{1 - n}{suffix}"
        flag = re.search(r"(?:[=?:,]|return)\s*$", before) and re.match(r"\s*[;:)},]", after)
        if n == 1 and flag:  # 2 would be true as well
            return f"0{suffix}"
        return f"{n + 1 if n <= 7 else n // 4}{suffix}"
    if not re.fullmatch(r"\d+\.\d*(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+", digits):
        return None
    x = float(digits)
    # Skip numbers that represent infinity, keep a divisor from zero or select a short cut.
    if x >= 1e15 or 0 < x < 1e-15 or (x == 0 and re.search(r"(?:[=!]=|[<>]=?)\s*$", before)) or \
            (x < 1e-6 and re.search(r"\b(?:max|min)\(", before)):
        return None
    new = 1.0 if x == 0 else max(1000 * x, 0.01) if x <= 1e-3 else 2 * x if x < 1e4 else x / 1000
    shown = f"{new:.12g}"
    return minus + shown + ("" if re.search("[.e]", shown) else ".0") + suffix


def changed(rule: str, match: re.Match, code: str, text: str) -> str | None:
    """Return the text that replaces group 1 of a match. None: no fault is possible here."""
    begin, end = match.span(1)
    word = text[begin:end]
    first = max(code.rfind(sign, 0, begin) for sign in ";{}") + 1
    last = end if rule == "call" else 1 + min(
        at for at in (code.find(sign, end) for sign in ";{}") if at >= 0)
    before, after = code[first:begin], code[end:last]
    in_for = FOR.search(code, code.rfind("\n", 0, begin) + 1, begin)
    if QUIET_STATEMENT.search(code, first, last) or ERROR_TEXT.search(before):
        return None
    match rule:
        case "binary":
            return None if '"' in text[first:last] else SWAPPED[word]
        case "unary":
            return ""
        case "number":
            colour = COLOUR.fullmatch(before + word + after[:-1])
            if in_for or colour or before.count("[") > before.count("]") or \
                    re.search(r"(<<|>>) $|\b(?:assign|resize)\([^,]*$", before) or \
                    re.match(r" (<<|>>)", after):
                return None
            return changed_number(word, before, after)
        case "index":
            if ARRAY.fullmatch(before[:-1]) or '"' in word:
                return None
            if word.isdigit():
                return str(int(word) - 1) if word != "0" else "1"
            return f"({word}) + 1" if re.search(r" [?&|^=<>]", word) else f"{word} + 1"
        case "element":
            return ELEMENTS[word]
        case "first":
            return "1"
        case "last":
            return " + 1 "
        case "comparison":
            return None if QUIET_CONDITION.search(code, first, last) else NEGATED[word]
        case "branch":
            if QUIET_CONDITION.search(code, first, last) or word in ("true", "false") or \
                    re.search(r"\s(?:[=!<>]?=|[<>]|&&|\|\|)\s", word):
                return None
            return word[1:] if word.startswith("!") else f"!({word})"
    name = match.group(2)  # call
    return None if in_for or QUIET_CALL.match(name) or "trace" in word else "{}"


def sites_of(path: str, text: str) -> list[Site]:
    """List all sites of a source."""
    code, found = masked(text), []
    lines = [0] + [match.end() for match in re.finditer("\n", code)] + [len(code)]
    for name, line, count in structure.functions(code):
        if QUIET_FUNCTION.search(name):
            continue
        begin, end = code.find("{", lines[line - 1]), lines[min(line + count, len(lines)) - 1]
        for rule, (kind, pattern) in RULES.items():
            if rule == "number" and path.startswith(FREE_NUMBERS):
                continue
            for match in pattern.finditer(code, begin, end):
                new = changed(rule, match, code, text)
                if new is not None:
                    found.append(Site(path, text, name, kind, *match.span(1), new))
    return found


def compilations(sources: dict[str, str]) -> dict[str, int]:
    """Count the compilations that read each header, directly or through other headers."""
    users, counts = collections.defaultdict(set), {}
    for path, text in sources.items():
        for kind, name in affected.INCLUDE.findall(text):
            if kind == '"':
                folder = affected.room_paths().get(name.split("/")[0], "src")
                users["/".join([folder, *name.split("/")[1:]])].add(path)
    for header in (path for path in sources if path.endswith(".h")):
        reached, front = set(), {header}
        while front:
            front = set().union(*(users[path] for path in front)) - reached
            reached |= front
        counts[header] = sum(3 if "/isa/" in p else 1 for p in reached if p.endswith(".cpp"))
    return counts


class Plan:
    """Faults of a seed: `slots` are their folders and kinds, `ranked` the sites of each slot."""

    def __init__(self, seed: str, count: int) -> None:
        self.seed, self.slots, self.sites, self.taken = seed, [], {}, set()
        self.ranked: dict[tuple[str, str], list[Site]] = collections.defaultdict(list)
        sources = {path: text for room in sorted(affected.rooms())
                   for path, text in affected.texts(affected.room_paths()[room]).items()
                   if not path.startswith(LEFT_OUT)}
        read = compilations(sources)
        lines: collections.Counter[str] = collections.Counter()
        for path, text in sources.items():
            lines[path.split("/")[1]] += sum(1 for line in text.splitlines() if line.strip())
            for site in sites_of(path, text):
                site.id = f"{seed}/{path}:{site.line}:{site.column}:{site.kind}"
                self.sites[site.id] = site
                self.ranked[site.folder, site.kind].append(site)
        for sites in self.ranked.values():
            sites.sort(key=lambda site: (read.get(site.path, 0) > WIDE, self.mix(
                site.path, site.kind, site.before, site.column)))
        folders = sorted((f for f in lines if any(self.ranked[f, k] for k in KINDS)),
                         key=self.mix)[:count]
        self.spread({f: lines[f] for f in folders}, count)

    def mix(self, *parts: object) -> str:
        """Return a key for a random order that only the seed and the parts determine."""
        return hashlib.sha256("|".join([self.seed, *map(str, parts)]).encode()).hexdigest()

    def spread(self, lines: dict[str, int], count: int) -> None:
        """Fill the slots: one a folder, the rest by lines of code (largest remainders)."""
        rest = (count - len(lines)) / sum(lines.values())
        number = {f: int(1 + rest * lines[f]) for f in lines}
        for f in sorted(lines, key=lambda f: number[f] - rest * lines[f])[
                :count - sum(number.values())]:
            number[f] += 1
        used: collections.Counter[str] = collections.Counter()
        for f, _ in sorted(((f, n) for f in lines for n in range(number[f])),
                           key=lambda slot: self.mix(*slot)):
            kind = min((k for k in KINDS if self.ranked[f, k]), key=lambda k: (
                used[k], self.slots.count((f, k)), self.mix(f, k)))
            used[kind] += 1
            self.slots.append((f, kind))

    def next_site(self, slot: tuple[str, str]) -> Site | None:
        """Return a site that no earlier call returned, in another function if possible."""
        free = [site for site in self.ranked[slot] if site.id not in self.taken]
        site = next((s for s in free if (s.path, s.function) not in self.taken),
                    next(iter(free), None))
        if site:
            self.taken |= {site.id, (site.path, site.function)}
        return site

    def faults(self, records: Records):
        """Yield number and site of each fault; another site follows one that does not compile."""
        self.taken.clear()
        for n, slot in enumerate(self.slots, start=1):
            while site := self.next_site(slot):
                if records.result(site) != "not compiled":
                    yield n, site
                if records.result(site) != "not compiled":
                    break


class Records:
    """Records of the faults of a seed by ID, in a file of JSON lines."""

    def __init__(self, path: pathlib.Path, seed: str) -> None:
        self.path, self.seed = path, seed
        lines = path.read_text().splitlines() if path.exists() else []
        self.found = {r["id"]: r for r in map(json.loads, lines)}
        if not all(name.startswith(seed + "/") for name in self.found):
            sys.exit(f"mutants.py: {path} has results of another seed than {seed}")

    def result(self, site: Site) -> str:
        """Return the result of a fault; empty if there is none or its line has changed since."""
        record = self.found.get(site.id)
        return record["result"] if record and record["before"] == site.before else ""

    def add(self, site: Site, result: str, test: str, by: str, seconds: float) -> None:
        """Store a record; it replaces an older one of the same fault."""
        self.found[site.id] = {
            "id": site.id, "folder": site.folder, "at": f"{site.path}:{site.line}",
            "kind": site.kind, "before": site.before, "after": site.after, "result": result,
            "test": test, "by": by, "seconds": round(seconds, 1)}
        self.path.parent.mkdir(parents=True, exist_ok=True)
        fresh = self.path.with_name(self.path.name + ".new")
        fresh.write_text("".join(json.dumps(r) + "\n" for r in self.found.values()))
        fresh.replace(self.path)


def run(command: list[str], deadline: float, watch=lambda line: False, limits=None):
    """Run a process group. @return Exit status (None: stopped) and output.

    @param watch  Called with each line, and with "" several times a second. True: stop.
    """
    process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               text=True, errors="replace", process_group=0,
                               preexec_fn=limits, env=ENVIRONMENT)
    lines: queue.Queue[str | None] = queue.Queue()
    threading.Thread(target=lambda: [*map(lines.put, process.stdout), lines.put(None)],
                     daemon=True).start()
    output: list[str] = []
    try:
        while True:
            line: str | None = ""
            with contextlib.suppress(queue.Empty):
                line = lines.get(timeout=0.2)
            if line is None:
                return process.wait(), "".join(output)
            output.append(line)
            if watch(line) or time.monotonic() > deadline:
                return None, "".join(output)
    finally:  # ninja removes half-written files if it is terminated
        for number, seconds in ((signal.SIGTERM, 20), (signal.SIGKILL, 5)):
            end = time.monotonic() + seconds
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, number)
                while time.monotonic() < end:
                    process.poll()
                    os.killpg(process.pid, 0)
                    time.sleep(0.02)


def limit_memory() -> None:
    """Limit memory and files of a test: a fault can allocate or write without end."""
    memory = max(4 << 30, os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2)
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_FSIZE, (2 << 40, 2 << 40))  # test_files.cpp: sparse, 1 TiB


def refresh() -> str:
    """Bring the copied tree up to date with the work tree. @return Hash of its contents."""
    listed = subprocess.run(["git", "ls-files", "-coz", "--exclude-standard"], cwd=ROOT, check=True,
                            capture_output=True).stdout.decode().split("\0")
    wanted = {name for name in listed if name and (ROOT / name).is_file()}
    digest = hashlib.sha256()
    for name in sorted(wanted):
        data, to = (ROOT / name).read_bytes(), TREE / name
        digest.update(name.encode() + hashlib.sha256(data).digest())
        if not to.is_file() or to.read_bytes() != data:
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_bytes(data)
            shutil.copymode(ROOT / name, to)
    for path in [path for path in TREE.rglob("*") if path.is_file() or path.is_symlink()]:
        if path.relative_to(TREE).as_posix() not in wanted:
            path.unlink()
    return digest.hexdigest()


class Builder:
    """Build folder of the copied tree."""

    def __init__(self, jobs: int, slack: float) -> None:
        self.jobs = str(jobs)
        self.slack = slack  # factor of the time limits
        self.seconds: dict[str, float] = {}  # duration of each entry of ctest

    def prepare(self) -> None:
        """Build the tree without fault and run all quick tests, unless this tree passed before."""
        tree = refresh()
        passed = json.loads(BASELINE.read_text()) if BASELINE.exists() else {}
        print("build without fault", flush=True)
        if not (BUILD / "build.ninja").exists():
            self.require("configuration", *run(CONFIGURE, NEVER))
        self.require("build", *self.build([], NEVER))
        if passed.get("tree") != tree:
            print("quick tests without fault", flush=True)
            all_passed, output = self.test("", NEVER)
            self.require("tests", 0 if all_passed else 1, output)
            passed = {"tree": tree, "seconds": {n: float(s) for n, _, s in ENDED.findall(output)}}
            if not passed["seconds"]:
                sys.exit("mutants.py: no test has the label quick")
            BASELINE.write_text(json.dumps(passed))
        self.seconds = passed["seconds"]

    @staticmethod
    def require(step: str, status: int | None, output: str) -> None:
        if status != 0:
            sys.exit(f"{output[-8000:]}\nmutants.py: {step} without fault failed")

    def build(self, folders: list[str], deadline: float) -> tuple[int | None, str]:
        """Build the tests of some folders and the program if they run it; everything if empty."""
        targets = [f"hawser_test_{f}" for f in folders]
        if any("apps" in affected.uses()[f"tests/{f}"] for f in folders):
            targets.append("hawser_program")
        return run(["cmake", "--build", str(BUILD), "-j", self.jobs,
                    *(["--target", *targets] if targets else [])], deadline)

    def test(self, folder: str, deadline: float) -> tuple[bool | None, str]:
        """Run the quick tests of a folder, or all if empty.

        @return True: all passed, False: one failed, None: the deadline was reached. Then the
                output; for a folder of which a test failed, the name of the test.
        """
        started: dict[str, float] = {}
        failed = ""
        stop = NEVER

        def watch(line: str) -> bool:
            nonlocal failed, stop
            now = time.monotonic()
            started.update((name, now) for name in STARTED.findall(line))
            for name, result, _ in ENDED.findall(line):
                started.pop(name, None)
                if "***" in result and not failed:  # its output follows within a second
                    failed, stop = name, now + 1
            for name, since in started.items():
                if not failed and now - since > self.slack * (4 * self.seconds.get(name, 10) + 20):
                    failed, stop = f"{name} (endless)", now
            return folder != "" and now >= stop

        command = ["ctest", "--test-dir", str(BUILD), "-L", "^quick$", "-j", self.jobs,
                   "--output-on-failure", *(["-R", rf"^{re.escape(folder)}\."] if folder else [])]
        status, output = run(command, deadline, watch, limit_memory)
        if not folder or status == 0:
            return status == 0, output
        if status is None and not failed:
            return None, output
        name = re.search(r"\[  FAILED  \] ([\w/]+\.[\w/]+)", output)
        return False, name.group(1) if name else failed or "ctest"

    def entries(self, folder: str) -> list[str]:
        return [name for name in self.seconds if name.startswith(folder + ".")]

    def order(self, room: str, records: Records) -> list[str]:
        """Sort the test folders that use a folder: by distance, faults caught before, duration."""
        near = affected.distances({room})
        caught = collections.Counter(r["by"] for r in records.found.values()
                                     if r["folder"] == room and r["result"] == "caught")
        return sorted(filter(self.entries, affected.tests_of({room})), key=lambda t: (
            t != room, near.get(f"tests/{t}", 0), -caught[t],
            sum(self.seconds[name] for name in self.entries(t))))

    def attempt(self, folder: str, deadline: float) -> tuple[str, str]:
        """Build and run the quick tests of a folder. @return Result and the test that failed."""
        status, output = self.build([folder], deadline)
        if status is None:
            return "missed (time)", f"build of the tests of {folder}"
        if status != 0:
            compiled = not re.search(r"\berror: (?!static assertion)", output)
            return ("caught", "build") if compiled else ("not compiled", "")
        passed, output = self.test(folder, deadline)
        if passed is None:
            return "missed (time)", f"tests of {folder}"
        return ("missed", "") if passed else ("caught", output)

    def insert(self, site: Site, records: Records, limit: float) -> None:
        """Insert a fault, test until it is caught, remove it and store the result."""
        path, start, folders = TREE / site.path, time.monotonic(), []
        result, test = "missed", ""
        if path.read_bytes() != site.text.encode():
            sys.exit("mutants.py: the sources changed at the start; run it again")
        try:
            path.write_bytes((site.text[:site.begin] + site.new + site.text[site.end:]).encode())
            for folder in self.order(site.folder, records):
                folders.append(folder)
                result, test = self.attempt(folder, start + self.slack * limit)
                if result != "missed":
                    break
        finally:
            path.write_bytes(site.text.encode())
        seconds = time.monotonic() - start
        records.add(site, result, test, folders[-1] if result == "caught" else "", seconds)
        if seconds > 60 * self.slack:  # many objects have this fault and count for the next one
            self.require("rebuild", *self.build(folders, NEVER))


def equivalent_faults(path: pathlib.Path, seed: str) -> dict[str, str]:
    """Read the faults of this seed that have no effect: ID -> reason."""
    lines = path.read_text().splitlines() if path.exists() else []
    found = dict([*line.split(maxsplit=1), ""][:2] for line in lines if line.startswith(seed + "/"))
    if len(found) > MAX_EQUIVALENT or not all(found.values()):
        sys.exit(f"mutants.py: {path}: at most {MAX_EQUIVALENT} faults, each with a reason")
    return found


def summary(sites: list[Site], records: Records, equivalent: dict[str, str]) -> tuple[str, float]:
    """Return a text (tables, missed faults, score) and the score [%]."""
    counted = [(s, records.result(s)) for s in sites if s.id not in equivalent]
    counted = [(site, result) for site, result in counted if result]
    caught = sum(result == "caught" for _, result in counted)
    score = 100 * caught / max(len(counted), 1)
    out = []
    for title in ("folder", "kind"):
        out.append(f"\n{title:12} faults caught")
        for name in sorted({getattr(site, title) for site, _ in counted}):
            these = [result for site, result in counted if getattr(site, title) == name]
            out.append(f"{name:12} {len(these):6} {these.count('caught'):6}")
    out += [f"\n{result} {records.found[s.id]['test']} {s.id}\n  - {s.before}\n  + {s.after}"
            for s, result in counted if result != "caught"]
    out += [f"\nequivalent {s.id}\n  {equivalent[s.id]}" for s in sites if s.id in equivalent]
    out.append(f"\nseed {records.seed}: {caught} of {len(counted)} faults caught, {score:.1f} %"
               f" ({len(sites)} planned)")
    return "\n".join(out), score


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--seed", help="commit, or eight hexadecimal digits (default: HEAD)")
    parser.add_argument("--count", type=int, default=60, help="number of faults")
    parser.add_argument("--resume", type=pathlib.Path, metavar="FILE", help="results to continue")
    parser.add_argument("--report", type=pathlib.Path, metavar="FILE", help="file for the summary")
    parser.add_argument("--list", action="store_true", help="list the faults, do not test")
    parser.add_argument("--limit", type=float, default=180, help="build and tests of a fault [s]")
    parser.add_argument("--slack", type=float, default=1, help="factor of time limits")
    parser.add_argument("--only", default="", metavar="ID,...", help="repeat these faults")
    parser.add_argument("--equivalent", type=pathlib.Path, metavar="FILE",
                        default=ROOT / "tests/equivalent_faults.txt", help="faults without effect")
    parser.add_argument("--bar", type=float, default=85, help="required score [%%]")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="parallel processes")
    options = parser.parse_args()
    only = [name for name in options.only.split(",") if name]
    wish = options.seed or (only[0].split("/")[0] if only else "HEAD")
    seed = (affected.git("rev-parse", "--verify", "--quiet", wish + "^{commit}") or [wish])[0]
    seed = seed[:8] if len(seed) == 40 else seed
    if not re.fullmatch("[0-9a-f]{8}", seed):
        parser.error(f"--seed: {wish} is neither a commit nor eight hexadecimal digits")
    plan = Plan(seed, options.count)
    records = Records(options.resume or HOME / f"{seed}.jsonl", seed)
    equivalent = equivalent_faults(options.equivalent, seed)
    if unknown := set(only) - set(plan.sites):
        parser.error(f"--only: no such site in the sources: {' '.join(sorted(unknown))}")
    if options.list:
        for _, site in plan.faults(records):
            print(f"{site.id}\n  - {site.before}\n  + {site.after}")
        return 0

    HOME.mkdir(parents=True, exist_ok=True)
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.default_int_handler)
    builder, status, done = Builder(options.jobs, options.slack), 0, 0
    with (HOME / "lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            builder.prepare()
            start, total = time.time(), len(only or plan.slots)
            chosen = enumerate((plan.sites[name] for name in only), start=1)
            for n, site in chosen if only else plan.faults(records):
                if not only and (site.id in equivalent or records.result(site)):
                    continue
                builder.insert(site, records, options.limit)
                done += records.result(site) != "not compiled"
                end = time.time() + (time.time() - start) / max(done, 1) * (total - n)
                record = records.found[site.id]
                print(f"{n} of {total}: {record['result']} {record['test']} {record['seconds']} s "
                      f"{site.id}; end at", time.strftime("%H:%M", time.localtime(end)), flush=True)
        except BlockingIOError:
            sys.exit("mutants.py: another run uses build/mutants")
        except KeyboardInterrupt:
            print("stopped; a later run continues here")
            status = 130
    sites = [plan.sites[name] for name in only] or [site for _, site in plan.faults(records)]
    text, score = summary(sites, records, equivalent)
    print(text)
    if options.report:
        options.report.write_text(text + "\n")
    return status or int(score < options.bar)


if __name__ == "__main__":
    sys.exit(main())
