"""States: candidates that are the same posture, or each other's mirror image.

How near is the same is told by how far the movement leads: a halt is alike to others within half of the way to the next
halt, be it a small wave or a jump with both arms.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.moments import Moments

RETURNED = (
    0.6  # of the farthest way between: two halts nearer than that are a return, others are two postures
)
ALIKE = 0.5  # of the way to another posture, within which a halt is the same
ROUND = 0.4  # of how far a cycle leads that halts nowhere
APART = 1.5  # times what is half alike, from which on two postures are apart
LOOSEST = np.radians(16.0)  # beyond which postures are not alike, as of likeness in Z
ASKEW = np.radians(8.0)  # lopsidedness that may be how a suit sits


class Orbits(NamedTuple):
    """States up to reflection."""

    members: tuple[np.ndarray, ...]
    """Moments of each."""
    sides: tuple[np.ndarray, ...]
    """1 or -1 for each member, as it is the state or its mirror image; 0 where that is one."""
    alike: tuple[float, ...]
    """The angle within which a moment is in the state."""
    goes_round: tuple[bool, ...]
    """Whether a movement goes round by it without a halt."""
    confidence: float
    """0 where two states are as near as the members of one, 1 where members do not differ."""


def askew(moments: Moments) -> float:
    """How lopsided the most symmetric moment is, radians; 0 where that is more than how a suit may sit."""
    least = float(np.percentile(np.diagonal(moments.mirror), 1))
    return least if least < ASKEW else 0.0


def straight(angle: np.ndarray, floor: float) -> np.ndarray:
    """Take from an angle to a mirror image what is how a suit sits."""
    return np.sqrt(np.maximum(np.square(angle) - floor**2, 0.0))


def alike_within(moments: Moments, candidates: Sequence[int], extents: Mapping[int, float]) -> np.ndarray:
    """Tell of each candidate within which angle another is the same posture.

    Parameters
    ----------
    moments : Moments
        All recordings.
    candidates : sequence of int
        Moments, in order.
    extents : mapping of int to float
        Of those by which a movement goes round without a halt, how far it leads.

    Returns
    -------
    (C,) float
        Radians: what is half alike at least, 20 degrees at most.
    """
    least = np.full(len(candidates), np.inf)
    for start, stop in pairwise(moments.starts.tolist()):
        here = [k for k, moment in enumerate(candidates) if start <= moment < stop]
        for one, other in pairwise(here):
            a, b = candidates[one], candidates[other]
            chord, way = float(moments.own[a, b]), float(moments.own[a, a : b + 1].max())
            far = chord if chord > RETURNED * way else way
            if far > APART * moments.half:
                least[[one, other]] = np.minimum(least[[one, other]], ALIKE * far)
    for k, moment in enumerate(candidates):
        if moment in extents:
            least[k] = min(least[k], ROUND * extents[moment])
    least[np.isinf(least)] = np.min(least) if np.isfinite(least).any() else moments.half
    return np.clip(least, moments.half, max(LOOSEST, moments.half))


def cluster(moments: Moments, candidates: Sequence[int], alike: np.ndarray, round_: Container[int]) -> Orbits:
    """Group candidates that are alike, or each other's mirror image.

    Parameters
    ----------
    moments : Moments
        All recordings.
    candidates : sequence of int
        Moments, in order.
    alike : (C,) float
        What :func:`alike_within` tells of them; of two the lesser counts.
    round_ : container of int
        Candidates by which a movement goes round without a halt.

    Returns
    -------
    Orbits
        In the order of their first members.
    """
    from scipy.cluster.hierarchy import fcluster, linkage
    from scipy.spatial.distance import squareform

    at = np.asarray(candidates)
    own = moments.own[np.ix_(at, at)].astype(float)
    mirror = straight(moments.mirror[np.ix_(at, at)].astype(float), askew(moments))
    either = np.minimum(own, mirror) / np.minimum.outer(alike, alike)
    np.fill_diagonal(either, 0.0)
    heights, label = np.zeros(0), np.ones(1, dtype=int)
    if len(at) > 1:
        tree = linkage(squareform(either, checks=False), method="average")
        heights, label = tree[:, 2], fcluster(tree, 1.0, criterion="distance")
    members, sides, within = [], [], []
    for one in dict.fromkeys(label.tolist()):
        inside = np.flatnonzero(label == one)
        within.append(float(np.median(alike[inside])))
        members.append(at[inside])
        symmetric = np.median(mirror[inside, inside]) < within[-1]
        near = own[inside[0], inside] <= mirror[inside[0], inside]
        sides.append(np.zeros(len(inside), dtype=int) if symmetric else np.where(near, 1, -1))
    inner, outer = heights[heights <= 1.0], heights[heights > 1.0]
    confidence = 1.0 - float(inner.max(initial=0.0)) / float(outer.min(initial=2.0))
    goes_round = tuple(any(moment in round_ for moment in held.tolist()) for held in members)
    return Orbits(
        tuple(members), tuple(sides), tuple(within), goes_round, float(np.clip(confidence, 0.0, 1.0))
    )
