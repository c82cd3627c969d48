# mypy: allow-untyped-defs
"""Loops of the double metric: distances of postures of quaternions, tile by tile, symmetric to the bit.

Frames lie along the last axis, ``a (4 M, N)``, so that the innermost loop runs over neighbouring columns and
vectorises.
"""

import numpy as np
from numba import njit

from leitmotion.similarity._kernels import _asin

TILE = 256  # frames: a tile is 256 KB and stays in the second-level cache
INNER, GEODESIC = 0, 1

_ZERO, _ONE, _FOUR = np.float32(0), np.float32(1), np.float32(4)


@njit(cache=True, nogil=True)
def distances(a, b, w, kind, C):
    """Fill the symmetric C (N, N) with the distances of a[:, i] to b[:, j]; only those with j >= i are computed.

    The distance of one link is 1 - |q . r| or the angle of the turn between q and r; those of M links are averaged with
    the weights w (M,), over what both frames show.
    """
    n = a.shape[1]
    tile = np.empty((TILE, TILE), np.float32)
    for i0 in range(0, n, TILE):
        i1 = min(i0 + TILE, n)
        rows = a[:, i0:i1].copy()  # packed, so that the compiler knows neighbours to be neighbours
        for j0 in range(i0, n, TILE):
            j1 = min(j0 + TILE, n)
            _fill(rows, b[:, j0:j1].copy(), w, kind, tile)
            for i in range(i1 - i0):
                for j in range(max(j0, i0 + i) - j0, j1 - j0):
                    C[i0 + i, j0 + j] = tile[i, j]
            for j in range(j1 - j0):
                for i in range(min(i1, j0 + j) - i0):
                    C[j0 + j, i0 + i] = tile[i, j]


@njit(cache=True, nogil=True)
def _fill(a, b, w, kind, tile):
    columns = b.shape[1]
    seen = np.empty(columns, np.float32)
    for i in range(a.shape[1]):
        C = tile[i, :columns]
        for j in range(columns):
            C[j] = _ZERO
            seen[j] = _ZERO
        for m in range(w.size):
            q0, q1, q2, q3 = a[4 * m, i], a[4 * m + 1, i], a[4 * m + 2, i], a[4 * m + 3, i]
            r0, r1, r2, r3 = b[4 * m], b[4 * m + 1], b[4 * m + 2], b[4 * m + 3]
            if kind == INNER:
                _inner(q0, q1, q2, q3, r0, r1, r2, r3, w[m], C, seen)
            else:
                _geodesic(q0, q1, q2, q3, r0, r1, r2, r3, w[m], C, seen)
        for j in range(columns):
            C[j] = C[j] / seen[j] if seen[j] > _ZERO else np.float32(np.nan)


@njit(cache=True, nogil=True)
def _inner(q0, q1, q2, q3, r0, r1, r2, r3, w, C, seen):
    for j in range(C.size):
        cosine = abs(q0 * r0[j] + q1 * r1[j] + q2 * r2[j] + q3 * r3[j])
        both = cosine == cosine
        C[j] += w * (_ONE - min(cosine, _ONE)) if both else _ZERO
        seen[j] += w if both else _ZERO


@njit(cache=True, nogil=True)
def _geodesic(q0, q1, q2, q3, r0, r1, r2, r3, w, C, seen):
    """4 asin(|q - r| / 2) of the nearer of r and -r, which keeps its digits at small angles."""
    for j in range(C.size):
        d0, d1, d2, d3 = r0[j] - q0, r1[j] - q1, r2[j] - q2, r3[j] - q3
        s0, s1, s2, s3 = r0[j] + q0, r1[j] + q1, r2[j] + q2, r3[j] + q3
        apart = d0 * d0 + d1 * d1 + d2 * d2 + d3 * d3
        across = s0 * s0 + s1 * s1 + s2 * s2 + s3 * s3
        both = apart == apart
        near = apart if apart < across else across
        angle = _FOUR * _asin(near / _FOUR)
        C[j] += w * angle if both else _ZERO
        seen[j] += w if both else _ZERO


@njit(cache=True, nogil=True)
def reaches(D, half, ahead, behind):
    """Fill how far ahead and behind each moment is followed by moments nearer than half, in frames; -1 to the end.

    Where the distance first exceeds half lies between two frames, by a straight line.
    """
    n = D.shape[0]
    for i in range(n):
        ahead[i] = -1.0
        last = _ZERO
        for j in range(i + 1, n):
            if D[i, j] >= half:
                ahead[i] = j - i - 1 + (half - last) / (D[i, j] - last)
                break
            last = D[i, j]
        behind[i] = -1.0
        last = _ZERO
        for j in range(i - 1, -1, -1):
            if D[i, j] >= half:
                behind[i] = i - j - 1 + (half - last) / (D[i, j] - last)
                break
            last = D[i, j]
