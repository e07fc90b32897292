# SPDX-License-Identifier: Apache-2.0
"""Runs of scenes."""
from __future__ import annotations

import copy
import json
import os
import pathlib
import sys
import tempfile
import time as clock
import typing
from collections import abc
from typing import Any

from . import _core, notebook

__all__ = ["Event", "Inputs", "Outputs", "Session", "load"]


class Event(typing.NamedTuple):
    """Event of a step.

    Attributes
    ----------
    time : float
        End of the step [s].
    kind : str
        Kind, such as "line_break".
    where : str
        Name of the interaction, body or input; "" for the whole world.
    value : float
        Value in the unit of the kind.
    """

    time: float
    kind: str
    where: str
    value: float


class Inputs(abc.Mapping[str, float]):
    """Inputs of a session by name: ``session.inputs["ahts1/tow_speed"] = 0.3``.

    They are inputs of the world, inputs of the scene that set a signal, and input signals as
    "system.signal". Values are clamped to their range.
    """

    def __init__(self, session: Session) -> None:
        self._session = session

    @property
    def _of_scene(self) -> dict[str, dict[str, Any]]:
        return {s["name"]: s for s in self._session._signal_inputs}

    def _names(self) -> dict[str, None]:
        world = self._session.world
        names = dict.fromkeys(i.name for i in world.inputs)
        names.update(dict.fromkeys(self._of_scene))
        names.update(dict.fromkeys(n for n, s in world.signals.items() if s["input"]))
        return names

    def __getitem__(self, name: str) -> float:
        world = self._session.world
        try:
            return world.input(name).value
        except KeyError:
            pass
        entry = self._of_scene.get(name)
        if entry is not None:
            return world.signal(entry["signal"]) / entry["factor"]
        return world.signal(name)

    def __setitem__(self, name: str, value: float) -> None:
        self._session.set_input(name, value)

    def __iter__(self) -> abc.Iterator[str]:
        return iter(self._names())

    def __len__(self) -> int:
        return len(self._names())

    def __contains__(self, name: object) -> bool:
        return name in self._names()

    def __repr__(self) -> str:
        return f"Inputs({dict(self)!r})"


