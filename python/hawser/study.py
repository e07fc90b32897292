# SPDX-License-Identifier: Apache-2.0
"""Studies: many runs of one scene with other values, on one machine or a cluster.

>>> import hawser
>>> study = hawser.Study("scenes/pendulum.json", hawser.grid({"gravity.2": [-9.81, -1.62]}),
...                      duration=2.0)
>>> len(study.cases)
2

Each run is a `Case`. Its identity is the hash of the resolved scene, the control file, the options
of the study and the version of the package. A run that is stored is not repeated: start the same
study again after an interruption. `docs/studies.md` explains files, executors and clusters.
"""
from __future__ import annotations

import contextlib
import csv
import hashlib
import inspect
import json
import math
import os
import pathlib
import tempfile
from collections import abc
from concurrent.futures import Executor, Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from typing import Any

import numpy as np

from . import __version__, stats
from .cases import Case
from .errors import DefError, Error, StepError, StudyError

__all__ = ["Study", "Result"]

#: Outcomes of a run, best first. All except "good" make a study end with exit code 2.
OUTCOMES = ("good", "doubtful", "wrong", "failed", "refused", "lost")


@dataclass(frozen=True)
class _Plan:
    """Options that all runs of a study share; sent to workers."""

    scene: str
    set: tuple[tuple[str, Any], ...]
    duration: float | None
    begin: float
    every: float
    responses: tuple[str, ...]
    hours: float
    function: abc.Callable[[Any], abc.Mapping[str, float]] | None
    control: str
    threads: int
    verify: bool
    folder: str


@dataclass
class Result:
    """Result of one run, a row of the table."""

    index: int
    id: str
    case: Case
    outcome: str
    reason: str
    time: float
    values: dict[str, float]
    hash: str = ""

    def to_json(self) -> str:
        """Return the text that a study stores."""
        return json.dumps({"id": self.id, "set": dict(self.case.set), "control": self.case.control,
                           "weight": self.case.weight, "outcome": self.outcome,
                           "reason": self.reason, "time": self.time, "hash": self.hash,
                           "values": self.values}, indent=1) + "\n"


def _stored(folder: str, identity: str, index: int, case: Case) -> Result | None:
    """Return the stored result of a run; None if there is none or it is not complete."""
    try:
        data = json.loads((pathlib.Path(folder) / f"{identity}.json").read_text(encoding="utf-8"))
        if data["id"] != identity or data["outcome"] not in OUTCOMES:
            return None
        return Result(index, identity, case, data["outcome"], data["reason"], data["time"],
                      data["values"], data["hash"])
    except (OSError, ValueError, KeyError):
        return None


def _store(folder: str, result: Result) -> None:
    """Write a result to a file by itself; readers see all of it or nothing.

    The file is not flushed to the disk. After a power failure it may be empty or cut; then it is no
    result (_stored) and its run is repeated.
    """
    handle, name = tempfile.mkstemp(dir=folder, prefix=f".{result.id}.", suffix=".part")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(result.to_json())
        os.replace(name, pathlib.Path(folder) / f"{result.id}.json")
    except BaseException:
        pathlib.Path(name).unlink(missing_ok=True)
        raise


def _code_of(function: abc.Callable[..., Any] | None) -> str:
    if function is None:
        return ""
    try:
        return inspect.getsource(function)
    except (OSError, TypeError):
        return f"{getattr(function, '__module__', '')}.{getattr(function, '__qualname__', '')}"


def _opened(plan: _Plan, case: Case) -> Any:
    from .session import load
    control = case.control or plan.control
    return load(plan.scene, set=dict(plan.set) | dict(case.set), threads=plan.threads, control=control or None,
                verify=plan.verify)


def _identity(plan: _Plan, case: Case, session: Any) -> str:
    control = case.control or plan.control
    parts = [__version__, f"{session.scene_hash:016x}", f"{session.world.settings['step']!r}",
             pathlib.Path(control).read_text(encoding="utf-8") if control else "",
             repr((plan.duration, plan.begin, plan.every, plan.responses, plan.hours,
                   plan.verify)), _code_of(plan.function)]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


def _check(plan: _Plan, cases: list[tuple[int, Case]]) -> list[tuple[int, str, str]]:
    """Load the scene of each case. Return index, identity and reason of a refusal."""
    out = []
    for index, case in cases:
        try:
            session = _opened(plan, case)
            known = set(session.outputs)
            lost = [r for r in plan.responses if r not in known]
            if lost:
                raise DefError(f"the scene has no output {lost[0]!r}; it has: "
                               + ", ".join(sorted(known)[:20]))
            out.append((index, _identity(plan, case, session), ""))
        except (Error, OSError, ValueError, RuntimeError) as error:
            text = repr((plan.scene, sorted(case.set.items()), case.control, str(error)))
            out.append((index, hashlib.sha256(text.encode()).hexdigest()[:32], str(error)))
    return out


