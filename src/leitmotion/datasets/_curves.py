"""Curves in continuous time: keyed movement and random wandering, the same at every frame rate."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

Key = tuple[float, ...]  # (time, value) or (time, value, slope); without a slope the curve rests there


def keyed(t: np.ndarray, keys: Sequence[Key]) -> np.ndarray:
    """Evaluate the piecewise cubic through keys at times `t`: continuous with its first derivative, held outside."""
    at, value, slope = (np.array(column) for column in zip(*((*key, 0.0)[:3] for key in keys), strict=True))
    k = np.clip(np.searchsorted(at, t, side="right") - 1, 0, len(at) - 2)
    span = at[k + 1] - at[k]
    u = np.clip((t - at[k]) / span, 0.0, 1.0)
    rise = u * u * (3.0 - 2.0 * u)
    tangents = u * (1.0 - u) * (slope[k] * (1.0 - u) - slope[k + 1] * u)
    return value[k] * (1.0 - rise) + value[k + 1] * rise + span * tangents


def wander(rng: np.random.Generator, t: np.ndarray, seconds: float, pace: float, channels: int) -> np.ndarray:
    """Draw smooth random curves of unit variance: cubic B-splines of normal knots, `pace` knots a second.

    The knots depend on the length in seconds only, so that any sampling of `t` reads the same curves.
    """
    knots = rng.standard_normal((int(np.ceil(seconds * pace)) + 4, channels))
    k, u = np.divmod(t * pace, 1.0)
    first = k.astype(np.int64)
    weights = (
        (1.0 - u) ** 3 / 6.0,
        (3.0 * u**3 - 6.0 * u**2 + 4.0) / 6.0,
        (-3.0 * u**3 + 3.0 * u**2 + 3.0 * u + 1.0) / 6.0,
        u**3 / 6.0,
    )
    curves = sum(w[:, None] * knots[first + n] for n, w in enumerate(weights))
    return np.asarray(curves) / np.sqrt(151.0 / 315.0)  # mean over u of the sum of squared weights
