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
# reach of a state: between these shares of what is alike, so many times as far as its visits are apart
CLOSEST, PASSED, SPREAD = 0.25, 0.7, 2.5
ASKEW = np.radians(8.0)  # lopsidedness that may be how a suit sits


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


def visits(moments: Moments, orbits: Orbits) -> list[list[Stop]]:
    """Find each time that a state is held or passed, recording by recording, in order."""
    floor = askew(moments)
    nodes = []
    for orbit, (members, symmetric, sides) in enumerate(
        zip(orbits.members, orbits.symmetric, orbits.sides, strict=True)
    ):
        for side in (0,) if symmetric else (1, -1):
            rows = np.stack(
                [
                    moments.own[member] if side in (0, same) else straight(moments.mirror[member], floor)
                    for member, same in zip(members, sides, strict=True)
                ]
            )
            nodes.append(_Node(orbit, side, np.median(rows, axis=0), _reach(rows[:, members], orbits.alike)))
    whose = {
        int(member): k
        for k, node in enumerate(nodes)
        for member, side in zip(orbits.members[node.orbit], orbits.sides[node.orbit], strict=True)
        if node.side in (0, side)
    }
    return [
        _passes(nodes, whose, int(start), int(stop), orbits.alike) for start, stop in pairwise(moments.starts)
    ]


class _Node(NamedTuple):
    orbit: int
    side: int
    away: np.ndarray
    """(N,) how far each moment is."""
    reach: float
    """How near a moment has to be that only passes."""


def _reach(apart: np.ndarray, alike: float) -> float:
    """How near a moment has to come to be a visit: about as near as the members are to one another."""
    if len(apart) < 2:
        return PASSED * alike
    usual = np.median(apart[~np.eye(len(apart), dtype=bool)])
    return float(np.clip(SPREAD * usual, CLOSEST * alike, PASSED * alike))


def _passes(nodes: list[_Node], whose: dict[int, int], start: int, stop: int, alike: float) -> list[Stop]:
    """Runs of moments nearest to one state and near it; of runs of one state that it never left, one."""
    away = np.stack([node.away[start:stop] for node in nodes])
    reach = np.array([node.reach for node in nodes])
    nearest = away.argmin(axis=0)
    inside = away.min(axis=0) < reach[nearest]
    for member, node in whose.items():
        if start <= member < stop:
            nearest[member - start], inside[member - start] = node, True
    runs: list[tuple[int, int, int]] = []
    for t in np.flatnonzero(inside):
        which = int(nearest[t])
        if runs and runs[-1][0] == which and away[which, runs[-1][2] : t + 1].max() < alike:
            runs[-1] = (which, runs[-1][1], int(t))
        else:
            runs.append((which, int(t), int(t)))
    stops = [_stop(nodes[which], away[which], start, runs, k, alike) for k, (which, _, _) in enumerate(runs)]
    return [
        one._replace(
            told=any(one.start <= member < one.stop for member, node in whose.items() if node == run[0])
        )
        for one, run in zip(stops, runs, strict=True)
    ]


def _stop(
    node: _Node, away: np.ndarray, start: int, runs: list[tuple[int, int, int]], k: int, alike: float
) -> Stop:
    """How long a state is held around a run: as long as it is about as near as ever."""
    _, first, last = runs[k]
    before = runs[k - 1][2] + 1 if k else 0
    after = runs[k + 1][1] if k + 1 < len(runs) else len(away)
    limit = max(away[first : last + 1].min() + 0.2 * alike, 0.35 * alike)
    held = first + np.flatnonzero(away[first : last + 1] <= limit)
    begin, end = int(held[0]), int(held[-1])
    while begin > before and away[begin - 1] <= limit:
        begin -= 1
    while end + 1 < after and away[end + 1] <= limit:
        end += 1
    return Stop(node.orbit, node.side, start + begin, start + end + 1)
