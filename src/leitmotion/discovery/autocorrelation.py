"""Autocorrelation of postures: where a stretch that repeats is cut into cycles by paper P, eq. 5."""

from __future__ import annotations

import numpy as np

PEAK = 0.2  # which peaks of eq. 5 are "sufficiently high": half cycles stay below, whole ones of people above


def cycle_lags(x: np.ndarray, shortest: int) -> list[int]:
    """Find the lags of the high peaks of eq. 5, no two nearer than the shortest pattern.

    The sum of eq. 5 has L - lag terms and so fades as (L - lag) / L; a peak must reach PEAK of that.

    Parameters
    ----------
    x : (L, D) float
        Postures of a stretch that repeats; columns that are not always seen do not count.
    shortest : int
        Least distance of two peaks and of a peak from either end, frames.

    Returns
    -------
    list of int
        Lags in ascending order; none where nothing repeats.

    Examples
    --------
    >>> swing = np.sin(2 * np.pi * np.arange(40) / 10)[:, None]
    >>> cycle_lags(swing, 5)
    [10, 20, 30]
    """
    L = len(x)
    r = _autocorrelation(x)
    lag = np.arange(max(shortest, 1), L - shortest + 1)
    is_peak = (
        (r[lag] > r[lag - 1]) & (r[lag] >= r[np.minimum(lag + 1, L - 1)]) & (r[lag] >= PEAK * (L - lag) / L)
    )
    peaks: list[int] = []
    for peak in sorted(lag[is_peak].tolist(), key=lambda k: (-r[k], k)):
        if all(abs(peak - other) >= shortest for other in peaks):
            peaks.append(peak)
    return sorted(peaks)


def _autocorrelation(x: np.ndarray) -> np.ndarray:
    """Eq. 5: correlation of x (L, D) with itself at each lag, averaged over the columns that move and are seen."""
    L = len(x)
    x = x[:, ~np.isnan(x).any(axis=0)]
    centred = x - x.mean(axis=0)
    power = (centred**2).sum(axis=0)
    moving = power > 1e-12 * max(power.max(initial=0.0), 1e-300)
    if not moving.any():
        return np.zeros(L)
    spectrum = np.fft.rfft(centred[:, moving], 2 * L, axis=0)
    r = np.fft.irfft(abs(spectrum) ** 2, 2 * L, axis=0)[:L]
    return np.asarray((r / power[moving]).mean(axis=1))
