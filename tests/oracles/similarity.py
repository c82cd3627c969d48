"""Distances between frames, the obvious way: three loops, double precision."""

import math

import numpy as np


def cross_distance(a: np.ndarray, b: np.ndarray, width: int, metric: str = "mean_norm") -> np.ndarray:
    """(N, M): mean, over the groups seen in both frames, of the norm of their difference or their angle."""
    groups = a.shape[1] // width
    answer = np.full((len(a), len(b)), np.nan)
    for i, p in enumerate(a.reshape(len(a), groups, width)):
        for j, q in enumerate(b.reshape(len(b), groups, width)):
            of_one = [_apart(p[m], q[m], metric) for m in range(groups)]
            seen = [distance for distance in of_one if not math.isnan(distance)]
            if seen:
                answer[i, j] = sum(seen) / len(seen)
    return answer


def _apart(p: np.ndarray, q: np.ndarray, metric: str) -> float:
    if np.isnan(p).any() or np.isnan(q).any():
        return math.nan
    if metric == "geodesic":
        return 2 * math.acos(min(1.0, abs(float(np.dot(p, q)))))
    return math.sqrt(sum(float(d) ** 2 for d in p - q))