def _figures(x: np.ndarray, plan: _Plan) -> dict[str, float]:
    s = stats.summary(x)
    out = {"mean": s.mean, "std": s.std, "min": s.minimum, "max": s.maximum, "last": float(x[-1])}
    if plan.hours > 0.0:
        with contextlib.suppress(ValueError):  # Too few peaks: no value.
            out["mpm"] = stats.most_probable_maximum(x, plan.every, 3600.0 * plan.hours)
    return {name: float(value) for name, value in out.items()}


def _grade(verdict: abc.Mapping[str, Any]) -> tuple[str, str]:
    """Return grade and reason of a finished run."""
    grade = str(verdict["grade"])
    if grade == "good":
        return grade, ""
    return grade, (f"monitor {verdict['monitor']}: {verdict['value']:.4g} at "
                   f"{verdict['time']:.6g} s; {verdict['remedy']}")


def _simulate(plan: _Plan, index: int, case: Case) -> Result:
    """Run one case."""
    session = _opened(plan, case)
    identity = _identity(plan, case, session)
    done = _stored(plan.folder, identity, index, case)
    if done is not None:
        return done
    names = plan.responses or tuple(session.outputs)
    columns = [session.world.output(name).index for name in names]
    rows: list[np.ndarray] = []

    def sample(s: Any) -> bool:
        if s.time >= plan.begin - 1e-9:
            rows.append(s.world.output_values[columns])
        return True

    outcome, reason = "good", ""
    try:
        session.run(plan.duration, plan.every, sample, progress=False)
        outcome, reason = _grade(session.world.verdict)
    except StepError as error:
        outcome, reason = "failed", str(error)
    except Error as error:
        outcome, reason = "failed", f"{type(error).__name__}: {error}"
    values: dict[str, float] = {}
    data = np.array(rows)
    for k, name in enumerate(names):
        if len(rows) > 1 and np.all(np.isfinite(data[:, k])):
            values |= {f"{name}.{key}": v for key, v in _figures(data[:, k], plan).items()}
    if plan.function is not None and outcome != "failed":
        try:
            values |= {str(k): float(v) for k, v in plan.function(session).items()}
        except Exception as error:  # Code of the user: a row of its own, others go on.
            outcome, reason = "failed", f"{type(error).__name__}: {error}"
    result = Result(index, identity, case, outcome, reason, float(session.time), values,
                    f"{session.world.state_hash:016x}")
    _store(plan.folder, result)
    return result


def _run_block(plan: _Plan, cases: list[tuple[int, Case]]) -> list[Result]:
    return [_simulate(plan, index, case) for index, case in cases]


