"""The default way to find patterns: stripes by local alignment, families of cycles, returns.

Conventions
-----------
Everything is searched at one working rate and measured in body sizes, so that the answer is the same at any frame
rate, in any unit and for any body. Moments are of the working rate, frames of the recording.

References
----------
Paper P (Tang, Leung, Komura, Shum, 2008), whose steps stay recognisable: posture matrix, traced paths, families of
aligned paths, cycles. docs/papers/P.md tells where and why this differs.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from leitmotion.discovery.cuts import CUTS
from leitmotion.discovery.loops import loop_of
from leitmotion.discovery.moves import moves_of
from leitmotion.discovery.pattern import Patterns
from leitmotion.discovery.pauses import true_runs
from leitmotion.discovery.refine import Refiner
from leitmotion.discovery.search import Criteria, SecondLook, search
from leitmotion.discovery.stripes import AMPLITUDE_SHARE, REACH_S, Likeness, likeness
from leitmotion.discovery.tracing import trace_stripes
from leitmotion.discovery.writing import Found, Scribe, length_in_words
from leitmotion.features.catalogue import FEATURES
from leitmotion.features.resampling import resample
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import ParameterError
from leitmotion.similarity import Distances

WORKING_RATE = 30.0  # hertz
MAX_DISTANCE = FEATURES["posture"].alike["equal"]  # body sizes: equal error rate of postures labelled by eye
MIN_AMPLITUDE = 0.012  # body sizes: what the joints must move, on average, not to be still
MIN_CONTRAST = 0.3  # a stripe must be this much nearer than its surroundings
SECOND_LOOK = SecondLook(wider=1.5, min_contrast=0.4, amplitude_share=AMPLITUDE_SHARE)
MIN_DURATION_S = 0.5  # seconds
SHORTEST_S = 0.1  # a stretch of three moments
MISS_S = 600.0  # what comes nearest is looked for among stretches this far apart
USUAL = Criteria(MAX_DISTANCE, MIN_CONTRAST, MIN_AMPLITUDE, round(MIN_DURATION_S * WORKING_RATE))
"""What counts as a return where nothing is set."""


def find_recurrences(
    features: FeatureSequence,
    *,
    max_distance: float = MAX_DISTANCE,
    min_duration_s: float = MIN_DURATION_S,
    min_amplitude: float = MIN_AMPLITUDE,
    min_contrast: float = MIN_CONTRAST,
    amplitude_share: float = AMPLITUDE_SHARE,
    second_look: SecondLook = SECOND_LOOK,
    stillness: bool = False,
    cuts: str = "stripes",
) -> Patterns:
    """Find what recurs, without a parameter to set.

    Parameters
    ----------
    features : FeatureSequence
        Postures in body sizes, T frames; see :func:`leitmotion.features.posture`.
    max_distance : float
        Mean distance of the joints below which two postures are alike, body sizes.
    min_duration_s : float
        Shortest stretch that counts as coming back, seconds.
    min_amplitude : float
        How far the joints must move within a second, on average, not to be still, body sizes.
    min_contrast : float
        How much nearer than its surroundings a return must be, 0 to 1.
    amplitude_share : float
        Of what the joints move around a moment: of a small movement, what is nearer than this is alike.
    second_look : SecondLook
        What counts as a return in what is left over.
    stillness : bool
        Whether a posture that is held again counts as a pattern. Less than a second that was not seen ends no hold.
    cuts : {"stripes", "members", "autocorrelation"}
        What cuts a run into cycles: the stripe of one period; the same, moved to where the members of the family start
        and end; or paper P, eq. 5.

    Returns
    -------
    Patterns
        The pattern that fills most time first. Occurrences of two movements that come back later may overlap by half of
        `min_duration_s`, as what is left of a stretch is cut only where more of it is explained.

    Raises
    ------
    ParameterError
        When a parameter is out of range.
    """
    for name, value in (("max_distance", max_distance), ("min_duration_s", min_duration_s)):
        if not 0 < value < np.inf:
            raise ParameterError(f"{name} must be positive and finite, got {value}.")
    if min_duration_s < SHORTEST_S:
        raise ParameterError(
            f"min_duration_s must be {SHORTEST_S:g} s or more, got {min_duration_s:g}.",
            remedy=f"At {WORKING_RATE:g} moments a second a shorter stretch shows no movement.",
        )
    if not 0 <= min_amplitude < np.inf:
        raise ParameterError(f"min_amplitude must be 0 or more and finite, got {min_amplitude}.")
    if not 0 <= min_contrast < 1:
        raise ParameterError(f"min_contrast must lie in [0, 1), got {min_contrast}.")
    if not 0 < amplitude_share <= 1:
        raise ParameterError(f"amplitude_share must lie in (0, 1], got {amplitude_share}.")
    if cuts not in CUTS:
        raise ParameterError(f"cuts must be one of {', '.join(CUTS)}, got {cuts!r}.")
    parameters: dict[str, object] = {
        "method": "recurrence", "working_rate_hz": WORKING_RATE,
        "max_distance": max_distance, "max_distance_own_unit": max_distance * features.scale, "unit": features.unit,
        "min_duration_s": min_duration_s, "min_amplitude": min_amplitude, "min_contrast": min_contrast,
        "amplitude_share": amplitude_share, "stillness": stillness, "cuts": cuts, "features": list(features.names),
    }  # fmt: skip
    shortest = round(min_duration_s * WORKING_RATE)
    criteria = Criteria(max_distance, min_contrast, min_amplitude, shortest, cuts, amplitude_share)
    again = second_look.of(criteria)
    parameters |= {
        "second_max_distance": again.max_distance,
        "second_max_distance_own_unit": again.max_distance * features.scale,
        "second_min_contrast": again.min_contrast,
        "second_amplitude_share": again.share,
    }
    work = resample(features, WORKING_RATE)
    if len(work) < 2 * min_duration_s * WORKING_RATE:
        miss = (
            f"The recording lasts {len(features) / features.rate:.1f} s, "
            f"too short for two stretches of {min_duration_s:g} s."
        )
        return Patterns((), (), features.rate, parameters, miss)
    distances = Distances(work)
    found, limits = look(features, distances, criteria, second_look)
    parameters |= limits
    scribe = Scribe(features, distances, criteria)
    if stillness:
        found += [
            scribe.held(spans) for spans in _held_postures(distances, scribe.alike, max_distance, shortest)
        ]
    written = scribe.write(found)
    return Patterns(
        written.patterns,
        written.pairs,
        features.rate,
        parameters | written.limits,
        "" if found else _nearest_miss(distances, scribe.alike, features, parameters),
        written.stripes,
    )


def look(
    features: FeatureSequence,
    distances: Distances,
    criteria: Criteria,
    second_look: SecondLook = SECOND_LOOK,
) -> tuple[list[Found], dict[str, object]]:
    """Look for what recurs, and once more, farther, in what is left over.

    A recording that is a loop of copies is one movement, and nothing is looked for within it.

    Each look judges what it found by its own distance: whether occurrences are alike, which decides what stays, and
    how near they are, which counts for the confidence. By the distance of the first look for both nothing is found
    better and the confidence fits less well, on the recordings that a method may be fitted on.

    Parameters
    ----------
    features : FeatureSequence
        The recording, T frames.
    distances : Distances
        Posture distances of the same at the working rate, N moments.
    criteria : Criteria
        What counts as a return.
    second_look : SecondLook
        What does in what is left over.

    Returns
    -------
    list of Found
        Patterns without a name.
    dict
        What was not compared, where a recording is too long.
    """
    work = distances.features
    scribe = Scribe(features, distances, criteria)
    loop = loop_of(features, distances, scribe.alike, criteria.shortest)
    if loop is not None:
        return [scribe.cyclic(loop)], {}
    refine = Refiner(features, work.rate, criteria.max_distance)
    seen = search(distances, criteria, refine)
    found, limits = scribe.describe(seen), seen.limits
    left = _left_over(work, found, features.rate)
    if left is not None:
        wider = second_look.of(criteria)
        scribe = Scribe(features, distances, wider)
        again = search(left, wider, refine)
        found += scribe.describe(again)
        limits = limits | {f"second_{name}": value for name, value in again.limits.items()}
        left = _left_over(work, found, features.rate)
        if left is not None:
            moves = moves_of(left, scribe.alike, wider)
            found += scribe.describe(moves)
            limits = moves.limits | limits
    return found, limits


def _left_over(work: FeatureSequence, found: Sequence[Found], rate: float) -> Distances | None:
    """What no pattern explains, all else hidden; None where too little is left."""
    ratio = rate / work.rate
    taken = np.zeros(len(work), bool)
    for item in found:
        for start, stop, _, _ in item.pattern.stretches:
            taken[int(start / ratio) : int(np.ceil(stop / ratio))] = True
    if taken.all():
        return None
    return Distances(work.replace(values=np.where(taken[:, None], np.nan, work.values)))


def _held_postures(
    distances: Distances, alike: Likeness, max_distance: float, shortest: int
) -> list[list[tuple[float, float]]]:
    """Stretches in which the body keeps still, grouped by posture; groups of two or more."""
    seen = np.isfinite(distances.features.values).any(axis=1)
    # moments within reach are compared across a gap, so that a shorter one ends no stillness
    hidden = [gap for gap in true_runs(~seen) if gap[1] - gap[0] >= REACH_S * distances.features.rate]
    still = alike.still.copy()
    for start, stop in hidden:
        still[start:stop] = False
    groups: list[tuple[int, list[tuple[float, float]]]] = []
    for start, stop in true_runs(still):
        moments = start + np.flatnonzero(seen[start:stop])
        if not len(moments) or moments[-1] + 1 - moments[0] < shortest:
            continue
        span, middle = (int(moments[0]), int(moments[-1]) + 1), int(moments[len(moments) // 2])
        for posture, group in groups:
            if distances.along(np.array([(middle, posture)]))[0] < max_distance:
                group.append(span)
                break
        else:
            groups.append((middle, [span]))
    return [group for _, group in groups if len(group) >= 2]


def _nearest_miss(
    distances: Distances, alike: Likeness, features: FeatureSequence, asked: dict[str, Any]
) -> str:
    """Say what came nearest when nothing was found: search once more, twice as generously.

    Empty where nothing comes near even so.
    """
    if not np.isfinite(distances.features.values).any():
        return "Nothing was seen in this recording."
    if alike.still.all():
        held = "no posture is held again" if asked["stillness"] else "stillness does not count as a repeat"
        return f"The body keeps still all the time, and {held}."
    generous = 2 * asked["max_distance"]
    alike = likeness(distances, max_distance=generous, min_amplitude=asked["min_amplitude"], share=1.0)
    near = trace_stripes(
        distances, alike, max_distance=generous, min_duration_s=asked["min_duration_s"], horizon_s=MISS_S
    ).stripes
    if not near:
        return ""
    best = max(
        near,
        key=lambda s: min(s.contrast / max(asked["min_contrast"], 1e-9), 2 - s.cost / asked["max_distance"]),
    )
    a, b = (tuple(moment / WORKING_RATE for moment in span) for span in (best.a, best.b))
    apart = length_in_words(best.cost, features.scale, features.unit)
    times = best.background / best.cost if best.cost > 0 else np.inf
    clear = f"{times:.2f} times" if times > 1.005 else "no"
    limit = length_in_words(asked["max_distance"], features.scale, features.unit)
    if best.cost > asked["max_distance"]:
        why = f"which is not near enough: the limit is {limit}"
    elif best.contrast < asked["min_contrast"]:
        why = f"which is not clear enough: {1 / (1 - asked['min_contrast']):.2f} times are asked for"
    else:
        why = f"near and clear on average, but not within {limit} for long enough at a time"
    return (
        f"The nearest: {a[0]:.1f} to {a[1]:.1f} s and {b[0]:.1f} to {b[1]:.1f} s are {apart} apart on average, "
        f"{clear} nearer than their surroundings, {why}."
    )
