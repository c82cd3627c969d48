"""What a matrix of distances says of each moment: how much of the rest is alike, and what is most alike.

Conventions
-----------
Rows are asked about columns. Of one recording with itself, moments next to each other are alike since little time has
passed; a counterpart is some time apart.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.similarity.matrix import SimilarityMatrix

ROWS = 512  # looked at together, so that no second matrix is made


class Counterparts(NamedTuple):
    """The most alike moment of each."""

    places: np.ndarray
    """(N,) int: which column; -1 where there is none."""

    distances: np.ndarray
    """(N,) float: how far it is; NaN where there is none."""


def counterparts(matrix: SimilarityMatrix, *, apart_s: float = 0.0) -> Counterparts:
    """Find for each moment the one that is most alike.

    Parameters
    ----------
    matrix : SimilarityMatrix
        Dense, (N, M).
    apart_s : float
        Of one recording with itself: how far apart the two are at least, seconds.

    Returns
    -------
    Counterparts
        The earliest, where several are as near.

    Examples
    --------
    >>> found = counterparts(SimilarityMatrix([[0, 2, 1], [2, 0, 5], [1, 5, 0]], "mean_norm", 1, 1), apart_s=1)
    >>> found.places.tolist(), found.distances.tolist()
    ([2, 0, 0], [1.0, 2.0, 1.0])
    """
    values = _dense(matrix)
    rows, columns = values.shape
    places, distances = np.full(rows, -1), np.full(rows, np.nan)
    time = np.arange(columns) / matrix.column_rate
    for first in range(0, rows, ROWS):
        part = np.where(np.isfinite(values[first : first + ROWS]), values[first : first + ROWS], np.inf)
        if apart_s > 0:
            own = np.arange(first, first + len(part))[:, None] / matrix.row_rate
            part[np.abs(time - own) < apart_s - 1e-9] = np.inf
        if columns == 0:
            break
        nearest = part.argmin(axis=1)
        least = part[np.arange(len(part)), nearest]
        there = np.isfinite(least)
        places[first : first + ROWS][there] = nearest[there]
        distances[first : first + ROWS][there] = least[there]
    return Counterparts(places, distances)


def shares_alike(matrix: SimilarityMatrix, limit: float) -> np.ndarray:
    """Tell for each moment how large a share of the others is alike.

    Parameters
    ----------
    matrix : SimilarityMatrix
        Dense, (N, M).
    limit : float
        At most so far apart is alike.

    Returns
    -------
    (N,) float
        0 to 1, of the columns whose distance is known; NaN where none is.

    Examples
    --------
    >>> shares_alike(SimilarityMatrix([[0, 2], [2, 0]], "mean_norm", 1, 1), 1.0).tolist()
    [0.5, 0.5]
    """
    values = _dense(matrix)
    alike, known = np.zeros(len(values)), np.zeros(len(values))
    for first in range(0, len(values), ROWS):
        part = values[first : first + ROWS]
        alike[first : first + ROWS] = (part <= limit).sum(axis=1)
        known[first : first + ROWS] = np.isfinite(part).sum(axis=1)
    return np.divide(alike, known, out=np.full(len(values), np.nan), where=known > 0)


def _dense(matrix: SimilarityMatrix) -> np.ndarray:
    if matrix.kind != "dense":
        raise ParameterError(f"All distances have to be there, and this matrix is {matrix.kind}.")
    return matrix.values
