"""Tracing: all stripes of a recording, of any length, without ever holding its posture matrix.

Conventions
-----------
Moments of the working rate. A cell (i, j) of the matrix is *live* when an alignment runs through it; a few in a hundred
are, and only of the tiles that hold one are the steps kept by which paths came, four bits a cell.

References
----------
The alignment is T. F. Smith's and M. S. Waterman's, J. Mol. Biol. 147, 1981. Where it may begin is told by the triangle
inequality, which the mean of norms (paper P, eq. 2) obeys.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from leitmotion.discovery.labour import ahead, aside, share_work
from leitmotion.discovery.stripes import CORRIDOR_S, GAP_S, Likeness, Stripe, measure_all
from leitmotion.discovery.tiles import BLOCK, LANES, filled_up, side_by_side
from leitmotion.similarity import Distances

FEWEST, CELLS = 64, 6_000_000  # blocks of rows aligned in one call, and cells in a short recording
REST_S = 60.0  # how long a rest may be whose end is still the same moment as its beginning
LIVE = 60_000_000  # tiles with live cells, twelve bytes each
POINTS = 30_000_000  # of all paths together
ENDS = 16_384  # of paths, followed in one call
NEAR_S = 60.0  # paths nearer to the diagonal are followed first
STILL_GAIN = -0.1


Candidates = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]
"""Where something may be alike, by block of rows, and how far apart it is; see the kernel ``candidates``."""


class Traced(NamedTuple):
    """What a recording's alignment with itself shows."""

    stripes: list[Stripe]
    limits: dict[str, object]
    """What bounded the search, empty where nothing did: ``compared_within_s``, stretches farther apart were not
    compared; ``paths_left_out``, how many ends of paths were not followed, the least clear ones."""


class Live(NamedTuple):
    """The live cells of the matrix, by row and tile."""

    steps: np.ndarray  # (L,) uint64: how a path came into each cell of a tile
    places: np.ndarray  # (L,) int32: which tile of the row that is
    row_offsets: np.ndarray  # (N + 1,) where a row's tiles begin
    rows: np.ndarray  # (E,) ends of paths
    columns: np.ndarray
    gains: np.ndarray


def trace_stripes(
    distances: Distances,
    alike: Likeness,
    *,
    max_distance: float,
    min_duration_s: float,
    horizon_s: float = np.inf,
) -> Traced:
    """Trace all stripes of a recording, the longest and nearest first.

    Parameters
    ----------
    distances : Distances
        Posture distances of N moments, body sizes; NaN where nothing was seen.
    alike : Likeness
        What counts as alike.
    max_distance : float
        Body sizes.
    min_duration_s : float
        Shortest stretch, seconds.
    horizon_s : float
        How far apart two stretches may be, seconds.

    Returns
    -------
    Traced
        Both stretches of each stripe are at least `min_duration_s` long. Where more is alike than fits in memory, the
        horizon is nearer than asked for.
    """
    rate = distances.features.rate
    shortest = max(2, round(min_duration_s * rate))
    horizon = int(min(len(distances), horizon_s * rate))
    while True:
        live, reached = _align(distances, alike, max_distance, shortest, horizon)
        if live is not None:
            break
        horizon = _nearer(horizon, reached, len(distances))
    points, lengths, left_out = _follow(live, rate, shortest)
    del live
    stripes = [
        stripe
        for stripe in measure_all(points, lengths, distances, alike)
        if stripe is not None and min(stripe.a[1] - stripe.a[0], stripe.b[1] - stripe.b[0]) >= shortest
    ]
    limits: dict[str, object] = {}
    if horizon < min(len(distances), horizon_s * rate):
        limits["compared_within_s"] = round(horizon / rate, 1)
    if left_out:
        limits["paths_left_out"] = left_out
    return Traced(stripes, limits)


