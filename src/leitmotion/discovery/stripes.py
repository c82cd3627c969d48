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

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.labour import share_work
from leitmotion.similarity import Distances

CORRIDOR_S = 0.13  # paths nearer to one another than this are one stripe
REACH_S = 1.0  # how far around a moment its amplitude is read
AMPLITUDE_SHARE = 0.5  # alike: nearer than half of what the body moves around that moment
REST_SHARE = 0.15  # of the greatest speed nearby: slower is a rest between two movements
CLEAR = 0.2  # of the distance of what is alike: both ends of a stripe are nearer than it by this share
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
        lags = np.sort(self.path[:, 1] - self.path[:, 0])  # much faster than numpy's median of a few
        return float(lags[len(lags) // 2] + lags[(len(lags) - 1) // 2]) / 2

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
    distances: Distances,
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
    distances : Distances
        Posture distances of N moments, body sizes.
    max_distance, min_amplitude : float
        Body sizes.
    share : float
        Of what the body moves around a moment: nearer than this is alike.

    Returns
    -------
    Likeness
        Threshold, stillness, speed and movement of each moment.
    """
    rate = distances.features.rate
    band = distances.band(round(REACH_S * rate)).values
    amplitude = _amplitudes(band)
    threshold = np.minimum(max_distance, share * amplitude).astype(np.float32)
    speed = _speed(band, rate)
    return Likeness(
        np.maximum(threshold, np.float32(1e-6)), amplitude < min_amplitude, speed, _moving(speed, rate)
    )


def measure(paths: Sequence[np.ndarray], distances: Distances, alike: Likeness) -> list[Stripe | None]:
    """Trim paths to where they are alike at both ends, and measure them.

    Parameters
    ----------
    paths : sequence of (K, 2) int
        Moments.
    distances : Distances
        Posture distances.
    alike : Likeness
        What counts as alike.

    Returns
    -------
    list of Stripe or None
        One for each path; None when nothing on it is alike and in motion.
    """
    if not paths:
        return []
    lengths = [len(path) for path in paths]
    return measure_all(
        np.concatenate(paths).astype(np.int32, copy=False), np.array(lengths), distances, alike
    )


def measure_all(
    points: np.ndarray, lengths: np.ndarray, distances: Distances, alike: Likeness
) -> list[Stripe | None]:
    """Do the same for paths that stand one after another.

    Parameters
    ----------
    points : (M, 2) int32
        The paths' moments.
    lengths : (S,) int
        How many points each path has.
    distances, alike
        As for :func:`measure`.

    Returns
    -------
    list of Stripe or None
        S of them.
    """
    from leitmotion.discovery._path_kernels import measure_paths

    offsets = np.concatenate(([0], np.cumsum(lengths)))
    kept = np.zeros((len(lengths), 2), np.int64)
    cost, background, gain = (np.zeros(len(lengths)) for _ in range(3))

    def fill(part: slice) -> None:
        ends = slice(part.start, part.stop + 1)
        measure_paths(
            distances.across, distances.width, alike.threshold, alike.still, alike.moving, CLEAR,
            points, offsets[ends], SAMPLED, kept[part], cost[part], background[part], gain[part],
        )  # fmt: skip

    share_work(fill, len(lengths), 256)
    return [
        Stripe(points[o + a : o + b], c, d, g) if b > a else None
        for o, (a, b), c, d, g in zip(
            offsets[:-1].tolist(),
            kept.tolist(),
            cost.tolist(),
            background.tolist(),
            gain.tolist(),
            strict=True,
        )
    ]


def _amplitudes(band: np.ndarray) -> np.ndarray:
    """Distance of the farthest posture within reach of each moment, (N,)."""
    amplitude = np.zeros(len(band), np.float32)
    for k in range(1, min(band.shape[1], len(band))):
        apart = band[: len(band) - k, k]
        np.fmax(amplitude[: len(band) - k], apart, out=amplitude[: len(band) - k])
        np.fmax(amplitude[k:], apart, out=amplitude[k:])
    return amplitude


def _speed(band: np.ndarray, rate: float) -> np.ndarray:
    from scipy.ndimage import uniform_filter1d

    step = np.nan_to_num(band[:-1, 1])
    return np.asarray(uniform_filter1d(np.concatenate((step[:1], step)), max(1, round(0.1 * rate))))


def _moving(speed: np.ndarray, rate: float) -> np.ndarray:
    from scipy.ndimage import maximum_filter1d

    return np.asarray(speed > REST_SHARE * maximum_filter1d(speed, 2 * round(REACH_S * rate) + 1))


def part(stripe: Stripe, keep: np.ndarray) -> np.ndarray:
    """Cut the longest run of `keep` out of a stripe, to be measured anew.

    Parameters
    ----------
    stripe : Stripe
        The whole.
    keep : (K,) bool
        Which of its moments.

    Returns
    -------
    (L, 2) int
        That part of its path; empty where nothing is kept.
    """
    edges = np.flatnonzero(np.diff(np.concatenate(([0], keep.astype(np.int8), [0]))))
    if edges.size == 0:
        return stripe.path[:0]
    runs = edges.reshape(-1, 2)
    start, stop = runs[np.argmax(runs[:, 1] - runs[:, 0])]
    return stripe.path[start:stop]
