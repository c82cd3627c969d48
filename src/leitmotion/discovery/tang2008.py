"""Patterns after paper P, to the letter: trace diagonals of the posture matrix, align them, cut cycles.

Conventions
-----------
The work is done at the paper's rate. ``C (n, n)`` is the posture matrix scaled to [0, 1]. A *trace* is a pair of
similar segments found in C: the earlier lies along y, the later along x, y < x. Frames of traces are moments of
the paper's rate; what is returned is in frames of the recording.

References
----------
Paper P: Tang, Leung, Komura, Shum, "Finding repetitive patterns in 3D human motion captured data", 2008. What
its text leaves open, and how it was read here, stands in ``docs/papers/P.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.autocorrelation import cycle_lags
from leitmotion.discovery.pattern import Pattern, PatternPair, Patterns, cut_at_occurrences, letter
from leitmotion.features.resampling import resample
from leitmotion.features.sequence import FeatureSequence
from leitmotion.motion.errors import ParameterError
from leitmotion.motion.segmentation import Segmentation
from leitmotion.similarity import align, self_distance

REACH_S = 0.05  # how far regions A and B of figure 8 (b) reach: the paper gives no size
SAME_DURATION = 2.0  # cycles and acyclic segments are of one duration within the slope that tracing allows


class Trace(NamedTuple):
    """A pair of similar segments: the optimal path of figure 8 (d)."""

    path: np.ndarray
    """(K, 2) int: moments y of the earlier and x of the later segment, never decreasing."""
    cost: float
    """Mean of C along the path."""

    @property
    def s_min(self) -> int:
        """Where the earlier segment starts."""
        return int(self.path[0, 0])

    @property
    def e_max(self) -> int:
        """Where the later segment ends (exclusive)."""
        return int(self.path[-1, 1]) + 1

    @property
    def segments(self) -> tuple[tuple[int, int], tuple[int, int]]:
        """The earlier and the later segment, half-open."""
        (y0, x0), (y1, x1) = self.path[0].tolist(), self.path[-1].tolist()
        return (y0, y1 + 1), (x0, x1 + 1)


class Found(NamedTuple):
    """A pattern in moments of the paper's rate."""

    kind: str
    occurrences: list[tuple[int, int]]
    stretches: list[tuple[int, int]]
    traces: list[Trace]
    how: str


def find_patterns_tang2008(
    features: FeatureSequence,
    *,
    threshold: float = 0.26,
    first_window_s: float = 0.5,
    next_window_s: float = 0.83,
    min_duration_s: float = 0.5,
    dtw_threshold: float = 0.5,
    cluster_tolerance: float = 0.05,
    rate_hz: float = 60.0,
) -> Patterns:
    """Find cyclic and acyclic patterns the way of paper P.

    Parameters
    ----------
    features : FeatureSequence
        Postures freed of place and yaw, T frames (paper P, section 2.1).
    threshold : float
        T of section 2.3.1: postures nearer than this share of the clip's largest distance are similar.
    first_window_s, next_window_s : float
        Windows of section 2.3.3, seconds (30 and 50 frames at 60 Hz).
    min_duration_s : float
        Shortest segment that counts, seconds.
    dtw_threshold : float
        Dearest continuation of a trace, of the clip's largest distance per step of its path.
    cluster_tolerance : float
        Traces whose ends differ by less than this share of their duration are one family (eqs. 3 and 4).
    rate_hz : float
        The rate to work at, hertz: the paper's laboratory recorded at 60.

    Returns
    -------
    Patterns
        A family of several traces is cyclic, cut at the peaks of eq. 5; single traces are acyclic, grouped by
        likeness and duration. `confidence` is 1 - (mean cost of its traces) / threshold.

    Raises
    ------
    ParameterError
        When a parameter is not positive.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.arange(600) / 60
    >>> circle = np.stack([np.cos(2 * np.pi * t), np.sin(2 * np.pi * t), 0 * t], axis=1)
    >>> found = find_patterns_tang2008(FeatureSequence(circle, ("hand",), rate=60, width=3))
    >>> [(pattern.kind, pattern.cycles, round(pattern.period_s, 2)) for pattern in found.patterns]
    [('cyclic', 10, 1.0)]
    """
    _check_positive(locals())
    work = resample(features, rate_hz)
    C, largest = _scaled(self_distance(work).values)
    shortest = max(2, round(min_duration_s * rate_hz))
    windows = max(1, round(first_window_s * rate_hz)), max(1, round(next_window_s * rate_hz))
    reach = max(1, round(REACH_S * rate_hz))

    traced = _trace_patterns(C, threshold, windows, dtw_threshold, shortest, reach)
    traces = _distinct(traced, len(C), shortest, reach)
    families = _cluster(traces, cluster_tolerance)
    found, single = _cut_cycles(families, work.values, shortest, cluster_tolerance)
    found += _group(single, C, threshold)

    scribe = _Scribe(
        features.rate, len(features), rate_hz, threshold, largest * features.scale, features.unit
    )
    patterns, pairs, stripes = scribe.write(found, C)
    parameters: dict[str, object] = {
        "method": "tang2008", "working_rate_hz": rate_hz,
        "threshold": threshold, "max_distance_own_unit": threshold * largest * features.scale,
        "unit": features.unit, "first_window_s": first_window_s, "next_window_s": next_window_s,
        "min_duration_s": min_duration_s, "dtw_threshold": dtw_threshold,
        "cluster_tolerance": cluster_tolerance, "features": list(features.names),
        "traces": len(traces), "families": sum(len(family) > 1 for family in families),
    }  # fmt: skip
    miss = "" if patterns else _nearest_miss(traced, shortest, threshold, rate_hz)
    return Patterns(patterns, pairs, features.rate, parameters, miss, stripes)


