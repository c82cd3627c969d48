"""The default way to find patterns: stripes by local alignment, families of cycles, returns.

Conventions
-----------
Everything is searched at one working rate and measured in body sizes, so that the answer is the same at any frame
rate, in any unit and for any body. Moments are of the working rate, frames of the recording.

References
----------
Paper P (Tang, Leung, Komura, Shum, 2008), whose steps stay recognisable: posture matrix, traced paths, families of
aligned paths, cycles. docs/papers/P.md tells where and why this differs.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from leitmotion.discovery.cuts import CUTS, cutter
from leitmotion.discovery.families import Run, cyclic_runs
from leitmotion.discovery.pattern import Pattern, PatternPair, Patterns, cut_at_occurrences, letter
from leitmotion.discovery.refine import Refiner
from leitmotion.discovery.returns import Return, returns_of
from leitmotion.discovery.stripes import Likeness, Stripe, likeness, measure, part
from leitmotion.discovery.themes import Theme, themes_of
from leitmotion.discovery.tracing import trace_stripes
from leitmotion.features.resampling import resample
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.segmentation import Segmentation
from leitmotion.similarity import Distances, align

WORKING_RATE = 30.0  # hertz
MAX_DISTANCE = 0.08  # body sizes: mean distance of the joints of two postures that are alike
MIN_AMPLITUDE = 0.012  # body sizes: what the joints must move, on average, not to be still
MIN_CONTRAST = 0.4  # a stripe must be this much nearer than its surroundings
MIN_PERIOD_S = 0.25
MIN_AGREEMENT = 0.5  # of the pairs of occurrences must be alike
MISS_S = 600.0  # what comes nearest is looked for among stretches this far apart
COMPARED = 60  # pairs of occurrences that are aligned to judge a pattern


def find_recurrences(
    features: FeatureSequence,
    *,
    max_distance: float = MAX_DISTANCE,
    min_duration_s: float = 0.5,
    min_amplitude: float = MIN_AMPLITUDE,
    min_contrast: float = MIN_CONTRAST,
    stillness: bool = False,
    cuts: str = "stripes",
) -> Patterns:
    """Find what recurs, without a parameter to set.

    Parameters
    ----------
    features : FeatureSequence
        Postures in body sizes, T frames; see :func:`leitmotion.features.posture`.
    max_distance : float
        Mean distance of the joints below which two postures are alike, body sizes.
    min_duration_s : float
        Shortest stretch that counts as coming back, seconds.
    min_amplitude : float
        How far the joints must move within a second, on average, not to be still, body sizes.
    min_contrast : float
        How much nearer than its surroundings a return must be, 0 to 1.
    stillness : bool
        Whether a posture that is held again counts as a pattern.
    cuts : {"stripes", "members", "autocorrelation"}
        What cuts a run into cycles: the stripe of one period; the same, moved to where the members of the family start
        and end; or paper P, eq. 5.

    Returns
    -------
    Patterns
        The pattern that fills most time first.

    Raises
    ------
    ParameterError
        When a parameter is out of range.
    """
    for name, value in (("max_distance", max_distance), ("min_duration_s", min_duration_s)):
        if not 0 < value < np.inf:
            raise ParameterError(f"{name} must be positive and finite, got {value}.")
    if not 0 <= min_amplitude < np.inf:
        raise ParameterError(f"min_amplitude must be 0 or more and finite, got {min_amplitude}.")
    if not 0 <= min_contrast < 1:
        raise ParameterError(f"min_contrast must lie in [0, 1), got {min_contrast}.")
    if cuts not in CUTS:
        raise ParameterError(f"cuts must be one of {', '.join(CUTS)}, got {cuts!r}.")
    parameters: dict[str, object] = {
        "method": "recurrence", "working_rate_hz": WORKING_RATE,
        "max_distance": max_distance, "max_distance_own_unit": max_distance * features.scale, "unit": features.unit,
        "min_duration_s": min_duration_s, "min_amplitude": min_amplitude, "min_contrast": min_contrast,
        "stillness": stillness, "cuts": cuts, "features": list(features.names),
    }  # fmt: skip
    work = resample(features, WORKING_RATE)
    if len(work) < 2 * min_duration_s * WORKING_RATE:
        miss = (
            f"The recording lasts {len(features) / features.rate:.1f} s, "
            f"too short for two stretches of {min_duration_s:g} s."
        )
        return Patterns((), (), features.rate, parameters, miss)
    distances = Distances(work)
    alike = likeness(distances, max_distance=max_distance, min_amplitude=min_amplitude)
    traced = trace_stripes(distances, alike, max_distance=max_distance, min_duration_s=min_duration_s)
    parameters |= traced.limits
    shortest = round(min_duration_s * WORKING_RATE)
    stripes = [
        s for s in traced.stripes if s.contrast >= min_contrast and s.lag >= MIN_PERIOD_S * WORKING_RATE
    ]
    runs = cyclic_runs(stripes, cutter(cuts, alike.speed, work.values))
    themes = themes_of(runs, stripes)
    refine = Refiner(features, WORKING_RATE, max_distance)
    for theme in themes:
        theme.runs = _settled([refine.run(run) for run in theme.runs])
    returns = returns_of(themes, stripes, distances, alike, shortest=shortest, min_contrast=min_contrast)
    for item in returns:
        item.spans = refine.spans(item.spans)

    scribe = _Scribe(features, distances, alike, max_distance)
    found = [scribe.cyclic(theme) for theme in themes] + [scribe.acyclic(item) for item in returns]
    found = [item for item in found if item.agreement >= MIN_AGREEMENT]
    if stillness:
        found += [scribe.held(spans) for spans in _held_postures(distances, alike, max_distance, shortest)]
    found.sort(key=lambda item: -_filled(item.pattern))
    named = [item.named(letter(k)) for k, item in enumerate(found)]
    return Patterns(
        tuple(item.pattern for item in named),
        tuple(pair for item in named for pair in item.pairs),
        features.rate,
        parameters,
        "" if named else _nearest_miss(distances, alike, features, parameters),
        tuple(stripe for item in named for stripe in item.stripes),
    )


class _Found(NamedTuple):
    """A pattern with what shows it."""

    pattern: Pattern
    pairs: list[PatternPair]
    stripes: list[PatternPair]
    agreement: float  # share of the pairs of occurrences that are alike

    def named(self, name: str) -> _Found:
        spans = {
            what: value.replace(labels=(name,) * len(value))
            for what in ("occurrences", "stretches")
            for value in [getattr(self.pattern, what)]
        }
        return _Found(
            self.pattern.replace(id=name, **spans),
            [pair.replace(pattern=name) for pair in self.pairs],
            [stripe.replace(pattern=name) for stripe in self.stripes],
            self.agreement,
        )


class _Scribe:
    """Writes themes and returns down as nouns, in frames and in the recording's own unit."""

    def __init__(
        self, features: FeatureSequence, distances: Distances, alike: Likeness, max_distance: float
    ) -> None:
        self.ratio = features.rate / WORKING_RATE
        self.frames = len(features)
        self.rate = features.rate
        self.scale = features.scale
        self.unit = features.unit
        self.distances = distances
        self.alike = alike
        self.max_distance = max_distance

    def cyclic(self, theme: Theme) -> _Found:
        cycles = [
            (a, b) for run in theme.runs for a, b in zip(run.borders[:-1], run.borders[1:], strict=True)
        ]
        extents = [(run.start, run.stop) for run in theme.runs]
        shown = self._within(theme)
        return self._write("cyclic", cycles, extents, shown)

    def acyclic(self, found: Return) -> _Found:
        return self._write("acyclic", found.spans, found.spans, found.stripes)

    def held(self, spans: list[tuple[float, float]]) -> _Found:
        pattern, *_ = self._write("acyclic", spans, spans, [])
        return _Found(pattern.replace(reason="a posture that is held again, without movement"), [], [], 1.0)

    def _write(
        self,
        kind: str,
        occurrences: Sequence[tuple[float, float]],
        extents: Sequence[tuple[float, float]],
        stripes: Sequence[Stripe],
    ) -> _Found:
        costs, pairs = self._compare(occurrences)
        scores = [
            float(
                np.clip(1.0 - np.median(costs[(pairs == k).any(axis=1)]) / (2 * self.max_distance), 0.0, 1.0)
            )
            for k in range(len(occurrences))
        ]
        agreement = float(np.mean(costs < self.max_distance))
        contrast = float(np.mean([s.contrast for s in stripes])) if stripes else 0.0
        clarity = float(np.clip(contrast / 0.75, 0.0, 1.0)) if stripes else agreement
        spans = self._segmentation(occurrences, np.array(scores))
        pattern = Pattern(
            id="?",
            kind=kind,
            occurrences=spans,
            stretches=self._segmentation(extents, np.full(len(extents), np.nan)),
            period_s=float(np.median(spans.stops - spans.starts)) / self.rate,
            cost=float(np.mean(costs)) * self.scale,
            confidence=round(float(np.sqrt(clarity * agreement)) * _evidence(len(stripes)), 3),
            reason=self._reason(kind, costs, contrast, agreement),
        )
        traced = [self._pair(stripe.path, self.frames) for stripe in stripes]
        return _Found(pattern, self._pairs(spans, stripes), traced, agreement)

    def _pairs(self, occurrences: Segmentation, stripes: Sequence[Stripe]) -> list[PatternPair]:
        """What the stripes say of each two occurrences; of several pieces the longest."""
        pieces: dict[tuple[int, int], np.ndarray] = {}
        for stripe in stripes:
            frames = np.round(stripe.path * self.ratio).astype(np.int64)
            for joined, piece in cut_at_occurrences(frames, occurrences).items():
                if len(stripe.path[piece]) > len(pieces.get(joined, ())):
                    pieces[joined] = stripe.path[piece]
        return [self._pair(path, occurrences.stops[list(joined)]) for joined, path in sorted(pieces.items())]

    def _pair(self, path: np.ndarray, stop: np.ndarray | int) -> PatternPair:
        """One point a moment of the working rate, and the last frame of the last moment."""
        last = np.maximum((path[-1:] + 1) * self.ratio - 1, path[-1:] * self.ratio)
        frames = np.round(np.concatenate((path * self.ratio, last))).astype(np.int64)
        cost = float(np.nanmean(self.distances.along(path)))
        return PatternPair("?", np.minimum(frames, np.asarray(stop) - 1), cost * self.scale)

    def _compare(self, occurrences: Sequence[tuple[float, float]]) -> tuple[np.ndarray, np.ndarray]:
        """Align pairs of occurrences, neighbours first: mean distances (K,), and which pairs (K, 2)."""
        pairs = _compared(len(occurrences))
        costs = []
        for i, j in pairs:
            rows, columns = (_moments(occurrences[k], len(self.distances)) for k in (i, j))
            costs.append(self._cost(self.distances.between(rows, columns)))
        return np.array(costs), pairs

    def _cost(self, apart: np.ndarray) -> float:
        """Mean distance of two occurrences laid over one another; moments that were not seen are left out."""
        seen = ~np.isnan(apart)
        if not seen.any():
            return self.max_distance
        apart = apart[np.ix_(seen.any(axis=1), seen.any(axis=0))]
        return float(align(np.where(np.isnan(apart), self.max_distance, apart)).cost)

    def _within(self, theme: Theme) -> list[Stripe]:
        """The parts of a theme's stripes that lie in its stretches."""
        inside = theme.holds(len(self.distances))
        paths = [part(s, inside[s.path[:, 0]] & inside[s.path[:, 1]]) for s in theme.stripes]
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
        Body sizes.
    scale : float
        What one body size is in the recording's own unit.
    unit : str
        That unit.

    Returns
    -------
    str
        Centimetres where the recording has metres, else a share of the body size.
    """
    return f"{distance * scale * 100:.1f} cm" if unit == "m" else f"{distance:.1%} of the body size"


def _evidence(stripes: int) -> float:
    """One stripe may be chance, several hardly: 0.8 for one, 0.89 for two, towards 1."""
    return max(stripes, 1) / (max(stripes, 1) + 0.25)


def _moments(span: tuple[float, float], moments: int) -> range:
    start = int(np.floor(span[0]))
    return range(start, min(moments, max(start + 2, round(span[1]))))


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


def _settled(runs: Sequence[Run]) -> list[Run]:
    """Runs of one theme without overlap: a later run gives up the cycles that begin before the earlier one ends."""
    settled: list[Run] = []
    for run in sorted(runs, key=lambda run: run.start):
        if settled and run.start < settled[-1].stop:
            last = settled[-1]
            borders = [b for b in run.borders if b >= last.borders[-1]]
            if len(borders) < 2:
                last.stop = max(last.stop, run.stop)
                continue
            last.stop = min(last.stop, borders[0])
            run = Run(max(run.start, last.stop), run.stop, run.period, run.stripes, run.support, borders)
        settled.append(run)
    return settled


def _held_postures(
    distances: Distances, alike: Likeness, max_distance: float, shortest: int
) -> list[list[tuple[float, float]]]:
    """Stretches in which the body keeps still, grouped by posture; groups of two or more."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], alike.still.astype(np.int8), [0])))).reshape(-1, 2)
    spans = [(int(a), int(b)) for a, b in edges if b - a >= shortest]
    groups: list[list[tuple[float, float]]] = []
    for span in spans:
        middle = (span[0] + span[1]) // 2
        for group in groups:
            other = int(group[0][0] + group[0][1]) // 2
            if distances.along(np.array([(middle, other)]))[0] < max_distance:
                group.append(span)
                break
        else:
            groups.append([span])
    return [group for group in groups if len(group) >= 2]