def _align(
    distances: Distances, alike: Likeness, max_distance: float, shortest: int, horizon: int
) -> tuple[Live | None, int]:
    """Align row by row; None where the live cells do not fit, and how many rows were done."""
    from leitmotion.discovery import _kernels, _near_kernels

    a, N = distances.across, len(distances)
    rate = distances.features.rate
    theta = np.where(alike.still, np.float32(-1), alike.threshold)
    centres, radius, most = _near_kernels.block_bounds(a, distances.width, theta)
    blocks = np.flatnonzero(most > 0).astype(np.int32)
    tiles, width = side_by_side(a, distances.width)
    centres, _ = side_by_side(centres[:, blocks], distances.width)
    most, radius = (filled_up(values[blocks], nothing) for values, nothing in ((most, -1), (radius, 0)))
    thetas = filled_up(theta, -1)
    thresholds, stills = filled_up(alike.threshold, 1), filled_up(alike.still.astype(np.float32), 1)
    reach = round(REST_S * rate)
    first = np.empty(N, np.int32)

    def look_ahead(rows: slice) -> None:
        _near_kernels.first_apart(a, distances.width, alike.threshold, reach, rows.start, rows.stop, first)

    share_work(look_ahead, N, 4096)
    chunk = BLOCK * max(FEWEST, CELLS // (BLOCK * N))

    def candidates(rows: tuple[int, int]) -> Candidates:
        b0, b1 = rows[0] // BLOCK, -(-min(rows[1], N) // BLOCK)
        c0, c1 = np.searchsorted(blocks, (b0, b1)).tolist()
        found: Candidates = _near_kernels.candidates(
            tiles, thetas, centres, radius, most, blocks, width, c0, c1, b0, b1, horizon // BLOCK + 2
        )
        return found

    shape = (3, (len(tiles) + 2) * LANES)
    state = (
        np.zeros(shape, np.float32), np.zeros(shape, np.float32), np.zeros(shape, np.float32),
        np.zeros((3, len(tiles) + 1), np.int32), np.zeros(3, np.int64),
    )  # fmt: skip
    most_tiles = min(LIVE, N * (min(N, horizon) // LANES + 2))
    steps, places = (
        np.empty(most_tiles, np.uint64),
        np.empty(most_tiles, np.int32),
    )  # taken as they are written to
    used = 0
    offsets, found = [np.zeros(1, np.int64)], []
    starts = range(0, N, chunk)
    pieces = [(start, start + chunk if start + chunk < N else N + 3) for start in starts]
    for (i0, i1), near in zip(pieces, ahead(candidates, pieces), strict=True):
        used, row_offsets, *ends = aside(
            _kernels.align_rows, tiles, width, thresholds, stills, first,
            np.float32(0.5 * max_distance), np.float32(STILL_GAIN), np.float32(GAP_S * rate),
            np.float32(0.2 * shortest), horizon, i0, i1, *near, *state, steps, places, used,
        )  # fmt: skip
        if used < 0:
            return None, -1 - used
        offsets.append(row_offsets[1 : min(N, i1) - i0 + 1])
        found.append(ends)
    rows, columns, gains = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return Live(steps, places, np.concatenate(offsets), rows, columns, gains), N


def _nearer(horizon: int, reached: int, moments: int) -> int:
    """Horizon at which the live cells should fit, as it was `reached` rows that filled the room."""
    wanted = 0.8 * sum(min(horizon, moments - i) for i in range(reached))
    low, high = 1, horizon
    while low < high:
        middle = (low + high + 1) // 2
        area = middle * moments - middle * middle / 2
        low, high = (middle, high) if area <= wanted else (low, middle - 1)
    return max(1, min(low, int(0.8 * horizon)))


def _follow(live: Live, rate: float, shortest: int) -> tuple[np.ndarray, np.ndarray, int]:
    """Follow paths back from their ends, near ones first and then by their gain: points, lengths, ends left out."""
    from leitmotion.discovery._path_kernels import walk_back

    far = live.columns - live.rows > NEAR_S * rate
    near, far = np.flatnonzero(~far), np.flatnonzero(far)
    order = np.concatenate([some[np.argsort(-live.gains[some], kind="stable")] for some in (near, far)])
    rows, columns = live.rows[order], live.columns[order]
    corridor = max(1, round(CORRIDOR_S * rate))
    path = np.empty((2 * len(live.row_offsets), 2), np.int64)
    points, lengths = [np.zeros((0, 2), np.int32)], [np.zeros(0, np.int64)]
    total, k = 0, 0
    while k < len(rows) and total < POINTS:
        more = min(len(rows), k + ENDS)
        piece, counts = aside(
            walk_back, live.steps, live.row_offsets, live.places, rows, columns,
            corridor, shortest, k, more, path,
        )  # fmt: skip
        points.append(piece)
        lengths.append(counts)
        total, k = total + len(piece), more
    return np.concatenate(points), np.concatenate(lengths), len(rows) - k
