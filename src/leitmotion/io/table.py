"""CSV and TSV: tables of points, a row a frame, a column a coordinate.

The header names the columns: ``time, NAME_x, NAME_y, NAME_z``, or with a dot, a blank, brackets or nothing between name
and letter, or letter and number (``X1, Y1, Z1``). Points without a third column lie in a plane. ``NAME_c``,
``NAME_confidence``, ``NAME_likelihood`` or ``NAME_visibility`` is how sure the source was. Other columns are left out,
by name. Lines that begin with # are comments. An empty cell, NaN and their kin are points unseen.
"""

from __future__ import annotations

import csv
import io
import re
from collections import Counter
from dataclasses import replace

import numpy as np

from leitmotion.io.numerals import read_rows
from leitmotion.io.points import split_people
from leitmotion.io.reading import Draft, Finding, Source
from leitmotion.io.timing import Timing, read_times

_SUFFIX = re.compile(r"^(?P<name>.*?)(?P<mark>[\s_.:\-\[(]*)(?P<letter>[xyzXYZ])[\])]?$")
_PREFIX = re.compile(r"^(?P<letter>[xyzXYZ])[_\s]?(?P<name>\d+)$")
_SURE = re.compile(r"^(?P<name>.+?)[\s_.:]+(?:c|conf|confidence|likelihood|visibility|score)$", re.IGNORECASE)
_TIMES = ("time", "t", "time_s", "time_ms", "time_us", "times", "timestamp", "timestamp_ms", "seconds", "time[s]",
          "time (s)")  # fmt: skip
_FRAMES = ("frame", "frame#", "frames", "index", "")
_JOINTS = ("shoulder", "elbow", "wrist", "hip", "knee", "ankle", "spine", "neck", "hand")
_PIXELS = 20.0  # coordinates in a plane beyond this are pixels


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
    warnings: list[str] = []
    source, start, header, delimiter = _header(source)
    columns, sure, left = _columns(header)
    if not columns:
        raise source.error(
            f"expected columns such as NAME_x, NAME_y, NAME_z, found {', '.join(header[:6])}.",
            remedy="Name the columns of the table in its first line.",
        )
    flat = len(next(iter(columns.values()))) == 2
    time = next((k for k, word in enumerate(header) if word.lower() in _TIMES), None)
    wanted = (
        [k for triple in columns.values() for k in triple]
        + list(sure.values())
        + ([] if time is None else [time])
    )
    rows = read_rows(source, start, len(header), delimiter=delimiter, missing=True, wanted=wanted)
    if len(rows.values) == 0:
        raise source.error("expected a row a frame after the header, found none.")
    left = [word for word in left if word.lower() not in _TIMES + _FRAMES]
    if left:
        what = (
            "A column that is no point was"
            if len(left) == 1
            else f"{len(left)} columns that are no points were"
        )
        warnings.append(f"{what} left out: {', '.join(left[:8])}{' …' if len(left) > 8 else ''}.")
    names = list(columns)
    again = [name for name in names if f"{name}#2" in columns]
    if again:
        warnings.append(f"Names stand more than once and were numbered: {', '.join(again)}.")
    positions = rows.values[:, [columns[name] for name in names]]
    positions[~np.isfinite(positions).all(axis=-1)] = np.nan
    timing = _timing(source, rows.values, time, header, warnings)
    takes = split_people(names, timing.place(positions), _kind(names))
    if sure and len(takes) == 1:
        takes[0].confidence = timing.place(_confidence(rows.values, names, sure, warnings), missing=0.0)
    return Draft(
        takes,
        rate=timing.rate,
        unit=_plane_unit(positions) if flat else None,
        warnings=warnings,
    )


def looks(head: bytes) -> bool:
    """Whether a file that begins like this has a header that names points."""
    lines = head.removeprefix(b"\xef\xbb\xbf").decode("utf-8", "replace").splitlines()
    line = next((line for line in lines if line.strip() and not line.startswith("#")), "")
    return bool(_columns(_cells(line.replace('"', ""), _delimiter(line)))[0])


def _delimiter(line: str) -> str:
    mark = max("\t,;", key=line.count)
    return mark if mark in line else " "


