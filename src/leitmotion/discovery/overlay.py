"""Overlay: how far two stretches are apart when they are laid over one another in time.

Conventions
-----------
Distances are in body sizes.
"""

from __future__ import annotations

import numpy as np

from leitmotion.discovery.labour import aside
from leitmotion.features.sequence import FeatureSequence
from leitmotion.similarity import Distances, cross_distance, warping_cost

HELD = 600 * 600  # distances held at once: those of two stretches of 20 s
AGREED = 1.5  # times the distance of postures that are alike: two whole stretches, ends and all, are alike
LOOKED_AT = 20_000 * 20_000  # distances computed: those of two stretches of eleven minutes, seconds of work


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
    from leitmotion.discovery._overlay_kernels import distances_along

    along = distances_along(apart, apart.dtype.type(unseen))
    return float(along.mean()) if along.size else unseen


def overlay_of_stretches(distances: Distances, rows: range, columns: range, unseen: float) -> float:
    """Mean distance of two stretches of one recording along their warping path, however long they are.

    Parameters
    ----------
    distances : Distances
        Posture distances of N moments.
    rows, columns : range
        The stretches, moments that follow one another.
    unseen : float
        As for :func:`overlay_cost`.

    Returns
    -------
    float
        `unseen` where nothing was seen.
    """
    if len(rows) * len(columns) <= HELD:
        from leitmotion.discovery._overlay_kernels import overlay

        return float(
            overlay(
                distances.across,
                rows.start,
                rows.stop,
                columns.start,
                columns.stop,
                distances.width,
                float(unseen),
            )
        )
    whole = distances.features
    return overlay_of(whole[rows.start : rows.stop], whole[columns.start : columns.stop], unseen)


def overlay_of_spans(
    distances: Distances, one: tuple[float, float], other: tuple[float, float], unseen: float
) -> float:
    """Do the same for two stretches that start and stop between moments.

    Parameters
    ----------
    distances : Distances
        Posture distances of N moments.
    one, other : (float, float)
        Where each starts and stops, moments.
    unseen : float
        As for :func:`overlay_cost`.

    Returns
    -------
    float
        `unseen` where nothing was seen. Of the shortest stretch two moments are compared.
    """
    last = len(distances)
    rows, columns = (range(int(a), min(last, max(int(a) + 2, round(b)))) for a, b in (one, other))
    return overlay_of_stretches(distances, rows, columns, unseen)


def overlay_of(one: FeatureSequence, other: FeatureSequence, unseen: float) -> float:
    """Mean distance of two sequences along their warping path, however long they are.

    Beyond 20 s their distances are never held all at once, and beyond eleven minutes only every n-th moment is
    looked at, so that neither memory nor time run away.

    Parameters
    ----------
    one, other : FeatureSequence
        The same features of two stretches.
    unseen : float
        As for :func:`overlay_cost`.

    Returns
    -------
    float
        `unseen` where nothing was seen.
    """
    cells = len(one) * len(other)
    if cells <= HELD:
        return overlay_cost(cross_distance(one, other).values, unseen)
    every = int(np.ceil(np.sqrt(cells / LOOKED_AT)))
    return aside(warping_cost, one[::every], other[::every], unseen)
