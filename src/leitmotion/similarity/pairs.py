"""Distances of single pairs of moments, where a matrix of all would be waste."""

from __future__ import annotations

import numpy as np

from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import ParameterError
from leitmotion.similarity.distance import check_comparable


def pair_distances(
    a: FeatureSequence, frames_a: np.ndarray, b: FeatureSequence, frames_b: np.ndarray
) -> np.ndarray:
    """Compare moments pair by pair: paper P, eq. 2, as in :func:`leitmotion.similarity.self_distance`.

    Parameters
    ----------
    a, b : FeatureSequence
        (N, D) and (M, D) values with the same names and width; may be the same.
    frames_a, frames_b : (K,) int
        The moment of each pair in `a`, and in `b`.

    Returns
    -------
    (K,) float
        Mean over the groups of the norms of their differences. A group with NaN in either frame is left out; NaN where
        the two frames share no group. Of quaternions (``width`` 4) the nearer of q and -q counts, as the sign of one
        is chosen in each recording for itself.

    Raises
    ------
    ParameterError
        When the two do not hold the same features, or a frame is outside.

    Examples
    --------
    >>> hand = FeatureSequence([[0, 0, 0], [3, 4, 0]], ("hand",), rate=60, width=3)
    >>> pair_distances(hand, [0, 1], hand, [1, 1]).tolist()
    [5.0, 0.0]
    """
    check_comparable(a, b)
    one, other = _groups(a, frames_a), _groups(b, frames_b)
    if len(one) != len(other):
        raise ParameterError(f"Pairs have two frames each, got {len(one)} and {len(other)}.")
    apart = np.linalg.norm(one - other, axis=2)
    if a.width == 4:
        apart = np.minimum(apart, np.linalg.norm(one + other, axis=2))
    seen = np.isfinite(apart)
    count = seen.sum(axis=1)
    total = np.where(seen, apart, 0.0).sum(axis=1)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def _groups(features: FeatureSequence, frames: np.ndarray) -> np.ndarray:
    chosen = np.asarray(frames, dtype=np.int64)
    if chosen.size and (chosen.min() < 0 or chosen.max() >= len(features)):
        raise ParameterError(f"Frames are 0 to {len(features) - 1}, got {chosen.min()} to {chosen.max()}.")
    return features.values[chosen].reshape(len(chosen), len(features.names), features.width)
