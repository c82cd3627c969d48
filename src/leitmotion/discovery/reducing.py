"""Reducing: which candidates are states, and which only a posture on the way.

A posture through which every way leads on in one and the same manner parts nothing and joins nothing: what leads to it
and what leads on are one path. It stays a state all the same

- where the body keeps still in it;
- where a recording ends in it on a way by which the body never else came, or begins with one by which it never else
  went;
- where it is the turning point of the only path that its neighbour has, or of that and its mirror image: there and
  back again, as in jumping jacks, else it is a reversible loop of its neighbour;
- where it is symmetric and what follows is the mirror image of what came before, reversed in time: the middle of an
  anti-palindrome;
- where what follows is the mirror image of what came before: half a cycle of an anti-phase movement;
- where it is the one state of a cycle.

References
----------
Paper S, sections 3.5 and 3.6.1: which postures of its examples are states.
"""

from __future__ import annotations

from collections.abc import Sequence, Set
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.visiting import Stop
from leitmotion.discovery.ways import Atlas, Course, Gone, ways_of

HELD_S = 0.7
"""Seconds for which a posture is held that is a state wherever it leads."""


class Walked(NamedTuple):
    """Stops, and what lies between them."""

    stops: list[list[Stop]]
    """Stretch by stretch of what was seen without a break, in order."""
    gone: list[list[Gone]]
    """Which path lies between each two."""
    courses: list[Course]
    """The paths, up to reflection and reversal."""

    def at(self, orbit: int) -> list[Stop]:
        """Every visit of a state or its mirror image."""
        return [stop for row in self.stops for stop in row if stop.orbit == orbit]

    def upright(self, orbit: int) -> bool:
        """Whether a state is its own mirror image."""
        return all(stop.side == 0 for stop in self.at(orbit))

    def image(self, gone: Gone) -> Gone:
        """The same way in the mirror."""
        return gone if self.courses[gone.path].symmetric else gone._replace(mirrored=not gone.mirrored)

    def back(self, gone: Gone) -> Gone:
        """The same way reversed."""
        return gone if self.courses[gone.path].palindromic else gone._replace(reversed=not gone.reversed)

    def ends(self, path: int) -> set[int]:
        """Which states a path joins, up to reflection."""
        first = self.courses[path].first
        return {first.source.orbit, first.target.orbit}


def reduced(stops: Sequence[Sequence[Stop]], atlas: Atlas) -> Walked:
    """Leave out one candidate after another that is only a posture on the way.

    Parameters
    ----------
    stops : sequence of sequence of Stop
        The visits of all candidates, stretch by stretch.
    atlas : Atlas
        What tells which path a way is.

    Returns
    -------
    Walked
        What is left, of a recording that visits any one state at least.
    """
    stops = _without_chance_ends(stops, HELD_S * atlas.moments.rate)
    while True:
        walked = Walked([list(row) for row in stops], *atlas.sort(ways_of(stops)))
        kept = _as_others(walked)
        if kept != walked.stops:
            stops = kept
            continue
        through = _through(walked)
        passed = [orbit for orbit in through if _is_on_the_way(orbit, through, walked, atlas)]
        if not passed or len(through) == 1:
            return walked
        # of a lopsided cycle a posture goes first that happens to be symmetric, else what came last
        lopsided = not all(course.symmetric for course in walked.courses)
        least = max(
            passed,
            key=lambda orbit: (lopsided and walked.upright(orbit), min(s.start for s in walked.at(orbit))),
        )
        stops = [[stop for stop in row if stop.orbit != least] for row in walked.stops]
        if all(len(row) < 2 for row in stops):  # a movement leads from somewhere to somewhere
            return walked


