"""Writing: themes and returns as nouns, in frames of the recording and in its own unit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import islice, pairwise
from statistics import median
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.confidence import Evidence, confidence
from leitmotion.discovery.families import TOUCH
from leitmotion.discovery.overlay import AGREED, HELD, overlay_of_spans
from leitmotion.discovery.pattern import Pattern, PatternPair, cut_at_occurrences, letter
from leitmotion.discovery.returns import Return
from leitmotion.discovery.search import Criteria, Seen
from leitmotion.discovery.stripes import Likeness, Stripe, measure, part
from leitmotion.discovery.themes import Theme
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.segmentation import Segmentation
from leitmotion.similarity import Distances

COMPARED = 60  # pairs of occurrences that are aligned to judge a pattern
MIN_AGREEMENT = 0.5  # of the pairs of occurrences must be alike
PAIRS = 10_000  # of one pattern that are written down, those of occurrences that follow soonest first
STRIPES = 2_000  # of one pattern that are written down, those that gain most first


class Found(NamedTuple):
    """A pattern with what shows it."""

    pattern: Pattern
    stripes: Sequence[Stripe]
    agreement: float
    """Share of the pairs of occurrences that are alike."""

    evidence: Evidence
    """What its confidence follows from."""


class Written(NamedTuple):
    """What is told of all patterns."""

    patterns: tuple[Pattern, ...]
    pairs: tuple[PatternPair, ...]
    stripes: tuple[PatternPair, ...]
    evidence: tuple[Evidence, ...]
    """What the confidence of each pattern follows from."""

    limits: dict[str, object]
    """``pairs_left_out`` and ``stripes_left_out``, where a pattern has more than are written down."""


class Scribe:
    """Writes themes and returns down as nouns, in frames and in the recording's own unit."""

    def __init__(self, features: FeatureSequence, distances: Distances, criteria: Criteria) -> None:
        self.ratio = features.rate / distances.features.rate
        self.frames = len(features)
        self.rate = features.rate
        self.scale = features.scale
        self.unit = features.unit
        self.distances = distances
        self.criteria = criteria
        self.max_distance = criteria.max_distance

    @cached_property
    def alike(self) -> Likeness:
        """What counts as alike."""
        return self.criteria.likeness(self.distances)

    def describe(self, seen: Seen) -> list[Found]:
        """All of what one pass saw, but for what its own occurrences gainsay."""
        found = [self.cyclic(theme) for theme in seen.themes] + [self.acyclic(item) for item in seen.returns]
        return [item for item in found if item.agreement >= MIN_AGREEMENT]

    def cyclic(self, theme: Theme) -> Found:
        """A theme: one occurrence a cycle."""
        cycles = [
            (a, b) for run in theme.runs for a, b in zip(run.borders[:-1], run.borders[1:], strict=True)
        ]
        extents = [(run.start, run.stop) for run in theme.runs]
        shown = self._within(theme.stripes, extents)
        return self._describe("cyclic", cycles, extents, shown)

    def acyclic(self, found: Return) -> Found:
        """A return: one occurrence a stretch; cyclic where some follow one another without a break."""
        extents = joined_spans(found.spans)
        kind = "acyclic" if len(extents) == len(found.spans) else "cyclic"
        return self._describe(kind, found.spans, extents, self._within(found.stripes, extents))

    def held(self, spans: list[tuple[float, float]]) -> Found:
        """A posture that is held at several times."""
        found = self._describe("acyclic", spans, spans, [])
        reason = "a posture that is held again, without movement"
        pattern = found.pattern.replace(reason=reason, confidence=round(found.agreement, 3))
        return found._replace(pattern=pattern, agreement=1.0)

    def write(self, found: Sequence[Found]) -> Written:
        """Name what was found by letters, the pattern that fills most time first, and write its pairs down."""
        patterns: list[Pattern] = []
        pairs: list[PatternPair] = []
        stripes: list[PatternPair] = []
        pairs_left = stripes_left = 0
        found = sorted(found, key=lambda item: -_filled(item.pattern))
        for k, item in enumerate(found):
            pattern = _named(item.pattern, letter(k))
            between = self._between_occurrences(pattern.occurrences, item.stripes)
            kept = sorted(between, key=lambda joined: joined[1] - joined[0])[:PAIRS]  # neighbours first
            kept.sort()
            stops = pattern.occurrences.stops[np.array(kept, np.int64).reshape(-1, 2)]
            pairs += self._traced(pattern.id, [between[joined] for joined in kept], stops)
            shown = item.stripes
            if len(shown) > STRIPES:
                shown = sorted(shown, key=lambda stripe: -stripe.gain)[:STRIPES]
            stripes += self._traced(
                pattern.id, [s.path for s in shown], np.full((len(shown), 2), self.frames)
            )
            patterns.append(pattern)
            pairs_left += len(between) - len(kept)
            stripes_left += len(item.stripes) - len(shown)
        limits: dict[str, object] = {}
        if pairs_left:
            limits["pairs_left_out"] = pairs_left
        if stripes_left:
            limits["stripes_left_out"] = stripes_left
        evidence = tuple(item.evidence for item in found)
        return Written(tuple(patterns), tuple(pairs), tuple(stripes), evidence, limits)

    def _describe(
        self,
        kind: str,
        occurrences: Sequence[tuple[float, float]],
        extents: Sequence[tuple[float, float]],
        stripes: Sequence[Stripe],
    ) -> Found:
        costs, pairs = self._compare(occurrences)
        scores = [
            max(0.0, 1.0 - median(costs[(pairs == k).any(axis=1)].tolist()) / (2 * self.max_distance))
            for k in range(len(occurrences))
        ]
        agreement = float(np.mean(costs < AGREED * self.max_distance))
        contrast = float(np.mean([s.contrast for s in stripes])) if stripes else 0.0
        spans = self._segmentation(occurrences, np.array(scores))
        seconds = float(np.median(spans.stops - spans.starts)) / self.rate
        evidence = Evidence(contrast, float(np.mean(costs)) / self.max_distance, seconds)
        pattern = Pattern(
            id="?",
            kind=kind,
            occurrences=spans,
            stretches=self._segmentation(extents, np.full(len(extents), np.nan)),
            period_s=seconds,
            cost=float(np.mean(costs)) * self.scale,
            confidence=round(confidence(evidence), 3),
            reason=self._reason(kind, costs, contrast, agreement),
        )
        return Found(pattern, stripes, agreement, evidence)

    def _between_occurrences(
        self, occurrences: Segmentation, stripes: Sequence[Stripe]
    ) -> dict[tuple[int, int], np.ndarray]:
        """What the stripes say of each two occurrences; of several pieces the longest."""
        from leitmotion.discovery._overlay_kernels import warped

        pieces: dict[tuple[int, int], np.ndarray] = {}
        for stripe in stripes:
            frames = np.round(stripe.path * self.ratio).astype(np.int64)
            for joined, piece in cut_at_occurrences(frames, occurrences).items():
                if piece.stop - piece.start > len(pieces.get(joined, ())):
                    pieces[joined] = stripe.path[piece]
        spans = list(zip(occurrences.starts / self.ratio, occurrences.stops / self.ratio, strict=True))
        last = len(self.distances)
        missing = (pair for pair in _neighbours_first(len(spans)) if pair not in pieces)
        for i, j in islice(missing, PAIRS):
            rows, columns = (
                range(int(np.ceil(a)), min(last, int(np.ceil(b)))) for a, b in (spans[i], spans[j])
            )
            if not 0 < len(rows) * len(columns) <= HELD:
                continue
            cost, path = warped(
                self.distances.across,
                rows.start,
                rows.stop,
                columns.start,
                columns.stop,
                self.distances.width,
            )
            if cost < AGREED * self.max_distance:
                pieces[i, j] = path
        return pieces

    def _traced(self, name: str, paths: Sequence[np.ndarray], stops: np.ndarray) -> list[PatternPair]:
        """Paths in frames: one point a moment of the working rate, and the last frame of the last moment."""
        if not paths:
            return []
        lengths = np.array([len(path) for path in paths])
        points = np.concatenate(paths)
        apart = self.distances.along(points).astype(np.float64)
        firsts = np.cumsum(lengths) - lengths
        seen = np.add.reduceat(np.isfinite(apart).astype(np.int64), firsts)
        costs = np.add.reduceat(np.nan_to_num(apart), firsts) / seen * self.scale
        ends = np.cumsum(lengths)
        lasts = points[ends - 1]
        lasts = np.maximum((lasts + 1) * self.ratio - 1, lasts * self.ratio)
        frames = np.round(np.insert(points * self.ratio, ends, lasts, axis=0)).astype(np.int64)
        frames = np.minimum(frames, np.repeat(np.asarray(stops) - 1, lengths + 1, axis=0))
        frames.flags.writeable = False
        pieces = np.split(frames, (ends + np.arange(1, len(ends) + 1))[:-1])
        return [PatternPair(name, piece, cost) for piece, cost in zip(pieces, costs.tolist(), strict=True)]

    def _compare(self, occurrences: Sequence[tuple[float, float]]) -> tuple[np.ndarray, np.ndarray]:
        """Align pairs of occurrences, neighbours first: mean distances (K,), and which pairs (K, 2)."""
        pairs = _compared(len(occurrences))
        costs = []
        for i, j in pairs:
            costs.append(overlay_of_spans(self.distances, occurrences[i], occurrences[j], self.max_distance))
        return np.array(costs), pairs

    def _within(self, stripes: Sequence[Stripe], spans: Sequence[tuple[float, float]]) -> list[Stripe]:
        """The parts of stripes that lie in some stretches."""
        inside = np.zeros(len(self.distances), bool)
        for start, stop in spans:
            inside[max(0, int(np.ceil(start))) : int(np.ceil(stop))] = True
        paths = [part(s, inside[s.path[:, 0]] & inside[s.path[:, 1]]) for s in stripes]
        return [piece for piece in measure(paths, self.distances, self.alike) if piece is not None]

    def _segmentation(self, spans: Sequence[tuple[float, float]], scores: np.ndarray) -> Segmentation:
        borders = np.clip(np.round(np.array(spans) * self.ratio).astype(np.int64), 0, self.frames)
        starts, stops = borders[:, 0], borders[:, 1]
        stops[:-1] = np.minimum(stops[:-1], np.maximum(starts[1:], starts[:-1] + 1))
        return Segmentation(starts, stops, ("",) * len(starts), scores, self.rate)

    def _reason(self, kind: str, costs: np.ndarray, contrast: float, agreement: float) -> str:
        what = "cycles" if kind == "cyclic" else "occurrences"
        apart = f"{what} are {self._length(float(np.mean(costs)))} apart on average"
        clear = f", {1 / (1 - contrast):.1f} times nearer than their surroundings" if 0 < contrast < 1 else ""
        odd = f"; {1 - agreement:.0%} of the pairs are not alike" if agreement < 1 else ""
        return apart + clear + odd

    def _length(self, distance: float) -> str:
        return length_in_words(distance, self.scale, self.unit)


