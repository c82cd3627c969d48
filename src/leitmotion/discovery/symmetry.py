"""Motifs of symmetry in a recording: the taxonomy of paper S, told from proximity signals.

Conventions
-----------
What tells more is told, and what it implies is not: a palindrome that goes on is no cycle besides, a walk that is
anti-phase no asymmetric one. An anti-palindrome may be anti-phase as well; then both stand, each with its confidence.

References
----------
Paper S, sections 3.2 to 3.6.
"""

from __future__ import annotations

import numpy as np

from leitmotion.discovery.excursions import excursions
from leitmotion.discovery.forms import Form, covered_by, runs_of_cycles, runs_of_turns
from leitmotion.discovery.labour import ahead
from leitmotion.discovery.naming import (
    CLEAR,
    LEAST_CONFIDENCE,
    Named,
    name_forms,
    name_loop,
    name_pair,
    name_symmetric,
)
from leitmotion.discovery.pairs import Pair, loops, pairs_of_paths
from leitmotion.discovery.sides import sides_of
from leitmotion.discovery.signals import Signal, find_signals
from leitmotion.discovery.spikes import find_strikes
from leitmotion.discovery.symmetry_span import Symmetry, SymmetrySpan
from leitmotion.discovery.waypoints import Waypoints, angles, find_waypoints
from leitmotion.similarity import DoubleMetric, still_spans

STILL_SHARE = 0.6  # of the angle of half likeness, that a body which keeps still stays within
STILL = np.radians(5.0), np.radians(6.5)  # bounds of that, of a mean link
DRIFT = np.radians(8.0)  # a second, of a body that keeps still: one that passes slowly is faster
SAME = 0.6  # of a form, or of both stretches of a pair, in another


def find_symmetry(found: DoubleMetric, *, min_still_s: float = 0.5) -> Symmetry:
    """Find the motifs of a recording's symmetry in space and time.

    Parameters
    ----------
    found : DoubleMetric
        Of T moments (:func:`leitmotion.similarity.double_metric`).
    min_still_s : float
        How long stillness lasts at least, seconds.

    Returns
    -------
    Symmetry
        Stretches in moments of `found`, in order of their starts.

    Examples
    --------
    >>> from leitmotion.datasets import compose_session
    >>> from leitmotion.features import kinematic_chain
    >>> from leitmotion.similarity import double_metric
    >>> chain = kinematic_chain(compose_session(seed=0, rate=30.0).motion)
    >>> len(find_symmetry(double_metric(chain)).spans) > 0
    True
    """
    waypoints = find_waypoints(found)
    kinds = [(mirror, reverse) for mirror in (False, True) for reverse in (False, True)]
    traced = ahead(lambda kind: find_signals(waypoints, mirror=kind[0], reverse=kind[1]), kinds)
    signals = dict(zip(kinds, traced, strict=True))
    cycles = runs_of_cycles(signals[False, False], waypoints)
    halves = runs_of_cycles(signals[True, False], waypoints, within=cycles)
    forms = [
        *cycles,
        *halves,
        *runs_of_turns(signals[False, True], waypoints, cycles),
        *runs_of_turns(signals[True, True], waypoints, halves),
    ]
    told = name_forms(forms, waypoints)
    once = name_forms(excursions(waypoints, _clear(told)), waypoints)
    told = [one for one in told if not any(_again(one, other) for other in once)] + once
    named = [each for _, each in told]
    named += _pairs(signals, _clear(told), waypoints)
    named += name_symmetric(named, waypoints)
    spans = [_span(each, waypoints) for each in named if each.confidence >= LEAST_CONFIDENCE]
    spans += _still(found, min_still_s)
    return Symmetry(
        tuple(sorted(spans, key=lambda span: (span.start, -span.confidence))),
        found.rate,
        len(found),
        {
            "metric": found.metric,
            "beta": found.beta,
            "half_alike_deg": float(np.degrees(found.half_angle)),
            "sides_differ_deg": _lasting_deg(waypoints),
            "links": found.names,
        },
        find_strikes(found),
    )


def _clear(told: list[tuple[Form, Named]]) -> list[Form]:
    return [form for form, each in told if each.confidence >= CLEAR]


def _again(one: tuple[Form, Named], other: tuple[Form, Named]) -> bool:
    """Whether another tells for the most part what one tells."""
    return one[1].motif == other[1].motif and covered_by(one[0], other[0]) > SAME


def _lasting_deg(waypoints: Waypoints) -> float:
    """By how much the mean posture and its mirror image differ, degrees."""
    count = len(waypoints.at)
    if not count:
        return 0.0
    return float(np.degrees(sides_of(waypoints.own, waypoints.products, 0, count - 1).lasting))


def _pairs(
    signals: dict[tuple[bool, bool], list[Signal]], forms: list[Form], waypoints: Waypoints
) -> list[Named]:
    again, reflected, back = (
        pairs_of_paths(signals[kind], forms) for kind in ((False, False), (True, False), (False, True))
    )
    back = [pair for pair in back if not any(_same(pair, other) for other in again)]
    named = [
        name_pair(motif, pair, waypoints)
        for motif, pairs in (
            ("path_repetition", again),
            ("reflected_path_repetition", reflected),
            ("path_reversal", back),
        )
        for pair in pairs
    ]
    returns = loops(waypoints.own, waypoints, forms)
    named += [name_loop(loop, waypoints) for loop in returns]
    named += [name_pair("state_repetition", loop, waypoints) for loop in returns]
    named += [
        name_pair("reflected_state_repetition", loop, waypoints)
        for loop in loops(waypoints.mirror, waypoints, forms)
    ]
    return named


def _same(pair: Pair, other: Pair) -> bool:
    return all(
        min(one[1], two[1]) - max(one[0], two[0]) > SAME * (one[1] - one[0])
        for one, two in ((pair.earlier, other.earlier), (pair.later, other.later))
    )


def _span(named: Named, waypoints: Waypoints) -> SymmetrySpan:
    moments, later = named.moments, named.partner
    return SymmetrySpan(
        named.motif,
        *((moments[0], moments[-1] + 1) if moments else waypoints.stretch(named.marks[0], named.marks[-1])),
        named.confidence,
        named.cyclic,
        None if later is None else waypoints.stretch(*later),
        np.array(moments, dtype=np.int64),
        named.reason,
    )


def _still(found: DoubleMetric, min_still_s: float) -> list[SymmetrySpan]:
    """Stillness within a narrower angle than that of half likeness, which a slow walk stays within for half a step."""
    angle = float(np.clip(STILL_SHARE * found.half_angle, *STILL))
    distance = angle if found.metric == "geodesic" else 1.0 - float(np.cos(angle / 2.0))
    narrow = found.replace(beta=float(np.log(2.0)) / distance)
    reason = f"All its postures are within {np.degrees(angle):.1f}° of a mean link of one another."
    return [
        SymmetrySpan("stillness", start, stop, 1.0, reason=reason)
        for start, stop, _, _ in still_spans(narrow, min_duration_s=min_still_s)
        if _drift(found, start, stop) <= DRIFT
    ]


def _drift(found: DoubleMetric, start: int, stop: int) -> float:
    """How fast the posture changes from the first third of a stretch to the last, noise aside; radians a second."""
    third = max((stop - start) // 3, 1)
    first, last = slice(start, start + third), slice(stop - third, stop)
    across, before, after = (
        float((angles(found.own[one, other], found.metric) ** 2).mean())
        for one, other in ((first, last), (first, first), (last, last))
    )
    return float(np.sqrt(max(across - (before + after) / 2, 0))) * found.rate / (stop - start - third)