def _check_positive(parameters: dict[str, object]) -> None:
    for name, value in parameters.items():
        if isinstance(value, (int, float)) and not value > 0:
            raise ParameterError(f"{name} must be positive, got {value}.")


def _scaled(distances: np.ndarray) -> tuple[np.ndarray, float]:
    """Scale to [0, 1] over the clip (section 2.2.2); also gives the largest distance."""
    largest = float(np.fmax.reduce(distances, axis=None, initial=0.0))
    return (distances / np.float32(largest) if largest > 0 else distances), largest


def _trace_patterns(
    C: np.ndarray, threshold: float, windows: tuple[int, int], dtw_threshold: float, apart: int, reach: int
) -> list[Trace]:
    """Thin the binary cloud, find start points and trace from each not yet passed (section 2.3).

    A start point that an earlier trace ran over lies behind a bridged gap and is bypassed.
    """
    from leitmotion.discovery import _tang_kernels

    minima = np.zeros(C.shape, np.bool_)
    _tang_kernels.thin(C, threshold, apart, minima)
    passed = np.zeros(C.shape, np.bool_)
    traces = []
    for x, y in _tang_kernels.start_points(minima, reach):
        if not passed[x, y]:
            points = _tang_kernels.trace(C, minima, x, y, apart, *windows, dtw_threshold)
            trace = _optimal_path(C, np.array(points), apart)
            _mark(passed, trace, reach)
            traces.append(trace)
    return traces


def _optimal_path(C: np.ndarray, points: np.ndarray, apart: int) -> Trace:
    """Join the points of a trace by the DTW path of each leg (figure 8 (d))."""
    legs = [points[:1, ::-1]]
    for (x0, y0), (x1, y1) in pairwise(points):
        lag = np.arange(x0, x1 + 1) - np.arange(y0, y1 + 1)[:, None]
        leg = align(np.where(lag >= apart, C[y0 : y1 + 1, x0 : x1 + 1], np.nan)).path[1:]
        legs.append(np.add(leg, (y0, x0)))
    path = np.concatenate(legs)
    return Trace(path, float(C[path[:, 0], path[:, 1]].mean()))


def _mark(passed: np.ndarray, trace: Trace, reach: int) -> None:
    """Mark what lies within region B's height of the path, in every column."""
    y, x = trace.path.T
    for dy in range(-2 * reach, 2 * reach + 1):
        passed[x, np.clip(y + dy, 0, len(passed) - 1)] = True


def _distinct(traces: Sequence[Trace], moments: int, shortest: int, reach: int) -> list[Trace]:
    """Keep traces long enough in both segments and, of those that run together, the longest."""
    long = [t for t in traces if min(stop - start for start, stop in t.segments) >= shortest]
    covered = np.zeros((moments, moments), np.bool_)
    kept = []
    for trace in sorted(long, key=lambda t: -len(t.path)):
        y, x = trace.path.T
        if covered[x, y].mean() <= 0.5:
            _mark(covered, trace, reach)
            kept.append(trace)
    return sorted(kept, key=lambda t: (t.segments[1], t.segments[0]))


