"""Families: stripes of one cyclic movement, the cycles they cut, and the stretches that are the same movement.

Conventions
-----------
Moments of the working rate; a run is a stretch of time in which a movement repeats without a break.

References
----------
Paper P, section 2.4: the stripes of one cyclic movement begin and end together (eq. 3), one per multiple of its period.
Two cycles give one stripe whose stretches touch; that is cyclic too, where the paper's rule (more than one stripe)
calls it acyclic. How a run is cut into cycles stands in :mod:`leitmotion.discovery.cuts`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from leitmotion.discovery.stripes import Stripe

TOUCH = 0.25  # a pause of a quarter of the lag still joins two cycles
ALIGNED = 0.6  # stripes whose joint extents overlap by this much (of their union) begin and end together
MULTIPLE = 0.6  # a longer period is a multiple where shorter ones fill this much of it
SAME_PERIOD = 1.5  # ratio of periods within which two runs may be one movement


@dataclass(eq=False)
class Run:
    """A stretch of time in which a movement repeats without a break."""

    start: float
    stop: float
    period: float
    stripes: list[Stripe]  # at one period
    support: list[Stripe] = field(default_factory=list)  # at any multiple of it
    borders: list[float] = field(default_factory=list)  # of its cycles, one more than there are cycles

    @property
    def cycles(self) -> int:
        """How many cycles the borders cut."""
        return max(0, len(self.borders) - 1)


def is_near(stripe: Stripe) -> bool:
    """Tell whether the two stretches of a stripe touch or overlap: the movement goes on without a break."""
    return stripe.b[0] - stripe.a[1] <= TOUCH * stripe.lag


def cyclic_runs(stripes: Sequence[Stripe], cut: Callable[[Run], list[float]]) -> list[Run]:
    """Group near stripes into runs and cut each into cycles.

    Parameters
    ----------
    stripes : sequence of Stripe
        Those to be explained; only near ones are.
    cut : callable
        Gives the borders of a run's cycles; see :mod:`leitmotion.discovery.cuts`.

    Returns
    -------
    list of Run
        In order of time, none overlapping another by half, each of at least two cycles.
    """
    runs = [_run_of(group) for group in _aligned(sorted(filter(is_near, stripes), key=lambda s: s.lag))]
    runs = _joined(_without_multiples(runs))
    for run in runs:
        run.borders = cut(run)
    runs = [run for run in runs if run.cycles >= 2]
    return sorted(_apart(runs), key=lambda run: run.start)


def overlap(a: tuple[float, float], b: tuple[float, float]) -> float:
    """Length that two stretches share.

    Parameters
    ----------
    a, b : (float, float)
        Start and stop.

    Returns
    -------
    float
        0 where they do not meet.
    """
    return max(0.0, min(a[1], b[1]) - max(a[0], b[0]))


def _aligned(near: list[Stripe]) -> list[list[Stripe]]:
    """Stripes whose joint extents [Smin, Emax) agree, the shortest lag first."""
    groups: list[list[Stripe]] = []
    starts, stops = np.zeros(len(near)), np.zeros(len(near))
    for stripe in near:
        start, stop = stripe.a[0], stripe.b[1]
        n = len(groups)
        shared = np.minimum(stops[:n], stop) - np.maximum(starts[:n], start)
        share = np.maximum(0, shared) / (np.maximum(stops[:n], stop) - np.minimum(starts[:n], start))
        best = len(share) - 1 - int(np.argmax(share[::-1])) if n else 0  # of equals the last
        if n and share[best] >= ALIGNED:
            groups[best].append(stripe)
            starts[best], stops[best] = min(starts[best], start), max(stops[best], stop)
        else:
            groups.append([stripe])
            starts[n], stops[n] = start, stop
    return groups


def _run_of(group: list[Stripe]) -> Run:
    clear = 0.75 * max(s.contrast for s in group)
    first = next(s for s in sorted(group, key=lambda s: s.lag) if s.contrast >= clear)
    fundamental = [s for s in group if s.lag < 1.4 * first.lag]
    return Run(
        start=min(s.a[0] for s in group), stop=max(s.b[1] for s in group),
        period=float(np.median([s.lag for s in fundamental])), stripes=fundamental, support=list(group),
    )  # fmt: skip


def _without_multiples(runs: list[Run]) -> list[Run]:
    """Drop runs at a multiple of a shorter period, and small repeats inside one cycle of a larger one."""
    by_period = sorted(runs, key=lambda run: -run.period)
    kept = np.ones(len(runs), bool)
    starts, stops, periods = (
        np.array([getattr(run, what) for run in by_period]) for what in ("start", "stop", "period")
    )
    for k, long in enumerate(by_period):
        if not kept[k]:
            continue  # lies inside a longer one
        shared = np.minimum(stops, long.stop) - np.maximum(starts, long.start)
        enough = np.maximum(0, shared) >= 0.7 * (stops - starts)
        inside = np.flatnonzero(kept & (periods < long.period / 1.4) & enough)
        if not inside.size:
            continue
        end = int(np.ceil(long.stop)) + 1
        covered = _covered([(int(starts[i]), min(int(stops[i]), end)) for i in inside], int(long.start))
        if covered >= MULTIPLE * (long.stop - long.start):
            kept[k] = False
            for i in inside:
                by_period[i].support.extend(long.support)
        else:
            kept[inside] = False
    return [run for run, keep in zip(by_period, kept, strict=True) if keep]


def _covered(spans: Sequence[tuple[int, int]], start: int) -> int:
    """Length of the union of stretches from a start on."""
    total, reached = 0, start
    for first, stop in sorted(spans):
        total += max(0, stop - max(first, reached))
        reached = max(reached, stop)
    return total


def _joined(runs: list[Run]) -> list[Run]:
    """Join runs of one period that overlap or follow without a break."""
    joined: list[Run] = []
    for run in sorted(runs, key=lambda run: run.start):
        last = joined[-1] if joined else None
        if (
            last is not None
            and run.start - last.stop <= 0
            and max(run.period, last.period) <= SAME_PERIOD * min(run.period, last.period)
            and overlap((run.start, run.stop), (last.start, last.stop)) >= 0.5 * min(run.period, last.period)
        ):
            last.stop = max(last.stop, run.stop)
            last.stripes += run.stripes
            last.support += run.support
            last.period = float(np.median([s.lag for s in last.stripes]))
        else:
            joined.append(run)
    return joined


def _apart(runs: list[Run]) -> list[Run]:
    """Of runs that overlap by half of the shorter, keep the one whose stripes gain most."""
    kept: list[Run] = []
    starts, stops = np.zeros(len(runs)), np.zeros(len(runs))
    for run in sorted(runs, key=lambda run: -sum(s.gain for s in run.support)):
        n = len(kept)
        shared = np.minimum(stops[:n], run.stop) - np.maximum(starts[:n], run.start)
        shorter = np.minimum(stops[:n] - starts[:n], run.stop - run.start)
        if (np.maximum(0, shared) < 0.5 * shorter).all():
            starts[n], stops[n] = run.start, run.stop
            kept.append(run)
    return kept
