"""Patterns across recordings: what a folder of recordings shares.

The recordings are joined, with gaps that nothing crosses, and searched once by the default method, so that a movement
of two recordings is held to the same rules as one that comes back within a recording. People differ more from one
another than from themselves, so that the limits are wider than within one recording; limb directions are compared
rather than places, as they know nothing of proportions (:func:`leitmotion.features.limb_directions`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.joining import Joined, join
from leitmotion.discovery.pattern import Pattern, PatternPair, letter
from leitmotion.discovery.recurrence import MIN_AMPLITUDE, MIN_CONTRAST, SECOND_LOOK, find_recurrences
from leitmotion.discovery.search import SecondLook
from leitmotion.discovery.shared import Places, SharedPair, SharedPattern, SharedPatterns
from leitmotion.discovery.stripes import AMPLITUDE_SHARE
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.segmentation import Segmentation


class Limits(NamedTuple):
    """What counts as alike across recordings, chosen on the people that benchmarks/bench_across.py fits on."""

    max_distance: float
    """In the values of the features: postures nearer than this are alike."""

    min_amplitude: float
    """What the joints must move, on average, not to be still."""

    min_contrast: float
    """How much nearer than its surroundings a return must be, 0 to 1."""

    amplitude_share: float
    """Of what the joints move around a moment: of a small movement, what is nearer than this is alike."""

    second_look: SecondLook
    """What counts as alike in what is left over."""


DIRECTIONS = Limits(
    0.35, 0.05, 0.2, AMPLITUDE_SHARE, SecondLook(wider=1.4, min_contrast=0.2, amplitude_share=1.0)
)
"""Of limb directions, radians."""
PLACES = Limits(0.08, MIN_AMPLITUDE, MIN_CONTRAST, AMPLITUDE_SHARE, SECOND_LOOK)
"""Of postures, body sizes: at 0.1, walks of one person are taken for runs of another."""


def find_shared_patterns(
    sequences: Sequence[FeatureSequence],
    *,
    names: Sequence[str] | None = None,
    max_distance: float | None = None,
    min_duration_s: float = 0.5,
    min_amplitude: float | None = None,
    min_contrast: float | None = None,
) -> SharedPatterns:
    """Find the movements that recur in several recordings, of one person or of several, in two of them or within one.

    Parameters
    ----------
    sequences : sequence of FeatureSequence
        Limb directions of each recording (:func:`leitmotion.features.limb_directions`), or postures in body sizes
        (:func:`leitmotion.features.posture`). Rates and joints may differ: what all have is compared.
    names : sequence of str, optional
        Of the recordings; by default "recording 1" and so on.
    max_distance : float, optional
        Mean distance of the joints below which two moments are alike, in the values of the features; wider than within
        one recording. By default that of :data:`DIRECTIONS` where they are radians, else of :data:`PLACES`.
    min_duration_s : float
        Shortest stretch that counts as coming back, seconds.
    min_amplitude, min_contrast : float, optional
        As for :func:`leitmotion.discovery.find_recurrences`; by default as for `max_distance`.

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
    usual = DIRECTIONS if joined.features.unit == "rad" else PLACES
    asked = {"max_distance": max_distance, "min_amplitude": min_amplitude, "min_contrast": min_contrast}
    limits = usual._asdict() | {name: value for name, value in asked.items() if value is not None}
    found = find_recurrences(joined.features, min_duration_s=min_duration_s, **limits)
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
