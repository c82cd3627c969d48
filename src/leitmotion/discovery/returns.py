"""Returns: movements that come back later.

Conventions
-----------
Moments of the working rate. A *return* is an acyclic movement with the stretches in which it occurs. Every stretch of
every stripe is a candidate; the one that explains most is taken, what it explains is taken from the others, and
so on. Only candidates that this touches are judged anew, so that a long recording takes little longer per second.

References
----------
Paper P, section 2.5, last paragraph: what no cyclic pattern explains is grouped by the similarity of the stretches and
their durations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from leitmotion.discovery.families import overlap
from leitmotion.discovery.stripes import Likeness, Stripe, measure, part
from leitmotion.discovery.themes import HOLDS, Theme
from leitmotion.similarity import Distances

FREE = 0.3  # an acyclic stretch may overlap what is already explained by this share


@dataclass
class Return:
    """An acyclic movement: where it occurs, and the stripes that show it."""

    spans: list[tuple[float, float]]
    stripes: list[Stripe]


def returns_of(
    themes: Sequence[Theme],
    stripes: Sequence[Stripe],
    distances: Distances,
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
    distances : Distances
        Posture distances of N moments.
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
    _take(taken, [(run.start, run.stop) for theme in themes for run in theme.runs])

    def rest_of(stripes: Sequence[Stripe]) -> list[Stripe | None]:
        """What is left of stripes; None where that is too short or not clear."""
        free = [~taken[stripe.path[:, 0]] & ~taken[stripe.path[:, 1]] for stripe in stripes]
        cut = [k for k, kept in enumerate(free) if kept.mean() < 1 - FREE]
        rests: list[Stripe | None] = list(stripes)
        paths = [part(stripes[k], free[k]) for k in cut]
        for k, rest in zip(cut, measure(paths, distances, alike), strict=True):
            rests[k] = rest
        return [
            rest
            if rest is not None
            and min(rest.a[1] - rest.a[0], rest.b[1] - rest.b[0]) >= shortest
            and rest.contrast >= min_contrast
            and overlap(rest.a, rest.b) == 0
            else None
            for rest in rests
        ]

    left = _Left([rest for rest in rest_of(stripes) if rest is not None])
    found = []
    while len(left.stripes):
        best = left.best()
        if len(best.spans) < 2:
            break
        found.append(best)
        _take(taken, best.spans)
        touched = left.touching(best.spans)
        left.put(touched, rest_of([left.stripes[k] for k in touched]))
    return found


def _take(taken: np.ndarray, spans: Sequence[tuple[float, float]]) -> None:
    for start, stop in spans:
        taken[int(start) : int(np.ceil(stop))] = True


class _Left:
    """The stripes that are left, clearest first, and how much each of their stretches would explain."""

    def __init__(self, stripes: Sequence[Stripe]) -> None:
        self.stripes = np.array([None, *stripes], dtype=object)[1:]
        self.spans = _spans(stripes)
        self.scores = np.full((len(stripes), 2), np.nan)
        self._sort()

    def best(self) -> Return:
        """The movement that explains most, with everywhere that it comes back."""
        stripe, side = divmod(int(np.argmax(self.scores)), 2)
        return self._occurrences(stripe, side)

    def touching(self, spans: Sequence[tuple[float, float]]) -> np.ndarray:
        """Which stripes reach into any of some stretches."""
        reach = np.zeros(len(self.stripes), bool)
        for start, stop in spans:
            reach |= ((self.spans[..., 0] < stop + 1) & (self.spans[..., 1] > start - 1)).any(axis=1)
        return np.flatnonzero(reach)

    def put(self, which: np.ndarray, rests: Sequence[Stripe | None]) -> None:
        """Put what is left of some stripes in their place, and judge anew whatever they bear on."""
        changed = np.array([r is not s for r, s in zip(rests, self.stripes[which], strict=True)], bool)
        which, rests = which[changed], [r for r, c in zip(rests, changed, strict=True) if c]
        dirty = np.zeros(int(self.spans.max()) + 2, np.int64)
        for start, stop in self.spans[which].reshape(-1, 2):
            dirty[start:stop] = 1
        reached = np.concatenate(([0], np.cumsum(dirty)))
        self.scores[reached[self.spans[..., 1]] > reached[self.spans[..., 0]]] = np.nan
        keep = np.ones(len(self.stripes), bool)
        for k, rest in zip(which, rests, strict=True):
            if rest is None:
                keep[k] = False
            else:
                self.stripes[k] = rest
                self.spans[k] = rest.a, rest.b
                self.scores[k] = np.nan
        self.stripes, self.spans, self.scores = self.stripes[keep], self.spans[keep], self.scores[keep]
        self._sort()

    def _sort(self) -> None:
        order = np.argsort([-stripe.gain for stripe in self.stripes], kind="stable")
        self.stripes, self.spans, self.scores = self.stripes[order], self.spans[order], self.scores[order]
        for stripe, side in np.argwhere(np.isnan(self.scores)):
            self.scores[stripe, side] = _explained(self._occurrences(stripe, side))

    def _occurrences(self, stripe: int, side: int) -> Return:
        """Everywhere that the movement of one stretch comes back, along the stripes that hold most of it."""
        first, last = self.spans[stripe, side].tolist()
        spans: list[tuple[float, float]] = [(first, last)]
        shown = []
        starts, stops = np.maximum(self.spans[..., 0], first), np.minimum(self.spans[..., 1], last)
        for k, here in np.argwhere(stops - starts >= HOLDS * (last - first)).tolist():
            other = self.stripes[k]
            carry = (other.forward, other.backward)[here]
            span = (carry(int(starts[k, here])), carry(int(stops[k, here]) - 1) + 1)
            if all(overlap(span, known) == 0 for known in spans):
                spans.append(span)
                shown.append(other)
        return Return(sorted(spans), shown)


def _spans(stripes: Sequence[Stripe]) -> np.ndarray:
    """Both stretches of each stripe, (S, 2, 2)."""
    return np.array([(stripe.a, stripe.b) for stripe in stripes], np.int64).reshape(-1, 2, 2)


def _explained(found: Return) -> float:
    """Time that a return explains, weighted by how clear its stripes are."""
    if len(found.spans) < 2:
        return 0.0
    clear = float(np.mean([stripe.contrast for stripe in found.stripes]))
    return clear * sum(stop - start for start, stop in found.spans)
