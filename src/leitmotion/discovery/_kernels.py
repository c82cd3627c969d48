# mypy: allow-untyped-defs
"""Loops that align a recording locally with itself. Plain arrays and numbers in, plain arrays out; nothing is checked.

The posture matrix is never held. Of each row only some tiles are looked at: those where a path may begin, told by
blocks of moments (`_near_kernels.candidates`), and those that a path of the two rows before may enter. Of each tile
with a live cell the steps are kept, four bits a cell in one number, and which tile it is.
"""

import numpy as np
from numba import njit

from leitmotion.discovery._near_kernels import distances_to_tile, pick_block
from leitmotion.discovery.tiles import BLOCK, LANES

NONE, START, DIAGONAL, STEEP, FLAT = 0, 1, 2, 3, 4  # how a path came into a cell
BITS = 4  # of a step


@njit(cache=True, nogil=True, error_model="numpy")
def step_into(
    d, theta, thetas, still, stills, still_distance, still_gain, ceiling, H1, H2, S1, S2, at, cells
):  # fmt: skip
    """Enter the cells of one tile; no branch, so that it vectorises.

    H1, H2 and S1, S2 are the row before and the row before that, which have the tile at `at`. Fills cells (4 * LANES,):
    H, S, how they were entered, and the same where the cell gains.
    """
    straight, steep, flat = (H1[at - 1 : at + LANES], H2[at - 1 : at + LANES], H1[at - 2 : at + LANES])
    gained, gained_steep, gained_flat = (
        S1[at - 1 : at + LANES],
        S2[at - 1 : at + LANES],
        S1[at - 2 : at + LANES],
    )
    for lane in range(LANES):
        gain = np.float32(1) - d[lane] / min(theta, thetas[lane])
        gain = gain if gain >= np.float32(-1) else np.float32(-1)  # also where nothing was seen
        kept = still_gain if d[lane] < still_distance else np.float32(-1)
        gain = kept if still + stills[lane] > 0 else gain
        h, s = straight[lane], gained[lane]
        other, s_other = steep[lane], gained_steep[lane]
        how = np.float32(DIAGONAL) if h > 0 else np.float32(START)
        better = other > h + np.float32(1e-6)
        h = other if better else h
        s = s_other if better else s
        how = np.float32(STEEP) if better else how
        other, s_other = flat[lane], gained_flat[lane]
        better = other > h + np.float32(1e-6)
        h = other if better else h
        s = s_other if better else s
        how = np.float32(FLAT) if better else how
        h = min(h, ceiling) + gain
        live = h > 0
        cells[lane] = h if live else np.float32(0)
        cells[LANES + lane] = s + gain if live else np.float32(0)
        how = how if live else np.float32(NONE)
        cells[2 * LANES + lane] = how
        cells[3 * LANES + lane] = how if gain > 0 else np.float32(NONE)


@njit(cache=True, nogil=True)
def best_ends(S0, on1, on2, at, least, ended):
    """Tell the cells of a tile of a row where a path ends, of neighbours the best; S0 is the row, on1 and on2 the next.

    Fills ended (LANES,); returns how many.
    """
    left, here, right = S0[at - 1 : at + LANES], S0[at : at + LANES], S0[at + 1 : at + LANES + 1]
    straight, flat, steep = (
        on1[at + 1 : at + LANES + 1],
        on1[at + 2 : at + LANES + 2],
        on2[at + 1 : at + LANES + 1],
    )
    for lane in range(LANES):
        s = here[lane]
        extended = (straight[lane] == DIAGONAL) | (flat[lane] == FLAT) | (steep[lane] == STEEP)
        ended[lane] = (s > least) & (s >= left[lane]) & (s > right[lane]) & (not extended)
    ends = 0
    for lane in range(LANES):
        ends += ended[lane] > 0
    return ends


@njit(cache=True, nogil=True)
def put(cells, H, S, onward):
    """Put the cells of a tile into their row."""
    for lane in range(LANES):
        H[lane] = cells[lane]
    for lane in range(LANES):
        S[lane] = cells[LANES + lane]
    for lane in range(LANES):
        onward[lane] = cells[3 * LANES + lane]


@njit(cache=True, nogil=True)
def packed(how):
    """The steps of a tile in one number."""
    word = np.uint64(0)
    for lane in range(LANES):
        word |= np.uint64(how[lane]) << np.uint64(BITS * lane)
    return word


