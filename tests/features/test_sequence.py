"""Feature sequence: rows with a rate, cut along time."""

import numpy as np
import pytest

from leitmotion.features import FeatureSequence
from leitmotion.motion import ParameterError


def test_a_step_divides_the_rate():
    features = FeatureSequence(np.arange(30.0).reshape(10, 3), ("head",), rate=120, width=3)
    assert len(features[2:8:2]) == 3
    assert features[2:8:2].rate == 60
    assert np.array_equal(features[2:8:2].values, features.values[2:8:2])


@pytest.mark.parametrize(
    ("values", "width", "says"), [(np.zeros((10, 4)), 3, "shape"), (np.zeros((10, 0)), 0, "width")]
)
def test_width_times_names_is_the_number_of_values(values, width, says):
    with pytest.raises(ParameterError, match=says):
        FeatureSequence(values, ("head",), rate=120, width=width)


def test_there_is_a_weight_for_each_name_or_none():
    features = FeatureSequence(np.zeros((4, 6)), ("head", "neck"), rate=120, width=3)
    assert features.weights == ()
    assert features.replace(weights=np.array([1, 2]))[::2].weights == (1.0, 2.0)
    with pytest.raises(ParameterError, match="each of the 2 names or none, got 3"):
        features.replace(weights=(1.0, 1.0, 1.0))
