# SPDX-License-Identifier: Apache-2.0
"""Measure the structure of the C++ sources: include circles, long functions, tests of kinds.

A module is a header with the source of the same name. Include circles are detected between modules
of one room, because the table of layers rejects circles between rooms. Functions are found by
their braces, not by a compiler. A brace opens a function if the preceding text ends like a
signature; all inner braces belong to it.
"""
import re

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
# Text to blank at equal length: comments, strings, characters.
HIDDEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|'
                    r"'(?:\\.|[^'\\\n])+'", re.DOTALL)
PREPROCESSOR = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
SCOPE = re.compile(r"\b(?:namespace|struct|class|union|enum|extern)\b[^()]*$")
# Ends of signatures: `)`, qualifiers, a return type behind an arrow, a list of initialisers.
SIGNATURE = re.compile(r"\)\s*(?:const|noexcept(?:\([^()]*\))?|override|final|mutable|&&?|"
                       r"->\s*[\w:<>,&*\s]+|requires\b[^{}]*|:\s[^;{}]*|\s)*$")
KINDS = re.compile(r"#define HAWSER_INTERACTION_KINDS\(X\)((?:[^\n]*\\\n)*[^\n]*)")


def blank(text: str) -> str:
    """Replace comments, strings and directives by spaces."""
    def spaces(match: re.Match) -> str:
        return re.sub(r"[^\n]", " ", match.group(0))
    return PREPROCESSOR.sub(spaces, HIDDEN.sub(spaces, text))


def functions(text: str) -> list[tuple[str, int, int]]:
    """Return name, first line and number of lines of each function with a body."""
    code = blank(text)
    found, scopes, start, depth = [], [], 0, 0
    for match in re.finditer(r"[{};]", code):
        at = match.start()
        if depth > 0:  # within a function
            depth += {"{": 1, "}": -1, ";": 0}[match.group(0)]
            if depth == 0:
                head, begin = scopes.pop()
                first = text.count("\n", 0, begin) + 1
                name = re.search(r"([\w~]+(?:::[\w~]+)*|operator\S+)\s*\(", head)
                found.append((name.group(1) if name else "?", first,
                              text.count("\n", 0, at) + 2 - first))
                start = at + 1
            continue
        if match.group(0) == "{":
            head = code[start:at]
            begin = start + len(head) - len(head.lstrip())
            if SIGNATURE.search(head) and not SCOPE.search(head):
                scopes.append((head, begin))
                depth = 1
                continue
        start = at + 1
    return found


def module_of(path: str) -> str:
    return path.rsplit(".", 1)[0]


def module_edges(sources: dict[str, str]) -> dict[str, set[str]]:
    """Return module -> included modules. @param sources  "room/file.h" or deeper -> text."""
    modules = {module_of(path) for path in sources}
    edges: dict[str, set[str]] = {module: set() for module in modules}
    for path, text in sources.items():
        for name in INCLUDE.findall(text):
            other = module_of(name)
            if other in modules and other != module_of(path):
                edges[module_of(path)].add(other)
    return edges


def circles(edges: dict[str, set[str]]) -> list[list[str]]:
    """Return strongly connected components of more than one module (Tarjan 1972), each sorted."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    out: list[list[str]] = []
    for root in sorted(edges):
        if root in index:
            continue
        work = [(root, iter(sorted(edges[root])))]
        index[root] = low[root] = len(index)
        stack.append(root)
        while work:
            node, rest = work[-1]
            for other in rest:
                if other not in index:
                    index[other] = low[other] = len(index)
                    stack.append(other)
                    work.append((other, iter(sorted(edges[other]))))
                    break
                if other in stack:
                    low[node] = min(low[node], index[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    part = []
                    while not part or part[-1] != node:
                        part.append(stack.pop())
                    if len(part) > 1:
                        out.append(sorted(part))
    return out


def kinds_of(header: str) -> list[str]:
    """Return the kinds of interactions in the list behind include/hawser/interactions.h."""
    body = KINDS.search(header)
    return re.findall(r"\bX\((\w+)", body.group(1)) if body else []


def asks_for_kind(text: str, kinds: list[str]) -> bool:
    """True if code compares the kind of an interaction or branches on it. Creation is allowed."""
    name = r"(?:hawser::)?(?:InteractionKind::)?(?:" + "|".join(kinds) + r")\b(?!::)"
    asked = rf"[!=]=\s*{name}|\bcase\s+{name}|{name}\s*[!=]="
    return re.search(asked, blank(text)) is not None
