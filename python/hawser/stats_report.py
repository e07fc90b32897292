# SPDX-License-Identifier: Apache-2.0
"""Printed statistics and plots of a run (`hawser stats`)."""
from __future__ import annotations

import math
import pathlib
from typing import TYPE_CHECKING

import numpy as np

from . import stats, table

if TYPE_CHECKING:
    from . import recording as recordings

__all__ = ["draw", "line", "print_column", "print_range_graphs"]

#: Number of blocks whose maxima Gumbel's distribution is fitted to.
BLOCKS = 20


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


def _maximum(fit: stats.Extreme, probability: float) -> str:
    low, high = fit.interval(probability)
    return f"{fit.quantile(probability):.5g}, 95 % interval {low:.5g} to {high:.5g}"


def print_column(column: table.Column, step: float, duration: float) -> None:
    """Print extremes, cycles and spectrum of a column. Raises ValueError if peaks are too few."""
    x, hours = column.values, duration / 3600.0
    try:
        tops = stats.fit_peaks(x)
    except ValueError as error:
        raise ValueError(f"{column.name}: {error}") from None
    print(f"\n{column.name} [{column.unit}]")
    cycles = duration / stats.up_crossing_period(x, step)
    print(f"  Weibull, {tops.count} peaks: location {tops.location:.5g}, scale {tops.scale:.5g}, "
          f"shape {tops.shape:.4g}")
    print(f"    most probable maximum in {hours:g} h: {_maximum(tops, 1.0 - 1.0 / cycles)}")
    size = x.size // BLOCKS
    blocks = stats.gumbel(x[:size * BLOCKS].reshape(BLOCKS, size).max(axis=1))
    count = duration / (size * step)
    print(f"  Gumbel, maxima of {BLOCKS} blocks of {size * step:.4g} s: location "
          f"{blocks.location:.5g}, scale {blocks.scale:.5g}")
    # The maximum of n blocks has the mode location + scale ln n, where F(x) = exp(-1/n).
    print(f"    most probable maximum in {hours:g} h: {_maximum(blocks, math.exp(-1.0 / count))}")
    found = stats.rainflow(x)
    edges = np.linspace(0.0, found[:, 0].max() * (1.0 + 1e-12), 11)
    print("  rainflow cycles by range (ASTM E1049)")
    for low, high, number in zip(edges, edges[1:], stats.rainflow_histogram(x, edges)):
        print(f"    {low:>11.5g} to {high:>11.5g}: {number:g}")
    omega, density = stats.spectrum(x, step)
    top = int(density[1:].argmax()) + 1
    print(f"  spectrum (Welch): largest at {omega[top]:.4g} rad/s, {2 * math.pi / omega[top]:.4g} s")


def print_range_graphs(run: recordings.Recording, rows: np.ndarray) -> None:
    """Print minimum, mean and maximum of the tension along each cable over its arc length."""
    for cable in run.cables:
        x = run.tension(cable["name"])[rows]
        if x.shape[1] == 0:
            continue
        print(f"\n{cable['name']}: tension [N] over arc length [m]\n"
              f"{'arc length':>12}{'minimum':>12}{'mean':>12}{'maximum':>12}")
        for values in zip(run.arc_length(cable["name"]), *stats.range_graph(x)):
            print("".join(f"{value:>12.5g}" for value in values))


def _name(text: str) -> str:
    return "".join(c if c.isalnum() or c in "._-" else "_" for c in text)


def draw(data: table.Table, run: recordings.Recording | None,
         folder: pathlib.Path) -> list[pathlib.Path]:
    """Draw series, spectrum and cycles of each column, and range graphs (needs matplotlib)."""
    import matplotlib  # type: ignore
    matplotlib.use("Agg")
    from matplotlib import pyplot

    from . import plot
    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for column in data.columns:
        x = column.values
        if not np.all(np.isfinite(x)) or np.ptp(x) == 0.0:
            continue
        figure, axes = pyplot.subplots(1, 3, figsize=(13.0, 3.5), layout="constrained")
        plot.series(data, [column.name], axes[0])
        plot.spectrum(x, data.step, axes[1])
        plot.rainflow(x, axes=axes[2])
        files.append(folder / f"{_name(column.name)}.png")
        figure.savefig(files[-1], dpi=110)
        pyplot.close(figure)
    if run is None:
        return files
    for cable in run.cables:
        if cable["elements"] == 0:
            continue
        figure = plot.range_graph(run, cable["name"]).figure
        files.append(folder / f"range_{_name(cable['name'])}.png")
        figure.savefig(files[-1], dpi=110)
        pyplot.close(figure)
    return files
