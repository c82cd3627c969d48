"""C3D: points in space, of which the markers are read; analog channels are left alone.

Whole and float storage of all three processors. A point whose residual is negative was not seen. Points that a model
computed (angles, forces, moments, powers, segment axes) are no markers and are left out, and so are trajectories
without a label; the warnings count both. Labels ``SUBJECT:NAME`` tell several people apart.

References
----------
.. [1] The C3D file format user guide. Motion Lab Systems, 2021.
"""

from __future__ import annotations

import re

import numpy as np

from leitmotion.io.c3d_parameters import BLOCK, Header, read_header
from leitmotion.io.points import distinct, split_people, unseen_in_origin
from leitmotion.io.reading import Draft, Finding, Source
from leitmotion.io.units import unit_named

_COMPUTED = ("ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS", "REACTIONS", "MODELED_MARKERS")
_AXES = "OALP"  # last letters of the four points by which Plug-in Gait stores a segment's axes
_FULL = 65535  # the largest frame number a header holds


def read(source: Source) -> Draft:
    """Read the markers of a C3D.

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
        When it is no C3D, holds no points or ends before its first frame.
    """
    header = read_header(source)
    warnings: list[str] = []
    positions = _positions(source, header, warnings)
    labels = header.texts("POINT", "LABELS")[: header.points]
    labels += [""] * (header.points - len(labels))
    kept = _markers(header, labels, warnings)
    if not kept:
        raise source.error("expected labelled markers, found computed or unlabelled points only.")
    names = distinct([labels[k] or f"point{k + 1}" for k in kept], warnings)
    takes = split_people(names, positions if len(kept) == header.points else positions[:, kept])
    return Draft(
        takes,
        rate=_rate(source, header),
        unit=_unit(header),
        up=_up(header),
        up_may_err=True,
        warnings=warnings,
    )


def _positions(source: Source, header: Header, warnings: list[str]) -> np.ndarray:
    """Places of all points (T, P, 3) in the file's unit, NaN where unseen."""
    if header.points == 0:
        raise source.error("expected points, found analog channels only.")
    width = 4 * header.points + header.analog
    size = 4 if header.scale < 0 else 2
    block = header.data_block or int(header.number("POINT", "DATA_START") or 0)
    start = (block - 1) * BLOCK
    if start < BLOCK:
        raise source.error(f"expected its data after the parameters, found them said to be in block {block}.")
    fit = max(0, len(source.content) - start) // (width * size)
    frames = _frames(header, fit, warnings)
    if frames < 1:
        raise source.error("expected at least one whole frame, found the end of the file: it was cut short.")
    data = memoryview(source.content)[start : start + frames * width * size]
    machine = header.machine
    if size == 2:
        table = machine.integers(data).reshape(frames, width)[:, : 4 * header.points]
        scale = header.scale or header.number("POINT", "SCALE") or 1.0
    else:
        table = machine.floats(data).reshape(frames, width)[:, : 4 * header.points]
        scale = 1.0
    quads = table.reshape(frames, header.points, 4)
    with np.errstate(invalid="ignore", over="ignore"):  # a float may hold any bits
        positions = np.multiply(quads[..., :3], scale, dtype=np.float64)
        unseen = quads[..., 3] < 0
    if unseen.any():
        positions[unseen] = np.nan
    return unseen_in_origin(positions, warnings)


def _frames(header: Header, fit: int, warnings: list[str]) -> int:
    """How many frames there are: the header's count holds no more than 65,535, so others may overrule it."""
    counts = {"the first block": header.last - header.first + 1}
    long = header.number("POINT", "LONG_FRAMES")
    if long is not None:
        counts["POINT:LONG_FRAMES"] = int(long)
    stated = header.number("POINT", "FRAMES")
    if stated is not None:
        counts["POINT:FRAMES"] = int(stated) & _FULL if stated < 0 else int(stated)
    ends = [_wide(header, name) for name in ("ACTUAL_START_FIELD", "ACTUAL_END_FIELD")]
    if ends[0] is not None and ends[1] is not None:
        counts["TRIAL:ACTUAL_END_FIELD"] = ends[1] - ends[0] + 1
    full = header.last >= _FULL or counts.get("POINT:FRAMES") == _FULL
    frames = max(counts.values()) if full else counts["the first block"]
    if full and frames <= _FULL < fit:
        frames = fit  # nothing in the file counts further, but its data go on
    if not 1 <= frames <= fit:
        possible = [count for count in counts.values() if 1 <= count <= fit]
        taken = max(possible) if possible else fit
        warnings.append(f"The header promises {frames} frames, the file holds {fit}; {taken} were read.")
        return taken
    others = {where: count for where, count in counts.items() if count != frames and count != _FULL}
    if others and not full:
        said = ", ".join(f"{where} {count}" for where, count in others.items())
        warnings.append(f"The counts of frames disagree: {frames} were read, but {said} is stated as well.")
    return frames


def _wide(header: Header, name: str) -> int | None:
    """A frame number in two 16-bit words."""
    words = header.parameters.get(("TRIAL", name))
    if not isinstance(words, np.ndarray) or words.size == 0:
        return None
    words = words.reshape(-1).astype(np.int64) & _FULL
    return int(words[0] + (words[1] << 16 if words.size > 1 else 0))


def _markers(header: Header, labels: list[str], warnings: list[str]) -> list[int]:
    """Which points are markers with a label of their own."""
    groups = {word.upper() for word in header.texts("POINT", "TYPE_GROUPS")[::2]} | set(_COMPUTED)
    computed = {label for group in groups for label in header.texts("POINT", group)}
    bare = [label.rpartition(":")[2] for label in labels]
    known = set(bare)
    computed |= {
        name for name in known if len(name) == 4 and name[3] in _AXES and all(name[:3] + c in known for c in _AXES)
    }  # fmt: skip
    unlabelled = [
        k for k, name in enumerate(bare) if re.match(r"\*\d*$|(uname|unlabel+ed)\W*\d*$", name, re.IGNORECASE)
    ]
    derived = [k for k, name in enumerate(bare) if name in computed or labels[k] in computed]
    if derived:
        warnings.append(
            f"{len(derived)} points that a model computed (angles, forces, axes …) were left out."
        )
    if unlabelled:
        warnings.append(f"{len(unlabelled)} trajectories without a label were left out.")
    dropped = set(derived) | set(unlabelled)
    return [k for k in range(len(labels)) if k not in dropped]


def _rate(source: Source, header: Header) -> Finding:
    stated = header.number("POINT", "RATE")
    for rate, where in ((stated, "POINT:RATE"), (header.rate, "the first block")):
        if rate is not None and np.isfinite(rate) and rate > 0:
            return Finding(float(rate), "read", f"stated in {where}")
    if source.options.rate is None:
        raise source.error("expected a rate above 0 Hz, found none.", remedy="State it with --rate HZ.")
    return Finding(source.options.rate, "given", "rate given by the caller")


def _unit(header: Header) -> Finding | None:
    for word in header.texts("POINT", "UNITS"):
        unit = unit_named(word)
        if unit:
            return Finding(unit, "read", f"POINT:UNITS is {word!r}")
    return None


def _up(header: Header) -> Finding | None:
    """The vertical of the screen is the vertical of the room."""
    for word in header.texts("POINT", "Y_SCREEN"):
        match = re.fullmatch(r"([+-]?)([XYZxyz])", word)
        if match:
            return Finding(
                match[1].replace("+", "") + match[2].lower(), "read", f"POINT:Y_SCREEN is {word!r}"
            )
    return None
