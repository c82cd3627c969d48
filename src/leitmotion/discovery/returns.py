"""Returns: movements that come back later.

Conventions
-----------
Moments of the working rate. A *return* is a movement without a run of more than two cycles, with the stretches in which
it occurs; two of them may overlap by half of the shortest stretch. Every stretch of every stripe is a candidate; the
one that explains most is taken, what it explains is taken from the others, and so on. Only candidates that this touches
are judged anew.

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
from leitmotion.discovery.units import Alternates
from leitmotion.similarity import Distances

FREE = 0.3  # an acyclic stretch may overlap what is already explained by this share
PARTS = 24  # ends of other stripes inside a stretch at which it is tried in parts
AGREED = (
    0.75  # share of the stripes that must have begun, and not yet ended, where an occurrence begins and ends
)


@dataclass
class Return:
    """A movement that comes back: where it occurs, and the stripes that show it."""

    spans: list[tuple[float, float]]
    stripes: list[Stripe]
    covered: np.ndarray
    """(K, 2): from where to where in the first stretch each stripe shows it."""

    explained: float
    """Time that it explains, weighted by how clear its stripes are."""


def returns_of(
    themes: Sequence[Theme],
    stripes: Sequence[Stripe],
    distances: Distances,
    alike: Likeness,
    alternates: Alternates,
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
    alternates : callable
        Tells movements of alternating sides, which stay together; see :func:`leitmotion.discovery.units.alternation`.
    shortest : int
        Shortest occurrence, moments.
    min_contrast : float
        Least contrast of a stripe that is kept.

    Returns
    -------
    list of Return
        Each with at least two occurrences that do not overlap. Occurrences of two returns may, by half of the shortest
        stretch and a moment: what is left of a stripe is cut only where it shares more with what is explained.
    """
    taken = np.zeros(len(distances), bool)
    _take(taken, [(run.start, run.stop) for theme in themes for run in theme.runs])

    def rest_of(stripes: Sequence[Stripe]) -> list[Stripe | None]:
        """What is left of stripes; None where that is too short or not clear."""
        rests: list[Stripe | None] = list(stripes)
        lengths = np.array([len(stripe.path) for stripe in stripes], np.int64)
        points = np.concatenate([np.zeros((0, 2), np.int32), *(stripe.path for stripe in stripes)])
        free = ~taken[points].any(axis=1)
        starts = np.cumsum(lengths) - lengths
        lost = lengths - np.add.reduceat(free, starts, dtype=np.int64) if len(stripes) else lengths
        cut = np.flatnonzero(lost > np.minimum(FREE * lengths, shortest / 2)).tolist()
        paths = [part(stripes[k], free[starts[k] : starts[k] + lengths[k]]) for k in cut]
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

    left = _Left([rest for rest in rest_of(stripes) if rest is not None], shortest, alternates)
    found = []
    while len(left.stripes):
        best = left.best()
        if len(best.spans) < 2:
            break
        found.append(best)
        _take(taken, best.spans)
        touched = left.touching(best.spans)
        if not left.put(touched, rest_of([left.stripes[k] for k in touched])):
            break  # each round shortens or drops a stripe; where none does, the same would be found again
    return found


def _take(taken: np.ndarray, spans: Sequence[tuple[float, float]]) -> None:
    for start, stop in spans:
        taken[int(start) : int(np.ceil(stop))] = True


