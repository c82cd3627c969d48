# mypy: allow-untyped-defs
"""Loops that align a recording locally with itself. Plain arrays and numbers in, plain arrays out; nothing is checked.

The posture matrix is never held. Of each row only the *live* cells are looked at: those where a path may begin, told
by blocks of moments (`candidates`), and those that a path of the two rows before may enter. A row's live cells are kept
as segments: where each begins, and where its steps stand in one long array of bytes.
"""

import math

import numpy as np
from numba import njit

from leitmotion.similarity._kernels import distances_to

NONE, START, DIAGONAL, STEEP, FLAT = 0, 1, 2, 3, 4  # how a path came into a cell
TILE = 512  # blocks
BESIDE = 4  # columns beside an interval whose distances are computed with it: paths widen
JOINED = 8  # columns: intervals nearer than this are looked at as one


@njit(cache=True, nogil=True)
def first_apart(a, width, theta, reach, i0, i1, first):
    """Fill first (N,) from i0 to i1: the first moment after each that is not like it, at most `reach` moments ahead."""
    N = a.shape[1]
    C = np.empty(32, np.float32)
    for i in range(i0, i1):
        stop = min(N, i + 1 + reach)
        j = i + 1
        while j < stop:
            n = min(32, stop - j)
            distances_to(a, i, j, j + n, 1, width, C)
            k = 0
            while k < n and C[k] < min(theta[i], theta[j + k]):
                k += 1
            j += k
            if k < n:
                break
        first[i] = j


@njit(cache=True, nogil=True)
def block_bounds(a, width, theta, size):
    """Summarise blocks of `size` moments: a centre, how far its moments are from it, and their greatest theta.

    A group that some moment of a block did not see is NaN in its centre.
    """
    D, N = a.shape
    M = D // width
    B = (N + size - 1) // size
    centres = np.empty((D, B), np.float32)
    radius = np.zeros(B, np.float32)
    most = np.empty(B, np.float32)
    for b in range(B):
        start, stop = b * size, min(N, (b + 1) * size)
        middle = (start + stop) // 2
        most[b] = theta[start:stop].max()
        for m in range(M):
            for k in range(m * width, (m + 1) * width):
                centres[k, b] = a[k, middle] + a[k, start:stop].sum() * np.float32(0)
        for i in range(start, stop):
            total = np.float32(0)
            for m in range(M):
                square = np.float32(0)
                for k in range(m * width, (m + 1) * width):
                    dx = a[k, i] - centres[k, b]
                    square += dx * dx
                if square == square:
                    total += math.sqrt(square)
            radius[b] = max(radius[b], total / np.float32(M))
    return centres, radius, most


