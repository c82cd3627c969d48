"""What the page shows of much: key postures, the strip of postures, nearest moments, where to look from.

Conventions
-----------
``distances`` is (F, F): moment against moment, in the matrix's own numbers, NaN where unknown. Frames returned are its
rows.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.discovery import Pattern

MISSING = {"i2": -32768, "i4": -2147483648}
NEAREST = 3
NEAREST_APART_S = 0.9
STRIP_CANDIDATES = 360
STRIP_SLACK = 0.955
SOLE = 0.026
LONG_PATH = 1.5
THREE_QUARTERS = 0.62


def find_nearest(distances: np.ndarray, rate: float, *, cap: float) -> tuple[np.ndarray, np.ndarray]:
    """Find the moments most like each moment, apart from it and from one another.

    Parameters
    ----------
    distances : (F, F) float
        Between moments.
    rate : float
        Moments per second.
    cap : float
        Farther than this is not alike.

    Returns
    -------
    frames : (F, 3) int
        The nearest, the next and the third; -1 where none comes within the cap.
    distances : (F, 3) float
        How far each is, NaN where there is none.
    """
    count = len(distances)
    apart = int(np.ceil(NEAREST_APART_S * rate))
    frames = np.full((count, NEAREST), -1, dtype=np.int64)
    found = np.full((count, NEAREST), np.nan)
    columns = np.arange(count)
    for first in range(0, count, 512):
        rows = np.arange(first, min(first + 512, count))
        band = np.array(distances[first : first + 512], dtype=np.float32)
        band[np.isnan(band) | (np.abs(columns - rows[:, None]) < apart)] = np.inf
        for k in range(NEAREST):
            best = band.argmin(axis=1)
            value = band[np.arange(len(rows)), best]
            near = value <= cap
            frames[rows[near], k] = best[near]
            found[rows[near], k] = value[near]
            for row, column in enumerate(best):
                band[row, max(column - apart + 1, 0) : column + apart] = np.inf
    return frames, found


def choose_key(pattern: Pattern, distances: np.ndarray, rate: float) -> int:
    """Choose the posture that stands for a pattern: of its best occurrence the one least like the rest.

    Parameters
    ----------
    pattern : Pattern
        What recurs.
    distances : (F, F) float
        Between moments.
    rate : float
        Moments per second.

    Returns
    -------
    int
        A row of `distances`.
    """
    last = len(distances) - 1
    spans = pattern.occurrences
    scores = np.where(np.isnan(spans.scores), 0, spans.scores)
    best = int(scores.argmax())
    start = min(round(spans.starts[best] / spans.rate * rate), last)
    stop = min(max(round(spans.stops[best] / spans.rate * rate), start + 1), last + 1)
    outside = np.ones(len(distances), dtype=bool)
    for a, b, _, _ in pattern.stretches:
        outside[round(a / spans.rate * rate) : round(b / spans.rate * rate)] = False
    outside &= np.arange(len(distances)) % max(1, len(distances) // 600) == 0
    if not outside.any():
        outside[start:stop] = True
    block = distances[start:stop, outside]
    known = np.isfinite(block)
    unlike = np.where(known, block, 0).sum(axis=1) / np.maximum(known.sum(axis=1), 1)
    return start + int(unlike.argmax())


def choose_strips(distances: np.ndarray, counts: Sequence[int]) -> list[np.ndarray]:
    """Choose the postures of the strip for several widths: each as unlike its neighbours as its place allows.

    The postures keep a distance in time of at least 0.955 of an even spacing, and half of it to both ends; under
    that rule the sum of the distances between neighbours is the greatest possible.

    Parameters
    ----------
    distances : (F, F) float
        Between moments.
    counts : sequence of int
        How many postures each strip has.

    Returns
    -------
    list of (K,) int arrays
        Rows of `distances`, in order.
    """
    count = len(distances)
    stride = max(1, count // STRIP_CANDIDATES)
    candidates = np.arange(0, count, stride)
    gain = np.nan_to_num(np.asarray(distances[::stride, ::stride], dtype=np.float64))
    return [candidates[_most_varied(gain, k)] for k in counts if k <= max(len(candidates) // 2, 1)]


def _most_varied(gain: np.ndarray, count: int) -> np.ndarray:
    """Choose `count` places in order with the greatest sum of gains between neighbours (dynamic programming)."""
    n = len(gain)
    apart = max(1, int(STRIP_SLACK * n / count))
    edge = int(0.5 * STRIP_SLACK * n / count)
    place = np.arange(n)
    allowed = (place[None, :] - place[:, None]) >= apart
    score = np.where((place >= edge) & (place < n - edge), 0.0, -np.inf)
    inside = score.copy()
    back = []
    for _ in range(count - 1):
        total = np.where(allowed, score[:, None] + gain, -np.inf)
        back.append(total.argmax(axis=0))
        score = total.max(axis=0) + inside
    chosen = [int(score.argmax())]
    for step in reversed(back):
        chosen.append(int(step[chosen[-1]]))
    return np.array(chosen[::-1])


def floor_height(drawn: np.ndarray, girth: float) -> float:
    """Tell where the floor is: under the lowest points of nearly all postures.

    Parameters
    ----------
    drawn : (F, R, 3) float
        Positions, metres.
    girth : float
        Thickness of the body, 1 of a person of 1.7 m.

    Returns
    -------
    float
        Height of the floor, metres.
    """
    y = drawn[..., 1]
    seen = np.isfinite(y).any(axis=1)
    if not seen.any():
        return 0.0
    return float(np.percentile(np.nanmin(y[seen], axis=1), 5) - SOLE * girth)


def look_across(drawn: np.ndarray, facing: np.ndarray) -> float:
    """Choose where the camera of the room stands: beside a long way, else before the person, three quarters on.

    Parameters
    ----------
    drawn : (F, R, 3) float
        Positions, metres.
    facing : (F,) float
        Yaw of the body's front.

    Returns
    -------
    float
        Yaw from which the camera looks, radians: 0 stands before a person who faces +Z.
    """
    seen = np.isfinite(drawn[..., 0]).any(axis=1)
    if not seen.any():
        return 0.0
    middle = np.nanmean(drawn[seen][..., [0, 2]], axis=1)
    spread = middle - middle.mean(axis=0)
    axes = np.linalg.svd(spread, full_matrices=False)[2]
    ahead = float(np.arctan2(np.sin(facing[seen]).mean(), np.cos(facing[seen]).mean()))
    if np.ptp(spread @ axes[0]) < LONG_PATH:
        return ahead + THREE_QUARTERS
    along = float(np.arctan2(axes[0, 0], axes[0, 1]))
    sides = [along + np.pi / 2 - 0.45, along - np.pi / 2 - 0.45]
    return min(sides, key=lambda yaw: -np.cos(yaw - ahead))
