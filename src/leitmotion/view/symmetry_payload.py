"""What the Symmetry view holds: both likenesses as bytes, the motifs as lanes, how lopsided the body is.

Conventions
-----------
Cells ``values[i, j]`` above the diagonal are Z, how like moments i and j are, on it and below it Z*, how like moment i
is to the mirror image of moment j: both are symmetric, and Z is 1 on the diagonal. 254 is the same, 255 unknown. Times
are seconds.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from leitmotion.body import ANALYSIS_ROLES, Body, mirror_role
from leitmotion.discovery import Patterns, Symmetry, SymmetrySpan
from leitmotion.features import mirror_distance, posture
from leitmotion.similarity import DoubleMetric, axis_speed, still_spans
from leitmotion.view.arrays import array
from leitmotion.view.cells import shrunk_likeness
from leitmotion.view.symmetry_answer import LOOKED_FOR, empty_symmetry, symmetry_lead, symmetry_title
from leitmotion.view.symmetry_fit import fit
from leitmotion.view.symmetry_words import (
    CHIEF,
    TOLD,
    half_alike,
    lane_words,
    motif_name,
    side_words,
    span_name,
    span_sentence,
    span_tip,
)

CELLS = 600
HELD = 0.5  # of a span, that a pattern has to hold to give it its letter
ROWS = 3  # a lane has at most: what overlaps is drawn in several
QUANTUM = 1e-3
FASTEST = 98  # percentile of the speeds that a curve shows


class Mirroring(NamedTuple):
    """A recording beside its mirror image, and what was found of it."""

    found: Symmetry
    distances: DoubleMetric


def symmetry_payload(
    body: Body, patterns: Patterns, mirroring: Mirroring, *, step: int, metres: float
) -> dict[str, Any]:
    """Turn what was found of symmetry into what the page holds.

    Parameters
    ----------
    body : Body
        The person, with both sides, at the recording's own rate.
    patterns : Patterns
        What recurs: spans within a pattern bear its letter.
    mirroring : Mirroring
        The motifs, and the distances that they were found in.
    step : int
        Frames of the recording a drawn frame.
    metres : float
        Of the drawing, a unit of the body's positions.

    Returns
    -------
    dict
        The page's ``symmetry``; its fields are described in ``docs/page.md``.
    """
    found, distances = mirroring
    held = [_pattern_of(span, found.rate, patterns) for span in found.spans]
    letters = ["" if k is None else patterns.patterns[k].id for k in held]
    compared = [role for role in ANALYSIS_ROLES if role in body.roles and mirror_role(role) in body.roles]
    apart = mirror_distance(posture(body, roles=compared)) * body.size * metres
    factor, unit = (100.0, "cm") if body.unit == "m" else (100 / (body.size * metres), "% of body size")
    seen = apart[np.isfinite(apart)]
    index = {role: r for r, role in enumerate(body.roles)}
    return {
        "title": symmetry_title(found),
        "lead": [symmetry_lead(found)],
        "empty": empty_symmetry(float(np.median(seen)) * factor if len(seen) else None, unit),
        "looked_for": LOOKED_FOR,
        "half": half_alike(float(np.degrees(distances.half_angle))),
        "beta": distances.beta,
        "matrix": _cells(distances),
        "partner": [index.get(mirror_role(role), -1) for role in body.roles],
        "compared": [index[role] for role in compared],
        "told": {"factor": factor, "unit": unit},
        "lopsidedness": {"quantum": QUANTUM, "values": _quanta(apart[::step])},
        "speed": _speed(distances),
        "still": [[a / distances.rate, b / distances.rate] for a, b, _, _ in still_spans(distances)],
        "strikes": [float(frame / found.rate) for frame in found.strikes],
        "lanes": _lanes(found, distances, held, letters),
    }


def _cells(distances: DoubleMetric) -> dict[str, Any]:
    own, mirror = (shrunk_likeness(each, distances.beta, CELLS) for each in (distances.own, distances.mirror))
    stride = -(-len(distances) // CELLS)
    both = np.where(np.triu(np.ones(own.shape, dtype=bool), 1), own, mirror)
    seen = np.isfinite(np.diagonal(distances.own))[:: max(stride, 1)]
    known = seen[:, None] & seen[None, :]
    return {
        "rate": distances.rate / max(stride, 1),
        "values": array(np.where(known, np.rint(254 * both), 255), "u1"),
    }


def _speed(distances: DoubleMetric) -> dict[str, Any]:
    """How fast the body moves, by the identity axis: bytes, 254 is `most` in whole degrees a second, 255 unknown."""
    speed = np.degrees(axis_speed(distances))[:: -(-len(distances) // CELLS)]
    known = np.isfinite(speed)
    most = float(np.ceil(np.percentile(speed[known], FASTEST))) if known.any() else 1.0
    part = np.minimum(np.nan_to_num(speed) / max(most, 1.0), 1.0)
    return {"most": max(most, 1.0), "values": array(np.where(known, np.rint(254 * part), 255), "u1")}


def _lanes(
    found: Symmetry, distances: DoubleMetric, held: Sequence[int | None], letters: Sequence[str]
) -> list[dict[str, Any]]:
    """One lane a motif that was found, those first that tell how the sides move together."""
    lanes = []
    for motif in TOLD:
        inside = [k for k, span in enumerate(found.spans) if span.motif == motif]
        if not inside:
            continue
        spans = [found.spans[k] for k in inside]
        name, term = lane_words(motif, spans)
        rows = _rows(spans)
        lanes.append(
            {
                "motif": motif,
                "name": name,
                "term": term,
                "chief": motif in CHIEF,
                "key": _key(spans, found.rate),
                "rows": max(rows) + 1,
                "spans": [
                    _span(found.spans[k], found.rate, distances, letters[k], n, len(spans))
                    | {"pattern": held[k], "row": row}
                    for n, (k, row) in enumerate(zip(inside, rows, strict=True))
                ],
            }
        )
    return lanes


def _span(
    span: SymmetrySpan, rate: float, distances: DoubleMetric, letter: str, k: int, count: int
) -> dict[str, Any]:
    sentence, picture = span_sentence(span, rate)
    return {
        "start": span.start / rate,
        "stop": span.stop / rate,
        "partner": None if span.partner is None else [moment / rate for moment in span.partner],
        "marks": [float(mark / rate) for mark in span.marks],
        "cyclic": span.cyclic,
        "confidence": span.confidence,
        "reason": span.reason,
        "plain": motif_name(span),
        "side": span.side,
        "left_share": span.left_share,
        "links": list(span.links),
        "sides": side_words(span),
        "name": span_name(span, rate, letter, k, count),
        "tip": span_tip(span, rate, letter),
        "sentence": sentence,
        "picture": picture,
        "fit": fit(span, rate, distances),
    }


def _pattern_of(span: SymmetrySpan, rate: float, patterns: Patterns) -> int | None:
    """Which pattern holds a span: the one that has most of it, and half at least."""
    start, stop = span.start / rate, span.stop / rate
    best, most = None, HELD * (stop - start)
    for p, pattern in enumerate(patterns.patterns):
        held = sum(
            max(min(stop, b / pattern.stretches.rate) - max(start, a / pattern.stretches.rate), 0.0)
            for a, b, _, _ in pattern.stretches
        )
        if held > most:
            best, most = p, held
    return best


def _key(spans: Sequence[SymmetrySpan], rate: float) -> float:
    """The posture that stands for a lane: of its surest span, the first turn, which is where it is farthest out."""
    surest = max(spans, key=lambda span: span.confidence)
    inner = [mark for mark in surest.marks if surest.start < mark < surest.stop]
    return float((inner[0] if inner else (surest.start + surest.stop) / 2) / rate)


def _rows(spans: Sequence[SymmetrySpan]) -> list[int]:
    """Lay spans that overlap into rows of their lane; what finds no room in the last one lies over it."""
    ends = [-1] * ROWS
    rows = []
    for span in spans:
        reach = max(span.stop, span.partner[1] if span.partner else 0)
        row = next((r for r in range(ROWS) if ends[r] <= span.start), ROWS - 1)
        ends[row] = max(ends[row], reach)
        rows.append(row)
    return rows


def _quanta(lengths: np.ndarray) -> dict[str, Any]:
    known = np.isfinite(lengths)
    return array(np.where(known, np.minimum(np.rint(lengths / QUANTUM), 65534), 65535), "u2")
