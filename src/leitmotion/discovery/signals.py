"""Proximity signals: stretches in which a movement goes where it went before, itself or its mirror image, or back.

Conventions
-----------
Paths run over waypoints (:mod:`leitmotion.discovery.waypoints`), earlier first. A *forward* signal runs along the
identity axis, a *reversed* one across it, towards it.

References
----------
Paper S, sections 3.2.3, 3.2.4 and 3.4: what makes a signal parallel to the identity axis, and one perpendicular to it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.discovery.waypoints import Waypoints

CEILING = 8.0  # waypoints that a path can lose before it ends, whatever it gained
LEAST_GAIN = 1.5  # of a signal, in waypoints that are the same
BEST = 0.25  # quantile of the cost of a path
LOOSE, LOOSEST = 3.0, 0.7  # times that, but no less, at which it gains nothing
PARTED = 1.6  # of what is alike, that two ways may go from a rest before they part
REST = 3.0  # times as long as at other waypoints the body stays where it rests
MEETS = 2  # waypoints apart at most a reversed path meets the identity axis
BAND = 3  # waypoints beside a signal in which no other runs


class Signal(NamedTuple):
    """A traced path of likeness."""

    path: np.ndarray
    """(N, 2) int waypoints: the earlier stretch rises; the later one rises, or falls where it is reversed."""
    mirror: bool
    """Whether the later stretch is like the mirror image."""
    reversed: bool
    """Whether it runs back in time."""
    cost: float
    """Mean angle along the path, over the angle of half likeness."""
    extent: float
    """How far from each other the postures are that the lesser stretch goes through, over that angle."""

    @property
    def earlier(self) -> tuple[int, int]:
        """First and last waypoint of the earlier stretch."""
        return int(self.path[0, 0]), int(self.path[-1, 0])

    @property
    def later(self) -> tuple[int, int]:
        """First and last waypoint of the later stretch."""
        one, other = int(self.path[0, 1]), int(self.path[-1, 1])
        return min(one, other), max(one, other)


def find_signals(waypoints: Waypoints, *, mirror: bool, reverse: bool) -> list[Signal]:
    """Trace the signals of one kind.

    Parameters
    ----------
    waypoints : Waypoints
        K waypoints.
    mirror : bool
        In D*, else in D.
    reverse : bool
        Across the identity axis, else along it.

    Returns
    -------
    list of Signal
        The one that gains most first. None runs within a band of another; none along the identity axis.
    """
    from leitmotion.discovery import _signal_kernels as kernels

    apart = waypoints.mirror if mirror else waypoints.own
    apart = apart / np.minimum.outer(waypoints.alike, waypoints.alike)
    count = len(apart)
    lower, upper = np.zeros(count, np.int64), np.full(count, count, np.int64)
    if reverse:
        apart, upper = np.ascontiguousarray(apart[:, ::-1]), np.arange(count - 1, -1, -1)
    else:
        lower = waypoints.first_far
    H, S = np.zeros((2, count, count), np.float32)
    how = np.zeros((count, count), np.uint8)
    kernels.align(apart, lower, upper, np.float32(CEILING), H, S, how)
    rows, columns = kernels.ends(S, np.float32(LEAST_GAIN))
    taken = np.zeros((count, count), bool)
    path = np.empty((2 * count, 2), np.int64)
    found = []
    for k in np.argsort(-S[rows, columns], kind="stable"):
        length = kernels.trace(how, taken, rows[k], columns[k], path)
        traced = path[:length][::-1]
        gain = float((1 - apart[traced[:, 0], traced[:, 1]]).sum()) if length else 0.0
        if gain <= LEAST_GAIN:
            continue
        kernels.take(taken, traced, BAND)
        traced = _trimmed(traced, apart)
        if not len(traced):
            continue
        cells = traced.copy()
        if reverse:
            cells[:, 1] = count - 1 - cells[:, 1]
        kept = _between_rests(cells, waypoints)
        traced, cells = traced[kept], cells[kept]
        cost = float(apart[traced[:, 0], traced[:, 1]].mean())
        if cost >= 1:  # what lies between the rests is not alike
            continue
        found.append(Signal(cells, mirror, reverse, cost, _extent(cells, waypoints)))
    return found


def _trimmed(path: np.ndarray, apart: np.ndarray) -> np.ndarray:
    """The part of a path in which it gains most by a measure as strict as its own best quarter.

    Past a posture that both reach, their ways go on being somewhat alike before they part.
    """
    cost = apart[path[:, 0], path[:, 1]]
    strict = min(max(LOOSE * float(np.quantile(cost, BEST)), LOOSEST), 1.0)
    summed = np.concatenate(([0.0], np.cumsum(np.maximum(1 - cost / strict, -1.0))))
    gained = summed - np.minimum.accumulate(summed)
    stop = int(np.argmax(gained))
    start = int(np.argmin(summed[: stop + 1]))
    return path[start:stop]


def _between_rests(path: np.ndarray, waypoints: Waypoints) -> slice:
    """Which part of a path lies between the rests at its ends, where it has such: a way goes from rest to rest.

    Both performances may be like each other beyond a rest for as far as postures are alike.
    """
    stays = np.diff(waypoints.at, append=waypoints.at[-1:] + 1)
    stay = stays[path[:, 0]] + stays[path[:, 1]]
    usual = float(np.median(stay))
    starts = [_innermost(path, stay, waypoints, usual)]
    if path[-1, 1] - path[-1, 0] > MEETS or path[0, 1] < path[-1, 1]:  # not the turn of a path that turns
        starts.append(_innermost(path[::-1], stay[::-1], waypoints, usual))
    return slice(starts[0], len(path) - (starts[1] if len(starts) > 1 else 0))


def _innermost(path: np.ndarray, stay: np.ndarray, waypoints: Waypoints, usual: float) -> int:
    """How many cells lie before the last of those, near the end of a path, in which the body stays."""
    near = (waypoints.own[path[0], path] <= PARTED * waypoints.alike[path[0]]).all(axis=1)
    reach = min(int(np.argmin(near)) if not near.all() else len(path), len(path) // 2)
    if reach < 1 or stay[:reach].max() < REST * usual:
        return 0
    return int(np.flatnonzero(stay[:reach] >= stay[:reach].max() / 2)[-1])


def _extent(path: np.ndarray, waypoints: Waypoints) -> float:
    """The largest distance within either stretch, the lesser of the two, over the angle of half likeness."""
    spans = []
    for column in path.T:
        start, stop = column.min(), column.max() + 1
        spans.append(
            float(np.max(waypoints.own[start:stop, start:stop]) / waypoints.alike[start:stop].mean())
        )
    return min(spans)
