# mypy: allow-untyped-defs
"""Kernels of proximity signals: waypoints, and local alignment of a recording with itself on a dense matrix."""

import numpy as np
from numba import njit

NONE, START, DIAGONAL, STEEP, FLAT = 0, 1, 2, 3, 4


@njit(cache=True, nogil=True)
def waypoints(own, step):
    """Moments at which the body has moved on by a step since the last that was taken; what is unseen is passed over."""
    T = own.shape[0]
    at = np.empty(T, np.int64)
    count = 0
    for t in range(T):
        if own[t, t] != own[t, t]:
            continue
        if count == 0 or own[at[count - 1], t] >= step:
            at[count] = t
            count += 1
    return at[:count]


@njit(cache=True, nogil=True)
def align(apart, lower, upper, ceiling, H, S, how):
    """Local alignment of rows i with columns lower[i] to upper[i], by steps (1, 1), (2, 1) and (1, 2).

    A cell gains 1 - apart, never less than -1. H is the running gain: it starts anew where it would fall below
    0, and enters a step at most `ceiling` high, so that no path bridges a long gap. S is the gain without that
    ceiling, `how` the step by which a cell is entered.
    """
    K = apart.shape[0]
    for i in range(K):
        for j in range(lower[i], upper[i]):
            gain = np.float32(1) - apart[i, j]
            if not gain >= np.float32(-1):  # also where nothing was seen
                gain = np.float32(-1)
            h, s, step = np.float32(0), np.float32(0), START
            if i >= 1 and j >= 1 and H[i - 1, j - 1] > h:
                h, s, step = H[i - 1, j - 1], S[i - 1, j - 1], DIAGONAL
            if i >= 2 and j >= 1 and H[i - 2, j - 1] > h + np.float32(1e-6):
                h, s, step = H[i - 2, j - 1], S[i - 2, j - 1], STEEP
            if i >= 1 and j >= 2 and H[i - 1, j - 2] > h + np.float32(1e-6):
                h, s, step = H[i - 1, j - 2], S[i - 1, j - 2], FLAT
            h = min(h, ceiling) + gain
            if h > 0:
                H[i, j], S[i, j], how[i, j] = h, s + gain, step


@njit(cache=True, nogil=True)
def ends(S, least):
    """Cells that gain more than `least`, of their neighbours the most: where a path may end."""
    K, N = S.shape
    rows, columns = np.empty(1024, np.int64), np.empty(1024, np.int64)
    found = 0
    for i in range(K):
        for j in range(N):
            s = S[i, j]
            if s <= least:
                continue
            best = True
            for k in range(max(i - 1, 0), min(i + 3, K)):
                for m in range(max(j - 1, 0), min(j + 3, N)):
                    if S[k, m] > s:
                        best = False
            if best:
                if found == rows.size:
                    rows = np.concatenate((rows, np.empty_like(rows)))
                    columns = np.concatenate((columns, np.empty_like(columns)))
                rows[found], columns[found] = i, j
                found += 1
    return rows[:found], columns[:found]


@njit(cache=True, nogil=True)
def trace(how, taken, i, j, path):
    """Walk back from a cell to where its path begins, or to where it meets a path that was taken; returns how long."""
    length = 0
    while True:
        if taken[i, j]:
            break
        path[length, 0], path[length, 1] = i, j
        length += 1
        step = how[i, j]
        if step == DIAGONAL:
            i, j = i - 1, j - 1
        elif step == STEEP:
            i, j = i - 2, j - 1
        elif step == FLAT:
            i, j = i - 1, j - 2
        else:
            break
    return length


@njit(cache=True, nogil=True)
def take(taken, path, band):
    """Mark the cells along a path, and those within a band of it, as taken."""
    K, N = taken.shape
    for k in range(path.shape[0]):
        for i in range(max(path[k, 0] - band, 0), min(path[k, 0] + band + 1, K)):
            for j in range(max(path[k, 1] - band, 0), min(path[k, 1] + band + 1, N)):
                taken[i, j] = True
