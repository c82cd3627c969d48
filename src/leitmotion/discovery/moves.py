"""Moves: whole movements, from pause to pause, that come back though no stripe shows it.

Conventions
-----------
Moments of the working rate, distances in body sizes. Two kicks may be too far apart half-way to leave a stripe, and yet
be much nearer to one another, from beginning to end, than to anything else. Where a movement begins and ends must then
be known beforehand: at a pause, at a rest, or where something begins that is known already.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from leitmotion.discovery.labour import share_work
from leitmotion.discovery.pauses import pauses, true_runs
from leitmotion.discovery.returns import Return
from leitmotion.discovery.search import Criteria, Seen
from leitmotion.discovery.stripes import Likeness, measure
from leitmotion.similarity import Distances, align

SHORTEST_S, LONGEST_S = 0.6, 6.0  # of a move
SEGMENTS = 6  # stretches between two pauses in one move
MARGIN = 3  # moments: so near to an end there is no pause
AWAY = 1.33  # times the distance of what is alike: how far a move must lead away from where it began
LOOSE = 2.2  # times that distance: laid over one another without warping, moves that are alike are nearer
UNLIKE = 2.0  # times as long: a move is never another one performed so slowly
WITHIN_S = (
    10.0  # moves that follow one another sooner are compared first, then those twice as far apart, and so on
)
MOST = 5_000_000_000  # distances computed before those farther apart are left out: about a minute


def moves_of(distances: Distances, alike: Likeness, criteria: Criteria) -> Seen:
    """Find whole movements that come back.

    Parameters
    ----------
    distances : Distances
        Posture distances of N moments; those that are NaN are known to be something else.
    alike : Likeness
        What counts as alike.
    criteria : Criteria
        What counts as a return; the shortest move lasts 0.6 s, whatever is asked for beyond.

    Returns
    -------
    Seen
        Returns, the one that explains most first, no two of them sharing a moment. Where much is like much else,
        ``moves_compared_within_s`` among the limits: moves farther apart were not compared.
    """
    spans = _spans(distances, alike, criteria)
    pairs, contrasts, limits = _alike(spans, distances, criteria)
    found = []
    for explained, (seed, *others) in _groups(spans, pairs, contrasts):
        stripes = measure([_path(distances, spans[seed], spans[other]) for other in others], distances, alike)
        clear = {
            other: stripe
            for other, stripe in zip(others, stripes, strict=True)
            if stripe is not None and stripe.contrast >= criteria.min_contrast
        }
        if clear:
            stretches = sorted((float(start), float(stop)) for start, stop in spans[[seed, *clear]])
            found.append(Return(stretches, list(clear.values()), np.zeros((0, 2), int), explained))
    return Seen([], found, limits)


def _spans(distances: Distances, alike: Likeness, criteria: Criteria) -> np.ndarray:
    """What may be a move, (K, 2): from one pause or rest to one of the next few, as long as it moves."""
    rate = distances.features.rate
    shortest, longest = max(criteria.shortest, round(SHORTEST_S * rate)), round(LONGEST_S * rate)
    seen = np.isfinite(distances.features.values).any(axis=1)
    spans = set()
    for start, stop in true_runs(seen):
        if stop - start < shortest:
            continue
        ends = _ends(start, stop, alike, rate)
        for i, first in enumerate(ends):
            for last in ends[i + 1 : i + 1 + SEGMENTS]:
                moving = first + np.flatnonzero(alike.moving[first:last])
                if len(moving) and shortest <= moving[-1] + 1 - moving[0] <= longest:
                    spans.add((int(moving[0]), int(moving[-1]) + 1))
    far = AWAY * criteria.max_distance
    away = sorted(span for span in spans if _leads_away(distances, *span, far))
    return np.array(away, np.int64).reshape(-1, 2)


def _ends(start: int, stop: int, alike: Likeness, rate: float) -> list[int]:
    """Where moves may begin and end: at pauses, and within rests."""
    rests = [start + at for at, _ in true_runs(~alike.moving[start:stop])]
    inside = [start + p for p in pauses(alike.speed[start:stop], rate) if MARGIN < p < stop - start - MARGIN]
    return sorted({start, stop, *rests, *(p for p in inside if alike.moving[p])})


def _leads_away(distances: Distances, start: int, stop: int, far: float) -> bool:
    return bool(np.nanmax(distances.between(range(start, start + 1), range(start, stop)), initial=0) > far)


def _alike(
    spans: np.ndarray, distances: Distances, criteria: Criteria
) -> tuple[np.ndarray, np.ndarray, dict[str, object]]:
    """Pairs of spans that are alike from beginning to end, (P, 2), how clearly, (P,), and what was not compared."""
    from leitmotion.discovery import _whole_kernels

    found: list[tuple[np.ndarray, np.ndarray, int]] = [(np.zeros((0, 2), np.int64), np.zeros(0), 0)]
    rate = distances.features.rate
    within = round(WITHIN_S * rate)
    for sooner in range(0, len(distances), within):
        if sum(work for _, _, work in found) > MOST:
            break
        later = np.array((sooner, sooner + within))

        def compare(part: slice, later: np.ndarray = later) -> None:
            found.append(
                _whole_kernels.near_pairs(
                    distances.across, spans, part.start, part.stop, later, distances.width,
                    criteria.max_distance, LOOSE * criteria.max_distance, UNLIKE,
                )
            )  # fmt: skip

        share_work(compare, len(spans), 512)
    else:
        sooner = len(distances)
    pairs = np.concatenate([near for near, _, _ in found])
    order = np.lexsort(pairs.T[::-1])
    pairs, costs = pairs[order], np.concatenate([cost for _, cost, _ in found])[order]
    around = np.array([np.nanmedian(distances.between(range(*spans[x]), range(*spans[y]))) for x, y in pairs])
    contrasts = 1 - np.divide(costs, around, out=np.ones(len(pairs)), where=around > 0)
    clear = contrasts > criteria.min_contrast
    limits: dict[str, object] = {}
    if sooner < len(distances):
        limits["moves_compared_within_s"] = round(sooner / rate, 1)
    return pairs[clear], contrasts[clear], limits


def _groups(spans: np.ndarray, pairs: np.ndarray, contrasts: np.ndarray) -> list[tuple[float, list[int]]]:
    """Spans that are one movement, and what they explain, the most first; the first is alike to all the others."""
    partners: dict[int, list[tuple[float, int]]] = {}
    lengths = spans[:, 1] - spans[:, 0]
    for (x, y), contrast in zip(pairs.tolist(), contrasts.tolist(), strict=True):
        explained = contrast * float(min(lengths[x], lengths[y]))
        partners.setdefault(x, []).append((-explained, y))
        partners.setdefault(y, []).append((-explained, x))
    for others in partners.values():
        others.sort()
    free = np.ones(len(spans), bool)
    groups = {seed: _group(seed, others, spans, free) for seed, others in partners.items()}
    found = []
    while groups:
        best = max(groups, key=lambda seed: groups[seed][0])
        members = groups[best][1]
        if len(members) < 2:
            break
        found.append(groups[best])
        shared = np.zeros(len(spans), bool)
        for member in members:
            shared |= (spans[:, 0] < spans[member, 1]) & (spans[:, 1] > spans[member, 0])
        free &= ~shared
        groups = {
            seed: _group(seed, partners[seed], spans, free) if shared[group[1]].any() else group
            for seed, group in groups.items()
            if free[seed]
        }
    return found


def _group(
    seed: int, others: Sequence[tuple[float, int]], spans: np.ndarray, free: np.ndarray
) -> tuple[float, list[int]]:
    """What a span explains together with those it is alike to, clearest first, and which they are."""
    members, explained = [seed], 0.0
    for gain, other in others:
        start, stop = spans[other]
        if free[other] and all(stop <= spans[m, 0] or start >= spans[m, 1] for m in members):
            members.append(other)
            explained -= gain
    return explained * len(members) / max(1, len(members) - 1), members


def _path(distances: Distances, one: np.ndarray, other: np.ndarray) -> np.ndarray:
    path = align(distances.between(range(*one), range(*other)), step="symmetricP1").path
    return np.add(path, (one[0], other[0]))
