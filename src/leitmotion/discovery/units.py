"""Units: where a stripe that shows several movements in a row is divided into one stripe for each.

Conventions
-----------
Moments of the working rate. A *pause* is a moment at which the body is slower than shortly before and after. A movement
is *closed* when it comes back, at a pause, to the posture in which it began: a squat, a kick, a step to the side and
back. What comes back twice in one order (a kick, then a squat) is one long stripe; the pause between them, at which the
first has closed or the second is about to begin what it closes, parts it in two. But a step to the left and one to
the right are one movement: of two movements that are mirror images of one another none is parted from the other.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from itertools import pairwise

import numpy as np

from leitmotion.discovery.families import is_near
from leitmotion.discovery.overlay import overlay_of_stretches
from leitmotion.discovery.pauses import pauses
from leitmotion.discovery.stripes import Likeness, Stripe, measure
from leitmotion.features.mirror import mirrored
from leitmotion.similarity import Distances

SETTLE_S = 0.2  # how near to an end of a movement its posture is looked for
BACK = 0.35  # of how far a movement leads away: it is back when it is this near again
UNLIKE = 0.7  # of the distance of two movements: a mirror image this much nearer is of the other side
AWAY = 2.0  # times the distance of what is alike: how far a movement must lead away before it comes back


Alternates = Callable[[tuple[int, int], tuple[int, int]], bool]
"""Tells of two stretches, frames ``[start, stop)``, whether the one is the other with the sides exchanged."""


def alternation(distances: Distances, max_distance: float) -> Alternates:
    """Prepare to tell movements of alternating sides.

    Parameters
    ----------
    distances : Distances
        Posture distances of N moments.
    max_distance : float
        Body sizes: mean distance along the warping path below which mirror images are alike.

    Returns
    -------
    callable
        Always false where the features know no sides, and of movements that are the same on both sides.
    """
    features, last = distances.features, len(distances)
    image = mirrored(features)
    if image is None:
        return lambda a, b: False
    beside = Distances(features.replace(values=np.concatenate((features.values, image.values))))

    @cache
    def alternates(a: tuple[int, int], b: tuple[int, int]) -> bool:
        one, other, exchanged = range(*a), range(*b), range(last + b[0], last + b[1])
        apart = overlay_of_stretches(beside, one, exchanged, max_distance)
        return apart < max_distance and apart < UNLIKE * overlay_of_stretches(
            beside, one, other, max_distance
        )

    return alternates


def divide(
    stripes: Sequence[Stripe],
    distances: Distances,
    alike: Likeness,
    alternates: Alternates,
    *,
    max_distance: float,
    shortest: int,
) -> list[Stripe]:
    """Divide the stripes that show several closed movements in a row.

    Of a movement that goes on without a break (a near stripe) only one cycle is asked: where that holds several
    unlike movements, the stripe is divided; else it is a family of cycles and stays whole.

    Parameters
    ----------
    stripes : sequence of Stripe
        As traced.
    distances : Distances
        Posture distances of N moments.
    alike : Likeness
        What counts as alike.
    alternates : callable
        Tells movements of alternating sides, which stay together; see :func:`alternation`.
    max_distance : float
        Body sizes: what is nearer is the same posture.
    shortest : int
        Shortest stretch, moments.

    Returns
    -------
    list of Stripe
        The whole ones and the pieces of the others, at least `shortest` long.
    """
    kept, paths = [], []
    for stripe in stripes:
        cuts = []
        cycle = stripe.path if not is_near(stripe) else _cycle(stripe)
        inner = _closures(cycle, distances, alike, max_distance, shortest)
        if is_near(stripe) and _same_again(cycle, inner, distances, max_distance):
            inner = []  # the stripe of several periods of one movement
        if _without_alternations(cycle, inner, alternates):
            cuts = _closures(stripe.path, distances, alike, max_distance, shortest)
            cuts = _without_alternations(stripe.path, cuts, alternates)
        if cuts:
            paths += [stripe.path[start:stop] for start, stop in pairwise([0, *cuts, len(stripe.path)])]
        else:
            kept.append(stripe)
    pieces = [piece for piece in measure(paths, distances, alike) if piece is not None]
    return kept + [p for p in pieces if min(p.a[1] - p.a[0], p.b[1] - p.b[0]) >= shortest]


def _same_again(path: np.ndarray, cuts: Sequence[int], distances: Distances, max_distance: float) -> bool:
    """Whether all movements that one cycle holds are alike."""
    moments = path[[0, *cuts, len(path) - 1], 0].tolist()
    pieces = [range(start, stop) for start, stop in pairwise(moments)]
    return all(
        overlay_of_stretches(distances, a, b, max_distance) < max_distance for a, b in pairwise(pieces)
    )


def _without_alternations(path: np.ndarray, cuts: Sequence[int], alternates: Alternates) -> list[int]:
    """The cuts that part no movement from its mirror image."""
    ends = [0, *cuts, len(path) - 1]
    moments = path[ends, 0].tolist()
    return [
        cut
        for cut, before, at, after in zip(cuts, moments[:-2], moments[1:-1], moments[2:], strict=True)
        if not alternates((before, at), (at, after))
    ]


def _cycle(stripe: Stripe) -> np.ndarray:
    """The path of a near stripe as far as its first cycle goes."""
    earlier = stripe.path[:, 0]
    return stripe.path[: int(np.searchsorted(earlier, earlier[0] + stripe.lag)) + 1]


def _closures(
    path: np.ndarray, distances: Distances, alike: Likeness, max_distance: float, shortest: int
) -> list[int]:
    """Places along a path at which one closed movement gives way to another."""
    last = len(path) - 1
    if last < 2 * shortest:
        return []
    rate = distances.features.rate
    stops = pauses(alike.speed[path].mean(axis=1), rate)
    settle = max(1, round(SETTLE_S * rate))
    cuts = []
    at = 0
    for p in stops:
        if (
            p - at >= shortest
            and last - p >= shortest
            and _closes(path, at, p, distances, max_distance, settle)
        ):
            cuts.append(p)
            at = p
    end, reached = last, cuts[-1] if cuts else 0
    for p in reversed(stops):
        if p - reached < shortest:
            break
        if end - p >= shortest and _closes(path, p, end, distances, max_distance, settle):
            cuts.append(p)
            end = p
    return sorted(cuts)


def _closes(
    path: np.ndarray, start: int, stop: int, distances: Distances, max_distance: float, settle: int
) -> bool:
    """Whether both stretches between two places lead away from a posture and back to it."""
    from leitmotion.discovery._border_kernels import closes

    away, near, back = (np.float32(value) for value in (AWAY * max_distance, max_distance, BACK))
    part = path[start : stop + 1]
    return bool(closes(distances.across, distances.width, part, away, near, back, settle))
