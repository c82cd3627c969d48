"""Limbs: four ends of a tree of bones that make a body, told from how it is built, not from names.

Two feet meet at the pelvis and two hands at the chest, the trunk between; the bones of a pair are alike; thigh, shin,
upper arm, forearm and trunk stand in the proportions of people [1]. What leaves the chest besides the arms is the head.
Each of these that fails costs, and the four ends that cost least are taken.

References
----------
[1] Drillis, Contini, *Body segment parameters*, New York University (1966).
"""

from __future__ import annotations

from itertools import combinations, pairwise, product
from typing import NamedTuple

import numpy as np

from leitmotion.body.graph import Graph
from leitmotion.body.look import typical
from leitmotion.body.size import ARM, BREADTH, CHAIN

THIGH, SHIN = CHAIN["hip", "knee"], CHAIN["knee", "ankle"]
UPPER_ARM, FOREARM = ARM["shoulder", "elbow"], ARM["elbow", "wrist"]
TRUNK = CHAIN["pelvis", "neck"]
SHOULDERS = BREADTH["left_shoulder", "right_shoulder"]

ENDS = 7  # of the tree that are tried as hands and feet, those that reach out farthest
SHORTEST = 0.06  # of the longest way through the tree: how far an end must reach out
STRAIGHT = 0.03  # by how much the way over joints between may exceed the straight line and still be one bone
BENDS = 0.9  # of the moments in which it does not: who bends a joint does so in more of them
SKIPPED = 0.8  # what a joint that a leg's bone passes over leaves of its length
PASSED = 0.25  # what a joint costs that an arm's bone passes over
NARROWEST = 0.05  # of the usual breadth: shoulders that are nearer to each other cost no more
LIKELY = 16  # bones on the way to a hand that are tried as an arm, the likeliest
UNLIKE = 5.0  # how much more the difference of the sides costs than that from people's proportions
NOWHERE = 1e-9  # a length that costs too much
LEVEL = 0.15  # what it costs that hands are lower than feet throughout
NO_HEAD = 0.3  # what it costs that nothing but the arms leaves the chest


class Limb(NamedTuple):
    """Three places of an arm or a leg, the lengths of the bones between them, and how many places they pass over."""

    joints: tuple[int, int, int]
    upper: float
    lower: float
    passed: int


class Fit(NamedTuple):
    """Four limbs on a trunk, and what that costs."""

    pelvis: int
    """The place where the ways to the feet part."""

    chest: int
    """The place where the ways to the hands part."""

    ends: tuple[int, int, int, int]
    """Two feet and two hands."""

    legs: tuple[Limb, Limb]
    arms: tuple[Limb, Limb]
    head: tuple[int, ...]
    """The way from what joins the arms to the top of the head, empty where there is none."""

    stature: float
    """How tall a person with such legs is."""

    cost: float


def fit_body(graph: Graph, most: float) -> Fit | None:
    """Find the four ends of a tree that make the likeliest body.

    Parameters
    ----------
    graph : Graph
        Places joined by bones.
    most : float
        What a body may cost.

    Returns
    -------
    Fit or None
        The cheapest; None where each costs more.
    """
    paths = _Paths(graph)
    best: Fit | None = None
    for four in combinations(_far_ends(graph, paths), 4):
        for first, second in ((four[:2], four[2:]), (four[::2], four[1::2]), (four[::3], four[1:3])):
            for legs, arms in ((first, second), (second, first)):
                best = _body(paths, (*legs, *arms), best.cost if best else most) or best
    return best


