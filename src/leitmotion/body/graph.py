"""Graph: the points of a body joined by bones, from a skeleton's tree or, without one, from distances that stay.

The graph is a tree without a direction: nothing in it says which end is up. Points that never part are one place.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.motion import Motion, Skeleton, Trajectories

STRETCH = 0.12  # of the body's extent: by how much a bone of a tree may stretch, 5th to 95th percentile
STIFF = 0.1  # of a distance: how far it may deviate and still be a bone between points
TOGETHER = 0.005  # of the body's extent: points that are never farther apart are one place
CHANGES = 2.0  # times the noise: a distance that deviates so much is taken for twice its length
FINEST, COARSEST = 1e-4, 0.02  # of the largest distance: noise of what has none, and of what has no bones
MOST = 200  # points: more are a cloud of markers
SEEN = 0.5  # of the moments in which a point must be seen


class Graph(NamedTuple):
    """Places joined by bones."""

    members: tuple[tuple[int, ...], ...]
    """For each place its points; in a skeleton those nearer to the root first, end sites behind the joints."""

    positions: np.ndarray
    """(M, N, 3) where each place is."""

    above: tuple[int, ...]
    """The place that each hangs on, -1 for the first; a place stands behind the one it hangs on."""

    lengths: np.ndarray
    """(N,) median length of the bone to `above`, 0 of the first."""

    def path(self, start: int, end: int) -> list[int]:
        """List the places from one to another, both included."""
        ups = [start]
        while self.above[ups[-1]] >= 0:
            ups.append(self.above[ups[-1]])
        downs = [end]
        while downs[-1] not in ups:
            downs.append(self.above[downs[-1]])
        return ups[: ups.index(downs[-1])] + downs[::-1]

    def leaves(self) -> list[int]:
        """List the places that are the end of one bone only."""
        degree = np.bincount([place for pair in self.bones() for place in pair], minlength=len(self.above))
        return [int(place) for place in np.flatnonzero(degree == 1)]

    def bones(self) -> list[tuple[int, int]]:
        """List the bones, upper end first."""
        return [(up, place) for place, up in enumerate(self.above) if up >= 0]


def graph_of(recording: Motion | Trajectories, positions: np.ndarray) -> Graph | None:
    """Join the points of a recording by bones.

    In a skeleton the bones are its own, without those that stretch: what hangs on a stretching bone (a target, a node
    that marks the place in the scene) is no part of the body. Its end sites are places, too. Of points those are
    joined whose distance stays the same, the shorter first, as a minimum spanning tree.

    Parameters
    ----------
    recording : Motion or Trajectories
        Whose points they are.
    positions : (M, P + K, 3) float
        Where they are at some moments, end sites last.

    Returns
    -------
    Graph or None
        The largest part that hangs together; None where that is no body (too few points, or far too many).
    """
    if positions.shape[2] != 3 or not 8 <= positions.shape[1] <= MOST or len(positions) == 0:
        return None
    rooted = isinstance(recording, Motion)
    often = np.isfinite(positions).all(axis=2).mean(axis=0) >= SEEN
    extent = _extent(positions[:, often])
    if not extent > 0:
        return None
    together = TOGETHER * extent
    if isinstance(recording, Motion):
        most = STRETCH * extent
        pairs = [pair for pair in _bones_of(recording.skeleton) if _stretch(positions, pair) <= most]
    else:
        pairs = _spanning_tree(positions, often)
    return _joined(positions, pairs, together, rooted)


def _bones_of(skeleton: Skeleton) -> list[tuple[int, int]]:
    joints = len(skeleton)
    pairs = [(int(up), joint) for joint, up in enumerate(skeleton.parents) if up >= 0]
    return pairs + [(int(up), joints + k) for k, up in enumerate(skeleton.end_parents)]


def _spanning_tree(positions: np.ndarray, kept: np.ndarray) -> list[tuple[int, int]]:
    """Join the points by the cheapest tree; a distance that changes is dear, by how much it does beyond the noise."""
    points = np.flatnonzero(kept)
    if len(points) < 2:
        return []
    apart = np.linalg.norm(positions[:, points, None] - positions[:, None, points], axis=3)
    seen = np.isfinite(apart)
    count = np.maximum(seen.sum(axis=0), 1)
    mean = np.where(seen, apart, 0.0).sum(axis=0) / count
    deviation = np.sqrt(np.where(seen, (apart - mean) ** 2, 0.0).sum(axis=0) / count)
    others = deviation + np.where(np.eye(len(points), dtype=bool), np.inf, 0.0)
    noise = float(np.median(others.min(axis=1))) + FINEST * float(mean.max())
    if noise > COARSEST * float(mean.max()):
        return []
    cost = np.where(seen.any(axis=0), mean * (1.0 + (deviation / noise / CHANGES) ** 2), np.inf)
    nearest, price = np.zeros(len(points), dtype=int), cost[0].copy()
    joined = np.zeros(len(points), dtype=bool)
    joined[0] = True
    pairs = []
    for _ in range(len(points) - 1):
        new = int(np.where(joined, np.inf, price).argmin())
        if deviation[nearest[new], new] <= max(STIFF * mean[nearest[new], new], CHANGES**2 * noise):
            pairs.append((int(points[nearest[new]]), int(points[new])))
        joined[new] = True
        closer = cost[new] < price
        nearest[closer], price = new, np.minimum(price, cost[new])
    return pairs


def _stretch(positions: np.ndarray, pair: tuple[int, int]) -> float:
    """How far the length of a bone usually changes."""
    length = np.linalg.norm(positions[:, pair[0]] - positions[:, pair[1]], axis=1)
    low, high = np.percentile(length, (5, 95))
    return float(high - low)


def _joined(
    positions: np.ndarray, pairs: Sequence[tuple[int, int]], together: float, rooted: bool
) -> Graph | None:
    """Put coinciding points together and take the largest part, without a root that only marks a place."""
    beside: dict[int, list[int]] = {}
    for a, b in pairs:
        beside.setdefault(a, []).append(b)
        beside.setdefault(b, []).append(a)
    best: list[tuple[int, int]] = []
    waiting = sorted(beside)
    seen: set[int] = set()
    for start in waiting:
        if start in seen:
            continue
        order, seen = [(-1, start)], seen | {start}
        for _, point in order:  # the list grows while it is walked
            for other in beside[point]:
                if other not in seen:
                    seen.add(other)
                    order.append((point, other))
        if len(order) > len(best):
            best = order
    while rooted and len(best) > 1 and sum(up == best[0][1] for up, _ in best) == 1:
        best = [(-1, best[1][1]), *best[2:]]
    members: list[list[int]] = []
    above: list[int] = []
    lengths: list[float] = []
    place: dict[int, int] = {}
    for up, point in best:
        length = 0.0
        if up >= 0:
            gap = np.linalg.norm(positions[:, up] - positions[:, point], axis=1)
            length = float(np.nanmedian(gap))
            if np.nanmax(gap) <= together:
                place[point] = place[up]
                members[place[up]].append(point)
                continue
        place[point] = len(members)
        members.append([point])
        above.append(place[up] if up >= 0 else -1)
        lengths.append(length)
    if len(members) < 8:
        return None
    return Graph(
        tuple(tuple(those) for those in members),
        positions[:, [those[0] for those in members]],
        tuple(above),
        np.array(lengths),
    )


def _extent(positions: np.ndarray) -> float:
    """How large a body usually is along its longest axis, but for the few points farthest out: they may be no part."""
    whole = positions[np.isfinite(positions).all(axis=(1, 2))]
    if not whole.size:
        return 0.0
    low, high = np.percentile(whole, (5, 95), axis=1)
    return float(np.median((high - low).max(axis=1)))
