"""Compare a recording with its own mirror image: features, bias and double metric in one call."""

from __future__ import annotations

import math
from typing import NamedTuple

from leitmotion.body import mirror_role
from leitmotion.describing import Recording, Roles, known_weights
from leitmotion.features import SideBias, active_weights, averaged, extract, side_bias, without_bias
from leitmotion.motion import ParameterError
from leitmotion.similarity import DoubleMetric, double_metric

COMPARED_RATE = 30.0
"""Moments per second that are compared."""
MOST_MOMENTS = 6000
"""Moments that are compared at most: 288 MB for both matrices."""
SPREAD_S = 0.04
"""Over which postures are averaged, so that noise of single frames does not count: a standard deviation, seconds."""
BIASES = ("none", "mean", "standing")


class Mirrored(NamedTuple):
    """A recording beside its mirror image."""

    distances: DoubleMetric
    """D and D* of the moments that were compared, with the β of their likeness."""

    every: int
    """A moment is so many frames of the recording."""

    bias: SideBias | None
    """The bias of the sides that was taken out; None where none was."""


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
    bias : {"none", "mean", "standing"}
        By which posture the bias of the sides is measured and taken out (:func:`leitmotion.features.side_bias`).
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
    taken = None if bias == "none" else side_bias(chain, pose=bias)
    if taken is not None:
        chain = without_bias(chain, taken)
    shares = None
    if weights == "active":
        own = active_weights(chain)
        shares = (own + own[[chain.names.index(mirror_role(name)) for name in chain.names]]) / 2
    drawn = max(1, round(chain.rate / COMPARED_RATE))
    every = drawn * math.ceil(len(chain) / drawn / MOST_MOMENTS)
    chain = averaged(chain, SPREAD_S)
    return Mirrored(double_metric(chain[::every], metric=metric, weights=shares, beta=beta), every, taken)
