"""How a distance of the matrix is told to a person: in which unit, and from where on the map is blank.

Conventions
-----------
Page and figures tell distances alike: places in centimetres, or in parts of the body's size where there are no metres;
rotations in degrees, velocities in centimetres a second.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.similarity import SimilarityMatrix

CAP_PERCENTILE = 60
SAMPLED = 1000  # moments that the cap is told from


class Told(NamedTuple):
    """How distances are told."""

    factor: float
    """What a value of 1 in the matrix is in the unit told."""

    word: str
    """The unit told."""

    least: float
    """The cap is at least this, in the unit told; 0 where nothing is known of the recording's unit."""

    most: float
    """And at most this."""


def how_told(matrix: SimilarityMatrix, *, size: float | None = None) -> Told:
    """Choose in which unit the distances of a matrix are told.

    Parameters
    ----------
    matrix : SimilarityMatrix
        Distances between moments.
    size : float, optional
        The body's size in the recording's own unit; by default the matrix' scale where that is one.

    Returns
    -------
    Told
        The unit, the factor to it, and the bounds of the cap.

    Examples
    --------
    >>> how_told(SimilarityMatrix([[0.0]], "mean_norm", 30, 30, scale=1.5)).factor
    150.0
    """
    scale, unit = matrix.scale, matrix.unit
    if unit == "m":
        return Told(100 * scale, "cm", 8.0, 16.0)
    if unit == "rad":
        return Told(float(np.degrees(scale)), "°", 5.0, 30.0)
    if unit == "m/s":
        return Told(100 * scale, "cm/s", 5.0, 30.0)
    if unit in ("px", "relative") and (size is not None or scale != 1.0):
        return Told(100 * scale / (size or scale), "% of body size", 5.0, 10.0)
    return Told(scale, unit, 0.0, np.inf)


def distance_cap(distances: np.ndarray, told: Told) -> float:
    """Tell from which distance on the map is blank: the 60th percentile off the diagonal in whole units, within bounds.

    The upper bound keeps "alike" meaningful where most postures differ greatly, as when a person lies down.

    Parameters
    ----------
    distances : (N, N) or (N, M) float
        Values of the matrix.
    told : Told
        How they are told.

    Returns
    -------
    float
        The cap in the unit told.

    Examples
    --------
    >>> distance_cap(np.array([[0, 0.112], [0.112, 0]]), Told(100.0, "cm", 8.0, 16.0))
    12.0
    """
    stride = max(1, len(distances) // SAMPLED)
    sample = distances[::stride, ::stride]
    off = sample[np.eye(*sample.shape) == 0]
    off = off[np.isfinite(off)] * told.factor
    typical = float(np.percentile(off, CAP_PERCENTILE)) if off.size else told.least
    if not told.least:
        return typical or 1.0
    return float(np.clip(np.ceil(typical - 1e-9), told.least, told.most))
