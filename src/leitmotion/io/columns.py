"""Columns of a table: which are the coordinates of a point, which the time, what the rest is; however it is stored.

Names are ``NAME_x``, ``NAME_y``, ``NAME_z``, or with a dot, a blank, brackets or nothing between name and letter, or
letter and number (``X1``, ``Y1``, ``Z1``). Points without a third column lie in a plane. ``NAME_c``,
``NAME_confidence``, ``NAME_likelihood`` or ``NAME_visibility`` is how sure the source was. Three columns of angles,
speeds or forces are no point.

A table may state its unit, vertical, rate, and what its points are: in comments, or in the metadata of its file. One
that states the kind of its points was written here: then names are exactly what stands before the last underscore.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.io.landmarks import find_landmarks
from leitmotion.io.numerals import read_rows
from leitmotion.io.points import plane_unit, split_people
from leitmotion.io.reading import Draft, Finding, PointTake, Source
from leitmotion.io.table_timing import time_rows
from leitmotion.io.units import METRES, unit_named

UP = ("x", "y", "z", "-x", "-y", "-z")
TIMES = ("time", "t", "time_s", "time_ms", "time_us", "times", "timestamp", "timestamp_ms", "seconds", "time[s]",
         "time (s)", "time (seconds)")  # fmt: skip
FRAMES = ("frame", "frame#", "frames", "frame_number", "frame_index", "frame_idx", "frame_id", "field#", "index",
          "sub frame", "")  # fmt: skip

_SUFFIX = re.compile(r"^(?P<name>.*?)(?P<mark>[\s_.:\-\[(]*)(?P<letter>[xyzXYZ])[\])]?$")
_PREFIX = re.compile(r"^(?P<letter>[xyzXYZ])[_\s]?(?P<name>\d+)$")
_SURE_WORDS = "c|conf|confidence|likelihood|visibility|score"
_SURE = re.compile(rf"^(?P<name>.+?)[\s_.:]+(?:{_SURE_WORDS})$", re.IGNORECASE)
_SURE_PREFIX = re.compile(rf"^(?:{_SURE_WORDS}|v)[\s_.:]?(?P<name>\d+)$", re.IGNORECASE)
_NO_POINT = re.compile(
    r"(?:^|[\s_.:\-])(?:angles?|rot|rotation|euler|quat|quaternion|orientation|deg|degrees|acc|accel|acceleration|gyro|"
    r"vel|velocity|speed|force|torque|moment|q|o)[\s_.:\-\[(]*$",
    re.IGNORECASE,
)
_JOINTS = ("shoulder", "elbow", "wrist", "hip", "knee", "ankle", "spine", "neck", "hand")
_FEW = 8  # names that a warning lists


class Columns(NamedTuple):
    """What the columns of a table hold, by their places in the header."""

    points: dict[str, list[int]]
    """Coordinates of each point, two or three."""

    sure: dict[str, int]
    """How sure the source was of a point."""

    time: int | None
    """When each row was."""

    frame: int | None
    """The number of each row's frame."""

    left: list[str]
    """Names of columns that are none of these."""

    @property
    def wanted(self) -> list[int]:
        """Places of all columns that must hold numbers."""
        times = [self.time] if self.time is not None else []
        return [k for triple in self.points.values() for k in triple] + list(self.sure.values()) + times


def find_columns(header: Sequence[str], *, exact: bool = False) -> Columns:
    """Tell what each column of a table is, from its name.

    Parameters
    ----------
    header : sequence of str
        The names of the columns.
    exact : bool
        Whether the names are what is written here: ``NAME_x``, with whatever the name may be.

    Returns
    -------
    Columns
        With no points where the names name none.

    Examples
    --------
    >>> find_columns(["time", "head.X", "head.Y", "phase"])
    Columns(points={'head': [1, 2]}, sure={}, time=0, frame=None, left=['phase'])
    """
    words = [word.strip().lower() for word in header]
    time = next((k for k, word in enumerate(words) if word in TIMES), None)
    frame = next((k for k, word in enumerate(words) if word in FRAMES and (word or k == 0)), None)
    points, sure = _exactly(header) if exact else _spelled(header)
    used = {k for triple in points.values() for k in triple} | set(sure.values())
    left = [word for k, word in enumerate(header) if k not in used and words[k] not in TIMES + FRAMES]
    return Columns(points, sure, time, frame, left)


