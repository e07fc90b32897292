# SPDX-License-Identifier: Apache-2.0
"""Study files in JSON (docs/studies.md)."""
from __future__ import annotations

import csv
import json
import os
import pathlib
from collections import abc
from typing import Any

from .cases import Case, grid, latin_hypercube, product, scatter, seeds
from .errors import StudyError
from .study import Study

__all__ = ["from_json"]

_KEYS = {"scene", "description", "set", "duration", "from", "every", "responses", "hours", "control",
         "threads", "verify", "cases"}
_CASES = {"list", "grid", "latin_hypercube", "seeds", "scatter"}


def _cases_of(data: Any, folder: pathlib.Path) -> list[Case]:
    if not isinstance(data, abc.Mapping) or not data:
        raise StudyError("/cases: give an object with " + ", ".join(sorted(_CASES)))
    unknown = set(data) - _CASES
    if unknown:
        raise StudyError(f"/cases/{min(unknown)}: unknown; known are " + ", ".join(sorted(_CASES)))
    parts = []
    for key, value in data.items():
        try:
            if key == "list":
                parts.append([Case(dict(c)) for c in value])
            elif key == "grid":
                parts.append(grid(value))
            elif key == "latin_hypercube":
                parts.append(latin_hypercube({p: (r[0], r[1])
                                              for p, r in value["ranges"].items()},
                                             int(value["count"]), int(value.get("seed", 1))))
            elif key == "seeds":
                parts.append(seeds(value["path"], int(value["count"]), int(value.get("first", 1))))
            else:
                rows = value["rows"] if "rows" in value else _scatter_rows(folder / value["file"])
                names = {k: value[k] for k in ("height", "period") if k in value}
                parts.append(scatter(rows, **names))
        except StudyError as error:
            raise StudyError(f"/cases/{key}: {error}") from None
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise StudyError(f"/cases/{key}: {type(error).__name__}: {error}") from None
    return product(*parts)


def _scatter_rows(file: pathlib.Path) -> list[list[float]]:
    rows = []
    with open(file, newline="", encoding="utf-8") as text:
        for number, row in enumerate(csv.reader(text), start=1):
            if not row or row[0].startswith("#"):
                continue
            try:
                rows.append([float(v) for v in row])
            except ValueError:
                if number > 1:
                    raise StudyError(f"{file}:{number}: give numbers: height [m], period [s], "
                                     "occurrence") from None
    return rows


def from_json(file: str | os.PathLike[str], folder: str | os.PathLike[str]) -> Study:
    """Read a study file. Paths in it are relative to its folder.

    Raises
    ------
    StudyError
        With file and path of the mistake.
    """
    path = pathlib.Path(file)
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(data, dict):
            raise StudyError("give an object")
        unknown = set(data) - _KEYS
        if unknown:
            raise StudyError(f"/{min(unknown)}: unknown; known are " + ", ".join(sorted(_KEYS)))
        for key in ("scene", "cases"):
            if key not in data:
                raise StudyError(f"/{key}: missing")
        home = path.parent
        control = data.get("control")
        return Study(home / data["scene"], _cases_of(data["cases"], home),
                     set=data.get("set"), duration=data.get("duration"), begin=data.get("from", 0.0),
                     every=data.get("every", 0.1), responses=data.get("responses", ()),
                     hours=data.get("hours", 0.0), control=home / control if control else None,
                     threads=data.get("threads", 1), verify=data.get("verify", False),
                     folder=folder)
    except StudyError as error:
        raise StudyError(f"{path}: {error}") from None
    except (json.JSONDecodeError, TypeError) as error:
        raise StudyError(f"{path}: {error}") from None
