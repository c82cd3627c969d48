"""Size: one length that says how large a body is, told from whichever roles were found.

References
----------
[1] Drillis, Contini, *Body segment parameters*, New York University (1966): segment lengths as shares of
    stature, as tabulated in Winter, *Biomechanics and Motor Control of Human Movement*.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

CHAIN = {
    ("hip", "knee"): 0.245,
    ("knee", "ankle"): 0.246,
    ("pelvis", "neck"): 0.288,
    ("neck", "head"): 0.080,
}
"""Parts of the chain ankle-knee-hip and pelvis-neck-head, as shares of stature [1]."""

ARM = {("shoulder", "elbow"): 0.186, ("elbow", "wrist"): 0.146}
BREADTH = {("left_shoulder", "right_shoulder"): 0.259, ("left_hip", "right_hip"): 0.191}
"""What speaks for the parts of the chain that are missing, as shares of stature [1]."""

OF_STATURE = sum(CHAIN.values())
"""The whole chain as a share of stature: 0.859."""


def size_of_body(points: Mapping[str, np.ndarray]) -> float | None:
    """Measure a body: the length of the chain ankle-knee-hip plus pelvis-neck-head.

    Each part is the median over time, the mean of the two sides. A part whose roles are missing takes its share of
    the stature that the other parts and the arms speak for [1]; the breadths speak only where all else is silent.

    Parameters
    ----------
    points : mapping of str to (T, C) float
        Positions by role, NaN where unseen.

    Returns
    -------
    float or None
        In the unit of `points`; None where nothing tells it.
    """
    for shares in (CHAIN | ARM, BREADTH):
        known = {part: length for part in shares if (length := _length(points, part)) is not None}
        if known:
            stature = sum(known.values()) / sum(shares[part] for part in known)
            return float(sum(known.get(part, share * stature) for part, share in CHAIN.items()))
    return None


def size_of_cloud(positions: np.ndarray) -> float | None:
    """Measure a person of whom no role is known: the height of the points in a usual frame.

    Parameters
    ----------
    positions : (T, P, C) float
        Positions, Y up, NaN where unseen.

    Returns
    -------
    float or None
        The chain of :func:`size_of_body` in a person whose stature is the median over time of the extent
        along Y, in the unit of `positions`; of the largest extent where they never differ in Y; None where
        they never differ.
    """
    seen = positions[np.isfinite(positions).all(axis=2).any(axis=1)]
    if not len(seen):
        return None
    extent = np.nanmax(seen, axis=1) - np.nanmin(seen, axis=1)
    for span in (extent[:, 1], extent.max(axis=1)):
        height = float(np.median(span))
        if height > 0:
            return height * OF_STATURE
    return None


def _length(points: Mapping[str, np.ndarray], part: tuple[str, str]) -> float | None:
    ends = [part] if part[0] in points or part[0].startswith("left_") else []
    ends = ends or [(f"{side}_{part[0]}", f"{side}_{part[1]}") for side in ("left", "right")]
    lengths = []
    for start, end in ends:
        if start in points and end in points:
            length = np.linalg.norm(points[end] - points[start], axis=-1)
            length = length[np.isfinite(length)]
            if len(length) and np.median(length) > 0:
                lengths.append(float(np.median(length)))
    return float(np.mean(lengths)) if lengths else None
