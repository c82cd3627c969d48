"""The answer of the Symmetry view: what was found of how the sides move together, and of nothing else.

Conventions
-----------
A stretch *alternates* the sides, moves both *together*, moves *one* side more, or comes back *unmirrored*. Only what is
more likely right than wrong is said. Stretches are counted, each under the first kind that fits it, whether a pattern
holds it or not: a page and a terminal say the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from leitmotion.body import Body
from leitmotion.discovery import Symmetry, SymmetrySpan
from leitmotion.view.counting import clock, count_word
from leitmotion.view.symmetry_words import limb_words, motif_name

ALTERNATE = ("anti_phase", "anti_palindrome")
TOGETHER = ("symmetric_palindrome", "symmetric_cycle", "symmetric_path")
UNMIRRORED = ("asymmetric_palindrome", "asymmetric_cycle")
VERBS = {
    # of one stretch, of several
    "alternate": ("alternates sides", "alternate sides"),
    "together": ("moves both sides together", "move both sides together"),
    "left": ("moves the left side more", "move the left side more"),
    "right": ("moves the right side more", "move the right side more"),
    "unmirrored": ("comes back, but not mirrored", "come back, but not mirrored"),
}
"""What is said of the kinds, in the order in which they are told."""
TRUNK = ("pelvis", "neck", "left_hip", "right_hip", "left_shoulder", "right_shoulder")
SURE = 0.5  # confidence from which a stretch is more likely right than wrong
LOOKED_FOR = (
    "Stretches that are their own mirror image at once, half a cycle later or backwards, and ways and postures that "
    "come again, as they were or with the sides exchanged."
)
NOTHING_MIRRORED = "Nothing comes back mirrored clearly enough"
NOT_COMPUTED = "The symmetry of this recording was not computed."
MOSTLY = 0.5  # of a recording, that a kind has to fill to be told without its stretches
ALL = 0.9  # of a recording, that stillness has to fill to be all of it


class Claim(NamedTuple):
    """What is said of one kind."""

    stretches: int
    """How many there are."""

    frames: int
    """How long they are together."""

    limbs: str
    """Which limbs differ most, where one side moves more."""


def symmetry_title(found: Symmetry) -> str:
    """Say what was found, as the heading of the view.

    Parameters
    ----------
    found : Symmetry
        What was found.

    Returns
    -------
    str
        For example ``"The sides alternate in two stretches"``.

    Examples
    --------
    >>> walk = SymmetrySpan("anti_phase", 0, 90, 0.9, cyclic=True, marks=[0, 30, 60, 90])
    >>> symmetry_title(Symmetry((walk,), 30.0, 90, {}))
    'The sides alternate'
    """
    claims = _claims(found.spans)
    frames = {kind: claim.frames for kind, claim in claims.items()}
    one_side = frames["left"] + frames["right"]
    most = max(*frames.values(), one_side)
    if most and frames["alternate"] == most:
        return f"The sides alternate{_where(claims['alternate'], found)}"
    if most and frames["together"] == most:
        return f"Both sides move together{_where(claims['together'], found)}"
    if again := _mirrored_again(found.spans):
        return "One movement comes back mirrored" if again == 1 else "Movements come back mirrored"
    if most and one_side == most:
        if frames["left"] and frames["right"]:
            return "One side moves more, now the left, now the right"
        side = "left" if frames["left"] else "right"
        return f"The {side} side moves more{_where(claims[side], found)}"
    if most:
        mirrored = frames["alternate"] or frames["together"]
        return "Movements come back, but not mirrored" if mirrored else NOTHING_MIRRORED
    if (still := _still(found)) > MOSTLY:
        return f"The body keeps still{'' if still >= ALL else ' most of the time'}"
    return "No symmetry is clear here" if _moving(found.spans) else "No symmetry shows here"


def symmetry_lead(found: Symmetry) -> str:
    """Say in how many stretches the movement treats the sides how, and what was nearly found where nothing mirrors.

    Parameters
    ----------
    found : Symmetry
        What was found.

    Returns
    -------
    str
        A few plain sentences.
    """
    claims = _claims(found.spans)
    told = []
    for kind, verbs in VERBS.items():
        count, _, limbs = claims[kind]
        if count:
            told.append(f"{_counted(count)} {verbs[count > 1]}{f': {limbs}' * bool(limbs)}.")
    again = _mirrored_again(found.spans)
    if again and not claims["alternate"].frames:
        told.append(f"{_counted(again)} {'comes' if again == 1 else 'come'} again with the sides exchanged.")
    if not told:
        told.append(_why_nothing(found))
    if not (again or claims["alternate"].frames or claims["together"].frames):
        told += _nearest_miss(found)
    return " ".join(told)


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
        return (
            "Symmetry needs joints in three dimensions; this recording has two. Give the same movement with its "
            "depth."
        )
    if not set(TRUNK) <= set(body.roles):
        missing = next(role for role in TRUNK if role not in body.roles).replace("_", " ")
        return (
            f"Symmetry is told from the trunk on, and no {missing} is known here. Name it in a map file (--map), "
            "if the recording has it."
        )
    return f"The symmetry of this recording cannot be told: {why}"


def _claims(spans: Sequence[SymmetrySpan]) -> dict[str, Claim]:
    """Sort what is sure by kinds; what a kind before it covers by half is not told once more."""
    claims: dict[str, Claim] = {}
    before: list[SymmetrySpan] = []
    for kind in VERBS:
        sure = [span for span in spans if span.confidence >= SURE and _kind(span) == kind]
        own = [span for span in sure if not _covered(span, before)]
        one_side = kind in ("left", "right")
        claims[kind] = Claim(
            *_stretches(own), limb_words(link for span in own for link in span.links) if one_side else ""
        )
        before += own
    return claims


def _kind(span: SymmetrySpan) -> str:
    if span.motif in ALTERNATE:
        return "alternate"
    if span.motif in TOGETHER:
        return "together"
    if span.motif in UNMIRRORED:
        return span.side if span.side in ("left", "right") else "unmirrored"
    return ""


def _where(claim: Claim, found: Symmetry) -> str:
    """In how many stretches, unless they fill most of the recording."""
    if claim.frames > MOSTLY * found.frames:
        return ""
    return f" in {count_word(claim.stretches)} {'stretch' if claim.stretches == 1 else 'stretches'}"


def _counted(count: int) -> str:
    return f"{count_word(count).capitalize()} {'stretch' if count == 1 else 'stretches'}"


def _why_nothing(found: Symmetry) -> str:
    still = _still(found)
    if still >= ALL:
        return "It moves too little to tell how the two sides move together."
    if still > MOSTLY:
        return (
            f"It does so {still:.0%} of the time, and no other stretch tells how the two sides move together."
        )
    if _moving(found.spans):
        return (
            "No stretch tells clearly how the two sides move together: none is more likely right than wrong."
        )
    return "No stretch was clear enough to say how the two sides move together."


def _nearest_miss(found: Symmetry) -> list[str]:
    """Say what came nearest to being mirrored, and how near."""
    mirroring = (*ALTERNATE, *TOGETHER, "reflected_path_repetition")
    misses = [span for span in found.spans if span.motif in mirroring and span.confidence < SURE]
    if not misses:
        return []
    best = max(misses, key=lambda span: span.confidence)
    name = motif_name(best)
    when = f"{clock(best.start / found.rate)} to {clock(best.stop / found.rate)}"
    return [f"The nearest miss, {when}: {name[0].lower()}{name[1:]}, confidence {best.confidence:.2f}."]


def _still(found: Symmetry) -> float:
    """Share of the recording in which the body keeps still."""
    frames = _stretches([span for span in found.spans if span.motif == "stillness"])[1]
    return frames / max(found.frames, 1)


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
