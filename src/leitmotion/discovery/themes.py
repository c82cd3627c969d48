"""Themes: which runs of cycles are the same movement.

Conventions
-----------
Moments of the working rate. A *theme* gathers the runs, and the single occurrences elsewhere, of one cyclic
movement.

References
----------
Paper P, section 2.5, last paragraph: cycles are grouped into one pattern.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import product

import numpy as np

from leitmotion.discovery.cuts import WHOLE
from leitmotion.discovery.families import SAME_PERIOD, Run, is_near
from leitmotion.discovery.stripes import Stripe

LINKED = 0.8  # of a period: how long a stripe between two runs must be to make them one movement
COVERED = 0.4  # of the shorter run: how much of it such stripes must cover
FREE = 0.3  # a single occurrence may overlap a run by this share
HOLDS = 0.7  # share of an occurrence that a stripe must cover to carry it to the other side


@dataclass
class Theme:
    """The runs of one cyclic movement, and the stripes that show it."""

    runs: list[Run]
    stripes: list[Stripe] = field(default_factory=list)

    @property
    def period(self) -> float:
        """Median length of its cycles, moments."""
        return float(np.median(np.concatenate([np.diff(run.borders) for run in self.runs])))

    def holds(self, moments: int) -> np.ndarray:
        """Which moments lie in its runs, (N,) bool."""
        inside = np.zeros(moments, bool)
        for run in self.runs:
            inside[int(np.ceil(run.start)) : int(np.ceil(run.stop))] = True
        return inside


def themes_of(runs: Sequence[Run], stripes: Sequence[Stripe]) -> list[Theme]:
    """Join runs that stripes show to be the same movement, then add its single occurrences elsewhere.

    Parameters
    ----------
    runs : sequence of Run
        The cyclic runs.
    stripes : sequence of Stripe
        All stripes of the recording.

    Returns
    -------
    list of Theme
        Each with its runs in order of time.
    """
    far = sorted((stripe for stripe in stripes if not is_near(stripe)), key=lambda s: -s.gain)
    group = list(range(len(runs)))
    for i, j in _links(runs, far):
        one, other = _root(group, i), _root(group, j)
        group[max(one, other)] = min(one, other)
    roots = [_root(group, k) for k in range(len(runs))]
    themes = [
        Theme([run for run, g in zip(runs, roots, strict=True) if g == k]) for k in dict.fromkeys(roots)
    ]
    _add_single_occurrences(themes, far)
    for theme, shares in zip(themes, _shares_inside(stripes, themes), strict=True):
        theme.runs.sort(key=lambda run: run.start)
        theme.stripes = [stripes[k] for k in np.flatnonzero(shares >= HOLDS).tolist()]
    return themes


def _shares_inside(stripes: Sequence[Stripe], themes: Sequence[Theme]) -> Iterator[np.ndarray]:
    """For each theme the share of every stripe that joins two moments of its runs, (S,)."""
    points = np.concatenate([np.zeros((0, 2), np.int64), *(stripe.path for stripe in stripes)])
    lengths = np.array([len(stripe.path) for stripe in stripes], np.int64)
    starts = np.cumsum(lengths) - lengths
    for theme in themes:
        inside = theme.holds(int(points.max(initial=0)) + 1)
        both = inside[points[:, 0]] & inside[points[:, 1]]
        yield np.add.reduceat(both, starts, dtype=np.int64) / lengths if len(stripes) else np.zeros(0)


def _root(group: list[int], k: int) -> int:
    while group[k] != k:
        k = group[k]
    return k


def _links(runs: Sequence[Run], far: Sequence[Stripe]) -> list[tuple[int, int]]:
    """Pairs of runs that stripes show to be one movement: a stripe of most of a period, and enough of them."""
    starts, stops = (np.array([getattr(run, what) for run in runs]) for what in ("start", "stop"))
    shown: dict[tuple[int, int], list[np.ndarray]] = {}
    for stripe in far:
        first = np.flatnonzero((starts < stripe.a[1]) & (stops > stripe.a[0])).tolist()
        second = np.flatnonzero((starts < stripe.b[1]) & (stops > stripe.b[0])).tolist()
        for i, j in product(first, second):
            if i < j and _same_period(runs[i].period, runs[j].period):
                i0, i1 = np.searchsorted(stripe.path[:, 0], (runs[i].start, runs[i].stop)).tolist()
                j0, j1 = np.searchsorted(stripe.path[:, 1], (runs[j].start, runs[j].stop)).tolist()
                if min(i1, j1) > max(i0, j0):
                    ends = stripe.path[[max(i0, j0), min(i1, j1) - 1]]
                    shown.setdefault((i, j), []).append(ends)
    return [(i, j) for (i, j), ends in shown.items() if _linked(runs[i], runs[j], ends)]


def _same_period(one: float, other: float) -> bool:
    return max(one, other) <= SAME_PERIOD * min(one, other)


def _linked(first: Run, second: Run, paths: Sequence[np.ndarray]) -> bool:
    shorter = min(first.period, second.period)
    longest = max(int((path[-1] - path[0]).min()) + 1 for path in paths)
    rows = _length_covered([(path[0, 0], path[-1, 0] + 1) for path in paths])
    columns = _length_covered([(path[0, 1], path[-1, 1] + 1) for path in paths])
    least = COVERED * min(first.stop - first.start, second.stop - second.start)
    return longest >= LINKED * shorter and min(rows, columns) >= least


def _length_covered(spans: Sequence[tuple[int, int]]) -> int:
    """Length of the union of stretches."""
    total, reached = 0, -1
    for start, stop in sorted(spans):
        total += max(0, stop - max(start, reached))
        reached = max(reached, stop)
    return int(total)


def _add_single_occurrences(themes: Sequence[Theme], far: Sequence[Stripe]) -> None:
    """A cycle of a theme may come back alone: carry whole cycles along a stripe to where no run is yet."""
    everywhere = np.array([(run.start, run.stop) for theme in themes for run in theme.runs]).reshape(-1, 2)
    sides = np.array([(stripe.a, stripe.b) for stripe in far]).reshape(-1, 2, 2)
    for theme in themes:
        for run in list(theme.runs):
            shared = np.minimum(run.stop, sides[..., 1] - 1) - np.maximum(run.start, sides[..., 0])
            for k, side in np.argwhere(shared >= LINKED * run.period).tolist():
                lone = _carried(run, far[k], side)
                if lone is None:
                    continue
                over = np.minimum(everywhere[:, 1], lone.stop) - np.maximum(everywhere[:, 0], lone.start)
                if (over <= FREE * (lone.stop - lone.start)).all():
                    theme.runs.append(lone)
                    everywhere = np.concatenate((everywhere, [(lone.start, lone.stop)]))


def _carried(run: Run, stripe: Stripe, side: int) -> Run | None:
    """The cycles of a run that lie on one side of a stripe, where they come back; None where no whole one does."""
    here, carry = ((stripe.a, stripe.forward), (stripe.b, stripe.backward))[side]
    start, stop = max(run.start, here[0]), min(run.stop, here[1] - 1)
    span = (carry(start), carry(stop))
    if not 1 / SAME_PERIOD <= (span[1] - span[0]) / (stop - start) <= SAME_PERIOD:
        return None
    inside = [b for b in run.borders if start <= b <= stop]
    if len(inside) >= 2:
        borders = [carry(b) for b in inside]
    elif stop - start >= WHOLE * run.period:
        borders = [span[0], min(span[1], span[0] + run.period)]
    else:
        return None
    return Run(span[0], span[1], float(np.median(np.diff(borders))), [stripe], [stripe], borders)
