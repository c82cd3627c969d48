"""CSV as it is written here: ``time, NAME_x, NAME_y, NAME_z``, and what the numbers mean in comments before them.

Every number is the shortest that reads back as the same; an empty cell is a point unseen. So what
:mod:`leitmotion.io.table` reads equals what was written, to the bit, in the recording's own unit.
"""

from __future__ import annotations

import csv
import io
import json
from typing import NamedTuple

import numpy as np

from leitmotion.io.units import unit_in_metres
from leitmotion.motion import DataError, Motion, ParameterError, Trajectories, joint_points


class Sheet(NamedTuple):
    """A recording as columns."""

    header: list[str]
    """C names."""

    values: np.ndarray
    """(T, C) float, NaN where a point is unseen."""

    stated: dict[str, str]
    """What the table says about itself."""


def as_sheet(recording: Motion | Trajectories, unit: str | float | None = None) -> Sheet:
    """Lay a recording out in columns; of a skeleton the places of its joints.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames of J joints or P points.
    unit : str or float, optional
        Unit of length, a name or a number of metres; else metres, or what the points have.

    Returns
    -------
    Sheet
        A time, two or three coordinates a point, and its confidence where there is one.

    Raises
    ------
    ParameterError
        When points of a picture should be given in a unit of length.
    DataError
        When there is nothing to write.

    Examples
    --------
    >>> hands = Trajectories(("LFIN",), [[[0.1, 0.2, 0.3]]], rate=50)
    >>> as_sheet(hands).header, as_sheet(hands).values.tolist()
    (['time', 'LFIN_x', 'LFIN_y', 'LFIN_z'], [[0.0, 0.1, 0.2, 0.3]])
    """
    points = joint_points(recording) if isinstance(recording, Motion) else recording
    if not points.names or not len(points):
        raise DataError("Expected at least one point and one frame to write, found none.")
    positions, word = points.positions, points.unit
    if unit is not None and unit != points.unit:
        if points.unit != "m":
            raise ParameterError(f"Points in {points.unit} have no length to write in {unit!r}.")
        word, metres = unit_in_metres(unit)
        if word.endswith(" m"):
            raise ParameterError(f"A table names its unit: expected one such as mm, got {unit!r}.")
        positions = positions / metres
    letters = [f"_{letter}" for letter in "xyz"[: positions.shape[2]]]
    if points.confidence is not None:
        positions = np.concatenate((positions, points.confidence[..., None]), axis=2)
        letters.append("_confidence")
    header = ["time", *(f"{name}{letter}" for name in points.names for letter in letters)]
    if len(set(header)) < len(header):
        raise DataError("The names of the points make columns of one name; give them others.")
    values = np.concatenate((points.times[:, None], positions.reshape(len(points), -1)), axis=1)
    stated = {"unit": word, "up": "y", "rate": repr(float(points.rate)), "kind": points.kind}
    return Sheet(header, values, stated | ({"name": points.name} if points.name else {}))


def write(recording: Motion | Trajectories, *, unit: str | float | None = None) -> bytes:
    """Make the bytes of a CSV; parameters as in :func:`as_sheet`.

    Returns
    -------
    bytes
        UTF-8 text.

    Examples
    --------
    >>> hands = Trajectories(("LFIN", "RFIN"), [[[0.1, 0.2], [np.nan, np.nan]]], rate=50, unit="relative")
    >>> print(write(hands).decode())
    # unit: relative
    # up: y
    # rate: 50.0
    # kind: marker
    time,LFIN_x,LFIN_y,RFIN_x,RFIN_y
    0.0,0.1,0.2,,
    <BLANKLINE>
    """
    sheet = as_sheet(recording, unit)
    out = io.StringIO()
    for key, word in sheet.stated.items():
        plain = word.isprintable() and word == word.strip() and not word.startswith('"')
        out.write(f"# {key}: {word if plain else json.dumps(word)}\n")
    plain = all(word.isprintable() and word == word.strip() and ";" not in word for word in sheet.header)
    csv.writer(out, lineterminator="\n", quoting=csv.QUOTE_MINIMAL if plain else csv.QUOTE_ALL).writerow(
        sheet.header
    )
    for row in sheet.values.tolist():
        out.write(",".join(["" if number != number else repr(number) for number in row]))
        out.write("\n")
    return out.getvalue().encode("utf-8")
