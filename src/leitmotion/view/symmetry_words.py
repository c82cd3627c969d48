"""The sentences of the Symmetry view: what a motif is called, what it looks like in the matrix.

Conventions
-----------
A motif's plain name comes first, the thesis's term under it. The *chief* motifs tell how a movement treats the two
sides; the others tell which posture or way comes again. A span that lies in a pattern is called by its letter.
*Asymmetric* means no more than not mirrored; only where one side makes two thirds of the way is it said to be one side.

References
----------
Paper S, sections 3.2 to 3.5.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from leitmotion.discovery import SymmetrySpan
from leitmotion.view.counting import clock, plural


class Motif(NamedTuple):
    """How a motif is told."""

    name: str
    """Plain."""

    term: str
    """The thesis's."""

    field: str
    """What stands between two marks, in the singular."""

    sentence: str
    """Of a span, with ``{it}`` for what moves, ``{when}`` for when its partner begins."""

    picture: str
    """How it looks in the matrix."""


CHIEF = {
    "anti_phase": Motif(
        "Alternates sides", "anti-phase", "half-cycle",
        "{it} alternates: half a cycle later the body is its own mirror image.",
        "cyan stripes run midway between the red ones",
    ),
    "anti_palindrome": Motif(
        "From side to side", "anti-palindrome", "way",
        "{it} goes over to the other side: what follows is the mirror image of what was, backwards.",
        "cyan lines cross the diagonal",
    ),
    "symmetric_palindrome": Motif(
        "Both, out and back", "symmetric palindrome", "way",
        "{it} moves both sides together, and comes back the way it went.",
        "white lines cross the diagonal",
    ),
    "symmetric_cycle": Motif(
        "Both sides, repeating", "symmetric cycle", "cycle",
        "{it} moves both sides together, again and again.",
        "red and cyan stripes lie on one another and make white",
    ),
    "symmetric_path": Motif(
        "Both sides together", "symmetric path", "way",
        "{it} moves both sides together.",
        "the diagonal is white",
    ),
    "asymmetric_palindrome": Motif(
        "Out and back, not mirrored", "asymmetric palindrome", "way",
        "{it} comes back the way it went, and is not its own mirror image.",
        "red lines cross the diagonal, with no cyan on them",
    ),
    "asymmetric_cycle": Motif(
        "Comes round, not mirrored", "asymmetric cycle", "cycle",
        "{it} comes round, and is not its own mirror image.",
        "red stripes run alone, with no cyan between them",
    ),
}  # fmt: skip
"""Motifs that tell how the sides move together, in the order of their lanes."""

ONE_SIDED = {
    "asymmetric_palindrome": "One side, out and back",
    "asymmetric_cycle": "One side, repeating",
}
"""What a motif is called where one side moves more."""

OTHERS = {
    "reflected_path_repetition": Motif(
        "Again, mirrored", "reflected path repetition", "",
        "This comes again at {when} with the sides exchanged.",
        "a cyan stripe lies away from the diagonal",
    ),
    "path_reversal": Motif(
        "Again, backwards", "path reversal", "",
        "This comes again at {when}, backwards.",
        "a red line runs across, from lower left to upper right",
    ),
    "path_repetition": Motif(
        "Again, the same way", "path repetition", "",
        "This comes again at {when}.",
        "a red stripe lies away from the diagonal",
    ),
    "reflected_state_repetition": Motif(
        "Mirrored posture again", "reflected state repetition", "",
        "This posture comes again at {when}, as its mirror image.",
        "a cyan spot lies away from the diagonal",
    ),
    "state_repetition": Motif(
        "The same posture again", "state repetition", "",
        "This posture comes again at {when}.",
        "a red spot lies away from the diagonal",
    ),
    "stillness": Motif(
        "Keeps still", "stillness", "",
        "The body keeps still.",
        "a block lies on the diagonal",
    ),
}  # fmt: skip
"""The rest, in the order of their lanes."""

TOLD = CHIEF | OTHERS
ITS_IMAGE = "its mirror image"
FITS = {
    "anti_phase": "its mirror image, half a cycle later",
    "anti_palindrome": "its mirror image, backwards",
    "asymmetric_cycle": "itself, a cycle later",
    "asymmetric_palindrome": "itself, on the other way",
    "reflected_path_repetition": "its mirror image, then",
    "reflected_state_repetition": "its mirror image, then",
    "path_reversal": "itself, then, backwards",
    "path_repetition": "itself, then",
    "state_repetition": "itself, then",
}
"""What is laid under the figure while such a stretch plays."""


def motif_name(span: SymmetrySpan) -> str:
    """Name what a stretch is, plainly.

    Parameters
    ----------
    span : SymmetrySpan
        The stretch.

    Returns
    -------
    str
        That of its motif; of an asymmetric one another where one side moves more.

    Examples
    --------
    >>> motif_name(SymmetrySpan("asymmetric_cycle", 0, 90, 0.9, left_share=0.1))
    'One side, repeating'
    """
    one_sided = span.side in ("left", "right")
    return ONE_SIDED.get(span.motif, TOLD[span.motif].name) if one_sided else TOLD[span.motif].name


