"""Racemizing: growing a motion graph by the mirror images of its states and paths (paper S, section 3.6.2)."""

from __future__ import annotations

from leitmotion.discovery.motion_graph import MotionGraph, Path, State


def racemized(graph: MotionGraph) -> MotionGraph:
    """Add the mirror image of every state and path, where the reflected graph shares a state with the graph.

    Whoever can go a path can go its mirror image, and reaches it where both graphs have a state in common: a symmetric
    one, or one whose mirror image was visited as well. A part of the graph that shares none is left as it is, since
    nobody was seen to get from it to its image; ``parameters["racemized"]`` tells whether all, a part or nothing of the
    graph was reflected.

    Parameters
    ----------
    graph : MotionGraph
        As it was performed, or racemized.

    Returns
    -------
    MotionGraph
        With states and paths that have no visits behind those that have.

    Examples
    --------
    >>> from leitmotion.discovery.motion_graph import Visit
    >>> once = (Visit(0, 0, 9),)
    >>> states = (State("A", False, once), State("X", True, once, "X"))
    >>> paths = (Path("ax", "A", "X", False, True, once),)
    >>> whole = racemized(MotionGraph(states, paths, ("turn",), (30.0,), 1.0, {}))
    >>> [state.name for state in whole.states], [path.name for path in whole.paths]
    (['A', 'X', 'A*'], ['ax', '(ax)*'])
    """
    states = {state.name: state for state in graph.states}
    parts = _parts(graph)
    joined = [part for part in parts if any(states[name].mirror for name in part)]
    reached = {name for part in joined for name in part}
    image = {name: name if states[name].symmetric else starred(name) for name in states}
    new_states = [
        state.replace(mirror=image[state.name]) if state.name in reached else state for state in graph.states
    ]
    new_states += [
        State(image[name], False, (), name)
        for name in states
        if name in reached and image[name] not in states
    ]
    paths = {path.name: path for path in graph.paths}
    new_paths, made = [], []
    for path in graph.paths:
        if path.source not in reached or path.mirror:
            new_paths.append(path)
            continue
        name = starred(path.name)
        new_paths.append(path.replace(mirror=name))
        if name not in paths:
            made.append(
                Path(name, image[path.source], image[path.target], False, path.reversible, (), path.name)
            )
    share = "all" if len(joined) == len(parts) else "a part" if joined else "nothing"
    return graph.replace(
        states=tuple(new_states),
        paths=(*new_paths, *made),
        parameters=graph.parameters | {"racemized": share},
    )


def starred(name: str) -> str:
    """Name the mirror image of an asymmetric state or of a path.

    Examples
    --------
    >>> [starred(name) for name in ("A", "A*", "ax", "(ax)*")]
    ['A*', 'A', '(ax)*', 'ax']
    """
    if name.startswith("("):
        return name[1:].removesuffix(")*")
    if name[0].isupper():
        return name.removesuffix("*") if name.endswith("*") else name + "*"
    return f"({name})*"


def _parts(graph: MotionGraph) -> list[set[str]]:
    """The states that hang together by paths."""
    parts: list[set[str]] = [{state.name} for state in graph.states]
    for path in graph.paths:
        touched = [part for part in parts if part & {path.source, path.target}]
        parts = [part for part in parts if part not in touched] + [set().union(*touched)]
    return parts
