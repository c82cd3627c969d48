"""Facing: which way the body's front points about the vertical, through bends, somersaults and cartwheels.

The trunk has a left, an up and a front axis. Its yaw is the twist about the vertical of the swing-twist
decomposition: with ``l`` the left and ``f`` the front axis, and (x, z) their horizontal parts,

    yaw = atan2(f_x - l_z, f_z + l_x)

which is the sum of two horizontal arrows: where the front points, and where a person whose left is ``l``
would look if they stood. In a forward bend or a somersault the left axis keeps its direction while the front
turns over; in a cartwheel it is the other way round; the sum follows the axis that still lies flat. It turns
with the person exactly and changes sign in the mirror. The length of the sum is 1 + cos(tilt of the trunk),
so that only a trunk that is upside down has no yaw.

Paper P turns by the normal of three trunk markers, which is the front axis alone; upright, both agree.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

FAINTEST = 0.2  # of 2: below, the trunk tilts by more than 143 degrees and every wobble turns its yaw about


def yaw_of_trunk(points: Mapping[str, np.ndarray]) -> np.ndarray | None:
    """Tell which way a body faces.

    The left axis is the sum of the directions across hips and shoulders; where a frame shows one of them only, that
    one. The up axis runs from the pelvis to the neck (without one of them: to the head, or between the middles of
    hips and shoulders); where there is none, the left axis alone decides, as for a person who stands. Frames in which
    the yaw cannot be told (points unseen, trunk upside down) take it from the frames around them, linearly and the
    shorter way round: the yaw of a body is slow, and only the yaw is filled, never a position.

    Parameters
    ----------
    points : mapping of str to (T, 3) float
        Global positions by role, NaN where unseen.

    Returns
    -------
    (T,) float or None
        Radians, unwrapped along time; None where no frame tells it.
    """
    left = _left_axis(points)
    if left is None:
        return None
    up = _up_axis(points)
    if up is None:
        front_x, front_z = -left[:, 2], left[:, 0]
        arrow = np.stack((front_x, front_z), axis=1)
    else:
        front = _unit(np.cross(left, up))
        arrow = np.stack((front[:, 0] - left[:, 2], front[:, 2] + left[:, 0]), axis=1)
    length = np.linalg.norm(arrow, axis=1)
    told = np.flatnonzero(length >= FAINTEST)  # false where the length is NaN
    if not told.size:
        return None
    yaw = np.unwrap(np.arctan2(arrow[told, 0], arrow[told, 1]))
    return np.interp(np.arange(len(arrow)), told, yaw) + 0.0  # no negative zero


def _left_axis(points: Mapping[str, np.ndarray]) -> np.ndarray | None:
    lines = []
    for pair in ("hip", "shoulder"):
        if f"left_{pair}" in points and f"right_{pair}" in points:
            lines.append(_unit(points[f"left_{pair}"] - points[f"right_{pair}"]))
    if not lines:
        return None
    both = np.stack(lines)
    seen = np.isfinite(both).all(axis=2)
    total = np.where(seen[..., None], both, 0.0).sum(axis=0)
    return _unit(np.where(seen.any(axis=0)[:, None], total, np.nan))


def _up_axis(points: Mapping[str, np.ndarray]) -> np.ndarray | None:
    for start, end in (("pelvis", "neck"), ("pelvis", "head"), ("pelvis", "chest")):
        if start in points and end in points:
            return points[end] - points[start]
    middles = [
        (points[f"left_{pair}"] + points[f"right_{pair}"]) / 2
        for pair in ("hip", "shoulder")
        if f"left_{pair}" in points and f"right_{pair}" in points
    ]
    return middles[1] - middles[0] if len(middles) == 2 else None


def _unit(vectors: np.ndarray) -> np.ndarray:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    with np.errstate(invalid="ignore", divide="ignore"):
        return vectors / np.where(length > 0, length, np.nan)