def _without_chance_ends(stops: Sequence[Sequence[Stop]], held: float) -> list[list[Stop]]:
    """Leave out a state at which a recording only happens to begin or to end, where there are others."""
    halted: dict[int, list[Stop]] = {stop.orbit: [] for row in stops for stop in row}
    ends = set()
    for row in stops:
        told = [stop for stop in row if stop.told]
        ends |= {stop.orbit for stop in (*told[:1], *told[-1:])}
        for stop in told:
            halted[stop.orbit].append(stop)
    again = any(len(visits) > 1 for visits in halted.values())
    chance = {
        orbit
        for orbit in ends
        if again and len(halted[orbit]) == 1 and halted[orbit][0].stop - halted[orbit][0].start < held
    }
    return [[stop for stop in row if stop.orbit not in chance] for row in stops]


def _through(walked: Walked) -> dict[int, set[tuple[Gone, Gone]]]:
    """By state, the ways into it and on, where the body halts or turns; of an image as seen in the mirror."""
    through: dict[int, set[tuple[Gone, Gone]]] = {stop.orbit: set() for row in walked.stops for stop in row}
    for n, row in enumerate(walked.stops):
        for k, stop in enumerate(row[1:-1], 1):
            if stop.told:
                through[stop.orbit].add(_seen(n, k, walked))
    return through


def _seen(n: int, k: int, walked: Walked) -> tuple[Gone, Gone]:
    """The way into a stop and the way on, of a mirror image as seen in the mirror."""
    stop, into, out = walked.stops[n][k], walked.gone[n][k - 1], walked.gone[n][k]
    image = (walked.image(into), walked.image(out))
    return min((into, out), image) if stop.side == 0 else (into, out) if stop.side == 1 else image


def _as_others(walked: Walked) -> list[list[Stop]]:
    """Leave out where a body passes a state on other paths than those on which it comes and goes when it halts."""
    paths: dict[int, set[int]] = {stop.orbit: set() for row in walked.stops for stop in row}
    beside = [
        [{gone.path for gone in walked.gone[n][max(k - 1, 0) : k + 1]} for k in range(len(row))]
        for n, row in enumerate(walked.stops)
    ]
    for row, ways in zip(walked.stops, beside, strict=True):
        for stop, near in zip(row, ways, strict=True):
            if stop.told:
                paths[stop.orbit] |= near
    return [
        [stop for stop, near in zip(row, ways, strict=True) if stop.told or near <= paths[stop.orbit]]
        for row, ways in zip(walked.stops, beside, strict=True)
    ]


def _is_on_the_way(
    orbit: int, through: dict[int, set[tuple[Gone, Gone]]], walked: Walked, atlas: Atlas
) -> bool:
    visits = walked.at(orbit)
    held = np.median([stop.stop - stop.start for stop in visits]) >= HELD_S * atlas.moments.rate
    if not through[orbit]:  # a recording only happens to begin or to end there
        return len(visits) == 1 and not held and any(len(walked.at(other)) > 1 for other in through)
    if len(through[orbit]) > 1 or _parts_or_joins(orbit, through[orbit], walked):
        return False
    ((into, out),) = through[orbit]
    if held or into == out or into == walked.image(out):
        return False
    if out == walked.back(into):
        return not _leads_nowhere_else(orbit, out.path, walked)
    return not (walked.upright(orbit) and out == walked.image(walked.back(into)))


def _parts_or_joins(orbit: int, through: Set[tuple[Gone, Gone]], walked: Walked) -> bool:
    """Whether a recording ends at a state on a way by which no other came, or begins with one by which none went."""
    for row, gone in zip(walked.stops, walked.gone, strict=True):
        for stop, way, place in ((row[0], gone[0], 1), (row[-1], gone[-1], 0)) if gone else ():
            if stop.orbit != orbit or not stop.told:
                continue
            seen = walked.image(way) if stop.side < 0 else way
            known = {each[place] for each in through}
            if seen not in known and not (stop.side == 0 and walked.image(seen) in known):
                return True
    return False


def _leads_nowhere_else(orbit: int, path: int, walked: Walked) -> bool:
    """Whether the state from which the body came has no other path but that one and its mirror image."""
    others = walked.ends(path) - {orbit}
    return not others or {
        gone.path for row in walked.gone for gone in row if walked.ends(gone.path) & others
    } == {path}
