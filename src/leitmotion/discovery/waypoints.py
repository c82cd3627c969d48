"""Waypoints: a recording told by the moments at which the body has moved on, whatever its tempo.

Conventions
-----------
Angles are radians of a mean link. A body that keeps still makes no waypoint, one that moves slowly few a second; so
two performances of one movement have about as many, and stillness makes no likeness.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.similarity import DoubleMetric
from leitmotion.similarity.mirror import MOST

STEP = 0.2  # of the angle of half likeness, between one waypoint and the next
LARGEST_FLOOR = np.radians(8.0)  # by which both sides may differ throughout, of a mean link
FLOOR_SHARE = 0.25  # quantile over the moments, of how near each comes to the mirror image of any
LEAST = np.radians(6.5)  # what is alike at least, of a mean link
REACH = np.radians(60.0)  # of way before and after, within which what a movement spans is told
ALIKE_SHARE = 0.36  # of that extent, within which two moments are alike


class Waypoints(NamedTuple):
    """K waypoints of T moments."""

    at: np.ndarray
    """(K,) moments."""
    own: np.ndarray
    """(K, K) float32 angle of each to each."""
    mirror: np.ndarray
    """(K, K) float32 angle of each to the mirror image of each, less the floor."""
    alike: np.ndarray
    """(K,) float32 angle within which the posture is alike to another: a share of what the movement around it spans."""
    floor: float
    """What the two sides differ by throughout."""

    def left(self, k: int) -> int:
        """The last moment before the body has moved on from a waypoint."""
        return int(self.at[k + 1]) - 1 if k + 1 < len(self.at) else int(self.at[k])

    def stretch(self, first: int, last: int) -> tuple[int, int]:
        """Moments of a way from a waypoint to another, or of the stay at one."""
        if first == last:
            return int(self.at[first]), self.left(first) + 1
        return self.left(first), int(self.at[last]) + 1

    @property
    def first_far(self) -> np.ndarray:
        """(K,) the first later waypoint that is not half alike; K where there is none."""
        return np.array([_first(row, k, self.alike[k]) for k, row in enumerate(self.own)], dtype=np.int64)


def find_waypoints(found: DoubleMetric) -> Waypoints:
    """Choose the waypoints of a recording.

    Parameters
    ----------
    found : DoubleMetric
        T moments.

    Returns
    -------
    Waypoints
        Each differs from the one before by a fifth of the angle of half likeness, or by more where the body moves
        faster than that from one moment to the next.
    """
    from leitmotion.discovery import _signal_kernels as kernels

    half = found.half_angle
    step = half * STEP
    at = kernels.waypoints(found.own, np.float32(_distance(step, found.metric)))
    grid = np.ix_(at, at)
    own, mirror = (_angles(each[grid], found.metric) for each in (found.own, found.mirror))
    floor = _floor(mirror)
    mirror = np.sqrt(np.maximum(mirror**2 - np.float32(floor) ** 2, 0))
    return Waypoints(at, own, mirror, _alike(own), floor)


def _angles(distances: np.ndarray, metric: str) -> np.ndarray:
    if metric == "geodesic":
        return distances
    turned: np.ndarray = 2 * np.arccos(np.clip(1 - distances, -1, 1))
    return turned


def _distance(angle: float, metric: str) -> float:
    return angle if metric == "geodesic" else 1.0 - float(np.cos(angle / 2.0))


def _floor(mirror: np.ndarray) -> float:
    """How near the body comes to its mirror image, at most: what is left is a bias of the sides, or noise."""
    if not mirror.size:
        return 0.0
    nearest = np.nanmin(np.where(np.isfinite(mirror), mirror, np.pi), axis=1)
    return float(min(np.quantile(nearest, FLOOR_SHARE), LARGEST_FLOOR))


def _alike(own: np.ndarray) -> np.ndarray:
    """A share of what the movement spans before or after each waypoint, the lesser: what borders on it is not it."""
    count = len(own)
    way = np.concatenate(([0.0], np.cumsum(np.nan_to_num(np.diagonal(own, 1)))))
    since = np.searchsorted(way, way - REACH)
    until = np.searchsorted(way, way + REACH, side="right")
    spans = np.array(
        [(np.nanmax(own[k, since[k] : k + 1]), np.nanmax(own[k, k : until[k]])) for k in range(count)],
        dtype=np.float32,
    ).reshape(count, 2)
    spans[since == 0, 0] = spans[since == 0].max(axis=1, initial=0)
    spans[until == count, 1] = spans[until == count].max(axis=1, initial=0)
    alike: np.ndarray = np.clip(ALIKE_SHARE * spans.mean(axis=1), LEAST, MOST)
    return alike


def _first(row: np.ndarray, k: int, half: float) -> int:
    far = np.flatnonzero(~(row[k:] < half))
    return k + int(far[0]) if far.size else len(row)
