# mypy: allow-untyped-defs
"""Loops over the posture matrix. Plain arrays and numbers in, plain arrays out; nothing is checked here."""

import numpy as np
from numba import njit

NONE, START, DIAGONAL, STEEP, FLAT = 0, 1, 2, 3, 4  # how a path came into a cell


@njit(cache=True)
def amplitudes(D, reach):
    """Distance of the farthest posture within `reach` frames of each moment, shape (N,)."""
    N = D.shape[0]
    A = np.zeros(N, np.float32)
    for i in range(N):
        for j in range(max(0, i - reach), min(N, i + reach + 1)):
            if D[i, j] > A[i]:
                A[i] = D[i, j]
    return A


@njit(cache=True)
def align_locally(D, theta, still, still_distance, still_gain, ceiling, least):
    """Align a recording locally with itself above the diagonal, by steps (1, 1), (2, 1) and (1, 2).

    A cell gains 1 - d / theta, never less than -1. H is the running gain: it starts anew where it would fall below
    0, and enters a step at most `ceiling` high, so that no path bridges a long gap. S is the gain without that
    ceiling. What is nearer to the diagonal than the first moment that differs is no return.

    Returns the step into each cell and the ends of the paths: rows, columns and gains.
    """
    N = D.shape[0]
    step_into = np.zeros((N, N), np.int8)
    H = np.zeros((3, N), np.float32)  # the last three rows
    S = np.zeros((3, N), np.float32)
    extended = np.zeros((3, N), np.bool_)
    rows, columns = np.empty(1024, np.int32), np.empty(1024, np.int32)
    gains = np.empty(1024, np.float32)
    found = 0
    for i in range(N + 3):
        now, before, earlier = i % 3, (i - 1) % 3, (i - 2) % 3
        left = np.float32(0.0)
        for j in range(N):  # row i - 3 is complete: of neighbouring ends of paths note the best
            right = S[now, j + 1] if j + 1 < N else np.float32(0.0)
            ends = S[now, j] > least and not extended[now, j] and S[now, j] >= left and S[now, j] > right
            left = S[now, j]
            if ends:
                if found == rows.size:
                    rows = np.concatenate((rows, np.empty_like(rows)))
                    columns = np.concatenate((columns, np.empty_like(columns)))
                    gains = np.concatenate((gains, np.empty_like(gains)))
                rows[found], columns[found], gains[found] = i - 3, j, S[now, j]
                found += 1
            H[now, j], S[now, j], extended[now, j] = 0.0, 0.0, False
        if i >= N:
            continue
        first = i + 1
        while first < N and not D[i, first] >= min(theta[i], theta[first]):
            first += 1
        for j in range(first, N):
            h, s, step = np.float32(0.0), np.float32(0.0), START
            if i > 0 and H[before, j - 1] > h:
                h, s, step = H[before, j - 1], S[before, j - 1], DIAGONAL
            if i > 1 and H[earlier, j - 1] > h + 1e-6:
                h, s, step = H[earlier, j - 1], S[earlier, j - 1], STEEP
            if i > 0 and j > 1 and H[before, j - 2] > h + 1e-6:
                h, s, step = H[before, j - 2], S[before, j - 2], FLAT
            closeness = min(theta[i], theta[j])
            if step == START and not D[i, j] < closeness:
                continue  # most cells: no path comes here and none begins
            if still[i] or still[j]:
                gain = still_gain if D[i, j] < still_distance else np.float32(-1.0)
            else:
                gain = max(np.float32(1.0) - D[i, j] / closeness, np.float32(-1.0))
                if not gain >= -1.0:  # nothing was seen
                    gain = np.float32(-1.0)
            h = min(h, ceiling) + gain
            if h > 0:
                H[now, j], S[now, j], step_into[i, j] = h, s + gain, step
                if gain > 0:
                    if step == DIAGONAL:
                        extended[before, j - 1] = True
                    elif step == STEEP:
                        extended[earlier, j - 1] = True
                    elif step == FLAT:
                        extended[before, j - 2] = True
    return step_into, rows[:found], columns[:found], gains[:found]


@njit(cache=True)
def walk_back(step_into, rows, columns, width, shortest):
    """Follow the steps back from each end in turn and close a corridor of `width` frames around the path.

    A closed cell has no step any more, so that a later path stops where an earlier one ran. Returns the paths of at
    least `shortest` frames in both directions, one after another (M, 2), and where each begins and the last ends.
    """
    N = step_into.shape[0]
    path = np.empty((2 * N, 2), np.int64)
    points = np.empty((1024, 2), np.int64)
    offsets = [0]
    total = 0
    for k in range(rows.size):
        i, j = rows[k], columns[k]
        n = 0
        while step_into[i, j] != NONE:
            path[n, 0], path[n, 1] = i, j
            n += 1
            step = step_into[i, j]
            if step == START:
                break
            i -= 2 if step == STEEP else 1
            j -= 2 if step == FLAT else 1
        for m in range(n):
            for a in range(max(0, path[m, 0] - width), min(N, path[m, 0] + width + 1)):
                for b in range(max(0, path[m, 1] - width), min(N, path[m, 1] + width + 1)):
                    step_into[a, b] = NONE
        if n == 0 or min(path[0, 0] - path[n - 1, 0], path[0, 1] - path[n - 1, 1]) + 1 < shortest:
            continue
        while total + n > len(points):
            points = np.concatenate((points, np.empty_like(points)))
        for m in range(n):
            points[total + m, 0], points[total + m, 1] = path[n - 1 - m, 0], path[n - 1 - m, 1]
        total += n
        offsets.append(total)
    return points[:total], np.array(offsets)
