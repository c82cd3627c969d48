"""What the page holds: the nouns as one JSON document with typed arrays in base64.

Conventions
-----------
The page computes nothing that is not here. It counts time in *drawn frames*, at most 30 a second; positions are
whole millimetres of a drawing in metres (another unit is scaled so that the body is 1.6 m large), the matrix is
bytes, at most 600 x 600 cells. An array is ``{"type", "shape", "data"}``: a JavaScript typed array's name, its
lengths and its little-endian bytes in base64.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from leitmotion.body import ANALYSIS_ROLES, LINKS, ROLES, Body, Dynamics
from leitmotion.discovery import MotionGraph, Pattern, Patterns, make_lesson
from leitmotion.features import posture
from leitmotion.motion import ParameterError, Segmentation
from leitmotion.similarity import SimilarityMatrix
from leitmotion.view import words
from leitmotion.view.arrays import array
from leitmotion.view.choose import MISSING, choose_key, choose_strips, find_nearest, floor_height, look_across
from leitmotion.view.curve_payload import curves_payload
from leitmotion.view.distances import distance_cap, how_told
from leitmotion.view.graph_payload import graph_payload
from leitmotion.view.graph_words import NOT_COMPUTED as NO_GRAPH
from leitmotion.view.lesson import step_payload
from leitmotion.view.symmetry_answer import NOT_COMPUTED
from leitmotion.view.symmetry_payload import Mirroring, symmetry_payload

VERSION = 1
DRAWN_RATE = 30.0
CELLS = 600
BODY_SIZE = 1.6
FULL_SIZE = 1.5
PATH_RATE = 15.0
NEAREST_QUANTUM = 1e-4
STRIP_COUNTS = (*range(1, 15), 16, 18)
HEAD_TOP = 0.14


def page_payload(
    body: Body,
    patterns: Patterns,
    matrix: SimilarityMatrix,
    *,
    source: dict[str, Any],
    labels: Segmentation | None = None,
    labels_from: str = "",
    mirroring: Mirroring | str = NOT_COMPUTED,
    dynamics: Dynamics | None = None,
    graph: MotionGraph | str = NO_GRAPH,
    opens_with: str = "repeats",
) -> dict[str, Any]:
    """Turn the nouns into what the page holds.

    Parameters
    ----------
    body : Body
        The person, at the recording's own rate.
    patterns : Patterns
        What recurs.
    matrix : SimilarityMatrix
        Every moment of `body` against every other; its rate may be lower than the body's.
    source : dict
        Where the recording is from: ``path`` and whatever else the JSON contract tells; ``warnings`` are sentences
        that the page shows as notes.
    labels : Segmentation, optional
        What someone wrote about the recording.
    labels_from : str
        The file name of the labels.
    mirroring : Mirroring or str
        Symmetry, or a sentence that says why there is none.
    dynamics : Dynamics, optional
        Of the body, for curves.
    graph : MotionGraph or str
        States and paths, or a sentence that says why there are none.
    opens_with : {"repeats", "lesson", "symmetry", "graph"}
        What the page shows first.

    Returns
    -------
    dict
        The document, ready for :func:`json.dumps`; its fields are described in ``docs/page.md``.

    Raises
    ------
    ParameterError
        When the matrix is not square or does not cover the body.
    """
    _check(body, matrix)
    unit = _Unit(body, matrix, patterns)
    step = max(1, round(body.rate / DRAWN_RATE))
    frames, seconds = len(range(0, len(body), step)), len(body) / body.rate
    moments, rate = _moments(matrix)
    cap = distance_cap(moments, unit.told) / unit.shown
    remark = words.as_they_stand(patterns, body)
    near, near_distances = find_nearest(moments, rate, cap=cap / unit.per_value)
    return {
        "version": VERSION,
        "opens_with": opens_with,
        "title": words.title(patterns),
        "lead": _lead(words.lead(patterns, seconds, body)),
        "source": {
            "name": body.name or "recording",
            "path": str(source.get("path", "")),
            "frames": len(body),
            "rate": body.rate,
            "seconds": seconds,
        },
        "clock": {"frames": frames, "rate": body.rate / step},
        "body": _body(body, step, unit, patterns),
        "distance": {"factor": unit.shown, "unit": unit.told.word, "cap": cap},
        "matrix": _matrix(matrix, cap, unit),
        "nearest": {
            "rate": rate,
            "seconds": array(np.where(near < 0, np.nan, near / rate), "f4"),
            "distances": array(_quanta(near_distances * unit.per_value), "u2"),
            "quantum": NEAREST_QUANTUM,
        },
        "patterns": [_pattern(p, moments, rate) for p in patterns.patterns],
        "stripes": _stripes(patterns),
        "lesson": _lesson(body, patterns),
        "labels": None if labels is None else _labels(labels, labels_from),
        "symmetry": {"none": mirroring}
        if isinstance(mirroring, str)
        else symmetry_payload(body, patterns, mirroring, step=step, metres=unit.draw),
        "graph": {"none": graph} if isinstance(graph, str) else graph_payload(body, graph),
        "curves": None if dynamics is None else curves_payload(dynamics, step=step),
        "strips": [array(chosen / rate, "f4") for chosen in choose_strips(moments, STRIP_COUNTS)],
        "empty": None
        if len(patterns)
        else words.empty_text(patterns, still=_keeps_still(moments, rate, cap, unit), remark=remark),
        "looked_for": f"{words.looked_for(patterns)} {remark}".rstrip(),
        "notes": [str(note) for note in source.get("warnings", ()) if note != remark or len(patterns)],
    }


class _Unit:
    """How a distance of the matrix becomes a length of the drawing and a number that a person reads."""

    def __init__(self, body: Body, matrix: SimilarityMatrix, patterns: Patterns) -> None:
        self.draw = 1.0 if body.unit == "m" else BODY_SIZE / body.size
        self.told = how_told(matrix, size=body.size)
        places = matrix.metric == "mean_norm" and matrix.unit in ("m", "px", "relative")
        self.positional = places and patterns.parameters.get("feature", "posture") == "posture"
        if places:
            self.per_value = matrix.scale * self.draw
            self.shown = 100.0 if body.unit == "m" else 100 / BODY_SIZE
        else:
            self.per_value = matrix.scale
            self.shown = self.told.factor / matrix.scale


def _check(body: Body, matrix: SimilarityMatrix) -> None:
    n, m = matrix.values.shape
    if n != m:
        raise ParameterError(f"The page needs a square matrix of one recording, got {n} x {m}.")
    seconds, covered = len(body) / body.rate, n / matrix.row_rate
    if abs(seconds - covered) > 2 / matrix.row_rate + 1 / body.rate:
        raise ParameterError(
            f"The matrix covers {covered:.2f} s, the body {seconds:.2f} s: they must be one recording."
        )


def _moments(matrix: SimilarityMatrix) -> tuple[np.ndarray, float]:
    """Distances between moments, at most about 30 a second, and how many there are a second."""
    stride = max(1, round(matrix.row_rate / DRAWN_RATE))
    return matrix.values[::stride, ::stride], matrix.row_rate / stride


def _body(body: Body, step: int, unit: _Unit, patterns: Patterns) -> dict[str, Any]:
    drawn = body.positions[::step] * unit.draw
    flat = drawn.shape[2] == 2
    if flat:
        drawn = np.concatenate([drawn, np.zeros((*drawn.shape[:2], 1))], axis=2)
        drawn[np.isnan(drawn[..., 0]), 2] = np.nan
    known = tuple(role for role in body.roles if role in ROLES)
    size = body.size * unit.draw
    floor = floor_height(drawn, size / FULL_SIZE)
    index = {role: r for r, role in enumerate(body.roles)}
    searched = patterns.parameters.get("features")
    names = searched if isinstance(searched, list | tuple) else ANALYSIS_ROLES if known else body.roles
    compared = [index[name] for name in names if name in index]
    return {
        "roles": list(body.roles),
        "words": [words.role_word(role) for role in body.roles],
        "compared": compared if unit.positional else [],
        "links": [[index[a], index[b]] for a, b in LINKS if a in index and b in index],
        "dots": len(known) < 6,
        "flat": flat,
        "metres": body.unit == "m",
        "girth": size / FULL_SIZE,
        "height": _height(drawn) + (HEAD_TOP * size / FULL_SIZE if "head" in index else 0.0),
        "reach": _reach(drawn, floor) + HEAD_TOP * size / FULL_SIZE,
        "floor": floor,
        "yaw": 0.0 if flat else look_across(drawn, body.facing[::step]),
        "positions": _millimetres(drawn),
        "facing": array(body.facing[::step], "f4"),
    }


def _height(drawn: np.ndarray) -> float:
    """How tall the person stands: nearly the tallest posture, from the lowest point to the highest."""
    y = drawn[..., 1]
    seen = np.isfinite(y).any(axis=1)
    if not seen.any():
        return 1.7
    return float(np.percentile(np.nanmax(y[seen], axis=1) - np.nanmin(y[seen], axis=1), 90)) or 1.0


def _reach(drawn: np.ndarray, floor: float) -> float:
    """How high the highest posture reaches above the floor, a stray point apart."""
    y = drawn[..., 1]
    seen = np.isfinite(y).any(axis=1)
    return float(np.percentile(np.nanmax(y[seen], axis=1), 99.5) - floor) if seen.any() else 1.7


def _millimetres(drawn: np.ndarray) -> dict[str, Any]:
    """Positions as whole millimetres: 16 bits hold 32 m each way, a longer walk takes 32."""
    whole = np.rint(drawn * 1000)
    far = np.abs(whole[np.isfinite(whole)]).max(initial=0)
    kind = "i2" if far < 32767 else "i4"
    return array(np.where(np.isfinite(whole), whole, MISSING[kind]), kind)


def _matrix(matrix: SimilarityMatrix, cap: float, unit: _Unit) -> dict[str, Any]:
    """Distances as bytes, each cell the mean of its block; 255 is unknown, 254 is `top` or farther."""
    n = matrix.values.shape[0]
    stride = -(-n // CELLS)
    starts = np.arange(0, n, stride)
    cells = np.empty((len(starts), len(starts)))
    for k, start in enumerate(starts):
        band = matrix.values[start : start + stride].astype(np.float64)
        sums = np.add.reduceat(np.nan_to_num(band).sum(axis=0), starts)
        count = np.add.reduceat(np.isfinite(band).sum(axis=0), starts)
        with np.errstate(invalid="ignore", divide="ignore"):
            cells[k] = sums / count
    known = np.isfinite(cells)
    diagonal = np.diag_indices_from(cells)
    cells[diagonal] = np.where(known[diagonal], 0.0, np.nan)
    top = 1.5 * cap
    whole = np.rint(np.minimum(cells * unit.per_value / top, 1) * 254)
    return {
        "rate": matrix.row_rate / stride,
        "top": top,
        "values": array(np.where(known, whole, 255), "u1"),
    }


def _pattern(pattern: Pattern, distances: np.ndarray, rate: float) -> dict[str, Any]:
    head, sub = words.lane_head(pattern)
    spans = pattern.stretches
    return {
        "id": pattern.id,
        "kind": pattern.kind,
        "period_s": pattern.period_s,
        "confidence": pattern.confidence,
        "reason": pattern.reason,
        "cost": pattern.cost,
        "head": head,
        "sub": sub,
        "key": choose_key(pattern, distances, rate) / rate,
        "stretches": [
            {
                "start": float(start / spans.rate),
                "stop": float(stop / spans.rate),
                "cycles": [list(cycle) for cycle in words.cycles_in(pattern, k)],
                "name": words.stretch_name(pattern, k),
                "tip": words.stretch_tip(pattern, k),
            }
            for k, (start, stop, _, _) in enumerate(spans)
        ],
    }


def _stripes(patterns: Patterns) -> dict[str, Any]:
    """Warping paths one after the other: seconds of the earlier and of the later moment."""
    order = {p.id: k for k, p in enumerate(patterns.patterns)}
    pairs = [pair for pair in patterns.stripes if pair.pattern in order]
    every = max(1, round(patterns.rate / PATH_RATE))
    paths = [_thinned(pair.path, every) / patterns.rate for pair in pairs]
    lengths = [len(path) for path in paths]
    return {
        "pattern": [order[pair.pattern] for pair in pairs],
        "length": lengths,
        "points": array(np.concatenate(paths) if paths else np.empty((0, 2)), "f4"),
    }


def _lesson(body: Body, patterns: Patterns) -> dict[str, Any] | None:
    """Steps in order, each with its times, the typical one first; of the others the moments that belong together."""
    searched = patterns.parameters.get("features")
    named = searched if isinstance(searched, list | tuple) else ()
    lesson = make_lesson(
        posture(body, roles=[role for role in named if role in body.roles] or None), patterns
    )
    if not lesson.steps:
        return None
    order = {pattern.id: k for k, pattern in enumerate(patterns.patterns)}
    paths = [each.path for step in lesson.steps for each in step.variations]
    return {
        "steps": [step_payload(step, lesson) | {"pattern": order[step.pattern]} for step in lesson.steps],
        "points": array(np.concatenate(paths) / lesson.rate, "f4"),
    }


def _thinned(path: np.ndarray, every: int) -> np.ndarray:
    """Keep one step of a path every so many frames of progress, and always both ends."""
    progress = path.sum(axis=1) // (2 * every)
    keep = np.concatenate([[True], np.diff(progress) > 0])
    keep[-1] = True
    return path[keep]


def _labels(labels: Segmentation, labels_from: str) -> dict[str, Any]:
    items = [[start / labels.rate, stop / labels.rate, label] for start, stop, label, _ in labels]
    return {"title": f"Labels in {labels_from}" if labels_from else "Given labels", "items": items}


def _lead(pieces: words.Lead) -> list[str | dict[str, str]]:
    return [{"chip": piece.id} if isinstance(piece, words.Chip) else piece for piece in pieces]


def _keeps_still(distances: np.ndarray, rate: float, cap: float, unit: _Unit) -> bool:
    """Whether the body keeps still for half a second somewhere: a dark block beside the diagonal."""
    apart = max(1, round(rate / 2))
    beside = np.diagonal(distances, apart) * unit.per_value
    return bool((beside[np.isfinite(beside)] < 0.15 * cap).any())


def _quanta(distances: np.ndarray) -> np.ndarray:
    return np.where(np.isfinite(distances), np.minimum(np.rint(distances / NEAREST_QUANTUM), 65535), 65535)
