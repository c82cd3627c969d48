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

    stretch: int
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
    """What lies between the stops of each stretch that was seen without a break."""
    return [[Way(k, a, b) for a, b in pairwise(row)] for k, row in enumerate(stops)]


def node_of(stop: Stop, mirrored: bool = False) -> Node:
    """Which state a stop, or its mirror image, is at."""
    return stop.orbit, -stop.side if mirrored else stop.side


class _Member(NamedTuple):
    """A way, and how it runs along the first of its path."""

    way: Way
    at: tuple[int, int]
    """Its stretch and its place there."""
    mirrored: bool
    reversed: bool


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
        paths: list[list[_Member]] = []
        for row, line in enumerate(ways):
            for k, way in enumerate(line):
                self._add([_Member(way, (row, k), False, False)], paths)
        for held in paths[:0:-1]:  # what the first ways of two paths kept apart, more of them may join
            paths.remove(held)
            self._add(held, paths)
        courses = [self._course([member.way for member in held]) for held in paths]
        gone = {
            member.at: _told(Gone(path, member.mirrored, member.reversed), courses[path])
            for path, held in enumerate(paths)
            for member in held
        }
        return [[gone[row, k] for k in range(len(line))] for row, line in enumerate(ways)], courses

    def _add(self, group: list[_Member], paths: list[list[_Member]]) -> None:
        """Add ways that are one path to the path that they are, or as a path of their own."""
        best, least = None, np.inf
        for held in paths:
            for mirrored, reverse in product((False, True), (False, True)):
                cost = self._apart(held, group, mirrored, reverse)
                rank = cost / BACKWARDS if reverse else cost
                if cost < 1.0 and rank < least:
                    best, least = (held, mirrored, reverse), rank
        if best is None:
            paths.append(group)
            paths.sort(key=lambda held: held[0].at)
            return
        held, mirrored, reverse = best
        held += [
            member._replace(mirrored=member.mirrored != mirrored, reversed=member.reversed != reverse)
            for member in group
        ]

    def _apart(self, held: list[_Member], group: list[_Member], mirrored: bool, reverse: bool) -> float:
        """How far ways are from a path, gone so; infinitely where their ends are others."""
        first, other = held[0].way, group[0].way
        ends = (node_of(first.target, mirrored), node_of(first.source, mirrored))
        if (node_of(other.source), node_of(other.target)) != (ends if reverse else ends[::-1]):
            return np.inf
        told = [
            self.differs(
                a.way, b.way, mirrored != (a.mirrored != b.mirrored), reverse != (a.reversed != b.reversed)
            )
            for a, b in product(held[:COMPARED], group[:COMPARED])
        ]
        return float(np.median(told))

    def _course(self, held: Sequence[Way]) -> Course:
        first = held[0]
        closed = node_of(first.source) == node_of(first.target)
        upright = first.source.side == 0 and first.target.side == 0
        sample = held[:COMPARED]
        symmetric = upright and self._median(sample, True, False)
        palindromic = closed and self._median(sample, False, True)
        turned = node_of(first.source, True) == node_of(first.target)
        antipalindromic = turned and self._crosses(first) and self._median(sample, True, True)
        return Course(first, symmetric, palindromic, antipalindromic)

    def _crosses(self, way: Way) -> bool:
        """Whether a way leads through a symmetric posture, as what is anti-palindromic must."""
        lopsided = np.diagonal(self.moments.mirror)[way.start : way.stop]
        return bool(straight(lopsided, self.floor).min() < LEAST * self.ends(way))

    def _median(self, sample: Sequence[Way], mirrored: bool, reverse: bool) -> bool:
        return float(np.median([self.differs(way, way, mirrored, reverse) for way in sample])) < 1.0


def _told(gone: Gone, course: Course) -> Gone:
    """How a way runs along a path, said in one way where several are true."""
    mirrored = gone.mirrored and not course.symmetric
    reverse = gone.reversed and not course.palindromic
    if mirrored and course.antipalindromic:
        mirrored, reverse = False, not reverse and not course.palindromic
    return Gone(gone.path, mirrored, reverse)
