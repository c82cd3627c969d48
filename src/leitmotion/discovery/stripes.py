"""Stripes: the paths in a posture matrix along which a movement comes back.

Conventions
-----------
Distances are in the unit of the matrix (body sizes). A stripe lies above the diagonal: its first stretch is earlier
than its second. Contrast is ``1 - cost / background``: 1 when the stripe is far better than its surroundings, 0 when
the body merely keeps still there.

References
----------
Paper P, section 2.3, asks for the longest similar segment pairs by tracing minima with shrinking windows. Here the
same pairs are found as local alignments (T. F. Smith and M. S. Waterman, J. Mol. Biol. 147, 1981) of the recording with
itself, which needs no window.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

CORRIDOR_S = 0.13  # paths nearer to one another than this are one stripe
REACH_S = 1.0  # how far around a moment its amplitude is read
AMPLITUDE_SHARE = 0.5  # alike: nearer than half of what the body moves around that moment
REST_SHARE = 0.15  # of the greatest speed nearby: slower is a rest between two movements
SAMPLED = 64  # moments a side of a stripe's rectangle that tell its background
GAP_S = 0.27  # how long a mismatch a path may bridge


class Likeness(NamedTuple):
    """What counts as alike at each moment."""

    threshold: np.ndarray
    """(N,) distance below which another posture is alike, body sizes."""

    still: np.ndarray
    """(N,) bool: the body keeps still around this moment."""

    speed: np.ndarray
    """(N,) how fast the posture changes, body sizes a moment, smoothed over a tenth of a second."""

    moving: np.ndarray
    """(N,) bool: it moves at this very moment, and is not about to start or at rest between two repeats."""


@dataclass(frozen=True, eq=False)
class Stripe:
    """Two stretches that show the same movement."""

    path: np.ndarray  # (K, 2) moments, never decreasing
    cost: float  # mean distance along the path
    background: float  # median distance in the rectangle of the two stretches
    gain: float  # sum of 1 - d / threshold

    @cached_property
    def a(self) -> tuple[int, int]:
        """The earlier stretch, ``[start, stop)``."""
        return int(self.path[0, 0]), int(self.path[-1, 0]) + 1

    @cached_property
    def b(self) -> tuple[int, int]:
        """The later stretch, ``[start, stop)``."""
        return int(self.path[0, 1]), int(self.path[-1, 1]) + 1

    @cached_property
    def lag(self) -> float:
        """How much later the later one is, moments."""
        return float(np.median(self.path[:, 1] - self.path[:, 0]))

    @property
    def contrast(self) -> float:
        """How much nearer than its surroundings the stripe is."""
        return 1.0 - self.cost / self.background if self.background > 0 else 0.0

    def forward(self, moment: float) -> float:
        """Moment of the second stretch that corresponds to one of the first."""
        return float(np.interp(moment, self.path[:, 0], self.path[:, 1]))

    def backward(self, moment: float) -> float:
        """Moment of the first stretch that corresponds to one of the second."""
        return float(np.interp(moment, self.path[:, 1], self.path[:, 0]))


def likeness(
    distances: np.ndarray,
    rate: float,
    *,
    max_distance: float,
    min_amplitude: float,
    share: float = AMPLITUDE_SHARE,
) -> Likeness:
    """Decide at each moment how near another posture must be to be alike.

    A large movement is compared by `max_distance`; around a small one (a waving hand) alike means nearer than half
    of what the body moves there; where it moves less than `min_amplitude` it keeps still.

    Parameters
    ----------
    distances : (N, N) float32
        Posture distances, body sizes.
    rate : float
        Moments per second.
    max_distance, min_amplitude : float
        Body sizes.
    share : float
        Of what the body moves around a moment: nearer than this is alike.

    Returns
    -------
    Likeness
        Threshold, stillness, speed and movement of each moment.
    """
    from leitmotion.discovery._kernels import amplitudes

    amplitude = amplitudes(distances, round(REACH_S * rate))
    threshold = np.minimum(max_distance, share * amplitude).astype(np.float32)
    speed = _speed(distances, rate)
    return Likeness(
        np.maximum(threshold, np.float32(1e-6)), amplitude < min_amplitude, speed, _moving(speed, rate)
    )


def trace_stripes(
    distances: np.ndarray, alike: Likeness, rate: float, *, max_distance: float, min_duration_s: float
) -> list[Stripe]:
    """Trace all stripes of a self-distance matrix, the longest and nearest first.

    Parameters
    ----------
    distances : (N, N) float32
        Posture distances, body sizes; NaN where nothing was seen.
    alike : Likeness
        What counts as alike.
    rate : float
        Moments per second.
    max_distance : float
        Body sizes.
    min_duration_s : float
        Shortest stretch, seconds.

    Returns
    -------
    list of Stripe
        Both stretches of each are at least `min_duration_s` long.
    """
    from leitmotion.discovery._kernels import align_locally, walk_back

    shortest = max(2, round(min_duration_s * rate))
    step_into, rows, columns, gains = align_locally(
        distances, alike.threshold, alike.still,
        np.float32(0.5 * max_distance), np.float32(-0.1), np.float32(GAP_S * rate), np.float32(0.2 * shortest),
    )  # fmt: skip
    best_first = np.argsort(-gains, kind="stable")
    corridor = max(1, round(CORRIDOR_S * rate))
    points, offsets = walk_back(step_into, rows[best_first], columns[best_first], corridor, shortest)
    stripes = []
    for path in np.split(points, offsets[1:-1]):
        stripe = measure(path, distances, alike) if len(path) else None
        if stripe is not None and min(stripe.a[1] - stripe.a[0], stripe.b[1] - stripe.b[0]) >= shortest:
            stripes.append(stripe)
    return stripes


def measure(path: np.ndarray, distances: np.ndarray, alike: Likeness) -> Stripe | None:
    """Trim a path to where it is alike at both ends, and measure it.

    Parameters
    ----------
    path : (K, 2) int
        Moments.
    distances : (N, N) float32
        Posture distances.
    alike : Likeness
        What counts as alike.

    Returns
    -------
    Stripe or None
        None when nothing on the path is alike and in motion.
    """
    i, j = path[:, 0], path[:, 1]
    d = distances[i, j].astype(np.float64)
    gain = 1.0 - d / np.minimum(alike.threshold[i], alike.threshold[j])
    gain[alike.still[i] | alike.still[j]] = -0.1
    good = np.flatnonzero((gain > 0) & alike.moving[i] & alike.moving[j])
    if good.size == 0:
        return None
    keep = slice(good[0], good[-1] + 1)
    path, d, gain = path[keep], d[keep], gain[keep]
    every = max(1, len(path) // SAMPLED)
    block = distances[path[0, 0] : path[-1, 0] + 1 : every, path[0, 1] : path[-1, 1] + 1 : every]
    return Stripe(path, float(np.nanmean(d)), float(np.nanmedian(block)), float(np.nansum(gain)))


def _speed(distances: np.ndarray, rate: float) -> np.ndarray:
    from scipy.ndimage import uniform_filter1d

    step = np.nan_to_num(np.diagonal(distances, 1))
    return np.asarray(uniform_filter1d(np.concatenate((step[:1], step)), max(1, round(0.1 * rate))))


def _moving(speed: np.ndarray, rate: float) -> np.ndarray:
    from scipy.ndimage import maximum_filter1d

    return np.asarray(speed > REST_SHARE * maximum_filter1d(speed, 2 * round(REACH_S * rate) + 1))


def part(stripe: Stripe, keep: np.ndarray, distances: np.ndarray, alike: Likeness) -> Stripe | None:
    """Measure the part of a stripe that lies in the longest run of `keep`.

    Parameters
    ----------
    stripe : Stripe
        The whole.
    keep : (K,) bool
        Which of its moments.
    distances : (N, N) float32
        Posture distances.
    alike : Likeness
        What counts as alike.

    Returns
    -------
    Stripe or None
        None when nothing is left.
    """
    edges = np.flatnonzero(np.diff(np.concatenate(([0], keep.astype(np.int8), [0]))))
    if edges.size == 0:
        return None
    runs = edges.reshape(-1, 2)
    start, stop = runs[np.argmax(runs[:, 1] - runs[:, 0])]
    if stop - start == len(keep):
        return stripe
    return measure(stripe.path[start:stop], distances, alike)
