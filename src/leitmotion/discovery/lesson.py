"""A lesson: what recurs, most frequent first, and how each time it was done differs from the typical one.

Conventions
-----------
The *typical* occurrence of a pattern is the one nearest to all others (:func:`typical_occurrence`). Each other one is
laid over it in time; one that was cut at another phase is laid from where it is in the same phase on, and how far that
is from its own first frame is told apart, as ``shift_s``: it is no way of moving. Where they differ most is looked for
between a tenth and nine tenths of the movement, as borders are uncertain. *Phase* is the share of the typical
occurrence that has passed, 0 to 1. Places are as :func:`leitmotion.features.posture` has them: x to the person's left,
y up, z ahead, in body sizes.

References
----------
Tang, Leung, Komura, Shum, *Finding repetitive patterns in 3D human motion captured data* (2008): its
conclusion names lessons as a use of what recurs, frequent movements first and then their variations.
"""

from __future__ import annotations

import numpy as np

from leitmotion.discovery.pattern import Pattern, Patterns
from leitmotion.discovery.typical import (
    WORKING_RATE,
    align_elsewhere,
    align_occurrences,
    at_moments,
    typical_occurrence,
)
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, check_rate, noun, set_array

EDGE = 0.1
"""Share of a movement at either end where nothing is told: its borders are uncertain."""
NAMED = 3
"""Joints told of each variation: those that differ most."""


@noun
class Difference(Noun):
    """How far one joint is from where it is in the typical occurrence, where that is farthest.

    Parameters
    ----------
    joint : str
        Its role.
    distance : float
        How far, body sizes.
    phase : float
        When: the share of the typical occurrence that has passed, 0 to 1.
    offset : (C,) float
        Whereto, body sizes: to the person's left, up and ahead; across and up in a picture.
    """

    joint: str
    distance: float
    phase: float
    offset: np.ndarray

    def __post_init__(self) -> None:
        set_array(self, "offset", dtype=np.float64, shape=(None,))


@noun
class Variation(Noun):
    """One occurrence of a pattern beside the typical one.

    Parameters
    ----------
    occurrence : int
        Which occurrence of the pattern, from 0.
    start, stop : int
        Its frames, half-open.
    distance : float
        Mean distance of the joints along the warping path, body sizes.
    tempo : float
        How fast it is, from phase to phase: 1.25 takes four fifths of the time of the typical one.
    lag_s : float
        By how many seconds it is behind the typical one where that is most, both stretched to its length; negative:
        ahead.
    lag_phase : float
        When that is, 0 to 1.
    differences : tuple of Difference
        The joints that differ most, farthest first.
    path : (K, 2) int
        Frames of the recording, of the typical occurrence and of this one, that belong together.
    shift_s : float
        How long after its first frame the phase begins with which the typical one begins, seconds; negative: before.
        0 unless the two were cut at different phases: then the path, and all that is told along it, begins and ends
        outside of [`start`, `stop`).
    """

    occurrence: int
    start: int
    stop: int
    distance: float
    tempo: float
    lag_s: float
    lag_phase: float
    differences: tuple[Difference, ...]
    path: np.ndarray
    shift_s: float = 0.0

    def __post_init__(self) -> None:
        set_array(self, "path", dtype=np.int64, shape=(None, 2))


@noun
class Step(Noun):
    """One movement to learn.

    Parameters
    ----------
    pattern : str
        Id of the pattern.
    kind : {"cyclic", "acyclic"}
        That of the pattern.
    count : int
        How often it occurs.
    seconds : float
        How long its occurrences last in all.
    typical : int
        Which occurrence is the typical one, from 0.
    start, stop : int
        Its frames, half-open.
    variations : tuple of Variation
        All other occurrences, in order of time.
    """

    pattern: str
    kind: str
    count: int
    seconds: float
    typical: int
    start: int
    stop: int
    variations: tuple[Variation, ...]


@noun
class Lesson(Noun):
    """What to learn of a recording, most frequent first.

    Parameters
    ----------
    steps : tuple of Step
        By how often each occurs, then by how long its occurrences last in all.
    rate : float
        Frames per second of the recording.
    scale : float
        What one body size is in `unit`.
    unit : {"m", "px", "relative"}
        The recording's own unit.
    turned : bool
        Whether the person was turned to face one way, so that an offset tells left from right and front from back.
    """

    steps: tuple[Step, ...]
    rate: float
    scale: float = 1.0
    unit: str = "m"
    turned: bool = True

    def __post_init__(self) -> None:
        check_rate(self)

    def __len__(self) -> int:
        return len(self.steps)


