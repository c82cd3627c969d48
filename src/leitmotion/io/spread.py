"""Where points lie and how far they reach, where some of them are unseen."""

from __future__ import annotations

import numpy as np

LOOKS = 32
"""How many frames of a recording are looked at to judge it."""


def mean(points: np.ndarray) -> np.ndarray:
    """Mean over points of (T, P, C), without those unseen; NaN where none is seen.

    Parameters
    ----------
    points : (T, P, C) float
        NaN where unseen.

    Returns
    -------
    (T, C) float
        The means.
    """
    seen = np.isfinite(points).all(axis=-1, keepdims=True)
    count = seen.sum(axis=1)
    total = np.where(seen, points, 0.0).sum(axis=1)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def reach(positions: np.ndarray) -> np.ndarray:
    """How far points reach along each axis, in each frame; NaN where none is seen.

    Parameters
    ----------
    positions : (T, P, C) float
        NaN where unseen.

    Returns
    -------
    (T, C) float
        Largest less least.
    """
    seen = np.isfinite(positions)
    width = np.where(seen, positions, -np.inf).max(axis=1) - np.where(seen, positions, np.inf).min(axis=1)
    return np.where(np.isfinite(width), width, np.nan)


def median(rows: np.ndarray) -> np.ndarray:
    """Median of the rows that are whole, zeros where none is.

    Parameters
    ----------
    rows : (T, C) float
        Some of them perhaps with NaN.

    Returns
    -------
    (C,) float
        The medians.
    """
    rows = rows[np.isfinite(rows).all(axis=1)]
    return np.median(rows, axis=0) if len(rows) else np.zeros(rows.shape[1])
