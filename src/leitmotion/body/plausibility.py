"""Plausibility: what the geometry says against an assignment of roles.

Nothing is changed here. Each check that fails gives a factor below 1 for the roles that it casts doubt on.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

SEGMENTS = (("hip", "knee"), ("knee", "ankle"), ("shoulder", "elbow"), ("elbow", "wrist"))
LARGEST_RATIO = 1.5  # of one bone's length on the two sides; people differ by a few per cent
SHORTEST = 0.02  # of the body's height: two joints nearer than this are one joint twice
DOUBT = 0.5
CLEARLY = 0.8  # of 1: how much of what the feet say must be against the names


def doubts(points: Mapping[str, np.ndarray]) -> dict[str, float]:
    """Find what the places of the points say against their roles.

    Checked are: no bone is without length; a bone is about as long on the left as on the right; the head is
    farther from the pelvis than the neck is; hips and shoulders agree on which side is left; and the lower foot
    points where a person faces whose left is where the names say it is, up being from the pelvis to the neck or,
    without a neck, from the ankles to the pelvis. The other foot may hang, and in a run its toes point backwards
    for most of the stride. The last check finds files whose sides are swapped or whose axes are left-handed.

    Parameters
    ----------
    points : mapping of str to (T, C) float
        Some frames of each role, C = 2 or 3, NaN where unseen.

    Returns
    -------
    dict of str to float
        Factors in (0, 1) for the roles in doubt.
    """
    factor: dict[str, float] = {}
    height = _height(points)
    for above, below in SEGMENTS:
        lengths = [_distance(points, f"{side}_{above}", f"{side}_{below}") for side in ("left", "right")]
        short = [length < SHORTEST * height for length in lengths]
        unequal = max(lengths) > LARGEST_RATIO * min(lengths)
        for side, is_short in zip(("left", "right"), short, strict=True):
            if is_short or unequal:
                factor[f"{side}_{below}"] = DOUBT
    if _distance(points, "pelvis", "head") < _distance(points, "pelvis", "neck"):
        factor["head"] = DOUBT
    if _sides_look_swapped(points):
        for role in points:
            if role.startswith(("left_", "right_")):
                factor[role] = factor.get(role, 1.0) * DOUBT
    return factor


def _sides_look_swapped(points: Mapping[str, np.ndarray]) -> bool:
    across = {pair: _between(points, f"right_{pair}", f"left_{pair}") for pair in ("hip", "shoulder")}
    if _median(_dot(across["hip"], across["shoulder"])) < 0:
        return True
    left, up = across["hip"], _up(points)
    if left is None or up is None or left.shape[-1] != 3:
        return False
    feet = [_between(points, f"{side}_ankle", f"{side}_toe") for side in ("left", "right")]
    if feet[0] is None or feet[1] is None:
        return False
    lower = points["left_ankle"][:, 1] < points["right_ankle"][:, 1]
    ahead = _dot(np.where(lower[:, None], feet[0], feet[1]), np.cross(left, up))
    ahead = ahead[np.isfinite(ahead)]
    return bool(ahead.sum() < -CLEARLY * np.abs(ahead).sum())


def _up(points: Mapping[str, np.ndarray]) -> np.ndarray | None:
    trunk = _between(points, "pelvis", "neck")
    legs = [_between(points, f"{side}_ankle", "pelvis") for side in ("left", "right")]
    if trunk is not None or legs[0] is None or legs[1] is None:
        return trunk
    return legs[0] + legs[1]


def _height(points: Mapping[str, np.ndarray]) -> float:
    """Something near the height of the person: the largest extent of the points in a usual frame."""
    if not points:
        return np.nan
    stacked = np.stack(list(points.values()), axis=1)
    seen = stacked[np.isfinite(stacked).all(axis=(1, 2))]
    return float(np.median(np.ptp(seen, axis=1).max(axis=1))) if len(seen) else np.nan


def _between(points: Mapping[str, np.ndarray], start: str, end: str) -> np.ndarray | None:
    return points[end] - points[start] if start in points and end in points else None


def _distance(points: Mapping[str, np.ndarray], start: str, end: str) -> float:
    """Median distance; NaN, against which every comparison is false, where it cannot be told."""
    step = _between(points, start, end)
    return np.nan if step is None else _median(np.linalg.norm(step, axis=-1))


def _dot(a: np.ndarray | None, b: np.ndarray | None) -> np.ndarray:
    return np.array([]) if a is None or b is None else np.einsum("ti,ti->t", a, b)


def _median(values: np.ndarray) -> float:
    values = values[np.isfinite(values)]
    return float(np.median(values)) if len(values) else np.nan
