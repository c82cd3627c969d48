"""Ways of the sides: how much of a movement each side of the body makes.

Conventions
-----------
The *way* of a link is the sum of the angles that it turns by against its bearer from moment to moment. Pelvis, trunk
and head belong to no side. The mirror exchanges the sides: it turns a share of the left into one minus it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.body import mirror_role
from leitmotion.features.sequence import FeatureSequence

MOVES = np.radians(1.0)  # that both sides together have to turn by, so that one can move more
AS_MUCH = 0.5  # of what the link that differs most differs by, that another has to differ by to be named


class SideWays(NamedTuple):
    """What the two sides of a body do in a movement."""

    left_share: float
    """Way of the left links over that of both sides, 0 to 1."""

    links: tuple[str, ...]
    """Links of the side that moves more whose way differs most from that of their twins, in the chain's order."""


def side_ways(chain: FeatureSequence) -> SideWays | None:
    """Tell which share of a movement the left side makes, and which links differ most.

    Parameters
    ----------
    chain : FeatureSequence
        A kinematic chain, T moments of L links.

    Returns
    -------
    SideWays or None
        None where no side moves, or none is seen together with the other. A moment counts where both twins are seen.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> from leitmotion.features import kinematic_chain
    >>> chain = kinematic_chain(compose_session(seed=0, rate=30.0).motion)
    >>> 0.4 < side_ways(chain).left_share < 0.6
    True
    """
    turns = chain.values.reshape(len(chain), -1, 4)
    left = [k for k, name in enumerate(chain.names) if name.startswith("left_")]
    left = [k for k in left if mirror_role(chain.names[k]) in chain.names]
    right = [chain.names.index(mirror_role(chain.names[k])) for k in left]
    nearness = np.abs((turns[1:] * turns[:-1]).sum(axis=-1)).clip(0.0, 1.0)
    angles = 2.0 * np.arccos(nearness)
    both = np.isfinite(angles[:, left]) & np.isfinite(angles[:, right])
    ways = [np.where(both, angles[:, side], 0.0).sum(axis=0) for side in (left, right)]
    whole = float(ways[0].sum() + ways[1].sum())
    if whole < MOVES:
        return None
    share = float(ways[0].sum()) / whole
    more, less, side = (*ways, left) if share > 1 / 2 else (ways[1], ways[0], right)
    differ = more - less
    most = float(differ.max())
    named = sorted(k for k, each in zip(side, differ, strict=True) if most > 0 and each >= AS_MUCH * most)
    return SideWays(share, tuple(chain.names[k] for k in named))
