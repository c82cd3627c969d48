"""Rotations told by directions: the shortest way from one to another, a frame of three axes, a part of a turn."""

from __future__ import annotations

import numpy as np

from leitmotion.motion.rotations import from_matrix, normalize


def between(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Turn one direction onto another by the shortest way.

    Parameters
    ----------
    a, b : (..., 3) float
        Unit vectors.

    Returns
    -------
    (..., 4) float
        Unit quaternions, NaN where a direction is. Of opposite directions any half turn is the shortest: then one about
        an axis across the largest component of `a`.

    Examples
    --------
    >>> between(np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])).round(3).tolist()
    [0.707, 0.707, 0.0, 0.0]
    """
    a, b = np.broadcast_arrays(np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64))
    q = np.concatenate((1.0 + (a * b).sum(axis=-1, keepdims=True), np.cross(a, b)), axis=-1)
    opposite = np.linalg.norm(q, axis=-1) < 1e-9
    if opposite.any():
        away = a[opposite]
        least = np.eye(3)[np.abs(away).argmin(axis=-1)]
        q[opposite] = np.concatenate((np.zeros((len(away), 1)), np.cross(away, least)), axis=-1)
    return normalize(q)


def from_axes(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Quaternion that turns the axes of the world onto three others.

    Parameters
    ----------
    x, y, z : (..., 3) float
        Orthogonal unit vectors, right-handed.

    Returns
    -------
    (..., 4) float
        Unit quaternions, NaN where one of the axes is.

    Examples
    --------
    >>> x, y, z = np.eye(3)
    >>> (from_axes(-z, y, x) @ [1, 1, 1, 1]).round(3)
    np.float64(1.414)
    """
    axes = np.stack(np.broadcast_arrays(x, y, z), axis=-1)
    known = np.isfinite(axes).all(axis=(-2, -1))
    q = np.full((*axes.shape[:-2], 4), np.nan)
    if known.any():
        q[known] = from_matrix(axes[known])
    return q


def power(q: np.ndarray, share: float) -> np.ndarray:
    """Turn by a share of a rotation about its own axis, the shorter way round.

    Parameters
    ----------
    q : (..., 4) float
        Unit quaternions.
    share : float
        1 gives the rotation itself, 0 none.

    Returns
    -------
    (..., 4) float
        Unit quaternions with w of 0 or more.

    Examples
    --------
    >>> power(np.array([0.0, 1.0, 0.0, 0.0]), 0.5).round(3).tolist()
    [0.707, 0.707, 0.0, 0.0]
    """
    q = np.asarray(q, dtype=np.float64)
    q = np.where(q[..., :1] < 0, -q, q)
    sine = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    half = np.arctan2(sine, q[..., :1])
    # sin(s a) / sin(a) tends to s where nothing turns
    ratio = np.where(sine > 1e-9, np.sin(share * half) / np.where(sine > 1e-9, sine, 1.0), share)
    return np.concatenate((np.cos(share * half), ratio * q[..., 1:]), axis=-1)
