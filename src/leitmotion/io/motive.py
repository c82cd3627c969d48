"""Motive CSV: what OptiTrack Motive exports, markers, rigid bodies and bones.

The first line is of words and their values (``Export Frame Rate``, ``Length Units``). Before the line that begins with
``Frame`` stand rows that tell of each column its type, its name, its ID and whether it is a position or a rotation. An
empty cell is unseen. Places of bones are read where there are any, else those of markers and rigid bodies.
"""

from __future__ import annotations

import re

from leitmotion.io.columns import read_rows_of
from leitmotion.io.reading import Draft, Source
from leitmotion.io.text import cells_of

_EXPECTED = ("bone marker", "rigid body marker", "marker constraint")
"""Types of where Motive expects a marker, which stand beside the markers themselves."""


def looks(head: bytes) -> bool:
    """Whether a file that begins like this is one."""
    return re.match(rb'(?:\xef\xbb\xbf)?"?Format Version"?,', head) is not None


def read(source: Source) -> Draft:
    """Read the points of a Motive CSV.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person a skeleton, else one.

    Raises
    ------
    FormatError
        When it has no positions in space, or is not what the format says; it names the line.
    """
    rows, start = _header(source)
    facts = dict(zip(rows[0][::2], rows[0][1::2]))
    if facts.get("Coordinate Space", "Global").lower() == "local":
        raise source.error(
            "expected places in the room, found places in each parent's frame.",
            remedy="Export it with the coordinate space Global.",
        )
    axes = rows[-1]
    types = [word.lower() for word in _labelled(rows, "Type", 0, len(axes))]
    names = _labelled(rows, "Name", 1, len(axes))
    held = _filled(rows[-2], len(axes))
    places = [k for k, axis in enumerate(axes) if held[k] == "Position" and axis in ("X", "Y", "Z")]
    chosen = _chosen(places, types, names)
    header = []
    for k, axis in enumerate(axes):
        if k in chosen:
            header.append(f"{names[k]}_{axis.lower()}")
        elif axis in ("Frame", "Time (Seconds)", "Time"):
            header.append(axis)
        else:
            header.append(" ".join(word for word in (names[k], held[k].lower(), axis) if word))
    if not chosen:
        unlabelled = " but unlabelled ones" if places else ""
        raise source.error(
            f"expected positions of markers, rigid bodies or bones, found none{unlabelled}.",
            remedy="Label the markers in Motive." if places else "Export the markers from Motive.",
        )
    stated = {
        "unit": facts.get("Length Units", ""),
        "rate": facts.get("Export Frame Rate") or facts.get("Capture Frame Rate", ""),
        "name": facts.get("Take Name", ""),
    }
    draft = read_rows_of(source, start, header, ",", stated, exact=True)
    if types[min(chosen)] == "bone":
        for take in draft.takes:
            take.kind = "joint"  # type: ignore[union-attr]
    return draft


def _header(source: Source) -> tuple[list[list[str]], int]:
    """The rows up to the one that names the axes, without those that are empty, and the byte after them."""
    rows: list[list[str]] = []
    position = 3 if source.content.startswith(b"\xef\xbb\xbf") else 0
    for _ in range(16):
        stop = source.content.find(b"\n", position)
        if stop < 0:
            break
        line = source.content[position:stop].decode("utf-8", "replace").rstrip("\r")
        cells = [cell.strip() for cell in cells_of(line)]
        position = stop + 1
        if any(cells):
            rows.append(cells)
        if cells[:1] == ["Frame"]:
            if len(rows) < 5:
                break
            return rows, position
    raise source.error(
        "expected rows of types, names and IDs and one that begins with Frame, found none.",
        remedy="Export it from Motive with its header.",
    )


def _labelled(rows: list[list[str]], label: str, place: int, width: int) -> list[str]:
    """The cells of the row of a label, one a column; where none bears it, of the row where it usually stands."""
    row = next((row for row in rows[1:-2] if label in row[:2]), rows[1 + place])
    return _filled(row, width)


def _filled(row: list[str], width: int) -> list[str]:
    return (row + [""] * width)[:width]


def _chosen(places: list[int], types: list[str], names: list[str]) -> set[int]:
    """The columns to read of all that are positions."""
    places = [k for k in places if not re.match(r"(?:.*:)?unlabel+ed", names[k], re.IGNORECASE)]
    bones = {k for k in places if types[k] == "bone"}
    if bones:
        return bones
    seen = {k for k in places if types[k] not in _EXPECTED}
    return seen or set(places)
