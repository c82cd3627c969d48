"""The answer of the Symmetry view: what was found of how the sides move together, and of nothing else.

Conventions
-----------
A motif *alternates* the sides, moves both *together* or *favours* one. Only what is more likely right than wrong is
said. A pattern is told by its letter; a stretch that no pattern holds is counted, under the first kind that fits it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from leitmotion.body import Body
from leitmotion.discovery import Symmetry, SymmetrySpan
from leitmotion.view.counting import count_word
from leitmotion.view.words import Chip, Lead, joined, listed

ALTERNATE = ("anti_phase", "anti_palindrome")
TOGETHER = ("symmetric_palindrome", "symmetric_cycle", "symmetric_path")
FAVOUR = ("asymmetric_palindrome", "asymmetric_cycle")
KINDS = {"alternate": ALTERNATE, "together": TOGETHER, "favour": FAVOUR}
VERBS = {
    # one pattern, several, and stretches that no pattern holds, one and several
    "alternate": (
        " returns as its own mirror image. ",
        " return as their own mirror image. ",
        ("alternates sides", "alternate sides"),
    ),
    "together": (
        " moves both sides together. ",
        " move both sides together. ",
        ("moves both sides together", "move both sides together"),
    ),
    "favour": (" favours one side. ", " favour one side. ", ("favours one side", "favour one side")),
}
TRUNK = ("pelvis", "neck", "left_hip", "right_hip", "left_shoulder", "right_shoulder")
SURE = 0.5  # confidence from which a stretch is more likely right than wrong
LOOKED_FOR = (
    "Stretches that are their own mirror image at once, half a cycle later or backwards, and ways and postures that "
    "come again, as they were or with the sides exchanged."
)
NOT_COMPUTED = "The symmetry of this recording was not computed."
MOSTLY = 0.5  # of a recording, that a kind has to fill to be told without its stretches


class Claim(NamedTuple):
    """What is said of one kind."""

    letters: list[str]
    """Of the patterns that are of it most of all."""

    loose: int
    """Stretches that none of these holds."""

    stretches: int
    """All of them."""

    frames: int
    """How long they are together."""


def symmetry_title(found: Symmetry, letters: Sequence[str]) -> str:
    """Say what was found, as the heading of the view.

    Parameters
    ----------
    found : Symmetry
        What was found.
    letters : sequence of str
        For each span that of the pattern which it lies in; empty where none holds it.

    Returns
    -------
    str
        For example ``"Two ways of moving alternate sides"``.

    Examples
    --------
    >>> walk = SymmetrySpan("anti_phase", 0, 90, 0.9, cyclic=True, marks=[0, 30, 60, 90])
    >>> symmetry_title(Symmetry((walk,), 30.0, 90, {}), ["A"])
    'One way of moving alternates sides'
    """
    claims = _claims(found.spans, letters)
    kind = max(claims, key=lambda kind: claims[kind].frames)
    claim = claims[kind]
    if claim.frames and kind == "alternate":
        return _alternating(claim)
    if claim.frames and kind == "together":
        return f"Both sides move together{'' if claim.frames > MOSTLY * found.frames else _where(claim)}"
    if _mirrored_again(found.spans):
        return "Movements come back mirrored"
    if claim.frames:
        return "No side mirrors the other" if _alone(claims, kind) else f"One side is favoured{_where(claim)}"
    return "No symmetry is clear here" if _moving(found.spans) else "No symmetry shows here"


def symmetry_lead(found: Symmetry, letters: Sequence[str]) -> Lead:
    """Say in one line which pattern treats the sides how; of what no pattern of its kind tells, in how many stretches.

    Parameters
    ----------
    found : Symmetry
        What was found.
    letters : sequence of str
        For each span that of the pattern which it lies in; empty where none holds it.

    Returns
    -------
    tuple of str and Chip
        The pieces of the line, in order.
    """
    claims = _claims(found.spans, letters)
    pieces: list[str | Chip] = []
    for kind, (one, several, elsewhere) in VERBS.items():
        claim = claims[kind]
        if claim.letters:
            pieces += [*listed(claim.letters), one if len(claim.letters) == 1 else several]
        elif claim.loose:
            what = "stretch" if claim.loose == 1 else "stretches"
            pieces.append(f"{count_word(claim.loose).capitalize()} {what} {elsewhere[claim.loose > 1]}. ")
    again = _mirrored_again(found.spans)
    if again and not claims["alternate"].frames:
        come = "One stretch comes" if again == 1 else f"{count_word(again).capitalize()} stretches come"
        pieces.append(f"{come} again with the sides exchanged.")
    if pieces:
        return tuple(joined(pieces))
    if _moving(found.spans):
        return (
            "No stretch tells clearly how the two sides move together: none is more likely right than wrong.",
        )
    return ("No stretch was clear enough to say how the two sides move together.",)


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
        f"No motif of symmetry was found.{far} You can still lay the mirror image under the figure, and compare any "
        "moment with the mirror image of any other."
    )


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


def _claims(spans: Sequence[SymmetrySpan], letters: Sequence[str]) -> dict[str, Claim]:
    """Sort what is sure by kinds; a pattern is of the kind that has the most of it, weighed by confidence."""
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
    chief = {letter: max(KINDS, key=of.__getitem__) for letter, of in weights.items()}
    claims: dict[str, Claim] = {}
    before: list[SymmetrySpan] = []
    for kind in KINDS:
        lettered = {letter for _, letter in sure[kind] if letter and kind == chief[letter]}
        own = [span for span, letter in sure[kind] if letter in lettered]
        rest = [span for span, letter in sure[kind] if not letter and not _covered(span, before + own)]
        count, frames = _stretches(own + rest)
        claims[kind] = Claim(sorted(lettered), count - _stretches(own)[0], count, frames)
        before += own + rest
    return claims


def _alternating(claim: Claim) -> str:
    if claim.loose:
        return f"The sides alternate{_where(claim) if claim.stretches > 1 else ''}"
    if len(claim.letters) > 1:
        return f"{count_word(len(claim.letters)).capitalize()} ways of moving alternate sides"
    return "One way of moving alternates sides"


def _where(claim: Claim) -> str:
    return f" in {count_word(claim.stretches)} {'stretch' if claim.stretches == 1 else 'stretches'}"


def _alone(claims: dict[str, Claim], kind: str) -> bool:
    return not any(claim.frames for other, claim in claims.items() if other != kind)


def _mirrored_again(spans: Sequence[SymmetrySpan]) -> int:
    """How many stretches surely come again as their mirror image, those that overlap counted once."""
    return _stretches([s for s in spans if s.confidence >= SURE and s.motif == "reflected_path_repetition"])[
        0
    ]


def _moving(spans: Sequence[SymmetrySpan]) -> bool:
    return any(span.motif != "stillness" for span in spans)


def _covered(span: SymmetrySpan, others: Sequence[SymmetrySpan]) -> bool:
    both = [min(span.stop, other.stop) - max(span.start, other.start) for other in others]
    return 2 * max(both, default=0) > span.stop - span.start


def _stretches(spans: Sequence[SymmetrySpan]) -> tuple[int, int]:
    """How many stretches they are and how long together, what overlaps counted once."""
    count, frames, reach = 0, 0, 0
    for start, stop in sorted((span.start, span.stop) for span in spans):
        count += start >= reach
        frames += max(stop - max(start, reach), 0)
        reach = max(reach, stop)
    return count, frames
