"""Whole movements laid over one another: every course by recursion, every pair by the general alignment."""

from functools import cache

import numpy as np

from leitmotion.motion import DataError
from leitmotion.similarity import align


def course(d, j):
    """Least mean distance a row of a course through d (n, M) that ends in column j, and where it begins."""
    n = len(d)

    @cache
    def best(i, j):
        if j < 0:
            return np.inf, 0
        if i == 0:
            return d[0, j], j
        ways = [(best(i - 1, j - 1)[0] + d[i, j], best(i - 1, j - 1)[1])]
        ways.append((best(i - 1, j - 2)[0] + d[i, j], best(i - 1, j - 2)[1]))
        if i > 1:
            ways.append((best(i - 2, j - 1)[0] + d[i - 1, j] + d[i, j], best(i - 2, j - 1)[1]))
        return min(ways, key=lambda way: way[0])

    total, begin = best(n - 1, j)
    return total / n, begin


def near_pairs(d, spans, limit, loose, unlike):
    """Pairs of stretches that do not overlap, as alike as the kernel asks, and how far apart they are."""
    found = {}
    for x, (a, b) in enumerate(spans):
        for y, (c, e) in list(enumerate(spans))[x + 1 :]:
            lengths = sorted((b - a, e - c))
            if (c < b and a < e) or lengths[1] > unlike * lengths[0]:
                continue
            straight = [d[a + (b - a - 1) * k // 8, c + (e - c - 1) * k // 8] for k in range(9)]
            if np.mean(straight) > loose:
                continue
            try:
                path = align(d[a:b, c:e], step="symmetricP1").path
            except DataError:
                continue
            weights = np.append(2, np.diff(path, axis=0).sum(axis=1))  # a diagonal step 2, a straight one 1
            cost = np.average(d[a:b, c:e][tuple(path.T)], weights=weights)
            if cost < limit:
                found[x, y] = cost
    return found
