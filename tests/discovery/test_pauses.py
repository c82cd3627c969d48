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
        assert int(a) <= start < stop <= b
        assert stop - start >= min(15, b - a)
