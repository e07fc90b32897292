# SPDX-License-Identifier: Apache-2.0
"""Print the statistics of each column of a table that `hawser run --csv` wrote."""
import argparse
import math
import sys

import numpy as np

from . import stats, table


def line(column: table.Column, step: float, duration: float) -> str:
    """Return one row of the printed table; '-' marks values that the series does not allow."""
    x = column.values
    name = f"{column.name} [{column.unit}]" if column.unit else column.name
    if not np.all(np.isfinite(x)):
        return f"{name:<44} not finite in {int((~np.isfinite(x)).sum())} of {x.size} rows"
    s = stats.summary(x)
    period = stats.up_crossing_period(x, step)
    try:
        largest = f"{stats.most_probable_maximum(x, step, duration):>12.5g}"
    except ValueError:
        largest = f"{'-':>12}"
    shown = f"{period:>10.4g}" if math.isfinite(period) else f"{'-':>10}"
    return (f"{name:<44}{s.mean:>12.5g}{s.std:>12.5g}{s.minimum:>12.5g}{s.maximum:>12.5g}"
            f"{shown}{largest}")


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python3 -m hawser", description=__doc__)
    parser.add_argument("file", help="table of `hawser run --csv`")
    parser.add_argument("--from", dest="begin", type=float, default=0.0, metavar="S",
                        help="leave out rows before this time [s]")
    parser.add_argument("--hours", type=float, default=3.0,
                        help="duration of the most probable maximum (default 3 h)")
    options = parser.parse_args(arguments)
    try:
        data = table.read(options.file).after(options.begin)
    except (OSError, ValueError) as error:
        print(f"hawser: {error}", file=sys.stderr)
        return 1
    print(f"{options.file}: {data.time.size} rows, {data.time[0]:g} to {data.time[-1]:g} s, "
          f"every {data.step:g} s")
    print(f"{'column':<44}{'mean':>12}{'std':>12}{'minimum':>12}{'maximum':>12}{'period s':>10}"
          f"{f'mpm {options.hours:g} h':>12}")
    for column in data.columns:
        print(line(column, data.step, 3600.0 * options.hours))
    return 0


if __name__ == "__main__":
    sys.exit(main())
