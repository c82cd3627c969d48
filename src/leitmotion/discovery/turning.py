"""Turning: moments at which a state may be; stillnesses, halts, turning points and centres of symmetry."""

from __future__ import annotations

import numpy as np

from leitmotion.discovery.moments import Moments
from leitmotion.similarity import align

DEEP = np.log(2.2)  # by which the speed sinks at a halt, beneath the lesser of the peaks around it
SLOWEST = 0.08  # of the peak speed: what is slower is still
CENTRE = 0.35  # of the lopsidedness around it, which a centre of symmetry has at most
ANTI = 0.4  # of the lopsidedness around it, by which what follows a centre differs from the image of what came before


def halts(moments: Moments, start: int, stop: int) -> list[int]:
    """Find where the body halts or turns: deep minima of its speed within a recording."""
    from scipy.signal import find_peaks

    speed = moments.speed[start:stop]
    if len(speed) < 3:
        return []
    peak = np.percentile(speed, 95)
    depth = -np.log(np.maximum(speed, max(SLOWEST * peak, 1e-6)))
    padded = np.concatenate(([-np.log(max(peak, 1e-6))], depth, [-np.log(max(peak, 1e-6))]))
    found, _ = find_peaks(padded, prominence=DEEP, plateau_size=1)
    return [start + int(place) - 1 for place in found]


def centres(moments: Moments, lopsided: np.ndarray, start: int, stop: int) -> list[int]:
    """Find the symmetric moments through which an anti-palindromic movement passes."""
    from scipy.signal import find_peaks

    lop = lopsided[start:stop]
    if len(lop) < 3:
        return []
    found, told = find_peaks(-lop, prominence=moments.half, plateau_size=1)
    kept = []
    for place, left, right in zip(found, told["left_bases"], told["right_bases"], strict=True):
        before = _summit(lop, int(place), -1, int(left))
        after = _summit(lop, int(place), 1, int(right))
        around = min(lop[before], lop[after])
        if lop[place] > CENTRE * around:
            continue
        image = moments.mirror[start + before : start + place + 1, start + place : start + after + 1][::-1]
        if min(image.shape) < 2:
            continue
        path = align(image).path
        if np.percentile(image[path[:, 0], path[:, 1]], 80) < ANTI * around:
            kept.append(start + int(place))
    return kept


def _summit(height: np.ndarray, place: int, step: int, limit: int) -> int:
    """The highest place on one side, before it sinks to half of that again."""
    best = at = place
    while at != limit:
        at += step
        if height[at] > height[best]:
            best = at
        elif height[at] < 0.5 * height[best] and height[best] > 2 * height[place]:
            break
    return best
