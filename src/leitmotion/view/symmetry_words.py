"""The sentences of the Symmetry view: what a motif is called, what it looks like in the matrix, what was found.

Conventions
-----------
A motif's plain name comes first, the thesis's term under it. The *chief* motifs tell how a movement treats the two
sides; the others tell which posture or way comes again. A span that lies in a pattern is called by its letter.

References
----------
Paper S, sections 3.2 to 3.5.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from leitmotion.body import Body
from leitmotion.discovery import SymmetrySpan
from leitmotion.view.counting import clock, count_word, plural
from leitmotion.view.words import Chip, Lead, listed


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
        "One side, out and back", "asymmetric palindrome", "way",
        "{it} favours one side, and comes back the way it went.",
        "red lines cross the diagonal, with no cyan on them",
    ),
    "asymmetric_cycle": Motif(
        "One side, repeating", "asymmetric cycle", "cycle",
        "{it} favours one side, again and again.",
        "red stripes run alone, with no cyan between them",
    ),
}  # fmt: skip
"""Motifs that tell how the sides move together, in the order of their lanes."""

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
ALTERNATE = ("anti_phase", "anti_palindrome")
TOGETHER = ("symmetric_palindrome", "symmetric_cycle", "symmetric_path")
FAVOUR = ("asymmetric_palindrome", "asymmetric_cycle")
KINDS = {"alternate": ALTERNATE, "together": TOGETHER, "favour": FAVOUR}
VERBS = {
    # one pattern, several, and stretches that no pattern holds, one and several
    "alternate": (
        " returns as its own mirror image.",
        " return as their own mirror image.",
        ("alternates sides", "alternate sides"),
    ),
    "together": (
        " moves both sides together.",
        " move both sides together.",
        ("moves both sides together", "move both sides together"),
    ),
    "favour": (" favours one side.", " favour one side.", ("favours one side", "favour one side")),
}
TRUNK = ("pelvis", "neck", "left_hip", "right_hip", "left_shoulder", "right_shoulder")
SURE = 0.5  # confidence from which a stretch is more likely right than wrong
LOOKED_FOR = (
    "Stretches that are their own mirror image at once, half a cycle later or backwards, and ways and postures that "
    "come again, as they were or with the sides exchanged."
)
NOT_COMPUTED = "The symmetry of this recording was not computed."


def symmetry_title(spans: Sequence[SymmetrySpan], letters: Sequence[str]) -> str:
    """Say what was found, as the heading of the view.

    Parameters
    ----------
    spans : sequence of SymmetrySpan
        What was found. What is more likely wrong than right says nothing here.
    letters : sequence of str
        Of the pattern that each lies in; empty where none holds it.

    Returns
    -------
    str
        For example ``"Two ways of moving alternate sides"``.

    Examples
    --------
    >>> walk = SymmetrySpan("anti_phase", 0, 90, 0.9, cyclic=True, marks=[0, 30, 60, 90])
    >>> symmetry_title([walk], ["A"])
    'One way of moving alternates sides'
    """
    ways, loose, stretches = _claims(spans, letters)
    if loose["alternate"]:
        return f"The sides alternate{_in_stretches(stretches['alternate'])}"
    if len(ways["alternate"]) > 1:
        return f"{count_word(len(ways['alternate'])).capitalize()} ways of moving alternate sides"
    if ways["alternate"]:
        return "One way of moving alternates sides"
    if stretches["together"]:
        return "Both sides move together"
    if _mirrored_again(spans):
        return "Movements come back mirrored"
    if stretches["favour"]:
        return "No side mirrors the other"
    return "No symmetry is clear here" if _moving(spans) else "No symmetry shows here"


def symmetry_lead(spans: Sequence[SymmetrySpan], letters: Sequence[str]) -> Lead:
    """Say in one line which pattern treats the sides how; of what no pattern of its kind tells, in how many stretches.

    Parameters
    ----------
    spans : sequence of SymmetrySpan
        What was found. What is more likely wrong than right says nothing here.
    letters : sequence of str
        Of the pattern that each lies in; empty where none holds it.

    Returns
    -------
    tuple of str and Chip
        The pieces of the line, in order.
    """
    ways, loose, _ = _claims(spans, letters)
    pieces: list[str | Chip] = []
    for kind, (one, several, elsewhere) in VERBS.items():
        if ways[kind]:
            pieces += (
                ([" "] if pieces else []) + listed(ways[kind]) + [one if len(ways[kind]) == 1 else several]
            )
        elif loose[kind]:
            count = loose[kind]
            told = f"{count_word(count)} {'stretch' if count == 1 else 'stretches'} {elsewhere[count > 1]}."
            pieces.append((" " if pieces else "") + told[0].upper() + told[1:])
    again = _mirrored_again(spans)
    if again and not (ways["alternate"] or loose["alternate"]):
        come = "One stretch comes" if again == 1 else f"{count_word(again).capitalize()} stretches come"
        pieces.append(f"{' ' if pieces else ''}{come} again with the sides exchanged.")
    if pieces:
        return _joined(pieces)
    if _moving(spans):
        return (
            "No stretch tells clearly how the two sides move together: none is more likely right than wrong.",
        )
    return ("No stretch was clear enough to say how the two sides move together.",)


def _claims(
    spans: Sequence[SymmetrySpan], letters: Sequence[str]
) -> tuple[dict[str, list[str]], dict[str, int], dict[str, int]]:
    """Under each kind: the letters of patterns, how many stretches no pattern holds, and how many there are in all.

    A pattern is of the motif that has the most of it, weighed by confidence. A stretch counts once, under the first
    kind that fits it.
    """
    weights: dict[str, dict[str, float]] = {}
    sure: dict[str, list[tuple[SymmetrySpan, str]]] = {kind: [] for kind in KINDS}
    for span, letter in zip(spans, letters, strict=True):
        kind = next((kind for kind, held in KINDS.items() if span.motif in held), None)
        if kind is None:
            continue
        if letter:
            of = weights.setdefault(letter, dict.fromkeys(KINDS, 0.0))
            of[kind] += span.confidence * (span.stop - span.start)
        if span.confidence >= SURE:
            sure[kind].append((span, letter))
    chief = {letter: max(of, key=lambda kind, of=of: of[kind]) for letter, of in weights.items()}  # type: ignore[misc]
    ways: dict[str, list[str]] = {}
    loose: dict[str, int] = {}
    stretches: dict[str, int] = {}
    before: list[SymmetrySpan] = []
    for kind in KINDS:
        lettered = {letter for _, letter in sure[kind] if letter}
        ways[kind] = sorted(letter for letter in lettered if chief[letter] == kind)
        own = [span for span, letter in sure[kind] if letter in ways[kind]]
        rest = [span for span, letter in sure[kind] if not letter and not _covered(span, before + own)]
        stretches[kind] = _stretches(own + rest)
        loose[kind] = stretches[kind] - _stretches(own)
        before += own + rest
    return ways, loose, stretches


def _mirrored_again(spans: Sequence[SymmetrySpan]) -> int:
    """How many stretches surely come again as their mirror image, those that overlap counted once."""
    return _stretches(
        [span for span in spans if span.confidence >= SURE and span.motif == "reflected_path_repetition"]
    )


def _moving(spans: Sequence[SymmetrySpan]) -> bool:
    return any(span.motif != "stillness" for span in spans)


def _covered(span: SymmetrySpan, others: Sequence[SymmetrySpan]) -> bool:
    both = [min(span.stop, other.stop) - max(span.start, other.start) for other in others]
    return 2 * max(both, default=0) > span.stop - span.start


def _in_stretches(count: int) -> str:
    return "" if count == 1 else f" in {count_word(count)} stretches"


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
    return told.sentence.replace("{when}", when), f"In the matrix, {told.picture}."


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
    goes_on = all(span.cyclic for span in spans) and not told.term.endswith("cycle") and motif in CHIEF
    return (
        told.name,
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
    told = TOLD[span.motif]
    parts = [
        (f"{letter}, " if letter else "") + (told.name[0].lower() if letter else told.name[0]) + told.name[1:]
    ]
    parts.append(f"{clock(span.start / rate)} to {clock(span.stop / rate)}")
    if span.partner:
        parts.append(f"and {clock(span.partner[0] / rate)} to {clock(span.partner[1] / rate)}")
    count = len(span.marks) - 1
    if told.field and count > 0:
        parts.append(
            f"{plural(count, told.field)} of {float(span.marks[-1] - span.marks[0]) / count / rate:.2f} s"
        )
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
    return f"{TOLD[span.motif].name}{within}, {k + 1} of {count}, {where}{again}"


def no_symmetry(body: Body, why: str) -> str:
    """Say in a sentence why a recording has no symmetry to show.

    Parameters
    ----------
    body : Body
        The person.
    why : str
        What was missed when it was looked for.

    Returns
    -------
    str
        The sentence.
    """
    if body.positions.shape[2] == 2:
        return "Symmetry needs joints in three dimensions; this recording has two."
    if not set(TRUNK) <= set(body.roles):
        return "Symmetry needs a body whose trunk and sides are known; here they are not."
    return f"The symmetry of this recording cannot be told: {why}"


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


def empty_symmetry(apart: float | None, unit: str) -> str:
    """Say that no motif was found, and what the view shows all the same.

    Parameters
    ----------
    apart : float or None
        How far the body is from its own mirror image half of the time, in the unit told, where that is known.
    unit : str
        That unit.

    Returns
    -------
    str
        A few plain sentences.
    """
    far = (
        f" Half of the time it is more than {apart:.1f} {unit} from its own mirror image."
        if apart is not None
        else ""
    )
    return (
        f"No motif of symmetry was found: no stretch comes back, as it was or mirrored.{far} You can still lay the "
        "mirror image under the figure, and compare any moment with the mirror image of any other."
    )


def _stretches(spans: Sequence[SymmetrySpan]) -> int:
    """How many stretches they are, those that overlap counted once."""
    count, reach = 0, -1
    for start, stop in sorted((span.start, span.stop) for span in spans):
        count += start >= reach
        reach = max(reach, stop)
    return count


def _joined(pieces: Sequence[str | Chip]) -> Lead:
    joined: list[str | Chip] = []
    for piece in pieces:
        if joined and isinstance(piece, str) and isinstance(joined[-1], str):
            joined[-1] += piece
        else:
            joined.append(piece)
    return tuple(joined)
