"""A recording beside its mirror image, in one call."""

import numpy as np
import pytest

import leitmotion as lm


def test_bias_weights_and_rate_are_as_asked():
    motion = lm.compose_session(seed=3, rate=60.0).motion
    plain = lm.compare_with_mirror(motion)
    assert (plain.every, plain.bias, plain.distances.rate) == (2, None, 30.0)
    active = lm.compare_with_mirror(motion, weights="active", bias="mean", beta=50.0)
    weights = dict(zip(active.distances.names, active.distances.weights, strict=True))
    assert weights["left_humerus"] == weights["right_humerus"] > weights["lower_neck"]
    assert (active.bias.pose, active.bias.frames, active.distances.beta) == ("mean", len(motion), 50.0)
    assert not np.array_equal(active.distances.own, plain.distances.own)


def test_an_unknown_bias_is_refused():
    with pytest.raises(lm.ParameterError, match="bias must be one of none, mean, standing, got 'some'"):
        lm.compare_with_mirror(lm.compose_session(seed=3, rate=30.0).motion, bias="some")