@njit(cache=True, nogil=True)
def candidates(a, centres, radius, most, width, size, c0, c1, horizon):
    """Find where postures may be alike in the rows of blocks c0 to c1, and how far apart they are there.

    The mean of norms is a metric: two moments are at least as far apart as the centres of their blocks less the radii.
    Returns intervals of moments, where those of each block begin, their distances, one row of a block after another,
    and where the distances of each interval stand.
    """
    N, B = a.shape[1], centres.shape[1]
    M = np.float32(centres.shape[0] // width)
    near = np.zeros((c1 - c0, B), np.bool_)
    C, square = np.empty(TILE, np.float32), np.empty(TILE, np.float32)
    for b0 in range(c0, min(B, c1 + horizon), TILE):
        tile = centres[:, b0 : b0 + TILE].copy()  # packed, stays in the cache for all rows
        n = tile.shape[1]
        for c in range(c0, c1):
            if most[c] > 0:
                _sum_of_norms(tile, centres[:, c], width, square, C)
                for b in range(n):
                    least = C[b] / M - radius[c] - radius[b0 + b]
                    near[c - c0, b0 + b] = least < min(most[c], most[b0 + b]) + np.float32(1e-5)
    begins, ends = np.empty(1024, np.int32), np.empty(1024, np.int32)
    offsets = np.zeros(c1 - c0 + 1, np.int64)
    found = 0
    for c in range(c0, c1):
        began = found
        for b in range(c, min(B, c + horizon)):
            if near[c - c0, b]:
                start = b * size
                stop = min(N, start + size + BESIDE)
                if found > began and start - ends[found - 1] <= JOINED:
                    ends[found - 1] = stop
                    continue
                if found == begins.size:
                    begins = np.concatenate((begins, np.empty_like(begins)))
                    ends = np.concatenate((ends, np.empty_like(ends)))
                begins[found], ends[found] = start, stop
                found += 1
        offsets[c - c0 + 1] = found
    places = np.zeros(found + 1, np.int64)
    for k in range(found):
        places[k + 1] = places[k] + size * (ends[k] - begins[k])
    apart = np.empty(places[found], np.float32)
    for c in range(c0, c1):
        for k in range(offsets[c - c0], offsets[c - c0 + 1]):
            n = ends[k] - begins[k]
            for r in range(min(size, N - c * size)):
                at = places[k] + r * n
                distances_to(a, c * size + r, begins[k], ends[k], 1, width, apart[at : at + n])
    return begins[:found], ends[:found], offsets, apart, places


@njit(cache=True, nogil=True)
def _sum_of_norms(tile, one, width, square, C):
    """Fill C with the sums over groups of the norms of tile[:, b] - one; what was not seen adds nothing."""
    n = tile.shape[1]
    for b in range(n):
        C[b] = 0.0
    if width == 3:
        for m in range(tile.shape[0] // 3):
            x, y, z = one[3 * m], one[3 * m + 1], one[3 * m + 2]
            xs, ys, zs = tile[3 * m], tile[3 * m + 1], tile[3 * m + 2]
            for b in range(n):
                dx, dy, dz = xs[b] - x, ys[b] - y, zs[b] - z
                norm = math.sqrt(dx * dx + dy * dy + dz * dz)
                C[b] += norm if norm == norm else np.float32(0)
        return
    for m in range(tile.shape[0] // width):
        for b in range(n):
            square[b] = 0.0
        for k in range(m * width, (m + 1) * width):
            x, xs = one[k], tile[k]
            for b in range(n):
                dx = xs[b] - x
                square[b] += dx * dx
        for b in range(n):
            C[b] += math.sqrt(square[b]) if square[b] == square[b] else np.float32(0)


@njit(cache=True, nogil=True)
def step_into(
    d, theta, thetas, still, stills, still_distance, still_gain, ceiling, H1, H2, H, S1, S2, S, G, step
):
    """Enter neighbouring cells of one row; no branch, so that it vectorises.

    H1, H2 and S1, S2 are the row before and the row before that, H and S the row itself, all from two columns ahead of
    the first cell on. Fills H, S, each cell's gain G and its step.
    """
    for k in range(thetas.size):
        closeness = min(theta, thetas[k])
        gain = np.float32(1) - d[k] / closeness
        gain = gain if gain >= np.float32(-1) else np.float32(-1)  # also where nothing was seen
        kept = still_gain if d[k] < still_distance else np.float32(-1)
        gain = kept if still | stills[k] else gain
        h, s = H1[k + 1], S1[k + 1]
        how = np.uint8(DIAGONAL) if h > 0 else np.uint8(START)
        better = H2[k + 1] > h + np.float32(1e-6)
        h, s, how = (H2[k + 1], S2[k + 1], np.uint8(STEEP)) if better else (h, s, how)
        better = H1[k] > h + np.float32(1e-6)
        h, s, how = (H1[k], S1[k], np.uint8(FLAT)) if better else (h, s, how)
        h = min(h, ceiling) + gain
        live = h > 0
        H[k + 2] = h if live else np.float32(0)
        S[k + 2] = s + gain if live else np.float32(0)
        step[k] = how if live else np.uint8(NONE)
        G[k] = gain


@njit(cache=True, nogil=True)
def align_rows(
    a, width, theta, still, first, still_distance, still_gain, ceiling, least, horizon,
    i0, i1, size, begins, ends, offsets, apart, places,
    H, S, extended, lo, hi, count, steps, used,
):  # fmt: skip
    """Align rows i0 to i1 above the diagonal, by steps (1, 1), (2, 1) and (1, 2).

    A cell gains 1 - d / theta, never less than -1. H is the running gain: it starts anew where it would fall below
    0, and enters a step at most `ceiling` high, so that no path bridges a long gap. S is the gain without that
    ceiling. What is nearer to the diagonal than the first moment that differs is no return.

    H and S (3, N + 3), two columns ahead and one behind, and extended (3, N) hold the last three rows; lo, hi (3, N)
    and count (3,) the segments of their live cells.
    Rows past the last only note the ends of paths. Writes the steps into the live cells from `used` on; returns where
    the next go, or -1 - i where there is no room in row i; segments: row's offsets, first columns, places; and ends of
    paths.
    """
    N = a.shape[1]
    row_offsets = np.zeros(i1 - i0 + 1, np.int64)
    seg_start, seg_at = np.empty(1024, np.int32), np.empty(1024, np.int64)
    segs = 0
    rows, columns = np.empty(1024, np.int32), np.empty(1024, np.int32)
    gains = np.empty(1024, np.float32)
    found = 0
    C, G = np.empty(N, np.float32), np.empty(N, np.float32)
    step = np.empty(N, np.uint8)
    row_lo, row_hi = np.empty(N, np.int32), np.empty(N, np.int32)
    for i in range(i0, i1):
        now, before, earlier = i % 3, (i - 1) % 3, (i - 2) % 3
        for k in range(count[now]):  # row i - 3 is complete: of neighbouring ends of paths note the best
            for j in range(lo[now, k], hi[now, k]):
                s = S[now, j + 2]
                if s > least and not extended[now, j] and s >= S[now, j + 1] and s > S[now, j + 3]:
                    if found == rows.size:
                        rows = np.concatenate((rows, np.empty_like(rows)))
                        columns = np.concatenate((columns, np.empty_like(columns)))
                        gains = np.concatenate((gains, np.empty_like(gains)))
                    rows[found], columns[found], gains[found] = i - 3, j, s
                    found += 1
        for k in range(count[now]):
            for j in range(lo[now, k], hi[now, k]):
                H[now, j + 2], S[now, j + 2], extended[now, j] = 0.0, 0.0, False
        count[now] = 0
        if i >= N:
            row_offsets[i - i0 + 1] = segs
            continue
        # Where to look: the union of three lists in order.
        block = i // size - i0 // size
        p, p_stop = offsets[block], offsets[block + 1]
        known = p
        q, r = 0, 0
        stop = min(N, i + horizon)
        intervals = 0
        while True:
            begin, end = N, N
            which = 0
            if p < p_stop:
                begin, end, which = begins[p], ends[p], 1
            if q < count[before] and lo[before, q] + 1 < begin:
                begin, end, which = lo[before, q] + 1, hi[before, q] + 2, 2
            if r < count[earlier] and lo[earlier, r] + 1 < begin:
                begin, end, which = lo[earlier, r] + 1, hi[earlier, r] + 1, 3
            if which == 0:
                break
            if which == 1:
                p += 1
            elif which == 2:
                q += 1
            else:
                r += 1
            begin, end = max(begin, first[i]), min(end, stop)
            if begin >= end:
                continue
            if intervals > 0 and begin - row_hi[intervals - 1] <= JOINED:
                row_hi[intervals - 1] = max(row_hi[intervals - 1], end)
            else:
                row_lo[intervals], row_hi[intervals] = begin, end
                intervals += 1
        live = 0
        for m in range(intervals):
            begin, end = row_lo[m], row_hi[m]
            if used + end - begin > steps.size:
                return -1 - i, row_offsets, seg_start, seg_at, rows, columns, gains
            n = end - begin
            at = begin
            while at < end:  # most distances are known
                while known < p_stop and ends[known] <= at:
                    known += 1
                if known < p_stop and begins[known] <= at:
                    upto = min(end, ends[known])
                    length = ends[known] - begins[known]
                    place = places[known] + (i % size) * length + at - begins[known]
                    C[at - begin : upto - begin] = apart[place : place + upto - at]
                else:
                    upto = min(end, begins[known]) if known < p_stop else end
                    distances_to(a, i, at, upto, 1, width, C[at - begin :])
                at = upto
            step_into(
                C, theta[i], theta[begin:end], still[i], still[begin:end], still_distance, still_gain, ceiling,
                H[before, begin : end + 2], H[earlier, begin : end + 2], H[now, begin : end + 2],
                S[before, begin : end + 2], S[earlier, begin : end + 2], S[now, begin : end + 2], G, step,
            )  # fmt: skip
            last = -2 * JOINED  # column of the last live cell
            for k in range(n):
                if step[k] == NONE:
                    continue
                j = begin + k
                if G[k] > 0:
                    if step[k] == DIAGONAL:
                        extended[before, j - 1] = True
                    elif step[k] == STEEP:
                        extended[earlier, j - 1] = True
                    elif step[k] == FLAT:
                        extended[before, j - 2] = True
                if j - last > JOINED:
                    if segs == seg_start.size:
                        seg_start = np.concatenate((seg_start, np.empty_like(seg_start)))
                        seg_at = np.concatenate((seg_at, np.empty_like(seg_at)))
                    seg_start[segs], seg_at[segs] = j, used
                    segs += 1
                    lo[now, live] = j
                    live += 1
                else:
                    for _ in range(last + 1, j):
                        steps[used] = NONE
                        used += 1
                steps[used] = step[k]
                used += 1
                hi[now, live - 1] = j + 1
                last = j
        count[now] = live
        row_offsets[i - i0 + 1] = segs
    return (
        used, row_offsets, seg_start[:segs], seg_at[:segs], rows[:found], columns[:found], gains[:found]
    )  # fmt: skip
