"""Cycling: where a movement goes round without a halt, the state is a convention, told by the first full cycle."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.moments import Moments

SHORTEST_S = 0.25  # of a cycle, or of half of one
QUARTERS = 4  # moments of the first cycle that have to return as well
STEADY = 1.6  # by which cycles that follow one another may differ in length
ROUND = 0.4  # of how far a cycle leads: what is nearer has returned


class Cycle(NamedTuple):
    """A movement that goes round."""

    state: int
    """The moment that stands for its state."""
    extent: float
    """How far it leads, radians."""


def cycles(moments: Moments, mirror: np.ndarray, halts: Sequence[int], start: int, stop: int) -> list[Cycle]:
    """Find the first cycle in each stretch between halts of a recording in which the body goes round more than once."""
    found = []
    own = moments.own[start:stop, start:stop]
    either = np.minimum(own, mirror[start:stop, start:stop])
    lop = np.diagonal(mirror)[start:stop]
    borders = [0, *(halt - start for halt in halts), stop - start]
    for first, last in pairwise(borders):
        span = _first_cycle(own[first:last, first:last], either[first:last, first:last], moments)
        if span is None:
            continue
        a, b = first + span[0], first + span[1]
        extent = float(own[a, a : b + 1].max())
        # a cycle that is lopsided is told best where it is most so
        lopsided = lop[a:b].max() > ROUND * extent
        found.append(Cycle(start + (a + int(lop[a:b].argmax()) if lopsided else a), extent))
    return found


def _first_cycle(own: np.ndarray, either: np.ndarray, moments: Moments) -> tuple[int, int] | None:
    """Begin and end of the first cycle, or half cycle of what is its own mirror image half a cycle later."""
    count = len(own)
    shortest = max(2, round(SHORTEST_S * moments.rate))
    for begin in range(0, count - 2 * shortest):
        period = _return(own, either, begin, moments.half)
        if period is None or period < shortest:
            continue
        later = [
            _return(own, either, begin + k * period // QUARTERS, moments.half) for k in range(1, QUARTERS + 1)
        ]
        if all(p is not None and period / STEADY <= p <= period * STEADY for p in later[:-1]):
            return begin, begin + period
    return None


def _return(own: np.ndarray, either: np.ndarray, begin: int, half: float) -> int | None:
    """After how many moments the body, or its image, is first back where it was."""
    away, near = own[begin, begin:], either[begin, begin:]
    farthest = np.maximum.accumulate(away)
    back = np.flatnonzero((near < ROUND * farthest) & (farthest > 1.5 * half))
    if not back.size:
        return None
    first = int(back[0])
    last = first
    while last + 1 < len(near) and near[last + 1] < ROUND * farthest[last + 1]:
        last += 1
    return first + int(near[first : last + 1].argmin())
