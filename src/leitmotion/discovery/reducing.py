"""Reducing: which candidates are states, and which only a posture on the way.

A posture through which every way leads on in one and the same manner parts nothing and joins nothing: what leads to it
and what leads on are one path. It stays a state all the same

- where the body keeps still in it;
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

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.visiting import Stop
from leitmotion.discovery.ways import Atlas, Course, Gone, ways_of

HELD_S = 0.8
"""Seconds for which a posture is held that is a state wherever it leads."""


class Walked(NamedTuple):
    """Stops, and what lies between them."""

    stops: list[list[Stop]]
    """Recording by recording, in order."""
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
        The visits of all candidates, recording by recording.
    atlas : Atlas
        What tells which path a way is.

    Returns
    -------
    Walked
        What is left, of a recording that visits any one state at least.
    """
    while True:
        walked = Walked([list(row) for row in stops], *atlas.sort(ways_of(stops)))
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


def _through(walked: Walked) -> dict[int, set[tuple[Gone, Gone]]]:
    """By state, the ways into it and on; those of its mirror image as they are seen in the mirror."""
    through: dict[int, set[tuple[Gone, Gone]]] = {stop.orbit: set() for row in walked.stops for stop in row}
    turns = {orbit for orbit in through if sum(stop.told for stop in walked.at(orbit)) > 1}
    for row, gone in zip(walked.stops, walked.gone, strict=True):
        for stop, into, out in zip(row[1:-1], gone[:-1], gone[1:], strict=True):
            if stop.orbit in turns and not stop.told:
                continue  # where a body halts tells more of a state than where it happens to pass
            pair, image = (into, out), (walked.image(into), walked.image(out))
            seen = min(pair, image) if stop.side == 0 else pair if stop.side == 1 else image
            through[stop.orbit].add(seen)
    return through


def _is_on_the_way(
    orbit: int, through: dict[int, set[tuple[Gone, Gone]]], walked: Walked, atlas: Atlas
) -> bool:
    visits = walked.at(orbit)
    held = np.median([stop.stop - stop.start for stop in visits]) >= HELD_S * atlas.moments.rate
    if not through[orbit]:  # a recording only happens to begin or to end there
        return len(visits) == 1 and not held and any(len(walked.at(other)) > 1 for other in through)
    if len(through[orbit]) > 1:
        return False
    ((into, out),) = through[orbit]
    if into == out or into == walked.image(out):
        return False
    if out == walked.back(into):
        return not _leads_nowhere_else(orbit, out.path, walked)
    if walked.upright(orbit) and out == walked.image(walked.back(into)):
        return False
    return not held


def _leads_nowhere_else(orbit: int, path: int, walked: Walked) -> bool:
    """Whether the state from which the body came has no other path but that one and its mirror image."""
    others = walked.ends(path) - {orbit}
    return not others or {
        gone.path for row in walked.gone for gone in row if walked.ends(gone.path) & others
    } == {path}
