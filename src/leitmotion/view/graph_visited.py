"""The most visited part of a motion graph: of a long recording no picture holds the whole."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from leitmotion.discovery import MotionGraph, Path, State

MOST_STATES, MOST_PATHS = 20, 24
"""What one picture holds."""

Item = TypeVar("Item", State, Path)


def most_visited(graph: MotionGraph, *, states: int = MOST_STATES, paths: int = MOST_PATHS) -> MotionGraph:
    """Keep the states that were visited most, and of the paths between them those that were gone most.

    Parameters
    ----------
    graph : MotionGraph
        Any.
    states, paths : int
        How many that somebody performed at most. A mirror image stays with what it is of, and what only reflection made
        is not counted.

    Returns
    -------
    MotionGraph
        In the order of the graph, which itself is given where it has no more.

    Examples
    --------
    >>> from leitmotion.discovery import Visit
    >>> often, once = (Visit(0, 0, 9), Visit(0, 20, 29)), (Visit(0, 10, 19),)
    >>> x, y = State("X", True, once, "X"), State("Y", True, often, "Y")
    >>> [state.name for state in most_visited(MotionGraph((x, y), (), ("one",), (30.0,), 1.0, {}), states=1).states]
    ['Y']
    """
    kept = _most(graph.states, states)
    names = {state.name for state in kept}
    between = [path for path in graph.paths if path.source in names and path.target in names]
    return graph.replace(states=kept, paths=_most(between, paths))


def shown_of(shown: MotionGraph, graph: MotionGraph, words: tuple[str, str] = ("states", "paths")) -> str:
    """Say which part of a graph is shown.

    Parameters
    ----------
    shown : MotionGraph
        What :func:`most_visited` kept.
    graph : MotionGraph
        Of this.
    words : (str, str)
        What states and paths are called.

    Returns
    -------
    str
        A sentence; nothing where all is shown.

    Examples
    --------
    >>> from leitmotion.discovery import Visit
    >>> x, y = (State(name, True, (Visit(0, 0, 9),), name) for name in "XY")
    >>> graph = MotionGraph((x, y), (), ("one",), (30.0,), 1.0, {})
    >>> shown_of(most_visited(graph, states=1), graph)
    'The most visited: 1 of 2 states, 0 of 0 paths.'
    """
    told = [[sum(bool(item.visits) for item in each) for each in (g.states, g.paths)] for g in (shown, graph)]
    if told[0] == told[1]:
        return ""
    (states, paths), (all_states, all_paths) = told
    return f"The most visited: {states} of {all_states} {words[0]}, {paths} of {all_paths} {words[1]}."


def _most(items: Sequence[Item], most: int) -> tuple[Item, ...]:
    """Keep so many performed ones, each together with its mirror image."""
    pairs: dict[frozenset[str], list[Item]] = {}
    for item in items:
        pairs.setdefault(frozenset((item.name, item.mirror or item.name)), []).append(item)
    kept: set[str] = set()
    room = most
    for pair in sorted(pairs.values(), key=lambda pair: -sum(len(item.visits) for item in pair)):
        performed = sum(bool(item.visits) for item in pair)
        if performed <= room:
            room -= performed
            kept |= {item.name for item in pair}
    return tuple(item for item in items if item.name in kept)
