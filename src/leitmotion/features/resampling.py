"""Bring a feature sequence to another rate, so that every recording is searched at one pace."""

from __future__ import annotations

import numpy as np

from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import ParameterError


def resample(features: FeatureSequence, rate: float) -> FeatureSequence:
    """Interpolate linearly between frames.

    Parameters
    ----------
    features : FeatureSequence
        T frames.
    rate : float
        Frames per second wanted.

    Returns
    -------
    FeatureSequence
        The same span of time, first frame on first frame; NaN wherever a neighbour is NaN.

    Raises
    ------
    ParameterError
        When the rate is not positive and finite.

    Examples
    --------
    >>> ramp = FeatureSequence([[0.0], [1.0], [2.0], [3.0]], ("x",), rate=60)
    >>> resample(ramp, 30).values.ravel().tolist()
    [0.0, 2.0]
    """
    if not 0 < rate < np.inf:
        raise ParameterError(f"rate must be a positive and finite number of hertz, got {rate}.")
    frames = len(features)
    if frames < 2 or rate == features.rate:
        return features.replace(rate=features.rate if frames < 2 else rate)
    count = int(np.floor((frames - 1) * rate / features.rate + 1e-6)) + 1
    place = np.minimum(np.arange(count) * features.rate / rate, frames - 1)
    before = np.minimum(place.astype(np.int64), frames - 2)
    share = (place - before)[:, None]
    values = features.values
    mixed = np.where(share == 0, values[before], (1 - share) * values[before] + share * values[before + 1])
    return features.replace(values=mixed, rate=rate)