def _filled(pattern: Pattern) -> int:
    return int((pattern.stretches.stops - pattern.stretches.starts).sum())


def _nearest_miss(
    distances: Distances, alike: Likeness, features: FeatureSequence, asked: dict[str, Any]
) -> str:
    """Say what came nearest when nothing was found: search once more, twice as generously.

    Empty where nothing comes near even so.
    """
    if alike.still.all():
        return "The body keeps still all the time, and stillness does not count as a repeat."
    generous = 2 * asked["max_distance"]
    alike = likeness(distances, max_distance=generous, min_amplitude=asked["min_amplitude"], share=1.0)
    near = trace_stripes(
        distances, alike, max_distance=generous, min_duration_s=asked["min_duration_s"], horizon_s=MISS_S
    ).stripes
    if not near:
        return ""
    best = max(
        near, key=lambda s: min(s.contrast / asked["min_contrast"], 2 - s.cost / asked["max_distance"])
    )
    a, b = (tuple(moment / WORKING_RATE for moment in span) for span in (best.a, best.b))
    apart = length_in_words(best.cost, features.scale, features.unit)
    times = best.background / best.cost if best.cost > 0 else np.inf
    clear = f"{times:.1f} times" if times > 1.05 else "no"
    return (
        f"The nearest: {a[0]:.1f} to {a[1]:.1f} s and {b[0]:.1f} to {b[1]:.1f} s are {apart} apart on average, "
        f"{clear} nearer than their surroundings, which is not near or not clear enough."
    )