class Outputs(abc.Mapping[str, float]):
    """Outputs of a session by name, in SI units, including signals as "system.signal"."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def __getitem__(self, name: str) -> float:
        return self._session.world.output(name).value

    def __iter__(self) -> abc.Iterator[str]:
        return iter([o.name for o in self._session.world.outputs])

    def __len__(self) -> int:
        return len(self._session.world.outputs)

    @property
    def values_array(self) -> Any:
        """Values of all outputs as an array, in the order of the names."""
        return self._session.world.output_values

    def unit(self, name: str) -> str:
        """Return the unit label of an output."""
        return self._session.world.output(name).unit

    def __repr__(self) -> str:
        return f"Outputs({dict(self)!r})"


class Session(_core.Session):
    """Run of a scene with its inputs, timeline and files; `load` creates one.

    Examples
    --------
    >>> import hawser
    >>> session = hawser.load("scenes/pendulum.json")
    >>> session.step(60)
    >>> round(session.time, 3)
    0.5
    """

    def __init__(self, file: str = "", *, options: abc.Mapping[str, Any] | None = None,
                 **given: Any) -> None:
        self._options = dict(options or {})
        super().__init__(file, **self._options, **given)

    @property
    def inputs(self) -> Inputs:
        """Inputs by name; values may be set."""
        return Inputs(self)  # Not kept: a cycle of references would keep worlds in memory.

    @property
    def outputs(self) -> Outputs:
        """Outputs by name."""
        return Outputs(self)

    @property
    def events(self) -> list[Event]:
        """Events of the last call of `step`, or of the last block of `run`."""
        return self._events(Event)

    @property
    def stats(self) -> dict[str, Any]:
        """Figures of the last step."""
        return self.world.stats

    def step(self, count: int = 1) -> None:
        """Take steps without the interpreter lock.

        Parameters
        ----------
        count : int
            Number of steps.

        Raises
        ------
        StepError
            If a step fails; the state is the last good one.
        KeyboardInterrupt
            After Ctrl-C, within 0.1 s.
        """
        self._step(count)

    def run(self, until: float | None = None, every: float | None = None,
            callback: abc.Callable[[Session], object] | None = None,
            progress: bool | None = None) -> None:
        """Take steps until a time.

        Parameters
        ----------
        until : float, optional
            Simulation time [s]; default: the duration of the scene.
        every : float, optional
            Time between calls of `callback` [s], at least a step; default: each step.
        callback : callable, optional
            Called with the session after each interval. The run ends if it returns False.
        progress : bool, optional
            Show a progress bar (tqdm, if installed); default: in a terminal, for runs above 2 s.
        """
        h = self.world.settings["step"]
        end = self.duration if until is None else float(until)
        if every is not None and not every > 0.0:
            raise ValueError(f"every: the time must be above 0 s, it is {every}")
        total = max(0, round((end - self.time) / h))
        block = 1 if every is None else max(1, round(every / h))
        if callback is None and every is None:
            block = max(1, round(0.1 / h))
        bar = _Progress(total, h, progress)
        done = 0
        try:
            while done < total:
                count = min(block, total - done)
                self.step(count)
                done += count
                bar.add(count)
                if callback is not None and callback(self) is False:
                    break
        finally:
            bar.close()

    def save(self, file: str | os.PathLike[str] | None = None) -> _core.State | None:
        """Save the present state.

        Parameters
        ----------
        file : path, optional
            File that only this scene restores (`load(..., restore=file)`). Without it, the state
            is returned.
        """
        if file is None:
            return self._save()
        self._save_file(os.fspath(file))
        return None

    def restore(self, state: _core.State | str | os.PathLike[str]) -> None:
        """Restore a state of this session, or a file of `save`.

        Timeline and control file continue from its time. A recording continues with a new branch.
        """
        if not isinstance(state, _core.State):
            other = _revive(self.scene_text, self.path, self._kept_options(), os.fspath(state))
            state = other._save()
        self._restore(state)

    def _kept_options(self) -> dict[str, Any]:
        """Return the options that are not part of `scene_text`."""
        return {k: v for k, v in self._options.items() if k in ("threads", "budget", "budget_work")}

    def __deepcopy__(self, memo: dict[int, Any]) -> Session:
        other = Session(self.path or "scene", scene_text=self.scene_text,
                        options=self._kept_options())
        other._restore(self._save())
        return other

    def __reduce__(self) -> tuple[Any, ...]:
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "state")
            self._save_file(file)
            data = pathlib.Path(file).read_bytes()
        return _unpickle, (self.scene_text, self.path, self._kept_options(), data)

    def picture(self, azimuth: float = -60.0, elevation: float = 22.0,
                size: tuple[int, int] = (640, 400)) -> bytes:
        """Return a 3-D picture of the present state as PNG.

        Parameters
        ----------
        azimuth, elevation : float
            Direction of the camera [deg].
        size : tuple of int
            Width and height [pixels].

        Raises
        ------
        Error
            If the program `hawser` is missing, or if the session has no scene.
        """
        with tempfile.TemporaryDirectory() as folder:
            state, file = copy.deepcopy(self), os.path.join(folder, "state.hwr")
            state.record(file)
            state.finish()
            return notebook.draw(file, self.time, azimuth, elevation, size)

    def view(self, height: int = 480) -> notebook.Page:
        """Serve the live 3-D page on loopback, starting at the present state.

        The page runs a copy of the session: it does not change this one. In a notebook the result
        shows itself in an iframe.

        Parameters
        ----------
        height : int
            Height in a notebook [pixels].
        """
        folder = tempfile.TemporaryDirectory()
        scene, state = (os.path.join(folder.name, name) for name in ("scene.json", "state.hws"))
        pathlib.Path(scene).write_text(self.scene_text, encoding="utf-8")
        self.save(state)
        return notebook.open_page([scene, "--restore", state], height, folder)

    def _repr_html_(self) -> str:
        """Show a picture and the outputs in a notebook."""
        from html import escape
        rows = "".join(f"<tr><td>{escape(o.name)}</td><td>{o.value:.5g}</td>"
                       f"<td>{escape(o.unit)}</td></tr>" for o in self.world.outputs[:60])
        return (f"<p>{escape(repr(self))}</p>"
                + notebook.html(lambda: notebook.image(self.picture()))
                + f"<table>{rows}</table>")

    def __repr__(self) -> str:
        return f"<hawser.Session \"{self.name or self.path}\", t = {self.time:g} s>"


def _revive(text: str, path: str, options: abc.Mapping[str, Any], state_file: str) -> Session:
    return Session(path or "scene", scene_text=text, options=options, restore=state_file)


def _unpickle(text: str, path: str, options: abc.Mapping[str, Any], data: bytes) -> Session:
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "state")
        pathlib.Path(file).write_bytes(data)
        return _revive(text, path, options, file)


class _Progress:
    """Progress bar of a run in seconds of simulation time."""

    def __init__(self, total: int, step: float, wanted: bool | None) -> None:
        self._bar: Any = None
        self._step, self._total, self._begin = step, total, clock.monotonic()
        self._wanted = sys.stderr.isatty() if wanted is None else wanted
        self._at_once = wanted is True
        self._done = 0
        if self._at_once:
            self._open()

    def _open(self) -> None:
        try:
            import tqdm  # type: ignore
        except ImportError:
            self._wanted = False
            return
        self._bar = tqdm.tqdm(total=self._total * self._step, unit="s", leave=self._at_once,
                              bar_format="{l_bar}{bar}| {n:.1f}/{total:.1f} s [{elapsed}<{remaining}]")
        self._bar.update(self._done * self._step)

    def add(self, count: int) -> None:
        self._done += count
        if self._bar is not None:
            self._bar.update(count * self._step)
        elif self._wanted and clock.monotonic() - self._begin > 2.0:
            self._open()

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()


def load(scene: str | os.PathLike[str] | None = None, *, text: str = "",
         set: abc.Mapping[str, Any] | None = None, threads: int = 1, scale: int = 1,
         step: float | None = None, budget: float = 0.0, budget_work: float = 0.0,
         operations: str | os.PathLike[str] | None = None,
         restore: str | os.PathLike[str] | None = None,
         control: str | os.PathLike[str] | None = None,
         record: str | os.PathLike[str] | None = None, csv: str | os.PathLike[str] | None = None,
         every: int = 1, verify: bool = False) -> Session:
    """Load a scene and return a session at its start state.

    Parameters
    ----------
    scene : path
        Scene file.
    text : str
        Scene as JSON text, instead of a file.
    set : mapping
        Changes to the scene: {"settings.step": 0.01, "bodies.rig.mass": 2e7}.
    threads : int
        Worker threads; results do not depend on the number.
    scale : int
        Number of copies of the scene along `repeat.offset`.
    step : float, optional
        Replaces settings.step [s].
    budget, budget_work : float
        Limits of the solver in a step: CPU time [s], work [flop]; 0: none.
    operations : path, optional
        File of further operations in the format of the key "timeline".
    restore : path, optional
        File of `Session.save`.
    control : path, optional
        File with input values over time.
    record, csv : path, optional
        Recording, and table of tensions and motions.
    every : int
        Steps between frames and between rows.
    verify : bool
        Check each step by the verifier.

    Returns
    -------
    Session

    Raises
    ------
    SceneError
        If the scene is invalid, with file and position.
    """
    if (scene is None) == (not text):
        raise ValueError("load: give a scene file or a text")
    options: dict[str, Any] = {"threads": threads, "scale": scale, "step": step, "budget": budget,
                               "budget_work": budget_work}
    if operations is not None:
        options["operations"] = os.fspath(operations)
    if set:
        options["set"] = [f"{path}={_assigned(value)}" for path, value in set.items()]
    files = {"restore": restore, "control": control, "record": record, "csv": csv}
    given = {key: os.fspath(file) for key, file in files.items() if file is not None}
    return Session("scene" if scene is None else os.fspath(scene), scene_text=text,  # type: ignore
                   options=options, every=every, verify=verify, **given)


def _assigned(value: Any) -> str:
    """Return a value in the form of an assignment of the program."""
    if isinstance(value, str):
        return value
    if hasattr(value, "tolist"):
        value = value.tolist()
    return json.dumps(value)
