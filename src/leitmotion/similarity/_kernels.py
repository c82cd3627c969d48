# mypy: allow-untyped-defs
"""Loops of this room: tiles of distances between frames, and dynamic time warping.

In the tiles frames lie along the last axis, ``a (D, N)`` and ``b (D, M)``, so that the innermost loop runs
over neighbouring columns and vectorises. One tile of the result stays in cache while it is summed and while
it is mirrored. No sum crosses a tile and the compiler may not reorder any, so a distance depends on its two
frames alone, to the bit.
"""

import math

import numpy as np
from numba import njit

TILE = 256  # frames: a tile is 256 KB and stays in the second-level cache
POINTS, GROUPS, ANGLES = 0, 1, 2
START, DIAGONAL, DOWN, ACROSS, DOWN_TWO, ACROSS_TWO = 0, 1, 2, 3, 4, 5

_ZERO, _ONE, _TWO, _FOUR = np.float32(0), np.float32(1), np.float32(2), np.float32(4)
_C3, _C5, _C7, _C9, _C11 = (np.float32(c) for c in (1 / 6, 3 / 40, 15 / 336, 105 / 3456, 945 / 42240))


@njit(cache=True)
def self_distance(a, width, kind, C):
    """Fill the symmetric C (N, N): upper tiles computed, lower ones their mirror image."""
    n = a.shape[1]
    tile = np.empty((TILE, TILE), np.float32)
    for i0 in range(0, n, TILE):
        i1 = min(i0 + TILE, n)
        rows = a[:, i0:i1].copy()  # packed, so that the compiler knows neighbours to be neighbours
        for j0 in range(i0, n, TILE):
            j1 = min(j0 + TILE, n)
            _fill(rows, a[:, j0:j1].copy(), width, kind, tile)
            for i in range(i1 - i0):
                for j in range(j1 - j0):
                    C[i0 + i, j0 + j] = tile[i, j]
            if j0 > i0:
                for j in range(j1 - j0):
                    for i in range(i1 - i0):
                        C[j0 + j, i0 + i] = tile[i, j]


@njit(cache=True)
def cross_distance(a, b, width, kind, C):
    """Fill C (N, M)."""
    n, m = a.shape[1], b.shape[1]
    tile = np.empty((TILE, TILE), np.float32)
    for i0 in range(0, n, TILE):
        i1 = min(i0 + TILE, n)
        rows = a[:, i0:i1].copy()  # packed, so that the compiler knows neighbours to be neighbours
        for j0 in range(0, m, TILE):
            j1 = min(j0 + TILE, m)
            _fill(rows, b[:, j0:j1].copy(), width, kind, tile)
            for i in range(i1 - i0):
                for j in range(j1 - j0):
                    C[i0 + i, j0 + j] = tile[i, j]


@njit(cache=True, nogil=True)
def distances_to(a, i, first, stop, every, width, C):
    """Fill C with the distances of moment i to every n-th moment of [first, stop), bit for bit as in a tile."""
    M = a.shape[0] // width
    columns = (stop - first + every - 1) // every
    if every == 1 and width == 3:
        _points_to(a, i, first, columns, M, C)
        return
    for j in range(columns):
        C[j] = _distance(a, i, first + j * every, width, M)


@njit(cache=True, nogil=True, inline="always")
def _points_to(a, i, first, columns, M, C):
    seen = np.float32(M)
    for j in range(columns):
        C[j] = _ZERO
    for m in range(M):
        x, y, z = a[3 * m, i], a[3 * m + 1, i], a[3 * m + 2, i]
        xs, ys, zs = a[3 * m, first:], a[3 * m + 1, first:], a[3 * m + 2, first:]
        for j in range(columns):
            dx, dy, dz = xs[j] - x, ys[j] - y, zs[j] - z
            C[j] += math.sqrt(dx * dx + dy * dy + dz * dz)
    for j in range(columns):
        C[j] /= seen
    for j in range(columns):
        if C[j] != C[j]:  # something was not seen
            C[j] = _distance(a, i, first + j, 3, M)


@njit(cache=True, nogil=True)
def _distance(a, i, j, width, M):
    total, seen = _ZERO, _ZERO
    for m in range(M):
        square = _ZERO
        for k in range(m * width, (m + 1) * width):
            dx = a[k, j] - a[k, i]
            square += dx * dx
        if square == square:
            total += math.sqrt(square)
            seen += _ONE
    return total / seen if seen > _ZERO else np.float32(np.nan)


