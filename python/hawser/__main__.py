# SPDX-License-Identifier: Apache-2.0
"""Statistics of a run, and studies.

python3 -m hawser stats RUN.csv        statistics of each column of a table of `hawser run --csv`
python3 -m hawser stats RUN.hwr        statistics of the tension of each cable of a recording, and
                                       of its outputs and signals
python3 -m hawser study STUDY.json -o FOLDER [--jobs N | --dask ADDRESS | --mpi]

Exit codes: 0 done; 1 wrong option or file; 2 a run of a study is not good; 130 interrupted.
"""
from __future__ import annotations

import argparse
import pathlib
import sys
from typing import TYPE_CHECKING

from . import stats_report, table
from .errors import Error

if TYPE_CHECKING:
    from . import recording as recordings


def of_recording(run: recordings.Recording) -> table.Table:
    """Return the tensions of a recording (first, last and largest element of each cable) and its
    outputs."""
    if len(run) < 2:
        raise ValueError(f"{run.file}: fewer than two frames")
    columns = []
    for cable in run.cables:
        x = run.tension(cable["name"])
        if x.shape[1] == 0:
            continue
        for label, values in (("first end", x[:, 0]), ("last end", x[:, -1]),
                              ("largest", x.max(axis=1))):
            columns.append(table.Column(f"{cable['name']} tension, {label}", "N",
                                        values.astype(float)))
    columns += [table.Column(name, unit, run.output(name))
                for name, unit in zip(run.output_names, run.output_units)]
    return table.Table(run.time, tuple(columns))


def print_stats(options: argparse.Namespace) -> int:
    try:
        run = None
        if options.file.endswith(".hwr"):
            from .recording import Recording
            run = Recording(options.file)
        elif options.range_graph:
            raise ValueError("--range-graph: give a recording (.hwr)")
        data = (table.read(options.file) if run is None else of_recording(run)).after(options.begin)
        chosen = [data[name] for name in options.column]
    except KeyError as error:
        print(f"hawser: --column: {error.args[0]}", file=sys.stderr)
        return 1
    except (Error, OSError, ValueError) as error:
        print(f"hawser: {error}", file=sys.stderr)
        return 1
    duration = 3600.0 * options.hours
    print(f"{options.file}: {data.time.size} rows, {data.time[0]:g} to {data.time[-1]:g} s, "
          f"every {data.step:g} s")
    print(f"{'column':<44}{'mean':>12}{'std':>12}{'minimum':>12}{'maximum':>12}{'period s':>10}"
          f"{f'mpm {options.hours:g} h':>12}")
    for column in data.columns:
        print(stats_report.line(column, data.step, duration))
    try:
        for column in chosen:
            stats_report.print_column(column, data.step, duration)
        if options.range_graph and run is not None:
            stats_report.print_range_graphs(run, run.time >= options.begin)
        if options.plots is not None:
            files = stats_report.draw(data, run, options.plots)
            print(f"\n{len(files)} plots in {options.plots}")
    except (ImportError, OSError, ValueError) as error:
        print(f"hawser: {error}", file=sys.stderr)
        return 1
    return 0


def _executor(options: argparse.Namespace):
    """Return the executor that the options name; None: a pool of processes."""
    if options.dask:
        from dask.distributed import Client
        return Client(options.dask).get_executor()
    if options.mpi:
        from mpi4py.futures import MPIPoolExecutor
        return MPIPoolExecutor()
    return None


def run_study(options: argparse.Namespace) -> int:
    from .study import OUTCOMES
    from .study_file import from_json
    folder = pathlib.Path(options.folder)

    def report(done: int, total: int) -> None:
        if not options.quiet:
            print(f"\r{done} of {total} runs", end="", file=sys.stderr, flush=True)

    try:
        todo = from_json(options.file, folder)
        executor = _executor(options)
        results = todo.run(executor, jobs=options.jobs, progress=report)
    except (Error, OSError, ImportError) as error:
        print(f"\nhawser: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"\ninterrupted; start again to continue from {folder}", file=sys.stderr)
        return 130
    if not options.quiet:
        print(file=sys.stderr)
    todo.write_csv(folder / "table.csv")
    for name, write in (("h5py", lambda: todo.write_hdf5(folder / "table.h5")),
                        ("matplotlib", lambda: todo.plot(folder))):
        try:
            write()
        except ImportError:
            print(f"hawser: {name} is missing: no {'table.h5' if name == 'h5py' else 'plots'}",
                  file=sys.stderr)
    counts = {o: sum(r.outcome == o for r in results) for o in OUTCOMES}
    print(f"{len(results)} runs: " + ", ".join(f"{n} {o}" for o, n in counts.items() if n)
          + f"; {folder / 'table.csv'}")
    for result in [r for r in results if r.outcome != "good"][:10]:
        print(f"  run {result.index} {dict(result.case.set)}: {result.outcome}: {result.reason}")
    return todo.exit_code


def main(arguments: list[str] | None = None) -> int:
    given = list(sys.argv[1:] if arguments is None else arguments)
    if given and given[0].endswith((".csv", ".hwr")):
        given.insert(0, "stats")
    parser = argparse.ArgumentParser(prog="python3 -m hawser", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    one = commands.add_parser("stats", help="print statistics of a run")
    one.add_argument("file", help="table of `hawser run --csv`, or a recording (.hwr)")
    one.add_argument("--from", dest="begin", type=float, default=0.0, metavar="S",
                     help="omit rows before this time [s]")
    one.add_argument("--hours", type=float, default=3.0,
                     help="duration of the most probable maximum (default 3 h)")
    one.add_argument("--column", action="append", default=[], metavar="NAME",
                     help="also print extremes (Weibull, Gumbel), cycles and spectrum of this "
                          "column; repeatable")
    one.add_argument("--range-graph", action="store_true",
                     help="also print minimum, mean and maximum tension along each cable")
    one.add_argument("--plots", type=pathlib.Path, metavar="FOLDER",
                     help="draw series, spectra, cycles and range graphs (matplotlib)")
    one.set_defaults(call=print_stats)
    many = commands.add_parser("study", help="run a study file")
    many.add_argument("file", help="study (JSON)")
    many.add_argument("-o", "--output", dest="folder", required=True,
                      help="folder of results; an interrupted study continues from it")
    where = many.add_mutually_exclusive_group()
    where.add_argument("--jobs", type=int, help="number of processes (default: all processors)")
    where.add_argument("--dask", metavar="ADDRESS", help="scheduler of a Dask cluster")
    where.add_argument("--mpi", action="store_true",
                       help="workers of `mpiexec -n N python3 -m mpi4py.futures -m hawser …`")
    many.add_argument("--quiet", action="store_true", help="no progress")
    many.set_defaults(call=run_study)
    options = parser.parse_args(given)
    if getattr(options, "jobs", None) is not None and options.jobs < 1:
        parser.error("--jobs: give a number >= 1")
    return options.call(options)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except BrokenPipeError:  # A reader such as head has closed the output.
        sys.stderr.close()
        sys.exit(1)
