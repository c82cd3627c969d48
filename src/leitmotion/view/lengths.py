"""How long the times of a pattern last, and whether patterns share time, in words."""

from __future__ import annotations

import numpy as np

from leitmotion.discovery import Pattern, Patterns, SharedPattern, SharedPatterns

UNEVEN = 0.25  # of the median: times that differ by more are told by the shortest and the longest


def lasts(pattern: Pattern) -> str:
    """Say how long one time lasts: the median, or from where to where when times differ by more than a person minds.

    Parameters
    ----------
    pattern : Pattern
        What recurs.

    Returns
    -------
    str
        For example ``"1.74 s"`` or ``"0.8–1.2 s"``.
    """
    lengths = (pattern.occurrences.stops - pattern.occurrences.starts) / pattern.occurrences.rate
    return _from_where_to_where(lengths, pattern.period_s)


def shared_lasts(pattern: SharedPattern, found: SharedPatterns) -> str:
    """Say how long one time of a movement lasts that may occur in several recordings, as :func:`lasts` does.

    Parameters
    ----------
    pattern : SharedPattern
        What recurs.
    found : SharedPatterns
        What it is one of; it knows the rates.

    Returns
    -------
    str
        For example ``"2.10 s"`` or ``"1.6–2.7 s"``.
    """
    places = pattern.occurrences
    rates = np.asarray(found.rates)[places.recordings]
    return _from_where_to_where((places.stops - places.starts) / rates, pattern.period_s)


def _from_where_to_where(lengths: np.ndarray, median: float) -> str:
    if lengths.max() - lengths.min() <= UNEVEN * median:
        return f"{median:.2f} s"
    return f"{lengths.min():.1f}–{lengths.max():.1f} s"


def overlap(patterns: Patterns) -> str:
    """Say that patterns overlap in time, where one has most of a time of another, as those of paper P's method may.

    Parameters
    ----------
    patterns : Patterns
        What recurs.

    Returns
    -------
    str
        A sentence; empty where they do not.
    """
    reach = 0
    for start, stop in sorted((a, b) for pattern in patterns for a, b, _, _ in pattern.occurrences):
        if 2 * (min(reach, stop) - start) > stop - start:
            return "These patterns overlap: a moment may belong to several."
        reach = max(reach, stop)
    return ""
