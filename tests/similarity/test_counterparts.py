"""The most alike moment of each, and how much is alike: by definition, with what is unseen left out."""

import numpy as np
import pytest

from leitmotion.motion import ParameterError
from leitmotion.similarity import SimilarityMatrix, counterparts, shares_alike


def test_they_are_what_the_definition_says(rng):
    values = rng.random((700, 700)).astype(np.float32)
    values[rng.random(values.shape) < 0.2] = np.nan
    values[3] = np.nan
    values[:, 3] = np.nan
    matrix = SimilarityMatrix(values, "mean_norm", 10.0, 10.0)
    found = counterparts(matrix, apart_s=2.0)
    shares = shares_alike(matrix, 0.3)
    assert found.places[3] == -1
    assert np.isnan([found.distances[3], shares[3]]).all()
    for i in (0, 5, 300, 511, 512, 699):
        others = [j for j in range(700) if abs(i - j) >= 20 and np.isfinite(values[i, j])]
        nearest = min(others, key=lambda j: values[i, j])
        assert (found.places[i], found.distances[i]) == (nearest, values[i, nearest])
        known = values[i][np.isfinite(values[i])]
        assert shares[i] == pytest.approx((known <= 0.3).mean())


def test_a_recording_that_is_too_short_has_none():
    found = counterparts(SimilarityMatrix(np.zeros((5, 5)), "mean_norm", 30.0, 30.0), apart_s=1.0)
    assert found.places.tolist() == [-1] * 5


def test_a_band_is_refused():
    band = SimilarityMatrix(np.zeros((5, 2)), "mean_norm", 30.0, 30.0, kind="banded")
    with pytest.raises(ParameterError, match="All distances have to be there, and this matrix is banded"):
        counterparts(band)
