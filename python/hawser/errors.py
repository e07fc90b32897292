# SPDX-License-Identifier: Apache-2.0
"""Exceptions of the package. All derive from `Error`."""
from __future__ import annotations

__all__ = ["Error", "DefError", "RemovedError", "SceneError", "LimitError", "UseError",
           "ThreadError", "RecordingError", "StepError", "StudyError"]


class Error(RuntimeError):
    """Base class."""


class DefError(Error, ValueError):
    """Invalid definition, name or request. The message names the field, its value and the remedy."""


class RemovedError(DefError):
    """The object of a handle was removed, or its world does not exist any more."""


class SceneError(DefError):
    """Invalid scene.

    Attributes
    ----------
    file : str
        File with the mistake.
    path : str
        JSON pointer into that file, such as "/bodies/3/mass"; "" for the whole document.
    message : str
        Description of the mistake and of the valid form.
    """

    def __init__(self, text: str, file: str = "", path: str = "", message: str = "") -> None:
        super().__init__(text)
        self.file, self.path, self.message = file, path, message

    def __reduce__(self) -> tuple[type, tuple[str, str, str, str]]:
        return type(self), (str(self), self.file, self.path, self.message)


class LimitError(Error, MemoryError):
    """A world would exceed a limit of its settings."""


class UseError(Error):
    """A world is used by a second thread, or changed within its own step."""


class ThreadError(Error):
    """The operating system provides too few worker threads."""


class RecordingError(Error, OSError):
    """A recording cannot be written or read."""


class StepError(Error):
    """A step failed; the state is the last good one.

    Attributes
    ----------
    status : str
        Status of the C++ library: "diverged", "bad_load", "cancelled", … .
    reason : str
        Cause and remedy, if known.
    """

    def __init__(self, status: str, reason: str = "") -> None:
        super().__init__(f"the step failed: {status}" + (f": {reason}" if reason else ""))
        self.status, self.reason = status, reason

    def __reduce__(self) -> tuple[type, tuple[str, str]]:
        return type(self), (self.status, self.reason)


class StudyError(Error, ValueError):
    """Invalid definition of a study."""