def limb_words(links: Iterable[str]) -> str:
    """Name the limbs that links belong to.

    Parameters
    ----------
    links : iterable of str
        Of one side or both.

    Returns
    -------
    str
        "arm", "leg", "arm and leg", or empty.
    """
    limbs = {"arm" if link.endswith(("humerus", "radius")) else "leg" for link in links}
    return " and ".join(sorted(limbs))


def side_words(span: SymmetrySpan) -> str:
    """Say which side moves more in a stretch, how much of the way it makes, and which limbs differ most.

    Parameters
    ----------
    span : SymmetrySpan
        The stretch.

    Returns
    -------
    str
        Empty where no side moves more, or that is not known.

    Examples
    --------
    >>> side_words(SymmetrySpan("asymmetric_cycle", 0, 90, 0.9, left_share=0.15, links=("right_humerus",)))
    'the right side moves more (85% of the way): arm'
    """
    if span.left_share is None or span.side == "both":
        return ""
    share = span.left_share if span.side == "left" else 1 - span.left_share
    limbs = limb_words(span.links)
    return f"the {span.side} side moves more ({share:.0%} of the way){': ' * bool(limbs)}{limbs}"


def span_sentence(span: SymmetrySpan, rate: float) -> tuple[str, str]:
    """Say what a stretch is, and how that looks in the matrix.

    Parameters
    ----------
    span : SymmetrySpan
        The stretch.
    rate : float
        Frames per second of it.

    Returns
    -------
    str
        The sentence, with ``{it}`` where the pattern's name stands; empty of that where it has none.
    str
        "In the matrix, …".
    """
    told = TOLD[span.motif]
    when = clock(span.partner[0] / rate) if span.partner else ""
    sentence = told.sentence.replace("{when}", when)
    if span.motif in ONE_SIDED and (sides := side_words(span)):
        sentence = f"{sentence[:-1]}: {sides}."
    return sentence, f"In the matrix, {told.picture}."


def lane_words(motif: str, spans: Sequence[SymmetrySpan]) -> tuple[str, str]:
    """Name a lane: the plain name, and the thesis's term.

    Parameters
    ----------
    motif : str
        Of the lane.
    spans : sequence of SymmetrySpan
        What it shows.

    Returns
    -------
    tuple of str
        For example ``("Alternates sides", "anti-phase cycle")``.
    """
    told = TOLD[motif]
    names = {motif_name(span) for span in spans}
    goes_on = all(span.cyclic for span in spans) and not told.term.endswith("cycle") and motif in CHIEF
    return (
        names.pop() if len(names) == 1 else told.name,
        f"{told.term} cycle" if goes_on and motif == "anti_phase" else f"{told.term}{', cyclic' * goes_on}",
    )


def span_tip(span: SymmetrySpan, rate: float, letter: str = "") -> str:
    """Say all there is about a stretch, in the line that stands beside its bar.

    Parameters
    ----------
    span : SymmetrySpan
        The stretch.
    rate : float
        Frames per second of it.
    letter : str
        Of the pattern that it lies in.

    Returns
    -------
    str
        For example ``"A, alternates sides · 0:33.9 to 0:38.1 · 4 half-cycles of 0.62 s · confidence 0.82: …"``.
    """
    told, name = TOLD[span.motif], motif_name(span)
    parts = [f"{letter}, {name[0].lower()}{name[1:]}" if letter else name]
    parts.append(f"{clock(span.start / rate)} to {clock(span.stop / rate)}")
    if span.partner:
        parts.append(f"and {clock(span.partner[0] / rate)} to {clock(span.partner[1] / rate)}")
    count = len(span.marks) - 1
    if told.field and count > 0:
        parts.append(
            f"{plural(count, told.field)} of {float(span.marks[-1] - span.marks[0]) / count / rate:.2f} s"
        )
    if sides := side_words(span):
        parts.append(sides)
    reason = f": {span.reason.rstrip('.')}" if span.reason else ""
    return " · ".join([*parts, f"confidence {span.confidence:.2f}{reason}"])


def span_name(span: SymmetrySpan, rate: float, letter: str, k: int, count: int) -> str:
    """Name a stretch for someone who hears the page.

    Parameters
    ----------
    span : SymmetrySpan
        The stretch.
    rate : float
        Frames per second of it.
    letter : str
        Of the pattern that it lies in.
    k, count : int
        Which of its lane's, from 0, and of how many.

    Returns
    -------
    str
        For example ``"Alternates sides, pattern A, 1 of 3, 0.7 to 4.1 seconds"``.
    """
    within = f", pattern {letter}" if letter else ""
    where = f"{span.start / rate:.1f} to {span.stop / rate:.1f} seconds"
    again = (
        f", and {span.partner[0] / rate:.1f} to {span.partner[1] / rate:.1f} seconds" if span.partner else ""
    )
    return f"{motif_name(span)}{within}, {k + 1} of {count}, {where}{again}"


def half_alike(degrees: float) -> str:
    """Say what the strength of the colours means.

    Parameters
    ----------
    degrees : float
        Turn of every link at which two postures are half alike.

    Returns
    -------
    str
        For example ``"half alike at 8° a link"``.

    Examples
    --------
    >>> half_alike(8.45)
    'half alike at 8° a link'
    """
    return f"half alike at {degrees:.0f}° a link"