def _cells(line: str, delimiter: str) -> list[str]:
    return line.split() if delimiter == " " else [cell.strip() for cell in line.split(delimiter)]


def _header(source: Source) -> tuple[Source, int, list[str], str]:
    """The file with plain cells, the byte after the header, its columns, what divides them."""
    content = source.content.removeprefix(b"\xef\xbb\xbf")
    position = 0
    while content[position : position + 1] in (b"#", b"\n", b"\r"):
        position = content.find(b"\n", position) + 1
        if position == 0:
            raise source.error("expected a header, found comments only.")
    stop = content.find(b"\n", position)
    if stop < 0:
        raise source.error("expected a header and a row a frame, found one line.")
    line = content[position:stop].decode("utf-8", "replace").strip("\r")
    delimiter = _delimiter(line)
    if b'"' in content:
        content, position = _unquoted(content[position:], delimiter), 0
        stop = content.find(b"\n")
        line = content[:stop].decode("utf-8", "replace")
    header = _cells(line, delimiter)
    if delimiter == ";":  # where a semicolon divides, a comma is a decimal point
        content = content[:stop] + content[stop:].replace(b",", b".")
    return replace(source, content=content), stop + 1, header, delimiter


def _unquoted(content: bytes, delimiter: str) -> bytes:
    rows = csv.reader(io.StringIO(content.decode("utf-8", "replace"), newline=""), delimiter=delimiter)
    lines = (delimiter.join(re.sub(rf"[{delimiter}\r\n]", " ", cell) for cell in row) for row in rows)
    return ("\n".join(lines) + "\n").encode("utf-8")


def _columns(header: list[str]) -> tuple[dict[str, list[int]], dict[str, int], list[str]]:
    """Columns of each point's coordinates, of its confidence, and the names of columns that are neither."""
    found: dict[str, dict[str, int]] = {}
    counts: Counter[tuple[str, str]] = Counter()
    for k, word in enumerate(header):
        match = _PREFIX.match(word) or _SUFFIX.match(word)
        if match and match["name"]:
            letter = match["letter"].lower()
            own = _numbered(match["name"], letter, counts)
            found.setdefault(own, {}).setdefault(letter, k)
    solid = any(len(letters) == 3 for letters in found.values())
    letters = "xyz" if solid else "xy"
    columns = {
        name: [places[letter] for letter in letters]
        for name, places in found.items()
        if places.keys() >= set(letters)
    }
    sure = {}
    for k, word in enumerate(header):
        match = _SURE.match(word)
        own = _numbered(match["name"], "", counts) if match else ""
        if own in columns:
            sure[own] = k
    used = {k for triple in columns.values() for k in triple} | set(sure.values())
    return columns, sure, [word for k, word in enumerate(header) if k not in used]


def _numbered(name: str, letter: str, counts: Counter[tuple[str, str]]) -> str:
    """The name of a point, numbered where its column stands again: ``RKNE``, ``RKNE#2``."""
    counts[name, letter] += 1
    return name if counts[name, letter] == 1 else f"{name}#{counts[name, letter]}"


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


def _timing(
    source: Source, values: np.ndarray, time: int | None, header: list[str], warnings: list[str]
) -> Timing:
    if time is not None:
        return read_times(source, values[:, time], header[time], warnings)
    stated = re.search(
        rb"^#[^\n]*?\b(?:rate|fps|frequency)\b\s*[:=]?\s*([\d.]+)", source.content, re.I | re.M
    )
    if stated:
        return Timing(Finding(float(stated[1]), "read", "stated in a comment"), None)
    if source.options.rate is not None:
        return Timing(Finding(source.options.rate, "given", "rate given by the caller"), None)
    raise source.error("expected a column of times, found none.", remedy="State the rate with --rate HZ.")


def _plane_unit(positions: np.ndarray) -> Finding:
    seen = np.abs(positions[np.isfinite(positions)])
    if seen.size and seen.max() > _PIXELS:
        return Finding("px", "guessed", "points in a plane with coordinates as large as pixels")
    return Finding("relative", "guessed", "points in a plane with coordinates too small for pixels")


def _kind(names: list[str]) -> str:
    named = sum(any(joint in name.lower() for joint in _JOINTS) for name in names)
    return "joint" if 2 * named > len(names) else "marker"
