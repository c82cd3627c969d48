"""Which moment should look like the body now, while a stretch of a motif plays: so that a person sees that it fits.

Conventions
-----------
Half a cycle later an anti-phase movement is its own mirror image, a palindrome is on its way back where it was on its
way out. What belongs together is told way by way: from mark to mark by the warping path through D or D*, else evenly.
"""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from leitmotion.discovery import SymmetrySpan
from leitmotion.motion import DataError
from leitmotion.similarity import DoubleMetric, align
from leitmotion.view.symmetry_words import FITS, ITS_IMAGE

APART_S = 0.15  # between two moments of now that are told

Way = list[float]


def fit(span: SymmetrySpan, rate: float, distances: DoubleMetric | None = None) -> dict[str, Any]:
    """Say which moment should look like the body now, and whether in the mirror, while a stretch plays.

    Parameters
    ----------
    span : SymmetrySpan
        The stretch.
    rate : float
        Frames per second of it.
    distances : DoubleMetric, optional
        What it was found in; without it moments run evenly from mark to mark.

    Returns
    -------
    dict
        ``mirrored``, ``words``, and for each way ``at``, moments of now in order, and ``to``, what belongs to each,
        seconds. Where every moment is its own mirror image, or the form has no marks, it is now itself.

    Examples
    --------
    >>> fit(SymmetrySpan("anti_phase", 0, 90, 0.9, cyclic=True, marks=[0, 30, 60, 90]), 30.0)["to"]
    [[1.0, 2.0], [2.0, 3.0], [1.0, 2.0]]
    """
    ways, others = _ways(span, rate)
    if not others:
        whole = [span.start / rate, span.stop / rate]
        return {"mirrored": True, "words": ITS_IMAGE, "at": [whole], "to": [whole]}
    mirrored = span.motif.startswith(("anti", "reflected"))
    if distances is not None:
        matrix = distances.mirror if mirrored else distances.own
        told = [_along(matrix, distances.rate, *pair) for pair in zip(ways, others, strict=True)]
        ways, others = [at for at, _ in told], [to for _, to in told]
    return {"mirrored": mirrored, "words": FITS[span.motif], "at": ways, "to": others}


def _ways(span: SymmetrySpan, rate: float) -> tuple[list[Way], list[Way]]:
    """Ways of a stretch, and to each the way that is like it, turned round where it is gone backwards."""
    if span.partner is not None:
        there = [moment / rate for moment in span.partner]
        return [[span.start / rate, span.stop / rate]], [
            there[::-1] if span.motif == "path_reversal" else there
        ]
    ways = [list(pair) for pair in itertools.pairwise(float(mark / rate) for mark in span.marks)]
    if len(ways) > 1 and span.motif in ("anti_phase", "asymmetric_cycle"):
        return ways, [*ways[1:], ways[-2]]
    if len(ways) > 1 and span.motif in ("anti_palindrome", "asymmetric_palindrome"):
        return ways, [ways[k ^ 1 if k ^ 1 < len(ways) else k - 1][::-1] for k in range(len(ways))]
    return ways, []


def _along(matrix: np.ndarray, rate: float, way: Way, other: Way) -> tuple[Way, Way]:
    """Follow the warping path of two ways; where none leads through they run evenly."""
    last = len(matrix) - 1
    first, end = (min(round(moment * rate), last) for moment in way)
    low, high = (min(round(moment * rate), last) for moment in sorted(other))
    if end - first < 2 or high - low < 2:
        return way, other
    back = other[0] > other[1]
    block = matrix[first : end + 1, low : high + 1]
    try:
        path = align(block[:, ::-1] if back else block, step="symmetric2").path
    except DataError:
        return way, other
    rows = np.unique(np.linspace(0, end - first, max(round((end - first) / rate / APART_S), 1) + 1).round())
    there = np.interp(rows, *_one_each(path))
    columns = high - there if back else low + there
    return _seconds((first + rows) / rate), _seconds(columns / rate)


def _one_each(path: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """One column for each row of a path: the middle of those that it meets there."""
    rows, where = np.unique(path[:, 0], return_inverse=True)
    return rows, np.bincount(where, path[:, 1]) / np.bincount(where)


def _seconds(moments: np.ndarray) -> Way:
    return [round(float(moment), 3) for moment in moments]
