"""Weights of joints: those that move most say most about which movement it is.

References
----------
Paper P (Tang, Leung, Komura, Shum, 2008), section 4: a mean over all joints lets those that keep quiet outvote one that
moves; the authors propose larger weights for more active limbs.
"""

from __future__ import annotations

import numpy as np

from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import ParameterError

SPAN_S = (
    0.25  # seconds over which a movement is measured: longer than jitter, shorter than half a swing of an arm
)
LIVELY = 0.9  # quantile: a joint is as active as in the livelier moments of the recording
FLOOR = 0.25  # of an equal weight, which every joint keeps


def active_weights(features: FeatureSequence) -> np.ndarray:
    """Weigh each joint by how much it moves in a recording.

    Activity is how far a joint moves within a quarter of a second in the livelier moments of the recording: the upper
    tenth of them. So it counts how a limb moves while it moves, not how long; and what leaps for less than a tenth of
    the time, as a marker that is lost for a moment, changes little. Weights are in proportion to activity, above a
    floor of a quarter of an equal weight, so that no joint is without a say.

    Parameters
    ----------
    features : FeatureSequence
        T frames of M joints.

    Returns
    -------
    (M,) float
        At least 0.25 each, M in all; 1 each where nothing moves. They do not depend on the unit.

    Examples
    --------
    >>> wave = np.sin(np.arange(60) / 5)
    >>> hands = FeatureSequence(np.stack((wave, 0 * wave, wave), axis=1), ("a", "b", "c"), rate=30)
    >>> active_weights(hands).round(3).tolist()
    [1.375, 0.25, 1.375]
    """
    joints = len(features.names)
    span = max(1, round(SPAN_S * features.rate))
    places = features.values.reshape(len(features), joints, features.width)
    moved = np.linalg.norm(places[span:] - places[:-span], axis=2)
    activity = np.array([_lively(moved[:, m]) for m in range(joints)])
    total = activity.sum()
    if not total > 0:
        return np.ones(joints)
    return FLOOR + (1.0 - FLOOR) * joints * activity / total


def weighted(features: FeatureSequence, weights: np.ndarray) -> FeatureSequence:
    """Weigh the joints, so that the mean of norms (paper P, eq. 2) becomes a weighted mean of the same scale.

    Parameters
    ----------
    features : FeatureSequence
        T frames of M joints.
    weights : (M,) float
        0 or more; only their proportions count, as they are scaled to sum to M.

    Returns
    -------
    FeatureSequence
        The values of each joint times its weight, which `weights` tells. Quaternions are then no rotations any more:
        compare them by the mean of norms. Where a joint is unseen, the mean is over the others with their weights.

    Raises
    ------
    ParameterError
        When there is not one weight a joint, one is negative or not finite, or all are 0.

    Examples
    --------
    >>> hands = FeatureSequence([[1.0, 1.0]], ("left_hand", "right_hand"), rate=30)
    >>> weighted(hands, [1, 3]).values.tolist()
    [[0.5, 1.5]]
    """
    scaled = np.asarray(weights, dtype=np.float64)
    if scaled.shape != (len(features.names),):
        raise ParameterError(f"Each of the {len(features.names)} joints has one weight, got {scaled.shape}.")
    if not (np.isfinite(scaled).all() and (scaled >= 0).all() and scaled.sum() > 0):
        raise ParameterError(f"Weights are 0 or more, finite and not all 0, got {scaled.tolist()}.")
    scaled = scaled * len(scaled) / scaled.sum()
    before = features.weights or np.ones(len(scaled))
    values = features.values * np.repeat(scaled, features.width)
    return features.replace(values=values, weights=tuple((before * scaled).tolist()))


def _lively(moved: np.ndarray) -> float:
    seen = moved[np.isfinite(moved)]
    return float(np.quantile(seen, LIVELY)) if seen.size else 0.0
