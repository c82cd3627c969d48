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


def test_what_surrounds_a_long_movement_is_sampled(monkeypatch):
    distances, begins = recording(reach(0.1, 600), reach(0.1, 600), reach(0.1, 600))
    asked = []
    between = Distances.between
    monkeypatch.setattr(
        Distances, "between", lambda self, *sides: asked.append(sides) or between(self, *sides)
    )
    item = Return([(float(a), a + 600.0) for a in begins[:2]], [], np.zeros((0, 2)), 1.0)
    taken = np.zeros(len(distances), bool)
    (found,) = with_lone_occurrences([item], taken, distances, max_distance=0.054, min_contrast=0.3)
    assert len(found.spans) == 3
    around = [len(rows) * len(columns) for rows, columns in asked if max(rows.step, columns.step) > 1]
    assert 0 < max(around) <= SAMPLED**2


def test_courses_are_those_of_the_twin(rng):
    values = rng.normal(size=(40, 6)).cumsum(axis=0)
    distances = Distances(FeatureSequence(values, ("a", "b"), 30.0, ("place",), 3))
    costs, begins = _whole_kernels.courses(distances.across, 0, 7, 10, 40, 3, 1.0)
    d = distances.between(range(0, 7), range(10, 40)).astype(float)
    for j in range(30):
        cost, begin = twin.course(d, j)
        assert costs[j] == pytest.approx(cost)
        if np.isfinite(cost):
            assert begins[j] == begin
