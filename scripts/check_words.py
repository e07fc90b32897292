#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Check the words of comments, documentation and commit subjects against docs/style.md.

A room is a folder of src/, apps/live, apps/validate, or one of include, apps, bench, tests, scripts,
docs. Measures of a room:
- what: occurrences of "what" per 10,000 words of comments or text
- of: sentences that begin with "Of", per 1,000 sentences
- long: sentences of more than 25 words, in per cent
- longest: sentences of more than 35 words, in per cent
- verb: comments of functions that begin with a verb, in per cent (headers of include/)

A room that keeps all LIMITS is done and must stay so. Another room has ratchets in
scripts/words_ratchet.json: its figures may not get worse. `--update` writes better figures to that
file. Commit subjects since the commit that added this script have the form `area: imperative` and
at most 72 characters.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
RATCHET = ROOT / "scripts/words_ratchet.json"
LIMITS = {"what": 15.0, "of": 0.0, "long": 5.0, "longest": 0.0, "verb": 80.0}
HIGHER_IS_BETTER = {"verb"}
SUBJECT = re.compile(r"^[a-z0-9][a-z0-9 _./-]*(, [a-z0-9 _./-]+)*: [a-z].*[^.]$")
MOST_SUBJECT = 72
TOLERANCE = 1.005  # of ratchets, for rounding

# Verbs that begin comments of functions, in the imperative.
VERBS = frozenset("""
abort accept accumulate acquire activate adapt add adjust adopt advance align allocate analyse append
apply approximate arrange assemble assign attach average balance begin bind bound break bring build
cache calculate call cancel carry change check choose clamp classify clear clone close collect
combine compare complete compose compress compute condense configure connect construct contain
continue convert copy correct count cover create cut damp deactivate decide declare decode decrease
define defer delete deliver derive describe destroy detach detect determine disable discard
disconnect divide draw drop dump duplicate eliminate emit enable encode end engage enlarge enter
enumerate erase estimate evaluate exchange exclude execute expand export extend extract
extrapolate factor fail fetch fill filter find finish fit fix flag flush follow forget format
forward free gather generate get go group grow halve handle hash hold identify ignore include
increase increment index initialise insert inspect install integrate interpolate intersect
introduce invalidate invert iterate join keep label launch lay lead leave let limit link list load
locate lock log look loop lower make map mark match measure merge minimise mirror modify move
multiply name narrow normalise note notify number observe obtain offer omit open order orient own
pack pad parse partition pass pause perform permute pick place plan plot point poll pop postpone
predict prepare prescribe preserve prevent print process produce project propagate protect provide
prune publish pull push put queue raise read reallocate rebuild recalculate receive recompute record
recover reduce refer refine refresh refuse register reject relax release reload remove rename
reorder repair repeat replace reply report represent request require reserve reset resize resolve
restart restore restrict resume retain retry return reuse reverse rewind rotate round run sample
save scale scan schedule search select send separate serialise serve set settle share shift show
shrink shut simulate skip sleep slice solve sort specify split start state step stop store stretch
substitute subtract sum support suspend swap switch take tell terminate test throw tighten toggle
trace track transform translate transpose traverse treat trigger trim try turn undo unify unite
unlock unpack update upgrade use validate verify view visit wait wake walk warn watch weigh widen
wind withdraw wrap write yield zero
""".split())
PREDICATE = re.compile(r"^(true|false) (if|when|where)\b", re.IGNORECASE)


def comments_of_cpp(text: str) -> list[str]:
    """Return blocks of consecutive // comments, without member comments' marks and code in ``` fences."""
    blocks: list[str] = []
    block: list[str] = []
    fenced = False
    for line in text.splitlines():
        match = re.match(r"^\s*//[/!]?<?(.*)$", line) or re.search(r"\s//[/!]?<(.*)$", line)
        if match is None:
            if block:
                blocks.append("\n".join(block))
            block, fenced = [], False
            continue
        content = match.group(1)
        if "SPDX-License-Identifier" in content:
            continue
        if content.strip().startswith("```"):
            fenced = not fenced
            continue
        if not fenced:
            block.append(content.strip())
    if block:
        blocks.append("\n".join(block))
    return blocks


def comments_of_python(text: str) -> list[str]:
    """Return doc strings and # comments."""
    found = [m.group(1) for m in re.finditer(r'"""(.*?)"""', text, re.DOTALL)]
    found += [m.group(1) for m in re.finditer(r"(?:^|\s)#(?!!) ?(.*)$", text, re.MULTILINE)
              if "SPDX-License-Identifier" not in m.group(1)]
    return found


