"""Compare a recording with itself, with another, or with its own mirror image, in one call."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from leitmotion.body import mirror_role
from leitmotion.describing import Recording, Roles, described, known_weights, only, weighed
from leitmotion.features import (
    FeatureSequence,
    SideBias,
    active_weights,
    averaged,
    extract,
    side_bias,
    without_bias,
)
from leitmotion.motion import DataError, ParameterError
from leitmotion.similarity import (
    DoubleMetric,
    SimilarityMatrix,
    balanced_bias,
    cross_distance,
    double_metric,
    self_distance,
)

COMPARED_RATE = 30.0
"""Moments per second that are compared."""
MOST_MOMENTS = 6000
"""Moments that are compared at most: 288 MB for both matrices."""
SPREAD_S = 0.04
"""Over which postures are averaged, so that noise of single frames does not count: a standard deviation, seconds."""
BIASES = ("none", "auto", "mean", "standing")


class Mirrored(NamedTuple):
    """A recording beside its mirror image."""

    distances: DoubleMetric
    """D and D* of the moments that were compared, with the β of their likeness."""

    every: int
    """So many frames of the recording are a moment."""

    bias: SideBias | None
    """The bias of the sides that was taken out; None where none was."""

    chain: FeatureSequence
    """The kinematic chain at those moments, without the bias."""


def compare(
    recording: Recording,
    other: Recording | None = None,
    *,
    features: str = "posture",
    weights: str = "equal",
    joints: str | Sequence[str] | None = None,
    exclude: str | Sequence[str] | None = None,
    body_map: Roles | None = None,
    other_map: Roles | None = None,
) -> SimilarityMatrix:
    """Compare every moment of a recording with every other, or with every moment of another (paper P, eq. 2).

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person.
    other : Motion, Trajectories or Body, optional
        Another, of whom the same joints are compared, those that both have.
    features, weights, joints, exclude
        As for :func:`leitmotion.find_patterns`. Two recordings are compared with equal weights only.
    body_map, other_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, when the names do not tell.

    Returns
    -------
    SimilarityMatrix
        Rows are moments of `recording`, about 30 a second, fewer of one that is long: a moment is the frame at
        ``recording.rate / matrix.row_rate`` times its number.

    Raises
    ------
    ParameterError
        When a role, the features or the weights are unknown, or do not fit.
    DataError
        When nothing tells how large a body is, or two recordings share no joint.

    Examples
    --------
    >>> import leitmotion as lm
    >>> session = lm.compose_session(seed=0, rate=30.0).motion
    >>> lm.compare(session[:90], session[:60]).values.shape
    (90, 60)
    """
    told = described(recording, features, joints=joints, exclude=exclude, body_map=body_map)
    if other is None:
        return self_distance(_thinned(weighed(told, weights)))
    if known_weights(weights) != "equal":
        raise ParameterError("Two recordings are compared with equal weights.")
    beside = described(other, features, joints=joints, exclude=exclude, body_map=other_map)
    common = tuple(name for name in told.names if name in beside.names)
    if not common:
        raise DataError("The two recordings share no joint to compare.")
    return cross_distance(_thinned(only(told, common)), _thinned(only(beside, common)))


def compare_with_mirror(
    recording: Recording,
    *,
    metric: str = "inner",
    weights: str = "equal",
    bias: str = "none",
    beta: float | None = None,
    body_map: Roles | None = None,
) -> Mirrored:
    """Compare every moment of a recording with every other, and with the mirror image of every other (paper S).

    Parameters
    ----------
    recording : Motion, Trajectories or Body
        One person in three dimensions.
    metric : {"inner", "geodesic"}
        The cost of paper S, or the angle (:func:`leitmotion.similarity.double_metric`).
    weights : {"equal", "active"}
        Whether each link counts alike, or the more the more it moves; both sides count alike.
    bias : {"none", "auto", "mean", "standing"}
        By which posture the bias of the sides is measured and taken out (:func:`leitmotion.features.side_bias`). "auto"
        takes the mean one where the recording does the same to both sides
        (:func:`leitmotion.similarity.balanced_bias`), else takes nothing out.
    beta : float, optional
        The sensitivity of the likeness; by default it is chosen from the recording.
    body_map : BodyMap or mapping of str, optional
        Which joints or markers stand for which role, when the names do not tell.

    Returns
    -------
    Mirrored
        About 30 moments a second are compared, fewer of a recording that is long; each posture is averaged with those
        around it, over a tenth of a second.

    Raises
    ------
    ParameterError
        When an option is unknown.
    DataError
        When the recording is planar, its trunk or a side is unknown, or nobody stands still.

    Examples
    --------
    >>> import leitmotion as lm
    >>> mirrored = lm.compare_with_mirror(lm.compose_session(seed=0, rate=30.0).motion, bias="standing")
    >>> mirrored.bias.pose, mirrored.every
    ('standing', 1)
    """
    if bias not in BIASES:
        raise ParameterError(f"bias must be one of {', '.join(BIASES)}, got {bias!r}.")
    known_weights(weights)
    chain = extract("kinematic_chain", recording, body_map)
    taken = None
    if bias == "auto":
        taken = balanced_bias(averaged(chain, SPREAD_S))
    elif bias != "none":
        taken = side_bias(chain, pose=bias)
    if taken is not None:
        chain = without_bias(chain, taken)
    shares = None
    if weights == "active":
        own = active_weights(chain)
        shares = (own + own[[chain.names.index(mirror_role(name)) for name in chain.names]]) / 2
    moments, every = _thinned(averaged(chain, SPREAD_S)), _every(chain)
    return Mirrored(double_metric(moments, metric=metric, weights=shares, beta=beta), every, taken, moments)


def _thinned(features: FeatureSequence) -> FeatureSequence:
    return features[:: _every(features)]


def _every(features: FeatureSequence) -> int:
    """How many frames a moment is."""
    drawn = max(1, round(features.rate / COMPARED_RATE))
    return drawn * max(1, math.ceil(len(features) / drawn / MOST_MOMENTS))