def _exactly(header: Sequence[str]) -> tuple[dict[str, list[int]], dict[str, int]]:
    place = {word: k for k, word in enumerate(header)}
    letters = "xyz" if any(f"{word[:-2]}_z" in place for word in header if word.endswith("_x")) else "xy"
    points = {
        word[:-2]: [place[f"{word[:-2]}_{letter}"] for letter in letters]
        for word in header
        if word.endswith("_x") and all(f"{word[:-2]}_{letter}" in place for letter in letters)
    }
    sure = {name: place[f"{name}_confidence"] for name in points if f"{name}_confidence" in place}
    return points, sure


def _spelled(header: Sequence[str]) -> tuple[dict[str, list[int]], dict[str, int]]:
    found: dict[str, dict[str, int]] = {}
    counts: Counter[tuple[str, str]] = Counter()
    for k, word in enumerate(header):
        match = _PREFIX.match(word) or _SUFFIX.match(word)
        if match and match["name"] and not _NO_POINT.search(match["name"]):
            letter = match["letter"].lower()
            own = _numbered(match["name"], letter, counts)
            found.setdefault(own, {}).setdefault(letter, k)
    solid = any(len(letters) == 3 for letters in found.values())
    letters = "xyz" if solid else "xy"
    points = {
        name: [places[letter] for letter in letters]
        for name, places in found.items()
        if places.keys() >= set(letters)
    }
    sure = {}
    for k, word in enumerate(header):
        match = _SURE_PREFIX.match(word) or _SURE.match(word)
        own = _numbered(match["name"], "", counts) if match else ""
        if own in points:
            sure[own] = k
    return points, sure


def _numbered(name: str, letter: str, counts: Counter[tuple[str, str]]) -> str:
    """The name of a point, numbered where its column stands again: ``RKNE``, ``RKNE#2``."""
    counts[name, letter] += 1
    return name if counts[name, letter] == 1 else f"{name}#{counts[name, letter]}"


def read_columns(
    source: Source, header: Sequence[str], columns: Columns, values: np.ndarray, stated: Mapping[str, str]
) -> Draft:
    """Make points of the columns of a table.

    Parameters
    ----------
    source : Source
        The file, for what the caller gave and for errors.
    header : sequence of str
        The names of the columns.
    columns : Columns
        What :func:`find_columns` told of them.
    values : (R, C) float
        The numbers, NaN where there is none.
    stated : mapping of str to str
        What the table states about itself: "unit", "up", "rate", "kind", "name".

    Returns
    -------
    Draft
        One person a name before a colon, else one.

    Raises
    ------
    FormatError
        When nothing tells the rate.
    """
    warnings: list[str] = []
    if columns.left:
        what = (
            "A column that is no point was"
            if len(columns.left) == 1
            else f"{len(columns.left)} columns that are no points were"
        )
        more = " …" if len(columns.left) > _FEW else ""
        warnings.append(f"{what} left out: {', '.join(columns.left[:_FEW])}{more}.")
    names = list(columns.points)
    again = [name for name in names if f"{name}#2" in columns.points]
    if again and "kind" not in stated:
        warnings.append(f"Names stand more than once and were numbered: {', '.join(again)}.")
    positions = values[:, [columns.points[name] for name in names]]
    positions[~np.isfinite(positions).all(axis=-1)] = np.nan
    sure = _confidence(values, names, columns.sure, warnings) if columns.sure else None
    kind, unit = stated.get("kind") or _kind(names), _unit(stated, warnings)
    landmarks = None if "kind" in stated else find_landmarks(names, positions, warnings)
    if landmarks is not None:
        names, positions, kind, unit = landmarks.names, landmarks.positions, "joint", unit or landmarks.unit
    flat = positions.shape[-1] == 2
    video = flat or bool(columns.sure) or any(word.strip().lower() == "image" for word in header)
    timing = time_rows(
        source,
        times=None if columns.time is None else values[:, columns.time],
        column="" if columns.time is None else header[columns.time],
        numbers=None if columns.frame is None else values[:, columns.frame],
        stated=stated.get("rate", ""),
        video=video,
        warnings=warnings,
    )
    positions = timing.place(positions)
    if sure is not None:
        sure = timing.place(sure, missing=0.0)
    up = stated.get("up", "").lower()
    return Draft(
        [PointTake(names, positions, kind, sure)]  # what was written here is one person, whatever the names
        if "kind" in stated
        else split_people(names, positions, kind, sure),
        rate=timing.rate,
        unit=unit or (plane_unit(positions, "points in a plane") if flat else None),
        up=Finding(up, "read", "stated by the table")
        if up in UP and (up.endswith("y") or not flat)
        else None,
        warnings=warnings,
        name=stated.get("name", ""),
    )


