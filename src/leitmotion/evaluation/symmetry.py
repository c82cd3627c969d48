"""How good found motifs of symmetry are: stretches that a person labelled, beside what was told of them.

Conventions
-----------
Only motifs of a whole course are judged (:data:`SHOWS`); those of two separate stretches have no labels. A motif is
*told* of a labelled stretch when spans with a confidence of one half or more cover at least half of it, one or several
together, since a cyclic movement may be told cycle by cycle. Its confidence is the mean over the frames so covered,
the greatest where several hold. Its *fit* is how many frames stretch and spans share, over how many either has, as far
as the labeller saw the recording. Several motifs may be told of one stretch. One stands for it:

1. A motif is left out when one that entails it (:data:`ENTAILS`) is told as well, with half its fit at least. Who says
   that a movement is a symmetric palindrome is at least as sure that it is symmetric, so confidence cannot choose.
2. Of the others the one with the greatest product of confidence and fit. Where a person keeps still within a longer
   movement both have labels, and each motif fits one of them.

It *agrees* when it is among the accepted motifs. Labels name the most special motif that was seen, so that what says
more or less is wrong, with one exception: a labelled symmetric path may be one way of a longer symmetric cycle or
palindrome, which then is told over it and half as much again at least. Where no motif was seen none may be told.

References
----------
Paper S, sections 3.2 to 3.5. A cycle of its section 3.5.1 runs one way only, so that cycle and palindrome exclude each
other; so do, by degree, anti-phase and anti-palindrome. Between them confidence and fit decide.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.motion.errors import ParameterError
from leitmotion.motion.noun import Noun, noun
from leitmotion.motion.segmentation import Segmentation

SHOWS = {
    "stillness": ("", "still"),
    "symmetric_path": ("together", "one_way"),
    "symmetric_cycle": ("together", "cycle"),
    "asymmetric_cycle": ("one", "cycle"),
    "symmetric_palindrome": ("together", "out_and_back"),
    "asymmetric_palindrome": ("one", "out_and_back"),
    "anti_phase": ("alternate", "cycle"),
    "anti_palindrome": ("alternate", "out_and_back"),
}
"""What the sides do and which course the body takes, by motif; stillness does not tell the sides."""
ENTAILS = {
    "symmetric_cycle": "symmetric_path",  # all its states are symmetric (3.4.3)
    "symmetric_palindrome": "symmetric_path",  # likewise (3.4.5)
    "anti_phase": "asymmetric_cycle",  # it returns, through no symmetric state (3.4.7); a limp does no more (3.5.5)
    "anti_palindrome": "asymmetric_palindrome",  # it turns back on either side (3.5.3); one raised hand does no more
}
"""Which weaker motif holds wherever a motif does that is told of the same stretch."""
SIDES = ("together", "alternate", "one")
COURSES = ("still", "one_way", "out_and_back", "cycle")
NONE = "none"
SURE = 0.5
"""Confidence from which on a span is told."""
COVERS = 0.5
"""Share of a stretch that is covered when a motif is told of it."""
SAME = 0.5
"""Fit from which on a span is about a stretch, and share of a fit that still counts as the same extent."""
ONE_WAY = 2 / 3
"""Fit up to which a stretch may be one way of a longer movement."""
_EPSILON = 1e-9


@noun
class SymmetryLabel(Noun):
    """A stretch whose symmetry a person labelled.

    Parameters
    ----------
    start, stop : int
        Frames ``[start, stop)``.
    sides : {"together", "alternate", "one"}
        What the sides do: the same at once, the same in turn and mirrored, or neither.
    course : {"still", "one_way", "out_and_back", "cycle"}
        Which course the body takes.
    motifs : tuple of str
        The accepted motifs, of :data:`SHOWS`; empty where the stretch shows none of them.
    sure : bool
        Whether another answer would surprise the labeller.

    Raises
    ------
    ParameterError
        When the stretch is empty, or a word is unknown.
    """

    start: int
    stop: int
    sides: str
    course: str
    motifs: tuple[str, ...] = ()
    sure: bool = True

    def __post_init__(self) -> None:
        object.__setattr__(self, "motifs", tuple(self.motifs))
        if not 0 <= self.start < self.stop:
            raise ParameterError(
                f"A label begins at 0 or later and ends after, got {self.start}, {self.stop}."
            )
        for field, word, known in (
            ("sides", self.sides, SIDES),
            ("course", self.course, COURSES),
            *(("motifs", motif, tuple(SHOWS)) for motif in self.motifs),
        ):
            if word not in known:
                raise ParameterError(f"SymmetryLabel.{field} must be of {', '.join(known)}, got {word!r}.")


@noun
class SymmetryVerdict(Noun):
    """What was told of a labelled stretch.

    Parameters
    ----------
    label : SymmetryLabel
        The stretch.
    told : str
        The motif that stands for it; "none" where none is told.
    confidence, fit : float
        Of that motif; 0 where none is told.
    all_told : tuple of str
        Every motif that is told of the stretch.
    """

    label: SymmetryLabel
    told: str = NONE
    confidence: float = 0.0
    fit: float = 0.0
    all_told: tuple[str, ...] = ()

    @property
    def agrees(self) -> bool:
        """Whether what is told is among the accepted motifs, or nothing is told where there is nothing."""
        if not self.label.motifs or self.told == NONE:
            return not self.label.motifs and self.told == NONE
        one_way = (
            ENTAILS.get(self.told) == "symmetric_path"
            and "symmetric_path" in self.label.motifs
            and self.fit <= ONE_WAY + _EPSILON
        )
        return self.told in self.label.motifs or one_way

    @property
    def sides(self) -> str:
        """What the sides do by what is told; a still body is symmetric when a symmetric motif is told beside."""
        if self.told != "stillness":
            return SHOWS.get(self.told, ("", ""))[0]
        return "together" if any(SHOWS[motif][0] == "together" for motif in self.all_told) else "one"

    @property
    def course(self) -> str:
        """Which course the body takes by what is told."""
        return SHOWS.get(self.told, ("", ""))[1]

    @property
    def sides_agree(self) -> bool:
        """Whether the sides agree with the label or an accepted motif; only asked where there is one."""
        return self.agrees or self.sides in {
            self.label.sides,
            *(SHOWS[motif][0] for motif in self.label.motifs if motif != "stillness"),
        }

    @property
    def course_agrees(self) -> bool:
        """Whether the course agrees with the label or an accepted motif; only asked where there is one."""
        return self.agrees or self.course in {
            self.label.course,
            *(SHOWS[motif][1] for motif in self.label.motifs),
        }


@noun
class SymmetryScores(Noun):
    """How good the motifs told of one recording, or of a clip of it, are.

    Parameters
    ----------
    verdicts : tuple of SymmetryVerdict
        One a labelled stretch.
    spans, wrong_spans : int
        Told spans that are about a labelled stretch, their fit to it being one half or more; and those of them whose
        motif neither is accepted there nor is entailed by an accepted one.
    seconds, unlabelled_s, told_unlabelled_s : float
        How much the labeller saw; how much of it has no label and is not checked; and of how much of that something
        is told.
    """

    verdicts: tuple[SymmetryVerdict, ...]
    spans: int
    wrong_spans: int
    seconds: float
    unlabelled_s: float
    told_unlabelled_s: float


def evaluate_symmetry(
    labels: Sequence[SymmetryLabel], told: Segmentation, *, window: tuple[int, int] | None = None
) -> SymmetryScores:
    """Judge the motifs told of one recording by what a person saw.

    Parameters
    ----------
    labels : sequence of SymmetryLabel
        The stretches, which may overlap.
    told : Segmentation
        Spans, each with its motif and its confidence. Motifs that are not of a whole course are left aside.
    window : (int, int), optional
        What the labeller saw of the recording, frames ``[start, stop)``; by default from the first label to the last.

    Returns
    -------
    SymmetryScores
        All figures.

    Raises
    ------
    ParameterError
        When there are no labels, one lies outside of the window, or a span has no confidence.

    Examples
    --------
    >>> from leitmotion.motion import Segmentation
    >>> walk = SymmetryLabel(0, 200, "alternate", "cycle", ("anti_phase",))
    >>> told = Segmentation([0, 0], [210, 190], ("asymmetric_cycle", "anti_phase"), [0.9, 0.8], rate=30)
    >>> scores = evaluate_symmetry([walk], told, window=(0, 300))
    >>> scores.verdicts[0].told, scores.verdicts[0].agrees, round(scores.told_unlabelled_s, 2)
    ('anti_phase', True, 0.33)
    """
    if not labels:
        raise ParameterError("There is nothing to judge without a label.")
    first, last = window or (min(one.start for one in labels), max(one.stop for one in labels))
    outside = [one for one in labels if not first <= one.start < one.stop <= last]
    if outside:
        raise ParameterError(
            f"Labels must lie within [{first}, {last}), got [{outside[0].start}, {outside[0].stop})."
        )
    if not np.isfinite(told.scores).all():
        raise ParameterError("Each told span needs its confidence as its score.")
    spans = [
        (max(start, first), min(stop, last), motif, confidence)
        for start, stop, motif, confidence in told
        if motif in SHOWS and confidence >= SURE and start < last and stop > first
    ]
    rights = [right for span in spans if (right := _right(labels, *span[:3])) is not None]
    labelled, said = np.zeros((2, last - first), dtype=bool)
    for one in labels:
        labelled[one.start - first : one.stop - first] = True
    for start, stop, *_ in spans:
        said[start - first : stop - first] = True
    return SymmetryScores(
        verdicts=tuple(_verdict(one, spans) for one in labels),
        spans=len(rights),
        wrong_spans=rights.count(False),
        seconds=(last - first) / told.rate,
        unlabelled_s=float((~labelled).sum() / told.rate),
        told_unlabelled_s=float((said & ~labelled).sum() / told.rate),
    )


def _verdict(label: SymmetryLabel, spans: Sequence[tuple[int, int, str, float]]) -> SymmetryVerdict:
    """Choose the motif that stands for a stretch."""
    told = {}
    for motif in SHOWS:
        own = [span for span in spans if span[2] == motif and span[0] < label.stop and span[1] > label.start]
        if not own:
            continue
        first = min(label.start, *(span[0] for span in own))
        sure = np.zeros(max(label.stop, *(span[1] for span in own)) - first)
        for start, stop, _, confidence in own:
            sure[start - first : stop - first] = np.maximum(sure[start - first : stop - first], confidence)
        inside = sure[label.start - first : label.stop - first]
        covered = int(np.count_nonzero(inside))
        if covered >= COVERS * inside.size - _EPSILON:
            either = np.count_nonzero(sure) + inside.size - covered
            told[motif] = float(inside.sum() / covered), float(covered / either)
    entailed = {
        weaker
        for motif, weaker in ENTAILS.items()
        if motif in told and weaker in told and told[motif][1] >= SAME * told[weaker][1] - _EPSILON
    }
    special = [motif for motif in told if motif not in entailed]
    if not special:
        return SymmetryVerdict(label)
    best = max(special, key=lambda motif: np.prod(told[motif]))
    return SymmetryVerdict(label, best, *told[best], all_told=tuple(told))


def _right(labels: Sequence[SymmetryLabel], start: int, stop: int, motif: str) -> bool | None:
    """Say whether a span is right about a stretch; None where it is about none."""
    about = [
        one
        for one in labels
        if min(stop, one.stop) - max(start, one.start)
        >= SAME * (max(stop, one.stop) - min(start, one.start)) - _EPSILON
    ]
    if not about:
        return None
    return any(motif in {*one.motifs, *map(ENTAILS.get, one.motifs)} for one in about)
