"""Lines, cards and curves, told in the plainest way."""

from __future__ import annotations

import itertools

import numpy as np


def crossings(a: np.ndarray, b: np.ndarray) -> int:
    """How many pairs of lines have a point in common: two equations for two unknowns."""
    count = 0
    for i, j in itertools.combinations(range(len(a)), 2):
        matrix = np.stack([b[i] - a[i], a[j] - b[j]], axis=1)
        if abs(np.linalg.det(matrix)) > 1e-12:
            along = np.linalg.solve(matrix, a[j] - a[i])
            count += bool(((along > 0) & (along < 1)).all())
    return count


def passed(a: np.ndarray, b: np.ndarray, cards: np.ndarray, half: np.ndarray) -> int:
    """How many pairs of a line and a card have a point in common: a point is tried between any two borders it meets."""
    count = 0
    for start, stop in zip(a, b, strict=True):
        for card in cards:
            borders = np.concatenate([(card + side * half - start) / (stop - start) for side in (-1, 1)])
            met = np.unique([*np.clip(borders, 0, 1), 0.0, 1.0])
            between = start + ((met[1:] + met[:-1]) / 2)[:, None] * (stop - start)
            count += bool((np.abs(between - card) < half).all(axis=1).any())
    return count


def crowd(
    points: np.ndarray, others: np.ndarray, near: float, touch: float, ends: int, tips: int
) -> tuple[float, int]:
    """How near a curve is to others, by all distances."""
    close, touched = 0.0, 0
    for other in others:
        apart = np.linalg.norm(points[:, None] - other[None], axis=2).min(axis=1)
        close += np.maximum(1 - apart[ends:-ends] / near, 0).mean()
        touched += apart[tips:-tips].min() < touch
    return close, touched
