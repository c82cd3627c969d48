# mypy: allow-untyped-defs
"""Loops that find where a recording may be like itself. Plain arrays and numbers in and out; nothing is checked.

Moments stand in tiles, ``tiles (G, D * LANES)``; see :mod:`leitmotion.discovery.tiles`.
"""

import math

import numpy as np
from numba import njit

from leitmotion.discovery.tiles import BLOCK, LANES
from leitmotion.similarity._kernels import _distance

_ZERO, _ONE = np.float32(0), np.float32(1)


@njit(cache=True, nogil=True)
def first_apart(a, width, theta, reach, i0, i1, first):
    """Fill first (N,) from i0 to i1: the first moment after each that is not like it, at most `reach` moments ahead."""
    N, M = a.shape[1], a.shape[0] // width
    for i in range(i0, i1):
        stop = min(N, i + 1 + reach)
        j = i + 1
        while j < stop and _distance(a, i, j, width, M) < min(theta[i], theta[j]):
            j += 1
        first[i] = j


@njit(cache=True, nogil=True)
def block_bounds(a, width, theta):
    """Summarise what may be alike in blocks of moments: a centre, how far the others are from it, greatest theta.

    Only moments whose theta is positive count; of a block without one theta is negative. A group that some moment did
    not see is NaN in the centre.
    """
    D, N = a.shape
    M = D // width
    B = (N + BLOCK - 1) // BLOCK
    centres = np.zeros((D, B), np.float32)
    radius = np.zeros(B, np.float32)
    most = np.full(B, np.float32(-1))
    inside = np.empty(BLOCK, np.int64)
    for b in range(B):
        n = 0
        for i in range(b * BLOCK, min(N, (b + 1) * BLOCK)):
            if theta[i] > 0:
                inside[n] = i
                n += 1
                most[b] = max(most[b], theta[i])
        for k in range(D if n else 0):
            centres[k, b] = a[k, inside[n // 2]]
        for i in inside[:n]:
            total = _ZERO
            for m in range(M):
                square = _ZERO
                for k in range(m * width, (m + 1) * width):
                    dx = a[k, i] - centres[k, b]
                    square += dx * dx
                if square == square:
                    total += math.sqrt(square)
                else:
                    centres[m * width, b] = np.nan
            radius[b] = max(radius[b], total / np.float32(M))
    return centres, radius, most


@njit(cache=True, nogil=True)
def pick(tiles, i, row):
    """Take the numbers of moment i out of the tiles."""
    for d in range(row.size):
        row[d] = tiles[i // LANES, d * LANES + i % LANES]


@njit(cache=True, nogil=True, error_model="numpy")
def norms_to(tile, rows, width, total, seen):
    """Compare BLOCK moments, one a row, with those of a tile: sums of norms, and how many groups both show.

    Fills total and seen (BLOCK * LANES,), bit for bit as in a tile of the matrix.
    """
    for lane in range(BLOCK * LANES):
        total[lane] = _ZERO
        seen[lane] = _ZERO
    groups = rows.shape[1] // width
    if width != 3:
        for r in range(BLOCK):
            for lane in range(LANES):
                for m in range(groups):
                    square = _ZERO
                    for k in range(m * width, (m + 1) * width):
                        dx = tile[k * LANES + lane] - rows[r, k]
                        square += dx * dx
                    if square == square:
                        total[r * LANES + lane] += math.sqrt(square)
                        seen[r * LANES + lane] += _ONE
        return
    for m in range(groups):
        x0, y0, z0 = rows[0, 3 * m], rows[0, 3 * m + 1], rows[0, 3 * m + 2]
        x1, y1, z1 = rows[1, 3 * m], rows[1, 3 * m + 1], rows[1, 3 * m + 2]
        x2, y2, z2 = rows[2, 3 * m], rows[2, 3 * m + 1], rows[2, 3 * m + 2]
        points = tile[3 * m * LANES : 3 * (m + 1) * LANES]
        for lane in range(LANES):
            x, y, z = points[lane], points[LANES + lane], points[2 * LANES + lane]
            dx, dy, dz = x - x0, y - y0, z - z0
            norm = math.sqrt(dx * dx + dy * dy + dz * dz)
            total[lane] += norm if norm == norm else _ZERO
            seen[lane] += _ONE if norm == norm else _ZERO
            dx, dy, dz = x - x1, y - y1, z - z1
            norm = math.sqrt(dx * dx + dy * dy + dz * dz)
            total[LANES + lane] += norm if norm == norm else _ZERO
            seen[LANES + lane] += _ONE if norm == norm else _ZERO
            dx, dy, dz = x - x2, y - y2, z - z2
            norm = math.sqrt(dx * dx + dy * dy + dz * dz)
            total[2 * LANES + lane] += norm if norm == norm else _ZERO
            seen[2 * LANES + lane] += _ONE if norm == norm else _ZERO


@njit(cache=True, nogil=True)
def pick_block(tiles, block, rows):
    """Take the moments of a block out of the tiles, one a row."""
    for r in range(BLOCK):
        pick(tiles, min(BLOCK * block + r, tiles.shape[0] * LANES - 1), rows[r])


@njit(cache=True, nogil=True, error_model="numpy")
def distances_to_tile(tile, rows, width, seen, apart):
    """Fill apart (BLOCK * LANES,) with the distances of BLOCK moments to those of a tile."""
    norms_to(tile, rows, width, apart, seen)
    for lane in range(BLOCK * LANES):
        apart[lane] /= seen[lane]


@njit(cache=True, nogil=True, error_model="numpy")
def candidates(tiles, theta, centres, radius, most, blocks, width, c0, c1, b0, b1, reach):
    """Find the tiles in which postures may be like those of blocks b0 to b1, and how far apart they are there.

    The mean of norms is a metric: two moments are at least as far apart as the centres of their blocks less the radii.
    `centres` are tiles, too, of those `blocks` in which anything may be alike; c0 to c1 of these are asked.
    Returns tiles, where those of each block begin, distances (K, BLOCK * LANES), and in which rows of each a path may
    begin (K, BLOCK).
    """
    D = centres.shape[1] // LANES
    M = np.float32(D // width)
    rows = np.zeros((c1 - c0 + BLOCK, D), np.float32)
    for c in range(c0, c1):
        pick(centres, c, rows[c - c0])
    near = np.zeros((c1 - c0, tiles.shape[0] + 1), np.bool_)
    total, seen = np.empty(BLOCK * LANES, np.float32), np.empty(BLOCK * LANES, np.float32)
    for t in range(c0 // LANES, centres.shape[0] if c1 > c0 else 0):
        if blocks[t * LANES] >= blocks[c1 - 1] + reach:
            break
        radii, thetas = radius[t * LANES : (t + 1) * LANES], most[t * LANES : (t + 1) * LANES]
        for first in range(c0, min(c1, (t + 1) * LANES), BLOCK):
            norms_to(centres[t], rows[first - c0 : first - c0 + BLOCK], width, total, seen)
            for c in range(first, min(c1, first + BLOCK)):
                sums = total[(c - first) * LANES : (c - first + 1) * LANES]
                slack, closest = radius[c] + np.float32(1e-5), most[c]
                hits = 0
                for lane in range(LANES):
                    hits += sums[lane] / M - radii[lane] - slack < min(closest, thetas[lane])
                for lane in range(LANES if hits else 0):
                    if sums[lane] / M - radii[lane] - slack < min(closest, thetas[lane]):
                        start = BLOCK * blocks[t * LANES + lane]
                        near[c - c0, start // LANES] = True
                        near[c - c0, (start + BLOCK - 1) // LANES] = True
    chosen = np.empty(1024, np.int32)
    offsets = np.zeros(b1 - b0 + 1, np.int64)
    found = 0
    c = c0
    for b in range(b0, b1):
        if c < c1 and blocks[c] == b:
            for g in range(BLOCK * b // LANES, tiles.shape[0]):
                if near[c - c0, g]:
                    if found == chosen.size:
                        chosen = np.concatenate((chosen, np.empty_like(chosen)))
                    chosen[found] = g
                    found += 1
            c += 1
        offsets[b - b0 + 1] = found
    apart = np.empty((found, BLOCK * LANES), np.float32)
    few = np.empty((BLOCK, D), np.float32)
    for b in range(b0, b1):
        start, stop = offsets[b - b0], offsets[b - b0 + 1]
        if stop > start:
            pick_block(tiles, b, few)
        for k in range(start, stop):
            distances_to_tile(tiles[chosen[k]], few, width, seen, apart[k])
    begins = np.zeros((found, BLOCK), np.bool_)
    for b in range(b0, b1):
        for r in range(min(BLOCK, theta.size - BLOCK * b)):
            for k in range(offsets[b - b0], offsets[b - b0 + 1]):
                thetas = theta[LANES * chosen[k] : LANES * (chosen[k] + 1)]
                begins[k, r] = any_alike(apart[k, r * LANES : (r + 1) * LANES], theta[BLOCK * b + r], thetas)
    return chosen[:found], offsets, apart, begins


@njit(cache=True, nogil=True)
def any_alike(d, theta, thetas):
    """Whether a path may begin in any cell of a tile."""
    alike = 0
    for lane in range(LANES):
        alike += d[lane] < min(theta, thetas[lane])
    return alike > 0
