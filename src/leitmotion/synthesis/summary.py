"""A summary: what recurs in a recording, each movement once, one after the other.

References
----------
Tang, Leung, Komura, Shum, *Finding repetitive patterns in 3D human motion captured data* (2008): its
conclusion names summaries of a recording as a use of what recurs in it.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from leitmotion.body import BodyMap
from leitmotion.discovery import Pattern, Patterns, align_occurrences, typical_occurrence
from leitmotion.features import FeatureSequence
from leitmotion.motion import DataError, Motion, ParameterError, Segmentation, Trajectories
from leitmotion.motion.noun import Noun, noun
from leitmotion.synthesis.blending import apart, join
from leitmotion.synthesis.footing import legs_of

SEAM_S = 0.3
"""Seconds of the shortest seam; also of what is compared to tell how long one must be."""
LONGEST_SEAM_S = 0.9
TOUCHING = 0.2  # of a cycle: two cycles with less between them follow one another


@noun
class Summary(Noun):
    """What recurs in a recording, each movement once.

    Parameters
    ----------
    recording : Motion or Trajectories
        The movements one after another, blended into each other.
    contents : Segmentation
        Where each stands in `recording`, in order; the label is the id of its pattern.
    sources : Segmentation
        Where each was taken from, in frames of the recording that is summarised; as many, labelled alike.
    """

    recording: Motion | Trajectories
    contents: Segmentation
    sources: Segmentation

    def __post_init__(self) -> None:
        if self.contents.labels != self.sources.labels:
            raise ParameterError("Summary.contents and Summary.sources must tell of the same patterns.")


class _Piece(NamedTuple):
    """What is taken without a break: the patterns shown in it, and each one's span."""

    shown: list[tuple[str, int, int]]

    @property
    def start(self) -> int:
        return min(start for _, start, _ in self.shown)

    @property
    def stop(self) -> int:
        return max(stop for _, _, stop in self.shown)


def summarize(
    recording: Motion | Trajectories,
    patterns: Patterns,
    features: FeatureSequence,
    roles: BodyMap | None = None,
) -> Summary:
    """Show each pattern once, in the order in which they first appear in the recording.

    Of a pattern its typical occurrence is shown (:func:`leitmotion.discovery.typical_occurrence`); of a cyclic one two
    cycles that follow one another where there are, as one alone is hard to see. What goes before and after is taken as
    well, for the length of the seam, so that a seam is made of lead-in and rest and leaves the movement whole; only at
    the ends of the recording, where there is less, does it reach into the movement. A seam lasts 0.3 s, longer where
    the postures are farther apart (0.9 s at most). Movements that follow one another in the recording, too, stay
    together as they were.

    Parameters
    ----------
    recording : Motion or Trajectories
        T frames.
    patterns : Patterns
        What recurs in it.
    features : FeatureSequence
        What of each of its frames is compared to find the typical occurrences.
    roles : BodyMap, optional
        Which joints are hips, knees, ankles and toes: where they are known, feet that stand are held in the seams.

    Returns
    -------
    Summary
        The summary begins where the first movement was, and goes on from there.

    Raises
    ------
    DataError
        When nothing recurs.
    ParameterError
        When the patterns or the features are of another recording.
    """
    if not patterns.patterns:
        raise DataError("Nothing recurs in the recording, so there is nothing to summarise.")
    if len(features) != len(recording):
        raise ParameterError(
            f"The features have {len(features)} frames, but the recording has {len(recording)}.",
            remedy="Give the features of the same recording.",
        )
    first = sorted(patterns.patterns, key=lambda pattern: int(pattern.occurrences.starts[0]))
    chosen = [(pattern.id, *best_span(pattern, features)) for pattern in first]
    shortest = max(1, round(SEAM_S * recording.rate))
    pieces = _kept_together(chosen, near=2 * shortest)
    seams = [_seam(recording, a, b, shortest) for a, b in pairwise(pieces)]
    spans = _with_context(pieces, seams, len(recording), shortest)
    lengths = [stop - start for start, stop in spans]
    fitting = [min(seam, lengths[k] // 2, lengths[k + 1] // 2) for k, seam in enumerate(seams)]
    legs = legs_of(recording, roles) if isinstance(recording, Motion) and roles is not None else ()
    joined = join([recording[start:stop] for start, stop in spans], fitting, legs)
    shown = [
        (label, start + at - span[0], stop + at - span[0], start, stop)
        for piece, span, at in zip(pieces, spans, joined.starts, strict=True)
        for label, start, stop in piece.shown
    ]
    labels = tuple(label for label, *_ in shown)
    starts, stops, from_starts, from_stops = np.array([frames for _, *frames in shown]).T
    return Summary(
        joined.recording.replace(name=f"{recording.name}-summary" if recording.name else "summary"),
        Segmentation(starts, stops, labels, rate=recording.rate),
        Segmentation(from_starts, from_stops, labels, rate=recording.rate),
    )


def best_span(pattern: Pattern, features: FeatureSequence) -> tuple[int, int]:
    """Choose what to show of a pattern: its typical occurrence, with the cycle beside it that fits better.

    Parameters
    ----------
    pattern : Pattern
        What recurs.
    features : FeatureSequence
        What is compared.

    Returns
    -------
    tuple of int
        Frames ``[start, stop)`` of the recording.
    """
    spans = pattern.occurrences
    best = typical_occurrence(pattern, features)
    beside = [k for k in (best + 1, best - 1) if pattern.kind == "cyclic" and _follow(pattern, k, best)]
    shown = [best, *sorted(beside, key=lambda k: align_occurrences(pattern, best, k, features).cost)[:1]]
    return int(spans.starts[min(shown)]), int(spans.stops[max(shown)])


def _follow(pattern: Pattern, k: int, m: int) -> bool:
    """Whether two neighbouring cycles follow one another without a break."""
    spans = pattern.occurrences
    if not 0 <= min(k, m) < max(k, m) < len(spans):
        return False
    gap = int(spans.starts[max(k, m)] - spans.stops[min(k, m)])
    return gap <= TOUCHING * pattern.period_s * spans.rate


def _kept_together(chosen: list[tuple[str, int, int]], *, near: int) -> list[_Piece]:
    pieces: list[_Piece] = []
    for shown in chosen:
        _, start, stop = shown
        last = pieces[-1] if pieces else None
        if last and last.shown[-1][1] <= start <= last.stop + near and stop > last.stop:
            last.shown.append(shown)
        else:
            pieces.append(_Piece([shown]))
    return pieces


def _seam(recording: Motion | Trajectories, a: _Piece, b: _Piece, shortest: int) -> int:
    """How many frames a seam takes: so many that no point crosses more than the body's extent in a second."""
    frames = min(shortest, a.stop - a.start, b.stop - b.start)
    gap = apart(recording[a.stop - frames : a.stop], recording[b.start : b.start + frames])
    return max(1, round(min(max(gap, SEAM_S), LONGEST_SEAM_S) * recording.rate))


def _with_context(
    pieces: list[_Piece], seams: list[int], frames: int, shortest: int
) -> list[tuple[int, int]]:
    before, after = [shortest, *seams], [*seams, shortest]
    return [
        (max(0, piece.start - lead), min(frames, piece.stop + rest))
        for piece, lead, rest in zip(pieces, before, after, strict=True)
    ]
