"""Distances computed when asked for: to the bit those of the dense matrix."""

import numpy as np
import pytest

from leitmotion.features import FeatureSequence
from leitmotion.motion import ParameterError
from leitmotion.similarity import Distances, SimilarityMatrix, self_distance


@pytest.fixture(params=[(3, False), (3, True), (4, True), (1, False)], ids=str)
def postures(request, rng):
    width, gaps = request.param
    values = rng.normal(size=(80, 5 * width))
    if gaps:
        values[10:13] = np.nan
        values[20:30, : 2 * width] = np.nan
    return FeatureSequence(values, tuple("abcde"), 30.0, ("place",), width)


def test_any_block_is_that_of_the_dense_matrix(postures):
    dense = self_distance(postures).values
    distances = Distances(postures)
    np.testing.assert_array_equal(distances.between(range(3, 40), range(5, 80)), dense[3:40, 5:80])
    np.testing.assert_array_equal(distances.between(range(3, 40, 7), range(5, 80, 4)), dense[3:40:7, 5:80:4])


def test_any_path_is_that_of_the_dense_matrix(postures, rng):
    dense = self_distance(postures).values
    path = rng.integers(0, 80, (200, 2))
    np.testing.assert_array_equal(Distances(postures).along(path), dense[path[:, 0], path[:, 1]])


def test_a_band_holds_the_diagonals_of_the_dense_matrix(postures):
    dense = self_distance(postures).values
    band = Distances(postures).band(7)
    assert (band.kind, band.values.shape, band.row_rate) == ("banded", (80, 8), 30.0)
    for k in range(8):
        np.testing.assert_array_equal(band.values[: 80 - k, k], np.diagonal(dense, k))
        assert np.isnan(band.values[80 - k :, k]).all()


def test_a_matrix_of_another_kind_is_refused():
    with pytest.raises(ParameterError, match="one of dense, banded, got 'sparse'"):
        SimilarityMatrix(np.zeros((2, 2)), "mean_norm", 30, 30, kind="sparse")
