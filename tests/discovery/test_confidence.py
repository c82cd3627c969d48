"""Confidence: a probability that rises with what speaks for a pattern."""

from itertools import pairwise

import numpy as np
import pytest

from leitmotion.discovery.confidence import FARTHEST, Evidence, confidence

FITTED = (2.20, 0.67, -1.38, 0.74)
"""As ``python benchmarks/fit_confidence.py`` prints it."""
MIDDLE = Evidence(contrast=0.6, apart=0.8, seconds=1.5)


def confidences(what, values):
    return [confidence(MIDDLE._replace(**{what: value})) for value in values]


@pytest.mark.parametrize(("what", "values"), [("contrast", (0, 0.3, 0.7, 1)), ("seconds", (0.3, 0.6, 2, 9))])
def test_what_is_clearer_or_longer_is_surer(what, values):
    assert all(before < after for before, after in pairwise(confidences(what, values)))


def test_what_is_farther_apart_is_less_sure_up_to_a_limit():
    told = confidences("apart", (0, 0.5, 1, FARTHEST))
    assert all(before > after for before, after in pairwise(told))
    assert confidences("apart", (10 * FARTHEST,)) == told[-1:]


@pytest.mark.parametrize("seconds", [0, 1e-6, 0.5, 3600])
@pytest.mark.parametrize("apart", [0, 1, 100])
@pytest.mark.parametrize("contrast", [0, 1])
def test_it_is_a_probability(contrast, apart, seconds):
    assert 0 < confidence(Evidence(contrast, apart, seconds)) < 1


def test_it_is_the_logistic_function_of_the_fitted_weights():
    z = np.dot(FITTED, (1, MIDDLE.contrast, MIDDLE.apart, np.log(MIDDLE.seconds)))
    assert confidence(MIDDLE) == pytest.approx(1 / (1 + np.exp(-z)))
