"""Visiting: every time that a state, or its mirror image, is held, turned at or passed."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.moments import Moments
from leitmotion.discovery.states import Orbits, askew, straight

# reach of a state: between these shares of what is alike, and so many times as far as its members are apart
CLOSEST, PASSED, SPREAD = 0.25, 0.7, 2.5
HELD, AS_EVER = 0.35, 0.2  # of what is alike: as near is held, or as little farther than ever during a visit


class Stop(NamedTuple):
    """A visit of a state, moments."""

    orbit: int
    """Which state, be it itself or its mirror image."""
    side: int
    """0 of a symmetric state, 1 as the first that was seen, -1 as its mirror image."""
    start: int
    stop: int
    told: bool = True
    """Whether the body halted or turned there, or goes round by it; else it only passed."""


class _Node(NamedTuple):
    """A state or its mirror image, as moments see it."""

    orbit: int
    side: int
    alike: float
    """The angle within which a moment is in the state."""
    away: np.ndarray
    """(N,) how far each moment is, as a share of that."""
    reach: float
    """How near a moment has to come that only passes."""
    members: np.ndarray
    """Moments at which the body halts there, turns, or begins a cycle."""
    goes_round: bool
    """Whether a movement goes round by it without a halt, so that each passing tells as much as another."""


def visits(moments: Moments, orbits: Orbits) -> list[list[Stop]]:
    """Find each visit of each state, stretch by stretch, in order.

    Parameters
    ----------
    moments : Moments
        All recordings.
    orbits : Orbits
        The states, by their members. A member is a visit; so is a moment that comes about as near as the members are
        to one another.

    Returns
    -------
    list of list of Stop
        Visits of a stretch, which do not overlap. What never left a state between two is one visit.
    """
    nodes = _nodes(moments, orbits)
    return [_row(nodes, moments, int(start), int(stop)) for start, stop in pairwise(moments.starts)]


def _nodes(moments: Moments, orbits: Orbits) -> list[_Node]:
    floor = askew(moments)
    nodes = []
    for orbit, (members, sides, alike) in enumerate(
        zip(orbits.members, orbits.sides, orbits.alike, strict=True)
    ):
        for side in (1, -1) if sides.any() else (0,):
            own = sides == side
            image = straight(moments.mirror[members], floor)
            rows = np.where(own[:, None], moments.own[members], image) / alike
            near, reach = np.median(rows, axis=0), _reach(rows[:, members], own)
            nodes.append(_Node(orbit, side, alike, near, reach, members[own], orbits.goes_round[orbit]))
    return nodes


def _reach(apart: np.ndarray, own: np.ndarray) -> float:
    """How near is near enough: about as near as the members are to one another, where there are several."""
    if len(apart) < 2:
        return PASSED
    between = apart[:, own] if own.any() else apart
    between = between[between > 0.0]
    return float(np.clip(SPREAD * np.median(between), CLOSEST, PASSED)) if between.size else PASSED


def _row(nodes: list[_Node], moments: Moments, start: int, stop: int) -> list[Stop]:
    """The visits of a stretch."""
    away = np.stack([node.away[start:stop] for node in nodes])
    nearest = away.argmin(axis=0)
    inside = away.min(axis=0) < np.array([node.reach for node in nodes])[nearest]
    told = np.full(stop - start, -1)
    own = moments.own[start:stop, start:stop]
    closest = np.full(stop - start, np.inf)
    for k, node in enumerate(nodes):
        here = node.members[(node.members >= start) & (node.members < stop)] - start
        told[here] = k
        for (
            member
        ) in here.tolist():  # while the body keeps still it is at one state, be it near to others as well
            still = _still(own[member] / node.alike, member)
            still = still[own[member, still] < closest[still]]
            closest[still], nearest[still], inside[still] = own[member, still], k, True
    stops: list[Stop] = []
    runs = _runs(away, nearest, inside)
    for k, (which, first, last) in enumerate(runs):
        after = runs[k + 1][1] if k + 1 < len(runs) else stop - start
        before = stops[-1].stop - start if stops else 0
        begin, end = _held(away[which], before, first, last, after)
        halted = nodes[which].goes_round or bool((told[first : last + 1] == which).any())
        stops.append(Stop(nodes[which].orbit, nodes[which].side, start + begin, start + end, halted))
    return stops


def _still(away: np.ndarray, member: int) -> np.ndarray:
    """Moments around one in which the body is held there."""
    far = away > HELD
    before, after = np.flatnonzero(far[:member]), np.flatnonzero(far[member:])
    return np.arange(
        int(before[-1]) + 1 if before.size else 0, member + int(after[0]) if after.size else len(away)
    )


def _runs(away: np.ndarray, nearest: np.ndarray, inside: np.ndarray) -> list[tuple[int, int, int]]:
    """Runs of moments at one state: which, the first and the last; those between which it was not left are one."""
    runs: list[tuple[int, int, int]] = []
    for t in np.flatnonzero(inside).tolist():
        which = int(nearest[t])
        since = runs[-1][2] if runs and runs[-1][0] == which else None
        if since is not None and (t == since + 1 or away[which, since : t + 1].max() < 1.0):
            runs[-1] = (which, runs[-1][1], t)
        else:
            runs.append((which, t, t))
    return runs


def _held(away: np.ndarray, before: int, first: int, last: int, after: int) -> tuple[int, int]:
    """How long a state is held around a run [first, last]: as long as it is about as near as ever."""
    limit = max(away[first : last + 1].min() + AS_EVER, HELD)
    near = first + np.flatnonzero(away[first : last + 1] <= limit)
    begin, end = int(near[0]), int(near[-1]) + 1
    while begin > before and away[begin - 1] <= limit:
        begin -= 1
    while end < after and away[end] <= limit:
        end += 1
    return begin, end