def read_rows_of(
    source: Source,
    start: int,
    header: Sequence[str],
    delimiter: str,
    stated: Mapping[str, str],
    *,
    exact: bool,
) -> Draft:
    """Read the rows of numbers from byte `start` on, under names, and make points of them as :func:`read_columns`.

    Parameters
    ----------
    source : Source
        The file.
    start : int
        Byte at which the rows begin.
    header : sequence of str
        The names of the columns; those that name no coordinate are left out.
    delimiter : str
        What divides the columns.
    stated : mapping of str to str
        What the table states about itself.
    exact : bool
        Whether the names are ``NAME_x``, with whatever the name may be.

    Returns
    -------
    Draft
        One person a name before a colon, else one.

    Raises
    ------
    FormatError
        When no names are those of points, a cell is no number, there is no row or nothing tells the rate.
    """
    columns = find_columns(header, exact=exact)
    if not columns.points:
        raise source.error(
            f"expected columns such as NAME_x, NAME_y, NAME_z, found {', '.join(header[:6])}.",
            remedy="Name the columns of the table in its first line.",
        )
    rows = read_rows(source, start, len(header), delimiter=delimiter, missing=True, wanted=columns.wanted)
    if len(rows.values) == 0:
        raise source.error("expected a row a frame after the header, found none.")
    draft = read_columns(source, header, columns, rows.values, stated)
    rows.tell_cut(source, draft.warnings)
    return draft


def _unit(stated: Mapping[str, str], warnings: list[str]) -> Finding | None:
    word = stated.get("unit", "")
    named = word.lower() if word.lower() in ("px", "relative") else unit_named(word)
    if word and named is None:
        warnings.append(
            f"The unit {word!r} is none of {', '.join(METRES)}, px, relative; it was judged anew."
        )
    return Finding(named, "read", "stated by the table") if named else None


def _kind(names: list[str]) -> str:
    named = sum(any(joint in name.lower() for joint in _JOINTS) for name in names)
    return "joint" if 2 * named > len(names) else "marker"


def _confidence(
    values: np.ndarray, names: list[str], sure: dict[str, int], warnings: list[str]
) -> np.ndarray:
    """From 0 to 1: 0 where the cell is empty, 1 of a point that has no such column."""
    columns = [values[:, sure[name]] if name in sure else np.ones(len(values)) for name in names]
    stated = np.nan_to_num(np.stack(columns, axis=1), nan=0.0)
    outside = int(((stated < 0.0) | (stated > 1.0)).sum())
    if outside:
        warnings.append(f"{outside} confidences lie outside 0 to 1 and were taken as the nearer of the two.")
    return np.clip(stated, 0.0, 1.0)
