"""Likeness in as many cells as a picture shows."""

from __future__ import annotations

import numpy as np

from leitmotion.similarity import likeness


def shrunk_likeness(distances: np.ndarray, beta: float, cells: int) -> np.ndarray:
    """Average likeness over squares of moments.

    Parameters
    ----------
    distances : (T, T) float
        D or D*.
    beta : float
        β.
    cells : int
        At most so many rows and columns.

    Returns
    -------
    (N, N) float
        0 to 1; what is unseen is like nothing.
    """
    step = max(1, -(-len(distances) // cells))
    edges = np.arange(0, len(distances), step)
    sizes = np.diff([*edges, len(distances)])
    rows = [
        np.add.reduceat(np.nan_to_num(likeness(distances[start : start + step], beta)).sum(axis=0), edges)
        for start in edges
    ]
    return np.array(rows) / np.outer(sizes, sizes)