@njit(cache=True, nogil=True)
def align_rows(
    tiles, width, theta, still, first, still_distance, still_gain, ceiling, least, horizon,
    i0, i1, chosen, offsets, apart, begins,
    H, S, onward, opened, count, steps, places, used,
):  # fmt: skip
    """Align rows i0 to i1 above the diagonal, by steps (1, 1), (2, 1) and (1, 2).

    A cell gains 1 - d / theta, never less than -1. H is the running gain: it starts anew where it would fall below
    0, and enters a step at most `ceiling` high, so that no path bridges a long gap. S is the gain without that
    ceiling. What is nearer to the diagonal than the first moment that differs is no return.

    H, S and onward, the step where it gains, hold the last three rows (3, (G + 2) * LANES), a tile ahead of the first
    and one behind the last; opened (3, G + 1) and count (3,) the tiles that a path of each row lies in or may enter.
    Rows past the last only note the ends of paths. Writes steps and which tile they are of from `used` on; returns
    where the next go, or -1 - i where there is no room in row i; where each row begins; and ends of paths.
    """
    N, G = first.size, tiles.shape[0]
    row_offsets = np.zeros(i1 - i0 + 1, np.int64)
    rows, columns = np.empty(1024, np.int32), np.empty(1024, np.int32)
    gains = np.empty(1024, np.float32)
    found = 0
    cells, ended = np.empty(4 * LANES, np.float32), np.empty(LANES, np.float32)
    also = np.empty(
        (64, BLOCK * LANES), np.float32
    )  # distances of tiles that are no candidates of their block
    which = np.full(G, -1, np.int32)
    known = np.empty(64, np.int32)
    few = np.empty((BLOCK, tiles.shape[1] // LANES), np.float32)
    seen = np.empty(BLOCK * LANES, np.float32)
    others = 0
    for i in range(i0, i1):
        now, before, earlier = i % 3, (i - 1) % 3, (i - 2) % 3
        H0, H1, H2 = H[now], H[before], H[earlier]
        S0, S1, S2 = S[now], S[before], S[earlier]
        on0, on1, on2 = onward[now], onward[before], onward[earlier]
        for k in range(count[now]):  # row i - 3 is complete: of neighbouring ends of paths note the best
            at = LANES * (opened[now, k] + 1)
            if best_ends(S0, on2, on1, at, least, ended) == 0:
                continue
            for lane in range(LANES):
                if ended[lane] > 0:
                    if found == rows.size:
                        rows = np.concatenate((rows, np.empty_like(rows)))
                        columns = np.concatenate((columns, np.empty_like(columns)))
                        gains = np.concatenate((gains, np.empty_like(gains)))
                    rows[found], columns[found] = i - 3, at + lane - LANES
                    gains[found] = S0[at + lane]
                    found += 1
        cells[:] = 0
        for k in range(count[now]):
            at = LANES * (opened[now, k] + 1)
            put(cells, H0[at : at + LANES], S0[at : at + LANES], on0[at : at + LANES])
        count[now] = 0
        if i >= N:
            row_offsets[i - i0 + 1] = used
            continue
        block = i // BLOCK
        if i % BLOCK == 0:
            for k in range(others):
                which[known[k]] = -1
            others = 0
        # Where to look: the union of three lists in order.
        p, p_stop = offsets[block - i0 // BLOCK], offsets[block - i0 // BLOCK + 1]
        q, r = 0, 0
        stop = min(N, i + horizon)
        open_tiles = 0
        while True:
            g = G
            if p < p_stop:
                g = min(g, chosen[p])
            if q < count[before]:
                g = min(g, opened[before, q])
            if r < count[earlier]:
                g = min(g, opened[earlier, r])
            if g == G:
                break
            candidate = p < p_stop and chosen[p] == g
            near = q < count[before] and opened[before, q] == g
            far = r < count[earlier] and opened[earlier, r] == g
            p, q, r = p + candidate, q + near, r + far
            start = g * LANES
            if start + LANES <= first[i] or start >= stop or not (near or far or begins[p - 1, i % BLOCK]):
                continue
            lanes = slice((i % BLOCK) * LANES, (i % BLOCK + 1) * LANES)
            if candidate:
                d = apart[p - 1, lanes]
            else:
                if which[g] < 0:
                    if others == known.size:
                        also = np.concatenate((also, np.empty_like(also)))
                        known = np.concatenate((known, np.empty_like(known)))
                    known[others], which[g] = g, others
                    others += 1
                    if others == 1:
                        pick_block(tiles, block, few)
                    distances_to_tile(tiles[g], few, width, seen, also[others - 1])
                d = also[which[g], lanes]
            at = start + LANES
            step_into(
                d, theta[i], theta[start : start + LANES], still[i], still[start : start + LANES],
                still_distance, still_gain, ceiling, H1, H2, S1, S2, at, cells,
            )  # fmt: skip
            if start < first[i] or start + LANES > stop:
                for lane in range(LANES):
                    if not first[i] <= start + lane < stop:
                        cells[lane::LANES] = 0
            live = 0
            for lane in range(LANES):
                live += cells[lane] > 0
            if live == 0:
                continue
            if used == steps.size:
                return -1 - i, row_offsets, rows, columns, gains
            put(cells, H0[at : at + LANES], S0[at : at + LANES], on0[at : at + LANES])
            steps[used], places[used] = packed(cells[2 * LANES : 3 * LANES]), g
            used += 1
            if open_tiles == 0 or opened[now, open_tiles - 1] != g:
                opened[now, open_tiles] = g
                open_tiles += 1
            if g + 1 < G and (cells[LANES - 1] > 0 or cells[LANES - 2] > 0):
                opened[now, open_tiles] = g + 1
                open_tiles += 1
        count[now] = open_tiles
        row_offsets[i - i0 + 1] = used
    return used, row_offsets, rows[:found], columns[:found], gains[:found]
