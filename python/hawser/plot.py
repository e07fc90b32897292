# SPDX-License-Identifier: Apache-2.0
"""Plots of results by matplotlib. Each function returns the axes that it drew on."""
from __future__ import annotations

import io
from collections import abc
from typing import TYPE_CHECKING, Any

import numpy as np

from . import notebook, stats
from .table import Table

if TYPE_CHECKING:
    from . import recording as recordings

__all__ = ["series", "tensions", "range_graph", "spectrum", "rainflow", "png"]


def _axes(axes: Any) -> Any:
    if axes is not None:
        return axes
    from matplotlib import pyplot  # type: ignore
    return pyplot.subplots(figsize=(7.0, 3.5), layout="constrained")[1]


def series(table: Table, names: abc.Sequence[str], axes: Any = None) -> Any:
    """Draw columns of a table over time.

    Parameters
    ----------
    table : hawser.table.Table
    names : sequence of str
        Columns; their units must be equal.
    axes : matplotlib axes, optional
    """
    columns = [table[name] for name in names]
    units = {c.unit for c in columns}
    if len(units) != 1:
        raise ValueError("series: give columns of one unit, not " + ", ".join(sorted(units)))
    axes = _axes(axes)
    for column in columns:
        axes.plot(table.time, column.values, label=column.name, linewidth=1.0)
    axes.set(xlabel="time [s]", ylabel=f"[{units.pop()}]")
    axes.legend(fontsize="small")
    axes.grid(True, alpha=0.3)
    return axes


def tensions(recording: recordings.Recording, cables: abc.Sequence[str] | None = None,
             axes: Any = None) -> Any:
    """Draw the largest tension of cables over time [kN]."""
    axes = _axes(axes)
    names = [c["name"] for c in recording.cables] if cables is None else list(cables)
    for name in names:
        x = recording.tension(name)
        if x.shape[1]:
            axes.plot(recording.time, np.nanmax(x, axis=1) / 1e3, label=name, linewidth=1.0)
    axes.set(xlabel="time [s]", ylabel="largest tension [kN]")
    if names:
        axes.legend(fontsize="small")
    axes.grid(True, alpha=0.3)
    return axes


def range_graph(recording: recordings.Recording, cable: str, axes: Any = None) -> Any:
    """Draw minimum, mean and maximum of the tension along a cable [kN] over its arc length [m]."""
    axes = _axes(axes)
    low, mean, high = stats.range_graph(recording.tension(cable))
    s = recording.arc_length(cable)
    axes.fill_between(s, low / 1e3, high / 1e3, alpha=0.25, label="minimum to maximum")
    axes.plot(s, mean / 1e3, label="mean")
    axes.set(xlabel="arc length from the first end [m]", ylabel=f"tension of {cable} [kN]")
    axes.legend(fontsize="small")
    axes.grid(True, alpha=0.3)
    return axes


def spectrum(values: Any, step: float, axes: Any = None) -> Any:
    """Draw the spectral density of a series with equal steps [s] (Welch)."""
    axes = _axes(axes)
    omega, density = stats.spectrum(values, step)
    axes.plot(omega, density)
    axes.set(xlabel="ω [rad/s]", ylabel="S(ω)")
    axes.grid(True, alpha=0.3)
    return axes


def rainflow(values: Any, bins: int = 20, axes: Any = None) -> Any:
    """Draw the number of rainflow cycles by range (ASTM E1049)."""
    axes = _axes(axes)
    top = float(np.ptp(np.asarray(values, dtype=float))) or 1.0
    edges = np.linspace(0.0, top * (1.0 + 1e-12), bins + 1)
    counts = stats.rainflow_histogram(values, edges)
    axes.bar(edges[:-1], counts, width=np.diff(edges), align="edge", edgecolor="white")
    axes.set(xlabel="range", ylabel="cycles")
    return axes


def png(axes: Any) -> str:
    """Return an HTML image of the figure of axes, and close the figure."""
    from matplotlib import pyplot
    data = io.BytesIO()
    axes.figure.savefig(data, format="png", dpi=90)
    pyplot.close(axes.figure)
    return notebook.image(data.getvalue())
