# SPDX-License-Identifier: Apache-2.0
"""The compiler's cache must not return precompiled headers of other text.

g++ recognises a header with `#pragma once` by its text. A cache that compares preprocessed text
finds no difference if only a comment changed. It then returns a precompiled header that g++ does not
match with the header: everything in it is defined twice.

usage: test_cache.py LAUNCHER... COMPILER       as the build starts its compiler
"""
import os
import pathlib
import subprocess
import sys
import tempfile

LAUNCHER = sys.argv[1:]


def build(folder: pathlib.Path, comment: str) -> subprocess.CompletedProcess:
    """Precompile a header with this comment and compile a source with it, in a fresh folder."""
    for old in folder.iterdir():
        old.unlink()
    (folder / "part.h").write_text(f"#pragma once\nstruct Part {{}};  // {comment}\n")
    (folder / "all.h").write_text('#pragma once\n#include "part.h"\n')
    (folder / "empty.cpp").write_text("")
    # Another name in each text: the object must not come from the cache if the header does not.
    (folder / "source.cpp").write_text(f'#include "part.h"\nPart {comment.replace(" ", "_")};\n')
    subprocess.run([*LAUNCHER, "-MD", "-MF", "all.d", "-x", "c++-header", "-include", "all.h",
                    "-o", "all.h.gch", "-c", "empty.cpp"], cwd=folder, check=True)
    return subprocess.run([*LAUNCHER, "-MD", "-MF", "source.d", "-Winvalid-pch", "-include",
                           "all.h", "-o", "source.o", "-c", "source.cpp"],
                          cwd=folder, capture_output=True, text=True)


def main() -> int:
    with tempfile.TemporaryDirectory() as cache, tempfile.TemporaryDirectory() as folder:
        os.environ["CCACHE_DIR"] = cache
        os.environ.pop("CCACHE_DISABLE", None)
        for comment in ("a fourth", "a fifth", "a fourth"):
            built = build(pathlib.Path(folder), comment)
            if built.returncode != 0:
                print(f"with the comment “{comment}”:\n{built.stderr}", file=sys.stderr)
                return 1
        statistics = subprocess.run(["ccache", "--print-stats"], capture_output=True, text=True)
        counts = dict(line.split("\t") for line in statistics.stdout.splitlines())
        hits = int(counts["direct_cache_hit"]) + int(counts["preprocessed_cache_hit"])
        # The third build is the first one again.
        if hits == 0:
            print(f"nothing came from the cache:\n{statistics.stdout}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