def _cluster(traces: Sequence[Trace], tolerance: float) -> list[list[Trace]]:
    """Gather traces whose starts and ends are aligned into families (section 2.4, eqs. 3 and 4)."""
    families: list[list[Trace]] = []
    for trace in traces:
        best, chosen = np.inf, None
        for family in families:
            cost = float(np.mean([abs(p.s_min - trace.s_min) + abs(p.e_max - trace.e_max) for p in family]))
            duration = np.mean([p.e_max - p.s_min for p in family])
            if cost < tolerance * duration and cost < best:
                best, chosen = cost, family
        if chosen is None:
            families.append([trace])
        else:
            chosen.append(trace)
    return families


def _cut_cycles(
    families: Sequence[Sequence[Trace]], values: np.ndarray, shortest: int, tolerance: float
) -> tuple[list[Found], list[Trace]]:
    """Cut each cyclic family at the peaks of eq. 5 (section 2.5); also gives the traces that are acyclic.

    A cyclic family fills a right-angled triangle down to the diagonal (figure 10 (a)): the two segments of one
    of its traces touch, time repeats without a break. Two cycles leave but one such trace. Where eq. 5 has no
    peak there is one cycle, which is no repetition. Traces of no cyclic family are acyclic if they stand apart.
    """
    found, single = [], []
    for family in families:
        start, stop = min(t.s_min for t in family), max(t.e_max for t in family)
        continuous = any(_touches(trace, tolerance) for trace in family)
        lags = cycle_lags(values[start:stop], shortest) if continuous else []
        if lags:
            borders = [start, *(start + lag for lag in lags), stop]
            how = "one trace onto itself" if len(family) == 1 else f"{len(family)} aligned traces"
            found.append(Found("cyclic", _whole(list(pairwise(borders))), [(start, stop)], list(family), how))
        else:
            single += [trace for trace in family if not _touches(trace, tolerance)]
    return found, single


