"""Segments: the rigid parts of a body, each with a frame that turns with it, from joints and from what files tell.

Conventions
-----------
A segment's axes are parallel to the body's at rest, standing with hanging arms: x to the person's left, y up, z to the
front. The trunk is one line from the middle of the hips to the middle of the shoulders; pelvis and thorax turn about it
with the hips and the shoulders, the abdomen half-way. A limb's long axis is the line between its joints, and its frame
is that of the part it hangs on, turned the shortest way. That leaves open how a limb turns about its own long axis,
which points do not tell: it counts as not turning. Where a file holds rotations, and the bone stands still in the frame
of its joint, that turn is the joint's.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from leitmotion.body.inertia import AXIAL, LIMBS, Table
from leitmotion.body.size import OF_STATURE, size_of_body
from leitmotion.motion import DataError, rotations

SEGMENTS = AXIAL + tuple(f"{side}_{limb}" for side in ("left", "right") for limb in LIMBS)
"""The 16 rigid parts."""
ENDS = {
    "head": ("neck", "head"),
    **{
        f"{side}_{segment}": (f"{side}_{upper}", f"{side}_{lower}")
        for side in ("left", "right")
        for segment, upper, lower in (
            ("upper_arm", "shoulder", "elbow"), ("forearm", "elbow", "wrist"), ("hand", "wrist", "hand"),
            ("thigh", "hip", "knee"), ("shank", "knee", "ankle"), ("foot", "ankle", "toe"),
        )
    },
}  # fmt: skip
"""Roles at the two ends of a segment: the one that it turns about, and the one it reaches to."""
NEEDED = tuple(
    dict.fromkeys(role for name, ends in ENDS.items() if name[-4:] not in ("hand", "foot") for role in ends)
)
"""Roles that a recording must have; those of hands and feet are used where it has them."""
NOWHERE = 1e-4
"""Metres: points that are nearer to each other stand in one place."""
STIFF = np.radians(3.0)
"""How far a bone may stray from its usual direction in the frame of its joint, root mean square."""


class Placed(NamedTuple):
    """Where the segments are, in the order of :data:`SEGMENTS`."""

    origins: np.ndarray
    """(T, S, 3) m, the end that each turns about."""
    centres: np.ndarray
    """(T, S, 3) m, centres of mass."""
    axes: np.ndarray
    """(T, S, 3, 3), columns are the axes x, y, z of each in the world."""


def check_roles(points: Mapping[str, np.ndarray], name: str) -> None:
    """Refuse a recording in which a needed role was not found, or two that a segment joins stand in one place.

    Raises
    ------
    DataError
        When one is missing, and the sentence names them all, or a segment has no length in a frame.
    """
    missing = [role for role in NEEDED if role not in points]
    if missing:
        raise DataError(
            f"Dynamics needs the joints of the whole body, and {name or 'the recording'} has no {', '.join(missing)}.",
            remedy='Name them by a map: body_map={"left_knee": "LKnee"} (--map FILE).',
        )
    pairs = [ends for ends in ENDS.values() if ends[1] in NEEDED]
    for one, other in [*pairs, ("left_hip", "right_hip"), ("left_shoulder", "right_shoulder")]:
        if has_no_length(points[one], points[other]):
            raise DataError(
                f"Dynamics needs joints that are apart, and in {name or 'the recording'} {one} and {other} stand in "
                "one place.",
                remedy='Name the right ones by a map: body_map={"left_knee": "LKnee"} (--map FILE).',
            )


def has_no_length(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two points stand in one place in some frame, NaN apart."""
    return bool((np.linalg.norm(one - other, axis=-1) < NOWHERE).any())


