# SPDX-License-Identifier: Apache-2.0
"""Cases of studies: lists, grids, Latin hypercubes, seeds, scatter diagrams."""
from __future__ import annotations

import dataclasses
import itertools
import math
from collections import abc
from typing import Any

import numpy as np

from .errors import StudyError

__all__ = ["Case", "grid", "latin_hypercube", "seeds", "scatter", "product"]


@dataclasses.dataclass(frozen=True)
class Case:
    """One run: changes to the scene, inputs over time, weight.

    Attributes
    ----------
    set : mapping
        Changes to the scene: {"sea.waves.0.height": 2.5}.
    control : str
        File with input values over time; "": that of the study.
    weight : float
        Probability of the case, for instance of its sea state.
    """

    set: abc.Mapping[str, Any] = dataclasses.field(default_factory=dict)
    control: str = ""
    weight: float = 1.0


def grid(axes: abc.Mapping[str, abc.Sequence[Any]]) -> list[Case]:
    """Return a case for each combination of values; the last axis changes fastest."""
    for path, values in axes.items():
        if isinstance(values, (str, bytes)) or not values:
            raise StudyError(f"grid: {path}: give a list of values")
    return [Case(dict(zip(axes, values))) for values in itertools.product(*axes.values())]


def latin_hypercube(ranges: abc.Mapping[str, tuple[float, float]], count: int,
                    seed: int = 1) -> list[Case]:
    """Return `count` cases whose values of each path lie one in each of `count` equal intervals.

    M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21 (1979) 239.
    """
    if count < 1:
        raise StudyError(f"latin_hypercube: count must be >= 1, it is {count}")
    random = np.random.default_rng(seed)
    columns = {}
    for path, (low, high) in ranges.items():
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            raise StudyError(f"latin_hypercube: {path}: give two finite numbers, low < high")
        order = random.permutation(count)
        columns[path] = low + (order + random.random(count)) / count * (high - low)
    return [Case({path: float(values[i]) for path, values in columns.items()})
            for i in range(count)]


def seeds(path: str, count: int, first: int = 1) -> list[Case]:
    """Return cases with the seeds first, first + 1, … at a path such as "sea.waves.0.seed"."""
    if count < 1:
        raise StudyError(f"seeds: count must be >= 1, it is {count}")
    return [Case({path: first + i}, weight=1.0 / count) for i in range(count)]


def scatter(rows: abc.Iterable[abc.Sequence[float]], height: str = "sea.waves.0.height",
            period: str = "sea.waves.0.period") -> list[Case]:
    """Return a case for each sea state of a scatter diagram.

    Parameters
    ----------
    rows : rows of (H_s [m], T_p [s], occurrence)
        Occurrences become weights with sum 1. Rows without occurrence are omitted.
    height, period : str
        Paths of the scene.
    """
    table = [[float(v) for v in row] for row in rows]
    if not table or any(len(r) != 3 or not all(map(math.isfinite, r)) or r[2] < 0 for r in table):
        raise StudyError("scatter: give rows of three finite numbers: height [m], period [s], "
                         "occurrence >= 0")
    total = sum(r[2] for r in table)
    if total <= 0.0:
        raise StudyError("scatter: the occurrences are all 0")
    return [Case({height: h, period: t}, weight=n / total) for h, t, n in table if n > 0.0]


def product(*parts: abc.Sequence[Case]) -> list[Case]:
    """Return all combinations of cases; weights multiply, a later value of a path replaces."""
    out = []
    for combination in itertools.product(*parts):
        values: dict[str, Any] = {}
        for case in combination:
            values.update(case.set)
        controls = [c.control for c in combination if c.control]
        out.append(Case(values, controls[-1] if controls else "",
                        math.prod(c.weight for c in combination)))
    return out