def length_in_words(distance: float, scale: float, unit: str) -> str:
    """Distance in words that a body understands.

    Parameters
    ----------
    distance : float
        Body sizes, or radians.
    scale : float
        What one of these is in the recording's own unit.
    unit : str
        That unit.

    Returns
    -------
    str
        Degrees of directions, centimetres where the recording has metres, else a share of the body size.
    """
    if unit == "rad":
        return f"{np.degrees(distance * scale):.0f} degrees"
    return f"{distance * scale * 100:.1f} cm" if unit == "m" else f"{distance:.1%} of the body size"


def joined_spans(spans: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Join stretches that follow one another without a break.

    Parameters
    ----------
    spans : sequence of (float, float)
        Start and stop, in order, without overlap.

    Returns
    -------
    list of (float, float)
        Fewer where some were joined.
    """
    joined = [spans[0]]
    for before, after in pairwise(spans):
        if after[0] - before[1] <= TOUCH * (after[0] - before[0]):
            joined[-1] = (joined[-1][0], after[1])
        else:
            joined.append(after)
    return joined


def _compared(count: int) -> np.ndarray:
    """Which of so many occurrences are compared, (K, 2): all pairs, neighbours first, or some at even steps."""
    total = count * (count - 1) // 2
    order = np.arange(total)
    if total > COMPARED:
        rest = np.linspace(count - 1, total - 1, COMPARED - min(COMPARED // 2, count - 1)).astype(int)
        order = np.concatenate((np.arange(count - 1), rest))
    before = np.cumsum([0, *range(count - 1, 0, -1)])  # pairs that stand less far apart than 1, 2, ...
    apart = np.searchsorted(before, order, side="right")
    first = order - before[apart - 1]
    return np.stack((first, first + apart), axis=1)


def _neighbours_first(count: int) -> Iterator[tuple[int, int]]:
    """All pairs of so many occurrences, those that follow soonest first."""
    return ((i, i + apart) for apart in range(1, count) for i in range(count - apart))


def _named(pattern: Pattern, name: str) -> Pattern:
    spans = {
        what: value.replace(labels=(name,) * len(value))
        for what, value in (("occurrences", pattern.occurrences), ("stretches", pattern.stretches))
    }
    return pattern.replace(id=name, **spans)


def _filled(pattern: Pattern) -> int:
    return int((pattern.stretches.stops - pattern.stretches.starts).sum())