def make_lesson(features: FeatureSequence, patterns: Patterns) -> Lesson:
    """Rank what recurs and compare each occurrence with the typical one.

    Parameters
    ----------
    features : FeatureSequence
        Postures of the whole recording (:func:`leitmotion.features.posture`), at any rate.
    patterns : Patterns
        What recurs in it.

    Returns
    -------
    Lesson
        A step a pattern; none where nothing recurs.

    Raises
    ------
    ParameterError
        When the features are no places of points, or of another recording.

    Examples
    --------
    >>> from leitmotion.motion import Segmentation
    >>> height = np.zeros((9, 3))
    >>> height[:, 1] = [0, 1, 0, 0, 1, 0, 0, 1.5, 0]
    >>> hand = FeatureSequence(height, ("right_hand",), rate=30, width=3)
    >>> spans = Segmentation([0, 3, 6], [3, 6, 9], rate=30)
    >>> found = Patterns((Pattern("A", "cyclic", spans, spans, 0.1, 0.0, 1.0),), (), 30, {})
    >>> (step,) = make_lesson(hand, found).steps
    >>> step.typical, [round(each.distance, 2) for each in step.variations]
    (0, [0.0, 0.17])
    >>> step.variations[1].differences[0].offset.tolist()
    [0.0, 0.5, 0.0]
    """
    if features.width not in (2, 3) or features.unit not in ("m", "px", "relative"):
        raise ParameterError(
            f"A lesson compares where joints are, got features in {features.unit} of width {features.width}.",
            remedy="Give the posture: leitmotion.features.posture(body).",
        )
    steps = [_step(pattern, features) for pattern in patterns.patterns]
    steps.sort(key=lambda step: (-step.count, -step.seconds))
    turned = "yaw" in features.invariant_to and features.width == 3
    return Lesson(tuple(steps), patterns.rate, features.scale, features.unit, turned)


def _step(pattern: Pattern, features: FeatureSequence) -> Step:
    spans, typical = pattern.occurrences, typical_occurrence(pattern, features)
    return Step(
        pattern=pattern.id,
        kind=pattern.kind,
        count=len(spans),
        seconds=float((spans.stops - spans.starts).sum() / spans.rate),
        typical=typical,
        start=int(spans.starts[typical]),
        stop=int(spans.stops[typical]),
        variations=tuple(
            _variation(pattern, typical, k, features) for k in range(len(spans)) if k != typical
        ),
    )


def _variation(pattern: Pattern, typical: int, k: int, features: FeatureSequence) -> Variation:
    spans = pattern.occurrences
    elsewhere = align_elsewhere(pattern, typical, k, features)
    laid = elsewhere or align_occurrences(pattern, typical, k, features)
    lengths = spans.stops[[typical, k]] - spans.starts[[typical, k]]
    start = int(spans.starts[k])
    if elsewhere is not None:
        lengths[1] = laid.path[-1, 1] - laid.path[0, 1] + max(1, round(spans.rate / WORKING_RATE))
    phases = (laid.path - laid.path[0]) / np.maximum(laid.path[-1] - laid.path[0], 1)
    inner = (phases[:, 0] >= EDGE) & (phases[:, 0] <= 1 - EDGE)
    inner |= ~inner.any()
    lags = np.where(inner, phases[:, 1] - phases[:, 0], 0.0)
    most = int(np.abs(lags).argmax())
    return Variation(
        occurrence=k,
        start=start,
        stop=int(spans.stops[k]),
        distance=laid.cost,
        tempo=float(lengths[0] / lengths[1]),
        lag_s=float(lags[most] * lengths[0] / spans.rate),
        lag_phase=float(phases[most, 0]),
        differences=_differences(laid.path[inner] / spans.rate, phases[inner, 0], features),
        path=laid.path,
        shift_s=float((laid.path[0, 1] - start) / spans.rate) if elsewhere is not None else 0.0,
    )


def _differences(
    moments: np.ndarray, phases: np.ndarray, features: FeatureSequence
) -> tuple[Difference, ...]:
    """The joints that go farthest from where they are in the typical occurrence, each at its farthest."""
    typical, this = (
        at_moments(features, moments[:, n]).values.reshape(len(moments), -1, features.width) for n in (0, 1)
    )
    offsets = this - typical
    distances = np.linalg.norm(offsets, axis=2)
    known = np.where(np.isfinite(distances), distances, -1.0)
    when = known.argmax(axis=0)
    farthest = known.max(axis=0)
    order = [int(r) for r in np.argsort(-farthest, kind="stable")[:NAMED] if farthest[r] >= 0]
    return tuple(
        Difference(features.names[r], float(farthest[r]), float(phases[when[r]]), offsets[when[r], r])
        for r in order
    )
