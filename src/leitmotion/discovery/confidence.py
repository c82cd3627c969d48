"""Confidence: how likely a pattern is right, from what speaks for it.

Conventions
-----------
A pattern is *right* when at least 80 % of its pairs join two stretches of one action, by the protocol of
:mod:`leitmotion.evaluation.patterns`. The weights were fitted by logistic regression on recordings of a few people
(``python benchmarks/fit_confidence.py`` prints them, and how well they hold on each actor when fitted on the others).
How often it holds on other people is measured by ``benchmarks/bench_confidence.py``, for postures with equal weights
in one recording. Elsewhere (other features, active
weights, several recordings) it is the same number, unmeasured.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

# of the logistic regression, in the order of Evidence
CONSTANT, CONTRAST, APART, LENGTH = 2.20, 0.67, -1.38, 0.74
FARTHEST = 2.0  # times the distance of what is alike: farther counts as this


class Evidence(NamedTuple):
    """What speaks for a pattern."""

    contrast: float
    """How much nearer than their surroundings its stripes are on average, 0 to 1."""

    apart: float
    """Mean distance of its occurrences along their warping paths, in distances of what is alike to the look that found
    it."""

    seconds: float
    """Median length of an occurrence."""


def confidence(evidence: Evidence) -> float:
    """Tell how likely a pattern is right.

    Parameters
    ----------
    evidence : Evidence
        What speaks for it.

    Returns
    -------
    float
        Probability, 0 to 1.

    Examples
    --------
    >>> clear, faint = Evidence(0.9, 0.3, 2.0), Evidence(0.3, 1.0, 0.6)
    >>> confidence(clear) > confidence(faint)
    True
    """
    z = CONSTANT + float(np.dot((CONTRAST, APART, LENGTH), predictors(evidence)))
    return float(1.0 / (1.0 + np.exp(-z)))


def predictors(evidence: Evidence) -> tuple[float, float, float]:
    """What the regression takes: contrast, distance up to a limit, logarithm of the length in seconds.

    Parameters
    ----------
    evidence : Evidence
        What speaks for a pattern.

    Returns
    -------
    (float, float, float)
        One number for each.
    """
    return evidence.contrast, min(evidence.apart, FARTHEST), float(np.log(max(evidence.seconds, 1e-3)))
