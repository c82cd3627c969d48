"""Averaging: postures over a moment, so that the noise of single frames does not count."""

from __future__ import annotations

import numpy as np

from leitmotion.features.sequence import FeatureSequence


def averaged(chain: FeatureSequence, spread_s: float) -> FeatureSequence:
    """Average each posture of a kinematic chain with those around it.

    Parameters
    ----------
    chain : FeatureSequence
        Unit quaternions, T frames.
    spread_s : float
        Standard deviation of the bell of weights, seconds.

    Returns
    -------
    FeatureSequence
        Unit quaternions of the same rotations, free of what changes from frame to frame; NaN where they were.

    Examples
    --------
    >>> still = FeatureSequence([[1.0, 0, 0, 0]] * 9, ("pelvis",), 30.0, width=4)
    >>> averaged(still, 0.05) == still
    True
    """
    from scipy.ndimage import gaussian_filter1d

    spread = spread_s * chain.rate
    values = chain.values.reshape(len(chain), -1, chain.width)
    seen = np.isfinite(values)
    filled = np.where(seen, values, 0.0)
    turned = np.where(np.einsum("tji,tji->tj", filled[1:], filled[:-1]) < 0, -1.0, 1.0)
    sign = np.cumprod(np.concatenate((np.ones((1, filled.shape[1])), turned)), axis=0)[..., None]
    summed = gaussian_filter1d(filled * sign, spread, axis=0, mode="nearest") * sign
    length = np.linalg.norm(summed, axis=-1, keepdims=True)
    mean = np.divide(summed, length, out=np.full_like(summed, np.nan), where=seen & (length > 0))
    return chain.replace(values=mean.reshape(chain.values.shape))
