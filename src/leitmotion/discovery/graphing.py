"""Graphing: from kinematic chains to the motion graph, from candidates to states, from ways to paths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from leitmotion.discovery.cycling import cycles
from leitmotion.discovery.lettering import named
from leitmotion.discovery.moments import Moments, moments_of
from leitmotion.discovery.motion_graph import MotionGraph
from leitmotion.discovery.reducing import Walked, reduced
from leitmotion.discovery.states import alike_within, askew, cluster, straight
from leitmotion.discovery.turning import centres, halts
from leitmotion.discovery.visiting import visits
from leitmotion.discovery.ways import Atlas
from leitmotion.features import FeatureSequence
from leitmotion.motion.errors import ParameterError


def build_graph(
    chains: Sequence[FeatureSequence],
    *,
    names: Sequence[str] = (),
    weights: np.ndarray | None = None,
) -> MotionGraph:
    """Draw the motion graph of one recording or several: what states it passes through, and on what paths.

    Parameters
    ----------
    chains : sequence of FeatureSequence
        Kinematic chains with both sides and the same links, one a recording.
    names : sequence of str
        Of the recordings.
    weights : (L,) float, optional
        How much each link counts, both sides alike.

    Returns
    -------
    MotionGraph
        Without a state where nothing recurs, turns back or keeps still. No path leads across frames in which nothing
        of the body was seen.

    Raises
    ------
    ParameterError
        When there is no recording, or the chains are of different links.
    DataError
        When nothing of a body was seen.
    """
    if not chains:
        raise ParameterError("A motion graph is of one recording at least, got none.")
    for chain in chains[1:]:
        if chain.names != chains[0].names:
            raise ParameterError(
                f"The recordings must have the same links, got {', '.join(chains[0].names)} and "
                f"{', '.join(chain.names)}."
            )
    moments = moments_of(chains, weights=weights)
    floor = askew(moments)
    mirror = straight(moments.mirror, floor)
    candidates, extents = _candidates(moments, mirror)
    drawn = _drawn(moments, candidates, extents)
    if not drawn.walked.courses:  # nothing recurs or turns back between two halts: from the begin to the end
        ends = [moment for a, b in pairwise(moments.starts.tolist()) for moment in (a, b - 1)]
        drawn = _drawn(moments, sorted({*candidates, *ends}), extents)
    rates = tuple(chain.rate for chain in chains)
    states, paths = named(drawn.walked, moments, chains)
    return MotionGraph(
        states,
        paths,
        tuple(names) if names else tuple(f"recording {k + 1}" for k in range(len(chains))),
        rates,
        drawn.confidence,
        {
            "alike_deg": round(float(np.degrees(drawn.alike)), 2),
            "half_alike_deg": round(float(np.degrees(moments.half)), 2),
            "evened_by_deg": [round(float(np.degrees(angle)), 2) for angle in moments.evened],
            "lopsided_by_deg": round(float(np.degrees(floor)), 2),
            "moments_per_s": round(moments.rate, 3),
        },
    )


class _Drawn(NamedTuple):
    walked: Walked
    alike: float
    confidence: float


def _drawn(moments: Moments, candidates: Sequence[int], extents: Mapping[int, float]) -> _Drawn:
    """States and paths from these candidates."""
    if not candidates:
        nothing: list[list[Any]] = [[] for _ in moments.starts[1:]]
        return _Drawn(Walked(nothing, nothing, []), moments.half, 0.0)
    orbits = cluster(moments, candidates, alike_within(moments, candidates, extents), extents)
    walked = reduced(visits(moments, orbits), Atlas(moments, orbits.alike))
    return _Drawn(walked, float(np.median(orbits.alike)), orbits.confidence)


def _candidates(moments: Moments, mirror: np.ndarray) -> tuple[list[int], dict[int, float]]:
    """Moments at which a state may be, in order, and how far the cycles lead that halt nowhere."""
    lopsided = np.diagonal(mirror)
    found: set[int] = set()
    extents: dict[int, float] = {}
    for start, stop in pairwise(moments.starts.tolist()):
        at = {*halts(moments, start, stop), *centres(moments, lopsided, start, stop)}
        extents |= {cycle.state: cycle.extent for cycle in cycles(moments, mirror, sorted(at), start, stop)}
        found |= at
    return sorted(found | set(extents)), extents