def _whole(cycles: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Leave out what is not of the duration of most cycles: a rest of the family, before or after its last peak."""
    usual = float(np.median([stop - start for start, stop in cycles]))
    kept = [(a, b) for a, b in cycles if 1 / SAME_DURATION <= (b - a) / usual <= SAME_DURATION]
    return kept if len(kept) >= 2 else cycles


def _touches(trace: Trace, tolerance: float) -> bool:
    """Whether the later segment starts where the earlier ends, as nearly as ends are aligned, or before."""
    (_, stop), (start, _) = trace.segments
    return start - stop <= tolerance * (trace.e_max - trace.s_min)


def _group(traces: Sequence[Trace], C: np.ndarray, threshold: float) -> list[Found]:
    """Group acyclic traces whose segments are alike and of like duration (section 2.5, last paragraph)."""
    groups: list[list[Trace]] = []
    for trace in sorted(traces, key=lambda t: -len(t.path)):
        for group in groups:
            if _is_same_movement(trace, group[0], C, threshold):
                group.append(trace)
                break
        else:
            groups.append([trace])
    found = []
    for group in groups:
        occurrences = _apart([segment for trace in group for segment in trace.segments])
        how = f"{len(group)} trace{'s' * (len(group) > 1)} between stretches apart"
        found.append(Found("acyclic", occurrences, occurrences, group, how))
    return found


def _is_same_movement(trace: Trace, other: Trace, C: np.ndarray, threshold: float) -> bool:
    (a0, a1), (b0, b1) = trace.segments[0], other.segments[0]
    if not 1 / SAME_DURATION <= (a1 - a0) / (b1 - b0) <= SAME_DURATION:
        return False
    return align(C[a0:a1, b0:b1]).cost < threshold


def _apart(segments: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """Keep segments that do not overlap, the longest first: a noun's occurrences stand apart."""
    kept: list[tuple[int, int]] = []
    for start, stop in sorted(segments, key=lambda s: (s[0] - s[1], s)):
        if all(stop <= a or b <= start for a, b in kept):
            kept.append((start, stop))
    return sorted(kept)


def _nearest_miss(traced: Sequence[Trace], shortest: int, threshold: float, rate: float) -> str:
    share = f"{threshold:.0%} of the recording's largest distance"
    if not traced:
        return f"No two moments that follow on one another stay within {share}."
    longest = max(min(stop - start for start, stop in trace.segments) for trace in traced)
    if longest < shortest:
        return f"The longest likeness within {share} lasts {longest / rate:.2f} s, under {shortest / rate:.2f} s."
    return f"The longest likeness within {share} lasts {longest / rate:.2f} s, but nothing in it repeats."


class _Scribe:
    """Writes what was found at the paper's rate as nouns in frames of the recording."""

    def __init__(
        self, rate: float, frames: int, working_rate: float, threshold: float, largest: float, unit: str
    ) -> None:
        self.rate, self.frames, self.ratio = rate, frames, rate / working_rate
        self.threshold, self.largest, self.unit = threshold, largest, unit

    def write(
        self, found: Sequence[Found], C: np.ndarray
    ) -> tuple[tuple[Pattern, ...], tuple[PatternPair, ...], tuple[PatternPair, ...]]:
        """Name patterns by the time they fill, most first; with their pairs of occurrences and their traces."""
        by_time = sorted(found, key=lambda f: (-sum(b - a for a, b in f.stretches), f.stretches))
        patterns, pairs, stripes = [], [], []
        for k, one in enumerate(by_time):
            stretches = self._frames_of(one.stretches, np.full(len(one.stretches), np.nan), letter(k))
            patterns.append(self._pattern(letter(k), one, stretches, C))
            pairs += self._pairs(letter(k), one, patterns[-1].occurrences, C)
            stripes += self._stripes(letter(k), one, stretches)
        return tuple(patterns), tuple(pairs), tuple(stripes)

    def _pattern(self, name: str, one: Found, stretches: Segmentation, C: np.ndarray) -> Pattern:
        cost = float(np.mean([trace.cost for trace in one.traces]))
        occurrences = self._frames_of(one.occurrences, self._likeness(one.occurrences, C), name)
        return Pattern(
            id=name,
            kind=one.kind,
            occurrences=occurrences,
            stretches=stretches.replace(scores=_means_within(occurrences, stretches)),
            period_s=float(np.median(occurrences.stops - occurrences.starts)) / self.rate,
            cost=cost * self.largest,
            confidence=float(np.clip(1 - cost / self.threshold, 0, 1)),
            reason=(
                f"{one.how}; their mean cost is {cost:.2f} of the recording's largest distance "
                f"(similar below {self.threshold:g})."
            ),
        )

    def _frames_of(self, spans: Sequence[tuple[int, int]], scores: np.ndarray, name: str) -> Segmentation:
        borders = np.minimum(np.rint(np.array(spans) * self.ratio), self.frames).astype(np.int64)
        return Segmentation(borders[:, 0], borders[:, 1], (name,) * len(spans), scores, self.rate)

    def _likeness(self, spans: Sequence[tuple[int, int]], C: np.ndarray) -> np.ndarray:
        """Mean over the others of 1 - (cost of aligning) / threshold, 0 to 1."""
        others = np.unique(np.linspace(0, len(spans) - 1, 12).round().astype(int))  # enough to judge by
        answer = np.empty(len(spans))
        for k, (a, b) in enumerate(spans):
            costs = [align(C[a:b, spans[o][0] : spans[o][1]]).cost for o in others if o != k]
            answer[k] = np.clip(1 - np.mean(costs) / self.threshold, 0, 1)
        return answer

    def _pairs(self, name: str, one: Found, occurrences: Segmentation, C: np.ndarray) -> list[PatternPair]:
        """What the traces say of each two occurrences; of several pieces the longest."""
        pieces: dict[tuple[int, int], np.ndarray] = {}
        for trace in one.traces:
            frames = np.rint(trace.path * self.ratio).astype(np.int64)
            for joined, piece in cut_at_occurrences(frames, occurrences).items():
                if len(trace.path[piece]) > len(pieces.get(joined, ())):
                    pieces[joined] = trace.path[piece]
        return [
            PatternPair(
                name,
                np.rint(path * self.ratio).astype(np.int64),
                float(np.nanmean(C[path[:, 0], path[:, 1]])) * self.largest,
            )
            for _, path in sorted(pieces.items(), key=lambda item: item[0])
        ]

    def _stripes(self, name: str, one: Found, stretches: Segmentation) -> list[PatternPair]:
        """Write each trace, cut to the two stretches that hold its middle."""
        pairs = []
        for trace in one.traces:
            path = np.rint(trace.path * self.ratio).astype(np.int64)
            middle = path[len(path) // 2]
            inside = np.ones(len(path), np.bool_)
            for side in (0, 1):
                holds = (stretches.starts <= middle[side]) & (middle[side] < stretches.stops)
                k = int(np.argmax(holds))
                inside &= holds.any()
                inside &= (path[:, side] >= stretches.starts[k]) & (path[:, side] < stretches.stops[k])
            if inside.any():
                pairs.append(PatternPair(name, path[inside], trace.cost * self.largest))
        return pairs


def _means_within(occurrences: Segmentation, stretches: Segmentation) -> np.ndarray:
    """Mean score of the occurrences in each stretch."""
    inside = (occurrences.starts >= stretches.starts[:, None]) & (
        occurrences.stops <= stretches.stops[:, None]
    )
    return np.array([occurrences.scores[row].mean() for row in inside])
