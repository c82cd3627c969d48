"""Balance: whether a recording does the same to both sides, so that its mean posture tells how a suit sits askew."""

from __future__ import annotations

import numpy as np

from leitmotion.features import FeatureSequence, SideBias, side_bias, without_bias
from leitmotion.similarity.mirror import double_metric, link_angle

SAMPLED = 500  # moments that are compared
NEAR = 0.45  # of the usual angle between two moments: so near half the moments come to the mirror image of another


def balanced_bias(chain: FeatureSequence) -> SideBias | None:
    """Measure the bias of the sides in the mean posture, where a recording tells that it is bias and no movement.

    It is, where half of the way leads past moments whose mirror image comes back in the recording (both sides do the
    same, together or by turns), no link's sides differ by more than 20 degrees, and mirror images are nearer without
    it: in the lower, the middle and the upper quarter. What one side does alone comes back with no other, and to shift
    the sides of a recording in which they are even puts its mirror images farther off.

    Parameters
    ----------
    chain : FeatureSequence
        A kinematic chain with both sides (:func:`leitmotion.features.kinematic_chain`), T frames.

    Returns
    -------
    SideBias or None
        To be taken out by :func:`leitmotion.features.without_bias`; None where nothing should be.

    Raises
    ------
    ParameterError
        When the features are no chain with both sides.
    DataError
        When a link is never seen.

    Examples
    --------
    >>> from leitmotion.datasets import compose_motif
    >>> from leitmotion.features import kinematic_chain
    >>> balanced_bias(kinematic_chain(compose_motif("limping", seed=0).motion)) is None
    True
    """
    bias = side_bias(chain)
    if bias.too_large:
        return None
    sample = chain[:: max(1, len(chain) // SAMPLED)]
    along = along_the_way(sample)
    before, usual = _nearest(sample, along)
    after, _ = _nearest(without_bias(sample, bias), along)
    return bias if before[1] < NEAR * usual and (after < before).all() else None


def along_the_way(chain: FeatureSequence) -> np.ndarray:
    """Take moments at even steps of the way, not of time: a posture that is held counts no more than another.

    Parameters
    ----------
    chain : FeatureSequence
        T moments.

    Returns
    -------
    (T,) int
        Moments in order, some more than once.
    """
    steps = np.nan_to_num(np.linalg.norm(np.diff(chain.values, axis=0), axis=1))
    way = np.concatenate(([0.0], np.cumsum(steps)))
    return np.searchsorted(way, np.linspace(0.0, way[-1], len(way)), side="left").clip(0, len(way) - 1)


def _nearest(chain: FeatureSequence, along: np.ndarray) -> tuple[np.ndarray, float]:
    """Quartiles of the angle to the nearest mirror image, and the usual angle between two moments, radians."""
    found = double_metric(chain)
    mirror, own = (
        link_angle(np.nan_to_num(each, nan=1.0), found.metric) for each in (found.mirror, found.own)
    )
    return np.percentile(mirror.min(axis=1)[along], (25.0, 50.0, 75.0)), float(np.median(own))
