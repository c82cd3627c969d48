"""What a reader is given and what it gives back.

A reader is a function ``read(source: Source) -> Draft`` in a module of its own. It knows its format and nothing
else: numbers stay in the file's unit and axes, and what the format does not say stays open.
:mod:`leitmotion.io.conform` judges the open questions and turns a draft into nouns of the house.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from leitmotion.motion import FormatError, Motion, Trajectories


def glimpse(content: bytes) -> str:
    """Quote how the first line of a text that holds more than blanks begins."""
    line = next(iter(content[:400].lstrip().decode("utf-8", "replace").splitlines()), "")
    return repr("".join(mark if mark.isprintable() else " " for mark in line[:40]).strip())


@dataclass(frozen=True)
class Finding:
    """One thing that is known about a recording, and how."""

    value: Any
    """What it is: a unit's name, an axis such as "y" or "-z", a rate in hertz, a path."""

    how: str
    """"read" in the file, "guessed" because the file does not say, "given" by the caller."""

    reason: str
    """Where it stands, or why it was guessed, in words."""


@dataclass(frozen=True)
class Reading:
    """What a file holds and how it was understood."""

    recordings: tuple[Motion | Trajectories, ...]
    """One noun a person."""

    findings: dict[str, Finding]
    """By topic: "unit", "up", "rate", and where meaningful "skeleton"."""

    warnings: tuple[str, ...]
    """What is odd about the file, a sentence each."""

    path: Path
    """The file."""

    window: tuple[int, int] | None = None
    """The frames ``[start, stop)`` of the file that the recordings hold, None for all."""

    people: tuple[str, ...] = ()
    """What each recording's person is called in the file."""

    format: str = ""
    """What the file's format is called."""


@dataclass(frozen=True)
class Options:
    """What the caller knows better than the file."""

    skeleton: str | PathLike[str] | None = None
    unit: str | float | None = None
    up: str | None = None
    """An axis such as "z" or "-y"; in any case and with a plus sign it is the same."""

    rate: float | None = None
    trust: bool = False
    """Whether the file's author may run code here, as a pickle does."""

    def __post_init__(self) -> None:
        if isinstance(self.up, str):
            object.__setattr__(self, "up", self.up.lower().removeprefix("+"))


@dataclass(frozen=True)
class Source:
    """A file's bytes, where they came from, and what the caller said about them."""

    path: Path
    content: bytes
    options: Options = field(default_factory=Options)

    def lines(self) -> Iterator[tuple[int, bytes]]:
        """Give the lines one after the other, each with the byte at which it begins."""
        position = 0
        while position < len(self.content):
            stop = self.content.find(b"\n", position)
            stop = len(self.content) if stop < 0 else stop
            yield position, self.content[position:stop]
            position = stop + 1

    def line_of(self, position: int) -> int:
        """Count the lines up to the one that holds the byte at `position`, from 1."""
        return self.content.count(b"\n", 0, position) + 1

    def fault(self, position: int, expected: str, found: str, *, remedy: str = "") -> FormatError:
        """Make the error that says what was expected and found at the byte `position`."""
        return FormatError(
            f"{self.path.name}, line {self.line_of(position)}: expected {expected}, found {found}.",
            remedy=remedy,
        )

    def error(self, message: str, *, remedy: str = "") -> FormatError:
        """Make an error about the file as a whole."""
        return FormatError(f"{self.path.name}: {message}", remedy=remedy)


@dataclass
class SkeletonTake:
    """One person's joints as the file has them."""

    names: list[str]
    parents: np.ndarray
    offsets: np.ndarray
    end_parents: np.ndarray
    end_offsets: np.ndarray
    positions: np.ndarray
    rotations: np.ndarray
    person: str = ""


@dataclass
class PointTake:
    """One person's points as the file has them; NaN where unseen."""

    names: list[str]
    positions: np.ndarray
    kind: str = "marker"
    confidence: np.ndarray | None = None
    person: str = ""


@dataclass
class Draft:
    """What a reader found: takes in the file's unit and axes, and what the format says about them."""

    takes: Sequence[SkeletonTake | PointTake]
    rate: Finding
    unit: Finding | None = None
    """None where the format does not say; a length that is "guessed" is believed where it makes the body an adult's."""

    up: Finding | None = None
    """None where the format does not say."""

    up_may_err: bool = False
    """Whether the body may contradict `up`: the vertical of a C3D is that of its screen, and often was not set."""

    as_saved: bool = False
    """Whether a noun was saved here and comes back as it was, each quaternion with its sign."""

    findings: dict[str, Finding] = field(default_factory=dict)
    warnings: list[str] = field(default_factory=list)
    name: str = ""
    """What the recording is called, where the file says so."""
