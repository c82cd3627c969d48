"""CSV and TSV: tables of points, a row a frame, a column a coordinate.

The first line that is no comment names the columns; :mod:`leitmotion.io.columns` says how. Commas, tabs, semicolons or
blanks divide. Lines before it that begin with # may state the unit, the vertical and the rate. An empty cell, NaN and
their kin are points unseen. A table with a row a point is turned into one with a row a frame first.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Iterable, Iterator
from dataclasses import replace

from leitmotion.io.columns import find_columns, read_columns, read_rows_of
from leitmotion.io.long_table import LongTable, find_long
from leitmotion.io.numerals import MISSING_WORDS
from leitmotion.io.reading import Draft, Source

_STATED = re.compile(r"#\s*(unit|up|rate|kind|name)s?\s*[:=]\s*(.+)$", re.IGNORECASE)
_RATE = re.compile(r"\b(?:rate|fps|frequency)\b\s*[:=]?\s*([\d.].*)$", re.IGNORECASE)
_KINDS = ("marker", "joint")


def read(source: Source) -> Draft:
    """Read a table of points.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person a name before a colon, else one.

    Raises
    ------
    FormatError
        When the header names no points, a cell is no number or nothing tells the rate.
    """
    stated, position = _comments(source)
    source, start, header, delimiter = _header(source, position)
    if "kind" not in stated:
        header = [word.strip() for word in header]
    long = find_long(header)
    if long is not None:
        return _read_long(source, start, header, delimiter, long, stated)
    if _numbers_only(header):
        raise source.error(
            f"expected a first line that names the columns, found {len(header)} numbers and no names.",
            remedy="Write a first line such as time,head_x,head_y,head_z that says what each number is.",
        )
    return read_rows_of(source, start, header, delimiter, stated, exact="kind" in stated)


def looks(head: bytes) -> bool:
    """Whether a file that begins like this has a header that names points, or holds bare numbers."""
    lines = head.removeprefix(b"\xef\xbb\xbf").decode("utf-8", "replace").splitlines()
    line = next((line for line in lines if line.strip() and not line.startswith("#")), "")
    header = _cells(line.replace('"', ""), _delimiter(line))
    return bool(find_columns(header).points) or find_long(header) is not None or _numbers_only(header)


def _numbers_only(header: list[str]) -> bool:
    """Whether a line holds two numbers and more, and nothing but numbers."""
    return len(header) > 1 and all(
        re.fullmatch(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", cell)
        or cell.lower().lstrip("+-").encode() in MISSING_WORDS
        or not cell
        for cell in header
    )  # fmt: skip


def _comments(source: Source) -> tuple[dict[str, str], int]:
    """What the lines of comment before the header state, and the byte after them."""
    content = source.content
    stated: dict[str, str] = {}
    position = 3 if content.startswith(b"\xef\xbb\xbf") else 0
    while content[position : position + 1] in (b"#", b"\n", b"\r"):
        stop = content.find(b"\n", position)
        if stop < 0:
            raise source.error("expected a header, found comments only.")
        line = content[position:stop].decode("utf-8", "replace").strip()
        match = _STATED.match(line)
        rate = _RATE.search(line)
        if match:
            stated.setdefault(match[1].lower(), _unquote(match[2].strip()))
        elif rate:
            stated.setdefault("rate", rate[1])
        position = stop + 1
    if stated.get("kind", "") not in _KINDS:
        stated.pop("kind", None)
    return stated, position


def _unquote(word: str) -> str:
    try:
        text = json.loads(word) if word.startswith('"') else word
    except ValueError:
        return word
    return text if isinstance(text, str) else word


def _delimiter(line: str) -> str:
    bare = re.sub(r'"[^"]*"?', "", line)  # what stands in quotes divides nothing, unless the whole line does
    line = bare if any(mark in bare for mark in "\t,;") else line
    mark = max("\t,;", key=line.count)
    return mark if mark in line else " "


def _cells(line: str, delimiter: str) -> list[str]:
    return line.split() if delimiter == " " else [cell.strip() for cell in line.split(delimiter)]


def _header(source: Source, position: int) -> tuple[Source, int, list[str], str]:
    """The file with plain cells, the byte after the header, its columns, what divides them."""
    content = source.content
    stop = content.find(b"\n", position)
    if stop < 0:
        raise source.error("expected a header and a row a frame, found one line.")
    line = content[position:stop].decode("utf-8", "replace").strip("\r")
    delimiter = _delimiter(line)
    header = _cells(line, delimiter)
    if '"' in line and delimiter != " ":  # a quoted name may hold what divides, and lines
        header, stop = _quoted_header(source, position, delimiter)
    start = stop + 1
    if b'"' in content[start:]:
        content, start = _unquoted(source, start, delimiter), 0
    if delimiter == ";":  # where a semicolon divides, a comma is a decimal point
        content = content[:start] + content[start:].replace(b",", b".")
    return replace(source, content=content), start, header, delimiter


def _quoted_header(source: Source, position: int, delimiter: str) -> tuple[list[str], int]:
    """The cells of the record that begins at a byte, and the line feed after it."""
    ends = [position]

    def lines() -> Iterator[str]:
        while ends[-1] < len(source.content):
            stop = source.content.find(b"\n", ends[-1])
            ends.append(len(source.content) if stop < 0 else stop + 1)
            yield source.content[ends[-2] : ends[-1]].decode("utf-8", "replace")

    header = next(_records(source, lines(), delimiter))
    return header, ends[-1] - 1


def _unquoted(source: Source, start: int, delimiter: str) -> bytes:
    text = io.StringIO(source.content[start:].decode("utf-8", "replace"), newline="")
    rows = _records(source, text, delimiter)
    lines = (delimiter.join(re.sub(rf"[{delimiter}\r\n]", " ", cell) for cell in row) for row in rows)
    end = "\n" if source.content.endswith(b"\n") else ""  # without it the last row may be cut
    return ("\n".join(lines) + end).encode("utf-8")


def _records(source: Source, lines: Iterable[str], delimiter: str) -> Iterator[list[str]]:
    try:
        yield from csv.reader(lines, delimiter=delimiter)
    except csv.Error:
        raise source.error(
            "expected that quotes which open in a cell close there, found that they do not."
        ) from None


def _read_long(
    source: Source, start: int, header: list[str], delimiter: str, long: LongTable, stated: dict[str, str]
) -> Draft:
    text = source.content[start:].decode("utf-8", "replace")
    rows = [_cells(line, delimiter) for line in text.splitlines() if line.strip()]
    short = next((k for k, row in enumerate(rows) if len(row) != len(header)), None)
    if short is not None:
        raise source.error(
            f"expected {len(header)} cells in row {short + 1} of the table, found {len(rows[short])}."
        )
    if not rows:
        raise source.error("expected rows after the header, found none.")
    wide = long.widen(source, [[row[k] for row in rows] for k in range(len(header))])
    columns = find_columns(wide.header, exact=True)
    return read_columns(source, wide.header, columns, wide.values, stated)
