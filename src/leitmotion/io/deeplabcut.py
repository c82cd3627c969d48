"""DeepLabCut CSV: rows of header that name scorer, perhaps individuals, body parts and coordinates.

``x``, ``y`` are pixels, ``likelihood`` is how sure the network was; several individuals are several people. What
triangulates has ``z`` and a unit of its own. The rate is that of the video, which the file does not state.
"""

from __future__ import annotations

import re

from leitmotion.io.columns import read_rows_of
from leitmotion.io.reading import Draft, Source
from leitmotion.io.text import cells_of

_LETTERS = {"x": "x", "y": "y", "z": "z", "likelihood": "confidence"}


def looks(head: bytes) -> bool:
    """Whether a file that begins like this is one."""
    return re.match(rb"(?:\xef\xbb\xbf)?scorer,[^\n]*\n(?:individuals,[^\n]*\n)?bodyparts,", head) is not None


def read(source: Source) -> Draft:
    """Read the points of a DeepLabCut CSV.

    Parameters
    ----------
    source : Source
        The file.

    Returns
    -------
    Draft
        One person an individual.

    Raises
    ------
    FormatError
        When it is not what the format says; it names the line.
    """
    rows: dict[str, list[str]] = {}
    start = 3 if source.content.startswith(b"\xef\xbb\xbf") else 0
    for _ in range(4):
        stop = source.content.find(b"\n", start)
        cells = cells_of(source.content[start:stop].decode("utf-8", "replace").rstrip("\r")) or [""]
        rows[cells[0]] = cells
        start = stop + 1
        if cells[0] == "coords" or stop < 0:
            break
    if "coords" not in rows or "bodyparts" not in rows:
        raise source.error("expected rows bodyparts and coords before the numbers, found none.")
    parts, coordinates = rows["bodyparts"], rows["coords"]
    people = rows.get("individuals", [""] * len(parts))
    header = [_name(k, *words) for k, words in enumerate(zip(people, parts, coordinates))]
    stated = {} if "z" in coordinates else {"unit": "px"}
    return read_rows_of(source, start, header, ",", stated, exact=True)


def _name(place: int, person: str, part: str, coordinate: str) -> str:
    if coordinate not in _LETTERS:
        return "frame" if place == 0 else coordinate or f"index {place}"
    return f"{person}:{part}_{_LETTERS[coordinate]}" if person else f"{part}_{_LETTERS[coordinate]}"
