"""Mirror: the postures of the same movement performed with the other side."""

from __future__ import annotations

import numpy as np

from leitmotion.body import mirror_role
from leitmotion.features.sequence import FeatureSequence

SIDES = ("left_", "right_")


def mirrored(features: FeatureSequence) -> FeatureSequence | None:
    """Exchange left and right in postures.

    Parameters
    ----------
    features : FeatureSequence
        Postures or velocities of a body that faces +Z, groups of three values: T frames. Joints are weighted equally.

    Returns
    -------
    FeatureSequence or None
        x negated, each role's place that of its partner; None of angles, where the names tell no sides, or where a
        side lacks a partner.

    Examples
    --------
    >>> hands = FeatureSequence([[1, 2, 3, -4, 5, 6]], ("left_hand", "right_hand"), rate=30, width=3)
    >>> mirrored(hands).values.tolist()
    [[4.0, 5.0, 6.0, -1.0, 2.0, 3.0]]
    """
    if (
        features.width != 3
        or features.unit == "rad"
        or not any(name.startswith(SIDES) for name in features.names)
    ):
        return None
    partners = [mirror_role(name) for name in features.names]
    if any(partner not in features.names for partner in partners):
        return None
    order = [features.names.index(partner) for partner in partners]
    values = features.values.reshape(len(features), -1, 3)[:, order] * [-1.0, 1.0, 1.0]
    return features.replace(values=np.ascontiguousarray(values.reshape(len(features), -1)))
