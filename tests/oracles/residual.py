"""Section 3 of paper P, the obvious way: one window against one place at a time, by the formula of eq. 6."""

import math

import numpy as np

Span = tuple[int, int]


def correlation(a: np.ndarray, b: np.ndarray, min_spread: float) -> float:
    """r_R of two windows (length, joints, axes); NaN where one of them keeps still."""
    a, b = a - a.mean(axis=0), b - b.mean(axis=0)
    if min(math.sqrt((w**2).sum(axis=2).mean()) for w in (a, b)) <= min_spread:
        return math.nan
    r = []
    for axis in range(a.shape[2]):
        x, y = a[:, :, axis], b[:, :, axis]
        x_moves = np.linalg.norm(x) > 0.01 * np.linalg.norm(a)
        y_moves = np.linalg.norm(y) > 0.01 * np.linalg.norm(b)
        if x_moves and y_moves:
            r.append((x * y).sum() / math.sqrt((x**2).sum() * (y**2).sum()))
        elif x_moves or y_moves:
            r.append(0.0)
    return sum(r) / len(r)


def matches(
    values: np.ndarray, spans: list[Span], length: int, least: float, min_spread: float
) -> list[list[tuple[int, int, float]]]:
    """For each window (its first moment, that of the place, r_R); values (N, joints, axes)."""
    places = [p for a, b in spans for p in range(a, b - length + 1)]
    found = []
    for a, b in spans:
        for w in range(a, b - length + 1, length):
            rated = [
                (correlation(values[w : w + length], values[p : p + length], min_spread), p)
                for p in places
                if p >= w + length
            ]
            taken: list[tuple[int, int, float]] = []
            for r, p in sorted((one for one in rated if one[0] > least), key=lambda one: (-one[0], one[1])):
                if all(abs(p - other) >= length for _, other, _ in taken):
                    taken.append((w, p, r))
            found.append(sorted(taken))
    return found
