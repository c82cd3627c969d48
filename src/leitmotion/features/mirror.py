"""Mirror: the postures of the same movement performed with the other side."""

from __future__ import annotations

import numpy as np

from leitmotion.body import CHAIN_LINKS, mirror_role
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import ParameterError

SIDES = ("left_", "right_")


def mirrored(features: FeatureSequence) -> FeatureSequence | None:
    """Exchange left and right in postures.

    In a kinematic chain this is W of paper S, section 2.10: (w, x, -y, -z), and the links of the two sides exchanged.

    Parameters
    ----------
    features : FeatureSequence
        Postures, velocities or limb directions of a body that faces +Z, groups of three values, or a kinematic chain,
        groups of four: T frames.

    Returns
    -------
    FeatureSequence or None
        x negated, each role's place that of its partner, with the role's own weight; None where the names tell no
        sides, where a side lacks a partner, where the partner's weight of 0 has left nothing of its place, or where an
        angle is of a line from side to side, which the mirror turns round as well.

    Examples
    --------
    >>> hands = FeatureSequence([[1, 2, 3, -4, 5, 6]], ("left_hand", "right_hand"), rate=30, width=3)
    >>> mirrored(hands).values.tolist()
    [[4.0, 5.0, 6.0, -1.0, 2.0, 3.0]]
    >>> from leitmotion.features import weighted
    >>> mirrored(weighted(hands, [3, 1])).values.tolist()
    [[6.0, 7.5, 9.0, -0.5, 1.0, 1.5]]
    """
    is_chain = features.width == 4 and set(features.names) <= set(CHAIN_LINKS)
    if (
        not (features.width == 3 or is_chain)
        or (features.unit == "rad" and "chest" in features.names)
        or not (is_chain or any(name.startswith(SIDES) for name in features.names))
    ):
        return None
    partners = [mirror_role(name) for name in features.names]
    if any(partner not in features.names for partner in partners):
        return None
    order = [features.names.index(partner) for partner in partners]
    own = np.array(features.weights or np.ones(len(order)))
    partner = own[order]
    if (own[partner == 0] > 0).any():
        return None
    share = np.divide(own, partner, out=np.zeros_like(own), where=partner > 0)
    signs = [1.0, 1.0, -1.0, -1.0] if is_chain else [-1.0, 1.0, 1.0]
    values = features.values.reshape(len(features), -1, features.width)[:, order] * signs * share[:, None]
    return features.replace(values=np.ascontiguousarray(values.reshape(len(features), -1)))


def mirror_distance(features: FeatureSequence) -> np.ndarray:
    """Measure how far each posture is from its own mirror image: how lopsided the body stands, in places.

    Parameters
    ----------
    features : FeatureSequence
        Postures of a body that faces +Z, groups of three values: T frames.

    Returns
    -------
    (T,) float
        The mean over the joints, in the unit of the values; over those that are seen together with their partner, NaN
        where there is none.

    Raises
    ------
    ParameterError
        When the mirror image of these features is not known, or they are no places.

    Examples
    --------
    >>> hands = FeatureSequence([[1, 2, 3, -1, 2, 5]], ("left_hand", "right_hand"), rate=30, width=3)
    >>> mirror_distance(hands).tolist()
    [2.0]
    """
    image = mirrored(features) if features.width == 3 else None
    if image is None:
        raise ParameterError(
            "The mirror images of these features are not known.",
            remedy="Take postures in three dimensions with the joints of both sides.",
        )
    apart = np.linalg.norm((image.values - features.values).reshape(len(features), -1, 3), axis=2)
    seen = np.isfinite(apart)
    with np.errstate(invalid="ignore"):
        mean: np.ndarray = np.where(seen, apart, 0.0).sum(axis=1) / seen.sum(axis=1)
    return mean
