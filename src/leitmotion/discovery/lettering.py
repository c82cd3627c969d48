"""Lettering: states and paths with the letters of paper S, in frames of their recordings."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import NamedTuple

from leitmotion.discovery.moments import Moments
from leitmotion.discovery.motion_graph import Path, State, Visit
from leitmotion.discovery.reducing import Walked
from leitmotion.discovery.visiting import Stop
from leitmotion.discovery.ways import Course, Node, node_of, ways_of
from leitmotion.features import FeatureSequence

ASYMMETRIC = "ABCDEFGHIJKLMNO"
SYMMETRIC = "XYZWVUTSRQP"


def named(
    walked: Walked, moments: Moments, chains: Sequence[FeatureSequence]
) -> tuple[tuple[State, ...], tuple[Path, ...]]:
    """Name states and paths in the order of their first visits, recordings in their order.

    Parameters
    ----------
    walked : Walked
        The visits of states, and which path lies between each two.
    moments : Moments
        In which all this is told.
    chains : sequence of FeatureSequence
        The recordings.

    Returns
    -------
    tuple of State, tuple of Path
        The nodes and the edges.
    """
    names = _names(walked.stops)
    frames = _Frames(moments, chains)
    visited: dict[Node, list[Visit]] = defaultdict(list)
    for k, row in enumerate(walked.stops):
        for stop in row:
            visited[node_of(stop)].append(frames.visit(k, stop.start, stop.stop))
    images = {node: (node[0], -node[1]) for node in visited}
    states = tuple(
        State(names[node], node[1] == 0, tuple(held), names[images[node]] if images[node] in visited else "")
        for node, held in visited.items()
    )
    return states, _paths(walked, names, frames)


class _Frames(NamedTuple):
    """What makes of moments frames of a recording."""

    moments: Moments
    chains: Sequence[FeatureSequence]

    def visit(self, stretch: int, start: int, stop: int, *, backwards: bool = False) -> Visit:
        """A visit of moments [start, stop) of a stretch; the last moment of a recording lasts to its end."""
        recording, origin = self.moments.origins[stretch].tolist()
        before = origin - int(self.moments.starts[stretch])
        chain = self.chains[recording]
        each = chain.rate / self.moments.rate
        after = (before + stop) * each
        last = len(chain) if after > len(chain) - 1 + 1e-3 else round(after)
        return Visit(recording, round((before + start) * each), last, reversed=backwards)


def _names(stops: Sequence[Sequence[Stop]]) -> dict[Node, str]:
    """The letter of each state; the one of a pair that came first has no star."""
    names: dict[Node, str] = {}
    used = {SYMMETRIC: 0, ASYMMETRIC: 0}
    for row in stops:
        for stop in row:
            node = node_of(stop)
            if node in names:
                continue
            alphabet = SYMMETRIC if stop.side == 0 else ASYMMETRIC
            count = used[alphabet]
            used[alphabet] += 1
            names[node] = alphabet[count % len(alphabet)] + "'" * (count // len(alphabet))
            if stop.side:
                names[node[0], -node[1]] = names[node] + "*"
    return names


def _paths(walked: Walked, names: dict[Node, str], frames: _Frames) -> tuple[Path, ...]:
    visited: dict[tuple[int, bool], list[Visit]] = defaultdict(list)
    directions: dict[int, set[bool]] = defaultdict(set)
    for row, gone in zip(ways_of(walked.stops), walked.gone, strict=True):
        for way, how in zip(row, gone, strict=True):
            visit = frames.visit(way.stretch, way.start, way.stop, backwards=how.reversed)
            visited[how.path, how.mirrored].append(visit)
            directions[how.path].add(how.reversed)
    labels = _labels(walked.courses, names)
    paths = []
    for (k, mirrored), visits in visited.items():
        course = walked.courses[k]
        source, target = (
            names[node_of(stop, mirrored)] for stop in (course.first.source, course.first.target)
        )
        own = course.symmetric or course.antipalindromic
        image = labels[k, mirrored != (not own)] if own or (k, not mirrored) in visited else ""
        reversible = course.palindromic or len(directions[k]) > 1
        paths.append(
            Path(labels[k, mirrored], source, target, course.symmetric, reversible, tuple(visits), image)
        )
    return tuple(paths)


def _labels(courses: Sequence[Course], names: dict[Node, str]) -> dict[tuple[int, bool], str]:
    """The name of each path and of its mirror image; figures tell apart those that join the same two states."""
    bases = []
    for course in courses:
        ends = [course.first.source, course.first.target]
        lopsided = [stop for stop in ends if stop.side]
        starred = bool(lopsided) and names[node_of(lopsided[0])].endswith("*")
        bases.append(("".join(names[node_of(stop, starred)].lower() for stop in ends), starred))
    labels = {}
    seen: dict[str, int] = defaultdict(int)
    count: dict[str, int] = defaultdict(int)
    for base, _ in bases:
        count[base] += 1
    for k, (base, starred) in enumerate(bases):
        seen[base] += 1
        name = f"{base}{seen[base]}" if count[base] > 1 else base
        labels[k, starred], labels[k, not starred] = name, f"({name})*"
    return labels
