"""Ways: what lies between two stops, and which of them are one path, gone either way, by the body or its image."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, product
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.moments import Moments
from leitmotion.discovery.states import askew, straight
from leitmotion.discovery.visiting import Stop
from leitmotion.similarity import align

SAME = 0.5  # of how far a way leads: ways that differ by less, at the worst moments but a few, are one path
BACKWARDS = 0.8  # times that of a way and another gone backwards, so that no arrow turns round by chance
LOPSIDED = 1.25  # times that of a way and an image between lopsided states: nobody's sides are quite the same
WORST = 85.0  # percentile of the moments
LEAST = 0.8  # of what makes two moments the same state: ways may differ as much as their ends may
COMPARED = 8  # ways of a path with which another is compared


Node = tuple[int, int]
"""A state: its orbit and side."""


class Way(NamedTuple):
    """What lies between two stops that follow one another."""

    recording: int
    source: Stop
    target: Stop

    @property
    def start(self) -> int:
        """The last moment at the source."""
        return self.source.stop - 1

    @property
    def stop(self) -> int:
        """After the first moment at the target."""
        return self.target.start + 1


class Gone(NamedTuple):
    """How a way runs along a path."""

    path: int
    mirrored: bool
    reversed: bool


class Course(NamedTuple):
    """A path up to reflection and reversal: its first way, and all."""

    first: Way
    symmetric: bool
    palindromic: bool
    """Whether it is its own reversal."""
    antipalindromic: bool
    """Whether it is the mirror image of its own reversal."""


def ways_of(stops: Sequence[Sequence[Stop]]) -> list[list[Way]]:
    """What lies between the stops of each recording."""
    return [[Way(k, a, b) for a, b in pairwise(row)] for k, row in enumerate(stops)]


def node_of(stop: Stop, mirrored: bool = False) -> Node:
    """Which state a stop, or its mirror image, is at."""
    return stop.orbit, -stop.side if mirrored else stop.side


class Atlas:
    """Tells which path each way is."""

    def __init__(self, moments: Moments, alike: Sequence[float]) -> None:
        self.moments = moments
        self.alike = alike
        self.floor = askew(moments)
        self.costs: dict[tuple[int, int, int, int, bool, bool], float] = {}

    def extent(self, way: Way) -> float:
        """How far a way leads from where it began."""
        return float(self.moments.own[way.start, way.start : way.stop].max())

    def ends(self, way: Way) -> float:
        """Within which angle the ends of a way are the same as those of another."""
        return min(self.alike[way.source.orbit], self.alike[way.target.orbit])

    def differs(self, a: Way, b: Way, mirrored: bool, reversed: bool) -> float:
        """How far a way is from another, gone so, as a share of how far they lead; below 1 they are the same."""
        key = (a.start, a.stop, b.start, b.stop, mirrored, reversed)
        if key not in self.costs:
            matrix = self.moments.mirror if mirrored else self.moments.own
            piece = matrix[a.start : a.stop, b.start : b.stop]
            if reversed:
                piece = piece[:, ::-1]
            path = align(piece).path
            along = piece[path[:, 0], path[:, 1]]
            worst = float(np.percentile(along, WORST))
            if mirrored:
                worst = float(straight(np.array(worst), self.floor))
            share = SAME * (BACKWARDS if reversed else 1.0)
            allowed = max(share * max(self.extent(a), self.extent(b)), LEAST * self.ends(a))
            if mirrored and a.source.side:
                allowed *= LOPSIDED
            self.costs[key] = worst / allowed
        return self.costs[key]

    def sort(self, ways: Sequence[Sequence[Way]]) -> tuple[list[list[Gone]], list[Course]]:
        """Sort ways into paths."""
        members: list[list[tuple[Way, bool, bool]]] = []
        gone: list[list[Gone]] = []
        for row in ways:
            gone.append([])
            for way in row:
                best = self._best(way, members)
                if best is None:
                    members.append([(way, False, False)])
                    gone[-1].append(Gone(len(members) - 1, False, False))
                else:
                    members[best.path].append((way, best.mirrored, best.reversed))
                    gone[-1].append(best)
        courses = [self._course([way for way, _, _ in held]) for held in members]
        return [[_told(g, courses[g.path]) for g in row] for row in gone], courses

    def _best(self, way: Way, members: Sequence[Sequence[tuple[Way, bool, bool]]]) -> Gone | None:
        best, least = None, 1.0
        for path, held in enumerate(members):
            for mirrored, reverse in product((False, True), (False, True)):
                first = held[0][0]
                ends = (node_of(first.target, mirrored), node_of(first.source, mirrored))
                if (node_of(way.source), node_of(way.target)) != (ends if reverse else ends[::-1]):
                    continue
                told = [
                    self.differs(other, way, mirrored != m, reverse != r) for other, m, r in held[:COMPARED]
                ]
                cost = float(np.median(told))
                if cost < least:
                    best, least = Gone(path, mirrored, reverse), cost
        return best

    def _course(self, held: Sequence[Way]) -> Course:
        first = held[0]
        closed = node_of(first.source) == node_of(first.target)
        upright = first.source.side == 0 and first.target.side == 0
        sample = held[:COMPARED]
        symmetric = upright and self._median(sample, True, False)
        palindromic = closed and self._median(sample, False, True)
        turned = node_of(first.source, True) == node_of(first.target)
        antipalindromic = turned and self._median(sample, True, True)
        return Course(first, symmetric, palindromic, antipalindromic)

    def _median(self, sample: Sequence[Way], mirrored: bool, reverse: bool) -> bool:
        return float(np.median([self.differs(way, way, mirrored, reverse) for way in sample])) < 1.0


def _told(gone: Gone, course: Course) -> Gone:
    """How a way runs along a path, said in one way where several are true."""
    mirrored = gone.mirrored and not course.symmetric
    reverse = gone.reversed and not course.palindromic
    if mirrored and course.antipalindromic:
        mirrored, reverse = False, not reverse and not course.palindromic
    return Gone(gone.path, mirrored, reverse)
