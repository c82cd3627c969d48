"""Numbers in text: rows of decimals from bytes to an array, exactly as Python's ``float`` reads them, only faster."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.io.reading import Source, glimpse

MISSING_WORDS = frozenset(
    {
        b"nan",
        b"na",
        b"n/a",
        b"null",
        b"none",
        b"-",
        b"#n/a",
        b"#nan",
    }
)
"""What programs write where a number is missing, in lower case and without sign."""

_INFINITE = b"1.#"  # with which Microsoft's C begins what is no number: 1.#IND, 1.#QNAN0
_LARGEST = 1e150  # the square of a larger number is infinite
_ROOM = 64  # how many numbers a byte of a table may stand for before it is refused


class Rows(NamedTuple):
    """A block of numbers read from text."""

    values: np.ndarray
    """(R, C) float."""

    cut: bool
    """Whether the text ended within a row, which is left out."""


def as_bytes(content: bytes) -> np.ndarray:
    """View a text as an array of byte values, what the kernels take."""
    return np.frombuffer(content, dtype=np.uint8)


def read_rows(
    source: Source,
    start: int,
    columns: int,
    *,
    delimiter: str = " ",
    missing: bool = False,
    whole: bool = False,
    wanted: Sequence[int] | None = None,
) -> Rows:
    """Read the lines from byte `start` on as rows of `columns` numbers each.

    Parameters
    ----------
    source : Source
        The file.
    start : int
        Byte at which the rows begin.
    columns : int
        Numbers a row.
    delimiter : str
        What divides them; a space stands for any run of blanks.
    missing : bool
        Whether empty cells, the words in :data:`MISSING_WORDS` and the last cells of a short row are NaN; else they
        are errors.
    whole : bool
        Whether short rows are errors all the same.
    wanted : sequence of int, optional
        The columns that must be numbers; words in others are NaN.

    Returns
    -------
    Rows
        The numbers.

    Raises
    ------
    FormatError
        When a row is longer or shorter or holds something else, or a number whose square is infinite.
    """
    from leitmotion.io import _kernels

    content = source.content
    capacity = content.count(b"\n", start) + 1
    pad = missing and not whole
    if not pad:
        capacity = min(capacity, len(content) // (2 * columns) + 1)
    elif capacity * columns > _ROOM * len(content) + 1_000_000:
        raise source.error(f"expected rows of {columns} numbers, found rows that are mostly empty.")
    values = np.empty((capacity, columns))
    doubts = np.empty((capacity * columns, 3), dtype=np.int64)
    rows, doubtful, status, stopped, column = _kernels.scan_rows(
        as_bytes(content), start, ord(delimiter), pad, values, doubts
    )
    inside = doubts[:doubtful]
    if wanted is not None:
        inside = inside[np.isin(inside[:, 0] % columns, list(wanted))]
    settle(source, values, inside[inside[:, 0] < rows * columns], missing=missing)
    if status in (_kernels.TOO_FEW, _kernels.TOO_MANY):
        last = not content[stopped:].partition(b"\n")[2].strip()
        if status == _kernels.TOO_MANY or not last:
            found = "more" if status == _kernels.TOO_MANY else f"{column}"
            raise source.fault(stopped, f"{columns} numbers in the row", found)
        status = _kernels.CUT
    return Rows(values[:rows], bool(status == _kernels.CUT))


def widest_row(content: bytes, delimiter: str) -> int:
    """Count the cells of the widest row of a text; where blanks divide, those of the first."""
    mark = None if delimiter == " " else delimiter.encode()
    lines = content.splitlines()
    if mark is None:
        return len(lines[0].split()) if lines else 0
    return max((line.rstrip(b"\r").count(mark) + 1 for line in lines), default=0)


def settle(source: Source, values: np.ndarray, doubts: np.ndarray, *, missing: bool = False) -> None:
    """Convert by ``float`` the tokens that a kernel left in doubt.

    Parameters
    ----------
    source : Source
        The file.
    values : ndarray
        Where the numbers belong; changed in place.
    doubts : (N, 3) int
        Flat place in `values`, first byte, byte after the last.
    missing : bool
        Whether the words in :data:`MISSING_WORDS` are NaN; else they are errors.

    Raises
    ------
    FormatError
        When a token is no number.
    """
    flat = values.reshape(-1)
    content = source.content
    for place, start, stop in doubts.tolist():
        token = content[start:stop].strip()
        try:
            number = math.nan if b"_" in token else float(token)
        except ValueError:
            number = math.nan
        if not abs(number) < _LARGEST:
            if not (missing and _is_missing(token)):
                expected = f"a number below {_LARGEST:.0e}" if math.isfinite(number) else "a number"
                raise source.fault(start, expected, glimpse(token))
            number = math.nan
        flat[place] = number


def _is_missing(token: bytes) -> bool:
    word = token.lower().lstrip(b"+-")
    return word in MISSING_WORDS or word.startswith(_INFINITE)
