"""Returns: which part of what comes back is one movement, from stripes drawn by hand."""

import numpy as np
import pytest

from leitmotion.discovery import returns
from leitmotion.discovery.families import overlap
from leitmotion.discovery.returns import _Left, returns_of
from leitmotion.discovery.stripes import Stripe, likeness
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances
from oracles import returns as twin

SHORTEST = 15


def stripe(first, second, count, contrast=0.8):
    """A straight stripe: so many moments from `first` on come back at `second`."""
    i = np.arange(count)
    return Stripe(np.stack((first + i, second + i), axis=1), 1.0 - contrast, 1.0, float(count))


@pytest.fixture
def grouped(rng):
    """Group stripes; what is left of one that is cut is measured on a body that never comes back."""
    features = FeatureSequence(rng.normal(size=(600, 9)), ("a", "b", "c"), 30.0, ("place",), 3)
    distances = Distances(features)
    alike = likeness(distances, max_distance=0.05, min_amplitude=0.012)

    def group(stripes, alternates=lambda a, b: False):
        return returns_of([], stripes, distances, alike, alternates, shortest=SHORTEST, min_contrast=0.3)

    return group


@pytest.mark.parametrize("before", [True, False])
def test_what_happened_to_stand_beside_a_movement_twice_is_no_part_of_it(grouped, before):
    core = (15, 60) if before else (0, 45)
    start, count = core[0], core[1] - core[0]
    stripes = [stripe(0, 100, 60), stripe(start, 200 + start, count), stripe(start, 300 + start, count)]
    (found,) = grouped(stripes)
    assert found.spans == [(at + core[0], at + core[1]) for at in (0, 100, 200, 300)]


def test_a_movement_on_which_all_stripes_agree_is_left_whole(grouped):
    (found,) = grouped([stripe(0, at, 60) for at in (100, 200, 300)])
    assert found.spans == [(at, at + 60) for at in (0, 100, 200, 300)]


def test_the_core_is_not_taken_where_it_would_be_too_short(grouped):
    stripes = [stripe(0, 100, 20), stripe(6, 206, 14), stripe(0, 300, 14)]
    assert (0, 20) in grouped(stripes)[0].spans


LEFT_AND_RIGHT = [stripe(0, 200, 90), stripe(0, 400, 45), stripe(200, 400, 45)]


def test_a_part_that_comes_back_oftener_goes_first(grouped):
    assert grouped(LEFT_AND_RIGHT)[0].spans == [(0, 45), (200, 245), (400, 445)]


def test_a_part_is_not_taken_from_its_mirror_image(grouped):
    asked = []

    def alternates(a, b):
        asked.append({a, b})
        return True

    assert grouped(LEFT_AND_RIGHT, alternates)[0].spans == [(0, 90), (200, 290)]
    assert {(0, 45), (45, 90)} in asked


def test_returns_share_no_more_than_half_of_the_shortest_stretch(grouped):
    first, second = grouped([*LEFT_AND_RIGHT, stripe(20, 480, 50), stripe(240, 540, 50)])
    shared = [overlap(one, other) for one in first.spans for other in second.spans]
    assert max(shared) <= SHORTEST / 2


def drawn(rng, count):
    """Stripes anywhere, of any length and tempo."""
    made = []
    for _ in range(count):
        length, first = rng.integers(SHORTEST, 90), rng.integers(0, 200)
        i = np.arange(length)
        second = first + length + rng.integers(0, 200) + np.round(i * rng.uniform(0.6, 1.4)).astype(int)
        made.append(Stripe(np.stack((first + i, second), axis=1), rng.uniform(0, 0.6), 1.0, float(length)))
    return made


@pytest.mark.parametrize("seed", range(25))
def test_whatever_the_stripes_each_return_takes_something(grouped, seed):
    stripes = drawn(np.random.default_rng(seed), 30)
    found = grouped(stripes)
    assert 0 < len(found) <= sum(len(stripe.path) for stripe in stripes)
    taken = np.zeros(600, bool)
    for item in found:
        inside = np.zeros(600, bool)
        for start, stop in item.spans:
            inside[int(start) : int(np.ceil(stop))] = True
        assert len(item.spans) >= 2
        assert (inside & ~taken).any()
        taken |= inside


def test_the_grouping_ends_where_a_round_takes_nothing(grouped, monkeypatch):
    rounds = []

    def nothing(taken, spans):
        rounds.append(spans)
        assert len(rounds) < 100, "it goes on for ever"

    monkeypatch.setattr(returns, "_take", nothing)
    assert len(grouped([stripe(0, 100, 60), stripe(0, 200, 60)])) == 1


def crooked(rng):
    """A stripe of steps (1, 1), (2, 1) and (1, 2)."""
    steps = np.array([(1, 1), (2, 1), (1, 2)])[rng.integers(0, 3, rng.integers(10, 60))]
    path = np.cumsum(np.concatenate((rng.integers((0, 120), (200, 320), (1, 2)), steps)), axis=0)
    return Stripe(path, rng.uniform(0.1, 0.6), 1.0, float(rng.integers(10, 60)))


def test_stretches_are_carried_as_the_twin_carries_them(rng):
    left = _Left([crooked(rng) for _ in range(60)], SHORTEST, lambda a, b: False)
    come = 0
    for k, side in np.ndindex(60, 2):
        first, last = left.spans[k, side].tolist()
        spans, shown, covered, explained = twin.come_back(left.stripes, first, last, 0.7)
        found = left._occurrences(first, last)
        assert found.spans == sorted(spans)
        assert found.stripes == [left.stripes[n] for n in shown]
        assert found.covered.tolist() == [list(part) for part in covered]
        assert left.scores[k, side] == found.explained == pytest.approx(explained)
        come = max(come, len(shown))
    assert come > 3
