#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run the commands of README.md and of the tutorials, as they are written.

Commands are the lines of code blocks that begin with `hawser`, and inline code such as
`hawser run scenes/buoy.json --duration 60`. Inline code with a word in capitals is a form, and a
command without arguments is a name; both are left out. Each page gets a folder of its own with
copies of scenes, exercises and schemas, in which its files are written (FILES) and its commands run
in their order. Scenes and exercises among the code blocks are checked with `hawser check`.

The tier quick runs the commands that take at most a few seconds (QUICK), the tier full runs all.
A command that starts a server must answer a request and end normally after an interrupt.
"""
import argparse
import gzip
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
COPIES = ["exercises", "scenes", "schema"]

# Files that a page describes: the code blocks from which each is made, joined as JSON objects.
FILES = {
    "README.md": {"first_tow.json": ["json:0"]},
    "docs/moored_barge.md": {"moored_barge.json": ["json:0"]},
    "docs/winches.md": {"lift.json": ["json:0", "json:1"], "tension.csv": [":0"]},
}

# Commands of each page that take at most a few seconds, without "hawser".
QUICK = {
    "README.md": ["run scenes/pendulum.json", "check first_tow", "run first_tow", "plot tow.hwr",
                  "view first_tow"],
    "docs/moored_barge.md": ["check ", "run moored_barge.json"],
    "docs/winches.md": ["run lift.json"],
    "docs/sea.md": ["inspect "],
    "docs/exercises.md": ["controls "],
}

# Commands that other tests run, and which.
ELSEWHERE = {
    "bench": "the tests of the folder bench",
}
SECONDS = 1800  # limit of a command


def tutorials():
    """Return the pages under the heading Tutorials of docs/index.md."""
    text = (ROOT / "docs/index.md").read_text(encoding="utf-8")
    part = text.split("## Tutorials")[1].split("\n## ")[0]
    return [f"docs/{name}.md" for name in re.findall(r"^([a-z_]+)$", part, re.MULTILINE)]


def blocks(text):
    """Return (language, content) of each code block."""
    return [(language, content) for language, content
            in re.findall(r"^```(\w*)\n(.*?)^```", text, re.DOTALL | re.MULTILINE)]


def commands(text):
    """Return the commands of a page, in their order and each once."""
    found = []
    for part in re.split(r"(^```\w*\n.*?^```)", text, flags=re.DOTALL | re.MULTILINE):
        if part.startswith("```"):
            body = re.sub(r"\\\n\s*", " ", part.split("\n", 1)[1])
            lines = [line.split("   #")[0].split(" # ")[0].strip() for line in body.splitlines()]
            found += [line for line in lines if line.startswith("hawser ")]
        else:
            inline = re.findall(r"`(hawser [^`]+)`", part)
            found += [line for line in inline
                      if not re.search(r"\b[A-Z]{2,}\b", line) and is_complete(line)]
    return list(dict.fromkeys(found))


def is_complete(line):
    """True if a command of running text names a file or a case, not only an option."""
    words = line.split()
    return len(words) > 2 and not words[2].startswith("-")


def write_files(page, folder):
    """Write the files that a page describes."""
    text = (ROOT / page).read_text(encoding="utf-8")
    for name, sources in FILES.get(page, {}).items():
        parts = []
        for source in sources:
            language, index = source.split(":")
            parts.append([c for k, c in blocks(text) if k == language][int(index)])
        if name.endswith(".json"):
            document = {}
            for part in parts:
                document.update(json.loads(part))
            (folder / name).write_text(json.dumps(document), encoding="utf-8")
        else:
            (folder / name).write_text("".join(parts), encoding="utf-8")


def write_documents(page, folder):
    """Write the scenes and exercises of a page as folder/page/N.json. Return commands for them."""
    lines = []
    for language, content in blocks((ROOT / page).read_text(encoding="utf-8")):
        if language != "json" or '"version"' not in content:
            continue
        (folder / "page").mkdir(exist_ok=True)
        name = f"page/{len(lines)}.json"
        (folder / name).write_text(content, encoding="utf-8")
        lines.append(f"hawser check {name}")
    return lines


def serve(words, folder, environment):
    """Start a server at a free port, request its page, interrupt it. Return a fault or ""."""
    process = subprocess.Popen(words + ["--port", "0"], cwd=folder, env=environment, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    output, address, end = "", None, time.monotonic() + 60.0
    while address is None and time.monotonic() < end and process.poll() is None:
        output += process.stdout.readline()
        address = re.search(r"http://[\w.:\[\]]+/", output)
    fault = ""
    if address is None:
        fault = "no address: " + output
    else:
        with urllib.request.urlopen(address.group(0), timeout=30) as answer:
            body = answer.read()
            if answer.headers.get("Content-Encoding") == "gzip":
                body = gzip.decompress(body)
            if answer.status != 200 or b"<html" not in body:
                fault = f"{address.group(0)} is no page"
    process.send_signal(signal.SIGINT)
    try:
        rest, _ = process.communicate(timeout=120)
    except subprocess.TimeoutExpired:
        process.kill()
        return "it does not end after an interrupt"
    if not fault and process.returncode not in (0, 130):
        fault = f"exit code {process.returncode}: {rest[-2000:]}"
    return fault


def run(line, folder, environment, bin_folder):
    """Run a command. Return a fault or ""."""
    words = shlex.split(line)
    words[0] = str(bin_folder / "hawser")
    if words[1] == "view":
        return serve(words, folder, environment)
    for part in line.split("&&"):
        words = shlex.split(part)
        if words[0] == "hawser":
            words[0] = str(bin_folder / "hawser")
        done = subprocess.run(words, cwd=folder, env=environment, text=True, timeout=SECONDS,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        if done.returncode != expected_code(part):
            return f"exit code {done.returncode}: {done.stdout[-2000:]}"
    return ""


def expected_code(part):
    """Return 4 (not passed) for an exercise without controls, else 0."""
    idle = part.startswith("hawser exercise") and "--control" not in part and "--re" not in part
    return 4 if idle else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tier", choices=["quick", "full"], default="quick")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--page", help="only this page, such as docs/sea.md")
    parser.add_argument("--list", action="store_true", help="print the commands of each page")
    options = parser.parse_args()

    failed, done = 0, 0
    for page in ["README.md", *tutorials()]:
        if options.page not in (None, page):
            continue
        lines = commands((ROOT / page).read_text(encoding="utf-8"))
        if options.tier == "quick":
            lines = [x for x in lines if any(f"hawser {key}" in x for key in QUICK.get(page, []))]
        lines = [x for x in lines if x.split()[1] not in ELSEWHERE]
        if options.list:
            print(page, *lines, sep="\n    ")
            continue
        folder = pathlib.Path(tempfile.mkdtemp(prefix="hawser_pages."))
        try:
            for name in COPIES:
                shutil.copytree(ROOT / name, folder / name)
            write_files(page, folder)
            for line in write_documents(page, folder) + lines:
                begin = time.monotonic()
                fault = run(line, folder, dict(os.environ), options.bin.resolve())
                print(f"{page}: {line}: {fault or 'ok'}, {time.monotonic() - begin:.1f} s",
                      flush=True)
                failed += fault != ""
                done += 1
        finally:
            shutil.rmtree(folder)
    if not options.list:
        print(f"{done} commands, {failed} failed")
    return 1 if failed or (done == 0 and not options.list) else 0


if __name__ == "__main__":
    sys.exit(main())
