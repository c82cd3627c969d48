# mypy: allow-untyped-defs
"""Loops of paper P, section 2.3, over the scaled posture matrix C (n, n).

The paper draws the later moment x to the right and the earlier one y upwards and keeps the half y < x. C is
symmetric, so the paper's column of moment x is here the row C[x], and its neighbours in y lie side by side.
Moments less than `apart` from one another are the same moment of one movement: no pattern and no way leads there.
"""

import numpy as np
from numba import njit


@njit(cache=True)
def thin(C, T, apart, minima):
    """Mark in minima (n, n) the vertical local minima of the binary cloud C < T (section 2.3.2)."""
    for x in range(C.shape[0]):
        for y in range(1, x - apart + 1):
            c = C[x, y]
            minima[x, y] = c < T and c < C[x, y - 1] and c < C[x, y + 1]


@njit(cache=True)
def start_points(minima, reach):
    """List the minima with none before (region B) and some ahead (region A), figure 8 (b), as rows (x, y).

    Either region reaches `reach` columns and, as no pattern is steeper than 2, twice as many rows; B to the
    left and below, A to the right and above. A leaves out the row of the point itself: a pattern of slope 1/2 has
    risen within two columns, and a flat anti-diagonal has steps of several points in one row.
    """
    n = minima.shape[0]
    found = [(0, 0) for _ in range(0)]
    for x in range(n):
        for y in range(x):
            if not minima[x, y]:
                continue
            before = _any_within(minima, x - reach, x, y - 2 * reach, y + 1)
            ahead = _any_within(minima, x + 1, x + reach + 1, y + 1, y + 2 * reach + 1)
            if ahead and not before:
                found.append((x, y))
    return found


@njit(cache=True)
def _any_within(minima, x0, x1, y0, y1):
    n = minima.shape[0]
    for x in range(max(x0, 0), min(x1, n)):
        for y in range(max(y0, 0), min(y1, n)):
            if minima[x, y]:
                return True
    return False


@njit(cache=True)
def trace(C, minima, x, y, apart, first_window, next_window, dearest):
    """Follow a pattern from its start point; returns the points chosen, rows (x, y) (section 2.3.3).

    The window's far edge cuts a column of minima; those within slope [1/2, 2] are candidates and the one with
    the least DTW cost, normalised by the length of its path, continues the pattern. An empty window shrinks.
    """
    points = [(x, y)]
    size = max(first_window, next_window)
    cost = np.empty((size + 1, 2 * size + 1), np.float32)
    window = first_window
    while True:
        _dtw_from(C, x, y, apart, window, cost)
        found = False
        for step in range(window, 0, -1):
            if x + step >= C.shape[0]:
                continue
            best, y_best = np.float32(dearest), -1
            for ahead in range((step + 1) // 2, 2 * step + 1):
                if y + ahead < x + step and minima[x + step, y + ahead] and cost[step, ahead] <= best:
                    best, y_best = cost[step, ahead], y + ahead
            if y_best >= 0:
                x, y = x + step, y_best
                points.append((x, y))
                found = True
                break
        if not found:
            return points
        window = next_window


@njit(cache=True)
def _dtw_from(C, x, y, apart, window, cost):
    """Fill cost[i, j] with the DTW cost from (x, y) to (x + i, y + j) over the length of its path."""
    n = C.shape[0]
    D = np.full((window + 1, 2 * window + 1), np.inf)
    L = np.zeros((window + 1, 2 * window + 1))
    for i in range(window + 1):
        for j in range(2 * window + 1):
            cost[i, j] = np.inf
            if x + i >= n or x + i - y - j < apart:
                continue
            best, length = np.inf, 0.0
            if i == 0 and j == 0:
                best = 0.0
            if i > 0 and j > 0 and D[i - 1, j - 1] < best:
                best, length = D[i - 1, j - 1], L[i - 1, j - 1]
            if i > 0 and D[i - 1, j] < best:
                best, length = D[i - 1, j], L[i - 1, j]
            if j > 0 and D[i, j - 1] < best:
                best, length = D[i, j - 1], L[i, j - 1]
            c = C[x + i, y + j]
            D[i, j] = best + c if c == c else np.inf
            L[i, j] = length + 1
            cost[i, j] = D[i, j] / L[i, j]
