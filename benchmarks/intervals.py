"""Intervals of means and shares, 95 %."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def of_mean(values: Sequence[float] | np.ndarray) -> tuple[float, float]:
    """Lower and upper end of the interval of a mean, by the bootstrap."""
    held = np.asarray(values, dtype=float)
    rng = np.random.default_rng(0)
    means = [rng.choice(held, held.size).mean() for _ in range(2000)]
    return float(np.quantile(means, 0.025)), float(np.quantile(means, 0.975))


def of_share(count: int, of: int) -> tuple[float, float]:
    """Lower and upper end of the interval of a share, by Wilson's score, which does not vanish where all are alike."""
    z = 1.959964
    middle = (count + z * z / 2) / (of + z * z)
    reach = z / (of + z * z) * np.sqrt(count * (of - count) / of + z * z / 4)
    return float(max(0.0, middle - reach)), float(min(1.0, middle + reach))


def of_pooled_share(counts: Sequence[tuple[int, int]]) -> tuple[float, float]:
    """Lower and upper end of the interval of a share over groups of (right, of), by the bootstrap over groups.

    Where all or none are right, by Wilson's score over the groups that hold any.
    """
    held = np.array([pair for pair in counts if pair[1]], dtype=float)
    right, of = held.sum(axis=0)
    if right in (0, of):
        return of_share(len(held) if right else 0, len(held))
    rng = np.random.default_rng(0)
    drawn = held[rng.integers(len(held), size=(2000, len(held)))].sum(axis=1)
    shares = drawn[:, 0] / drawn[:, 1]
    return float(np.quantile(shares, 0.025)), float(np.quantile(shares, 0.975))
