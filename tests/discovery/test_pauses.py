"""Pauses: where a movement is cut."""

import numpy as np
import pytest

from leitmotion.discovery.pauses import from_rest_to_rest, pauses

RATE = 30.0


def bumps(*seconds, peak=1.0):
    """Speed of movements one after another, each from rest to rest."""
    return np.concatenate([peak * np.sin(np.linspace(0, np.pi, round(s * RATE) + 1))[:-1] for s in seconds])


def test_a_pause_lies_between_two_movements():
    assert pauses(bumps(1, 1.5, 1), RATE) == [30, 75]


def test_what_leads_over_is_cut_off_at_the_rest():
    speed = bumps(0.6, 2.0, 0.6)[9:-9]
    assert from_rest_to_rest([(0, len(speed))], speed, RATE, 15) == [(9, 69 + 1)]


def dip(at, to, count=120):
    """Speed of a steady movement that slows down once, so far."""
    return 1.0 - (1.0 - to) * np.clip(1 - np.abs(np.arange(count) - at) / 6, 0, 1)


@pytest.mark.parametrize(("to", "found"), [(0.7, [60]), (0.87, [])])
def test_only_a_marked_slowing_is_a_pause(to, found):
    assert pauses(dip(60, to), RATE) == found


@pytest.mark.parametrize(("at", "to", "start"), [(7, 0.4, 7), (7, 0.6, 0), (25, 0.4, 0)])
def test_a_rest_is_slow_beside_the_fastest_and_near_an_end(at, to, start):
    assert from_rest_to_rest([(0, 120)], dip(at, to), RATE, 15) == [(start, 120)]
    assert from_rest_to_rest([(0, 120)], dip(at, to)[::-1], RATE, 15) == [(0, 120 - start)]


def test_a_rest_is_judged_by_the_fast_part_of_a_movement():
    slow = np.concatenate((0.45 * dip(7, 0.8, 100), np.full(20, 1.0)))
    ((start, _),) = from_rest_to_rest([(0, 120)], slow, RATE, 15)
    assert start == 7


def test_a_movement_without_a_rest_near_its_ends_stays():
    assert from_rest_to_rest([(2.5, 57.5)], np.ones(60), RATE, 15) == [(2.5, 57.5)]


def test_a_rest_in_the_middle_cuts_nothing():
    speed = np.concatenate((np.ones(30), np.zeros(3), np.ones(30)))
    assert from_rest_to_rest([(0.0, 63.0)], speed, RATE, 15) == [(0.0, 63.0)]


@pytest.mark.parametrize("seed", range(20))
def test_each_stays_within_itself_and_is_never_too_short(seed):
    rng = np.random.default_rng(seed)
    speed = np.abs(np.cumsum(rng.normal(size=400)))
    starts = np.sort(rng.uniform(0, 300, 5))
    spans = [(s, s + rng.uniform(15, 90)) for s in starts]
    for (a, b), (start, stop) in zip(spans, from_rest_to_rest(spans, speed, RATE, 15), strict=True):
        assert a <= start < stop <= b
        assert stop - start >= min(15, b - a)
