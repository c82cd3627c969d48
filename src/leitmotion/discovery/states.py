"""States: candidates that are the same posture, or each other's mirror image, and every time that one is passed."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.moments import Moments

RETURNED = (
    0.6  # of the farthest way between: two halts nearer than that are a return, others are two postures
)
ALIKE = 0.5  # of the least way between two postures, within which they are the same
APART = 1.5  # times what is half alike, from which two postures count as apart
LOOSEST = np.radians(20.0)
ASKEW = np.radians(8.0)  # lopsidedness that may be how a suit sits


class Orbits(NamedTuple):
    """States up to reflection."""

    members: tuple[np.ndarray, ...]
    """Moments of each."""
    symmetric: tuple[bool, ...]
    sides: tuple[np.ndarray, ...]
    """1 or -1 for each member."""
    alike: float
    """The angle within which two moments are the same state."""
    confidence: float


def askew(moments: Moments) -> float:
    """How lopsided the most symmetric moment is, radians; 0 where that is more than how a suit may sit."""
    least = float(np.percentile(np.diagonal(moments.mirror), 1))
    return least if least < ASKEW else 0.0


def straight(angle: np.ndarray, floor: float) -> np.ndarray:
    """Take from an angle to a mirror image what is how a suit sits."""
    return np.sqrt(np.maximum(np.square(angle) - floor**2, 0.0))


def apart_of(moments: Moments, candidates: Sequence[int], extents: Sequence[float] = ()) -> float:
    """The angle within which two candidates are the same state, from those that follow one another."""
    own = moments.own
    chords = []
    for a, b in pairwise(candidates):
        if np.searchsorted(moments.starts, a, side="right") != np.searchsorted(
            moments.starts, b, side="right"
        ):
            continue
        chord, way = own[a, b], own[a, a : b + 1].max()
        if chord > max(RETURNED * way, APART * moments.half):
            chords.append(chord)
    chords += [0.8 * extent for extent in extents]
    if not chords:
        return float(moments.half)
    return float(np.clip(ALIKE * np.percentile(chords, 10), moments.half, LOOSEST))


def cluster(moments: Moments, candidates: Sequence[int], alike: float) -> Orbits:
    """Group candidates that are alike, or each other's mirror image."""
    from scipy.cluster.hierarchy import fcluster, linkage
    from scipy.spatial.distance import squareform

    at = np.asarray(candidates)
    floor = askew(moments)
    own = moments.own[np.ix_(at, at)].astype(float)
    mirror = straight(moments.mirror[np.ix_(at, at)].astype(float), floor)
    either = np.minimum(own, mirror)
    np.fill_diagonal(either, 0.0)
    if len(at) == 1:
        label = np.array([1])
        heights = np.zeros(0)
    else:
        tree = linkage(squareform(either, checks=False), method="average")
        label = fcluster(tree, alike, criterion="distance")
        heights = tree[:, 2]
    order = sorted(set(label.tolist()), key=lambda one: int(np.flatnonzero(label == one)[0]))
    members, symmetric, sides = [], [], []
    for one in order:
        inside = np.flatnonzero(label == one)
        lop = float(np.median(mirror[inside, inside]))
        members.append(at[inside])
        symmetric.append(lop < alike)
        near = own[inside[0], inside] <= mirror[inside[0], inside]
        sides.append(np.where(near, 1, -1) if not symmetric[-1] else np.ones(len(inside), dtype=int))
    within = max([h for h in heights if h <= alike], default=0.0)
    between = min([h for h in heights if h > alike], default=2 * alike)
    return Orbits(
        tuple(members), tuple(symmetric), tuple(sides), alike, float(np.clip(1.0 - within / between, 0, 1))
    )
