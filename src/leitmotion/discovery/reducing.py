"""Reducing: which states are states, and which only a posture on the way."""

from __future__ import annotations

from collections import defaultdict

import numpy as np

from leitmotion.discovery.states import Stop
from leitmotion.discovery.ways import Atlas, Course, Gone, ways_of

HELD_S = 0.8
"""Seconds for which a posture is held that is a state wherever it leads."""


def reduced(
    stops: list[list[Stop]], atlas: Atlas, *, held_s: float = HELD_S
) -> tuple[list[list[Stop]], list[list[Gone]], list[Course]]:
    """Leave out one state after another that is only a posture on the way."""
    stops = [list(row) for row in stops]
    while True:
        gone, courses = atlas.sort(ways_of(stops))
        passed = _passed(stops, gone, courses)
        found = [
            orbit for orbit in passed if _is_on_the_way(orbit, passed, stops, gone, courses, atlas, held_s)
        ]
        if not found:
            return stops, gone, courses
        lopsided = any(not course.symmetric for course in courses)
        found.sort(key=lambda orbit: (not (lopsided and _upright(orbit, stops)), -_first(orbit, stops)))
        stops = [[stop for stop in row if stop.orbit != found[0]] for row in stops]


def _passed(stops, gone, courses) -> dict[int, set[tuple[Gone, Gone]]]:
    """By orbit, the ways in and out, those of a mirror image as seen in the mirror."""
    passed: dict[int, set[tuple[Gone, Gone]]] = defaultdict(set)
    for row, walked in zip(stops, gone, strict=True):
        for k, stop in enumerate(row):
            passed[stop.orbit]
            if 0 < k < len(row) - 1:
                passed[stop.orbit].add(_seen(walked[k - 1], walked[k], stop.side, courses))
    return passed


def _seen(into: Gone, out: Gone, side: int, courses) -> tuple[Gone, Gone]:
    pair = (into, out)
    image = (_image(into, courses), _image(out, courses))
    if side == 0:
        return min(pair, image)
    return pair if side == 1 else image


def _image(gone: Gone, courses) -> Gone:
    return gone if courses[gone.path].symmetric else gone._replace(mirrored=not gone.mirrored)


def _back(gone: Gone, courses) -> Gone:
    return gone if courses[gone.path].palindromic else gone._replace(reversed=not gone.reversed)


def _is_on_the_way(orbit, passed, stops, gone, courses, atlas, held_s) -> bool:
    through = passed[orbit]
    at = [stop for row in stops for stop in row if stop.orbit == orbit]
    held = float(np.median([stop.stop - stop.start for stop in at])) / atlas.moments.rate >= held_s
    if not through:  # where a recording only happens to begin or to end
        return len(at) == 1 and not held and any(len(each) > 0 for each in passed.values())
    if len(through) != 1:
        return False
    ((into, out),) = through
    if into == out or into == _image(out, courses):
        return False  # a loop, or half a cycle in the mirror
    if out == _back(into, courses):
        return not _has_no_other(orbit, out, stops, gone, courses)
    if _upright(orbit, stops) and out == _image(_back(into, courses), courses):
        return False  # the centre of what is anti-palindromic
    return not held


def _has_no_other(orbit, out, stops, gone, courses) -> bool:
    """Whether the state from which a body turns back here has no other path but that one and its mirror image."""
    ends = {courses[out.path].first.source.orbit, courses[out.path].first.target.orbit}
    others = ends - {orbit}
    if not others:
        return True
    (base,) = others
    leading = {
        g.path
        for row in gone
        for g in row
        if base in (courses[g.path].first.source.orbit, courses[g.path].first.target.orbit)
    }
    return leading == {out.path}


def _upright(orbit, stops) -> bool:
    return all(stop.side == 0 for row in stops for stop in row if stop.orbit == orbit)


def _first(orbit, stops) -> tuple[int, int]:
    return min(stop.start for row in stops for stop in row if stop.orbit == orbit)