def lengths_of(points: Mapping[str, np.ndarray], table: Table) -> np.ndarray:
    """Measure the length by which the radii of gyration of each segment are scaled.

    Limbs are the median distance of their joints; the parts of the trunk are shares of the median distance from the
    hips to the shoulders; head, hands and feet, of which recordings hold no two ends, are shares of the stature.

    Parameters
    ----------
    points : mapping of str to (T, 3) float
        Global positions by role, m, NaN where unseen.
    table : Table
        Of which sex.

    Returns
    -------
    (S,) float
        Metres.
    """
    stature = (size_of_body(points) or np.nan) / OF_STATURE
    trunk = _usual(_middle(points, "shoulder") - _middle(points, "hip")) / table.shoulders_to_hips
    lengths = []
    for segment in SEGMENTS:
        part = table.parts[_part(segment)]
        if segment in ("pelvis", "abdomen", "thorax"):
            lengths.append(part.length * trunk)
        elif _part(segment) in ("head", "hand", "foot"):
            lengths.append(part.length / table.stature * stature)
        else:
            upper, lower = ENDS[segment]
            lengths.append(_usual(points[lower] - points[upper]))
    return np.array(lengths)


def stiff_turns(points: Mapping[str, np.ndarray], turns: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Keep the joints' rotations in whose frame the bone of their segment stands still.

    Parameters
    ----------
    points : mapping of str to (T, 3) float
        Global positions by role, m.
    turns : mapping of str to (T, 4) float
        Global rotations of the joints by role.

    Returns
    -------
    dict of str to (T, 4) float
        By segment.
    """
    kept = {}
    for segment, (upper, lower) in ENDS.items():
        if upper not in turns or lower not in points:
            continue
        along = _unit(rotations.rotate(rotations.conjugate(turns[upper]), points[lower] - points[upper]))
        spread = 1.0 - float(np.linalg.norm(along.mean(axis=0)))  # 1 - cos of the usual angle
        if np.isfinite(spread) and spread <= 1.0 - np.cos(STIFF):
            kept[segment] = turns[upper]
    return kept


def place_segments(
    points: Mapping[str, np.ndarray],
    table: Table,
    lengths: np.ndarray,
    turns: Mapping[str, np.ndarray] | None = None,
) -> Placed:
    """Place the segments of a body and turn their frames.

    Parameters
    ----------
    points : mapping of str to (T, 3) float
        Global positions by role, m, without gaps.
    table : Table
        Of which sex.
    lengths : (S,) float
        As :func:`lengths_of` measures them, m.
    turns : mapping of str to (T, 4) float, optional
        Global rotations of the joints that carry a segment, by segment (:func:`stiff_turns`).

    Returns
    -------
    Placed
        Origins, centres of mass and axes.
    """
    long = dict(zip(SEGMENTS, lengths, strict=True))
    hips, shoulders = _middle(points, "hip"), _middle(points, "shoulder")
    up = _unit(shoulders - hips)
    across = {
        "pelvis": _unit(points["left_hip"] - points["right_hip"]),
        "thorax": _unit(points["left_shoulder"] - points["right_shoulder"]),
    }
    across["abdomen"] = across["pelvis"] + across["thorax"]
    origins, centres, axes = {}, {}, {}
    for segment, top, low in _trunk(table):
        axes[segment] = _frame(up, across[segment])
        centre = top - table.parts[segment].centre * (top - low)
        origins[segment] = hips + low * (shoulders - hips)
        centres[segment] = hips + centre * (shoulders - hips)
    for segment, (upper, lower) in ENDS.items():
        part, side = table.parts[_part(segment)], -1.0 if segment.startswith("right") else 1.0
        origin, hung = points[upper], _hangs_on(segment)
        held = lower in points
        if _part(segment) == "foot":
            forward = _unit(points[lower] - origin) if held else axes[hung][..., 2]
            beside = _carried(axes[hung][..., 0], axes[hung][..., 2], forward)
            axes[segment] = _lying(forward, _spun(beside, turns, segment))
            centres[segment] = origin + part.centre * (points[lower] - origin) if held else origin
        else:
            towards = _unit(points[lower] - origin) if held else -axes[hung][..., 1]
            upwards = towards if segment == "head" else -towards
            frame = axes[hung]
            if (
                _part(segment) == "upper_arm"
            ):  # from an arm held out sideways, which no arm ever points away from
                beside = _carried(side * frame[..., 1], -side * frame[..., 0], upwards)
            else:
                beside = _carried(frame[..., 0], frame[..., 1], upwards)
            axes[segment] = _frame(upwards, _spun(beside, turns, segment))
            if segment == "head":
                centres[segment] = origin + (1 - part.centre) * long[segment] * towards
            elif _part(segment) == "hand":
                centres[segment] = origin + part.centre * long[segment] * towards
            else:
                centres[segment] = origin + part.centre * (points[lower] - origin)
        origins[segment] = origin
    return Placed(*(np.stack([held[name] for name in SEGMENTS], axis=1) for held in (origins, centres, axes)))


def _trunk(table: Table) -> list[tuple[str, float, float]]:
    """Upper and lower end of each part of the trunk, as shares of the way from hips to shoulders."""
    ends, top = [], table.top_to_hips
    for segment in ("thorax", "abdomen", "pelvis"):
        low = max(top - table.parts[segment].length, 0.0)
        ends.append((segment, top / table.shoulders_to_hips, low / table.shoulders_to_hips))
        top = low
    return ends


def _hangs_on(segment: str) -> str:
    """Name the segment whose frame another is turned from."""
    if segment == "head":
        return "thorax"
    side, _, limb = segment.partition("_")
    above = {"hand": "forearm", "forearm": "upper_arm", "foot": "shank", "shank": "thigh"}.get(limb)
    return f"{side}_{above}" if above else "thorax" if limb == "upper_arm" else "pelvis"


def _part(segment: str) -> str:
    return segment if segment in AXIAL else segment.partition("_")[2]


def _middle(points: Mapping[str, np.ndarray], pair: str) -> np.ndarray:
    middle: np.ndarray = (points[f"left_{pair}"] + points[f"right_{pair}"]) / 2
    return middle


def _usual(vectors: np.ndarray) -> float:
    return float(np.nanmedian(np.linalg.norm(vectors, axis=-1)))


def _spun(beside: np.ndarray, turns: Mapping[str, np.ndarray] | None, segment: str) -> np.ndarray:
    """The left axis as the joint's rotation carries it, from where it usually stands in the joint's frame."""
    if not turns or segment not in turns:
        return beside
    usual = rotations.rotate(rotations.conjugate(turns[segment]), beside).mean(axis=0)
    carried: np.ndarray = rotations.rotate(turns[segment], np.broadcast_to(usual, beside.shape))
    return carried


def _carried(vectors: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Turn vectors with the shortest turn that brings one direction to another."""
    axis, cosine = np.cross(start, end), np.sum(start * end, axis=-1, keepdims=True)
    once = np.cross(axis, vectors)
    turned: np.ndarray = vectors + once + np.cross(axis, once) / np.maximum(1 + cosine, 1e-9)
    return turned


def _frame(up: np.ndarray, beside: np.ndarray) -> np.ndarray:
    """Axes of which y is given and x lies as near as may be to what is."""
    x = _unit(beside - np.sum(beside * up, axis=-1, keepdims=True) * up)
    return np.stack((x, up, np.cross(x, up)), axis=-1)


def _lying(forward: np.ndarray, beside: np.ndarray) -> np.ndarray:
    """Axes of which z is given and x lies as near as may be to what is."""
    x = _unit(beside - np.sum(beside * forward, axis=-1, keepdims=True) * forward)
    return np.stack((x, np.cross(forward, x), forward), axis=-1)


def _unit(vectors: np.ndarray) -> np.ndarray:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    with np.errstate(invalid="ignore", divide="ignore"):
        return vectors / np.where(length > 0, length, np.nan)
