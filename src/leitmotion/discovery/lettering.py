"""Lettering: states and paths with the letters of paper S, in frames of their recordings."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

from leitmotion.discovery.moments import Moments
from leitmotion.discovery.motion_graph import Path, State, Visit
from leitmotion.discovery.states import Stop
from leitmotion.discovery.ways import Course, Gone, Node, node_of, ways_of

ASYMMETRIC = "ABCDEFGHIJKLMNO"
SYMMETRIC = "XYZWVUTSRQP"


def named(
    stops: Sequence[Sequence[Stop]],
    gone: Sequence[Sequence[Gone]],
    courses: Sequence[Course],
    moments: Moments,
    rates: Sequence[float],
) -> tuple[tuple[State, ...], tuple[Path, ...]]:
    """Name states and paths in the order of their first visits, recordings in their order.

    Parameters
    ----------
    stops : sequence of sequence of Stop
        The visits of states, recording by recording.
    gone : sequence of sequence of Gone
        Which path lies between each two that follow one another.
    courses : sequence of Course
        The paths, up to reflection and reversal.
    moments : Moments
        In which all this is told.
    rates : sequence of float
        Frames per second of the recordings.

    Returns
    -------
    tuple of State, tuple of Path
        The nodes and the edges.
    """
    names = _names(stops)
    visited: dict[Node, list[Visit]] = defaultdict(list)
    for k, row in enumerate(stops):
        for stop in row:
            visited[node_of(stop)].append(_visit(k, stop.start, stop.stop, moments, rates))
    states = tuple(
        State(
            names[node],
            node[1] == 0,
            tuple(held),
            names[node[0], -node[1]] if (node[0], -node[1]) in visited else "",
        )
        for node, held in visited.items()
    )
    return states, _paths(stops, gone, courses, names, moments, rates)


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


def _paths(
    stops: Sequence[Sequence[Stop]],
    gone: Sequence[Sequence[Gone]],
    courses: Sequence[Course],
    names: dict[Node, str],
    moments: Moments,
    rates: Sequence[float],
) -> tuple[Path, ...]:
    visited: dict[tuple[int, bool], list[Visit]] = defaultdict(list)
    directions: dict[int, set[bool]] = defaultdict(set)
    for row, walked in zip(ways_of(stops), gone, strict=True):
        for way, how in zip(row, walked, strict=True):
            went = _visit(way.recording, way.start, way.stop, moments, rates, how.reversed)
            visited[how.path, how.mirrored].append(went)
            directions[how.path].add(how.reversed)
    labels = _labels(courses, names)
    paths = []
    for (k, mirrored), went in visited.items():
        course = courses[k]
        source, target = (
            names[node_of(stop, mirrored)] for stop in (course.first.source, course.first.target)
        )
        paths.append(
            Path(
                labels[k, mirrored],
                source,
                target,
                course.symmetric,
                course.palindromic or len(directions[k]) > 1,
                tuple(went),
                labels[k, mirrored]
                if course.symmetric or course.antipalindromic
                else labels[k, not mirrored]
                if (k, not mirrored) in visited
                else "",
            )
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


def _visit(
    recording: int, start: int, stop: int, moments: Moments, rates: Sequence[float], reverse: bool = False
) -> Visit:
    frames = rates[recording] / moments.rate
    offset = int(moments.starts[recording])
    return Visit(
        recording, round((start - offset) * frames), round((stop - 1 - offset) * frames) + 1, reversed=reverse
    )
