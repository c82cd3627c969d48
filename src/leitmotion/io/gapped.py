"""Skeletons with gaps: what of a take without all its numbers is still known is where some joints are."""

from __future__ import annotations

import numpy as np

from leitmotion.io.reading import PointTake, SkeletonTake
from leitmotion.motion import Motion, Skeleton, forward_kinematics, rotations


def as_points(take: SkeletonTake, warnings: list[str]) -> PointTake:
    """Give the joints of a skeleton of which numbers are missing as points, unseen where nothing tells their place.

    A joint is nowhere where its own place is missing, or a place or rotation above it; a missing rotation leaves the
    joint itself where it is.

    Parameters
    ----------
    take : SkeletonTake
        T frames of J joints; NaN where a number is missing.
    warnings : list of str
        Gains a sentence with the counts.

    Returns
    -------
    PointTake
        The J joints in the world, in the file's unit and axes.
    """
    placed, turned = (np.isfinite(values).all(axis=-1) for values in (take.positions, take.rotations))
    gaps = int((~(placed & turned)).any(axis=1).sum())
    whole = Motion(
        Skeleton(tuple(take.names), take.parents, take.offsets),
        np.where(placed[..., None], take.positions, take.offsets),
        np.where(turned[..., None], take.rotations, rotations.IDENTITY),
        rate=1.0,
    )
    positions = forward_kinematics(whole).positions
    for joint, parent in enumerate(take.parents):
        if parent >= 0:
            placed[:, joint] &= placed[:, parent] & turned[:, parent]
            turned[:, joint] &= turned[:, parent]
    positions[~placed] = np.nan
    warnings.append(
        f"Numbers are missing in {gaps} of {len(placed)} frames, and a skeleton has no gaps: its joints were read as "
        f"points, unseen at {int((~placed).sum())} places."
    )
    return PointTake(list(take.names), positions, "joint", person=take.person)
