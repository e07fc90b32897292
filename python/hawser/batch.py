# SPDX-License-Identifier: Apache-2.0
"""Many worlds of one scene on threads."""
from __future__ import annotations

import itertools
import os
from collections import abc
from concurrent.futures import ThreadPoolExecutor
from types import TracebackType
from typing import Any

import numpy as np

from . import _core
from .session import Session, load

__all__ = ["Batch"]


class Batch:
    """Worlds of one scene that step on threads; results do not depend on the number of threads.

    Parameters
    ----------
    scene : path or str
        Scene file; with `text`, a name for messages.
    count : int
        Number of worlds.
    threads : int
        Number of threads; each world steps on one of them.
    inputs, outputs : sequence of str, optional
        Names of the columns of arrays in and out; default: all of the scene.
    set : mapping, optional
        Changes to the scene as in `hawser.load`.
    text : str
        Scene as JSON text, instead of a file.

    Attributes
    ----------
    errors : dict
        Exception of each world whose step failed, by its number. Such a world keeps its last good
        state, is left out of further steps, and has NaN as outputs, until it is restored.

    Examples
    --------
    >>> import hawser
    >>> with hawser.Batch("scenes/pendulum.json", 4, threads=2) as batch:
    ...     _ = batch.step(10)
    ...     len(set(batch.hashes.tolist()))
    1
    """

    def __init__(self, scene: str | os.PathLike[str] | None, count: int, threads: int = 1, *,
                 inputs: abc.Sequence[str] | None = None, outputs: abc.Sequence[str] | None = None,
                 set: abc.Mapping[str, Any] | None = None, text: str = "") -> None:
        if count < 1 or threads < 1:
            raise ValueError(f"count and threads must be >= 1, they are {count} and {threads}")
        first = load(scene, set=set, text=text)
        self.sessions = [first]
        for _ in range(count - 1):
            self.sessions.append(Session(first.path or "scene", scene_text=first.scene_text))
        self.input_names = list(first.inputs if inputs is None else inputs)
        self.output_names = list(first.outputs if outputs is None else outputs)
        for name in self.input_names:
            first.inputs[name]  # raises for an unknown name
        self._outputs = [[s.world.output(n) for n in self.output_names] for s in self.sessions]
        self.errors: dict[int, Exception] = {}
        self.threads = threads
        self._pool = ThreadPoolExecutor(threads - 1) if threads > 1 else None

    def __len__(self) -> int:
        return len(self.sessions)

    def _each(self, act: abc.Callable[[int], None]) -> None:
        """Call act(i) for each world that has not failed, on the threads."""
        numbers = itertools.count()
        stop: list[bool] = []

        def work() -> None:
            for i in numbers:  # next() of a count is atomic
                if i >= len(self.sessions) or stop:
                    return
                if i not in self.errors:
                    try:
                        act(i)
                    except Exception as error:  # noqa: BLE001
                        self.errors[i] = error

        others = [self._pool.submit(work) for _ in range(self.threads - 1)] if self._pool else []
        try:
            work()
            for other in others:
                other.result()
        except BaseException:  # Ctrl-C: end the steps of the other threads
            stop.append(True)
            while not all(other.done() for other in others):
                for session in self.sessions:
                    session.cancel()
            raise

    def step(self, count: int = 1, inputs: Any = None) -> np.ndarray:
        """Take steps in all worlds.

        Parameters
        ----------
        count : int
            Number of steps.
        inputs : array (worlds, inputs), optional
            Values of the inputs `input_names`, set before the steps.

        Returns
        -------
        array (worlds, outputs)
            Values of the outputs `output_names` after the steps, in SI units.

        Raises
        ------
        ValueError
            If `inputs` has another shape or dtype, or contains NaN.
        """
        given = None if inputs is None else self._checked(inputs)

        def act(i: int) -> None:
            session = self.sessions[i]
            if given is not None:
                for name, value in zip(self.input_names, given[i]):
                    session.set_input(name, value)
            session.step(count)

        self._each(act)
        return self.outputs

    def _checked(self, inputs: Any) -> np.ndarray:
        wanted = (len(self.sessions), len(self.input_names))
        array = np.asarray(inputs)
        if array.shape != wanted or array.dtype.kind not in "iuf":
            raise ValueError(f"inputs: expected shape {wanted} and dtype float64, got shape "
                             f"{array.shape} and dtype {array.dtype}")
        if np.isnan(array).any():
            raise ValueError("inputs: a value is NaN")
        return array.astype(float)

    @property
    def outputs(self) -> np.ndarray:
        """Present values of the outputs: (worlds, outputs); NaN in failed worlds."""
        out = np.empty((len(self.sessions), len(self.output_names)))
        for i, handles in enumerate(self._outputs):
            out[i] = np.nan if i in self.errors else [h.value for h in handles]
        return out

    @property
    def failed(self) -> np.ndarray:
        """True for each world whose step failed."""
        return np.array([i in self.errors for i in range(len(self.sessions))])

    @property
    def time(self) -> np.ndarray:
        """Simulation time of each world [s]."""
        return np.array([s.time for s in self.sessions])

    @property
    def hashes(self) -> np.ndarray:
        """State hash of each world."""
        return np.array([s.world.state_hash for s in self.sessions], dtype=np.uint64)

    def save(self, world: int = 0) -> _core.State:
        """Return the state of a world."""
        state = self.sessions[world].save()
        assert state is not None
        return state

    def restore(self, state: _core.State, worlds: abc.Sequence[int] | None = None) -> None:
        """Branch: restore one state in all worlds, or in those of the given numbers."""
        chosen = range(len(self.sessions)) if worlds is None else worlds
        for i in chosen:
            self.sessions[i].restore(state)
            self.errors.pop(i, None)

    def close(self) -> None:
        """End the threads."""
        if self._pool is not None:
            self._pool.shutdown()
            self._pool = None
            self.threads = 1

    def __enter__(self) -> Batch:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 place: TracebackType | None) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<hawser.Batch: {len(self)} worlds on {self.threads} threads>"