def paragraphs_of_markdown(text: str) -> list[str]:
    """Return paragraphs and list items, without code, tables, headings or links' addresses."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
    found: list[str] = []
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*[*-] |\s*\d+\. )", text):
        lines = [line for line in paragraph.splitlines()
                 if not line.lstrip().startswith(("|", "#", "!", "<"))]
        if lines:
            found.append(re.sub(r"\]\([^)]*\)", "]", "\n".join(lines)))
    return found


def sentences(block: str) -> list[str]:
    """Return the sentences of a block. Tags such as @param begin one; formulas count as words."""
    block = re.sub(r"\n\s*([-*+]|\d+\.)\s+", " . ", block)  # list items
    block = re.sub(r"\*([^*\n]+)\.\*", r"\1. ", block)  # *Headings.*
    block = re.sub(r"@param\s+\w+", " . ", block)
    block = re.sub(r"\s+", " ", re.sub(r"@(return|throws|file|note)\b", " . ", block))
    block = re.sub(r"`[^`]*`", "code", block)
    parts = re.split(r"(?<=[.!?;:])\s+(?=[A-Z(\"'`0-9@])|\s\.\s", block)
    return [p.strip() for p in parts if re.search(r"[A-Za-z]", p)]


def words(text: str) -> list[str]:
    return re.findall(r"[A-Za-z][A-Za-z'’-]*", text)


def functions_of_header(text: str) -> list[str]:
    """Return the /// comments before functions of a header."""
    found: list[str] = []
    lines = text.splitlines()
    i = 0
    while i < len(lines):
        if not re.match(r"^\s*///(?!<)", lines[i]):
            i += 1
            continue
        block = []
        while i < len(lines) and re.match(r"^\s*///(?!<)", lines[i]):
            block.append(re.sub(r"^\s*///", "", lines[i]).strip())
            i += 1
        declaration = " ".join(lines[i:i + 3])
        head = re.split(r"[;{]|(?<!operator)(?<![=!<>])=", declaration, maxsplit=1)[0]
        if "(" not in head or re.match(r"\s*(struct|class|enum|namespace|using|#|inline constexpr|"
                                       r"constexpr|static constexpr|template)\b", head):
            continue
        if block[0].startswith("@file"):
            continue
        found.append(" ".join(block))
    return found


def begins_with_verb(comment: str) -> bool:
    comment = re.sub(r"^(@return|@throws)\b.*", "return", comment)
    if PREDICATE.match(comment):
        return True
    found = words(comment)
    return bool(found) and found[0].lower() in VERBS


def room_of(path: str) -> str | None:
    """Return the room of a file, or None if it is not checked."""
    if path.startswith(("src/", "apps/live/", "apps/validate/")):
        return "/".join(path.split("/")[:2]) if path.count("/") > 1 else "src"
    top = path.split("/")[0]
    if top in {"include", "apps", "bench", "tests", "scripts", "docs", "examples"}:
        return top
    return "docs" if path in {"README.md", "CONTRIBUTING.md"} else None


def blocks_of(path: str, text: str) -> list[str]:
    if path.endswith((".h", ".cpp")):
        return comments_of_cpp(text)
    if path.endswith(".py"):
        return comments_of_python(text)
    if path.endswith(".md") and not path.endswith("CHANGELOG.md"):
        return paragraphs_of_markdown(text)
    return []


def measure(files: dict[str, str]) -> dict[str, dict[str, float]]:
    """Return the figures of each room, from paths and texts."""
    counts: dict[str, dict[str, int]] = {}
    for path, text in files.items():
        room = room_of(path)
        if room is None:
            continue
        c = counts.setdefault(room, dict.fromkeys(
            ("words", "what", "sentences", "of", "long", "longest", "functions", "verbs"), 0))
        for block in blocks_of(path, text):
            found = words(block)
            c["words"] += len(found)
            c["what"] += sum(w.lower() in ("what", "what's", "whatever") for w in found)
            for sentence in sentences(block):
                size = len(words(sentence))
                c["sentences"] += 1
                c["of"] += sentence.startswith("Of ")
                c["long"] += size > 25
                c["longest"] += size > 35
        if path.startswith("include/") and path.endswith(".h"):
            for comment in functions_of_header(text):
                c["functions"] += 1
                c["verbs"] += begins_with_verb(comment)
    out: dict[str, dict[str, float]] = {}
    for room, c in counts.items():
        many = max(1, c["sentences"])
        out[room] = {"what": 1e4 * c["what"] / max(1, c["words"]),
                     "of": 1e3 * c["of"] / many,
                     "long": 100.0 * c["long"] / many,
                     "longest": 100.0 * c["longest"] / many}
        if c["functions"]:
            out[room]["verb"] = 100.0 * c["verbs"] / c["functions"]
    return out


