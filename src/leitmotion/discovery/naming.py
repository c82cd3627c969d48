"""Naming: which motif of paper S a form, a pair or a loop is, and how sure that is.

Conventions
-----------
A confidence is a product of shares, each from 0 to 1: how near the movement comes to itself, one less the square of
its mean distance over what is alike; how much of the stretch its signals tell; and how clearly its postures are
symmetric, or are not. So those of two motifs that fit one stretch can be compared.

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
from leitmotion.discovery.waypoints import Waypoints

SYMMETRIC, ASYMMETRIC = (0.3, 0.8), (0.85, 0.5)  # shares of symmetric postures: none of it, and all
LEAST_CONFIDENCE = 0.1
LESS_SPECIAL = 0.2  # of the confidence of an anti-palindrome, that being anti-phase besides says less
IMPLIED = 0.6  # of a form, that another tells which implies it
ONCE = 0.6  # of the confidence that what came back once has, since nothing shows that it would again
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
            implied = any(
                (other.mirror, other.reversed) in IMPLIES.get(kind, ()) and covered_by(form, other) > IMPLIED
                for other, _ in told
            )
            named = _named(form, waypoints)
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
    share = min(_symmetric(waypoints, *pair.earlier), _symmetric(waypoints, *pair.later))
    sure = _ramp(share, *ASYMMETRIC) if motif.startswith("reflected") else 1.0
    alike = float(np.degrees(waypoints.alike[pair.later[0] : pair.later[1] + 1].mean()))
    reason = f"The two are {pair.cost * alike:.1f}° of a mean link apart, {alike:.1f}° would be alike."
    return Named(motif, pair.earlier, sure * (1 - pair.cost**2), reason, partner=pair.later)


def name_loop(loop: Pair, waypoints: Waypoints) -> Named:
    """Name a way that comes back to where it began, once."""
    first, last = loop.earlier[0], loop.later[0]
    share = _symmetric(waypoints, first, last)
    motif, sure = _of_sides(share, *NAMES[False, False])
    reason = f"It comes back once; {share:.0%} of its postures are symmetric."
    return Named(motif, (first, last), ONCE * sure * (1 - loop.cost**2), reason)


def name_symmetric(forms: Sequence[Named], waypoints: Waypoints) -> list[Named]:
    """Name the movements through symmetric postures that no symmetric form tells."""
    alike = symmetric_waypoints(waypoints)
    for named in forms:
        if named.motif.startswith("symmetric"):
            alike[named.marks[0] : named.marks[-1] + 1] = False
    edges = np.flatnonzero(np.diff(np.concatenate(([0], alike.astype(int), [0]))))
    found = []
    for first, stop in zip(edges[::2], edges[1::2], strict=True):
        stretch = slice(first, stop)
        if np.nanmax(waypoints.own[stretch, stretch]) < LEAST_EXTENT * waypoints.alike[stretch].mean():
            continue
        ratio = np.diagonal(waypoints.mirror)[stretch] / waypoints.alike[stretch]
        apart = float(np.degrees(np.diagonal(waypoints.mirror)[stretch].mean()))
        reason = f"Its postures are {apart:.1f}° of a mean link from their mirror images."
        found.append(
            Named("symmetric_path", (int(first), int(stop) - 1), 1 - float(np.mean(ratio**2)), reason)
        )
    return found


def symmetric_waypoints(waypoints: Waypoints) -> np.ndarray:
    """Tell the postures that are alike to their own mirror images, (K,) bool."""
    alike: np.ndarray = np.diagonal(waypoints.mirror) <= waypoints.alike
    return alike


def _named(form: Form, waypoints: Waypoints) -> Named:
    share = _symmetric(waypoints, form.first, form.last)
    motif, sure = _of_sides(share, *NAMES[form.mirror, form.reversed])
    alike = float(np.degrees(waypoints.alike[form.first : form.last + 1].mean()))
    ways = len(form.marks) - 1
    what = "ways" if form.reversed else "half-cycles" if form.mirror else "cycles"
    reason = (
        f"{ways} {what}, {form.cost * alike:.1f}° of a mean link apart{' mirrored' if form.mirror else ''}, "
        f"{alike:.1f}° would be alike; {form.covered:.0%} of it is told, {share:.0%} of its postures are symmetric."
    )
    cyclic = ways >= 2 * WAYS.get((form.mirror, form.reversed), 2)
    return Named(
        motif, form.marks, sure * (1 - form.cost**2) * form.covered, reason, cyclic, None, form.moments
    )


def _of_sides(share: float, symmetric: str, asymmetric: str) -> tuple[str, float]:
    degrees = {symmetric: _ramp(share, *SYMMETRIC), asymmetric: _ramp(share, *ASYMMETRIC)}
    motif = max((name for name in degrees if name), key=lambda name: degrees[name])
    return motif, degrees[motif]


def _symmetric(waypoints: Waypoints, first: int, last: int) -> float:
    return float(symmetric_waypoints(waypoints)[first : last + 1].mean())


def _ramp(value: float, zero: float, one: float) -> float:
    return float(np.clip((value - zero) / (one - zero), 0, 1))
