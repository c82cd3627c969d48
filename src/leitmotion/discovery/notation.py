"""Notation: a motion graph written in a line, as paper S writes it.

Conventions
-----------
A bar over what is symmetric is the combining macron U+0304, over a state and over the first letter of a path: X̄, x̄y.
``→`` stands behind a path that was gone one way, ``↔`` behind one that was gone both ways. What only reflection made
stands last, behind the reflection operator W. *Plain* notation is ASCII: ``X_``, ``->``, ``<->``.
"""

from __future__ import annotations

from collections.abc import Callable

from leitmotion.discovery.motion_graph import MotionGraph, Path, State

BAR = "\u0304"
SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def notation(graph: MotionGraph) -> str:
    """Write a motion graph as paper S does: states, then paths, each in the order of their first visits.

    Parameters
    ----------
    graph : MotionGraph
        States and paths.

    Returns
    -------
    str
        "A, X̄, A*; ax ↔, (ax)* ↔"; empty of a graph without states.

    Examples
    --------
    >>> from leitmotion.discovery.motion_graph import Visit
    >>> state = State("X", True, (Visit(0, 0, 1),), "X")
    >>> path = Path("xx", "X", "X", True, False, (Visit(0, 0, 30),), "xx")
    >>> graph = MotionGraph((state,), (path,), ("butterfly",), (30.0,), 1.0, {})
    >>> notation(graph), plain_notation(graph)
    ('X̄; x̄x →', 'X_; xx_ ->')
    """
    return _written(graph, state_label, path_label, "→", "↔")


def plain_notation(graph: MotionGraph) -> str:
    """Write a motion graph in ASCII, for terminals that cannot show bars and arrows.

    Parameters
    ----------
    graph : MotionGraph
        States and paths.

    Returns
    -------
    str
        "A, X_, A*; ax <->, (ax)* <->".
    """
    return _written(
        graph,
        lambda state: state.name + "_" * state.symmetric,
        lambda path: path.name + "_" * path.symmetric,
        "->",
        "<->",
    )


def performed(graph: MotionGraph, recording: int = 0) -> str:
    """Write what was done in one recording: the state in which it begins, then the paths in order.

    Parameters
    ----------
    graph : MotionGraph
        States and paths.
    recording : int
        Which of its recordings.

    Returns
    -------
    str
        "A aa aa ax (ax)* (aa)*"; empty where the recording visits no state.
    """
    states = [(v.start, s) for s in graph.states for v in s.visits if v.recording == recording]
    paths = [(v.start, p) for p in graph.paths for v in p.visits if v.recording == recording]
    first = [state_label(state) for _, state in sorted(states, key=lambda each: each[0])[:1]]
    return " ".join(first + [path_label(path) for _, path in sorted(paths, key=lambda each: each[0])])


def state_label(state: State) -> str:
    """Write a state: a bar stands over one that is symmetric.

    Examples
    --------
    >>> state_label(State("X", True, (), "X"))
    'X̄'
    """
    return _barred(state.name) if state.symmetric else state.name


def path_label(path: Path) -> str:
    """Write a path: a bar over its first letter where it is symmetric, figures beneath the line.

    Examples
    --------
    >>> path_label(Path("xy2", "X", "Y", True, True, (), "xy2"))
    'x̄y₂'
    """
    name = path.name.translate(SUBSCRIPTS)
    return _barred(name) if path.symmetric else name


def _barred(name: str) -> str:
    return name[0] + BAR + name[1:]


def _written(
    graph: MotionGraph, state: Callable[[State], str], path: Callable[[Path], str], one: str, both: str
) -> str:
    def line(states: list[State], paths: list[Path]) -> str:
        told = [", ".join(state(each) for each in states)] if states else []
        ways = ", ".join(f"{path(each)} {both if each.reversible else one}" for each in paths)
        return "; ".join(told + ([ways] if ways else []))

    seen = line([s for s in graph.states if s.visits], [p for p in graph.paths if not p.reflected])
    made = line([s for s in graph.states if not s.visits], [p for p in graph.paths if p.reflected])
    return f"{seen}; W: {made}" if made else seen
