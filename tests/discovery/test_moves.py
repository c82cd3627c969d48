"""Moves: whole movements from pause to pause that leave no stripe."""

from itertools import pairwise

import numpy as np
import pytest
from tests.discovery.test_lone import reach, recording
from tests.oracles import whole as twin

from leitmotion.discovery import _whole_kernels, moves
from leitmotion.discovery.moves import moves_of
from leitmotion.discovery.search import Criteria
from leitmotion.discovery.stripes import likeness
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances

CRITERIA = Criteria(max_distance=0.08, min_contrast=0.4, min_amplitude=0.012, shortest=15)


def found_in(distances):
    alike = likeness(distances, max_distance=CRITERIA.max_distance, min_amplitude=CRITERIA.min_amplitude)
    return [item.spans for item in moves_of(distances, alike, CRITERIA).returns]


def test_movements_far_apart_half_way_are_one_move():
    distances, begins = recording(reach(0.25), reach(-0.25), np.roll(reach(0.4), 3, axis=1))
    (spans,) = found_in(distances)
    assert [start for start, _ in spans] == pytest.approx(begins[:2], abs=12)
    for (start, stop), begin in zip(spans, begins, strict=False):
        assert min(stop, begin + 45) - max(start, begin) > 0.8 * 45


def out_and_back(size=1.0, hurry=0.0, length=60):
    """A hand that goes out and comes back, faster at first or, negative, at last. (length, 9)."""
    phase = np.linspace(0, 2 * np.pi, length)
    phase += hurry * np.sin(phase)
    values = np.zeros((length, 9))
    values[:, 0:3] = (0.3 * (1 - np.cos(phase)))[:, None] * (1.0, 0.5, 0.2)
    values[:, 3:6] = (0.2 * np.sin(phase))[:, None] * (0.2, 1.0, 0.5)
    return size * values


@pytest.mark.parametrize(("size", "count"), [(0.35, 0), (0.5, 1)])
def test_a_move_leads_away_from_where_it_began(size, count):
    distances, _ = recording(out_and_back(size), out_and_back(size))
    assert len(found_in(distances)) == count


@pytest.mark.parametrize(("size", "whole"), [(1.4, True), (2.2, False)])
def test_moves_of_another_rhythm_are_one_unless_they_are_far_apart_unwarped(size, whole):
    distances, _ = recording(out_and_back(size, 0.8), out_and_back(size, -0.8), gap=60)
    lasting = max(stop - start for spans in found_in(distances) for start, stop in spans)
    assert (lasting > 40) == whole  # else the ways out and back are found one by one


def test_a_move_may_take_nearly_twice_as_long():
    distances, begins = recording(reach(0.2, 45), reach(-0.2, 80))
    (spans,) = found_in(distances)
    assert [start for start, _ in spans] == pytest.approx(begins, abs=3)


def test_a_move_holds_six_stretches_between_pauses_at_most():
    distances, _ = recording(*[reach(0.25, 24)] * 12, gap=1)
    alike = likeness(distances, max_distance=CRITERIA.max_distance, min_amplitude=CRITERIA.min_amplitude)
    spans = moves._spans(distances, alike, CRITERIA)
    ends = moves._ends(0, len(distances), alike, 30.0)
    inside = [sum(start < end < stop for end in ends) for start, stop in spans.tolist()]
    assert max(inside) == 5


def test_movements_that_nothing_repeats_are_none():
    distances, _ = recording(reach(), np.roll(reach(), 3, axis=1))
    assert found_in(distances) == []


@pytest.mark.filterwarnings("error")
def test_moves_that_mostly_rest_are_weighed_too():
    nods = [reach(0.1, 18), np.zeros((50, 9)), reach(0.1, 18)]
    distances, _ = recording(np.concatenate(nods), np.concatenate(nods), gap=90)
    (spans,) = found_in(distances)
    assert len(spans) == 2


def test_what_is_known_already_is_passed_over():
    distances, begins = recording(reach(0.25), reach(-0.25))
    values = distances.features.values.copy()
    values[begins[0] : begins[0] + 45] = np.nan
    assert found_in(Distances(distances.features.replace(values=values))) == []


@pytest.mark.parametrize("seed", range(5))
def test_no_two_moves_share_a_moment(seed):
    rng = np.random.default_rng(seed)
    parts = [reach(rng.uniform(-0.4, 0.4), rng.integers(30, 60)) for _ in range(6)]
    distances, _ = recording(*parts, gap=int(rng.integers(5, 40)))
    spans = sorted(span for spans in found_in(distances) for span in spans)
    assert spans
    assert all(before[1] <= after[0] for before, after in pairwise(spans))


def test_of_too_many_moves_those_far_apart_are_not_compared_and_that_is_told(monkeypatch):
    other = np.roll(reach(0.3), 3, axis=1)
    distances, _ = recording(reach(0.25), reach(-0.25), np.zeros((400, 9)), other, gap=40)
    assert len(found_in(distances)) == 1
    alike = likeness(distances, max_distance=CRITERIA.max_distance, min_amplitude=CRITERIA.min_amplitude)
    assert moves_of(distances, alike, CRITERIA).limits == {}
    monkeypatch.setattr(moves, "MOST", 0)
    seen = moves_of(distances, alike, CRITERIA)
    assert seen.limits == {"moves_compared_within_s": moves.WITHIN_S}
    assert len(seen.returns) == 1
    monkeypatch.setattr(moves, "WITHIN_S", 0.5)
    assert moves_of(distances, alike, CRITERIA).returns == []


def test_near_pairs_are_those_of_the_twin(rng):
    values = rng.normal(size=(120, 6)).cumsum(axis=0)
    distances = Distances(FeatureSequence(values, ("a", "b"), 30.0, ("place",), 3))
    spans = np.sort(rng.integers(0, 120, (40, 2)), axis=1)
    spans = spans[spans[:, 1] - spans[:, 0] > 5]
    limit, loose = 6.0, 8.0
    spans, every = spans[np.argsort(spans[:, 0])], np.array((0, 120))
    pairs, costs, _ = _whole_kernels.near_pairs(
        distances.across, spans, 0, len(spans), every, 3, limit, loose, 2.0
    )
    d = distances.between(range(120), range(120)).astype(float)
    expected = twin.near_pairs(d, spans.tolist(), limit, loose, 2.0)
    assert expected
    assert {tuple(pair) for pair in pairs.tolist()} == set(expected)
    assert costs == pytest.approx([expected[tuple(pair)] for pair in pairs.tolist()])
    soon = np.array((10, 30))
    some, _, _ = _whole_kernels.near_pairs(distances.across, spans, 0, len(spans), soon, 3, limit, loose, 2.0)
    lags = spans[pairs[:, 1], 0] - spans[pairs[:, 0], 0]
    assert np.array_equal(some, pairs[(lags >= 10) & (lags < 30)])
    assert 0 < len(some) < len(pairs)
