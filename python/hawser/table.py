# SPDX-License-Identifier: Apache-2.0
"""Tables of `hawser run --csv`: columns with names and units over time."""
from __future__ import annotations

import csv
import os
import re
from dataclasses import dataclass

import numpy as np

__all__ = ["Column", "Table", "read"]


@dataclass(frozen=True)
class Column:
    """One quantity over time."""

    name: str
    unit: str  #: As in the header; "" if it has none.
    values: np.ndarray


@dataclass(frozen=True)
class Table:
    """A table with equal steps in time.

    >>> read("run.csv")["tow tension at first end"].unit       # doctest: +SKIP
    'N'
    """

    time: np.ndarray  #: [s]
    columns: tuple[Column, ...]

    @property
    def step(self) -> float:
        """Time between rows [s]."""
        return float((self.time[-1] - self.time[0]) / (self.time.size - 1))

    def __getitem__(self, name: str) -> Column:
        for column in self.columns:
            if column.name == name:
                return column
        raise KeyError(f"no column {name!r}; there are: " + ", ".join(c.name for c in self.columns))

    def after(self, begin: float) -> "Table":
        """Return the rows from a time [s] on."""
        rows = self.time >= begin
        if rows.sum() < 2:
            raise ValueError(f"fewer than two rows from {begin} s on; the last is at "
                             f"{self.time[-1]:g} s")
        return Table(self.time[rows],
                     tuple(Column(c.name, c.unit, c.values[rows]) for c in self.columns))


def read(path: str | os.PathLike) -> Table:
    """Read a table. Raises ValueError with file, line and column if it is not one."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = csv.reader(file)
        header = next(rows, None)
        if not header or not header[0].startswith("time"):
            raise ValueError(f"{path}:1: no table of `hawser run --csv`: the first column is time [s]")
        values: list[list[float]] = []
        for number, row in enumerate(rows, start=2):
            if len(row) != len(header):
                raise ValueError(f"{path}:{number}: {len(row)} values for {len(header)} columns")
            try:
                values.append([float(v) if v else np.nan for v in row])
            except ValueError as error:
                raise ValueError(f"{path}:{number}: {error}") from None
    if len(values) < 2:
        raise ValueError(f"{path}: fewer than two rows of values")
    data = np.array(values)
    names = [re.fullmatch(r"(.*?)(?: \[([^\]]*)\])?", h) for h in header]
    columns = tuple(Column(n.group(1), n.group(2) or "", data[:, i])
                    for i, n in enumerate(names) if i > 0 and n)
    return Table(data[:, 0], columns)
