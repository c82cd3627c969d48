# mypy: allow-untyped-defs
"""Loops that compare whole movements. Plain arrays and numbers in, plain arrays out; nothing is checked here."""

import numpy as np
from numba import njit

from leitmotion.similarity._kernels import _distance, distances_to

SAMPLES = 9  # moments at which two movements are compared before they are warped


@njit(cache=True, nogil=True)
def courses(a, first, last, start, stop, width, unseen):
    """Lay moments [first, last) over every part of [start, stop): open begin, open end, steps (1, 1), (1, 2), (2, 1).

    Returns the mean distance a moment of the first of the best course that ends at each moment, and where it begins.
    """
    M = stop - start
    d = np.empty((2, M), np.float32)
    C = np.full((3, M), np.inf)
    B = np.zeros((3, M), np.int64)
    for i in range(last - first):
        distances_to(a, first + i, start, stop, 1, width, d[i % 2])
        for j in range(M):
            if d[i % 2, j] != d[i % 2, j]:
                d[i % 2, j] = unseen
        d0, d1 = d[i % 2], d[(i - 1) % 2]
        C0, C1, C2 = C[i % 3], C[(i - 1) % 3], C[(i - 2) % 3]
        B0, B1, B2 = B[i % 3], B[(i - 1) % 3], B[(i - 2) % 3]
        for j in range(M):
            best, begin = np.inf, j
            if i == 0:
                best = d0[j]
            else:
                if j > 0 and C1[j - 1] + d0[j] < best:
                    best, begin = C1[j - 1] + d0[j], B1[j - 1]
                if j > 1 and C1[j - 2] + d0[j] < best:
                    best, begin = C1[j - 2] + d0[j], B1[j - 2]
                if i > 1 and j > 0 and C2[j - 1] + d1[j] + d0[j] < best:
                    best, begin = C2[j - 1] + d1[j] + d0[j], B2[j - 1]
            C0[j], B0[j] = best, begin
    i = last - first - 1
    return C[i % 3] / (last - first), B[i % 3]


@njit(cache=True, nogil=True)
def near_courses(a, first, last, free, least, farthest, width, unseen):
    """Do so for each free stretch (F, 2); the courses of `least` moments or more that are nearer than `farthest`.

    Returns their costs, and where each starts and stops (K, 2).
    """
    moments = 0
    for f in range(free.shape[0]):
        moments += free[f, 1] - free[f, 0]
    costs, places = np.empty(moments), np.empty((moments, 2), np.int64)
    n = 0
    for f in range(free.shape[0]):
        start, stop = free[f]
        if stop - start < least:
            continue
        cost, begins = courses(a, first, last, start, stop, width, unseen)
        for j in range(stop - start):
            if cost[j] < farthest and j + 1 - begins[j] >= least:
                costs[n], places[n, 0], places[n, 1] = cost[j], start + begins[j], start + j + 1
                n += 1
    return costs[:n], places[:n]


@njit(cache=True, nogil=True)
def clear_courses(a, movements, places, limits, taken, sampled, width):
    """Which courses cross nothing that is taken and lie in surroundings farther than their limit, in order.

    Each that does is taken at once. A course is a movement, where it starts and where it stops; its surroundings are
    the rectangle of the two stretches, of which each side is sampled.
    """
    found = np.empty(places.shape[0], np.int64)
    n = 0
    for k in range(places.shape[0]):
        which, start, stop = places[k]
        if taken[start:stop].any():
            continue
        if most_are_farther(
            a, movements[which, 0], movements[which, 1], start, stop, limits[k], sampled, width
        ):
            taken[start:stop] = True
            found[n] = k
            n += 1
    return found[:n]


@njit(cache=True, nogil=True)
def most_are_farther(a, first, last, start, stop, limit, sampled, width):
    """Whether the median distance of moments [first, last) from [start, stop) is above a limit.

    Distances that are not known are left out, and only as many are computed as it takes to know.
    """
    every, each = 1 + (last - first) // sampled, 1 + (stop - start) // sampled
    rows, columns = (last - first + every - 1) // every, (stop - start + each - 1) // each
    d = np.empty(columns, np.float32)
    farther, others = 0, 0
    nearest, farthest = np.inf, -np.inf  # on either side of the limit
    for i in range(rows):
        distances_to(a, first + i * every, start, stop, each, width, d)
        for j in range(columns):
            if d[j] > limit:
                farther += 1
                nearest = min(nearest, d[j])
            elif d[j] <= limit:
                others += 1
                farthest = max(farthest, d[j])
        if 2 * max(farther, others) > rows * columns:
            break
    if farther == others:
        return farther > 0 and nearest + farthest > 2 * limit
    return farther > others


