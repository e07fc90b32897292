# SPDX-License-Identifier: Apache-2.0
"""Pictures and live pages of sessions and recordings, drawn by the program `hawser`."""
from __future__ import annotations

import base64
import os
import pathlib
import re
import select
import shutil
import signal
import subprocess
import tempfile
import time as clock
import weakref
from collections import abc
from typing import Any

from .errors import Error

__all__ = ["Page", "draw", "image", "open_page", "program"]


def program() -> str:
    """Return the program `hawser`: HAWSER_PROGRAM, that of the package or build folder, or of PATH.

    Raises
    ------
    Error
        If there is none.
    """
    package = pathlib.Path(__file__).parent
    near = [package / "bin/hawser", package.parents[1] / "bin/hawser"]
    for file in [os.environ.get("HAWSER_PROGRAM", ""), *map(str, near), shutil.which("hawser") or ""]:
        if file and os.access(file, os.X_OK):
            return file
    raise Error("the program hawser was not found: build it (make build), or set HAWSER_PROGRAM")


def draw(recording: str, time: float, azimuth: float, elevation: float,
         size: tuple[int, int]) -> bytes:
    """Return a 3-D picture of a recording at a time [s] as PNG; angles in degrees, size in pixels."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [program(), "plot", recording, "-o", folder, "--only", "scene", "--view", "3d", "--at",
             repr(float(time)), "--azimuth", repr(float(azimuth)), "--elevation",
             repr(float(elevation)), "--size", f"{size[0]}x{size[1]}"],
            capture_output=True, text=True)
        if done.returncode != 0:
            raise Error(f"hawser plot: {done.stderr.strip()}")
        return (pathlib.Path(folder) / "scene.png").read_bytes()


def image(png: bytes) -> str:
    """Return an HTML image of a PNG."""
    return f'<img alt="picture" src="data:image/png;base64,{base64.b64encode(png).decode()}">'


def _end(process: subprocess.Popen[bytes], folder: tempfile.TemporaryDirectory[str] | None) -> None:
    """End the server and remove its files."""
    if process.poll() is None:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(10.0)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
    if process.stdout is not None:
        process.stdout.close()
    if folder is not None:
        folder.cleanup()


class Page:
    """Live 3-D page that the program serves on loopback; `close` or the end of Python ends it.

    Attributes
    ----------
    url : str
        Address of the page.
    height : int
        Height in a notebook [pixels].
    """

    def __init__(self, process: subprocess.Popen[bytes], url: str, height: int,
                 folder: tempfile.TemporaryDirectory[str] | None) -> None:
        self.url, self.height = url, height
        self._finalizer = weakref.finalize(self, _end, process, folder)

    def close(self) -> None:
        """End the server."""
        self._finalizer()

    def __enter__(self) -> Page:
        return self

    def __exit__(self, *args: object) -> None:
        self.close()

    def _repr_html_(self) -> str:
        if not self._finalizer.alive:
            return f"<p>The page {self.url.partition('#')[0]} was closed.</p>"
        return f'<iframe src="{self.url}" width="100%" height="{self.height}"></iframe>'

    def __repr__(self) -> str:
        return f"<hawser page {self.url}>"


def open_page(arguments: abc.Sequence[str], height: int,
              folder: tempfile.TemporaryDirectory[str] | None = None) -> Page:
    """Start `hawser view` on a free port of 127.0.0.1.

    Parameters
    ----------
    arguments : sequence of str
        Arguments of the command.
    height : int
        Height in a notebook [pixels].
    folder : TemporaryDirectory, optional
        Files that the page needs; removed at its end.
    """
    process = subprocess.Popen([program(), "view", *arguments, "--port", "0", "--listen",
                                "127.0.0.1"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               start_new_session=True)  # Ctrl-C does not reach it.
    assert process.stdout is not None
    text, until = b"", clock.monotonic() + 60.0
    while clock.monotonic() < until:
        if not select.select([process.stdout], [], [], 0.5)[0]:
            continue
        more = os.read(process.stdout.fileno(), 4096)
        text += more
        found = re.search(rb"^instructor\s+(\S+)\s", text, re.MULTILINE)
        if found:
            return Page(process, found[1].decode(), height, folder)
        if not more:
            break
    process.kill()
    _end(process, folder)
    raise Error(f"hawser view: {text.decode(errors='replace').strip() or 'no address in 60 s'}")


def html(*parts: abc.Callable[[], Any]) -> str:
    """Join the parts of a notebook's output, without those that raise Error or ImportError."""
    out = []
    for part in parts:
        try:
            out.append(part())
        except (Error, ImportError) as error:
            out.append(f"<p>No picture: {str(error).splitlines()[0]}</p>")
    return "".join(out)
