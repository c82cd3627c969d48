"""What stands in doubt: composed motion in which one rule alone decides what recurs."""

from itertools import pairwise

import numpy as np
import pytest

from leitmotion.discovery import find_patterns
from leitmotion.discovery.recurrence import MAX_DISTANCE
from leitmotion.features import FeatureSequence

REST = np.zeros((45, 9))


def composed(*parts):
    return FeatureSequence(np.concatenate(parts), ("a", "b", "c"), 30.0, ("place",), 3)


def closed(size, joint=2, count=45):
    """One joint of three leaves its place and comes back, (count, 9)."""
    values = np.zeros((count, 9))
    away = 0.5 * (1 - np.cos(2 * np.pi * np.arange(count) / count))
    for k in range(3):
        values[:, 3 * joint + k] = size * away * np.cos(0.9 * k)
    return values


def shift(joint, distance, direction=(1.0, 0.0, 0.0)):
    """One joint elsewhere, so that postures are so far apart, (9,)."""
    places = np.zeros((3, 3))
    places[joint] = 3 * distance * np.array(direction) / np.linalg.norm(direction)
    return places.ravel()


def led(start, stop, count=45):
    return start + np.linspace(0, 1, count)[:, None] * (stop - start)


def legs(*through):
    """From one posture to the next at an even speed, a second and a half each, so that no pause parts them."""
    parts = [np.linspace(a, b, 45, endpoint=False) for a, b in pairwise(np.array(through, float))]
    return composed(0.6 * np.repeat(np.concatenate(parts), 3, axis=1))


def test_two_cycles_are_parted_where_a_part_of_them_comes_back_elsewhere():
    a, b, c = (0, 0, 0), (1, 0, 0), (1, 0, 1)
    d, e, f, g = (2, 1, 1), (-1, 1, 1), (-1, 2, -1), (2, -1, 0)
    found = find_patterns(legs(a, b, c, a, b, c, a, d, e, f, a, b, g))  # a to b: the legs 0, 3 and 10
    first = max(found.patterns, key=lambda pattern: len(pattern.occurrences))
    np.testing.assert_allclose(first.occurrences.starts, 45 * np.array([0, 3, 10]), atol=6)
    np.testing.assert_allclose(first.occurrences.stops, 45 * np.array([1, 4, 11]), atol=6)
    assert not any(pattern.kind == "cyclic" for pattern in found)


@pytest.mark.parametrize(("size", "told"), [(0.33, 0), (1.0, 1)])
def test_what_is_farther_apart_must_be_clearer(size, told):
    elsewhere = shift(2, 1.07 * MAX_DISTANCE, (np.cos(0.9), -1.0, 0.0))  # too far for the first look
    once = closed(size)
    found = find_patterns(
        composed(REST, once, REST, led(0 * elsewhere, elsewhere, 30), once + elsewhere, REST + elsewhere)
    )
    assert len(found) == told


@pytest.mark.parametrize(("around", "told"), [(2, [3]), (4, [])])
def test_what_is_alike_to_one_occurrence_alone_is_no_pattern(around, told):
    others = [shift(k // 2, 0.9 * MAX_DISTANCE * (-1) ** k) for k in range(around)]
    wider = 1 + 0.3 * np.minimum(1, 2 * np.sin(np.pi * np.arange(45) / 45))[:, None]
    parts, before = [], np.zeros(9)
    for place in (np.zeros(9), *others):
        parts += [led(before, place), REST + place, closed(0.8) + place * wider, REST + place]
        before = place
    assert [len(pattern.occurrences) for pattern in find_patterns(composed(*parts))] == told


def cycles(count, frames, size=1.0):
    """A movement over and over, so many frames each."""
    phase = 2 * np.pi * np.arange(frames) / frames
    once = np.zeros((frames, 9))
    for k in range(3):
        once[:, k] = 0.2 * size * (np.cos(0.1 * k) - np.cos(phase + 0.1 * k))
    return np.tile(once, (count, 1))


@pytest.mark.parametrize(
    "runs",
    [
        [(4, 36, 1.0, 45), (3, 30, 1.25, 6), (3, 48, 1.0, 30)],
        [(4, 36, 1.0, 45), (3, 42, 1.0, 6), (3, 36, 1.0, 30)],
        [(4, 30, 1.0, 45), (4, 42, 1.0, 0), (4, 36, 1.0, 30)],
    ],
)
def test_every_cycle_of_runs_of_changing_tempo_is_told_once(runs):
    parts, begins, at = [np.zeros((15, 9))], [], 15
    for count, frames, size, pause in runs:
        parts += [cycles(count, frames, size), np.zeros((pause, 9))]
        begins += [at + frames * k for k in range(count)]
        at += count * frames + pause
    (pattern,) = find_patterns(composed(*parts))
    np.testing.assert_allclose(pattern.occurrences.starts, begins, atol=4)


@pytest.mark.parametrize(
    ("size", "away", "why"),
    [
        (0.3, 1.07, "not near enough: the limit is 5.4 cm"),
        (0.2, 0.5, "not clear enough: 1.43 times are asked for"),
    ],
)
def test_the_nearest_miss_says_which_bar_it_missed(size, away, why):
    elsewhere = shift(2, away * MAX_DISTANCE, (np.cos(0.9), -1.0, 0.0))
    once = closed(size)
    parts = REST, once, REST, led(0 * elsewhere, elsewhere, 30), once + elsewhere, REST + elsewhere
    assert why in find_patterns(composed(*parts)).nearest_miss
