"""Lone occurrences: a known movement is found once more by its whole course."""

import numpy as np
import pytest
from tests.oracles import whole as twin

from leitmotion.discovery import _whole_kernels
from leitmotion.discovery.lone import with_lone_occurrences
from leitmotion.discovery.returns import Return
from leitmotion.discovery.stripes import SAMPLED
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances

LENGTH = 45


def reach(bend=0.0, length=LENGTH):
    """A hand that goes out and comes back; with a bend another joint moves half-way. (length, 9)."""
    phase = np.linspace(0, 2 * np.pi, length)
    out = np.zeros((length, 9))
    out[:, 0:3] = (0.3 * (1 - np.cos(phase)))[:, None] * (1.0, 0.5, 0.2)
    out[:, 3:6] = (0.2 * np.sin(phase))[:, None] * (0.2, 1.0, 0.5)
    out[:, 6:9] = (bend * np.exp(-((phase - np.pi) ** 2) / 0.3))[:, None] * (0.0, 0.0, 1.0)
    return out


def recording(*parts, gap=40):
    """Movements with stillness between, and where each begins."""
    still = np.zeros((gap, 9))
    pieces, begins, at = [still], [], gap
    for part in parts:
        pieces += [part, still]
        begins.append(at)
        at += len(part) + gap
    values = np.concatenate(pieces)
    return Distances(FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3)), begins


def more(distances, known, taken=(), max_distance=0.054):
    item = Return([(float(a), float(a + LENGTH)) for a in known], [], np.zeros((0, 2)), 1.0)
    hidden = np.zeros(len(distances), bool)
    for span in taken:
        hidden[slice(*span)] = True
    (found,) = with_lone_occurrences([item], hidden, distances, max_distance=max_distance, min_contrast=0.3)
    return [span for span in found.spans if span[0] not in known]


@pytest.mark.parametrize("length", [30, 45, 70])
def test_a_movement_that_differs_half_way_is_found_at_any_tempo(length):
    distances, begins = recording(reach(), reach(), reach(0.5, length))
    ((start, stop),) = more(distances, begins[:2])
    assert start == pytest.approx(begins[2], abs=5)
    assert stop == pytest.approx(begins[2] + length, abs=5)


def test_what_is_taken_is_not_found_again():
    distances, begins = recording(reach(), reach(), reach(0.5))
    assert more(distances, begins[:2], taken=[(begins[2], begins[2] + LENGTH)]) == []


def test_another_movement_and_stillness_are_not_found():
    distances, begins = recording(reach(), reach(), np.roll(reach(), 3, axis=1), gap=90)
    assert more(distances, begins[:2]) == []


@pytest.mark.filterwarnings("error")
def test_what_is_not_seen_is_near_at_no_distance():
    distances, begins = recording(reach(), reach(), reach())
    values = distances.features.values.copy()
    values[: begins[2] - 20, 6:] = np.nan
    values[begins[2] - 20 :, :6] = np.nan
    assert more(Distances(distances.features.replace(values=values)), begins[:2], max_distance=1.0) == []


def test_a_long_movement_is_found_though_its_surroundings_are_sampled():
    distances, begins = recording(reach(0.1, 600), reach(0.1, 600), reach(0.1, 600))
    item = Return([(float(a), a + 600.0) for a in begins[:2]], [], np.zeros((0, 2)), 1.0)
    taken = np.zeros(len(distances), bool)
    (found,) = with_lone_occurrences([item], taken, distances, max_distance=0.054, min_contrast=0.3)
    assert len(found.spans) == 3


def wandering(rng, moments, hidden=0.0):
    values = rng.normal(size=(moments, 6)).cumsum(axis=0)
    values[np.flatnonzero(rng.random(moments) < hidden)] = np.nan
    return Distances(FeatureSequence(values, ("a", "b"), 30.0, ("place",), 3))


@pytest.mark.parametrize("hidden", [0.0, 0.4])
def test_most_of_what_surrounds_is_farther_than_what_is_below_the_median_of_a_sample(rng, hidden):
    distances = wandering(rng, 400, hidden)
    for _ in range(40):
        (a, b), (c, d) = np.sort(rng.integers(0, 400, (2, 2))) + np.array((0, 1))
        sides = range(a, b), range(c, d)
        sample = distances.between(*(side[:: 1 + len(side) // SAMPLED] for side in sides))
        if np.isnan(sample).all():
            continue
        around = float(np.nanmedian(sample.astype(float)))
        for limit, farther in (
            (around - 1e-5, True),
            (around + 1e-5, False),
            (0.0, around > 0),
            (99.0, False),
        ):
            said = _whole_kernels.most_are_farther(distances.across, a, b, c, d, limit, SAMPLED, 3)
            assert said == farther


def test_of_what_was_not_seen_nothing_is_farther(rng):
    across = wandering(rng, 30, hidden=1.1).across
    assert not _whole_kernels.most_are_farther(across, 0, 9, 12, 30, 0.1, SAMPLED, 3)


def test_of_courses_that_cross_the_first_clear_one_is_taken(rng):
    distances = wandering(rng, 60)
    places = np.array([(0, 30, 40), (0, 35, 45), (1, 40, 50), (1, 20, 31), (0, 10, 20)])
    movements, taken = np.array([(0, 5), (5, 12)]), np.zeros(60, bool)
    taken[12] = True
    limits = np.array([99.0, 0.0, 0.0, 0.0, 0.0])  # the first is not clear at all, the others are
    found = _whole_kernels.clear_courses(distances.across, movements, places, limits, taken, SAMPLED, 3)
    assert found.tolist() == [1, 3]
    assert np.flatnonzero(taken).tolist() == [12, *range(20, 31), *range(35, 45)]


def test_courses_are_near_long_enough_and_free(rng):
    distances = wandering(rng, 60)
    free = np.array([(8, 11), (15, 30), (33, 60)])
    known = [
        (cost, start + begin, start + j + 1)
        for start, stop in free
        for j, (cost, begin) in enumerate(
            zip(*_whole_kernels.courses(distances.across, 0, 7, start, stop, 3, 1.0), strict=True)
        )
    ]
    farthest = float(np.median([cost for cost, _, _ in known]))
    expected = [course for course in known if course[0] < farthest and course[2] - course[1] >= 5]
    costs, places = _whole_kernels.near_courses(distances.across, 0, 7, free, 5, farthest, 3, 1.0)
    assert 0 < len(expected) < len(known)
    assert [(cost, *place) for cost, place in zip(costs, places.tolist(), strict=True)] == expected


def test_courses_are_those_of_the_twin(rng):
    distances = wandering(rng, 40)
    costs, begins = _whole_kernels.courses(distances.across, 0, 7, 10, 40, 3, 1.0)
    d = distances.between(range(0, 7), range(10, 40)).astype(float)
    for j in range(30):
        cost, begin = twin.course(d, j)
        assert costs[j] == pytest.approx(cost)
        if np.isfinite(cost):
            assert begins[j] == begin
