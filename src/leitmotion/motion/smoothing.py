"""Smoothing and differentiating: noise above a frequency taken away without delay, and the rate at which a path goes.

A Butterworth filter of second order runs forwards and backwards, so that nothing is delayed and the order is four.
Two passes would halve the power at the cutoff twice; the cutoff of each pass is raised, on the tangent scale of
the digital filter, by ``1 / (2**(1/2) - 1)**(1/4) = 1.247``, so that the two together halve it once [1].

References
----------
[1] Winter, *Biomechanics and Motor Control of Human Movement*: digital filtering.
"""

from __future__ import annotations

import numpy as np

ORDER = 2  # of one pass; two passes make four
PASSES = 2
CORRECTION = (2 ** (1 / PASSES) - 1) ** (1 / (2 * ORDER))
HIGHEST = 0.45
"""Share of the rate that a cutoff must stay below."""
SHORTEST = 5
"""Frames of a path that is filtered; in fewer there is nothing to part."""


def smooth(paths: np.ndarray, cutoff_hz: float, rate: float) -> np.ndarray:
    """Take away what is faster than a cutoff, without delay.

    Parameters
    ----------
    paths : (T, ...) float
        Without gaps, time first; five frames or more.
    cutoff_hz : float
        Where half of the power is left, above 0 and below 0.45 of the rate.
    rate : float
        Frames per second.

    Returns
    -------
    (T, ...) float
        The smooth paths.

    Examples
    --------
    >>> bool(np.allclose(smooth(np.ones((50, 3)), 6.0, 100.0), 1.0))
    True
    """
    from scipy.signal import butter, sosfiltfilt

    raised = (
        np.arctan(np.tan(np.pi * cutoff_hz / rate) / CORRECTION) * rate / np.pi
    )  # on the scale of the digital filter
    sections = butter(ORDER, raised, fs=rate, output="sos")
    first = paths[:1]  # taken off, so that a place far from zero costs no digits
    padding = min(len(paths) - 1, max(9, round(rate / cutoff_hz)))
    filtered: np.ndarray = sosfiltfilt(sections, paths - first, axis=0, padlen=padding) + first
    return filtered


def derivative(paths: np.ndarray, rate: float) -> np.ndarray:
    """Differentiate along time, by the cubic spline through the frames.

    Of a wave of half the Nyquist frequency a central difference keeps 64 % of the speed, the spline 95 %, so that what
    is found depends less on the rate; a parabola is differentiated exactly, at both ends too.

    Parameters
    ----------
    paths : (T, ...) float
        Without gaps, time first; two frames or more.
    rate : float
        Frames per second.

    Returns
    -------
    (T, ...) float
        Per second.

    Examples
    --------
    >>> t = np.arange(20) / 10.0
    >>> bool(np.allclose(derivative(t**2, 10.0), 2 * t))
    True
    """
    from scipy.interpolate import CubicSpline

    times = np.arange(len(paths)) / rate
    speeds: np.ndarray = CubicSpline(times, paths, axis=0).derivative()(times)
    return speeds
