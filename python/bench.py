#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measure the overhead of the Python package. Run it on idle processors.

usage: /usr/bin/python3 python/bench.py      the package is that of HAWSER_BUILD (build/release)

Prints medians. The C++ step is the wall time that the library measures itself
(stats["step_seconds"]), so the difference includes the call, the interpreter lock and the check of
signals.
"""
import os
import pathlib
import statistics
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
# The folder of this script has the package without its compiled part.
sys.path[0] = str(pathlib.Path(os.environ.get("HAWSER_BUILD", ROOT / "build/release")) / "python")
import hawser  # noqa: E402

SCENES = ROOT / "scenes"
LIMITS = {"step": 2.0, "array": 2.0, "controller": 5.0}  # microseconds


def pendulum():
    """Return a world with one pendulum."""
    world = hawser.World(step=1 / 60)
    world.add_body(name="ground", kind="fixed")
    world.add_body(name="bob", kind="lump", position=(1.0, 0.0, 0.0), mass=2.0)
    world.add_distance(a="ground", b="bob")
    world.step(100)
    return world


def median_step(world, count=3000):
    """Return the median of wall time of a call and of the C++ step [µs]."""
    calls, steps = [], []
    for _ in range(count):
        begin = time.perf_counter_ns()
        world.step()
        calls.append(time.perf_counter_ns() - begin)
        steps.append(world.stats["step_seconds"])
    return statistics.median(calls) * 1e-3, statistics.median(steps) * 1e6


class Controller(hawser.System):
    """Damper along x."""

    def prestep(self, step, loads):
        loads.add_force("bob", (-0.1 * step.world.velocity[0], 0.0, 0.0))


def waits():
    """Return for each thread of this process the time for which it waited for a processor [s]."""
    return {task.parent.name: int(task.read_text().split()[1]) * 1e-9
            for task in pathlib.Path("/proc/self/task").glob("*/schedstat")}


def batch_seconds(threads, steps=1000):
    """Return the wall time of steps of eight worlds, and that without waits for a processor [s]."""
    with hawser.Batch(SCENES / "crane_knuckle.json", 8, threads) as batch:
        batch.step(20)
        before, begin = waits(), time.perf_counter()
        batch.step(steps)
        wall = time.perf_counter() - begin
        waited = [after - before[task] for task, after in waits().items()]
        # The threads that stepped: the process has no others that wait.
        return wall, wall - min(sorted(waited)[-threads:])


def branches(count=1000):
    """Return the number of branches whose first step equals that of the parent."""
    parent = hawser.load(SCENES / "pendulum.json")
    parent.step(50)
    state = parent.save()
    parent.step()
    child, equal = hawser.load(SCENES / "pendulum.json"), 0
    for _ in range(count):
        child.restore(state)
        child.step()
        equal += child.world.state_hash == parent.world.state_hash
    return equal


def main():
    world = pendulum()
    call, step = median_step(world)
    print(f"world.step() minus the C++ step: {call - step:6.2f} µs (limit {LIMITS['step']} µs; "
          f"call {call:.2f}, step {step:.2f})")
    blocks = []
    for _ in range(1000):
        begin = time.perf_counter_ns()
        for _ in range(100):
            x = world.position
        blocks.append((time.perf_counter_ns() - begin) * 1e-5)
    access = statistics.median(blocks)
    shared = np.shares_memory(x, world.position)
    print(f"access to world.position:        {access:6.2f} µs (limit {LIMITS['array']} µs), "
          f"memory shared: {shared}")
    world.add_system(Controller("damper"))
    with_controller, step2 = median_step(world)
    print(f"controller in Python:            {with_controller - call:6.2f} µs a step "
          f"(limit {LIMITS['controller']} µs)")
    one, two = ([min(times) for times in zip(*(batch_seconds(t) for _ in range(3)))]
                for t in (1, 2))
    print(f"8 worlds, 2 threads over 1:      {one[0] / two[0]:6.2f} (at least 1.7 on idle processors; "
          f"without waits for a processor {one[1] / two[1]:.2f})")
    equal = branches()
    print(f"branches equal to the parent:    {equal} of 1000")
    return 0 if shared and equal == 1000 else 1


if __name__ == "__main__":
    sys.exit(main())
