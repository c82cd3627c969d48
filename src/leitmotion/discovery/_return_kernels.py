# mypy: allow-untyped-defs
"""Loops that carry stretches along stripes. Plain arrays and numbers in, plain arrays out; nothing is checked here."""

import numpy as np
from numba import njit


@njit(cache=True, nogil=True)
def carried(path, here, moment):
    """Moment on the other side of a path that corresponds to one on this side, between two points in proportion."""
    low, high = 0, len(path) - 1
    while low < high:
        middle = (low + high + 1) // 2
        if path[middle, here] <= moment:
            low = middle
        else:
            high = middle - 1
    at = float(path[low, 1 - here])
    if path[low, here] >= moment or low == len(path) - 1:
        return at
    slope = (path[low + 1, 1 - here] - at) / (path[low + 1, here] - path[low, here])
    return slope * (moment - path[low, here]) + at


@njit(cache=True, nogil=True)
def come_back(points, places, lengths, sides, contrasts, first, last, holds, spans, shown, covered):
    """Find everywhere that the movement of one stretch comes back along the stripes that hold `holds` of it.

    Fills spans (K + 1, 2), the stretch itself first, shown (K,), by which stripe, and covered (K, 2), which part of it
    that holds, K at most all sides of all stripes. Returns K and the time that is explained, weighted by how clear the
    stripes are, none where it does not come back.
    """
    spans[0, 0], spans[0, 1] = first, last
    K = 0
    clear = 0.0
    for k in range(len(sides)):
        for here in range(2):
            start, stop = max(sides[k, here, 0], first), min(sides[k, here, 1], last)
            if stop - start < holds * (last - first):
                continue
            path = points[places[k] : places[k] + lengths[k]]
            begin, end = carried(path, here, start), carried(path, here, stop - 1) + 1
            free = True
            for n in range(K + 1):
                if min(end, spans[n, 1]) > max(begin, spans[n, 0]):
                    free = False
                    break
            if free:
                shown[K] = k
                covered[K, 0], covered[K, 1] = start, stop
                K += 1
                spans[K, 0], spans[K, 1] = begin, end
                clear += contrasts[k]
    if K == 0:
        return 0, 0.0
    total = 0.0
    for n in range(K + 1):
        total += spans[n, 1] - spans[n, 0]
    return K, clear / K * total


@njit(cache=True, nogil=True)
def judge(points, places, lengths, sides, contrasts, holds, spans, shown, covered, scores):
    """Fill in the scores (S, 2) that are NaN: the time that each side of each stripe explains."""
    for k in range(len(sides)):
        for here in range(2):
            if np.isnan(scores[k, here]):
                scores[k, here] = come_back(
                    points, places, lengths, sides, contrasts, sides[k, here, 0], sides[k, here, 1], holds,
                    spans, shown, covered,
                )[1]  # fmt: skip
