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

INSIDE = 0.8  # of both stretches, that lie in one form: their likeness is the form's
TOLD = 0.5  # of a later stretch, that was told already
SAME_STATE = 0.6  # of what is alike, within which a posture has come back
LEFT = 2.0  # of what is alike, beyond which it had been left


class Pair(NamedTuple):
    """Two stretches, first and last waypoint of each."""

    earlier: tuple[int, int]
    later: tuple[int, int]
    cost: float
    """Mean distance of the two, over what is alike."""


def pairs_of_paths(signals: Sequence[Signal], forms: Sequence[Form]) -> list[Pair]:
    """Tell the paths that come back, each later stretch with the earlier one that it is like for the longest.

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
    found: list[Pair] = []
    told: set[int] = set()
    for signal in signals:
        earlier, later = signal.earlier, signal.later
        stretch = set(range(later[0], later[1] + 1))
        if (
            signal.extent < LEAST_EXTENT
            or later[0] <= earlier[1]
            or any(_inside(earlier, form) and _inside(later, form) for form in forms)
            or len(stretch & told) > TOLD * len(stretch)
        ):
            continue
        told |= stretch
        found.append(Pair(earlier, later, signal.cost))
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
        lies in one for the greater part.
    """
    near = apart / np.minimum.outer(waypoints.alike, waypoints.alike)
    back = []
    for j in range(len(near)):
        left = np.flatnonzero(waypoints.own[j, :j] > LEFT * waypoints.alike[j])
        before = np.flatnonzero(near[: left[-1], j] < SAME_STATE) if left.size else left
        if before.size:
            i = before[-1] - int(np.argmin(near[max(before[-1] - 3, 0) : before[-1] + 1, j][::-1]))
            back.append((j - i, float(near[i, j]), i, j))
    found: list[Pair] = []
    for way, cost, i, j in sorted(back):
        whole = (i, j)
        if not any(
            _shared(whole, (form.first, form.last)) > TOLD * min(way, form.last - form.first)
            for form in forms
        ) and all(_shared(whole, (pair.earlier[0], pair.later[0])) == 0 for pair in found):
            found.append(Pair((i, i), (j, j), cost))
    return found


def _shared(one: tuple[int, int], other: tuple[int, int]) -> int:
    return max(min(one[1], other[1]) - max(one[0], other[0]), 0)


def _inside(stretch: tuple[int, int], form: Form) -> bool:
    return _shared(stretch, (form.first, form.last)) >= INSIDE * (stretch[1] - stretch[0])