class _Paths:
    """Ways through a graph, and what was measured along them."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self.depth = np.zeros(len(graph.above))
        for place in range(1, len(graph.above)):
            self.depth[place] = self.depth[graph.above[place]] + graph.lengths[place]
        self._gaps = np.linalg.norm(graph.positions[:, :, None] - graph.positions[:, None], axis=3)
        seen = np.isfinite(self._gaps).sum(axis=0)
        middle = np.maximum(seen - 1, 0)[None] // 2
        usual = np.take_along_axis(np.sort(self._gaps, axis=0), middle, axis=0)[
            0
        ]  # what is unseen sorts last
        self._apart = np.where(seen > 0, usual, 0.0).tolist()
        self._ways: dict[tuple[int, int], list[int]] = {}
        self._legs: dict[tuple[int, int], Limb | None] = {}
        self._triples: dict[tuple[int, int], list[Limb]] = {}

    def way(self, start: int, end: int) -> list[int]:
        """List the places from one to another, both included."""
        key = (start, end)
        if key not in self._ways:
            self._ways[key] = self.graph.path(start, end)
        return self._ways[key]

    def length(self, path: list[int]) -> float:
        """Length along the bones."""
        return float(sum(abs(self.depth[a] - self.depth[b]) for a, b in pairwise(path)))

    def apart(self, a: int, b: int) -> float:
        """Usual distance, 0 of such as are never seen together."""
        return float(self._apart[a][b])

    def triples(self, start: int, end: int) -> list[Limb]:
        """List all three places along a way with a straight bone between each two."""
        key = (start, end)
        if key not in self._triples:
            path = self.way(start, end)
            bones = self._bones(path)
            self._triples[key] = [
                Limb((path[i], path[j], path[k]), bones[i, j], bones[j, k], k - i - 2)
                for i, j in bones
                for k in range(j + 1, len(path))
                if (j, k) in bones and bones[i, j] > 0 and bones[j, k] > 0
            ]
        return self._triples[key]

    def _bones(self, path: list[int]) -> dict[tuple[int, int], float]:
        """Measure what may be a bone between two places of a way: one that is, or over others that are in line."""
        gaps = self._gaps[:, path][:, :, path]
        gaps = gaps[np.isfinite(gaps).all(axis=(1, 2))]
        if not len(gaps):
            return {}
        steps = np.diagonal(gaps, offset=1, axis1=1, axis2=2)
        along = np.concatenate((np.zeros((len(gaps), 1)), np.cumsum(steps, axis=1)), axis=1)
        ways = along[:, None] - along[:, :, None]
        most = np.sort(ways - gaps, axis=0)[int(BENDS * (len(gaps) - 1))]
        usual = np.median(ways, axis=0)
        return {
            (i, j): float(usual[i, j])
            for i, j in combinations(range(len(path)), 2)
            if j == i + 1 or most[i, j] <= STRAIGHT * usual[i, j]
        }

    def leg(self, start: int, end: int) -> Limb | None:
        """Find the two longest bones that follow each other."""
        key = (start, end)
        if key not in self._legs:
            self._legs[key] = max(
                self.triples(start, end),
                key=lambda limb: min(limb.upper, limb.lower) * SKIPPED**limb.passed,
                default=None,
            )
        return self._legs[key]


def _far_ends(graph: Graph, paths: _Paths) -> list[int]:
    """Take the ends that reach out farthest from what the others span."""
    leaves = graph.leaves()
    if len(leaves) < 4:
        return []
    first = max(leaves, key=lambda leaf: paths.depth[leaf])
    chosen, spanned, longest = [first], {first}, 0.0
    while len(chosen) < ENDS:
        reach = {}
        for leaf in leaves:
            if leaf in chosen:
                continue
            path = paths.way(leaf, first)
            meet = next(i for i, place in enumerate(path) if place in spanned)
            reach[leaf] = (paths.length(path[: meet + 1]), path[: meet + 1])
        if not reach:
            break
        leaf = max(reach, key=lambda one: reach[one][0])
        longest = max(longest, reach[leaf][0])
        if reach[leaf][0] < SHORTEST * longest:
            break
        chosen.append(leaf)
        spanned.update(reach[leaf][1])
    return chosen


def _body(paths: _Paths, ends: tuple[int, int, int, int], most: float) -> Fit | None:
    """Take two ends as feet and two as hands; None where that costs too much."""
    graph = paths.graph
    pelvis, chest = _junctions(paths, ends)
    if pelvis == chest:
        return None
    legs = [paths.leg(pelvis, end) for end in ends[:2]]
    if legs[0] is None or legs[1] is None:
        return None
    stature = sum(leg.upper + leg.lower for leg in legs if leg) / 2 / (THIGH + SHIN)
    arms = _arms(paths, chest, ends[2:], stature)
    if arms is None:
        return None
    pair_of_legs, (pair_of_arms, cost) = (legs[0], legs[1]), arms
    cost += sum(np.log(leg.upper / leg.lower) ** 2 for leg in pair_of_legs) + _unlike(pair_of_legs)
    cost += np.log(_trunk(graph, pair_of_legs, pair_of_arms) / stature / TRUNK) ** 2
    if cost >= most:
        return None
    head = _head_branch(paths, pelvis, chest, ends, pair_of_arms)
    if not head:
        cost += NO_HEAD
    feet, hands = (graph.positions[:, list(those), 1].mean(axis=1) for those in (ends[:2], ends[2:]))
    both = np.isfinite(feet) & np.isfinite(hands)
    cost += LEVEL * float(np.mean(hands[both] < feet[both])) if both.any() else 0.0
    if cost >= most:
        return None
    return Fit(pelvis, chest, ends, pair_of_legs, pair_of_arms, tuple(head), stature, float(cost))


def _junctions(paths: _Paths, ends: tuple[int, int, int, int]) -> tuple[int, int]:
    """Find where the ways to two feet part, and where those to two hands do."""
    return _parting(paths, ends[2], ends[0], ends[1]), _parting(paths, ends[0], ends[2], ends[3])


def _parting(paths: _Paths, start: int, one: int, other: int) -> int:
    shared = start
    for a, b in zip(paths.way(start, one), paths.way(start, other), strict=False):
        if a != b:
            break
        shared = a
    return shared


def _trunk(graph: Graph, legs: tuple[Limb, Limb], arms: tuple[Limb, Limb]) -> float:
    """Usual distance from the middle of the hips to the middle of the shoulders."""
    hips, shoulders = (
        graph.positions[:, [limb.joints[0] for limb in pair]].mean(axis=1) for pair in (legs, arms)
    )
    length = typical(np.linalg.norm(shoulders - hips, axis=1))
    return length if length > 0 else NOWHERE


def _arms(
    paths: _Paths, chest: int, hands: tuple[int, ...], stature: float
) -> tuple[tuple[Limb, Limb], float] | None:
    """Find on two ways the bones that are most like a pair of arms, and tell what they cost."""
    ways = [
        sorted((_misfit(limb, stature) + PASSED * limb.passed, limb) for limb in paths.triples(chest, hand))[
            :LIKELY
        ]
        for hand in hands
    ]
    best, least = None, np.inf
    for (cost, one), (more, other) in product(*ways):
        breadth = max(paths.apart(one.joints[0], other.joints[0]) / stature / SHOULDERS, NARROWEST)
        beside = _unlike((one, other)) + 0.3 * np.log(breadth) ** 2
        if cost + more + beside < least:
            least = cost + more + beside
            best = (one, other), beside + _misfit(one, stature) + _misfit(other, stature)
    return best


def _unlike(pair: tuple[Limb, Limb]) -> float:
    """What it costs that the bones of a pair differ."""
    one, other = pair
    return UNLIKE * float(np.log(one.upper / other.upper) ** 2 + np.log(one.lower / other.lower) ** 2)


def _misfit(arm: Limb, stature: float) -> float:
    upper, lower = np.log(arm.upper / stature / UPPER_ARM), np.log(arm.lower / stature / FOREARM)
    return float(upper**2 + lower**2)


def _head_branch(
    paths: _Paths, pelvis: int, chest: int, ends: tuple[int, int, int, int], arms: tuple[Limb, Limb]
) -> list[int]:
    """List the longest way that leaves the chest, or what joins it to the shoulders, and is no arm and no trunk."""
    graph = paths.graph
    joined, used = {chest}, set(paths.way(chest, pelvis))
    for end, arm in zip(ends[2:], arms, strict=True):
        way = paths.way(chest, end)
        joined.update(way[: way.index(arm.joints[0])])
        used.update(way)
    best, longest = [], 0.0
    for leaf in set(graph.leaves()) - used:
        way = paths.way(chest, leaf)
        leaves_at = max(i for i, place in enumerate(way) if place in used)
        length = paths.length(way[leaves_at:])
        if way[leaves_at] in joined and length > longest:
            best, longest = way[leaves_at + 1 :], length
    return best
