"""What is written down of a pattern, and what is left out of long ones."""

from itertools import combinations

import numpy as np
import pytest

from leitmotion.discovery import find_patterns, writing
from leitmotion.discovery.recurrence import USUAL
from leitmotion.features import FeatureSequence, resample
from leitmotion.motion import Segmentation
from leitmotion.similarity import Distances


@pytest.fixture(scope="module")
def swings():
    phase = 2 * np.pi * np.arange(8 * 30) / 30
    swing = np.stack([0.1 * (1 - np.cos(phase + 0.1 * k)) for k in range(9)], axis=1)
    values = np.concatenate((swing, np.tile(swing[0], (60, 1))))
    return FeatureSequence(values, tuple("abc"), 30.0, ("place",), 3)


@pytest.mark.parametrize("count", [2, 3, 11, 12, 40])
def test_all_pairs_are_compared_or_all_neighbours_and_some(count):
    compared = writing._compared(count)
    everyone = sorted(combinations(range(count), 2), key=lambda pair: pair[1] - pair[0])
    neighbours = {(k, k + 1) for k in range(count - 1)}
    if len(everyone) <= writing.COMPARED:
        assert [tuple(pair) for pair in compared.tolist()] == everyone
    else:
        assert neighbours < {tuple(pair) for pair in compared.tolist()} < set(everyone)
        assert writing.COMPARED // 2 <= len(compared) <= writing.COMPARED + count


def test_of_many_pairs_those_that_follow_soonest_are_written_and_the_rest_told(swings, monkeypatch):
    whole = find_patterns(swings)
    assert not {"pairs_left_out", "stripes_left_out"} & set(whole.parameters)
    monkeypatch.setattr(writing, "PAIRS", 10)
    monkeypatch.setattr(writing, "STRIPES", 2)
    some = find_patterns(swings)
    assert some.patterns == whole.patterns
    assert (len(some.pairs), some.parameters["pairs_left_out"]) == (10, len(whole.pairs) - 10)
    assert (len(some.stripes), some.parameters["stripes_left_out"]) == (2, len(whole.stripes) - 2)
    assert set(map(_paths, some.pairs)) < set(map(_paths, whole.pairs))
    lags = [pair.b[0] - pair.a[0] for pair in whole.pairs]
    assert max(pair.b[0] - pair.a[0] for pair in some.pairs) <= sorted(lags)[12]


@pytest.mark.parametrize("rate", [4.0, 20.0, 25.0, 30.0, 50.0, 59.94])
def test_occurrences_up_to_the_last_frame_are_laid_over_one_another_within_the_recording(rate):
    frames = np.arange(round(3 * rate) + 1)
    for end in (len(frames) - 1, len(frames)):
        swing = 0.3 * np.sin(2 * np.pi * frames[:end] / (1.5 * rate))
        features = FeatureSequence(np.outer(swing, np.ones(9)), tuple("abc"), rate, ("place",), 3)
        distances = Distances(resample(features, 30.0))
        scribe = writing.Scribe(features, distances, USUAL)
        halves = Segmentation([0, end - round(1.5 * rate)], [round(1.5 * rate), end], rate=rate)
        (path,) = scribe._between_occurrences(halves, []).values()
        assert path.max() < len(distances)


def _paths(pair):
    return tuple(pair.path.ravel().tolist())
