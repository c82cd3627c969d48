"""Evening: taking out how a suit sits askew, told by movements that come back as their own mirror image.

A suit that sits askew turns a link by a constant, whatever the posture. Where each moment of a recording has another
that is nearly its mirror image, and they differ by the same turns throughout, that is how the suit sits; where they
differ now in one way, now in another, it is how the body moves, and nothing is taken out.
"""

from __future__ import annotations

import numpy as np

from leitmotion.features import FeatureSequence, SideBias, mirrored, without_bias
from leitmotion.motion.rotations import IDENTITY, conjugate, from_rotation_vector, multiply
from leitmotion.similarity import along_the_way, double_metric

SAMPLED = 500  # moments that are compared
ROUNDS = 4
LARGEST = np.radians(16.0)  # between a link and the image of its partner; more is the posture's
SHARE = 75.0  # percentile of the way that has to come back
EVEN = 0.6  # of what it was, to which the difference sinks where it was the suit's


def matched_bias(chain: FeatureSequence) -> SideBias | None:
    """Measure how a suit sits askew by the moments of a recording that are nearly mirror images of one another.

    Parameters
    ----------
    chain : FeatureSequence
        A kinematic chain with both sides, smooth.

    Returns
    -------
    SideBias or None
        What to take out; None where moments and images do not differ by the same throughout.
    """
    sample = chain[:: max(1, len(chain) // SAMPLED)]
    along = along_the_way(sample)
    links = len(chain.names)
    bias = SideBias(chain.names, np.tile(IDENTITY, (links, 1)), np.zeros(links), "matched", len(sample))
    tried: list[tuple[SideBias, float]] = []
    for _ in range(ROUNDS + 1):
        even = without_bias(sample, bias)
        apart = np.nan_to_num(double_metric(even).mirror, nan=1.0)
        tried.append((bias, float(np.percentile(apart.min(axis=1)[along], SHARE))))
        bias = bias.replace(turns=multiply(bias.turns, _halves(even, apart.argmin(axis=1), along)))
    (_, before), (last, after) = tried[0], tried[-1]
    if not after < EVEN**2 * before:
        return None
    angles = 4.0 * np.arccos(np.clip(np.abs(last.turns[:, 0]), 0.0, 1.0))  # a turn is half of what differs
    return last.replace(angles=angles)


def _halves(chain: FeatureSequence, match: np.ndarray, along: np.ndarray) -> np.ndarray:
    """Half of the turn from each link to the mirror image of its partner in the moment that matches."""
    image = mirrored(chain)
    assert image is not None
    own, other = (each.values.reshape(len(chain), -1, 4) for each in (chain, image))
    turn = multiply(conjugate(own[along]), other[match[along]])
    turn = turn * np.where(turn[..., :1] < 0, -1.0, 1.0)
    vectors = 2.0 * turn[..., 1:] * _scale(turn[..., :1])
    middle = np.zeros(vectors.shape[1:])
    seen = np.isfinite(vectors).all(axis=2).any(axis=0)
    middle[seen] = np.nanmedian(vectors[:, seen], axis=0)
    middle[np.linalg.norm(middle, axis=1) > LARGEST] = 0.0
    return from_rotation_vector(middle / 2.0)


def _scale(cosine: np.ndarray) -> np.ndarray:
    """What makes of the vector part of a quaternion half its rotation vector."""
    half = np.arccos(np.clip(cosine, -1.0, 1.0))
    return np.where(half < 1e-6, 1.0, half / np.maximum(np.sin(half), 1e-6))
