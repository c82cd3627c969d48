"""Parts: what of a posture is the same on both sides, and what is not (paper S, section 2.11)."""

from __future__ import annotations

from typing import NamedTuple

from leitmotion.features.mirror import mirrored
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion import ParameterError


class Parts(NamedTuple):
    """A posture as the sum of two parts."""

    symmetric: FeatureSequence
    """S, (T, 4 L): unchanged by the mirror."""

    antisymmetric: FeatureSequence
    """A, (T, 4 L): turned to its negative by the mirror; zero in a posture that is its own mirror image."""


def symmetry_parts(chain: FeatureSequence) -> Parts:
    """Part each posture Ψ of a kinematic chain into S = (Ψ + WΨ) / 2 and A = (Ψ - WΨ) / 2.

    Both are linear in the quaternions as the chain holds them, whose signs are chosen once for a recording; so
    W S = S, W A = -A, and the identities of paper S, section 2.14, hold for the signed product. S and A are no
    rotations.

    Parameters
    ----------
    chain : FeatureSequence
        A kinematic chain with both sides, T frames of L links.

    Returns
    -------
    Parts
        The two, of the chain's names.

    Raises
    ------
    ParameterError
        When the features have no mirror image.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.datasets import compose_session
    >>> from leitmotion.features import kinematic_chain
    >>> chain = kinematic_chain(compose_session(seed=0, rate=30.0).motion)
    >>> parts = symmetry_parts(chain)
    >>> bool(np.allclose(parts.symmetric.values + parts.antisymmetric.values, chain.values))
    True
    """
    image = mirrored(chain)
    if image is None:
        raise ParameterError(
            "These features have no mirror image, so that they have no symmetric part.",
            remedy="Take a kinematic chain with the links of both sides.",
        )
    return Parts(
        chain.replace(values=(chain.values + image.values) / 2.0),
        chain.replace(values=(chain.values - image.values) / 2.0),
    )
