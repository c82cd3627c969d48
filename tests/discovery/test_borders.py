"""The loops over borders of movements against their twins."""

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter1d

from leitmotion.discovery import _border_kernels, overlay
from leitmotion.features import FeatureSequence
from leitmotion.similarity import Distances, align, self_distance
from oracles import borders as twin


@pytest.fixture
def wandering(rng):
    """Distances of slow movement of which not all was seen, and all of them."""
    values = gaussian_filter1d(rng.normal(size=(300, 9)), 6, axis=0)
    values[100:110] = np.nan
    values[200:220, :3] = np.nan
    features = FeatureSequence(values, ("a", "b", "c"), 30.0, ("place",), 3)
    return Distances(features), self_distance(features).values


def test_postures_beside_borders_are_compared_as_the_twin_says(wandering, rng):
    distances, D = wandering
    beside, others = np.array([-12, -4, 0, 4, 12]), rng.integers(-10, 310, 60)
    for frame in rng.integers(0, 300, 20).tolist():
        apart = np.empty(len(others))
        _border_kernels.around(distances.across, 3, frame, others, beside, apart)
        expected = [twin.around(D, frame, other, beside) for other in others.tolist()]
        np.testing.assert_allclose(apart, expected, rtol=1e-6)
        assert np.isfinite(apart).any()


@pytest.mark.parametrize("smooth", [0, 2, 8])
def test_pauses_are_those_of_the_twin(rng, smooth):
    speed = rng.normal(size=400)
    speed = np.abs(np.round(gaussian_filter1d(speed, smooth) if smooth else speed, 2)).astype(np.float32)
    speed[50:60] = 0
    share = np.float32(0.8)
    for reach, around in ((1, 1), (2, 4), (7, 15)):
        found = _border_kernels.pauses(speed, reach, around, share).tolist()
        assert found == twin.pauses(speed, reach, around, share)
        assert len(found) > 2


def test_what_closes_closes_for_the_twin(wandering, rng):
    distances, D = wandering
    told = []
    for _ in range(300):
        first, length = rng.integers((0, 115), (95, 210)), rng.integers(20, 85)
        path = first + np.arange(length)[:, None]
        limits = [np.float32(value) for value in (rng.uniform(0, 0.6), rng.uniform(0, 0.6), 0.35)]
        told.append(_border_kernels.closes(distances.across, 3, path, *limits, 6))
        assert told[-1] == twin.closes(D, path, *limits, 6)
    assert 0.1 < np.mean(told) < 0.9


def test_an_overlay_costs_what_an_alignment_of_what_was_seen_does(wandering, rng):
    _, D = wandering
    for _ in range(50):
        (i, j), (n, m) = rng.integers(0, 200, 2), rng.integers(12, 100, 2)
        apart = D[i : i + n, j : j + m]
        known = apart[:, ~np.isnan(apart).all(axis=0)]
        known = known[~np.isnan(apart).all(axis=1)]
        cost = align(np.where(np.isnan(known), np.float32(0.4), known)).cost
        assert overlay.overlay_cost(apart, 0.4) == cost
