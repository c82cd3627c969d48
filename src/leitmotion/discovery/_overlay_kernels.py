# mypy: allow-untyped-defs
"""Loops that lay stretches over one another. Plain arrays and numbers in, plain arrays out; nothing is checked here."""

import numpy as np
from numba import njit

from leitmotion.similarity._kernels import accumulate, trace_back


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
