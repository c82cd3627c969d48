"""Waypoints: a recording told by the moments at which the body has moved on, whatever its tempo.

Conventions
-----------
Angles are radians of a mean link. A body that keeps still makes no waypoint, one that moves slowly few a second; so
two performances of one movement have about as many, and stillness makes no likeness.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.discovery.sides import antisymmetric, without_lasting
from leitmotion.similarity import DoubleMetric
from leitmotion.similarity.mirror import MOST

STEP = 0.2  # of the angle of half likeness, between one waypoint and the next
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
    """(K, K) float32 angle of each to the mirror image of each, without what the sides differ by for long."""
    products: np.ndarray
    """(K, K) inner products of the antisymmetric parts (:func:`leitmotion.discovery.sides.antisymmetric`)."""
    end: int
    """The moment after the last that was seen."""
    alike: np.ndarray
    """(K,) float32 angle within which the posture is alike to another: a share of what the movement around it spans."""

    def left(self, k: int) -> int:
        """The last moment before the body has moved on from a waypoint."""
        return (int(self.at[k + 1]) if k + 1 < len(self.at) else self.end) - 1

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
    own, mirror = (angles(each[grid], found.metric) for each in (found.own, found.mirror))
    products = antisymmetric(own.astype(np.float64), mirror)
    way = np.concatenate(([0.0], np.cumsum(np.diagonal(own, 1))))[: len(at)]
    since = np.searchsorted(way, way - REACH)
    until = np.searchsorted(way, way + REACH, side="right")
    mirror = without_lasting(own, products, since, until)
    seen = np.flatnonzero(~np.isnan(np.diagonal(found.own)))
    end = int(seen[-1]) + 1 if seen.size else 0
    return Waypoints(at, own, mirror, products, end, _alike(own, since, until))


def angles(distances: np.ndarray, metric: str) -> np.ndarray:
    """Turn distances (...) into angles of a mean link, radians; moments that share no link are as far as can be."""
    turned = distances if metric == "geodesic" else 2 * np.arccos(np.clip(1 - distances, -1, 1))
    return np.nan_to_num(turned, nan=np.pi)


def _distance(angle: float, metric: str) -> float:
    return angle if metric == "geodesic" else 1.0 - float(np.cos(angle / 2.0))


def _alike(own: np.ndarray, since: np.ndarray, until: np.ndarray) -> np.ndarray:
    """A share of what the movement spans before and after each waypoint."""
    count = len(own)
    spans = np.array(
        [(np.max(own[k, since[k] : k + 1]), np.max(own[k, k : until[k]])) for k in range(count)],
        dtype=np.float32,
    ).reshape(count, 2)
    spans[since == 0, 0] = spans[since == 0].max(axis=1, initial=0)
    spans[until == count, 1] = spans[until == count].max(axis=1, initial=0)
    alike: np.ndarray = np.clip(ALIKE_SHARE * spans.mean(axis=1), LEAST, MOST)
    return alike


def _first(row: np.ndarray, k: int, half: float) -> int:
    far = np.flatnonzero(~(row[k:] < half))
    return k + int(far[0]) if far.size else len(row)
