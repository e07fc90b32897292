# SPDX-License-Identifier: Apache-2.0
"""Hawser for Python: real-time multibody dynamics of ships, cranes, winches, rigs and cables.

>>> import hawser
>>> session = hawser.load("scenes/pendulum.json")
>>> session.step(60)

`load` runs scenes, `World` builds a world, `System` adds a controller, `Recording` reads
recordings, `Study` runs many cases, `stats` computes statistics of results. Statistics and tables
work without the compiled part.
"""
from __future__ import annotations

import contextlib
import importlib.util
import os
from typing import TYPE_CHECKING, Any

from . import stats, table
from .errors import (DefError, Error, LimitError, RecordingError, RemovedError, SceneError,
                     StepError, StudyError, ThreadError, UseError)

__version__ = "0.1.0"

# Names that need the compiled part, with their module. They are imported on first use.
_LAZY = {
    "load": "session", "Session": "session", "Event": "session",
    "World": "_core", "System": "_core", "State": "_core", "Body": "_core",
    "Interaction": "_core", "Wire": "_core", "Shape": "_core", "Material": "_core",
    "Input": "_core", "Output": "_core", "Step": "_core", "Loads": "_core",
    "instruction_set": "_core", "Recording": "recording", "Batch": "batch",
    "Study": "study", "Case": "cases", "grid": "cases", "latin_hypercube": "cases",
    "seeds": "cases", "scatter": "cases", "product": "cases",
}

__all__ = ["stats", "table", "Error", "DefError", "RemovedError", "SceneError", "LimitError",
           "UseError", "ThreadError", "RecordingError", "StepError", "StudyError", "load",
           "Session", "Event", "World", "System", "State", "Body", "Interaction", "Wire", "Shape",
           "Material", "Input", "Output", "Step", "Loads", "instruction_set", "Recording", "Batch",
           "Study", "Case", "grid", "latin_hypercube", "seeds", "scatter", "product"]

if TYPE_CHECKING:
    from ._core import (Body, Input, Interaction, Loads, Material, Output, Shape, State, Step,
                        System, Wire, World, instruction_set)
    from .batch import Batch
    from .cases import Case, grid, latin_hypercube, product, scatter, seeds
    from .recording import Recording
    from .session import Event, Session, load
    from .study import Study


def __getattr__(name: str) -> Any:
    if name not in _LAZY:
        raise AttributeError(f"module 'hawser' has no attribute '{name}'")
    try:
        module = importlib.import_module(f".{_LAZY[name]}", __name__)
    except ImportError as error:
        if importlib.util.find_spec("hawser._core") is not None:
            raise
        raise ImportError("the compiled part of hawser is missing: install the wheel of `make wheel`,"
                          " or set PYTHONPATH to build/release/python") from error
    if "HAWSER_READER" not in os.environ:  # The program reads .nc and .h5 files of coefficients.
        with contextlib.suppress(Error):
            os.environ["HAWSER_READER"] = importlib.import_module(".notebook", __name__).program()
    value = getattr(module, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
