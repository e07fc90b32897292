#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measure studies: equal tables with any executor and after kills, overhead, efficiency.

usage: /usr/bin/python3 python/bench_study.py [RUNS]     default: 2,000 runs and 48 long ones

The package is that of HAWSER_BUILD (build/release). The reference is a loop that loads and steps
each case in one process. Overhead and efficiency compare processor times of all processes of the
pool (/proc/PID/task/*/schedstat), which other work on the machine changes less than wall times.
Exit code: 0 if all tables are equal and only runs in flight were repeated.
"""
import json
import multiprocessing
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(os.environ.get("HAWSER_BUILD", ROOT / "build/release")).absolute()
# The folder of this script has the package without its compiled part.
sys.path[0] = str(BUILD / "python")
ENVIRONMENT = os.environ | {"PYTHONPATH": str(BUILD / "python")}


def studies(runs):
    """Return the two studies by name, as JSON documents."""
    forces = [[500000 + 5000 * k, 0, 0] for k in range(24)]
    return {
        "short": {"scene": str(ROOT / "scenes/pendulum.json"), "duration": 2.0, "cases": {
            "latin_hypercube": {"ranges": {"bodies.bob.mass": [0.5, 1.5]}, "count": runs}}},
        "long": {"scene": str(ROOT / "scenes/tow_payout.json"), "cases": {"grid": {
            "bodies.tug.force": forces, "settings.duration": [30, 90]}}}}


def used(pids):
    """Return the processor time of all threads of processes [s]."""
    files = (task for pid in pids for task in pathlib.Path(f"/proc/{pid}/task").glob("*/schedstat"))
    return sum(int(file.read_text().split()[0]) for file in files) * 1e-9


def loop(file):
    """Load and step all cases in this process. Return the processor time [s]."""
    import hawser
    from hawser import study_file
    study = study_file.from_json(file, "unused")
    document = json.loads(file.read_text())
    begin = time.process_time()
    for case in study.cases:
        session = hawser.load(document["scene"], set=dict(case.set))
        until = document.get("duration", session.duration)
        session.step(round(until / session.world.settings["step"]))
    return time.process_time() - begin


def pool_run(file, folder, workers):
    """Run a study on a pool. Return the table, wall time and processor time [s]."""
    from hawser import study_file
    study = study_file.from_json(file, folder)
    context = multiprocessing.get_context("forkserver")
    with ProcessPoolExecutor(workers, context) as pool:
        list(pool.map(abs, range(4 * workers)))  # The workers start.
        pids = [os.getpid(), *pool._processes]
        before, begin = used(pids), time.perf_counter()
        study.run(pool)
        wall, busy = time.perf_counter() - begin, used(pids) - before
    study.write_csv(folder / "table.csv")
    assert study.exit_code == 0
    return (folder / "table.csv").read_bytes(), wall, busy


def command_run(front, file, folder, *back):
    """Run a study by a command. Return the table."""
    subprocess.run([*front, "study", str(file), "-o", str(folder), "--quiet", *back], check=True,
                   env=ENVIRONMENT, stdout=subprocess.DEVNULL)
    return (folder / "table.csv").read_bytes()


def dask_run(file, folder):
    """Run a study on a Dask cluster of two workers on loopback."""
    from distributed import LocalCluster
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True,
                      dashboard_address=None) as cluster:
        return command_run([sys.executable, "-m", "hawser"], file, folder, "--dask",
                           cluster.scheduler_address)


def killed_run(file, folder, count, kills):
    """Kill a study at random counts of stored runs, and continue it. Return the table and the
    number of stored runs that were repeated."""
    command = [sys.executable, "-m", "hawser", "study", str(file), "--quiet", "--jobs", "2", "-o",
               str(folder)]
    stored, repeated = {}, 0

    def changed():
        now = {f.name: f.stat().st_mtime_ns for f in folder.glob("[0-9a-f]*.json")}
        number = sum(now[name] != at for name, at in stored.items())
        stored.update(now)
        return number

    for limit in sorted(random.Random(1).sample(range(count // 20, count - 4), kills)):
        running = subprocess.Popen(command, env=ENVIRONMENT, start_new_session=True,
                                   stdout=subprocess.DEVNULL)
        while len(list(folder.glob("[0-9a-f]*.json"))) < limit and running.poll() is None:
            time.sleep(0.01)
        assert running.poll() is None, "the study ended before it was killed"
        os.killpg(running.pid, signal.SIGKILL)
        running.wait()
        repeated += changed()
    table = command_run([sys.executable, "-m", "hawser"], file, folder, "--jobs", "2")
    return table, repeated + changed()


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    good, all_work, all_busy = True, 0.0, 0.0
    with tempfile.TemporaryDirectory() as name:
        home = pathlib.Path(name)
        for kind, data in studies(runs).items():
            file = home / f"{kind}.json"
            file.write_text(json.dumps(data))
            work, tables = loop(file), {}
            for workers in (1, 2):
                folder = home / f"{kind}{workers}"
                tables[f"{workers} processes"], wall, busy = pool_run(file, folder, workers)
                count = len(list(folder.glob("[0-9a-f]*.json")))
                print(f"{kind}: {count} runs, {workers} processes: wall {wall:.2f} s, processors "
                      f"{busy:.2f} s, loading and steps {work:.2f} s; overhead "
                      f"{1e3 * (busy - work) / count:.2f} ms a run, efficiency {work / busy:.2f}",
                      flush=True)
            all_work, all_busy = all_work + work, all_busy + busy
            tables["Dask, 2 workers"] = dask_run(file, home / f"{kind}_dask")
            mpi = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", "3", sys.executable,
                   "-m", "mpi4py.futures", "-m", "hawser"]
            if shutil.which("mpiexec"):
                tables["mpiexec -n 3"] = command_run(mpi, file, home / f"{kind}_mpi", "--mpi")
            tables["5 kills"], repeated = killed_run(file, home / f"{kind}_killed", count, 5)
            equal = len(set(tables.values())) == 1
            good = good and equal and repeated == 0
            print(f"{kind}: equal tables of {', '.join(tables)}: {equal}; stored runs that were "
                  f"repeated: {repeated}", flush=True)
        print(f"all runs, 2 processes: efficiency {all_work / all_busy:.2f}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
