# SPDX-License-Identifier: Apache-2.0
"""Recordings as numpy arrays and xarray data sets."""
from __future__ import annotations

import os
from collections import abc
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core, notebook
from .session import Event

if TYPE_CHECKING:
    import xarray

__all__ = ["Recording"]


class Recording(_core.Recording):
    """Recording of a run; poses and tensions have single precision.

    Parameters
    ----------
    file : path
        File of `Session.record` or `hawser run --record`.

    Notes
    -----
    Arrays are decoded on first use and kept. Values of bodies that do not exist in a frame are NaN.
    """

    def __init__(self, file: str | os.PathLike[str]) -> None:
        super().__init__(os.fspath(file))
        self._decoded: dict[str, Any] = {}

    def _once(self, name: str, decode: abc.Callable[[], Any]) -> Any:
        """Return the result of decode(), which is called for the first request of a name only."""
        if name not in self._decoded:
            self._decoded[name] = decode()
        return self._decoded[name]

    @property
    def _frame_heads(self) -> dict[str, np.ndarray]:
        return self._once("heads", self._heads)

    @property
    def _frame_poses(self) -> tuple[np.ndarray, np.ndarray]:
        return self._once("poses", self._poses)

    @property
    def time(self) -> np.ndarray:
        """Time of each frame [s]."""
        return self._frame_heads["time"]

    @property
    def energy(self) -> np.ndarray:
        """Mechanical energy in each frame [J]."""
        return self._frame_heads["energy"]

    @property
    def branch(self) -> np.ndarray:
        """Branch of each frame: number of restored states before it."""
        return self._frame_heads["branch"]

    @property
    def hashes(self) -> np.ndarray:
        """Motion hash of each frame."""
        return self._frame_heads["hash"]

    @property
    def tensions(self) -> np.ndarray:
        """Tension of each element of all cables [N]: array (frames, elements)."""
        return self._once("tensions", self._tensions)

    @property
    def events(self) -> list[Event]:
        """Events of the run."""
        return self._once("events", lambda: self._events(Event))

    def body(self, name: str) -> int:
        """Return the index of a body. Raises KeyError."""
        try:
            return self.body_names.index(name)
        except ValueError:
            raise KeyError(f"{self.file}: there is no body \"{name}\"") from None

    def position(self, body: str | None = None) -> np.ndarray:
        """Return positions [m]: (frames, bodies, 3), or (frames, 3) of one body."""
        x = self._frame_poses[0]
        return x if body is None else x[:, self.body(body)]

    def orientation(self, body: str | None = None) -> np.ndarray:
        """Return quaternions w, x, y, z: (frames, bodies, 4), or (frames, 4) of one body."""
        q = self._frame_poses[1]
        return q if body is None else q[:, self.body(body)]

    def cable(self, name: str) -> dict[str, Any]:
        """Return the data of a cable at the start. Raises KeyError."""
        for cable in self.cables:
            if cable["name"] == name:
                return cable
        names = ", ".join(c["name"] for c in self.cables)
        raise KeyError(f"{self.file}: there is no cable \"{name}\"; known: {names}")

    def tension(self, cable: str) -> np.ndarray:
        """Return the tension of the elements of a cable [N]: (frames, elements)."""
        data = self.cable(cable)
        first = data["first_element"]
        return self.tensions[:, first:first + data["elements"]]

    def output(self, name: str) -> np.ndarray:
        """Return the value of an output or signal in each frame, in SI units. Raises KeyError."""
        if name not in self.output_names:
            known = ", ".join(self.output_names[:20])
            raise KeyError(f"{self.file}: there is no output \"{name}\"; known: {known}")
        values = self._once("outputs", self._outputs)
        return values[:, self.output_names.index(name)]

    def arc_length(self, cable: str) -> np.ndarray:
        """Return the middle of each element of a cable of equal elements, from its first end [m]."""
        data = self.cable(cable)
        return (np.arange(data["elements"]) + 0.5) * data["length"] / max(1, data["elements"])

    def to_xarray(self) -> xarray.Dataset:
        """Return a data set with dimensions, units and names (needs xarray).

        Variables: position, orientation, energy, tension_CABLE for each cable, and each output
        by its name; output_NAME if a variable or coordinate has this name.
        """
        import xarray as xr

        time = ("time", self.time, {"units": "s"})
        names = [n or f"body {i}" for i, n in enumerate(self.body_names)]
        out = xr.Dataset(
            {"position": (("time", "body", "axis"), self.position(),
                          {"units": "m", "long_name": "position of the centre of mass"}),
             "orientation": (("time", "body", "quaternion"), self.orientation(),
                             {"units": "1", "long_name": "orientation, body to world"}),
             "energy": ("time", self.energy, {"units": "J", "long_name": "mechanical energy"})},
            coords={"time": time, "body": names, "axis": list("xyz"), "quaternion": list("wxyz")},
            attrs={"scene": self.scene_name, "file": self.file, "step": self.step,
                   "ending": self.ending})
        for cable in self.cables:
            name = cable["name"]
            at = f"s_{name}"
            out[f"tension_{name}"] = xr.DataArray(
                self.tension(name), dims=("time", at),
                coords={at: (at, self.arc_length(name), {"units": "m"})},
                attrs={"units": "N", "long_name": f"tension of {name}"})
        for name, unit in zip(self.output_names, self.output_units):
            key = f"output_{name}" if name in out.variables else name
            out[key] = ("time", self.output(name), {"units": unit, "long_name": name})
        return out

    def picture(self, time: float | None = None, azimuth: float = -60.0, elevation: float = 22.0,
                size: tuple[int, int] = (640, 400)) -> bytes:
        """Return a 3-D picture of a frame as PNG.

        Parameters
        ----------
        time : float, optional
            Time [s]; default: the last frame.
        azimuth, elevation : float
            Direction of the camera [deg].
        size : tuple of int
            Width and height [pixels].

        Raises
        ------
        Error
            If the program `hawser` is missing.
        """
        at = float(self.time[-1]) if time is None else time
        return notebook.draw(self.file, at, azimuth, elevation, size)

    def view(self, height: int = 480) -> notebook.Page:
        """Serve the 3-D page that plays the recording on loopback.

        In a notebook the result shows itself in an iframe.

        Parameters
        ----------
        height : int
            Height in a notebook [pixels].
        """
        return notebook.open_page([self.file], height)

    def _repr_html_(self) -> str:
        """Show a picture, tensions and events in a notebook."""
        from html import escape
        from . import plot
        rows = "".join(f"<tr><td>{e.time:.3f} s</td><td>{escape(str(e.kind))}</td>"
                       f"<td>{escape(str(e.where))}</td></tr>" for e in self.events[:20])
        parts: list[abc.Callable[[], str]] = []
        if len(self):
            parts.append(lambda: notebook.image(self.picture()))
        if len(self) and self.cables:
            parts.append(lambda: plot.png(plot.tensions(self)))
        return f"<p>{escape(repr(self))}</p>{notebook.html(*parts)}<table>{rows}</table>"

    def __repr__(self) -> str:
        last = f", to {self.time[-1]:g} s" if len(self) else ""
        return f"<hawser.Recording \"{self.file}\": {len(self)} frames{last}, {self.ending}>"
