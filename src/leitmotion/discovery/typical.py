"""The typical occurrence of a pattern: the one that is nearest to all others once they are laid over one another.

Conventions
-----------
Occurrences are aligned at a working rate of 30 moments a second, whatever the rate of the recording; those that last
longer than a minute at a lower one, as memory grows with the square of the number of moments.
"""

from __future__ import annotations

import numpy as np

from leitmotion.discovery.pattern import Pattern
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.segmentation import Segmentation
from leitmotion.similarity import Alignment, align, cross_distance

WORKING_RATE = 30.0  # hertz
MOMENTS = 2000  # of an occurrence, at most
SAME_CUT = 0.75
"""Of the distance from border to border: what is not nearer elsewhere than this was not cut at another phase."""
SHORTEST = 8
"""Moments of the shortest occurrence that has a phase to be cut at."""
COMPARED = 40  # occurrences that may become the typical one, and others that each is aligned with


def typical_occurrence(pattern: Pattern, features: FeatureSequence) -> int:
    """Find the medoid of the occurrences: least mean cost of the warping paths to the others.

    Of a pattern that occurs very often the 40 occurrences of the highest score are tried, and 40 spread over all stand
    for the others. Of equals the earliest is taken; of two occurrences that is the first.

    Parameters
    ----------
    pattern : Pattern
        What recurs.
    features : FeatureSequence
        What of each frame is compared, of the whole recording, at any rate.

    Returns
    -------
    int
        Which occurrence, from 0.

    Raises
    ------
    ParameterError
        When the features end before the pattern does.

    Examples
    --------
    >>> from leitmotion.motion import Segmentation
    >>> height = FeatureSequence([[0.0], [9.0], [0.0], [5.0], [0.0], [4.0]], ("hand",), rate=30)
    >>> spans = Segmentation([0, 2, 4], [2, 4, 6], rate=30)
    >>> typical_occurrence(Pattern("A", "acyclic", spans, spans, 0.07, 0.0, 1.0), features=height)
    1
    """
    check_features(pattern, features)
    spans = pattern.occurrences
    count = len(spans)
    scores = np.where(np.isfinite(spans.scores), spans.scores, 0.0)
    tried = np.sort(np.argsort(-scores, kind="stable")[:COMPARED])
    others = np.unique(np.linspace(0, count - 1, min(count, COMPARED)).round().astype(int))
    costs: dict[tuple[int, int], float] = {}

    def cost(k: int, m: int) -> float:
        pair = min(k, m), max(k, m)
        if pair not in costs:
            costs[pair] = align_occurrences(pattern, *pair, features).cost
        return costs[pair]

    means = [np.mean([cost(int(k), int(m)) for m in others if m != k]) for k in tried]
    return int(tried[int(np.argmin(means))])


def align_occurrences(pattern: Pattern, k: int, m: int, features: FeatureSequence) -> Alignment:
    """Lay two occurrences of a pattern over one another in time.

    Parameters
    ----------
    pattern : Pattern
        What recurs.
    k, m : int
        Which occurrences, from 0.
    features : FeatureSequence
        What is compared, of the whole recording; a moment of which nothing is seen is as far as the farthest.

    Returns
    -------
    Alignment
        `path` in frames of the occurrences; a step a moment, at 30 Hz unless they last longer than a minute. `cost` is
        the mean distance along it.
    """
    check_features(pattern, features)
    rows, columns, _ = _both(pattern.occurrences, k, m)
    distances = _distances(features, rows, columns)
    known = np.isfinite(distances)
    laid = align(np.where(known, distances, distances[known].max(initial=0.0)))
    return _in_frames(laid, rows, columns, pattern.occurrences.rate)


def align_elsewhere(pattern: Pattern, k: int, m: int, features: FeatureSequence) -> Alignment | None:
    """Lay one occurrence over another that was cut at another phase; None where it was not.

    A walk that is cut at the left step in one run and at the right step in another differs at every moment, though the
    walks are alike. So the whole of `k` is also looked for around `m`, up to half of the shorter of the two beyond its
    borders, at half to twice the speed. That the distance falls to three quarters or less of what it is from border to
    border shows that the cut is what differed.

    Parameters
    ----------
    pattern, k, m, features
        As for :func:`align_occurrences`.

    Returns
    -------
    Alignment or None
        As :func:`align_occurrences` gives it; the second column of `path` may begin and end outside of `m`.
    """
    spans = pattern.occurrences
    rows, own, rate = _both(spans, k, m)
    beyond = np.arange(1, min(len(rows), len(own)) // 2 + 1) / rate
    columns = np.concatenate((own[0] - beyond[::-1], own, own[-1] + beyond))
    columns = columns[(columns >= 0) & (columns <= (len(features) - 1) / features.rate)]
    if len(rows) < SHORTEST or len(columns) < len(rows):
        return None
    distances = _distances(features, rows, columns)
    known = np.isfinite(distances)
    if not (known.any(axis=0).all() and known.any(axis=1).all()):
        return None  # nobody saw all that would be compared
    filled = np.where(known, distances, distances[known].max())
    free = align(filled, step="symmetricP1", open_begin=True, open_end=True)
    if free.cost > SAME_CUT * align_occurrences(pattern, k, m, features).cost:
        return None
    return _in_frames(free, rows, columns, spans.rate)


def _both(spans: Segmentation, k: int, m: int) -> tuple[np.ndarray, np.ndarray, float]:
    """Moments of two stretches, seconds, and how many there are a second: fewer where they last minutes."""
    longest = float((spans.stops - spans.starts)[[k, m]].max()) / spans.rate
    rate = min(WORKING_RATE, MOMENTS / longest)
    return _moments(spans, k, rate), _moments(spans, m, rate), rate


def _distances(features: FeatureSequence, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
    """Distances of moments, seconds, to others; NaN where nothing of both was seen."""
    a, b = (at_moments(features, moments) for moments in (rows, columns))
    return cross_distance(a, b).values.astype(np.float64)


def _in_frames(laid: Alignment, rows: np.ndarray, columns: np.ndarray, rate: float) -> Alignment:
    path = np.stack((rows[laid.path[:, 0]], columns[laid.path[:, 1]]), axis=1)
    return laid.replace(path=np.round(path * rate).astype(np.int64))


def at_moments(features: FeatureSequence, moments: np.ndarray) -> FeatureSequence:
    """Take the frames nearest to moments in seconds; after the last frame that one."""
    frames = np.clip(np.round(moments * features.rate).astype(np.int64), 0, len(features) - 1)
    return features.replace(values=features.values[frames])


def _moments(spans: Segmentation, k: int, rate: float) -> np.ndarray:
    """Moments of a stretch at a rate, from its first frame on, seconds."""
    start, stop = spans.starts[k] / spans.rate, spans.stops[k] / spans.rate
    count = max(2, round((stop - start) * rate))
    return np.minimum(start + np.arange(count) / rate, stop - 1 / spans.rate)


def check_features(pattern: Pattern, features: FeatureSequence) -> None:
    """Refuse features that end before the pattern does; a frame more is let pass, as rates may differ."""
    spans = pattern.occurrences
    reached, covered = spans.stops.max() / spans.rate, len(features) / features.rate
    if reached > covered + 1 / features.rate:
        raise ParameterError(
            f"The pattern reaches to {reached:.2f} s, but the features cover {covered:.2f} s.",
            remedy="Give the features of the same recording.",
        )
