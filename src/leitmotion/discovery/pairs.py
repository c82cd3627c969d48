"""Pairs of stretches: what comes back later, as it was, back in time, or as its mirror image.

References
----------
Paper S, sections 3.2.2 to 3.2.4, 3.4.2 and 3.5.6.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.forms import LEAST_EXTENT, Form
from leitmotion.discovery.signals import Signal
from leitmotion.discovery.waypoints import Waypoints

INSIDE = 0.6  # of both stretches, that lie in one form: their likeness is the form's
OVERLAP = 0.1  # of a stretch, up to which two that follow one another may overlap
PART = 1.5  # cycles of a form, up to which likeness within it is not the form's own
LONG = 3.0  # times as long as a loop a cycle is, of which the loop is a part of its own
AS_GOOD = 0.8  # of the gain of the best, with which a nearer pair is told instead
TOLD = 0.5  # of a later stretch, that was told already
TWICE = 3  # marks of two cycles
NEARER = 2.0  # ways: so much longer a loop may be that ends at no distance, not at that of what is alike
SAME_STATE = 0.75  # of what is alike, within which a posture has come back
LEFT = 2.0  # of what is alike, beyond which it had been left


class Pair(NamedTuple):
    """Two stretches, first and last waypoint of each."""

    earlier: tuple[int, int]
    later: tuple[int, int]
    cost: float
    """Mean distance of the two, over what is alike."""


def pairs_of_paths(signals: Sequence[Signal], forms: Sequence[Form]) -> list[Pair]:
    """Tell the paths that come back, each later stretch with one that it is like for about the longest, the nearest.

    Parameters
    ----------
    signals : sequence of Signal
        Of one kind, the best first.
    forms : sequence of Form
        Runs within which likeness is the run's own.

    Returns
    -------
    list of Pair
        Of two stretches that do not overlap.
    """
    apart = [
        signal
        for signal in signals
        if signal.extent >= LEAST_EXTENT
        and _shared(signal.earlier, signal.later) <= OVERLAP * _length(signal.later)
        and not any(_explains(form, signal) for form in forms)
    ]
    found: list[Pair] = []
    for best in apart:
        if sum(_shared(pair.later, best.later) for pair in found) > TOLD * _length(best.later):
            continue
        like = [
            signal
            for signal in apart
            if _gain(signal) >= AS_GOOD * _gain(best)
            and _shared(signal.later, best.later) >= AS_GOOD * _length(best.later)
        ]
        nearest = max(like, key=lambda signal: signal.earlier[1])
        found.append(Pair(nearest.earlier, nearest.later, nearest.cost))
    return found


def loops(apart: np.ndarray, waypoints: Waypoints, forms: Sequence[Form]) -> list[Pair]:
    """Tell where the body is back in a posture, or in its mirror image, after it had left it.

    Parameters
    ----------
    apart : (K, K) float
        Angles in D, or in D*.
    waypoints : Waypoints
        K waypoints.
    forms : sequence of Form
        Runs that tell of their states themselves.

    Returns
    -------
    list of Pair
        The posture and its return, a waypoint each, the shortest way between first; ways do not overlap, and no form
        of shorter ways shares one for the greater part.
    """
    near = apart / np.minimum.outer(waypoints.alike, waypoints.alike)
    columns = np.ascontiguousarray(near.T)
    back = []
    for j in range(len(near)):
        left = np.flatnonzero(waypoints.own[j, :j] > LEFT * waypoints.alike[j])
        before = np.flatnonzero(columns[j, : left[-1]] < SAME_STATE) if left.size else left
        if before.size:
            i, j = _nearest(near, int(before[-1]), j)
            back.append((int((j - i) * (1 + NEARER * near[i, j])), float(near[i, j]), i, j))
    found: list[Pair] = []
    for _, cost, i, j in sorted(back):
        whole, way = (i, j), j - i
        if not any(
            _shared(whole, (form.first, form.last)) > TOLD * min(way, form.last - form.first)
            for form in forms
            if form.reversed or form.way <= LONG * way
        ) and all(_shared(whole, (pair.earlier[0], pair.later[0])) == 0 for pair in found):
            found.append(Pair((i, i), (j, j), cost))
    return found


def _nearest(near: np.ndarray, i: int, j: int) -> tuple[int, int]:
    """Go on outwards, to where both postures are nearest."""
    while True:
        ways = [(a, b) for a, b in ((i - 1, j), (i, j + 1), (i - 1, j + 1)) if a >= 0 and b < len(near)]
        best = min(ways, key=lambda way: near[way], default=(i, j))
        if near[best] >= near[i, j]:
            return i, j
        i, j = best


def _shared(one: tuple[int, int], other: tuple[int, int]) -> int:
    return max(min(one[1], other[1]) - max(one[0], other[0]), 0)


def _length(stretch: tuple[int, int]) -> int:
    return stretch[1] - stretch[0]


def _gain(signal: Signal) -> float:
    return len(signal.path) * (1 - signal.cost)


def _explains(form: Form, signal: Signal) -> bool:
    """Whether a form tells the likeness of two stretches itself: not of parts of a cycle, nor of two cycles in all."""
    inside = _inside(signal.earlier, form) and _inside(signal.later, form)
    twice = not (form.mirror or form.reversed) and len(form.marks) == TWICE
    whole = signal.later[1] - signal.earlier[0]
    return inside and whole > PART * form.way and not (twice and not signal.reversed)


def _inside(stretch: tuple[int, int], form: Form) -> bool:
    return _shared(stretch, (form.first, form.last)) >= INSIDE * (stretch[1] - stretch[0])
