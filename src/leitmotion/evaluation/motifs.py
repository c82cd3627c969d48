"""Are the motifs of symmetry right: every one that is asked for is told, and none that is not there.

Conventions
-----------
Frames are half-open. Only what is told with a confidence of one half or more counts.

A motif is *false* when it is told of a stretch that does not carry it
(:func:`leitmotion.evaluation.motif_truth.carries`); what follows from another by definition is carried, though nobody
asked for it.

A motif is *found* when one of its name is told with the same cyclic flag of a stretch that overlaps it by half
(intersection over union), or that covers half of it and lies by half within what it may reach, the halts at its ends
among that; of one that may reach farther than its halts, the flag is not compared. Symmetric paths and pairs may be
told in parts, half of which must be covered. Stillness is found when half of it is covered: its borders are soft. What
is said by another motif (:data:`IMPLIED_BY`) need not be told besides.

References
----------
Paper S, sections 3.2 to 3.6.1.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from leitmotion.evaluation.motif_truth import MOTIF_KINDS, Course, GoneStep, MotifSpan, Stretch, carries
from leitmotion.motion.errors import ParameterError

OVERLAP = 0.5
CONFIDENT = 0.5
IMPLIED_BY = {
    "symmetric_path": ("symmetric_cycle", "symmetric_palindrome"),
    "symmetric_cycle": ("state_repetition",),
    "asymmetric_cycle": ("state_repetition",),
    "path_repetition": ("symmetric_cycle", "asymmetric_cycle"),
}
"""Motifs that say what another asks for: a symmetric cycle is a symmetric path; a loop that is gone once is told by the
return to its state as well; a cycle that goes on repeats its path."""


class MotifScores(NamedTuple):
    """How the motifs of one recording compare with its truth."""

    missed: tuple[MotifSpan, ...]
    """Asked for and not told."""
    false: tuple[MotifSpan, ...]
    """Told of stretches that do not carry them."""
    asked: int
    told: int
    """With confidence."""

    @property
    def right(self) -> bool:
        """Whether nothing is missed and nothing false."""
        return not self.missed and not self.false


def evaluate_motifs(
    told: Sequence[MotifSpan], asked: Sequence[MotifSpan], steps: Sequence[GoneStep]
) -> MotifScores:
    """Compare the motifs that are told of a recording with its truth.

    Parameters
    ----------
    told : sequence of MotifSpan
        The answer; those of little confidence (below one half) are neither found nor false.
    asked : sequence of MotifSpan
        What must be told.
    steps : sequence of GoneStep
        What was done, in order of time, one step at least.

    Returns
    -------
    MotifScores
        What is missed and what is false.

    Raises
    ------
    ParameterError
        When a motif has an unknown name, a stretch is empty, or there are no steps.

    Examples
    --------
    >>> from leitmotion.evaluation import GoneStep, MotifSpan, evaluate_motifs
    >>> steps = [GoneStep("aa", k, k + 30, False, False, False, "A", "A") for k in (0, 30, 60)]
    >>> asked = [MotifSpan("asymmetric_cycle", 0, 90, cyclic=True)]
    >>> evaluate_motifs([MotifSpan("asymmetric_cycle", 4, 88, cyclic=True)], asked, steps).right
    True
    >>> evaluate_motifs([MotifSpan("anti_phase", 4, 88, cyclic=True)], asked, steps).right
    False
    """
    if not steps:
        raise ParameterError("steps must hold one step at least, got none.")
    for span in (*told, *asked):
        _check(span)
    sure = [span for span in told if span.confidence >= CONFIDENT]
    course = Course.of(steps)
    false = tuple(span for span in sure if not carries(course, span))
    true = [span for span in sure if span not in false]
    missed = tuple(span for span in asked if not _found(course, span, true))
    return MotifScores(missed, false, len(asked), len(sure))


def _check(span: MotifSpan) -> None:
    if span.motif not in MOTIF_KINDS:
        raise ParameterError(f"A motif must be one of {', '.join(MOTIF_KINDS)}, got {span.motif!r}.")
    for start, stop in ((span.start, span.stop), span.partner or (span.start, span.stop)):
        if not 0 <= start < stop:
            raise ParameterError(
                f"A stretch begins at 0 or later and ends after it began, got {start}, {stop}."
            )


def _found(course: Course, asked: MotifSpan, told: Sequence[MotifSpan]) -> bool:
    named = [span for span in told if span.motif == asked.motif]
    implying = [span for span in told if span.motif in IMPLIED_BY.get(asked.motif, ())]
    if asked.partner is not None:
        return _found_pair(asked, asked.partner, named) or any(
            _goes_on(asked, asked.partner, span) for span in implying
        )
    if not asked.cyclic:
        named += [_whole(span) for span in implying]
    if asked.motif == "symmetric_path":
        return _found_in_parts(asked, named)
    return any(_hits(course, asked, span) for span in named)


def _whole(span: MotifSpan) -> MotifSpan:
    """Take a pair as one stretch, from the beginning of its first to the end of its second."""
    if span.partner is None:
        return span
    first, last = min(span.start, span.partner[0]), max(span.stop, span.partner[1])
    return span._replace(start=first, stop=last, partner=None)


def _hits(course: Course, asked: MotifSpan, span: MotifSpan) -> bool:
    core, other = (asked.start, asked.stop), (span.start, span.stop)
    shared = _shared(core, other)
    if asked.motif == "stillness":
        return shared >= OVERLAP * _length(core)
    either = _length(core) + _length(other) - shared
    inside = _shared(course.soft(asked.widest or core), other) >= OVERLAP * _length(other)
    overlaps = shared >= OVERLAP * either or (shared >= OVERLAP * _length(core) and inside)
    longer = asked.widest not in (None, core) and not asked.cyclic
    return overlaps and (span.cyclic == asked.cyclic or longer)


def _found_in_parts(asked: MotifSpan, named: Sequence[MotifSpan]) -> bool:
    core = (asked.start, asked.stop)
    parts = [(span.start, span.stop) for span in named]
    inside = [part for part in parts if _shared(core, part) >= OVERLAP * _length(part)]
    return _covered(core, inside) >= OVERLAP * _length(core)


def _found_pair(asked: MotifSpan, partner: Stretch, named: Sequence[MotifSpan]) -> bool:
    core = (asked.start, asked.stop)
    ways = [((span.start, span.stop), span.partner or core) for span in named]
    pairs = [(a, b) for way in ways for a, b in (way, way[::-1]) if _shared(core, a) and _shared(partner, b)]
    return all(
        _covered(whole, [pair[k] for pair in pairs]) >= OVERLAP * _length(whole)
        for k, whole in enumerate((core, partner))
    )


def _goes_on(asked: MotifSpan, partner: Stretch, span: MotifSpan) -> bool:
    """Whether a cycle that goes on covers both stretches of a pair."""
    told = (span.start, span.stop)
    both = ((asked.start, asked.stop), partner)
    return span.cyclic and all(_shared(told, each) >= OVERLAP * _length(each) for each in both)


def _length(stretch: Stretch) -> int:
    return stretch[1] - stretch[0]


def _shared(a: Stretch, b: Stretch) -> int:
    return max(0, min(a[1], b[1]) - max(a[0], b[0]))


def _covered(whole: Stretch, parts: Sequence[Stretch]) -> int:
    """How many frames of a stretch lie in any of the parts."""
    covered, reached = 0, whole[0]
    for start, stop in sorted(parts):
        first, last = max(start, reached), min(stop, whole[1])
        if last > first:
            covered += last - first
            reached = last
    return covered
