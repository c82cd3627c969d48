"""Plausibility: what the geometry says against an assignment of roles.

Nothing is changed here. Each check that fails gives a factor below 1 for the roles that it casts doubt on.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from leitmotion.body.look import between, typical

SEGMENTS = (("hip", "knee"), ("knee", "ankle"), ("shoulder", "elbow"), ("elbow", "wrist"))
LARGEST_RATIO = 1.5  # of one bone's length on the two sides; people differ by a few per cent
SHORTEST = 0.02  # of the body's height: two joints nearer than this are one joint twice
DOUBT = 0.5


def doubts(points: Mapping[str, np.ndarray]) -> dict[str, float]:
    """Find what the places of the points say against their roles.

    Checked are: no bone is without length; a bone is about as long on the left as on the right; the head is farther
    from the pelvis than the neck is. Whether left is left is told by :mod:`leitmotion.body.sides`.

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
    return factor


def _height(points: Mapping[str, np.ndarray]) -> float:
    """Something near the height of the person: the largest extent of the points in a usual frame."""
    if not points:
        return np.nan
    stacked = np.stack(list(points.values()), axis=1)
    seen = stacked[np.isfinite(stacked).all(axis=(1, 2))]
    return typical(np.ptp(seen, axis=1).max(axis=1)) if len(seen) else np.nan


def _distance(points: Mapping[str, np.ndarray], start: str, end: str) -> float:
    """Median distance; NaN, against which every comparison is false, where it cannot be told."""
    step = between(points, start, end)
    return np.nan if step is None else typical(np.linalg.norm(step, axis=-1))
