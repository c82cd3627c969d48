"""Lines: the straight way across a stretch, from the frame before it to the frame behind it."""

from __future__ import annotations

import numpy as np


def shares(start: int, stop: int) -> np.ndarray:
    """Tell how far on the way each frame of a stretch is.

    Parameters
    ----------
    start, stop : int
        The stretch, half-open.

    Returns
    -------
    (N,) float
        Shares of the way, above 0 and below 1: the frame before the stretch would have 0, the one behind it 1.

    Examples
    --------
    >>> shares(10, 13).tolist()
    [0.25, 0.5, 0.75]
    """
    ways: np.ndarray = (np.arange(start, stop) - (start - 1)) / (stop - start + 1)
    return ways


def line(path: np.ndarray, start: int, stop: int) -> np.ndarray:
    """Draw the straight line across a stretch of a path.

    Parameters
    ----------
    path : (T, ..., C) float
        A path, or several.
    start, stop : int
        The stretch of N frames, half-open; a frame lies before it and one behind it.

    Returns
    -------
    (N, ..., C) float
        What lies between those two.
    """
    share = shares(start, stop).reshape(-1, *(1,) * (path.ndim - 1))
    straight: np.ndarray = (1 - share) * path[start - 1] + share * path[stop]
    return straight
