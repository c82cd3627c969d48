"""TRC: tables of markers as motion analysis programs and OpenSim write them.

Five lines of header (the third states rate and unit, the fourth names the markers, each over three columns), then a row
a frame: its number, its time and three numbers a marker; an empty cell is a marker unseen. Tabs, commas or blanks
divide. TRC states no vertical.
"""

from __future__ import annotations

import re

import numpy as np

from leitmotion.io.numerals import read_rows, widest_row
from leitmotion.io.points import distinct, split_people, unseen_in_origin
from leitmotion.io.reading import Draft, Finding, Source, glimpse
from leitmotion.io.timing import Timing, read_times
from leitmotion.io.units import unit_named


def read(source: Source) -> Draft:
    """Read a TRC.

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
        When the header or a row is not what the format says; it names the line.
    """
    warnings: list[str] = []
    lines, borders = _first_lines(source)
    facts = {
        key.lower(): value
        for key, value in zip(re.split(r"[\s,;]+", lines[1].strip()), re.split(r"[\s,;]+", lines[2].strip()))
    }
    delimiter = next((mark for mark in "\t,;" if mark in lines[3]), " ")
    cells = [cell.strip() for cell in (lines[3].split() if delimiter == " " else lines[3].split(delimiter))]
    if not cells or not cells[0].lower().startswith("frame"):
        raise source.fault(borders[3], "the columns Frame#, Time and the markers", glimpse(lines[3].encode()))
    names = [cell for cell in cells[2:] if cell]
    if not names:
        raise source.fault(borders[3], "names of markers", "none")
    start = borders[5]
    while True:  # between header and rows stand blank lines, or lines of nothing but delimiters
        stop = source.content.find(b"\n", start)
        line = source.content[start : stop if stop >= 0 else None]
        if line.strip(b" \t\r,;") or stop < 0:
            break
        start = stop + 1
    named = 2 + 3 * len(names)
    columns = max(named, widest_row(source.content[start:], delimiter))
    rows = read_rows(source, start, columns, delimiter=delimiter, missing=True)
    rows.tell_cut(source, warnings)
    if len(rows.values) == 0:
        raise source.error("expected a row a frame after the header, found none.")
    nameless = int(np.isfinite(rows.values[:, named:]).any(axis=0).sum()) // 3
    if nameless:
        warnings.append(f"{nameless} markers without a name were left out.")
    values = rows.values[:, 2:named].reshape(len(rows.values), len(names), 3)
    seen = np.isfinite(values).any(axis=(0, 2))
    if not seen.any():
        raise source.error("expected markers, found none that is ever seen.")
    if not seen.all():
        warnings.append(f"{int((~seen).sum())} markers that are never seen were left out.")
        values, names = values[:, seen], [name for name, here in zip(names, seen) if here]
    _check_count(facts.get("numframes"), len(values), "frames", warnings)
    positions = np.where(np.isfinite(values).all(axis=-1, keepdims=True), values, np.nan)
    unseen_in_origin(positions, warnings)
    timing = _timing(source, facts, rows.values[:, 1], warnings)
    unit = unit_named(facts.get("units", ""))
    return Draft(
        split_people(distinct(names, warnings), timing.place(positions)),
        rate=timing.rate,
        unit=Finding(unit, "read", f"Units is {facts['units']!r}") if unit else None,
        warnings=warnings,
    )


def _first_lines(source: Source) -> tuple[list[str], list[int]]:
    """The first five lines and the bytes at which these and the sixth begin."""
    lines, borders, position = [], [0], 0
    for _ in range(5):
        stop = source.content.find(b"\n", position)
        if stop < 0:
            raise source.error("expected five lines of header and a row a frame, found the end.")
        lines.append(source.content[position:stop].decode("utf-8", "replace").rstrip("\r"))
        position = stop + 1
        borders.append(position)
    if not lines[0].lstrip("\ufeff").lower().startswith("pathfiletype"):
        raise source.fault(
            0, "the word PathFileType", glimpse(lines[0].encode()), remedy="Is this a TRC file?"
        )
    return lines, borders


def _timing(source: Source, facts: dict[str, str], times: np.ndarray, warnings: list[str]) -> Timing:
    try:
        rate = float(facts.get("datarate", ""))
    except ValueError:
        rate = 0.0
    if np.isfinite(rate) and rate > 0:
        return Timing(Finding(rate, "read", "stated as DataRate"), None)
    return read_times(source, times, "Time", warnings)


def _check_count(stated: str | None, found: int, what: str, warnings: list[str]) -> None:
    if stated is not None and stated.isdecimal() and int(stated) != found:
        warnings.append(f"The header promises {stated} {what}, the file has {found}; those it has were read.")
