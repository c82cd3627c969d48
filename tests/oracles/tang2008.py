"""Section 2.3 of paper P, the obvious way: sets of points, and dynamic time warping by recursion.

Points are (x, y): x the later moment, y the earlier, y < x.
"""

import math
from functools import cache

import numpy as np

Point = tuple[int, int]


def thin(C: np.ndarray, threshold: float, apart: int) -> set[Point]:
    """Local minima along y of what is nearer than the threshold."""
    return {
        (x, y)
        for x in range(len(C))
        for y in range(1, x)
        if x - y >= apart and C[x, y] < threshold and C[x, y] < min(C[x, y - 1], C[x, y + 1])
    }


def start_points(minima: set[Point], reach: int) -> list[Point]:
    """Points with none to the left and below, and some to the right and above."""

    def some(columns: range, rows: range) -> bool:
        return any((x, y) in minima for x in columns for y in rows)

    return [
        (x, y)
        for x, y in sorted(minima)
        if not some(range(x - reach, x), range(y - 2 * reach, y + 1))
        and some(range(x + 1, x + reach + 1), range(y + 1, y + 2 * reach + 1))
    ]


def trace(
    C: np.ndarray, minima: set[Point], start: Point, apart: int, windows: tuple[int, int], dearest: float
) -> list[Point]:
    """Follow a pattern: the widest window with a valid candidate, of several the one with the least DTW cost."""
    points, window = [start], windows[0]
    while True:
        x, y = points[-1]
        chosen = None
        for step in range(window, 0, -1):
            candidates = [
                (_dtw(C, (x, y), (x + step, ahead), apart), ahead)
                for ahead in range(y, x + step)
                if (x + step, ahead) in minima and step / 2 <= ahead - y <= 2 * step
            ]
            valid = [(cost, ahead) for cost, ahead in candidates if cost <= dearest]
            if valid:
                chosen = (x + step, min(valid)[1])
                break
        if chosen is None:
            return points
        points.append(chosen)
        window = windows[1]


def _dtw(C: np.ndarray, start: Point, stop: Point, apart: int) -> float:
    """Cost of the cheapest path between two points over the number of its cells."""

    @cache
    def least(x: int, y: int) -> tuple[float, int]:
        if x - y < apart:
            return math.inf, 0
        if (x, y) == start:
            return float(C[x, y]), 1
        before = [(x - 1, y - 1), (x - 1, y), (x, y - 1)]
        within = [least(*p) for p in before if p[0] >= start[0] and p[1] >= start[1]]
        cost, length = min(within, key=lambda known: known[0])
        return cost + float(C[x, y]), length + 1

    cost, length = least(*stop)
    return cost / length
