"""Ends: the first and the last cycle of a run, where the body passes from one movement straight into another.

Conventions
-----------
Moments of the working rate, distances in body sizes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np

from leitmotion.discovery.overlay import overlay_of_spans
from leitmotion.discovery.themes import Theme
from leitmotion.similarity import Distances

FARTHER = (
    1.5  # times what inner cycles are apart, on average: so far from them a cycle at an end is none of them
)
NEAR = 0.4  # of the distance of what is alike: nearer it always is one
COMPARED = 8  # inner cycles that are compared
LEAST = 2  # cycles that a run keeps
BESIDE_S = 0.3  # how far beyond an end the body is looked at
GOES_ON = 0.5  # of the speed within inner cycles: so fast it moves on, and comes to no rest


def without_transitions(
    themes: Sequence[Theme], distances: Distances, speed: np.ndarray, max_distance: float
) -> list[Theme]:
    """Take from runs the first and the last cycle that are unlike the inner ones, where the body comes to no rest.

    A walk that turns into a run does so within a cycle that is neither. The first step after standing, though unlike
    the later ones, too, is a step of the walk.

    Parameters
    ----------
    themes : sequence of Theme
        With the borders of their cycles.
    distances : Distances
        Posture distances of N moments.
    speed : (N,) float
        How fast the posture changes.
    max_distance : float
        Mean distance along the warping path below which cycles are alike, body sizes.

    Returns
    -------
    list of Theme
        As many; a run keeps two cycles or more, and a theme with fewer than two inner cycles all of them.
    """
    return [_without(theme, distances, speed, max_distance) for theme in themes]


def _without(theme: Theme, distances: Distances, speed: np.ndarray, max_distance: float) -> Theme:
    inner = [cycle for run in theme.runs for cycle in list(pairwise(run.borders))[1:-1]]
    if len(inner) < 2:
        return theme
    some = [inner[k] for k in np.unique(np.linspace(0, len(inner) - 1, COMPARED).round().astype(int))]
    last = len(distances)
    beside = round(BESIDE_S * distances.features.rate)
    fast = GOES_ON * float(np.median(np.concatenate([speed[int(a) : int(b)] for a, b in some])))

    def apart(one: tuple[float, float], other: tuple[float, float]) -> float:
        return overlay_of_spans(distances, one, other, max_distance)

    usual = float(np.median([apart(one, other) for one, other in combinations(some, 2)]))
    farthest = max(NEAR * max_distance, FARTHER * usual)

    def transition(cycle: tuple[float, float], beyond: slice) -> bool:
        goes_on = beyond.stop - beyond.start == beside and speed[beyond].min() > fast
        return goes_on and float(np.median([apart(cycle, other) for other in some])) > farthest

    runs = []
    for run in theme.runs:
        borders = list(run.borders)
        first, end = int(run.start), int(np.ceil(run.stop))
        if len(borders) - 1 > LEAST and transition(
            (borders[0], borders[1]), slice(max(0, first - beside), first)
        ):
            borders = borders[1:]
        if len(borders) - 1 > LEAST and transition(
            (borders[-2], borders[-1]), slice(end, min(last, end + beside))
        ):
            borders = borders[:-1]
        start = run.start if borders[0] == run.borders[0] else borders[0]
        stop = run.stop if borders[-1] == run.borders[-1] else borders[-1]
        runs.append(replace(run, start=start, stop=stop, borders=borders))
    return Theme(runs, theme.stripes)