@njit(cache=True, nogil=True)
def near_pairs(a, spans, k0, k1, later, width, limit, loose, unlike):
    """Warp spans k0 to k1 over later ones that may be alike; pairs nearer than `limit` and how far apart they are.

    Spans stand in order; those that begin `later` moments later, from the first number to below the second, are
    compared. May be alike: they do not overlap, neither lasts more than `unlike` times as long as the other, and laid
    over one another without warping they are nearer than `loose`. Also tells how many distances that took.
    """
    M = a.shape[0] // width
    pairs = np.empty((256, 2), np.int64)
    costs = np.empty(256)
    n, work = 0, 0
    longest = 0
    for k in range(spans.shape[0]):
        longest = max(longest, spans[k, 1] - spans[k, 0])
    C = np.empty((3, longest))
    d = np.empty((2, longest), np.float32)
    for x in range(k0, k1):
        start, stop = spans[x]
        length = stop - start
        for y in range(max(x + 1, np.searchsorted(spans[:, 0], start + later[0])), spans.shape[0]):
            begin, end = spans[y]
            other = end - begin
            if begin - start >= later[1]:
                break
            if begin < stop and start < end:
                continue
            if length > unlike * other or other > unlike * length:
                continue
            apart = 0.0
            for s in range(SAMPLES):
                p = (4 * s + SAMPLES // 2) % SAMPLES  # the middle first
                i = start + (length - 1) * p // (SAMPLES - 1)
                j = begin + (other - 1) * p // (SAMPLES - 1)
                apart += _distance(a, i, j, width, M)
                work += 1
                if not apart <= SAMPLES * loose:
                    break
            if not apart <= SAMPLES * loose:
                continue
            cost, cells = _warped(a, start, stop, begin, end, width, limit, C, d)
            work += cells
            if cost < limit:
                if n == costs.size:
                    pairs = np.concatenate((pairs, np.empty_like(pairs)))
                    costs = np.concatenate((costs, np.empty_like(costs)))
                pairs[n, 0], pairs[n, 1], costs[n] = x, y, cost
                n += 1
    return pairs[:n], costs[:n], work


@njit(cache=True, nogil=True)
def _warped(a, start, stop, begin, end, width, limit, C, d):
    """Mean distance of two stretches along their warping path, both ends bound, neither twice as fast as the other.

    A diagonal step weighs 2, a straight one, taken together with the diagonal one before it, 1, so that all paths weigh
    the same. Infinite as soon as no path can stay below `limit`. Also tells how many distances that took.
    """
    rows, columns = stop - start - 1, end - begin - 1
    if rows > 2 * columns or columns > 2 * rows:
        return np.inf, 0
    weight = rows + columns + 2
    best_before, cells = np.inf, 0
    for i in range(rows + 1):
        left = rows - i
        low = max((i + 1) // 2, columns - 2 * left)  # between these columns both ends are within reach
        high = min(2 * i, columns - (left + 1) // 2)
        C0, C1, C2 = C[i % 3], C[(i - 1) % 3], C[(i - 2) % 3]
        d0, d1 = d[i % 2], d[(i - 1) % 2]
        first, last = max(0, low - 1), min(columns, high + 1)  # and beside them, where a straight step leads
        distances_to(a, start + i, begin + first, begin + last + 1, 1, width, d0[first:])
        cells += last + 1 - first
        for j in range(max(0, low - 2), min(columns, high + 3) + 1):
            C0[j] = np.inf
        best_here = np.inf
        for j in range(low, high + 1):
            best = np.inf
            if i == 0 and j == 0:
                best = 2.0 * d0[j]
            if i > 0 and j > 0 and C1[j - 1] + 2.0 * d0[j] < best:
                best = C1[j - 1] + 2.0 * d0[j]
            if i > 1 and j > 0 and C2[j - 1] + 2.0 * d1[j] + d0[j] < best:
                best = C2[j - 1] + 2.0 * d1[j] + d0[j]
            if i > 0 and j > 1 and C1[j - 2] + 2.0 * d0[j - 1] + d0[j] < best:
                best = C1[j - 2] + 2.0 * d0[j - 1] + d0[j]
            C0[j] = best
            best_here = min(best_here, best)
        if min(best_before, best_here) >= limit * weight:
            return np.inf, cells
        best_before = best_here
    return C[rows % 3, columns] / weight, cells
