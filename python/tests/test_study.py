# SPDX-License-Identifier: Apache-2.0
"""Test studies: equal tables with any executor, resumption, failures as rows, study files."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import hawser
from hawser.study_file import from_json

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import study_functions  # noqa: E402

SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
PENDULUM = SCENES / "pendulum.json"
ENVIRONMENT = os.environ | {"PYTHONPATH": os.pathsep.join(
    [str(pathlib.Path(hawser.__file__).parents[1]), str(pathlib.Path(__file__).parent)])}


def masses(*values):
    return hawser.grid({"bodies.bob.mass": list(values)})


def made(folder, cases, **given):
    given = {"duration": 0.5, "function": study_functions.position} | given
    return hawser.Study(PENDULUM, cases, folder=folder, **given)


def table(one):
    return [[str(v) for v in row.values()] for row in one.rows()]


def test_cases():
    assert [c.set for c in hawser.grid({"a": [1, 2], "b": [3]})] == [{"a": 1, "b": 3},
                                                                    {"a": 2, "b": 3}]
    x = np.sort([c.set["a"] for c in hawser.latin_hypercube({"a": (2.0, 4.0)}, 10, seed=3)])
    assert np.all(np.floor((x - 2.0) / 0.2) == np.arange(10))  # one value in each interval
    sea = hawser.scatter([(1.0, 6.0, 30), (2.0, 7.0, 10), (3.0, 8.0, 0)])
    assert [c.weight for c in sea] == [0.75, 0.25]
    both = hawser.product(sea, hawser.seeds("sea.waves.0.seed", 5))
    assert len(both) == 10 and abs(sum(c.weight for c in both) - 1.0) < 1e-12
    for bad in (lambda: hawser.grid({"a": []}), lambda: hawser.scatter([(1, 2)]),
                lambda: hawser.latin_hypercube({"a": (2, 1)}, 3), lambda: hawser.seeds("a", 0)):
        with pytest.raises(hawser.StudyError):
            bad()


def test_tables_do_not_depend_on_the_executor(tmp_path):
    cases = hawser.latin_hypercube({"bodies.bob.mass": (0.5, 1.5)}, 12)
    tables = []
    for name, run in (("one", lambda s: s.run(jobs=1)), ("two", lambda s: s.run(jobs=2)),
                      ("threads", lambda s: s.run(ThreadPoolExecutor(2)))):
        one = made(tmp_path / name, cases)
        run(one)
        assert one.exit_code == 0
        one.write_csv(tmp_path / f"{name}.csv")
        tables.append((tmp_path / f"{name}.csv").read_bytes())
    assert len(set(tables)) == 1


def test_dask_gives_the_same_table(tmp_path):
    distributed = pytest.importorskip("distributed")
    cases = masses(0.5, 1.0, 1.5)
    local = made(tmp_path / "local", cases)
    local.run(jobs=1)
    remote = made(tmp_path / "dask", cases)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True,
                                  dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            client.run(lambda p: sys.path.insert(0, p), str(pathlib.Path(__file__).parent))
            remote.run(client.get_executor())
    assert table(remote) == table(local)


def test_mpi_gives_the_same_table(tmp_path):
    pytest.importorskip("mpi4py")
    if shutil.which("mpiexec") is None:
        pytest.skip("mpiexec is not installed")
    file = tmp_path / "study.json"
    file.write_text(json.dumps({"scene": str(PENDULUM), "duration": 0.5,
                                "cases": {"grid": {"bodies.bob.mass": [0.5, 1.0, 1.5]}}}))
    mpi = ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", "3"]
    tables = []
    for name, front, back in (("local", [sys.executable, "-m", "hawser"], ["--jobs", "1"]),
                              ("mpi", [*mpi, sys.executable, "-m", "mpi4py.futures", "-m",
                                       "hawser"], ["--mpi"])):
        done = subprocess.run([*front, "study", str(file), "-o", str(tmp_path / name), "--quiet",
                               *back], env=ENVIRONMENT, capture_output=True, text=True, timeout=120)
        assert done.returncode == 0, done.stderr
        tables.append((tmp_path / name / "table.csv").read_bytes())
    assert tables[0] == tables[1]


def test_stored_runs_are_not_repeated(tmp_path):
    first = made(tmp_path / "a", masses(0.5, 1.0))
    first.run(jobs=1)
    times = {f.name: f.stat().st_mtime_ns for f in (tmp_path / "a").glob("*.json")}
    assert len(times) == 2
    more = made(tmp_path / "a", masses(0.5, 1.0, 1.5))
    more.run(jobs=1)
    assert table(more)[:2] == table(first)
    for name, at in times.items():
        assert (tmp_path / "a" / name).stat().st_mtime_ns == at
    other = made(tmp_path / "a", masses(0.5), duration=0.25)  # another identity
    other.run(jobs=1)
    assert other.results[0].id != first.results[0].id
    # A file that was cut is not accepted.
    cut = tmp_path / "a" / f"{first.results[0].id}.json"
    cut.write_text(cut.read_text()[:40])
    again = made(tmp_path / "a", masses(0.5, 1.0))
    again.run(jobs=1)
    assert table(again) == table(first)


def test_killed_studies_continue(tmp_path):
    file = tmp_path / "study.json"
    file.write_text(json.dumps({"scene": str(PENDULUM), "duration": 2.0, "cases": {
        "latin_hypercube": {"ranges": {"bodies.bob.mass": [0.5, 1.5]}, "count": 150}}}))
    command = [sys.executable, "-m", "hawser", "study", str(file), "--quiet", "--jobs", "2", "-o"]
    for k in range(2):
        running = subprocess.Popen([*command, str(tmp_path / "killed")], env=ENVIRONMENT,
                                   start_new_session=True)
        until = time.monotonic() + 60
        while (len(list((tmp_path / "killed").glob("*.json"))) < 20 * (k + 1)
               and running.poll() is None and time.monotonic() < until):
            time.sleep(0.01)
        os.killpg(running.pid, signal.SIGKILL)
        running.wait()
    stored = {f.name: f.stat().st_mtime_ns for f in (tmp_path / "killed").glob("*.json")}
    for name in ("killed", "whole"):
        subprocess.run([*command, str(tmp_path / name)], env=ENVIRONMENT, check=True)
    for name, at in stored.items():
        assert (tmp_path / "killed" / name).stat().st_mtime_ns == at
    assert ((tmp_path / "killed/table.csv").read_bytes() ==
            (tmp_path / "whole/table.csv").read_bytes())


def test_failures_are_rows(tmp_path):
    one = made(tmp_path, masses(1.0, -1.0, 3.0), function=study_functions.fail_if_heavy)
    one.run(jobs=1)
    assert [r.outcome for r in one.results] == ["good", "refused", "failed"]
    assert "mass" in one.results[1].reason and "too heavy" in one.results[2].reason
    assert one.exit_code == 2
    # A block has several cases: a failure in it is that of one case.
    many = made(tmp_path / "many", masses(*[1.0 + 0.01 * k for k in range(23)], 3.0),
                function=study_functions.fail_if_heavy)
    many.run(jobs=1)
    assert [r.outcome for r in many.results] == ["good"] * 23 + ["failed"]
    with pytest.raises(hawser.StudyError, match="all 1 cases are refused"):
        made(tmp_path, masses(-1.0)).run(jobs=1)


def test_dead_workers_are_named(tmp_path):
    one = made(tmp_path, masses(1.0, 3.0, 0.5, 1.5), function=study_functions.die_if_heavy)
    one.run(jobs=2)
    assert [r.outcome for r in one.results] == ["good", "lost", "good", "good"]
    assert one.exit_code == 2


def test_responses(tmp_path):
    one = hawser.Study(SCENES / "moored_barge.json",
                       hawser.scatter([(1.0, 7.0, 1), (2.0, 8.0, 1)]),
                       set={"sea.waves.0.kind": "jonswap"}, duration=12.0, begin=2.0, every=0.1,
                       responses=["north_east_tension"], folder=tmp_path)
    one.run(jobs=2)
    one.write_csv(tmp_path / "first.csv")
    one.run(jobs=1)  # All results are stored: columns have the same order.
    one.write_csv(tmp_path / "second.csv")
    assert (tmp_path / "first.csv").read_bytes() == (tmp_path / "second.csv").read_bytes()
    value = one.results[0].values
    assert value["north_east_tension.min"] <= value["north_east_tension.mean"] \
        <= value["north_east_tension.max"]
    assert value != one.results[1].values
    assert one.mean("north_east_tension.max") == pytest.approx(
        np.mean([r.values["north_east_tension.max"] for r in one.results]))
    wrong = hawser.Study(SCENES / "moored_barge.json", [{}], responses=["north_east"],
                         folder=tmp_path)
    with pytest.raises(hawser.StudyError, match="north_east_tension"):
        wrong.run(jobs=1)


def test_tables_and_plots(tmp_path):
    pandas = pytest.importorskip("pandas")
    one = made(tmp_path, masses(0.5, 1.0))
    one.run(jobs=1)
    frame = one.frame()
    assert isinstance(frame, pandas.DataFrame) and list(frame["bodies.bob.mass"]) == [0.5, 1.0]
    h5py = pytest.importorskip("h5py")
    one.write_hdf5(tmp_path / "table.h5")
    with h5py.File(tmp_path / "table.h5") as stored:
        assert list(stored["x"]) == list(frame["x"])
        assert stored["outcome"].asstr()[0] == "good"


@pytest.mark.parametrize("data, words", [
    ({"cases": {"list": [{}]}}, "/scene: missing"),
    ({"scene": "a.json", "cases": {"grid": {"a": []}}}, "/cases/grid: grid: a"),
    ({"scene": "a.json", "cases": {"gird": {}}}, "/cases/gird: unknown"),
    ({"scene": "a.json", "cases": {"list": [{}]}, "durations": 1}, "/durations: unknown"),
    ({"scene": "a.json", "cases": {"list": [{}]}, "duration": -1}, "duration: give"),
])
def test_study_files_are_checked(tmp_path, data, words):
    file = tmp_path / "study.json"
    file.write_text(json.dumps(data))
    with pytest.raises(hawser.StudyError, match=words) as error:
        from_json(file, tmp_path)
    assert str(file) in str(error.value)
