"""The MOTION section of a BVH: how many frames, how long each lasts, and a row of numbers for each."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from leitmotion.io.numerals import read_rows
from leitmotion.io.reading import Finding, Source, glimpse

_NTSC = (24000 / 1001, 30000 / 1001, 60000 / 1001, 120000 / 1001)
_USUAL = (24, 25, 30, 50, 60, 90, 100, 120, 150, 200, 240, 250, 300, 480, 500, 1000)
_SHORTEST = 1e-6  # seconds that a frame may last
_SNAP = 0.02  # how far, relatively, a rate may lie from the reciprocal of its frame time
_ROUNDED = 2e-3  # how far, relatively, milliseconds may lie from those of a usual rate

_FACT = re.compile(rb"\s*(Frames|Frame\s*Time)\s*:?[ \t]*(\S*)", re.IGNORECASE)


class Header(NamedTuple):
    """What stands before the rows."""

    promised: bytes
    """The count of frames as it is written, empty where there is none."""

    time: str
    """The frame time as it is written, empty where there is none."""

    start: int
    """The byte of the first row."""


def read_header(source: Source, position: int) -> Header:
    """Read the lines ``Frames:`` and ``Frame Time:``, in either order, on lines of their own or not.

    Parameters
    ----------
    source : Source
        The file.
    position : int
        The byte after the line MOTION.

    Returns
    -------
    Header
        What they say; without a frame time only where the caller gave a rate.

    Raises
    ------
    FormatError
        When the frame time is missing.
    """
    content = source.content
    facts: dict[bool, bytes] = {}
    begin = position
    while fact := _FACT.match(content, position):
        facts[fact[1].lower() != b"frames"] = fact[2]
        position = fact.end()
        if not _FACT.match(content, position):  # else two on one line
            stop = content.find(b"\n", position)
            position = len(content) if stop < 0 else stop + 1
    if True not in facts and source.options.rate is None:
        lines = [line for line in content[begin : begin + 4000].splitlines() if line.strip()]
        found = " and ".join(glimpse(line) for line in lines[:2]) or "none"
        raise source.fault(
            begin, "the lines 'Frames:' and 'Frame Time:'", found, remedy="State the rate with --rate HZ."
        )
    return Header(facts.get(False, b""), facts.get(True, b"").decode("utf-8", "replace"), position)


def read_frames(source: Source, header: Header, columns: int, warnings: list[str]) -> np.ndarray:
    """Read a row of numbers a frame.

    Numbers may have decimal commas, be divided by commas, or stand in lines that are no frames.

    Parameters
    ----------
    source : Source
        The file.
    header : Header
        What stands before them.
    columns : int
        Numbers a frame.
    warnings : list of str
        Gains a sentence where the file ends within a row or the counts of frames differ.

    Returns
    -------
    (T, N) float
        The numbers, NaN where one is missing (``nan``, ``1.#IND``).

    Raises
    ------
    FormatError
        When a row is longer or shorter or holds something else; it names the line.
    """
    promised = _count(header.promised)
    source = _with_points(source, header.start, columns)
    if promised and len(_first_row(source.content, header.start).split()) != columns:
        values = _stream(source, header.start)
        if values.size == promised * columns:
            warnings.append(
                "Lines are no frames: the numbers, as many as promised, were taken one after the other."
            )
            return values.reshape(promised, columns)
    rows = read_rows(source, header.start, columns, missing=True, whole=True)
    rows.tell_cut(source, warnings)
    frames = len(rows.values)
    if frames == 0:
        raise source.error("expected at least one row of numbers after the frame time, found none.")
    if promised is None:
        stated = f"states {glimpse(header.promised)} as" if header.promised else "does not state"
        warnings.append(f"The header {stated} the count of frames; the {frames} that the file has were read.")
    elif promised != frames:
        warnings.append(
            f"The header promises {promised} frames, the file has {frames}; those it has were read."
        )
    return rows.values


def rate_of(source: Source, header: Header, warnings: list[str]) -> Finding:
    """Tell the rate; as :func:`frame_rate`, with a warning where frames last longer than those of a movement do."""
    rate = frame_rate(header.time, source)
    if source.options.rate is None and rate.value <= 1.0:
        warnings.append(_doubt(source, header.time, 1.0 / rate.value))
    return rate


def frame_rate(text: str, source: Source) -> Finding:
    """Tell the rate that a frame time, rounded or cut to some decimals, stands for.

    Parameters
    ----------
    text : str
        The frame time in seconds as it is written.
    source : Source
        The file, for the error.

    Returns
    -------
    Finding
        The nearest whole rate whose frame time differs by less than one unit in the last place written, or where none
        does the nearest broadcast rate that does; else, or where that rate lies 2 % or more from the reciprocal, as of
        a frame time of one digit, the reciprocal.
    """
    try:
        seconds = float(text.replace(",", "."))
    except ValueError:
        seconds = np.nan
    if source.options.rate is not None and not _SHORTEST <= seconds < np.inf:
        return Finding(source.options.rate, "given", "rate given by the caller")
    if not _SHORTEST <= seconds < np.inf:
        raise source.error(
            f"expected a frame time above 0 s, found {glimpse(text.encode())}.",
            remedy="State the rate with --rate HZ.",
        )
    exact = 1.0 / seconds
    mantissa, _, power = text.lower().partition("e")
    decimals = len(mantissa.replace(",", ".").partition(".")[2]) - int(power or 0)
    unit = 10.0**-decimals
    whole = max(1, round(exact))
    broadcast = min(_NTSC, key=lambda rate: abs(1.0 / rate - seconds))
    # a few digits fit both: 0.0167 s is 60 Hz and 59.94 Hz, and whole rates are the usual ones
    near = next((rate for rate in (whole, broadcast) if abs(1.0 / rate - seconds) < unit), None)
    if near is not None and abs(near / exact - 1.0) >= _SNAP:
        near = None
    if near is not None:
        taken = "" if 1.0 / near == seconds else f", taken as {near:.6g} Hz"
        return Finding(float(near), "read", f"frame time {text} s{taken}")
    for digits in (
        6,
        9,
        12,
        15,
    ):  # the shortest rate of exactly this frame time, which 1 / seconds may miss by a bit
        short = float(f"{exact:.{digits}g}")
        if 1.0 / short == seconds:
            return Finding(short, "read", f"frame time {text} s")
    return Finding(exact, "read", f"frame time {text} s")


def _doubt(source: Source, text: str, seconds: float) -> str:
    """Say that frames last too long for a movement; refuse where the number is a usual rate, or that in ms."""
    for rate in _USUAL:
        hertz = abs(seconds / rate - 1.0) < _ROUNDED
        if hertz or (rate <= 120 and abs(seconds * rate / 1000.0 - 1.0) < _ROUNDED):
            raise source.error(
                f"expected a frame time in seconds, found {text}, which looks like "
                f"{'the rate' if hertz else 'milliseconds'}.",
                remedy=f"State the rate with --rate HZ, here --rate {rate}.",
            )
    return f"A frame lasts {text} s, longer than a movement's do: if that is not so, state the rate with --rate HZ."


def _count(word: bytes) -> int | None:
    try:
        return int(float(word))
    except (ValueError, OverflowError):
        return None


def _first_row(content: bytes, start: int) -> bytes:
    while start < len(content):
        stop = content.find(b"\n", start)
        stop = len(content) if stop < 0 else stop
        if content[start:stop].strip():
            return content[start:stop]
        start = stop + 1
    return b""


def _with_points(source: Source, start: int, columns: int) -> Source:
    """The file with decimal points in its rows for decimal commas, or with blanks for commas between numbers."""
    if source.content.find(b",", start) < 0:
        return source
    first = _first_row(source.content, start)
    divided = len(first.split()) != columns or b", " in first
    rows = source.content[start:].replace(b",", b" " if divided else b".")
    return replace(source, content=source.content[:start] + rows)


@dataclass(frozen=True)
class _Column(Source):
    """A text with a line feed for every blank, which tells lines as they were."""

    line: Callable[[int], int] = int

    def line_of(self, position: int) -> int:
        """Tell the line that the byte at `position` stood in."""
        return self.line(position)


def _stream(source: Source, start: int) -> np.ndarray:
    """All numbers from a byte on, whatever the lines."""
    column = source.content[start:].translate(bytes.maketrans(b" \t\r", b"\n\n\n"))
    text = _Column(source.path, source.content[:start] + column, source.options, source.line_of)
    return read_rows(text, start, 1, missing=True, whole=True).values
