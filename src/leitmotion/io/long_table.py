"""Long tables: a row a point and frame (``frame, name, x, y, z``), turned into a row a frame."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from leitmotion.io.columns import FRAMES, TIMES
from leitmotion.io.numerals import MISSING_WORDS
from leitmotion.io.reading import Source

_NAMES = ("name", "marker", "joint", "keypoint", "landmark", "bodypart", "body_part", "point", "label", "landmark_name",
          "joint_name", "keypoint_name", "marker_name", "landmark_id", "landmark_index", "joint_id")  # fmt: skip
_PEOPLE = ("person", "person_id", "subject", "individual", "track", "track_id")
_SURE = ("c", "conf", "confidence", "likelihood", "visibility", "score")


class WideTable(NamedTuple):
    """A row a frame."""

    header: list[str]
    values: np.ndarray


@dataclass(frozen=True)
class LongTable:
    """Where a table with a row a point has what, by the place of the column."""

    frame: int | None
    time: int | None
    name: int
    person: int | None
    coordinates: tuple[int, ...]
    sure: int | None

    def widen(self, source: Source, columns: Sequence[Sequence[object]]) -> WideTable:
        """Turn it into a table with a row a frame, in the order of the frames, points in that of their first rows.

        Parameters
        ----------
        source : Source
            The file, for the error.
        columns : sequence of sequence
            The cells of each column: words or numbers.

        Returns
        -------
        WideTable
            Columns ``frame`` or ``time`` and ``NAME_x``; names of several people begin with theirs and a colon.

        Raises
        ------
        FormatError
            When a cell is no number, or a point stands twice in a frame.
        """
        moments = [place for place in (self.frame, self.time) if place is not None]
        ordered = np.stack([_numbers(source, columns[place]) for place in moments], axis=1)
        frames, rows = np.unique(ordered[:, 0], return_inverse=True)
        if not np.isfinite(frames).all():
            raise source.error("expected a frame or time in every row, found rows without.")
        words = [str(word) for word in columns[self.name]]
        if self.person is not None and len(set(columns[self.person])) > 1:
            words = [f"{person}:{word}" for person, word in zip(columns[self.person], words)]
        names = list(dict.fromkeys(words))
        place = {name: k for k, name in enumerate(names)}
        points = np.array([place[word] for word in words])
        twice = np.flatnonzero(np.bincount(rows * len(names) + points) > 1)
        if twice.size:
            frame, point = divmod(int(twice[0]), len(names))
            raise source.error(
                f"expected each point once in a frame, found {names[point]!r} twice in {frames[frame]:g}.",
                remedy="A column person or track_id tells several people apart.",
            )
        letters = [f"_{letter}" for letter in "xyz"[: len(self.coordinates)]]
        held = list(self.coordinates)
        if self.sure is not None:
            letters.append("_confidence")
            held.append(self.sure)
        values = np.full((len(frames), len(names), len(held)), np.nan)
        for k, column in enumerate(held):
            values[rows, points, k] = _numbers(source, columns[column])
        when = np.zeros((len(frames), len(moments)))
        when[rows] = ordered
        header = [word for word, place in (("frame", self.frame), ("time", self.time)) if place is not None]
        header += [f"{name}{letter}" for name in names for letter in letters]
        return WideTable(header, np.concatenate((when, values.reshape(len(frames), -1)), axis=1))


def find_long(header: Sequence[str]) -> LongTable | None:
    """Tell a table with a row a point by its columns, None for another.

    Examples
    --------
    >>> find_long(["frame", "name", "x", "y"]).coordinates, find_long(["frame", "head_x", "head_y"])
    ((2, 3), None)
    """
    words = [word.strip().lower() for word in header]

    def first(among: Sequence[str]) -> int | None:
        return next((words.index(word) for word in among if word in words), None)

    name, frame, time = first(_NAMES), first([word for word in FRAMES if word]), first(TIMES)
    if name is None or not {"x", "y"} <= set(words) or (frame is None and time is None):
        return None
    coordinates = tuple(words.index(letter) for letter in "xyz" if letter in words)
    return LongTable(frame, time, name, first(_PEOPLE), coordinates, first(_SURE))


def _numbers(source: Source, cells: Sequence[object]) -> np.ndarray:
    return np.array([_number(source, cell) for cell in cells])


def _number(source: Source, cell: object) -> float:
    try:
        return float(cell)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        word = "" if cell is None else str(cell).strip().lower()
        if not word or word.lstrip("+-").encode() in MISSING_WORDS:
            return math.nan
        raise source.error(f"expected a number, found {str(cell)[:40]!r}.") from None
