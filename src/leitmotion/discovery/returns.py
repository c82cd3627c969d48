"""Returns: movements that come back later, and which runs of cycles are the same movement.

Conventions
-----------
Moments of the working rate. A *theme* gathers the runs, and the single occurrences elsewhere, of one cyclic
movement; a *return* is an acyclic movement with the stretches in which it occurs.

References
----------
Paper P, section 2.5, last paragraph: cycles are grouped into one pattern; what is left is grouped by the similarity
of the stretches and their durations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import product

import numpy as np

from leitmotion.discovery.families import SAME_PERIOD, WHOLE, Run, is_near, overlap
from leitmotion.discovery.stripes import Likeness, Stripe, part

LINKED = 0.8  # of a period: how long a stripe between two runs must be to make them one movement
COVERED = 0.4  # of the shorter run: how much of it such stripes must cover
FREE = 0.3  # an acyclic stretch may overlap what is already explained by this share
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


@dataclass
class Return:
    """An acyclic movement: where it occurs, and the stripes that show it."""

    spans: list[tuple[float, float]]
    stripes: list[Stripe]


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
    far = [stripe for stripe in stripes if not is_near(stripe)]
    group = list(range(len(runs)))
    for i, j in _links(runs, far):
        old, new = group[j], group[i]
        group = [new if g == old else g for g in group]
    themes = [
        Theme([run for run, g in zip(runs, group, strict=True) if g == k]) for k in dict.fromkeys(group)
    ]
    for theme in themes:
        _add_single_occurrences(theme, themes, far)
        theme.runs.sort(key=lambda run: run.start)
        theme.stripes = [s for s in stripes if _inside(s, theme).mean() >= HOLDS]
    return themes


def returns_of(
    themes: Sequence[Theme],
    stripes: Sequence[Stripe],
    distances: np.ndarray,
    alike: Likeness,
    *,
    shortest: int,
    min_contrast: float,
) -> list[Return]:
    """Group what is left of the stripes into movements that come back, the one that explains most first.

    Parameters
    ----------
    themes : sequence of Theme
        What is already explained.
    stripes : sequence of Stripe
        All stripes of the recording.
    distances : (N, N) float32
        Posture distances.
    alike : Likeness
        What counts as alike.
    shortest : int
        Shortest occurrence, moments.
    min_contrast : float
        Least contrast of a stripe that is kept.

    Returns
    -------
    list of Return
        Each with at least two occurrences that do not overlap.
    """
    taken = np.zeros(len(distances), bool)
    for theme in themes:
        for run in theme.runs:
            taken[int(run.start) : int(np.ceil(run.stop))] = True
    left = _unexplained(stripes, taken, distances, alike, shortest, min_contrast)
    found = []
    while left:
        best = max((_occurrences(span, left) for s in left for span in (s.a, s.b)), key=_explained)
        if len(best.spans) < 2:
            break
        found.append(best)
        for start, stop in best.spans:
            taken[int(start) : int(np.ceil(stop))] = True
        left = _unexplained(left, taken, distances, alike, shortest, min_contrast)
    return found


def _links(runs: Sequence[Run], far: Sequence[Stripe]) -> list[tuple[int, int]]:
    """Pairs of runs that stripes show to be one movement: a stripe of most of a period, and enough of them."""
    shown: dict[tuple[int, int], list[np.ndarray]] = {}
    for stripe in far:
        first = [k for k, run in enumerate(runs) if overlap(stripe.a, (run.start, run.stop))]
        second = [k for k, run in enumerate(runs) if overlap(stripe.b, (run.start, run.stop))]
        for i, j in product(first, second):
            if i < j:
                inside = stripe.path[
                    _between(stripe.path[:, 0], runs[i]) & _between(stripe.path[:, 1], runs[j])
                ]
                if len(inside):
                    shown.setdefault((i, j), []).append(inside)
    return [(i, j) for (i, j), paths in shown.items() if _linked(runs[i], runs[j], paths)]


def _linked(first: Run, second: Run, paths: Sequence[np.ndarray]) -> bool:
    shorter, longer = sorted((first.period, second.period))
    if longer > SAME_PERIOD * shorter:
        return False
    longest = max(int((path[-1] - path[0]).min()) + 1 for path in paths)
    rows = _length_covered([(path[0, 0], path[-1, 0] + 1) for path in paths])
    columns = _length_covered([(path[0, 1], path[-1, 1] + 1) for path in paths])
    least = COVERED * min(first.stop - first.start, second.stop - second.start)
    return longest >= LINKED * shorter and min(rows, columns) >= least


def _between(moments: np.ndarray, run: Run) -> np.ndarray:
    return (moments >= run.start) & (moments < run.stop)


def _length_covered(spans: Sequence[tuple[int, int]]) -> int:
    """Length of the union of stretches."""
    total, reached = 0, -1
    for start, stop in sorted(spans):
        total += max(0, stop - max(start, reached))
        reached = max(reached, stop)
    return int(total)


def _add_single_occurrences(theme: Theme, themes: Sequence[Theme], far: Sequence[Stripe]) -> None:
    """A cycle of the theme may come back alone: carry whole cycles along a stripe to where no run is yet."""
    for run in list(theme.runs):
        for stripe in sorted(far, key=lambda s: -s.gain):
            for here, carry in (
                (stripe.a, stripe.forward),
                (stripe.b, stripe.backward),
            ):
                start, stop = max(run.start, here[0]), min(run.stop, here[1] - 1)
                if stop - start < LINKED * run.period:
                    continue
                span = (carry(start), carry(stop))
                everywhere = [r for t in themes for r in t.runs]
                if any(overlap(span, (r.start, r.stop)) > FREE * (span[1] - span[0]) for r in everywhere):
                    continue
                if not 1 / SAME_PERIOD <= (span[1] - span[0]) / (stop - start) <= SAME_PERIOD:
                    continue
                inside = [b for b in run.borders if start <= b <= stop]
                if len(inside) >= 2:
                    borders = [carry(b) for b in inside]
                elif stop - start >= WHOLE * run.period:
                    borders = [span[0], min(span[1], span[0] + run.period)]
                else:
                    continue
                lone = Run(span[0], span[1], float(np.median(np.diff(borders))), [stripe], [stripe], borders)
                theme.runs.append(lone)


def _inside(stripe: Stripe, theme: Theme) -> np.ndarray:
    """Which moments of a stripe join two moments of the theme's runs, (K,) bool."""
    i, j = stripe.path[:, 0], stripe.path[:, 1]
    first, second = np.zeros(len(i), bool), np.zeros(len(i), bool)
    for run in theme.runs:
        first |= _between(i, run)
        second |= _between(j, run)
    return first & second


