"""Intervals of means: 95 % by the bootstrap."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np


def of_mean(values: Sequence[float] | np.ndarray) -> tuple[float, float]:
    """Lower and upper end of the interval of a mean."""
    held = np.asarray(values, dtype=float)
    rng = np.random.default_rng(0)
    means = [rng.choice(held, held.size).mean() for _ in range(2000)]
    return float(np.quantile(means, 0.025)), float(np.quantile(means, 0.975))
