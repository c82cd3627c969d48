"""What the sides differ by for long is taken out as the definition says."""

import numpy as np
import pytest

from leitmotion.discovery import sides
from oracles import sides as twin


@pytest.mark.parametrize("lasting", [0.02, 0.3])
def test_it_is_what_the_definition_says(rng, lasting):
    """With a part that lasts and is taken out whole, and with one of which 10 degrees are."""
    count = 120
    symmetric, antisymmetric = 0.02 * rng.normal(size=(2, count, 3)).cumsum(axis=1)
    antisymmetric += lasting

    def squares(a, b):
        return ((a[:, None] - b) ** 2).sum(axis=-1)

    own = np.sqrt(squares(symmetric, symmetric) + squares(antisymmetric, antisymmetric))
    mirror = np.sqrt(squares(symmetric, symmetric) + squares(antisymmetric, -antisymmetric))
    products = sides.antisymmetric(own, mirror)
    assert np.allclose(products, antisymmetric @ antisymmetric.T)
    since = np.maximum(np.arange(count) - rng.integers(1, 30, count), 0)
    until = np.minimum(np.arange(count) + rng.integers(1, 30, count), count)
    found = sides.without_lasting(own, products, since, until)
    exact = twin.without_lasting(
        own, products, since, until, largest=sides.LARGEST, left_over=sides.LEFT_OVER, nearest=sides.NEAREST
    )
    assert found.dtype == np.float32
    assert np.abs(found**2 - exact**2).max() < 1e-6
    assert found.max() > 0.05


def test_a_recording_of_nothing_has_none():
    nothing = np.zeros((0, 0))
    assert sides.without_lasting(nothing, nothing, np.zeros(0, int), np.zeros(0, int)).shape == (0, 0)
