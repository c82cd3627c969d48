"""Graphing: from kinematic chains to the motion graph, from candidates to states, from ways to paths."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from leitmotion.discovery.cycling import cycles
from leitmotion.discovery.lettering import named
from leitmotion.discovery.moments import Moments, moments_of
from leitmotion.discovery.motion_graph import MotionGraph
from leitmotion.discovery.reducing import reduced
from leitmotion.discovery.states import Stop, apart_of, askew, cluster, straight, visits
from leitmotion.discovery.turning import centres, halts
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
        Without a state where nothing recurs, turns back or keeps still.

    Raises
    ------
    ParameterError
        When there is no recording, or the chains are of different links.
    """
    if not chains:
        raise ParameterError("A motion graph is of one recording at least, got none.")
    for chain in chains[1:]:
        if chain.names != chains[0].names:
            raise ParameterError(
                f"The recordings must have the same links, got {', '.join(chains[0].names)} and {', '.join(chain.names)}."
            )
    moments = moments_of(chains, weights=weights)
    floor = askew(moments)
    mirror = straight(moments.mirror, floor)
    candidates, extents = _candidates(moments, mirror)
    stops: list[list[Stop]] = [[] for _ in chains]
    confidence, alike = 0.0, moments.half
    if candidates:
        alike = apart_of(moments, candidates, extents)
        orbits = cluster(moments, candidates, alike)
        stops, confidence = visits(moments, orbits), orbits.confidence
    stops, gone, courses = reduced(stops, Atlas(moments))
    rates = tuple(chain.rate for chain in chains)
    states, paths = named(stops, gone, courses, moments, rates)
    return MotionGraph(
        states,
        paths,
        tuple(names) if names else tuple(f"recording {k + 1}" for k in range(len(chains))),
        rates,
        confidence,
        {
            "alike_deg": round(float(np.degrees(alike)), 2),
            "half_alike_deg": round(float(np.degrees(moments.half)), 2),
            "lopsided_by_deg": round(float(np.degrees(floor)), 2),
            "moments_per_s": round(moments.rate, 3),
        },
    )


def _candidates(moments: Moments, mirror: np.ndarray) -> tuple[list[int], list[float]]:
    """Moments at which a state may be, in order, and how far the cycles lead that halt nowhere."""
    lopsided = np.diagonal(mirror)
    found, extents = [], []
    for start, stop in pairwise(moments.starts.tolist()):
        at = sorted({*halts(moments, start, stop), *centres(moments, lopsided, start, stop)})
        round_ = cycles(moments, mirror, at, start, stop)
        found += [*at, *(cycle.state for cycle in round_)]
        extents += [cycle.extent for cycle in round_]
    return sorted(set(found)), extents
