# mypy: allow-untyped-defs
"""Loops over moments at which a movement begins or ends. Plain arrays and numbers in and out; nothing is checked."""

import numpy as np
from numba import njit

from leitmotion.similarity._kernels import _distance, distances_to


@njit(cache=True, nogil=True)
def around(a, width, frame, others, beside, apart):
    """Fill apart: mean distance of the postures beside a frame and beside others; infinite where some was not seen."""
    N, M = a.shape[1], a.shape[0] // width
    for n in range(others.size):
        total, inside = np.float32(0), 0
        for k in beside:
            i, j = frame + k, others[n] + k
            if min(i, j) >= 0 and max(i, j) < N:
                total += _distance(a, i, j, width, M)
                inside += 1
        apart[n] = total / np.float64(inside) if inside and total == total else np.inf


@njit(cache=True, nogil=True)
def pauses(speed, reach, around, share):
    """Moments slowest within `reach`, and slower than `share` of the fastest within `around` on either side."""
    found = np.empty(speed.size, np.int64)
    n = 0
    for p in range(speed.size):
        lowest = True
        for q in range(max(0, p - reach), min(speed.size, p + reach + 1)):
            if speed[q] < speed[p]:
                lowest = False
                break
        if not lowest or (n and p - found[n - 1] < reach):
            continue
        before = speed[max(0, p - around) : p + 1].max()
        after = speed[p : p + around + 1].max()
        if speed[p] < share * min(before, after):
            found[n] = p
            n += 1
    return found[:n]


@njit(cache=True, nogil=True)
def closes(a, width, path, away, near, back, settle):
    """Whether both stretches of a path lead `away` from a posture and back to `near` it, or to a share of the way."""
    for side in range(2):
        first, final = path[0, side], path[-1, side]
        apart = np.empty(final - first + 1, np.float32)
        distances_to(a, first, first, final + 1, 1, width, apart)
        farthest, nearest = np.float32(0), np.float32(np.inf)
        for k in range(apart.size):
            if apart[k] > farthest:
                farthest = apart[k]
            if k >= apart.size - 1 - settle and apart[k] < nearest:
                nearest = apart[k]
        if farthest < away or nearest > max(near, back * farthest):
            return False
    return True
