"""Writing C3D: points in space as little-endian floats, after a section of parameters that says what they are.

The vertical of the screen is written as ``+Y``, so that any program that heeds it stands the person upright.

References
----------
.. [1] The C3D file format user guide. Motion Lab Systems, 2021.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence

import numpy as np

from leitmotion.io.c3d import OURS
from leitmotion.io.c3d_parameters import BLOCK, INTEL
from leitmotion.io.units import METRES, unit_in_metres
from leitmotion.motion import Motion, ParameterError, Trajectories, joint_points

_FULL = 0xFFFF  # the largest number of frames, and of points, that the first block holds
_WIDEST = 0xFF  # a text and a list may be this long
_LARGEST = 0x7FFF  # bytes of a parameter: some programs read the way to the next one as a signed number
_BLOCKS = 0xFF  # blocks of parameters


def write(recording: Motion | Trajectories, *, unit: str = "mm") -> bytes:
    """Make the bytes of a C3D, Y up.

    The numbers are 32-bit floats. A point that was not seen has a residual of -1 and lies in the origin; the others
    have a residual of 0. A Motion is written as the points of its joints. Labels are UTF-8, of which plain letters are
    ASCII, as the format has it; blanks at their ends are lost, since labels are padded with them. A C3D has no place
    for a confidence, the name of the recording and end sites. From 65,536 frames on the count stands in
    POINT:LONG_FRAMES and in TRIAL:ACTUAL_END_FIELD.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames of points in space.
    unit : str
        Name of the unit of length to write, such as "mm" or "m"; points without metres keep theirs.

    Returns
    -------
    bytes
        The file's content.

    Raises
    ------
    ParameterError
        When the points lie in a plane, there is no frame or no point or more than 65,535 points, a label is longer
        than 255 bytes or no text that UTF-8 can hold, the labels are too many for the format, or the unit has no name.

    Examples
    --------
    >>> from leitmotion.motion import Trajectories
    >>> content = write(Trajectories(("LFIN", "RFIN"), np.ones((100, 2, 3)), rate=50))
    >>> len(content) - 100 * 2 * 16  # four numbers of 4 bytes a point, after the first block and the parameters
    1024
    """
    if not isinstance(recording, Motion | Trajectories):
        raise ParameterError(f"A C3D holds a recording, got a {type(recording).__name__}.")
    points = joint_points(recording) if isinstance(recording, Motion) else recording
    frames, count, components = points.positions.shape
    if components != 3:
        raise ParameterError(
            f"A C3D holds points in space, got points with {components} coordinates.",
            remedy="Write them as .csv or .npz.",
        )
    if not frames or not count:
        raise ParameterError(f"A C3D holds at least one frame of one point, got {frames} frames of {count}.")
    if count > _FULL:
        raise ParameterError(
            f"A C3D holds at most {_FULL:,} points, got {count:,}.", remedy="Write them as .npz."
        )
    word, metres = _unit(points, unit)
    section = _parameters(points, word)
    data_block = 2 + len(section) // BLOCK
    head = struct.pack(
        "<BBHHHHHfHHf", 2, 0x50, count, 0, 1, min(frames, _FULL), 0, -1.0, data_block, 1, points.rate
    )
    places = np.zeros((frames, count, 4), dtype="<f4")
    unseen = np.isnan(points.positions).any(axis=-1)
    with np.errstate(over="ignore"):
        np.divide(points.positions, metres, out=places[..., :3], casting="same_kind")
    places[unseen] = (0.0, 0.0, 0.0, -1.0)
    if not np.isfinite(places).all():
        raise ParameterError(f"A C3D holds 32-bit floats, got a place beyond their reach in {word}.")
    # no padding to a whole block: who reads a long recording to the end of the file would take it for frames
    return b"".join((head.ljust(BLOCK, b"\0"), section, places.data))


def _unit(points: Trajectories, unit: str) -> tuple[str, float]:
    """What POINT:UNITS says, and how many of the points' own units that is."""
    if points.unit != "m":
        return points.unit, 1.0
    word, metres = unit_in_metres(unit)
    if word not in METRES:
        raise ParameterError(f"A C3D states its unit by name: one of {', '.join(METRES)}, got {unit!r}.")
    return word, metres


