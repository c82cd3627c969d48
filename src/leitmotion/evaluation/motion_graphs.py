"""Is a motion graph right: it has the states and paths of the true one, whatever their letters.

References
----------
Paper S, section 3.5: symmetric states, their mirror images, and paths that are gone one way or both.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import permutations
from typing import NamedTuple


class GraphState(NamedTuple):
    """A node: its mirror image is itself when it is symmetric, and empty where the graph does not hold it."""

    name: str
    symmetric: bool
    mirror: str = ""


class GraphPath(NamedTuple):
    """An edge, from state to state; of a reversible one the order does not matter."""

    source: str
    target: str
    symmetric: bool
    reversible: bool


class GraphShape(NamedTuple):
    """States and paths of a motion graph, without letters that matter."""

    states: Sequence[GraphState]
    paths: Sequence[GraphPath]


def same_graph(a: GraphShape, b: GraphShape) -> bool:
    """Tell whether two motion graphs are one but for the letters of their states.

    Parameters
    ----------
    a, b : GraphShape
        What was visited; what only reflection made is left out by the caller.

    Returns
    -------
    bool
        Whether some renaming of the states, which keeps what is symmetric and what mirrors what, makes the paths of
        one those of the other: their ends, symmetric or not, gone one way or both, and how many there are.

    Examples
    --------
    >>> from leitmotion.evaluation import GraphPath, GraphShape, GraphState, same_graph
    >>> jacks = GraphShape(
    ...     [GraphState("X", True, "X"), GraphState("Y", True, "Y")], [GraphPath("X", "Y", True, True)]
    ... )
    >>> renamed = GraphShape(
    ...     [GraphState("T", True, "T"), GraphState("X", True, "X")], [GraphPath("X", "T", True, True)]
    ... )
    >>> same_graph(jacks, renamed), same_graph(jacks, GraphShape(jacks.states, []))
    (True, False)
    """
    if len(a.states) != len(b.states) or len(a.paths) != len(b.paths):
        return False
    if _kinds(a) != _kinds(b):
        return False
    wanted = _edges(b, {state.name: state.name for state in b.states})
    for order in permutations(b.states):
        renamed = {old.name: new.name for old, new in zip(a.states, order, strict=True)}
        if all(
            old.symmetric == new.symmetric and renamed.get(old.mirror, "") == new.mirror
            for old, new in zip(a.states, order, strict=True)
        ) and (_edges(a, renamed) == wanted):
            return True
    return False


def _kinds(graph: GraphShape) -> tuple[Counter[bool], Counter[tuple[bool, bool]]]:
    """Count what no renaming changes, so that few renamings need be tried."""
    return (
        Counter(state.symmetric for state in graph.states),
        Counter((path.symmetric, path.reversible) for path in graph.paths),
    )


def _edges(graph: GraphShape, renamed: dict[str, str]) -> Counter[tuple[str, str, bool, bool]]:
    made: Counter[tuple[str, str, bool, bool]] = Counter()
    for path in graph.paths:
        ends = renamed[path.source], renamed[path.target]
        source, target = sorted(ends) if path.reversible else ends
        made[source, target, path.symmetric, path.reversible] += 1
    return made
