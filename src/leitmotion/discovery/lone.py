"""Lone occurrences: where a movement that is known to come back comes once more, though no stripe shows it.

Conventions
-----------
Moments of the working rate, distances in body sizes. A stripe must be alike from moment to moment; a movement as a
whole is known by its whole course, so that one that is performed otherwise half-way is found, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from leitmotion.discovery.labour import aside, share_work
from leitmotion.discovery.overlay import AGREED, overlay_of_stretches
from leitmotion.discovery.pauses import true_runs
from leitmotion.discovery.returns import Return
from leitmotion.discovery.stripes import SAMPLED
from leitmotion.similarity import Distances

SHORTER = 0.5  # of the typical occurrence: none is shorter
UNSEEN = 1.0  # body sizes: what counts where a distance is not known, unless that is near
COMPARED = 8  # occurrences among which the typical one is looked for


class _Courses(NamedTuple):
    """Stretches through which movements run, the nearest first."""

    apart: np.ndarray
    """(K,) mean distance from the movement."""

    places: np.ndarray
    """(K, 3): which movement, where the stretch starts, and where it stops."""


def with_lone_occurrences(
    returns: Sequence[Return],
    taken: np.ndarray,
    distances: Distances,
    *,
    max_distance: float,
    min_contrast: float,
) -> list[Return]:
    """Look for each movement's typical occurrence, as a whole, in what nothing explains.

    Parameters
    ----------
    returns : sequence of Return
        Movements that come back, in moments.
    taken : (N,) bool
        What is explained by something else, or was not seen.
    distances : Distances
        Posture distances of N moments.
    max_distance : float
        Body sizes: distance of postures that are alike.
    min_contrast : float
        How much nearer than its surroundings an occurrence is, 0 to 1.

    Returns
    -------
    list of Return
        As many, with all occurrences that were found, the nearest first where two would share a moment.
    """
    from leitmotion.discovery import _whole_kernels

    if not returns:
        return []
    taken = taken.copy()
    for item in returns:
        for start, stop in item.spans:
            taken[max(0, int(start)) : int(np.ceil(stop))] = True
    typical = [_typical(item.spans, distances, max_distance) for item in returns]
    spans = [list(item.spans) for item in returns]
    near = _courses(typical, taken, distances, AGREED * max_distance)
    movements = np.array([(movement.start, movement.stop) for movement in typical])
    clear = near.apart / (1 - min_contrast)
    found = aside(
        _whole_kernels.clear_courses,
        distances.across,
        movements,
        near.places,
        clear,
        taken,
        SAMPLED,
        distances.width,
    )
    for which, start, stop in near.places[found].tolist():
        spans[which].append((start, stop))
    return [replace(item, spans=sorted(found)) for item, found in zip(returns, spans, strict=True)]


def _courses(typical: Sequence[range], taken: np.ndarray, distances: Distances, farthest: float) -> _Courses:
    """Look through what is free for the courses of movements."""
    from leitmotion.discovery import _whole_kernels

    free, unseen = np.array(true_runs(~taken), np.int64).reshape(-1, 2), max(UNSEEN, farthest)
    near: list[tuple[np.ndarray, np.ndarray]] = [(np.zeros(0), np.zeros((0, 2), np.int64)) for _ in typical]

    def look(part: slice) -> None:
        for which in range(part.start, part.stop):
            movement = typical[which]
            near[which] = _whole_kernels.near_courses(
                distances.across, movement.start, movement.stop, free, max(2, int(np.ceil(SHORTER * len(movement)))),
                farthest, distances.width, unseen,
            )  # fmt: skip

    share_work(look, len(typical), 1)
    which = np.repeat(np.arange(len(typical)), [len(costs) for costs, _ in near])
    apart, places = (np.concatenate(parts) for parts in zip(*near, strict=True))
    order = np.lexsort((places[:, 1], places[:, 0], which, apart))
    return _Courses(apart[order], np.column_stack((which, places))[order])


def _typical(spans: Sequence[tuple[float, float]], distances: Distances, max_distance: float) -> range:
    """The occurrence that is nearest to the others."""
    last = len(distances)
    some = np.unique(np.linspace(0, len(spans) - 1, min(len(spans), COMPARED)).round().astype(int))
    stretches = [
        range(max(0, int(spans[k][0])), min(last, max(int(spans[k][0]) + 2, int(np.ceil(spans[k][1])))))
        for k in some
    ]
    if len(stretches) < 3:
        return stretches[0]
    apart = np.zeros(len(stretches))
    for one, other in combinations(range(len(stretches)), 2):
        apart[[one, other]] += overlay_of_stretches(distances, stretches[one], stretches[other], max_distance)
    return stretches[int(np.argmin(apart))]
