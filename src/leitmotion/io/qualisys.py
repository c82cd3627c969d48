"""Qualisys TSV: markers as Qualisys Track Manager exports them.

Lines of a word and its values, divided by tabs (``FREQUENCY`` states the rate, ``MARKER_NAMES`` names the markers),
then perhaps a line that names the columns, then a row a frame: perhaps its number and its time, and three numbers a
marker. An empty cell, or the origin, is a marker unseen. Lengths are millimetres. The vertical is nowhere stated.
"""

from __future__ import annotations

import re

import numpy as np

from leitmotion.io.numerals import read_rows, widest_row
from leitmotion.io.points import distinct, split_people, unseen_in_origin
from leitmotion.io.reading import Draft, Finding, Source, glimpse
from leitmotion.io.timing import Timing, read_times

_HELD = {"6D": "rigid bodies", "2D": "what each camera saw"}
_BEFORE = ("frame", "time")
_EXPORT = "Export the 3D data of the trajectories: TSV Export, 3D."


def looks(head: bytes) -> bool:
    """Whether a file that begins like this is one."""
    text = head.removeprefix(b"\xef\xbb\xbf").lstrip()
    return re.match(rb"(?:FILE_VERSION|NO_OF_FRAMES)\t", text) is not None


def read(source: Source) -> Draft:
    """Read the markers of a Qualisys TSV.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person a subject prefix, else one.

    Raises
    ------
    FormatError
        When it holds something else than markers in space, or a row is no row of numbers; it names the line.
    """
    warnings: list[str] = []
    facts, heading, start = _header(source)
    held = " ".join(facts.get("DATA_INCLUDED", ["3D"]))
    if held != "3D":
        raise source.error(
            f"expected the 3D data of markers, found {held} data{_parenthesis(_HELD.get(held, ''))}.",
            remedy=_EXPORT,
        )
    names = [name for name in facts.get("MARKER_NAMES", []) if name]
    if not names:
        raise source.error("expected names of markers after MARKER_NAMES, found none.", remedy=_EXPORT)
    named = sum(cell.lower() in _BEFORE for cell in heading[:2])
    columns = widest_row(source.content[start:], "\t")
    if source.content[start:].strip() and columns < named + 3 * len(names):
        raise source.fault(start, f"{named + 3 * len(names)} cells in a row", f"{columns} at most")
    columns = max(columns, named + 3 * len(names))
    rows = read_rows(source, start, columns, delimiter="\t", missing=True)
    rows.tell_cut(source, warnings)
    if len(rows.values) == 0:
        raise source.error("expected a row a frame after the header, found none.")
    before = _columns_before(source, heading, rows.values, 3 * len(names), start)
    for key, count, what in (
        ("NO_OF_FRAMES", len(rows.values), "frames"),
        ("NO_OF_MARKERS", len(names), "markers"),
    ):
        stated = "".join(facts.get(key, [])[:1])
        if stated.isdecimal() and int(stated) != count:
            warnings.append(
                f"The header promises {stated} {what}, the file has {count}; those it has were read."
            )
    positions = rows.values[:, before : before + 3 * len(names)].reshape(-1, len(names), 3)
    positions[~np.isfinite(positions).all(axis=-1)] = np.nan
    unseen_in_origin(positions, warnings)
    seen = np.isfinite(positions).any(axis=(0, 2))
    if not seen.any():
        raise source.error("expected markers, found none that is ever seen.")
    if not seen.all():
        warnings.append(f"{int((~seen).sum())} markers that are never seen were left out.")
        positions, names = positions[:, seen], [name for name, here in zip(names, seen) if here]
    timing = _timing(source, facts, heading, rows.values[:, :before], warnings)
    return Draft(
        split_people(distinct(names, warnings), timing.place(positions)),
        rate=timing.rate,
        unit=Finding("mm", "read", "Qualisys tables are in millimetres"),
        warnings=warnings,
    )


def _header(source: Source) -> tuple[dict[str, list[str]], list[str], int]:
    """The values of each word, the names of the columns where they stand, the byte at which the rows begin."""
    facts: dict[str, list[str]] = {}
    position = 0
    while position < len(source.content):
        stop = source.content.find(b"\n", position)
        stop = len(source.content) if stop < 0 else stop
        line = source.content[position:stop].decode("utf-8", "replace").lstrip("\ufeff").rstrip("\r")
        word, *values = (cell.strip() for cell in line.split("\t"))
        if re.fullmatch(
            r"[A-Z][A-Z0-9_]+|DESCRIPTION .*", word
        ):  # of which some programs write a blank for a tab
            facts.setdefault(word, values)
        elif word.lower() in _BEFORE or any(re.fullmatch(r".+ [XYZ]", cell) for cell in [word, *values]):
            return facts, [word, *values], stop + 1
        elif line.strip():
            return facts, [], position
        position = stop + 1
    return facts, [], position


def _columns_before(
    source: Source, heading: list[str], values: np.ndarray, coordinates: int, start: int
) -> int:
    """How many columns, frame and time, stand before the markers."""
    if heading:
        return sum(cell.lower() in _BEFORE for cell in heading[:2])
    spare = values.shape[1] - coordinates
    if spare % 2 == 1 and not np.isfinite(values[:, -1]).any():  # rows that end in a tab
        spare -= 1
    if spare > 2:
        raise source.fault(
            start, f"{coordinates} numbers in the row, three a marker", f"{spare + coordinates}"
        )
    return spare


def _timing(
    source: Source, facts: dict[str, list[str]], heading: list[str], before: np.ndarray, warnings: list[str]
) -> Timing:
    stated = "".join(facts.get("FREQUENCY", [])[:1])
    try:
        rate = float(stated)
    except ValueError:
        rate = 0.0
    if np.isfinite(rate) and rate > 0:
        return Timing(Finding(rate, "read", "stated as FREQUENCY"), None)
    places = [k for k, cell in enumerate(heading[:2]) if cell.lower() == "time"]
    place = places[0] if places else 1
    if before.shape[1] > place:
        return read_times(source, before[:, place], "Time", warnings)
    if source.options.rate is not None:
        return Timing(Finding(source.options.rate, "given", "rate given by the caller"), None)
    raise source.error(
        f"expected a rate above 0 Hz after FREQUENCY, found {glimpse(stated.encode())}.",
        remedy="State it with --rate HZ.",
    )


def _parenthesis(text: str) -> str:
    return f" ({text})" if text else ""
