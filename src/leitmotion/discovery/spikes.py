"""Strikes: fast movements that are stopped or thrown back at once, spikes across the identity axis.

Conventions
-----------
Three postures a tenth of a second apart span a triangle whose sides stand in D. The way before and the way after tell
how fast the body comes and goes, the third side how much of the one the other takes back.

References
----------
Paper S, section 3.6.3: the identity axis thins towards a strike, and at the impact the path reverses, which shows as an
inversion spike perpendicular to the axis.
"""

from __future__ import annotations

import numpy as np

from leitmotion.discovery.waypoints import angles
from leitmotion.similarity import DoubleMetric

APART_S = 0.1  # between two of the three postures, seconds
FAST = np.radians(140.0)  # a second, of a mean link before the impact; a walk is slower
BRAKED = np.radians(
    180.0
)  # a second, by which the movement is braked from before to after; a jumping jack turns more slowly
ONWARD = 0.15  # of the speed before, that may go on afterwards


def find_strikes(found: DoubleMetric) -> np.ndarray:
    """Find the moments at which a fast movement is stopped or thrown back at once.

    Parameters
    ----------
    found : DoubleMetric
        T moments, 20 a second or more; of fewer nothing is told.

    Returns
    -------
    (N,) int
        Moments, in order.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> from leitmotion.features import kinematic_chain
    >>> from leitmotion.similarity import double_metric
    >>> chain = kinematic_chain(compose_session(seed=0, rate=30.0).motion)
    >>> bool((np.diff(find_strikes(double_metric(chain))) > 0).all())
    True
    """
    apart = round(APART_S * found.rate)
    count = len(found)
    if apart < 2 or count <= 2 * apart:
        return np.zeros(0, dtype=np.int64)
    at = np.arange(apart, count - apart)
    before, after, whole = (
        angles(found.own[one, other].astype(np.float64), found.metric)
        for one, other in ((at - apart, at), (at, at + apart), (at - apart, at + apart))
    )
    seconds = apart / found.rate
    speed = before / seconds
    onward = (whole**2 - before**2 - after**2) / (2 * np.maximum(before, FAST * seconds)) / seconds
    braked = speed - onward
    around = np.lib.stride_tricks.sliding_window_view(
        np.pad(braked, apart, constant_values=-1), 2 * apart + 1
    )
    struck = (
        (speed >= FAST)
        & (onward <= ONWARD * speed)
        & (braked >= BRAKED)
        & (np.argmax(around, axis=1) == apart)
    )
    strikes: np.ndarray = at[struck]
    return strikes
