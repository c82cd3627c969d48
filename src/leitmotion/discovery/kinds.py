"""Kinds: which cycles of a theme are alike, so that a walk that becomes a run, step by step, is two movements.

A walk that turns, each step a little further, stays one: its kinds are less far apart, and pass into one another.

Conventions
-----------
Moments of the working rate, distances in body sizes.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, pairwise

import numpy as np

from leitmotion.discovery.families import Run
from leitmotion.discovery.overlay import AGREED, overlay_of_spans
from leitmotion.discovery.themes import Theme
from leitmotion.similarity import Distances

GRADUAL = 0.9  # of the distance of what is alike: nearer cycles that follow one another are of one kind
COMPARED = 24  # cycles of a theme that are compared each with each; the others go to the nearest


def part_themes(themes: Sequence[Theme], distances: Distances, max_distance: float) -> list[Theme]:
    """Part themes whose cycles are not all alike: a walk that becomes a run, step by step.

    Parameters
    ----------
    themes : sequence of Theme
        With the borders of their cycles.
    distances : Distances
        Posture distances of N moments.
    max_distance : float
        Mean distance along the warping path below which cycles are alike, body sizes.

    Returns
    -------
    list of Theme
        Those of alike cycles, each of two cycles or more.
    """
    parted: list[Theme] = []
    for theme in themes:
        cycles = [(run, a, b) for run in theme.runs for a, b in pairwise(run.borders)]
        spans = [(a, b) for _, a, b in cycles]
        kinds = _gradual(spans, _kinds(spans, distances, max_distance), distances, max_distance)
        if kinds.max(initial=0) == 0:
            parted.append(theme)
            continue
        for kind in range(kinds.max() + 1):
            runs = _runs_of_kind(cycles, kinds, kind)
            if sum(run.cycles for run in runs) >= 2:
                inside = Theme(runs).holds(len(distances))
                shown = [s for s in theme.stripes if (inside[s.path[:, 0]] & inside[s.path[:, 1]]).any()]
                parted.append(Theme(runs, shown))
    return parted


def _kinds(cycles: Sequence[tuple[float, float]], distances: Distances, max_distance: float) -> np.ndarray:
    """Which cycles are alike: a number for each, by average linkage of what some of them are apart."""
    from scipy.cluster.hierarchy import fcluster, linkage
    from scipy.spatial.distance import squareform

    count = len(cycles)
    if count < 2:
        return np.zeros(count, int)
    some = np.unique(np.linspace(0, count - 1, min(count, COMPARED)).round().astype(int))
    apart = np.zeros((len(some), len(some)))
    for x, y in combinations(range(len(some)), 2):
        apart[x, y] = apart[y, x] = overlay_of_spans(
            distances, cycles[some[x]], cycles[some[y]], max_distance
        )
    groups = fcluster(linkage(squareform(apart), "average"), max_distance, "distance") - 1
    kinds = np.zeros(count, int)
    nearest = [some[np.flatnonzero(groups == group)[0]] for group in range(groups.max() + 1)]
    for k, cycle in enumerate(cycles):
        at = np.searchsorted(some, k)
        if at < len(some) and some[at] == k:
            kinds[k] = groups[at]
        else:
            kinds[k] = int(
                np.argmin([overlay_of_spans(distances, cycle, cycles[n], max_distance) for n in nearest])
            )
    return kinds


def _gradual(
    cycles: Sequence[tuple[float, float]], kinds: np.ndarray, distances: Distances, max_distance: float
) -> np.ndarray:
    """Make one of kinds that are as alike as whole stretches must be and pass gradually into one another."""
    steps: dict[tuple[int, int], list[float]] = {}
    for (one, kind), (other, following) in pairwise(zip(cycles, kinds.tolist(), strict=True)):
        if kind != following and one[1] == other[0]:
            step = (min(kind, following), max(kind, following))
            steps.setdefault(step, []).append(overlay_of_spans(distances, one, other, max_distance))
    merged = kinds.copy()
    for (kind, following), apart in steps.items():
        if np.median(apart) < GRADUAL * max_distance:
            here, there = (np.flatnonzero(kinds == k)[:COMPARED] for k in (kind, following))
            between = [
                overlay_of_spans(distances, cycles[a], cycles[b], max_distance) for a in here for b in there
            ]
            if np.mean(between) < AGREED * max_distance:
                known, new = sorted((merged[kinds == kind][0], merged[kinds == following][0]))
                merged[merged == new] = known
    return np.unique(merged, return_inverse=True)[1]


def _runs_of_kind(cycles: Sequence[tuple[Run, float, float]], kinds: np.ndarray, kind: int) -> list[Run]:
    """The cycles of one kind, those that follow one another joined to runs."""
    runs: list[Run] = []
    previous = -2
    for k in np.flatnonzero(kinds == kind).tolist():
        run, a, b = cycles[k]
        first, last = a == run.borders[0], b == run.borders[-1]
        if k == previous + 1 and runs and runs[-1].borders[-1] == a:
            runs[-1].borders.append(b)
            runs[-1].stop = run.stop if last else b
        else:
            runs.append(
                Run(
                    run.start if first else a,
                    run.stop if last else b,
                    run.period,
                    run.stripes,
                    run.support,
                    [a, b],
                )
            )
        previous = k
    return runs
