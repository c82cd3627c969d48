"""Tables of posture pairs that a person labelled alike or not.

A comma-separated table (or semicolons, or tabs) whose first line names the columns: ``frame_a``, ``frame_b``,
``alike``, and of pairs from several recordings ``recording_a`` and ``recording_b``. ``person`` and ``group`` may say
whose pair it is and for what it is kept; other columns are let alone.
"""

from __future__ import annotations

import csv
import io
from os import PathLike
from pathlib import Path
from typing import NamedTuple

from leitmotion.io.containers import read_file
from leitmotion.io.text import as_text
from leitmotion.motion import FormatError

NEEDED = ("frame_a", "frame_b", "alike")
NAMED = ("recording_a", "recording_b")
_ALIKE = {"1": True, "true": True, "yes": True, "0": False, "false": False, "no": False}


class LabelledPair(NamedTuple):
    """Two postures, and whether a person calls them alike."""

    frame_a: int
    """0-based, of the recording as it is read."""

    frame_b: int
    alike: bool
    recording_a: str = ""
    """As the table names it; empty where the pairs are of one recording that is named elsewhere."""

    recording_b: str = ""
    person: str = ""
    group: str = ""
    line: int = 0
    """Of the table, counted from 1; 0 where there is none."""


def read_pairs(path: str | PathLike[str]) -> tuple[LabelledPair, ...]:
    r"""Read a table of labelled pairs.

    Parameters
    ----------
    path : str or path
        The table.

    Returns
    -------
    tuple of LabelledPair
        In the order of the table.

    Raises
    ------
    FormatError
        When there is no such file, a column is missing, or a cell is not what its column holds; it names the line.

    Examples
    --------
    >>> import leitmotion as lm
    >>> lm.io.write_whole("pairs.csv", "frame_a,frame_b,alike\n12,48,1\n12,30,0\n")
    PosixPath('pairs.csv')
    >>> [(pair.frame_a, pair.frame_b, pair.alike) for pair in read_pairs("pairs.csv")]
    [(12, 48, True), (12, 30, False)]
    """
    table, content = read_file(Path(path))
    text = as_text(table, content, []).decode("utf-8").removeprefix("\ufeff")
    first = text.partition("\n")[0]
    delimiter = max(",;\t", key=first.count)
    try:
        lines = list(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter))
    except csv.Error as error:
        raise FormatError(
            f"{table.name}: expected a table of pairs, found a damaged one ({error})."
        ) from None
    header = [word.strip().lower() for word in lines[0]] if lines else []
    missing = [name for name in NEEDED if name not in header]
    missing += [name for name in NAMED if name not in header and any(other in header for other in NAMED)]
    if missing:
        raise FormatError(
            f"{table.name}, line 1: expected a column {missing[0]}, found {', '.join(header[:8]) or 'nothing'}.",
            remedy=f"A table of pairs has the columns {', '.join(NAMED[:1] + NEEDED[:1] + NAMED[1:] + NEEDED[1:])}.",
        )
    pairs = [
        _pair(dict(zip(header, (cell.strip() for cell in cells), strict=False)), number, table)
        for number, cells in enumerate(lines[1:], start=2)
        if any(cell.strip() for cell in cells)
    ]
    if not pairs:
        raise FormatError(f"{table.name}: expected pairs below the names of the columns, found none.")
    return tuple(pairs)


def _pair(row: dict[str, str], line: int, table: Path) -> LabelledPair:
    where = f"{table.name}, line {line}"
    label = row.get("alike", "")
    if label.lower() not in _ALIKE:
        raise FormatError(f"{where}: expected 1 or 0 under alike, found {label!r}.")
    named = {name: row.get(name, "") for name in NAMED}
    if "recording_a" in row and not all(named.values()):
        empty = next(name for name, value in named.items() if not value)
        raise FormatError(f"{where}: expected a recording under {empty}, found an empty cell.")
    return LabelledPair(
        frame_a=_frame(row, "frame_a", where),
        frame_b=_frame(row, "frame_b", where),
        alike=_ALIKE[label.lower()],
        person=row.get("person", ""),
        group=row.get("group", ""),
        line=line,
        **named,
    )


def _frame(row: dict[str, str], column: str, where: str) -> int:
    word = row.get(column, "")
    if not word.isdecimal():
        raise FormatError(
            f"{where}: expected a frame, a whole number from 0 on, under {column}, found {word!r}."
        )
    return int(word)
