# mypy: allow-untyped-defs
"""Loops of the double metric: distances of postures of quaternions, tile by tile, symmetric to the bit.

Frames lie along the last axis, ``a (4 M, N)``, so that the innermost loop runs over neighbouring columns and
vectorises. A distance depends on its two frames alone, to the bit: whatever else a tile holds, the same operations
make it in the same order.
"""

import math

import numpy as np
from numba import njit

TILE = 256  # frames: a tile is 256 KB and stays in the second-level cache
INNER, GEODESIC = 0, 1

_ZERO, _ONE, _TWO, _QUARTER = np.float32(0), np.float32(1), np.float32(2), np.float32(0.25)
_NAN = np.float32(np.nan)
# 4 asin(s) / s as a polynomial in s² on [0, 1/2], by Chebyshev's points; the angle errs by less than 1e-6 radians
_C = tuple(
    np.float32(c)
    for c in (4.00000037, 0.66659602, 0.30215264, 0.15439984, 0.24699747, -0.22589615, 0.40754119)
)
_C0, _C1, _C2, _C3, _C4, _C5, _C6 = _C


@njit(cache=True, nogil=True)
def distances(a, b, w, kind, C):
    """Fill the symmetric C (N, N) with the distances of a[:, i] to b[:, j]; only those with j >= i are computed.

    The distance of one link is 1 - |q . r| or the angle of the turn between q and r; those of M links are averaged with
    the weights w (M,), over what both frames show.
    """
    n = a.shape[1]
    tile = np.empty((TILE, TILE), np.float32)
    unseen = np.empty(n, np.bool_)
    for i in range(n):
        unseen[i] = False
        for k in range(a.shape[0]):
            unseen[i] |= a[k, i] != a[k, i] or b[k, i] != b[k, i]
    for i0 in range(0, n, TILE):
        i1 = min(i0 + TILE, n)
        rows = a[:, i0:i1].copy()  # packed, so that the compiler knows neighbours to be neighbours
        for j0 in range(i0, n, TILE):
            j1 = min(j0 + TILE, n)
            columns = b[:, j0:j1].copy()
            gaps = unseen[i0:i1].any() or unseen[j0:j1].any()
            _fill(rows, columns, w, kind, gaps, tile)
            for i in range(i1 - i0):
                for j in range(max(j0, i0 + i) - j0, j1 - j0):
                    C[i0 + i, j0 + j] = tile[i, j]
            for j in range(j1 - j0):
                for i in range(min(i1, j0 + j) - i0):
                    C[j0 + j, i0 + i] = tile[i, j]


@njit(cache=True, nogil=True)
def _fill(a, b, w, kind, gaps, tile):
    columns = b.shape[1]
    apart = np.empty(columns, np.float32)  # of one link
    total = np.empty(columns, np.float32)
    seen = np.empty(columns, np.float32)
    whole = _ZERO
    for m in range(w.size):
        whole += w[m]
    for i in range(a.shape[1]):
        for j in range(columns):
            total[j] = _ZERO
            seen[j] = _ZERO
        for m in range(w.size):
            q0, q1, q2, q3 = a[4 * m, i], a[4 * m + 1, i], a[4 * m + 2, i], a[4 * m + 3, i]
            r0, r1, r2, r3 = b[4 * m], b[4 * m + 1], b[4 * m + 2], b[4 * m + 3]
            if kind == INNER:
                _inner(q0, q1, q2, q3, r0, r1, r2, r3, apart)
            else:
                _geodesic(q0, q1, q2, q3, r0, r1, r2, r3, apart)
            if gaps:
                for j in range(columns):
                    both = apart[j] == apart[j]
                    total[j] += w[m] * apart[j] if both else _ZERO
                    seen[j] += w[m] if both else _ZERO
            else:
                for j in range(columns):
                    total[j] += w[m] * apart[j]
        C = tile[i]
        if gaps:
            for j in range(columns):
                C[j] = total[j] / seen[j] if seen[j] > _ZERO else _NAN
        else:
            for j in range(columns):
                C[j] = total[j] / whole


@njit(cache=True, nogil=True)
def _inner(q0, q1, q2, q3, r0, r1, r2, r3, apart):
    for j in range(apart.size):
        cosine = abs(q0 * r0[j] + q1 * r1[j] + q2 * r2[j] + q3 * r3[j])
        apart[j] = _ONE - (_ONE if cosine > _ONE else cosine)


@njit(cache=True, nogil=True)
def _geodesic(q0, q1, q2, q3, r0, r1, r2, r3, apart):
    """4 asin(|q - r| / 2) of the nearer of r and -r, which keeps its digits at small angles."""
    turned = 0
    for j in range(apart.size):
        d0, d1, d2, d3 = r0[j] - q0, r1[j] - q1, r2[j] - q2, r3[j] - q3
        apart[j] = d0 * d0 + d1 * d1 + d2 * d2 + d3 * d3
        turned += apart[j] > _TWO
    if turned:  # seldom: rotations are continuous in time
        for j in range(apart.size):
            s0, s1, s2, s3 = r0[j] + q0, r1[j] + q1, r2[j] + q2, r3[j] + q3
            across = s0 * s0 + s1 * s1 + s2 * s2 + s3 * s3
            apart[j] = across if apart[j] > _TWO else apart[j]
    for j in range(apart.size):
        s2 = _QUARTER * apart[j]
        series = _C5 + s2 * _C6
        series = _C4 + s2 * series
        series = _C3 + s2 * series
        series = _C2 + s2 * series
        series = _C1 + s2 * series
        apart[j] = math.sqrt(s2) * (_C0 + s2 * series)


@njit(cache=True, nogil=True)
def reaches(D, half, ahead, behind, until):
    """Fill how far ahead and behind each moment is followed by moments nearer than half, in frames.

    Where the distance first exceeds half lies between two frames, by a straight line; -1 where the recording, or what
    is seen of it, ends before. `until` is the first moment ahead that is far or unseen. NaN, and itself, where a moment
    is unseen.
    """
    n = D.shape[0]
    for i in range(n):
        if D[i, i] != D[i, i]:
            ahead[i], behind[i], until[i] = np.nan, np.nan, i
            continue
        ahead[i], behind[i], until[i] = -1.0, -1.0, n
        last = _ZERO
        for j in range(i + 1, n):
            if not D[i, j] < half:
                until[i] = j
                if D[i, j] >= half:
                    ahead[i] = j - i - 1 + (half - last) / (D[i, j] - last)
                break
            last = D[i, j]
        last = _ZERO
        for j in range(i - 1, -1, -1):
            if not D[i, j] < half:
                if D[i, j] >= half:
                    behind[i] = i - j - 1 + (half - last) / (D[i, j] - last)
                break
            last = D[i, j]
