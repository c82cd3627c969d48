"""What a file does not say, judged from the body in it: the vertical.

Every judgement is a :class:`~leitmotion.io.reading.Finding` that is "guessed" and says why.
"""

from __future__ import annotations

import numpy as np

from leitmotion.io.reading import Finding, PointTake, SkeletonTake
from leitmotion.io.spread import LOOKS, mean, median, reach
from leitmotion.motion import Motion, Skeleton, forward_kinematics

_STEADY = 0.08  # how far, of the body's size, the lowest point may wander on a ground
_GROUND = 0.2  # how far, of the body's size, a ground may lie from zero
_UPRIGHT = 0.8  # share of the way from feet to head that must lie along one axis

_HIGH = (
    "head",
    "nose",
    "fhd",
    "bhd",
    "neck",
    "c7",
    "clav",
    "shoulder",
    "sho",
    "acro",
    "chest",
    "thorax",
    "ster",
)
_LOW = (
    "foot",
    "feet",
    "toe",
    "ankle",
    "heel",
    "ank",
    "hee",
    "mt1",
    "mt2",
    "mt5",
    "shank",
    "tibia",
    "knee",
    "hip",
    "asi",
    "psi",
    "sacr",
)


def look(take: SkeletonTake | PointTake) -> np.ndarray:
    """Place a person's points in a few frames spread over the recording.

    Parameters
    ----------
    take : SkeletonTake or PointTake
        One person.

    Returns
    -------
    (L, P, C) float
        Global positions in the file's unit and axes, NaN where unseen.
    """
    frames = len(take.positions)
    chosen = np.unique(np.linspace(0, frames - 1, min(frames, LOOKS)).astype(int))
    if isinstance(take, PointTake):
        return take.positions[chosen]
    skeleton = Skeleton(tuple(take.names), take.parents, take.offsets)
    motion = Motion(skeleton, take.positions[chosen], take.rotations[chosen], rate=1.0)
    return forward_kinematics(motion).positions


def judge_up(positions: np.ndarray, take: SkeletonTake | PointTake) -> Finding:
    """Tell the vertical: the axis from the feet to the head where names tell, else the body's longest.

    Parameters
    ----------
    positions : (L, P, C) float
        What :func:`look` saw.
    take : SkeletonTake or PointTake
        The person.

    Returns
    -------
    Finding
        An axis, "y" or "-z".
    """
    axes = "xyz"[: positions.shape[-1]]
    words = [name.lower() for name in take.names]
    high = [k for k, word in enumerate(words) if any(part in word for part in _HIGH)]
    low = [k for k, word in enumerate(words) if any(part in word for part in _LOW)]
    if len(axes) == 2:
        rise = median(mean(positions[:, high]) - mean(positions[:, low])) if high and low else np.zeros(2)
        seen = _along(axes, rise)
        if seen.endswith("y"):
            return Finding(seen, "guessed", "the head is above the feet along it")
        return Finding("-y", "guessed", "points in a picture, whose rows count downwards")
    if high and low:
        seen = _along(axes, median(mean(positions[:, high]) - mean(positions[:, low])))
        rest = ""
        if isinstance(take, SkeletonTake):
            bind = _rest(take)
            rest = _along(axes, bind[high].mean(axis=0) - bind[low].mean(axis=0))
        if seen and seen == rest:
            return Finding(seen, "guessed", "the head is above the feet along it")
        # who lies is long along another axis than the vertical; the ground tells them apart
        near = min((seen, rest), key=lambda axis: _wander(axis, positions))
        if isinstance(take, SkeletonTake) and not np.isfinite(_wander(near, positions)):
            near = min(("y", "z") if "z" in axes else ("y",), key=lambda axis: _wander(axis, positions))
        if seen and near != seen and np.isfinite(_wander(near, positions)):
            return Finding(near, "guessed", "the ground lies along it, and the body mostly does not stand")
        if seen or rest:
            where = "" if seen else " in the rest pose"
            return Finding(seen or rest, "guessed", f"the head is above the feet along it{where}")
    spread = median(reach(positions))
    longest = int(np.argmax(spread))
    if spread[longest] > 1.2 * np.delete(spread, longest).max():
        return Finding(axes[longest], "guessed", "the body is longest along it")
    return Finding("y", "guessed", "nothing in the file tells, and Y is the usual vertical")


def contradict_up(stated: Finding, positions: np.ndarray) -> Finding | None:
    """Tell whether a stated vertical cannot be: the body is tall along another axis, and there it has a floor.

    A floor is where the lowest point of the body stays while the body moves; who lies has one along the true vertical,
    so that lying does not contradict.

    Parameters
    ----------
    stated : Finding
        What the file says.
    positions : (L, P, 3) float
        What :func:`look` saw.

    Returns
    -------
    Finding or None
        The vertical that fits instead, None where the stated one may stand.
    """
    if positions.shape[-1] != 3 or len(positions) < 8:
        return None
    width = median(reach(positions))
    size = width.max()
    seen = np.isfinite(positions)
    lowest = np.where(seen, positions, np.inf).min(axis=1)
    highest = np.where(seen, positions, -np.inf).max(axis=1)
    whole = np.isfinite(lowest).all(axis=1)
    if size == 0.0 or whole.sum() < 8:
        return None
    wander = [
        np.ptp(np.percentile(edge[whole], (10, 90), axis=0), axis=0) / size for edge in (lowest, highest)
    ]
    said, tall = "xyz".index(stated.value[-1]), int(np.argmax(width))
    steady = min(wander[0][tall], wander[1][tall])
    if width[tall] < 1.8 * width[said] or steady > 0.05 or min(wander[0][said], wander[1][said]) < 0.1:
        return None
    sign = "-" if wander[1][tall] < wander[0][tall] else ""
    return Finding(
        f"{sign}{'xyz'[tall]}",
        "guessed",
        f"{stated.reason}, but the body is tall along this axis and has its floor there",
    )


def _wander(axis: str, positions: np.ndarray) -> float:
    """How far, of the body's size, its lowest point along an axis wanders; infinite where that is no ground."""
    size = median(reach(positions)).max()
    if not axis or size == 0.0:
        return np.inf
    heights = positions[..., "xyz".index(axis[-1])] * (-1.0 if axis[0] == "-" else 1.0)
    lowest = np.where(np.isfinite(heights), heights, np.inf).min(axis=1) / size
    lowest = lowest[np.isfinite(lowest)]
    if lowest.size == 0 or abs(float(np.median(lowest))) > _GROUND:
        return np.inf
    wander = float(np.ptp(np.percentile(lowest, (10, 90))))
    return wander if wander < _STEADY else np.inf


def _along(axes: str, rise: np.ndarray) -> str:
    """Name the axis, with its sign, along which most of a way lies; empty where it lies askew."""
    length = float(np.linalg.norm(rise))
    axis = int(np.argmax(np.abs(rise)))
    if length == 0.0 or abs(rise[axis]) < _UPRIGHT * length:
        return ""
    return ("-" if rise[axis] < 0 else "") + axes[axis]


def _rest(take: SkeletonTake) -> np.ndarray:
    rest = np.array(take.offsets)
    for joint, parent in enumerate(take.parents):
        if parent >= 0:
            rest[joint] += rest[parent]
    return rest
