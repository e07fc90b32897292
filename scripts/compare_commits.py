#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compare the motion of all scenes between two commits, bit for bit.

usage: scripts/compare_commits.py BEFORE AFTER [--steps N] [--threads N] [--keep] [SCENE...]

Both commits are built in build/compare/<commit>. Every scene of AFTER that BEFORE can read
(scenes/*.json except *.settled.json) runs with both. The bits of all poses and velocities are
compared after every step. Prints a line per scene, with the first different step and the body with
the largest difference in it. Exit codes: 0 all equal, 1 some differ, 2 not determined.

A change that moves code must give 0. `AFTER` may be `.`: the working tree as it is.
"""
import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build/compare"

# Print for each step a hash of all poses and velocities, and the poses of a requested step.
PROGRAM = r"""
#include <hawser/hawser.h>
#if __has_include(<hawser/scene.h>)
#include <hawser/scene.h>
#else
#include "scene/scene.h"
#endif
#include <cstdio>
#include <cstdlib>
#include <cstring>
namespace {
std::uint64_t mix(std::uint64_t h, double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    for (int i = 0; i < 8; ++i) h = (h ^ (bits >> (8 * i) & 0xff)) * 1099511628211ULL;
    return h;
}
}  // namespace
int main(int, char** argv) try {
    hawser::scene::Options options;
    options.threads = std::atoi(argv[3]);
    hawser::scene::Scene scene = hawser::scene::load_file(argv[1], options);
    hawser::World& w = scene.world;
    const int steps = std::atoi(argv[2]), shown = std::atoi(argv[4]);
    for (int k = 1; k <= steps; ++k) {
        if (w.step() != hawser::Status::ok) {
            std::printf("%d ended %s\n", k, hawser::to_string(w.stats().status));
            return 0;
        }
        std::uint64_t h = 14695981039346656037ULL;
        for (std::int32_t b = 0; b < w.body_count(); ++b) {
            const hawser::Pose p = w.pose({b});
            const hawser::Twist t = w.velocity({b});
            for (int i = 0; i < 3; ++i) {
                h = mix(mix(mix(h, p.position[i]), t.linear[i]), t.angular[i]);
                h = mix(h, p.orientation.vec()[i]);
            }
            h = mix(h, p.orientation.w());
            if (k == shown)
                std::printf("body %s %.17g %.17g %.17g\n", w.body_def({b}).name.c_str(),
                            p.position[0], p.position[1], p.position[2]);
        }
        std::printf("%d %016llx\n", k, static_cast<unsigned long long>(h));
    }
    return 0;
} catch (const std::exception& e) {
    std::printf("refused %s\n", e.what());
    return 0;
}
"""


def run(command: list[str], where: pathlib.Path = ROOT, what: str = "") -> str:
    done = subprocess.run(command, cwd=where, capture_output=True, text=True)
    if done.returncode != 0:
        print(f"{what or command[0]} failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        sys.exit(2)
    return done.stdout


def source_of(commit: str) -> tuple[str, pathlib.Path]:
    """Return the name and the folder of the sources of a commit."""
    if commit == ".":
        return "working tree", ROOT
    name = run(["git", "rev-parse", "--short=12", commit + "^{commit}"]).strip()
    folder = FOLDER / name
    if not folder.exists():
        run(["git", "worktree", "add", "--detach", str(folder), name])
    return name, folder


def build(name: str, source: pathlib.Path) -> pathlib.Path:
    """Build the program that prints hashes with the library of these sources."""
    print(f"building {name} ...", flush=True)
    tree = FOLDER / (source.name + ".build")
    run(["cmake", "-S", str(source), "-B", str(tree), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         "-DHAWSER_BENCH=OFF", "-DHAWSER_TESTS=OFF", "-DHAWSER_PROGRAM=OFF"], what="cmake")
    run(["cmake", "--build", str(tree), "--target", "hawser", "hawser_scene"], what="the build")
    text = tree / "motion.cpp"
    text.write_text(PROGRAM, encoding="utf-8")
    eigen = run(["pkg-config", "--cflags-only-I", "eigen3"]).split()
    program = tree / "motion"
    run(["c++", "-std=c++20", "-O1", "-DEIGEN_MAX_ALIGN_BYTES=16", "-DFMT_SHARED", *eigen,
         f"-I{source}/include", f"-I{tree}/include", f"-I{source}/src", str(text), "-o",
         str(program), str(tree / "libhawser_scene.a"), str(tree / "libhawser.a"), "-lfmt", "-lamd",
         "-lsuitesparseconfig", "-lpthread"], what="linking the library")
    return program


def motion(program: pathlib.Path, scene: pathlib.Path, steps: int, threads: int,
           shown: int = 0) -> list[str]:
    done = subprocess.run([str(program), str(scene), str(steps), str(threads), str(shown)],
                          cwd=scene.parent.parent, capture_output=True, text=True)
    if done.returncode != 0:
        return [f"ended with code {done.returncode}"]
    return done.stdout.splitlines()


def describe(before: pathlib.Path, after: pathlib.Path, scenes: list[pathlib.Path], step: int,
             threads: int) -> str:
    """Describe the body with the largest difference in a step."""
    def places(program: pathlib.Path, scene: pathlib.Path) -> dict[int, tuple[str, list[float]]]:
        lines = [line.rsplit(" ", 3) for line in motion(program, scene, step, threads, step)
                 if line.startswith("body ")]
        return {i: (line[0][5:], [float(x) for x in line[1:]]) for i, line in enumerate(lines)}
    a, b = places(before, scenes[0]), places(after, scenes[1])
    worst = max(((sum((x - y) ** 2 for x, y in zip(a[i][1], b[i][1])) ** 0.5, b[i][0])
                 for i in a if i in b), default=(0.0, "none"))
    return f"body '{worst[1]}' is {worst[0]:.3g} m off"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    parser.add_argument("--steps", type=int, default=1000)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--keep", action="store_true", help="keep the checked out sources")
    options = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    sides = [source_of(options.before), source_of(options.after)]
    programs = [build(name, source) for name, source in sides]
    names = options.scenes or sorted(
        p.name for p in (sides[1][1] / "scenes").glob("*.json") if ".settled." not in p.name)
    differ = 0
    for name in names:
        files = [source / "scenes" / pathlib.Path(name).name for _, source in sides]
        if not files[0].exists():
            print(f"{name}: new")
            continue
        one, other = (motion(p, f, options.steps, options.threads)
                      for p, f in zip(programs, files))
        if one == other:
            print(f"{name}: {len(one)} steps the same", flush=True)
            continue
        differ += 1
        step = next((k for k, (x, y) in enumerate(zip(one, other)) if x != y),
                    min(len(one), len(other)))
        print(f"{name}: DIFFERENT from step {step + 1} on: "
              f"{describe(*programs, files, step + 1, options.threads)}", flush=True)
    if not options.keep:
        for (_, source), commit in zip(sides, (options.before, options.after)):
            if commit != ".":
                run(["git", "worktree", "remove", "--force", str(source)])
    print(f"{len(names)} scenes, {differ} different")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
