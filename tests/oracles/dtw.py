"""Dynamic time warping, the obvious way: every path there is, and the cheapest of them."""

from collections.abc import Iterator

import numpy as np

STRAIGHT = [((1, 1),), ((1, 0),), ((0, 1),)]
LIMITED = [((1, 1),), ((1, 1), (1, 0)), ((1, 1), (0, 1))]  # a straight step only together with a diagonal one
PATTERNS = {"symmetric1": (STRAIGHT, 1), "symmetric2": (STRAIGHT, 2), "symmetricP1": (LIMITED, 2)}

Path = list[tuple[int, int]]


def cheapest(d: np.ndarray, step: str, *, open_begin: bool, open_end: bool) -> tuple[float, set[int]] | None:
    """Least cost (its mean per weight with an open end) and the columns where paths of that cost end."""
    last = len(d) - 1, d.shape[1] - 1
    found: list[tuple[float, int]] = []
    for column in range(d.shape[1] if open_begin else 1):
        for path, weights in _paths((0, column), last, step):
            if path[-1][0] == last[0] and (open_end or path[-1] == last):
                cost = sum(w * d[cell] for w, cell in zip(weights, path, strict=True))
                found.append((cost, path[-1][1], sum(weights)))
    if not found:
        return None
    least = {c: min(f for f in found if f[1] == c) for c in {f[1] for f in found}}  # the cheapest to each end
    value = {c: cost / weight if open_end else cost for c, (cost, _, weight) in least.items()}
    best = min(value.values())
    return best, {c for c, v in value.items() if v <= best + 1e-12}


def _paths(start: tuple[int, int], last: tuple[int, int], step: str) -> Iterator[tuple[Path, list[int]]]:
    moves, diagonal = PATTERNS[step]
    unfinished = [([start], [diagonal])]
    while unfinished:
        path, weights = unfinished.pop()
        yield path, weights
        for move in moves:
            cells, i, j = [], *path[-1]
            for di, dj in move:
                i, j = i + di, j + dj
                cells.append((i, j))
            if i <= last[0] and j <= last[1]:
                unfinished.append((path + cells, weights + [diagonal if all(m) else 1 for m in move]))