def keeps(rule: str, value: float, limit: float) -> bool:
    return value >= limit if rule in HIGHER_IS_BETTER else value <= limit


def faults_of(figures: dict[str, dict[str, float]],
              ratchet: dict[str, dict[str, float]]) -> list[str]:
    """Return figures beyond their limit, or beyond the ratchet if the room has one."""
    faults = []
    for room, values in sorted(figures.items()):
        for rule, value in values.items():
            if keeps(rule, value, LIMITS[rule]):
                continue
            reached = ratchet.get(room, {}).get(rule)
            if reached is None:
                faults.append(f"{room}: {rule} {value:.1f}, limit {LIMITS[rule]:g}")
                continue
            allowed = reached / TOLERANCE if rule in HIGHER_IS_BETTER else reached * TOLERANCE
            if not keeps(rule, value, allowed):
                faults.append(f"{room}: {rule} {value:.2f}, reached before {reached:.2f}")
    return faults


def improved(figures: dict[str, dict[str, float]],
             ratchet: dict[str, dict[str, float]]) -> dict[str, dict[str, float]]:
    """Return ratchets of rules that a room does not keep yet, at the better of both figures."""
    out: dict[str, dict[str, float]] = {}
    for room, values in sorted(figures.items()):
        for rule, value in values.items():
            if keeps(rule, value, LIMITS[rule]):
                continue
            reached = ratchet.get(room, {}).get(rule, value)
            best = max(value, reached) if rule in HIGHER_IS_BETTER else min(value, reached)
            worse = math.floor if rule in HIGHER_IS_BETTER else math.ceil
            out.setdefault(room, {})[rule] = worse(100.0 * best) / 100.0
    return out


def bad_subjects(subjects: list[str]) -> list[str]:
    return [f"commit subject ({len(s)} characters): {s}" for s in subjects
            if len(s) > MOST_SUBJECT or not (SUBJECT.match(s) or s.startswith("Merge "))]


def git(*arguments: str) -> list[str]:
    done = subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    return done.stdout.splitlines() if done.returncode == 0 else []


def subjects_since_this_check() -> list[str]:
    added = git("log", "--diff-filter=A", "--format=%H", "--", "scripts/check_words.py")
    return git("log", "--no-merges", "--format=%s", f"{added[-1]}..HEAD") if added else []


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true", help="write better figures to the ratchet")
    parser.add_argument("--table", action="store_true", help="print the figures of all rooms")
    parser.add_argument("--list", metavar="FOLDER", help="print long sentences and those with 'what' "
                        "or a first 'Of', and comments of functions without a verb, below a folder")
    options = parser.parse_args()
    tracked = git("ls-files", "--cached", "--others", "--exclude-standard")
    files = {p: (ROOT / p).read_text(encoding="utf-8", errors="replace") for p in tracked
             if room_of(p) and p.endswith((".h", ".cpp", ".py", ".md")) and (ROOT / p).is_file()}
    if options.list:
        return list_below(files, options.list)
    figures = measure(files)
    if options.table:
        print(f"{'room':<20}{'what':>8}{'of':>8}{'long':>8}{'longest':>9}{'verb':>7}")
        for room, v in sorted(figures.items()):
            verb = f"{v['verb']:7.1f}" if "verb" in v else ""
            print(f"{room:<20}{v['what']:8.1f}{v['of']:8.1f}{v['long']:8.1f}"
                  f"{v['longest']:9.1f}{verb}")
    ratchet = json.loads(RATCHET.read_text()) if RATCHET.exists() else {}
    faults = faults_of(figures, ratchet) + bad_subjects(subjects_since_this_check())
    if options.update:
        RATCHET.write_text(json.dumps(improved(figures, ratchet), indent=1) + "\n")
    for fault in faults:
        print(fault)
    done = sum(all(keeps(r, v, LIMITS[r]) for r, v in f.items()) for f in figures.values())
    print(f"words: {len(figures)} rooms, {done} within all limits, {len(faults)} faults")
    return 1 if faults else 0


def list_below(files: dict[str, str], folder: str) -> int:
    for path, text in sorted(files.items()):
        if not path.startswith(folder):
            continue
        for block in blocks_of(path, text):
            for sentence in sentences(block):
                bad = len(words(sentence)) > 25 or sentence.startswith("Of ")
                if bad or re.search(r"\bwhat(ever)?\b", sentence, re.IGNORECASE):
                    print(f"{path}: {sentence}")
        if path.startswith("include/") and path.endswith(".h"):
            for comment in functions_of_header(text):
                if not begins_with_verb(comment):
                    print(f"{path}: no verb: {comment[:120]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
