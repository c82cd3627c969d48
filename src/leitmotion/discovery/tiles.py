"""Tiles: moments side by side, so that a processor compares several at once and finds them in one place.

Conventions
-----------
A tile holds LANES moments, one number of all of them after another. Tiles are compared with BLOCK moments in a row at
a time: what a tile holds is then read once for all of these.
"""

from __future__ import annotations

import numpy as np

LANES = 16
BLOCK = 3


def side_by_side(across: np.ndarray, width: int) -> tuple[np.ndarray, int]:
    """Put moments into tiles.

    Parameters
    ----------
    across : (D, N) float32
        One moment a column.
    width : int
        How many numbers make a group.

    Returns
    -------
    (G, D' * LANES) float32
        NaN behind the last moment. Narrow groups are filled up with zeros, which change no norm.
    int
        The width of their groups, three or more.

    Examples
    --------
    >>> tiles, width = side_by_side(np.arange(20, dtype=np.float32)[None], 1)
    >>> tiles.shape, width, tiles[1, :5].tolist()
    ((2, 48), 3, [16.0, 17.0, 18.0, 19.0, nan])
    """
    filled = max(3, width)
    groups, moments = len(across) // width, across.shape[1]
    wide = np.zeros((groups, filled, moments + -moments % LANES), np.float32)
    wide[:, :width, :moments] = across.reshape(groups, width, moments)
    wide[:, 0, moments:] = np.nan
    tiles = wide.reshape(groups * filled, -1, LANES).transpose(1, 0, 2)
    return np.ascontiguousarray(tiles).reshape(-1, groups * filled * LANES), filled


def filled_up(values: np.ndarray, filling: float) -> np.ndarray:
    """Fill up the last tile of values.

    Parameters
    ----------
    values : (N,) array
        One a moment.
    filling : float
        What stands behind the last.

    Returns
    -------
    (G * LANES,) array
        Of the same type.
    """
    return np.pad(values, (0, -len(values) % LANES), constant_values=filling)