def _unexplained(
    stripes: Sequence[Stripe],
    taken: np.ndarray,
    distances: np.ndarray,
    alike: Likeness,
    shortest: int,
    min_contrast: float,
) -> list[Stripe]:
    left = []
    for stripe in stripes:
        free = ~taken[stripe.path[:, 0]] & ~taken[stripe.path[:, 1]]
        rest = stripe if free.mean() >= 1 - FREE else part(stripe, free, distances, alike)
        if rest is None or min(rest.a[1] - rest.a[0], rest.b[1] - rest.b[0]) < shortest:
            continue
        if rest.contrast >= min_contrast and overlap(rest.a, rest.b) == 0:
            left.append(rest)
    return sorted(left, key=lambda s: -s.gain)


def _occurrences(span: tuple[int, int], stripes: Sequence[Stripe]) -> Return:
    """Everywhere that the movement of one stretch comes back, along the stripes that hold most of it."""
    spans: list[tuple[float, float]] = [span]
    shown = []
    for stripe in stripes:
        for here, carry in ((stripe.a, stripe.forward), (stripe.b, stripe.backward)):
            start, stop = max(span[0], here[0]), min(span[1], here[1])
            if stop - start < HOLDS * (span[1] - span[0]):
                continue
            other = (carry(start), carry(stop - 1) + 1)
            if all(overlap(other, known) == 0 for known in spans):
                spans.append(other)
                shown.append(stripe)
    return Return(sorted(spans), shown)


def _explained(found: Return) -> float:
    """Time that a return explains, weighted by how clear its stripes are."""
    if len(found.spans) < 2:
        return 0.0
    clear = float(np.mean([stripe.contrast for stripe in found.stripes]))
    return clear * sum(stop - start for start, stop in found.spans)
