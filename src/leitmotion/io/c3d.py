"""C3D: points in space, of which the markers are read; analog channels are left alone.

Whole and float storage of all three processors. A point whose residual is negative was not seen. Points that a model
computed (angles, forces, moments, powers, segment axes) are no markers and are left out, and so are trajectories
without a label; the warnings count both. Labels ``SUBJECT:NAME`` tell several people apart. Of a file that Leitmotion
wrote everything is kept as it was.

References
----------
.. [1] The C3D file format user guide. Motion Lab Systems, 2021.
"""

from __future__ import annotations

import re

import numpy as np

from leitmotion.io.c3d_layout import Layout, find_layout
from leitmotion.io.c3d_parameters import Header, read_header
from leitmotion.io.points import distinct, split_people, unseen_in_origin
from leitmotion.io.reading import Draft, Finding, PointTake, Source
from leitmotion.io.units import unit_named

_COMPUTED = ("ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS", "REACTIONS", "MODELED_MARKERS")
_AXES = "OALP"  # last letters of the four points by which Plug-in Gait stores a segment's axes
_NO_LENGTHS = ("px", "relative")  # words for units of points that are not in metres
_SLOWEST = 1.0  # hertz, of a rate that is believed without a word
_CHUNK = 1 << 17  # numbers at a time, so that what lies between the file and the positions stays small

OURS = "Leitmotion"
"""What MANUFACTURER:SOFTWARE is in the files that :mod:`leitmotion.io.c3d_writing` makes."""


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
    if header.damaged:
        warnings.append("The parameters are damaged: those that could be read were used.")
    layout = find_layout(source, header, warnings)
    labels = header.texts("POINT", "LABELS")[: layout.points]
    ours = header.texts("MANUFACTURER", "SOFTWARE") == [OURS]
    kept = list(range(layout.points)) if ours else _markers(header, layout, labels, warnings)
    if not kept:
        raise source.error("expected labelled markers, found computed or unlabelled points only.")
    names = _names(labels, kept, warnings)
    positions = _positions(source, header, layout, kept)
    if ours:
        kind = "joint" if header.texts("POINT", "DESCRIPTIONS")[:1] == ["joint"] else "marker"
        takes = [PointTake(distinct(names, warnings), positions, kind)]
    else:
        names = distinct(_by_subject(header, names), warnings)
        takes = split_people(names, unseen_in_origin(positions, warnings))
    return Draft(
        takes,
        rate=_rate(source, header, warnings),
        unit=_unit(header, warnings),
        up=_up(header),
        up_may_err=not ours,
        warnings=warnings,
    )


def _positions(source: Source, header: Header, layout: Layout, kept: list[int]) -> np.ndarray:
    """Places of the points kept, (T, P, 3), in the file's unit, NaN where unseen."""
    positions = np.empty((layout.frames, len(kept), 3))
    decode = header.machine.integers if layout.size == 2 else header.machine.floats
    every = len(kept) == layout.points
    step = max(1, _CHUNK // layout.width)
    stride = layout.width * layout.size
    data = memoryview(source.content)[layout.start : layout.start + layout.frames * stride]
    for first in range(0, layout.frames, step):
        table = decode(data[first * stride : (first + step) * stride]).reshape(-1, layout.width)
        quads = table[:, : 4 * layout.points].reshape(len(table), layout.points, 4)
        quads = quads if every else quads[:, kept]
        places = positions[first : first + step]
        with np.errstate(invalid="ignore", over="ignore"):  # a float may hold any bits
            np.multiply(quads[..., :3], layout.scale, out=places, dtype=np.float64)
            unseen = (quads[..., 3] < 0) | np.isnan(places[..., 0] + places[..., 1] + places[..., 2])
        if unseen.any():
            places[unseen] = np.nan
    return positions


def _markers(header: Header, layout: Layout, labels: list[str], warnings: list[str]) -> list[int]:
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
    return [k for k in range(layout.points) if k not in dropped]


def _names(labels: list[str], kept: list[int], warnings: list[str]) -> list[str]:
    """The labels of the points kept; those without one are called by their number."""
    names = [labels[k] if k < len(labels) and labels[k] else f"point{k + 1}" for k in kept]
    numbered = sum(k >= len(labels) or not labels[k] for k in kept)
    if numbered:
        warnings.append(
            f"{numbered} of {len(kept)} points have no label in the file; they are called by number."
        )
    return names


def _by_subject(header: Header, names: list[str]) -> list[str]:
    """Names as ``SUBJECT:NAME`` where the subjects' prefixes end in another mark than a colon."""
    prefixes = [word for word in header.texts("SUBJECTS", "LABEL_PREFIXES") if word.rstrip(":")]
    if not header.number("SUBJECTS", "USES_PREFIXES"):
        return names
    for prefix in sorted(prefixes, key=len, reverse=True):
        subject = prefix.rstrip(":_-. ")
        names = [
            f"{subject}:{name[len(prefix) :]}" if ":" not in name and name.startswith(prefix) else name
            for name in names
        ]
    return names


def _rate(source: Source, header: Header, warnings: list[str]) -> Finding:
    said = {"POINT:RATE": header.number("POINT", "RATE"), "the first block": float(str(header.rate))}
    rates = {
        where: rate for where, rate in said.items() if rate is not None and np.isfinite(rate) and rate > 0
    }
    if not rates:
        if source.options.rate is None:
            raise source.error("expected a rate above 0 Hz, found none.", remedy="State it with --rate HZ.")
        return Finding(source.options.rate, "given", "rate given by the caller")
    # the parameter, unless its frames last a second and more and those of the first block do not
    where = next((where for where, rate in rates.items() if rate > _SLOWEST), next(iter(rates)))
    rate = rates[where]
    if source.options.rate is None:
        if max(rates.values()) > 1.001 * min(rates.values()):
            both = " and ".join(f"{other:g} Hz in {place}" for place, other in rates.items())
            warnings.append(
                f"The rate is {both}; {rate:g} Hz was taken: if it is wrong, state the rate with --rate HZ."
            )
        if rate <= _SLOWEST:
            warnings.append(
                f"A frame lasts {1 / rate:g} s, longer than a movement's do: if that is not so, state the rate with "
                "--rate HZ."
            )
    return Finding(rate, "read", f"stated in {where}")


def _unit(header: Header, warnings: list[str]) -> Finding | None:
    words = [word for word in header.texts("POINT", "UNITS") if word]
    for word in words:
        unit = word if word in _NO_LENGTHS else unit_named(word)
        if unit:
            return Finding(unit, "read", f"POINT:UNITS is {word!r}")
    if words:
        warnings.append(f"POINT:UNITS is {words[0]!r}, which names no unit of length that is known here.")
    return None


def _up(header: Header) -> Finding | None:
    """The vertical of the screen is the vertical of the room."""
    for word in header.texts("POINT", "Y_SCREEN"):
        match = re.fullmatch(r"([+-]?)\s*([XYZxyz])", word)
        if match:
            return Finding(
                match[1].replace("+", "") + match[2].lower(), "read", f"POINT:Y_SCREEN is {word!r}"
            )
    return None
