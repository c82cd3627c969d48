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
    spans = pattern.occurrences
    longest = float((spans.stops - spans.starts)[[k, m]].max()) / spans.rate
    rate = min(WORKING_RATE, MOMENTS / longest)
    rows, columns = (_moments(spans, n, rate) for n in (k, m))
    a, b = (at_moments(features, moments) for moments in (rows, columns))
    distances = cross_distance(a, b).values.astype(np.float64)
    known = np.isfinite(distances)
    laid = align(np.where(known, distances, distances[known].max(initial=0.0)))
    path = np.stack((rows[laid.path[:, 0]], columns[laid.path[:, 1]]), axis=1)
    return laid.replace(path=np.round(path * spans.rate).astype(np.int64))


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