def _parameters(points: Trajectories, unit: str) -> bytes:
    """The section of parameters, in whole blocks."""
    frames, count = points.positions.shape[:2]
    long = frames > _FULL
    labels = [_label(name) for name in points.names]

    def groups(data_block: int) -> dict[str, list[bytes]]:
        point = [
            _integers("USED", count),
            _floats("SCALE", -1.0),
            _floats("RATE", points.rate),
            _integers("DATA_START", data_block),
            _integers("FRAMES", min(frames, _FULL)),
            *([_floats("LONG_FRAMES", float(frames))] if long else []),
            _texts("UNITS", [unit.encode()]),
            _texts("X_SCREEN", [b"+X"]),
            _texts("Y_SCREEN", [b"+Y"]),
            *_lists("LABELS", labels),
            _texts("DESCRIPTIONS", [points.kind.encode()]),  # that of the first stands for all
        ]
        analog = [_integers("USED", 0), _floats("GEN_SCALE", 1.0), _floats("RATE", points.rate)]
        last = [
            _integers(f"ACTUAL_{end}_FIELD", n & _FULL, n >> 16) for end, n in (("START", 1), ("END", frames))
        ]
        return {
            "POINT": point,
            "ANALOG": analog,
            "FORCE_PLATFORM": [_integers("USED", 0)],
            "TRIAL": last,
            "MANUFACTURER": [_texts("SOFTWARE", [OURS.encode()])],
        }

    def section(data_block: int) -> bytes:
        entries = b""
        for number, (group, members) in enumerate(groups(data_block).items(), 1):
            entries += bytes([len(group), -number & 0xFF]) + group.encode() + b"\x03\0\0"
            entries += b"".join(member[:1] + bytes([number]) + member[1:] for member in members)
        return entries + b"\0\0"

    blocks = -(-(4 + len(section(0))) // BLOCK)
    if blocks > _BLOCKS:
        raise ParameterError(
            f"The labels of a C3D have {_BLOCKS * BLOCK:,} bytes at most, {count:,} points of such names need more.",
            remedy="Shorten the names, or write .npz.",
        )
    return (bytes([1, 0x50, blocks, INTEL]) + section(2 + blocks)).ljust(blocks * BLOCK, b"\0")


def _label(name: str) -> bytes:
    try:
        label = name.strip(" \0\t").encode("utf-8")
    except UnicodeEncodeError as error:
        raise ParameterError(
            f"A C3D cannot hold {error.object[error.start : error.end]!r} in a point's name."
        ) from None
    if len(label) > _WIDEST:
        raise ParameterError(
            f"A label of a C3D has at most {_WIDEST} bytes, {name[:40]!r}… has {len(label)}.",
            remedy="Shorten it.",
        )
    return label


def _lists(name: str, texts: Sequence[bytes]) -> list[bytes]:
    """A list as parameters NAME, NAME2, NAME3 …, since one holds no more than 255 texts."""
    width = max(map(len, texts))
    most = min(_WIDEST, (_LARGEST - _WIDEST) // width)
    parts = [texts[start : start + most] for start in range(0, len(texts), most)]
    return [_texts(f"{name}{k}" if k > 1 else name, part) for k, part in enumerate(parts, 1)]


def _texts(name: str, texts: Sequence[bytes]) -> bytes:
    width = max(map(len, texts))
    return _parameter(name, -1, (width, len(texts)), b"".join(text.ljust(width) for text in texts))


def _integers(name: str, *numbers: int) -> bytes:
    shape = (len(numbers),) if len(numbers) > 1 else ()
    return _parameter(name, 2, shape, struct.pack(f"<{len(numbers)}H", *numbers))


def _floats(name: str, number: float) -> bytes:
    return _parameter(name, 4, (), struct.pack("<f", number))


def _parameter(name: str, kind: int, shape: tuple[int, ...], data: bytes) -> bytes:
    """An entry without the number of its group, which stands after its first byte."""
    body = bytes([kind & 0xFF, len(shape), *shape]) + data + b"\0"
    return bytes([len(name)]) + name.encode() + struct.pack("<H", len(body) + 2) + body