class Study:
    """Many runs of one scene.

    Parameters
    ----------
    scene : path
        Scene file.
    cases : sequence of Case or of mappings
        Runs; mappings are changes to the scene.
    set : mapping, optional
        Changes to the scene in all runs; a value of a case replaces it.
    duration : float, optional
        End of each run [s]; default: that of the scene.
    begin : float
        Time from which outputs are sampled [s].
    every : float
        Time between samples [s].
    responses : sequence of str
        Names of outputs with statistics; default: all.
    hours : float
        Duration of the most probable maximum [h]; 0: none.
    function : callable, optional
        Function of the session at the end of a run; returns further values by name. Executors
        send it to workers, so define it in a module.
    control : path, optional
        File with input values over time for cases without their own.
    threads : int
        Worker threads of each run; results do not depend on it.
    verify : bool
        True: separate code checks each step.
    folder : path
        Folder of the results.
    """

    def __init__(self, scene: str | os.PathLike[str],
                 cases: abc.Iterable[Case | abc.Mapping[str, Any]], *,
                 set: abc.Mapping[str, Any] | None = None, duration: float | None = None,
                 begin: float = 0.0, every: float = 0.1, responses: abc.Sequence[str] = (),
                 hours: float = 0.0,
                 function: abc.Callable[[Any], abc.Mapping[str, float]] | None = None,
                 control: str | os.PathLike[str] | None = None, threads: int = 1,
                 verify: bool = False, folder: str | os.PathLike[str] = "study") -> None:
        self.cases = [c if isinstance(c, Case) else Case(dict(c)) for c in cases]
        if not self.cases:
            raise StudyError("cases: a study needs at least one case")
        for name, value, above in (("duration", duration, 0.0), ("every", every, 0.0)):
            if value is not None and not (math.isfinite(value) and value > above):
                raise StudyError(f"{name}: give a finite time above 0 s, not {value}")
        if not (math.isfinite(begin) and begin >= 0.0 and math.isfinite(hours) and hours >= 0.0):
            raise StudyError("begin and hours: give finite numbers >= 0")
        if threads < 1:
            raise StudyError(f"threads: give a number >= 1, not {threads}")
        self.folder = pathlib.Path(folder)
        self._plan = _Plan(os.path.abspath(scene), tuple((set or {}).items()), duration, begin,
                           every, tuple(responses), hours, function,
                           os.path.abspath(control) if control else "", threads, verify,
                           str(self.folder.absolute()))
        self.results: list[Result] = []

    def check(self, executor: Executor | None = None) -> list[tuple[int, str, str]]:
        """Load the scene of each case without running it.

        Returns
        -------
        list of (index, identity, reason)
            `reason` is "" if the case can run.
        """
        jobs = list(enumerate(self.cases))
        if executor is None:
            return _check(self._plan, jobs)
        futures = [executor.submit(_check, self._plan, block)
                   for block in _blocks(jobs, _workers(executor))]
        return sorted(row for future in futures for row in future.result())

    def run(self, executor: Executor | None = None, jobs: int | None = None,
            progress: abc.Callable[[int, int], None] | None = None) -> list[Result]:
        """Run all cases that have no stored result.

        All cases are checked before the first run. A refused case becomes a row of the table.

        Parameters
        ----------
        executor : concurrent.futures.Executor, optional
            Such as `dask.distributed.Client(...).get_executor()` or
            `mpi4py.futures.MPIPoolExecutor()`; default: a pool of processes.
        jobs : int, optional
            Number of processes of the default pool; default: number of processors.
        progress : callable, optional
            Called with the number of finished and of all runs.

        Returns
        -------
        list of Result
            In the order of the cases, with any executor.

        Raises
        ------
        StudyError
            If all cases are refused.
        """
        self.folder.mkdir(parents=True, exist_ok=True)
        if executor is not None:
            given = executor
            return self._run(lambda: given, False, progress)
        count = jobs or os.cpu_count() or 1
        pools: list[ProcessPoolExecutor] = []

        def pool() -> Executor:
            import multiprocessing
            for old in pools:
                old.shutdown(wait=False, cancel_futures=True)
            pools[:] = [ProcessPoolExecutor(count, multiprocessing.get_context("forkserver"))]
            return pools[0]

        try:
            return self._run(pool, True, progress)
        except BaseException:
            for p in pools:
                p.shutdown(wait=False, cancel_futures=True)
            raise
        finally:
            for p in pools:
                p.shutdown()

    def _run(self, make: abc.Callable[[], Executor], own: bool,
             progress: abc.Callable[[int, int], None] | None) -> list[Result]:
        executor = make()
        checked = self.check(executor)
        if all(reason for _, _, reason in checked):
            raise StudyError(f"all {len(checked)} cases are refused; the first: {checked[0][2]}")
        found: dict[int, Result] = {}
        waiting = []
        for index, identity, reason in checked:
            case = self.cases[index]
            if reason:
                found[index] = Result(index, identity, case, "refused", reason, 0.0, {})
            elif (done := _stored(str(self.folder), identity, index, case)) is not None:
                found[index] = done
            else:
                waiting.append((index, case))
        identity_of = {index: identity for index, identity, _ in checked}
        report = progress or (lambda done, total: None)
        report(len(found), len(self.cases))
        size = None
        while waiting:
            lost = self._run_once(executor, waiting, size, found, report)
            waiting = [(i, c) for i, c in waiting if i not in found]
            if not lost:
                break
            if size == 1 or not own:
                for index, case in lost if own else waiting:
                    found[index] = Result(index, identity_of[index], case, "lost",
                                          "the worker process ended during this run", 0.0, {})
                waiting = [(i, c) for i, c in waiting if i not in found]
            size = 1  # The next failure belongs to a single case.
            if waiting and own:
                executor = make()
        self.results = [found[i] for i in sorted(found)]
        return self.results

    def _run_once(self, executor: Executor, waiting: list[tuple[int, Case]], size: int | None,
                  found: dict[int, Result], report: abc.Callable[[int, int], None],
                  ) -> list[tuple[int, Case]]:
        """Run cases until all ended or a worker died. Return the cases of dead workers."""
        workers = 1 if size == 1 else _workers(executor)
        blocks = _blocks(waiting, workers, size)
        limit = 1 if size == 1 else len(blocks)  # One at a time tells which case kills a worker.
        lost: list[tuple[int, Case]] = []
        for begin in range(0, len(blocks), limit):
            futures: dict[Future[list[Result]], list[tuple[int, Case]]] = {
                executor.submit(_run_block, self._plan, block): block
                for block in blocks[begin:begin + limit]}
            for future in as_completed(futures):
                try:
                    for result in future.result():
                        found[result.index] = result
                    report(len(found), len(self.cases))
                except BrokenProcessPool:
                    lost += futures[future]
                except Exception as error:  # Raised by a cluster, or by files that vanished.
                    for index, case in futures[future]:
                        found[index] = Result(index, "", case, "failed",
                                              f"{type(error).__name__}: {error}", 0.0, {})
            if lost:
                break
        return lost

    # --- Results -------------------------------------------------------------------------------
    @property
    def exit_code(self) -> int:
        """0 if all runs are good, else 2."""
        return 0 if all(r.outcome == "good" for r in self.results) else 2

    def columns(self) -> list[str]:
        """Names of the columns of the table."""
        paths = list(dict.fromkeys(p for c in self.cases for p in c.set))
        values = list(dict.fromkeys(v for r in self.results for v in r.values))
        return ["run", "id", "outcome", "reason", "weight", "time", "hash", *paths, *values]

    def rows(self) -> list[dict[str, Any]]:
        """Rows of the table in the order of the cases."""
        return [{"run": r.index, "id": r.id, "outcome": r.outcome, "reason": r.reason,
                 "weight": r.case.weight, "time": r.time, "hash": r.hash, **r.case.set, **r.values}
                for r in self.results]

    def frame(self) -> Any:
        """Table as a pandas frame."""
        import pandas  # type: ignore
        return pandas.DataFrame(self.rows(), columns=self.columns())

    def write_csv(self, file: str | os.PathLike[str]) -> None:
        """Write the table; numbers have all digits."""
        with open(file, "w", newline="", encoding="utf-8") as out:
            writer = csv.DictWriter(out, self.columns(), restval="")
            writer.writeheader()
            writer.writerows(self.rows())

    def write_hdf5(self, file: str | os.PathLike[str]) -> None:
        """Write the table with a data set for each column (needs h5py)."""
        import h5py  # type: ignore
        rows = self.rows()
        with h5py.File(file, "w") as out:
            for name in self.columns():
                column = [row.get(name) for row in rows]
                numbers = all(v is None or isinstance(v, (int, float)) for v in column)
                key = name.replace("/", "|")  # "/" separates groups
                if numbers:
                    out[key] = np.array([math.nan if v is None else float(v) for v in column])
                else:
                    out.create_dataset(key, data=[str("" if v is None else v) for v in column],
                                       dtype=h5py.string_dtype())

    def mean(self, name: str) -> float:
        """Mean of a value over all runs that have it, by their weights."""
        pairs = [(r.case.weight, r.values[name]) for r in self.results if name in r.values]
        total = sum(w for w, _ in pairs)
        if not total > 0.0:
            raise StudyError(f"no run has a value {name!r}")
        return sum(w * v for w, v in pairs) / total

    def plot(self, folder: str | os.PathLike[str]) -> list[pathlib.Path]:
        """Draw minimum, mean and maximum of each response over the varied values (matplotlib).

        Returns
        -------
        list of path
            One picture for each response.
        """
        import matplotlib  # type: ignore
        matplotlib.use("Agg")
        from matplotlib import pyplot
        out = []
        names = list(dict.fromkeys(v.rpartition(".")[0] for r in self.results for v in r.values
                                   if v.endswith(".max")))
        paths = [p for p in dict.fromkeys(p for c in self.cases for p in c.set)
                 if all(isinstance(c.set.get(p), (int, float)) for c in self.cases)
                 and len({c.set[p] for c in self.cases}) > 1]
        for name in names:
            axes_count = max(1, len(paths))
            figure, axes = pyplot.subplots(1, axes_count, figsize=(4.5 * axes_count, 3.6),
                                           squeeze=False, sharey=True)
            rows = [r for r in self.results if f"{name}.max" in r.values]
            for k, axis in enumerate(axes[0]):
                x = [r.case.set[paths[k]] if paths else r.index for r in rows]
                for key, mark in (("max", "^"), ("mean", "o"), ("min", "v")):
                    axis.plot(x, [r.values[f"{name}.{key}"] for r in rows], mark, label=key,
                              markersize=4)
                axis.set_xlabel(paths[k] if paths else "run")
                axis.grid(True, alpha=0.3)
            axes[0][0].set_ylabel(name)
            axes[0][0].legend()
            figure.tight_layout()
            file = pathlib.Path(folder) / (name.replace("/", "_") + ".png")
            figure.savefig(file, dpi=120)
            pyplot.close(figure)
            out.append(file)
        return out


def _workers(executor: Executor) -> int:
    count = getattr(executor, "_max_workers", None) or getattr(executor, "num_workers", None)
    return count if isinstance(count, int) and count > 0 else os.cpu_count() or 1


def _blocks(jobs: list[tuple[int, Case]], workers: int,
            size: int | None = None) -> list[list[tuple[int, Case]]]:
    """Divide cases into blocks: about eight for each worker, at most 32 cases each."""
    count = size or max(1, min(32, len(jobs) // (8 * workers)))
    return [jobs[i:i + count] for i in range(0, len(jobs), count)]
