"""Patterns across recordings: what a folder of recordings shares.

The recordings are joined, with gaps that nothing crosses, and searched once by the default method, so that a movement
of two recordings is held to the same rules as one that comes back within a recording. Each recording is measured
in its own body's size, so that people of different size are compared.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.discovery.joining import Joined, join
from leitmotion.discovery.pattern import Pattern, PatternPair, letter
from leitmotion.discovery.recurrence import MIN_AMPLITUDE, MIN_CONTRAST, find_recurrences
from leitmotion.discovery.shared import Places, SharedPair, SharedPattern, SharedPatterns
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.segmentation import Segmentation

MAX_DISTANCE = 0.08
"""Body sizes: people differ more from one another than from themselves. The upper end of the interval that the labelled
pairs leave for one person; beyond it, walks of one person are soon taken for runs of another."""


def find_shared_patterns(
    sequences: Sequence[FeatureSequence],
    *,
    names: Sequence[str] | None = None,
    max_distance: float = MAX_DISTANCE,
    min_duration_s: float = 0.5,
    min_amplitude: float = MIN_AMPLITUDE,
    min_contrast: float = MIN_CONTRAST,
) -> SharedPatterns:
    """Find the movements that recur in several recordings, of one person or of several, in two of them or within one.

    Parameters
    ----------
    sequences : sequence of FeatureSequence
        Postures of each recording in body sizes; see :func:`leitmotion.features.posture`. Rates and joints may
        differ: what all have is compared.
    names : sequence of str, optional
        Of the recordings; by default "recording 1" and so on.
    max_distance : float
        Mean distance of the joints below which two postures are alike, body sizes; wider than within one recording.
    min_duration_s, min_amplitude, min_contrast : float
        As for :func:`leitmotion.discovery.find_recurrences`.

    Returns
    -------
    SharedPatterns
        Those of two or more recordings first.

    Raises
    ------
    ParameterError
        When there are fewer than two recordings or a parameter is out of range.
    DataError
        When the recordings cannot be compared.

    Examples
    --------
    >>> import numpy as np
    >>> phase = np.linspace(0, 2 * np.pi, 45)
    >>> wave = np.stack([0.1 * (1 - np.cos(phase)), 0.1 * np.sin(phase), 0.1 * np.sin(2 * phase)], axis=1)
    >>> hand = FeatureSequence(wave, ("hand",), rate=30, invariant_to=("place",), width=3)
    >>> found = find_shared_patterns([hand, hand])
    >>> found.patterns[0].recordings, found.counts.tolist()
    ((0, 1), [[1], [1]])
    """
    called = tuple(names) if names is not None else tuple(f"recording {k + 1}" for k in range(len(sequences)))
    joined = join(sequences, called)
    found = find_recurrences(
        joined.features,
        max_distance=max_distance,
        min_duration_s=min_duration_s,
        min_amplitude=min_amplitude,
        min_contrast=min_contrast,
    )
    patterns = [_placed(pattern, joined) for pattern in found.patterns]
    patterns = sorted(patterns, key=lambda pattern: len(pattern.recordings) == 1)  # stable: most time first
    letters = {pattern.id: letter(k) for k, pattern in enumerate(patterns)}
    pairs = [_pair(pair, letters[pair.pattern], joined) for pair in found.pairs]
    return SharedPatterns(
        tuple(pattern.replace(id=letters[pattern.id]) for pattern in patterns),
        tuple(sorted(pairs, key=lambda pair: (len(pair.pattern), pair.pattern))),
        called,
        joined.rates,
        joined.frames,
        found.parameters | {"invariant_to": list(joined.features.invariant_to)},
    )


def _placed(pattern: Pattern, joined: Joined) -> SharedPattern:
    return SharedPattern(
        id=pattern.id, kind=pattern.kind,
        occurrences=_places(pattern.occurrences, joined), stretches=_places(pattern.stretches, joined),
        period_s=pattern.period_s, cost=pattern.cost, confidence=pattern.confidence, reason=pattern.reason,
    )  # fmt: skip


def _places(spans: Segmentation, joined: Joined) -> Places:
    """In frames of the recordings; each at least one frame long, as a slow recording may have it."""
    recordings = joined.owner((spans.starts + spans.stops) // 2)
    starts = np.minimum(joined.frame(spans.starts, recordings), joined.frames[recordings] - 1)
    stops = np.maximum(joined.frame(spans.stops, recordings), starts + 1)
    return Places(recordings, starts, stops, spans.scores)


def _pair(pair: PatternPair, name: str, joined: Joined) -> SharedPair:
    recordings = joined.owner(pair.path[len(pair.path) // 2])
    frames = np.stack([_along(pair.path[:, side], recordings[side], joined) for side in (0, 1)], axis=1)
    return SharedPair(name, recordings, frames, pair.cost)


def _along(moments: np.ndarray, recording: np.int64, joined: Joined) -> np.ndarray:
    """Frames along a path; its last moment lasts to the frame before the next."""
    owners = np.full(len(moments), recording)
    frames = joined.frame(moments, owners)
    last = (moments[-1] + 1 - joined.begins[recording]) * joined.rates[recording] / joined.features.rate
    frames[-1] = max(frames[-1], round(last) - 1)
    return np.minimum(frames, joined.frames[recording] - 1)
