"""Overlay: how far two stretches are apart when they are laid over one another in time.

Conventions
-----------
Distances are in body sizes.
"""

from __future__ import annotations

import numpy as np

from leitmotion.similarity import align


def overlay_cost(apart: np.ndarray, unseen: float) -> float:
    """Mean distance of two stretches along their warping path.

    Parameters
    ----------
    apart : (N, M) float
        Distance of each moment of the one to each of the other; NaN where nothing was seen.
    unseen : float
        What counts where single distances are not known. Moments that were not seen at all are left out.

    Returns
    -------
    float
        `unseen` where nothing was seen.

    Examples
    --------
    >>> hidden = np.array([[0.0, np.nan, 0.5], [np.nan, np.nan, np.nan], [0.5, np.nan, 0.0]])
    >>> overlay_cost(hidden, 1.0)
    0.0
    """
    seen = ~np.isnan(apart)
    if not seen.any():
        return unseen
    apart = apart[np.ix_(seen.any(axis=1), seen.any(axis=0))]
    return float(align(np.where(np.isnan(apart), unseen, apart)).cost)
