"""Files that are known by how they begin, though nothing here reads them; the table of formats says what to do."""

from __future__ import annotations

import re

_MAPS = 117  # numbers a row of exponential maps: a place, a turn and 37 joints of the CMU body
_TURN = 6.3  # radians that no such number exceeds


def is_deepmimic(head: bytes) -> bool:
    """Whether a file that begins like this holds the frames of DeepMimic: JSON with ``Loop`` or ``Frames``."""
    return re.match(rb'(?:\xef\xbb\xbf)?\s*\{\s*"(?:Loop|Frames|Frame Duration)"', head) is not None


def is_exponential_maps(head: bytes) -> bool:
    """Whether a file that begins like this holds rows of exponential maps: 117 numbers, all but the place angles."""
    line = head.removeprefix(b"\xef\xbb\xbf").partition(b"\n")[0]
    try:
        numbers = [float(cell) for cell in line.split(b",")]
    except ValueError:
        return False
    return len(numbers) == _MAPS and all(abs(number) < _TURN for number in numbers[3:])
