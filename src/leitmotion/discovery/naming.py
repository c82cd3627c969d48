"""Naming: which motif of paper S a form, a pair or a loop is, and how sure that is.

Conventions
-----------
A confidence is a product of shares, each from 0 to 1: how near the movement comes to itself, one less a power of its
mean distance over what is alike; how much of the stretch its signals tell; and how clearly its postures are symmetric,
or are not. So those of two motifs that fit one stretch can be compared. The power is greater for what goes on: the like
of it was seen more often, so that it is the same at a greater distance.

References
----------
Paper S, sections 3.2 to 3.5.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.forms import LEAST_EXTENT, Form, covered_by
from leitmotion.discovery.pairs import Pair
from leitmotion.discovery.sides import Sides, sides_of
from leitmotion.discovery.waypoints import Waypoints

PARTING = (
    0.12,
    0.3,
)  # share of a movement that is antisymmetric: symmetric up to one, asymmetric from the other
ALTERNATING = 0.45, 0.6  # one side moves, both alternate
POSTURES = 0.93, 0.98  # share of postures that are alike to their mirror images: symmetric from the other on
LASTING = np.radians(16.0), np.radians(22.0)  # of the mean posture: symmetric up to one, not from the other
LEAST_CONFIDENCE = 0.1
CLEAR = 0.5  # confidence of a form that tells of what lies within it
IN_GENERAL = 0.9  # of the confidence of what is told more fully, that what it implies has at most
LESS_SPECIAL = 0.2  # of the confidence of an anti-palindrome, that being anti-phase besides says less
IMPLIED = 0.6  # of a form, that another tells which implies it
GOES_ON = 3  # marks: of more than two cycles
IMPLYING = 0.6  # of the confidence of what is implied, that what implies it has at least
FEW, MANY = 3, 4  # power of the distance over what is alike: of what came back once, of what goes on
ONCE = 0.75  # of the confidence that what came back once has, since nothing shows that it would again
NAMES = {
    # mirror, reversed: where symmetric, where not, and what it is implied by
    (True, True): ("", "anti_palindrome"),
    (True, False): ("", "anti_phase"),
    (False, True): ("symmetric_palindrome", "asymmetric_palindrome"),
    (False, False): ("symmetric_cycle", "asymmetric_cycle"),
}
IMPLIES = {
    (False, True): ((True, True),),
    (False, False): ((True, True), (True, False), (False, True)),
}
WAYS = {(False, False): 1}  # of a cycle; of all else two


class Named(NamedTuple):
    """A motif, in waypoints."""

    motif: str
    marks: tuple[int, ...]
    """Waypoints; the first and the last tell where it is."""
    confidence: float
    reason: str
    cyclic: bool = False
    partner: tuple[int, int] | None = None
    moments: tuple[int, ...] = ()
    """Of its marks, where they are better known than the waypoints tell."""


def name_forms(forms: Sequence[Form], waypoints: Waypoints) -> list[tuple[Form, Named]]:
    """Name runs of cycles and turns; what another implies that is told for most of it is left out.

    Parameters
    ----------
    forms : sequence of Form
        Of all kinds.
    waypoints : Waypoints
        K waypoints.

    Returns
    -------
    list of (Form, Named)
        Those of any confidence, the more special first.
    """
    told: list[tuple[Form, Named]] = []
    for kind in NAMES:
        for form in forms:
            if (form.mirror, form.reversed) != kind:
                continue
            named = _named(form, waypoints)
            implied = any(
                (other.mirror, other.reversed) in IMPLIES.get(kind, ())
                and covered_by(form, other) > IMPLIED
                and one.confidence >= IMPLYING * named.confidence
                for other, one in told
            )
            if kind == (True, True):
                implied = any(_part_of(form, other) for other in forms)
            if kind == (True, False):
                special = max(
                    (one.confidence for other, one in told if covered_by(form, other) > IMPLIED), default=0.0
                )
                named = named._replace(confidence=named.confidence * (1 - LESS_SPECIAL * special))
            if not implied and named.confidence >= LEAST_CONFIDENCE:
                told.append((form, named))
    return told


def name_pair(motif: str, pair: Pair, waypoints: Waypoints) -> Named:
    """Name two stretches."""
    sure = 1.0
    if motif.startswith("reflected"):  # of what is symmetric the mirror image tells nothing new
        sure = 1 - max(_symmetric(waypoints, *pair.earlier), _symmetric(waypoints, *pair.later))
    alike = float(np.degrees(waypoints.alike[pair.later[0] : pair.later[1] + 1].mean()))
    reason = f"The two are {pair.cost * alike:.1f}° of a mean link apart, {alike:.1f}° would be alike."
    return Named(motif, pair.earlier, sure * (1 - pair.cost**FEW), reason, partner=pair.later)


def name_loop(loop: Pair, waypoints: Waypoints) -> Named:
    """Name a way that comes back to where it began, once."""
    first, last = loop.earlier[0], loop.later[0]
    motif, sure = _of_sides(_symmetric(waypoints, first, last), *NAMES[False, False])
    reason = f"It comes back once; {_told_sides(waypoints, first, last)}."
    return Named(motif, (first, last), ONCE * sure * (1 - loop.cost**FEW), reason)


def name_symmetric(forms: Sequence[Named], waypoints: Waypoints) -> list[Named]:
    """Name the movements through symmetric postures; one that clear symmetric forms tell is less sure than they."""
    alike = np.diagonal(waypoints.mirror) <= waypoints.alike
    special = np.zeros(len(alike))
    for named in forms:
        if named.motif.startswith("symmetric") and named.confidence >= CLEAR:
            told = special[named.marks[0] : named.marks[-1] + 1]
            np.maximum(told, named.confidence, out=told)
    edges = np.flatnonzero(np.diff(np.concatenate(([0], alike.astype(int), [0]))))
    found = []
    for first, stop in zip(edges[::2], edges[1::2], strict=True):
        stretch = slice(first, stop)
        extent = waypoints.own[stretch, stretch].max() / waypoints.alike[stretch].mean()
        sure = _symmetric(waypoints, int(first), int(stop) - 1)
        if extent >= LEAST_EXTENT:
            near = float(np.mean((np.diagonal(waypoints.mirror)[stretch] / waypoints.alike[stretch]) ** 2))
            sure *= 1 - near
            if (special[stretch] > 0).mean() >= IMPLIED:
                sure = min(sure, IN_GENERAL * special[stretch].max())
            reason = (
                f"It goes on through symmetric postures; {_told_sides(waypoints, int(first), int(stop) - 1)}."
            )
            found.append(Named("symmetric_path", (int(first), int(stop) - 1), float(sure), reason))
    return found


def _named(form: Form, waypoints: Waypoints) -> Named:
    motif, sure = _of_sides(_symmetric(waypoints, form.first, form.last), *NAMES[form.mirror, form.reversed])
    if form.mirror:
        sure = _ramp(_sides(waypoints, form.first, form.last).parting, *ALTERNATING)
    alike = float(np.degrees(waypoints.alike[form.first : form.last + 1].mean()))
    ways = len(form.marks) - 1
    what = "ways" if form.reversed else "half-cycles" if form.mirror else "cycles"
    sides = _told_sides(waypoints, form.first, form.last)
    reason = (
        f"{ways} {what}, {form.cost * alike:.1f}° of a mean link apart{' mirrored' if form.mirror else ''}, "
        f"{alike:.1f}° would be alike; {form.covered:.0%} of it is told; {sides}."
    )
    cyclic = ways >= 2 * WAYS.get((form.mirror, form.reversed), 2)
    often = cyclic and (form.reversed or not form.mirror)  # a limp is not quite unlike its own mirror image
    near = 1 - form.cost ** (MANY if often else FEW)
    return Named(motif, form.marks, sure * near * form.covered, reason, cyclic, None, form.moments)


def _of_sides(symmetric: float, motif: str, asymmetric: str) -> tuple[str, float]:
    return (motif, symmetric) if motif and symmetric >= 0.5 else (asymmetric, 1 - symmetric)


def _symmetric(waypoints: Waypoints, first: int, last: int) -> float:
    """How clearly a stretch is symmetric: both sides do the same, from postures that are about the same."""
    sides = _sides(waypoints, first, last)
    alike = (np.diagonal(waypoints.mirror) <= waypoints.alike)[first : last + 1].mean()
    return (
        _ramp(sides.parting, *PARTING[::-1])
        * _ramp(sides.lasting, *LASTING[::-1])
        * _ramp(float(alike), *POSTURES)
    )


def _told_sides(waypoints: Waypoints, first: int, last: int) -> str:
    sides = _sides(waypoints, first, last)
    lasting = np.degrees(sides.lasting)
    return f"the sides part in {sides.parting:.0%} of the movement, and differ by {lasting:.1f}° throughout"


def _sides(waypoints: Waypoints, first: int, last: int) -> Sides:
    return sides_of(waypoints.own, waypoints.products, first, last)


def _part_of(turn: Form, cycle: Form) -> bool:
    """Whether a turn is a part of a cycle that goes on, in which the body passes a symmetric posture."""
    goes_on = not (cycle.mirror or cycle.reversed) and len(cycle.marks) > GOES_ON
    return goes_on and covered_by(turn, cycle) > IMPLIED and turn.last - turn.first < cycle.way


def _ramp(value: float, zero: float, one: float) -> float:
    return float(np.clip((value - zero) / (one - zero), 0, 1))
