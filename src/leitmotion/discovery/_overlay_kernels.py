# mypy: allow-untyped-defs
"""Loops that lay stretches over one another. Plain arrays and numbers in, plain arrays out; nothing is checked here."""

import numpy as np
from numba import njit

from leitmotion.similarity._kernels import accumulate, between, trace_back


@njit(cache=True, nogil=True)
def distances_along(apart, unseen):
    """Distances along the warping path, (K,): `unseen` where one is not known; what was not seen at all is left out."""
    N, M = apart.shape
    rows, columns = np.zeros(N, np.bool_), np.zeros(M, np.bool_)
    for i in range(N):
        for j in range(M):
            if apart[i, j] == apart[i, j]:
                rows[i] = columns[j] = True
    d = np.empty((rows.sum(), columns.sum()))
    n = 0
    for i in range(N):
        if rows[i]:
            m = 0
            for j in range(M):
                if columns[j]:
                    d[n, m] = apart[i, j] if apart[i, j] == apart[i, j] else unseen
                    m += 1
            n += 1
    if d.size == 0:
        return np.empty(0)
    move = np.empty(d.shape, np.uint8)
    accumulate(d, 1.0, False, False, move)
    path = trace_back(move, d.shape[1] - 1)
    along = np.empty(len(path))
    for k in range(len(path)):
        along[k] = d[path[k, 0], path[k, 1]]
    return along


@njit(cache=True, nogil=True)
def overlay(a, start, stop, begin, end, width, unseen):
    """Mean of these for moments [start, stop) and [begin, end) of a recording; `unseen` where nothing was seen."""
    apart = np.empty((stop - start, end - begin), np.float32)
    between(a, start, 1, begin, end, 1, width, apart)
    along = distances_along(apart, np.float32(unseen))
    return along.mean() if along.size else unseen


@njit(cache=True, nogil=True)
def warped(a, start, stop, begin, end, width):
    """Mean distance along the warping path, and the path (K, 2); infinite and empty where a moment was not seen."""
    apart = np.empty((stop - start, end - begin), np.float32)
    between(a, start, 1, begin, end, 1, width, apart)
    if not np.isfinite(apart).all():
        return np.inf, np.empty((0, 2), np.int64)
    d = apart.astype(np.float64)
    move = np.empty(d.shape, np.uint8)
    accumulate(d, 1.0, False, False, move)
    path = trace_back(move, d.shape[1] - 1)
    total = 0.0
    for k in range(len(path)):
        total += d[path[k, 0], path[k, 1]]
        path[k, 0] += start
        path[k, 1] += begin
    return total / len(path), path