class _Left:
    """The stripes that are left, clearest first, and how much each of their stretches would explain."""

    def __init__(self, stripes: Sequence[Stripe], shortest: int, alternates: Alternates) -> None:
        self.shortest = shortest
        self.alternates = alternates
        self.stripes = np.array([None, *stripes], dtype=object)[1:]
        self.spans = np.array([(s.a, s.b) for s in stripes], np.int64).reshape(-1, 2, 2)
        self.scores = np.full((len(stripes), 2), np.nan)
        self.contrasts = np.array([s.contrast for s in stripes])
        self.points = np.concatenate([np.zeros((0, 2), np.int32), *(s.path for s in stripes)], dtype=np.int32)
        self.lengths = np.array([len(s.path) for s in stripes], np.int64)
        self.places = np.cumsum(self.lengths) - self.lengths
        self._sort()

    def best(self) -> Return:
        """The movement that explains most, with everywhere that it comes back.

        A part of it that comes back elsewhere, too, goes first; and it begins and ends where most of its stripes do,
        so that what happened to precede or follow it twice is no part of it.
        """
        stripe, side = divmod(int(np.argmax(self.scores)), 2)
        first, last = self.spans[stripe, side].tolist()
        best = self._occurrences(first, last)
        while (part := self._oftener(first, last, best)) is not None:
            first, last, best = part
        return self._core(best)

    def _oftener(self, first: int, last: int, whole: Return) -> tuple[int, int, Return] | None:
        """The part of a stretch that explains most of those that come back where the whole does not."""
        inside = (self.spans >= first + self.shortest) & (self.spans <= last - self.shortest)
        ends = np.unique(self.spans[inside])
        if len(ends) > PARTS:
            ends = ends[np.linspace(0, len(ends) - 1, PARTS).round().astype(int)]
        found = None
        for start, stop in ((a, b) for end in ends.tolist() for a, b in ((first, end), (end, last))):
            part = self._occurrences(start, stop)
            if found is not None and part.explained <= found[2].explained:
                continue
            rest = (stop, last) if start == first else (first, start)
            if any(_is_new(span, whole.spans) for span in part.spans) and not self.alternates(
                (start, stop), rest
            ):
                found = (start, stop, part)
        return found

    def _core(self, whole: Return) -> Return:
        """What most stripes agree on, where there are several and no occurrence is lost."""
        if len(whole.stripes) < 2:
            return whole
        first = int(np.quantile(whole.covered[:, 0], AGREED, method="higher"))
        last = int(np.quantile(whole.covered[:, 1], 1 - AGREED, method="lower"))
        if last - first < self.shortest:
            return whole
        core = self._occurrences(first, last)
        return core if len(core.spans) >= len(whole.spans) else whole

    def touching(self, spans: Sequence[tuple[float, float]]) -> np.ndarray:
        """Which stripes reach into any of some stretches."""
        reach = np.zeros(len(self.stripes), bool)
        for start, stop in spans:
            reach |= ((self.spans[..., 0] < stop + 1) & (self.spans[..., 1] > start - 1)).any(axis=1)
        return np.flatnonzero(reach)

    def put(self, which: np.ndarray, rests: Sequence[Stripe | None]) -> bool:
        """Put what is left of some stripes in their place, and judge anew whatever they bear on; false if all stay."""
        changed = np.array([r is not s for r, s in zip(rests, self.stripes[which], strict=True)], bool)
        if not changed.any():
            return False
        which, rests = which[changed], [r for r, c in zip(rests, changed, strict=True) if c]
        dirty = np.zeros(int(self.spans.max()) + 2, np.int64)
        for start, stop in self.spans[which].reshape(-1, 2):
            dirty[start:stop] = 1
        reached = np.concatenate(([0], np.cumsum(dirty)))
        self.scores[reached[self.spans[..., 1]] > reached[self.spans[..., 0]]] = np.nan
        keep = np.ones(len(self.stripes), bool)
        for k, rest in zip(which.tolist(), rests, strict=True):
            if rest is None:
                keep[k] = False
                continue
            before = self.points[self.places[k] : self.places[k] + self.lengths[k], 0]
            self.places[k] += np.searchsorted(before, rest.a[0])  # a rest is a part of the path
            self.lengths[k] = len(rest.path)
            self.stripes[k], self.contrasts[k] = rest, rest.contrast
            self.spans[k] = rest.a, rest.b
            self.scores[k] = np.nan
        self._keep(keep)
        self._sort()
        return True

    def _keep(self, which: np.ndarray) -> None:
        for what in ("stripes", "spans", "scores", "contrasts", "lengths", "places"):
            setattr(self, what, getattr(self, what)[which])

    def _sort(self) -> None:
        from leitmotion.discovery._return_kernels import judge

        self._keep(np.argsort([-stripe.gain for stripe in self.stripes], kind="stable"))
        judge(*self._paths(), HOLDS, *self._room(), self.scores)

    def _paths(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        return self.points, self.places, self.lengths, self.spans, self.contrasts

    def _room(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """For what comes back: every side of every stripe may."""
        sides = 2 * len(self.stripes)
        return np.empty((sides + 1, 2)), np.empty(sides, np.int64), np.empty((sides, 2), np.int64)

    def _occurrences(self, first: int, last: int) -> Return:
        """Everywhere that the movement of one stretch comes back, along the stripes that hold most of it."""
        from leitmotion.discovery._return_kernels import come_back

        spans, shown, covered = self._room()
        count, explained = come_back(*self._paths(), first, last, HOLDS, spans, shown, covered)
        occurrences = sorted((start, stop) for start, stop in spans[: count + 1].tolist())
        return Return(occurrences, list(self.stripes[shown[:count]]), covered[:count], explained)


def _is_new(span: tuple[float, float], known: Sequence[tuple[float, float]]) -> bool:
    return all(overlap(span, other) < 0.5 * (span[1] - span[0]) for other in known)
