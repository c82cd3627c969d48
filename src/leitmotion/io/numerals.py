"""Numbers in text: rows of decimals from bytes to an array, exactly as Python's ``float`` reads them, only faster."""

from __future__ import annotations

import math
import re
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
_ALIKE = 20  # rows that end in numbers of one shape before another shape tells that the last is cut
_WORDS = re.compile(rb"#|//|[a-z]{4}", re.IGNORECASE)  # what a remark has and a number has not
_ROOM = 64  # how many numbers a byte of a table may stand for before it is refused


class Rows(NamedTuple):
    """A block of numbers read from text."""

    values: np.ndarray
    """(R, C) float."""

    cut: bool
    """Whether the text ended within a row, which is left out."""

    def tell_cut(self, source: Source, warnings: list[str]) -> None:
        """Add a sentence to the warnings where the last row was left out.

        Parameters
        ----------
        source : Source
            The file.
        warnings : list of str
            Gains the sentence.
        """
        if not self.cut:
            return
        start, stop = _last_line(source.content, 0)
        last = source.content[start:stop]
        if _WORDS.search(last):
            warnings.append(f"The last line is no row of numbers and was left out: {glimpse(last)}.")
        else:
            warnings.append(
                f"The file ends within its row {len(self.values) + 1}; the whole rows before it were read."
            )


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

    A last row is taken as cut, and left out, where it has fewer cells than every other. Where no line feed follows it,
    it is cut as well where its last number has fewer decimals, or fewer digits of an exponent, than those of the 20 and
    more rows before it, which all have as many; or where its last cell is empty and theirs are not.

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
    end = _end_of_whole_rows(content, start, columns, delimiter)
    capacity = content.count(b"\n", start) + 1
    pad = missing and not whole
    if not pad:
        capacity = min(capacity, len(content) // (2 * columns) + 1)
    elif capacity * columns > _ROOM * len(content) + 1_000_000:
        raise source.error(f"expected rows of {columns} numbers, found rows that are mostly empty.")
    values = np.empty((capacity, columns))
    doubts = np.empty((capacity * columns, 3), dtype=np.int64)
    rows, doubtful, status, stopped, column = _kernels.scan_rows(
        as_bytes(content)[:end], start, ord(delimiter), pad, values, doubts
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
    return Rows(values[:rows], bool(status == _kernels.CUT) or end < len(content))


def _last_line(content: bytes, start: int) -> tuple[int, int]:
    """The bytes of the last line that holds more than blanks, from byte `start` on."""
    stop = len(content)
    while stop > start:
        begin = max(content.rfind(b"\n", start, stop) + 1, start)
        if content[begin:stop].strip():
            return begin, stop
        stop = begin - 1
    return start, start


def _end_of_whole_rows(content: bytes, start: int, columns: int, delimiter: str) -> int:
    """The byte at which the last row begins where it is cut, else the length of the text."""
    begin, stop = _last_line(content, start)
    if begin == start or columns < 2:
        return len(content)
    mark = None if delimiter == " " else delimiter.encode()
    last = content[begin:stop].rstrip(b"\r\n").split(mark)
    cut = len(last) <= columns and _has_fewer_cells(content[start:begin], last, columns, mark)
    if not cut and stop == len(content):
        cut = _ends_in_a_shorter_number(content[start:begin], last[-1], mark)
    return begin if cut else len(content)


def _has_fewer_cells(before: bytes, last: list[bytes], columns: int, mark: bytes | None) -> bool:
    """Whether a row has fewer cells than every row before; a delimiter with which all of them end counts for none."""
    if len(last) == columns and last[-1].strip():
        return False
    rows = [line.rstrip(b"\r") for line in before.split(b"\n") if line.strip()]
    if not rows:
        return False
    if mark is None:
        return len(last) < min(len(row.split()) for row in rows)
    ends = all(row.endswith(mark) for row in rows)
    cells = len(last) - (ends and not last[-1].strip())
    return cells < min(row.count(mark) for row in rows) + (not ends)


def _ends_in_a_shorter_number(before: bytes, cell: bytes, mark: bytes | None) -> bool:
    """Whether the last cell is shorter than a writer would have written it that gives all numbers one shape."""
    shapes: set[tuple[int, int]] = set()
    stop = len(before)
    for _ in range(_ALIKE):
        begin, stop = _last_line(before[:stop], 0)
        if begin == stop:
            return False
        shapes.add(_shape(before[begin:stop].rstrip(b"\r\n").split(mark)[-1]))
        stop = begin
    if len(shapes) > 1:
        return False
    usual, own = shapes.pop(), _shape(cell)
    return own[0] < usual[0] or own[1] < usual[1]


def _shape(cell: bytes) -> tuple[int, int]:
    """How many decimals a number has, and how many characters its exponent; an empty cell has -1 of both."""
    if not cell.strip():
        return -1, -1
    mantissa, _, exponent = cell.strip().lower().partition(b"e")
    return len(mantissa.partition(b".")[2]), len(exponent)


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
