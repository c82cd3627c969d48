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
def near_pairs(a, spans, k0, k1, width, limit, loose, unlike):
    """Warp spans k0 to k1 over all later ones that may be alike; pairs nearer than `limit` and how far apart they are.

    May be alike: they do not overlap, neither lasts more than `unlike` times as long as the other, and laid over one
    another without warping they are nearer than `loose`.
    """
    M = a.shape[0] // width
    pairs = np.empty((256, 2), np.int64)
    costs = np.empty(256)
    n = 0
    longest = 0
    for k in range(spans.shape[0]):
        longest = max(longest, spans[k, 1] - spans[k, 0])
    C = np.empty((3, longest))
    W = np.empty((3, longest), np.int64)
    d = np.empty((2, longest), np.float32)
    for x in range(k0, k1):
        start, stop = spans[x]
        length = stop - start
        for y in range(x + 1, spans.shape[0]):
            begin, end = spans[y]
            other = end - begin
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
                if not apart <= SAMPLES * loose:
                    break
            if not apart <= SAMPLES * loose:
                continue
            cost = _warped(a, start, stop, begin, end, width, C, W, d)
            if cost < limit:
                if n == costs.size:
                    pairs = np.concatenate((pairs, np.empty_like(pairs)))
                    costs = np.concatenate((costs, np.empty_like(costs)))
                pairs[n, 0], pairs[n, 1], costs[n] = x, y, cost
                n += 1
    return pairs[:n], costs[:n]


@njit(cache=True, nogil=True)
def _warped(a, start, stop, begin, end, width, C, W, d):
    """Mean distance of two stretches along their warping path, both ends bound, neither twice as fast as the other.

    A diagonal step weighs 2, a straight one, taken together with the diagonal one before it, 1.
    """
    M = end - begin
    for i in range(stop - start):
        C0, C1, C2 = C[i % 3], C[(i - 1) % 3], C[(i - 2) % 3]
        W0, W1, W2 = W[i % 3], W[(i - 1) % 3], W[(i - 2) % 3]
        d0, d1 = d[i % 2], d[(i - 1) % 2]
        distances_to(a, start + i, begin, end, 1, width, d0)
        for j in range(M):
            best, weight = np.inf, 0
            if i == 0 and j == 0:
                best, weight = 2.0 * d0[j], 2
            if i > 0 and j > 0 and C1[j - 1] + 2.0 * d0[j] < best:
                best, weight = C1[j - 1] + 2.0 * d0[j], W1[j - 1] + 2
            if i > 1 and j > 0 and C2[j - 1] + 2.0 * d1[j] + d0[j] < best:
                best, weight = C2[j - 1] + 2.0 * d1[j] + d0[j], W2[j - 1] + 3
            if i > 0 and j > 1 and C1[j - 2] + 2.0 * d0[j - 1] + d0[j] < best:
                best, weight = C1[j - 2] + 2.0 * d0[j - 1] + d0[j], W1[j - 2] + 3
            C0[j], W0[j] = best, weight
    i = stop - start - 1
    return C[i % 3, M - 1] / max(1, W[i % 3, M - 1])
