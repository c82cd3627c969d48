"""What went wrong, in the words and the exit status that a person and a program can use."""

from __future__ import annotations

import os
import sys
import traceback
from dataclasses import dataclass

STOPPED = 130
"""Exit status after Ctrl-C, as shells count it."""

_DEFECT = (
    "This is a defect in Leitmotion, not in what you typed: please report it with the output of the same command "
    "and --traceback."
)


@dataclass(frozen=True)
class Failure:
    """One thing that went wrong: what kind, what happened, what to do, and the exception behind it."""

    type: str
    message: str
    remedy: str = ""
    error: BaseException | None = None

    @property
    def text(self) -> str:
        """The message and the remedy."""
        return f"{self.message} {self.remedy}".strip()

    @property
    def sentence(self) -> str:
        """The message and the remedy as one line for a person."""
        return f"Error: {self.text}"


def explain(error: BaseException) -> Failure:
    """Say what an exception means to the person at the shell.

    Parameters
    ----------
    error : BaseException
        What was raised. Errors of our own speak for themselves; those of the operating system are put in a
        sentence; anything else is a defect of ours and says so.

    Returns
    -------
    Failure
        Its type, message and remedy.
    """
    from leitmotion.motion.errors import LeitmotionError

    kind = type(error).__name__
    if isinstance(error, LeitmotionError):
        return Failure(kind, error.message, error.remedy, error)
    if isinstance(error, OSError):
        what = error.strerror or str(error)
        where = f"{os.fspath(error.filename)}: " if isinstance(error.filename, str | os.PathLike) else ""
        return Failure(kind, f"{where}{what}.", error=error)
    if isinstance(error, MemoryError):
        return Failure(kind, "There is not enough memory for this.", "Take a window of the recording.", error)
    return Failure(kind, f"{kind}: {error}.", _DEFECT, error)


def show_traceback(error: BaseException) -> None:
    """Print the traceback of an exception on standard error."""
    traceback.print_exception(error, file=sys.stderr)