@njit(cache=True, nogil=True)
def between(a, row, every_row, first, stop, every, width, C):
    """Fill C with the distances of every n-th moment from `row` on to every m-th of [first, stop)."""
    for k in range(C.shape[0]):
        distances_to(a, row + k * every_row, first, stop, every, width, C[k])


@njit(cache=True, nogil=True)
def band(a, width, C):
    """Fill C (N, W): C[i, k] is the distance of moment i to moment i + k, NaN past the end."""
    n = a.shape[1]
    for i in range(n):
        stop = min(n, i + C.shape[1])
        if np.isnan(_distance(a, i, i, width, a.shape[0] // width)):  # nothing of this moment was seen
            stop = i
        distances_to(a, i, i, stop, 1, width, C[i])
        C[i, stop - i :] = np.nan


@njit(cache=True, nogil=True)
def along(a, i, j, width, C):
    """Fill C (K,) with the distances of moments i (K,) to moments j (K,)."""
    M = a.shape[0] // width
    for k in range(i.size):
        C[k] = _distance(a, i[k], j[k], width, M)


@njit(cache=True)
def _fill(a, b, width, kind, tile):
    if kind == POINTS:
        _points(a, b, tile)
    elif kind == GROUPS:
        _groups(a, b, width, tile)
    else:
        _angles(a, b, tile)


@njit(cache=True)
def _points(a, b, tile):
    """Paper P, eq. 2, every point seen: the mean over m of |p_i,m - p_j,m|."""
    M = a.shape[0] // 3
    columns = b.shape[1]
    for i in range(a.shape[1]):
        C = tile[i]
        for j in range(columns):
            C[j] = _ZERO
        for m in range(M):
            x, y, z = a[3 * m, i], a[3 * m + 1, i], a[3 * m + 2, i]
            xs, ys, zs = b[3 * m], b[3 * m + 1], b[3 * m + 2]
            for j in range(columns):
                dx, dy, dz = xs[j] - x, ys[j] - y, zs[j] - z
                C[j] += math.sqrt(dx * dx + dy * dy + dz * dz)
        for j in range(columns):
            C[j] /= np.float32(M)


@njit(cache=True)
def _groups(a, b, width, tile):
    """Do the same for groups of any width; NaN is unseen, the mean is over what both frames show."""
    M = a.shape[0] // width
    columns = b.shape[1]
    square = np.empty(columns, np.float32)
    seen = np.empty(columns, np.float32)
    for i in range(a.shape[1]):
        C = tile[i]
        for j in range(columns):
            C[j] = _ZERO
            seen[j] = _ZERO
        for m in range(M):
            for j in range(columns):
                square[j] = _ZERO
            for k in range(m * width, (m + 1) * width):
                x, xs = a[k, i], b[k]
                for j in range(columns):
                    dx = xs[j] - x
                    square[j] += dx * dx
            for j in range(columns):
                both = square[j] == square[j]
                C[j] += math.sqrt(square[j]) if both else _ZERO
                seen[j] += _ONE if both else _ZERO
        for j in range(columns):
            C[j] = C[j] / seen[j] if seen[j] > _ZERO else np.float32(np.nan)


@njit(cache=True)
def _angles(a, b, tile):
    """Mean angle between rotations q and r: 4 asin(|q - r| / 2) of the nearer of r and -r.

    Unlike 2 acos |q · r| it keeps its digits at small angles.
    """
    M = a.shape[0] // 4
    columns = b.shape[1]
    seen = np.empty(columns, np.float32)
    for i in range(a.shape[1]):
        C = tile[i]
        for j in range(columns):
            C[j] = _ZERO
            seen[j] = _ZERO
        for m in range(M):
            w, x, y, z = a[4 * m, i], a[4 * m + 1, i], a[4 * m + 2, i], a[4 * m + 3, i]
            ws, xs, ys, zs = b[4 * m], b[4 * m + 1], b[4 * m + 2], b[4 * m + 3]
            for j in range(columns):
                dw, dx, dy, dz = ws[j] - w, xs[j] - x, ys[j] - y, zs[j] - z
                sw, sx, sy, sz = ws[j] + w, xs[j] + x, ys[j] + y, zs[j] + z
                apart = dw * dw + dx * dx + dy * dy + dz * dz
                across = sw * sw + sx * sx + sy * sy + sz * sz
                both = apart == apart
                near = apart if apart < across else across
                angle = _FOUR * _asin(near / _FOUR)
                C[j] += angle if both else _ZERO
                seen[j] += _ONE if both else _ZERO
        for j in range(columns):
            C[j] = C[j] / seen[j] if seen[j] > _ZERO else np.float32(np.nan)


@njit(cache=True, inline="always")
def _asin(s2):
    """Arc sine of the root of s2 <= 1/2: halve the angle, then the series; without a branch, to vectorise."""
    s2 = min(s2, np.float32(0.5))
    h2 = s2 / (_TWO + _TWO * math.sqrt(_ONE - s2))
    series = _C9 + h2 * _C11
    series = _C7 + h2 * series
    series = _C5 + h2 * series
    series = _C3 + h2 * series
    return _TWO * math.sqrt(h2) * (_ONE + h2 * series)


@njit(cache=True, nogil=True)
def accumulate(d, w, limited, open_begin, move):
    """Dynamic time warping over the local distances d (N, M).

    D(i, j) is the least sum of weighted distances of a path to (i, j), W(i, j) the sum of its weights: a
    diagonal step weighs w, a straight one 1. `limited` allows a straight step only after a diagonal one,
    both taken together. Fills move (N, M), returns the last row of D and of W; ties take the diagonal.
    """
    N, M = d.shape
    D = np.full((3, M), np.inf)  # rows i, i - 1, i - 2 in turn
    W = np.zeros((3, M))
    for i in range(N):
        D0, D1, D2 = D[i % 3], D[(i - 1) % 3], D[(i - 2) % 3]
        W0, W1, W2 = W[i % 3], W[(i - 1) % 3], W[(i - 2) % 3]
        for j in range(M):
            best, weight, how = np.inf, 0.0, START
            if i == 0 and (j == 0 or open_begin):
                best, weight = w * d[i, j], w
            if i > 0 and j > 0 and D1[j - 1] + w * d[i, j] < best:
                best, weight, how = D1[j - 1] + w * d[i, j], W1[j - 1] + w, DIAGONAL
            if limited:
                if i > 1 and j > 0 and D2[j - 1] + w * d[i - 1, j] + d[i, j] < best:
                    best, weight, how = D2[j - 1] + w * d[i - 1, j] + d[i, j], W2[j - 1] + w + 1, DOWN_TWO
                if i > 0 and j > 1 and D1[j - 2] + w * d[i, j - 1] + d[i, j] < best:
                    best, weight, how = D1[j - 2] + w * d[i, j - 1] + d[i, j], W1[j - 2] + w + 1, ACROSS_TWO
            else:
                if i > 0 and D1[j] + d[i, j] < best:
                    best, weight, how = D1[j] + d[i, j], W1[j] + 1, DOWN
                if j > 0 and D0[j - 1] + d[i, j] < best:
                    best, weight, how = D0[j - 1] + d[i, j], W0[j - 1] + 1, ACROSS
            D0[j], W0[j] = best, weight
            move[i, j] = how
    return D[(N - 1) % 3], W[(N - 1) % 3]


@njit(cache=True, nogil=True)
def warping_cost(a, N, width, unseen):
    """Mean distance along the path of `accumulate` (w = 1, ends bound) from moments [0, N) to those that follow them.

    Only one row is held, so the number of cells that the path has is carried along. `unseen` is the distance of
    moments that share no group.
    """
    M = a.shape[1] - N
    d = np.empty(M, np.float32)
    D, K = np.full(M, np.inf), np.zeros(M, np.int64)  # of row i to the left of j, of row i - 1 from there on
    for i in range(N):
        distances_to(a, i, N, N + M, 1, width, d)
        diagonal, k_diagonal = 0.0 if i == 0 else np.inf, 0
        left, k_left = np.inf, 0
        for j in range(M):
            up, k_up = D[j], K[j]
            best, k = (diagonal, k_diagonal) if diagonal <= up else (up, k_up)
            best, k = (best, k) if best <= left else (left, k_left)
            left, k_left = best + (np.float64(d[j]) if d[j] == d[j] else unseen), k + 1
            D[j], K[j] = left, k_left
            diagonal, k_diagonal = up, k_up
    return D[M - 1] / K[M - 1]


@njit(cache=True, nogil=True)
def trace_back(move, j):
    """Follow the moves from the last row's column j to where the path started, and turn the path round."""
    i = move.shape[0] - 1
    path = np.empty((i + j + 1, 2), np.int64)
    k = path.shape[0]
    while True:
        k -= 1
        path[k, 0], path[k, 1] = i, j
        how = move[i, j]
        if how == START:
            return path[k:]
        if how in (DOWN_TWO, ACROSS_TWO):
            i, j = (i - 1, j) if how == DOWN_TWO else (i, j - 1)
            k -= 1
            path[k, 0], path[k, 1] = i, j
            how = DIAGONAL
        if how in (DIAGONAL, DOWN):
            i -= 1
        if how in (DIAGONAL, ACROSS):
            j -= 1
