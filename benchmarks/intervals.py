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
