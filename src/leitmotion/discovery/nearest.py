"""The nearest miss across recordings: what came nearest where no two recordings share a movement."""

from __future__ import annotations

from collections.abc import Sequence

from leitmotion.discovery.joining import Joined, join
from leitmotion.discovery.recurrence import SECOND_LOOK, WORKING_RATE
from leitmotion.discovery.shared import SharedPatterns
from leitmotion.discovery.stripes import Stripe, likeness
from leitmotion.discovery.tracing import trace_stripes
from leitmotion.discovery.writing import length_in_words
from leitmotion.features.resampling import resample
from leitmotion.features.sequence import FeatureSequence
from leitmotion.similarity import Distances

HORIZON_S = 600.0
"""Stretches farther apart, all recordings in a row, are not looked at: what is told is a hint, and soon."""
GENEROUS = 2.0
"""Times the distance that counts as alike: beyond it, nothing is near."""


def nearest_across(sequences: Sequence[FeatureSequence], found: SharedPatterns) -> str:
    """Say what came nearest to being shared by two recordings: a search of theirs, twice as generous.

    Parameters
    ----------
    sequences : sequence of FeatureSequence
        What was searched.
    found : SharedPatterns
        What was found, with the parameters of the search.

    Returns
    -------
    str
        One sentence; empty where two recordings share something, or nothing comes near even so.

    Examples
    --------
    >>> import numpy as np
    >>> from leitmotion.discovery import find_shared_patterns
    >>> phase = np.linspace(0, 2 * np.pi, 45)
    >>> wave = np.stack([0.3 * (1 - np.cos(phase)), 0.3 * np.sin(phase), 0.3 * np.sin(2 * phase)], axis=1)
    >>> hands = [
    ...     FeatureSequence(wave + shift, ("hand",), rate=30, invariant_to=("place",), width=3)
    ...     for shift in (0, [0, 0.15, 0])
    ... ]
    >>> print(nearest_across(hands, find_shared_patterns(hands, names=("a", "b"))))
    The nearest: 0... to 1... s of a and 0... to 1... s of b are 0.1... apart on average, 1... cm; the limit is ...
    """
    if found.shared:
        return ""
    limit, shortest, least, contrast = (
        float(str(found.parameters[name]))
        for name in ("max_distance", "min_duration_s", "min_amplitude", "min_contrast")
    )
    joined = join(sequences, found.names)
    distances = Distances(resample(joined.features, WORKING_RATE))
    generous = GENEROUS * limit
    alike = likeness(distances, max_distance=generous, min_amplitude=least, share=1.0)
    traced = trace_stripes(
        distances, alike, max_distance=generous, min_duration_s=shortest, horizon_s=HORIZON_S
    ).stripes
    across = [stripe for stripe in traced if len(set(_owners(stripe, joined))) == 2]
    if not across:
        return ""
    best = max(
        across,
        key=lambda stripe: min(stripe.contrast / max(contrast, 1e-9), 2 - stripe.cost / limit),
    )
    return _sentence(best, joined, found, limit)


def _owners(stripe: Stripe, joined: Joined) -> list[int]:
    times = joined.features.rate / WORKING_RATE
    middle = stripe.path[len(stripe.path) // 2]
    return [int(owner) for owner in joined.owner((middle * times).astype(int))]


def _sentence(best: Stripe, joined: Joined, found: SharedPatterns, limit: float) -> str:
    owners = _owners(best, joined)
    begins = joined.begins[owners] / joined.features.rate
    spans = [
        f"{start / WORKING_RATE - begin:.1f} to {stop / WORKING_RATE - begin:.1f} s of {found.names[owner]}"
        for (start, stop), begin, owner in zip((best.a, best.b), begins, owners, strict=True)
    ]
    unit = joined.features.unit
    length = f", {length_in_words(best.cost, joined.features.scale, unit)}" if unit == "m" else ""
    told = (
        f"The nearest: {spans[0]} and {spans[1]} are {best.cost:.3f} apart on average{length}; "
        f"the limit is {limit:g}, at the second look {SECOND_LOOK.wider * limit:g}"
    )
    if best.cost > SECOND_LOOK.wider * limit:
        return f"{told}."
    if best.contrast >= float(str(found.parameters["min_contrast"])):
        return f"{told}; they are near on average, but not near for long enough at a time."
    times = best.background / best.cost if best.cost > 0 else float("inf")
    clear = f"only {times:.1f} times" if times > 1.05 else "no"
    return f"{told}, but they are {clear} nearer than their surroundings, which is not clear enough."
