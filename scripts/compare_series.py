#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compare columns of two files that `hawser run --csv` wrote (standard library only).

    scripts/compare_series.py RUN.csv REFERENCE.csv --column "work1 tension at first end" \\
                              [--from 2] [--to 600] [--every 1]

Prints, for each column whose name begins with COLUMN, the rms difference over the rms of the
reference, and the mean difference. Both are taken at common times, every `--every` seconds [s].
"""

import argparse
import csv
import math
import pathlib


def series(path, name):
    """Return the column whose name begins with `name`, by time in microseconds."""
    with path.open() as file:
        rows = csv.reader(file)
        header = next(rows)
        found = [i for i, title in enumerate(header) if title.startswith(name)]
        if len(found) != 1:
            raise SystemExit(f"{path}: {len(found)} columns begin with '{name}', to be one; it has: "
                             + ", ".join(header))
        return {round(1e6 * float(row[0])): float(row[found[0]]) for row in rows
                if row[found[0]] not in ("", "nan")}


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("run", type=pathlib.Path)
    options.add_argument("reference", type=pathlib.Path)
    options.add_argument("--column", action="append", required=True)
    options.add_argument("--from", dest="begin", type=float, default=0.0)
    options.add_argument("--to", dest="end", type=float, default=math.inf)
    options.add_argument("--every", type=float, help="seconds; by default all times of both")
    given = options.parse_args()
    for name in given.column:
        one, other = series(given.run, name), series(given.reference, name)
        times = [t for t in sorted(one.keys() & other.keys())
                 if given.begin <= 1e-6 * t <= given.end]
        if given.every:
            # Times of steps differ from the requested ones by less than a microsecond.
            each = round(1e6 * given.every)
            times = [t for t in times if min(t % each, -t % each) <= 1]
        if not times:
            raise SystemExit(f"{name}: no time in common")
        reference = math.sqrt(sum(other[t] ** 2 for t in times))
        apart = math.sqrt(sum((one[t] - other[t]) ** 2 for t in times))
        mean = sum(one[t] - other[t] for t in times) / len(times)
        share = f"{100 * apart / reference:.2f} %" if reference > 0 else "of nothing"
        print(f"{name}: {share} rms, {mean:+.4g} in the mean, {len(times)} times")


if __name__ == "__main__":
    main()
