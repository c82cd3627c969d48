"""Composed motions of paper S with their truth, and answers in the same shape, for benchmarks and for fitting.

Seeds 0 to 99 are for fitting a detector, 1000 to 1199 for reporting; no detector may be changed by what it says of the
latter.
"""

from __future__ import annotations

from typing import NamedTuple

from leitmotion.datasets import MOTIONS, ComposedMotif, compose_motif
from leitmotion.discovery import MotionGraph, Symmetry
from leitmotion.evaluation import GoneStep, GraphPath, GraphShape, GraphState, MotifSpan
from leitmotion.motion import Motion

FITTING, REPORTING = range(0, 100), range(1000, 1200)
__all__ = ["FITTING", "MOTIONS", "REPORTING", "Case", "case", "graph_told", "motifs_told"]


class Case(NamedTuple):
    """A motion and what is true of it."""

    motion: Motion
    asked: list[MotifSpan]
    steps: list[GoneStep]
    graph: GraphShape


def case(name: str, seed: int | None) -> Case:
    """Compose a motion that varies, or without a seed the exact one."""
    if seed is None:
        found = compose_motif(name, variation=None)
    else:
        found = compose_motif(name, seed=seed)
    return Case(
        found.motion,
        [MotifSpan(*span) for span in found.spans],
        [GoneStep(*step) for step in found.steps],
        graph_of(found),
    )


def graph_of(found: ComposedMotif) -> GraphShape:
    """Take the shape of a true graph."""
    names = {state.name for state in found.states}

    def mirror(name: str, symmetric: bool) -> str:
        image = name if symmetric else name[:-1] if name.endswith("*") else f"{name}*"
        return image if image in names else ""

    return GraphShape(
        [GraphState(s.name, s.symmetric, mirror(s.name, s.symmetric)) for s in found.states],
        [GraphPath(p.source, p.target, p.symmetric, p.reversible) for p in found.paths],
    )


def motifs_told(told: Symmetry) -> list[MotifSpan]:
    """Take the motifs of an answer."""
    return [
        MotifSpan(s.motif, s.start, s.stop, s.cyclic, s.partner, confidence=s.confidence) for s in told.spans
    ]


def graph_told(told: MotionGraph) -> GraphShape:
    """Take the shape of a graph, without what only reflection made."""
    seen = {state.name for state in told.states if state.visits}
    return GraphShape(
        [
            GraphState(s.name, s.symmetric, s.mirror if s.mirror in seen else "")
            for s in told.states
            if s.visits
        ],
        [GraphPath(p.source, p.target, p.symmetric, p.reversible) for p in told.paths if p.visits],
    )
