# mypy: allow-untyped-defs
"""Loops along the paths of an alignment. Plain arrays and numbers in, plain arrays out; nothing is checked here."""

import numpy as np
from numba import njit

from leitmotion.discovery._kernels import BITS, FLAT, NONE, START, STEEP
from leitmotion.discovery.tiles import LANES
from leitmotion.similarity._kernels import _distance, distances_to

BINS = 512


@njit(cache=True, nogil=True)
def _tile(row_offsets, places, i, g):
    """First tile of row i that is g or after it, or where the next row begins."""
    low, high = row_offsets[i], row_offsets[i + 1]
    while low < high:
        middle = (low + high) // 2
        if places[middle] < g:
            low = middle + 1
        else:
            high = middle
    return low


@njit(cache=True, nogil=True)
def _step(steps, row_offsets, places, i, j):
    """The step into a cell."""
    k = _tile(row_offsets, places, i, j // LANES)
    if k == row_offsets[i + 1] or places[k] != j // LANES:
        return NONE
    return (steps[k] >> np.uint64(BITS * (j % LANES))) & np.uint64(2**BITS - 1)


@njit(cache=True, nogil=True)
def _close(steps, row_offsets, places, i, first, stop):
    """Take the steps away from columns [first, stop) of row i."""
    k = _tile(row_offsets, places, i, first // LANES)
    while k < row_offsets[i + 1] and places[k] * LANES < stop:
        begin, end = max(0, first - places[k] * LANES), min(LANES, stop - places[k] * LANES)
        lanes = np.uint64(2**64 - 1) >> np.uint64(BITS * (LANES - end + begin))
        steps[k] &= ~(lanes << np.uint64(BITS * begin))
        k += 1


@njit(cache=True, nogil=True)
def walk_back(steps, row_offsets, places, rows, columns, width, shortest, k0, k1, path):
    """Follow the steps back from ends k0 to k1 in turn and close a corridor of `width` moments around each path.

    A closed cell has no step any more, so that a later path stops where an earlier one ran. Returns the paths of at
    least `shortest` moments in both directions, one after another (M, 2), and the length of each.
    """
    N = row_offsets.size - 1
    points = np.empty((4096, 2), np.int32)
    lengths = [0]
    total = 0
    for k in range(k0, k1):
        i, j = rows[k], columns[k]
        n = 0
        while i >= 0 and j >= 0:
            step = _step(steps, row_offsets, places, i, j)
            if step == NONE:
                break
            path[n, 0], path[n, 1] = i, j
            n += 1
            if step == START:
                break
            i -= 2 if step == STEEP else 1
            j -= 2 if step == FLAT else 1
        if n == 0:
            continue
        near, far = n - 1, n - 1  # points of the path, first to last in time, within `width` of a row
        for row in range(max(0, path[n - 1, 0] - width), min(N, path[0, 0] + width + 1)):
            while path[near, 0] < row - width:
                near -= 1
            while far > 0 and path[far - 1, 0] <= row + width:
                far -= 1
            _close(steps, row_offsets, places, row, max(0, path[near, 1] - width), path[far, 1] + width + 1)
        if min(path[0, 0] - path[n - 1, 0], path[0, 1] - path[n - 1, 1]) + 1 < shortest:
            continue
        while total + n > len(points):
            points = np.concatenate((points, np.empty_like(points)))
        for m in range(n):
            points[total + m, 0], points[total + m, 1] = path[n - 1 - m, 0], path[n - 1 - m, 1]
        total += n
        lengths.append(n)
    return points[:total], np.array(lengths[1:], np.int64)


@njit(cache=True, nogil=True)
def median(values):
    """Middle of some distances: only those that fall into its one bin of many are put in order."""
    least, most = np.float32(np.inf), np.float32(-np.inf)
    for k in range(values.size):
        least, most = min(least, values[k]), max(most, values[k])
    if values.size < BINS // 8 or most - least < np.float32(1e-30):
        return np.median(values)
    scale = np.float32(BINS - 1) / (most - least)
    counts = np.zeros(BINS, np.int64)
    for k in range(values.size):
        counts[np.int64((values[k] - least) * scale)] += 1
    rank, here = (values.size - 1) // 2, 0
    while rank >= counts[here]:
        rank -= counts[here]
        here += 1
    beyond = here  # the bin of the upper of two middle ones
    if values.size % 2 == 0 and rank + 1 == counts[here]:
        beyond += 1
        while counts[beyond] == 0:
            beyond += 1
    inside = np.empty(values.size, np.float32)
    n = 0
    for k in range(values.size):
        at = np.int64((values[k] - least) * scale)
        inside[n] = values[k]
        n += (at == here) | (at == beyond)
    few = np.sort(inside[:n])
    return (few[rank] + few[rank + 1 - values.size % 2]) / 2


@njit(cache=True, nogil=True)
def measure_paths(
    a, width, theta, still, moving, clear, points, offsets, sampled, kept, cost, background, gained
):
    """Trim each path to where it gains more than `clear` and is in motion at both ends, and measure it.

    Fills kept (S, 2), the points that are left, none where nothing is; cost, background and gained (S,).
    """
    C = np.empty(4 * sampled, np.float32)
    block = np.empty(16 * sampled * sampled, np.float32)
    groups = a.shape[0] // width
    longest = 0
    for s in range(offsets.size - 1):
        longest = max(longest, offsets[s + 1] - offsets[s])
    d, gain = np.empty(longest), np.empty(longest)
    for s in range(offsets.size - 1):
        o = offsets[s]
        n = offsets[s + 1] - o
        begin, end = n, 0
        for k in range(n):
            i, j = points[o + k, 0], points[o + k, 1]
            d[k] = _distance(a, i, j, width, groups)
            gain[k] = 1.0 - d[k] / min(theta[i], theta[j])
            if still[i] or still[j]:
                gain[k] = -0.1
            if gain[k] > clear and moving[i] and moving[j]:
                begin, end = min(begin, k), k + 1
        kept[s, 0], kept[s, 1] = begin, max(begin, end)
        if begin >= end:
            continue
        total, seen, sum_of_gains = 0.0, 0, 0.0
        for k in range(begin, end):
            if d[k] == d[k]:
                total += d[k]
                seen += 1
                sum_of_gains += gain[k] if gain[k] == gain[k] else 0.0
            elif still[points[o + k, 0]] or still[points[o + k, 1]]:
                sum_of_gains += gain[k]
        cost[s], gained[s] = total / seen, sum_of_gains
        i0, i1 = points[o + begin, 0], points[o + end - 1, 0] + 1
        j0, j1 = points[o + begin, 1], points[o + end - 1, 1] + 1
        every = max(1, (end - begin) // sampled)
        seen = 0
        for i in range(i0, i1, every):
            distances_to(a, i, j0, j1, every, width, C)
            for k in range((j1 - j0 + every - 1) // every):
                if C[k] == C[k]:
                    block[seen] = C[k]
                    seen += 1
        background[s] = median(block[:seen])
