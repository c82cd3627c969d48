"""Sentences about a motion graph: what the page says of its states and paths."""

from __future__ import annotations

from leitmotion.body import Body
from leitmotion.discovery import MotionGraph, Path, State
from leitmotion.view.counting import clock, count_word
from leitmotion.view.graph_names import pieces_of, times

NO_STATES = (
    "No posture was found at which the movement turns back, rests or comes by again, so there is no graph."
)
NOT_COMPUTED = "The motion graph of this recording was not computed."


def no_graph(body: Body, why: str) -> str:
    """Say in a sentence why a recording has no graph to show.

    Parameters
    ----------
    body : Body
        The person.
    why : str
        What was missed when it was drawn.

    Returns
    -------
    str
        The sentence.
    """
    if body.positions.shape[2] == 2:
        return (
            "The motion graph needs joints in three dimensions; this recording has two. Give the same movement "
            "with its depth."
        )
    return f"The motion graph of this recording cannot be drawn: {why}"


def graph_title(graph: MotionGraph) -> str:
    """Say how large a graph is, reflections apart.

    Parameters
    ----------
    graph : MotionGraph
        With a state at least.

    Returns
    -------
    str
        Of a page.

    Examples
    --------
    >>> from leitmotion.discovery import MotionGraph, Visit
    >>> once = (Visit(0, 0, 9),)
    >>> path = Path("aa", "A", "A", False, False, once)
    >>> graph_title(MotionGraph((State("A", False, once),), (path,), (), (), 1.0, {}))
    'One posture, one way back to it'
    """
    states = sum(bool(state.visits) for state in graph.states)
    paths = sum(not path.reflected for path in graph.paths)
    postures = f"{count_word(states).capitalize()} posture{'s' * (states != 1)}"
    ways = f"{count_word(paths)} way{'s' * (paths != 1)}"
    return f"{postures}, {ways} {'back to it' if states == 1 else 'between them'}"


def said(item: State | Path) -> str:
    """Describe a state or a path for those who hear it.

    Parameters
    ----------
    item : State or Path
        Of a graph.

    Returns
    -------
    str
        A phrase.

    Examples
    --------
    >>> said(State("A*", False, (), "A"))
    'State A star, mirror image of A, reflected'
    >>> said(Path("ax", "A", "X", False, True, ()))
    'Path from A to X, both ways, reflected'
    """
    how_often = times(len(item.visits))
    if isinstance(item, State):
        kind = (
            "its own mirror image"
            if item.symmetric
            else f"mirror image of {_spelled(item.mirror)}"
            if item.mirror
            else ""
        )
        return ", ".join(part for part in (f"State {_spelled(item.name)}", kind, how_often) if part)
    kind = "symmetric" if item.symmetric else ""
    which = "".join(piece.text for piece in pieces_of(item) if piece.kind == "below")
    ends = f"Path {which} from".replace("  ", " ") + f" {_spelled(item.source)} to {_spelled(item.target)}"
    ways = "both ways" if item.reversible else ""
    return ", ".join(part for part in (ends, kind, ways, how_often) if part)


def visit_name(item: State | Path, k: int, start: float, stop: float) -> str:
    """Name one visit.

    Parameters
    ----------
    item : State or Path
        Of a graph.
    k : int
        Which of its visits.
    start, stop : float
        Seconds.

    Returns
    -------
    str
        For its bar in the time line.

    Examples
    --------
    >>> from leitmotion.discovery import Visit
    >>> visit_name(Path("ax", "A", "X", False, True, (Visit(0, 0, 30, True),)), 0, 3.2, 4.1)
    'Path from A to X, gone back, 1 of 1, 0:03.2 to 0:04.1'
    """
    parts = [said(item).split(",")[0]]
    if item.visits[k].reversed:
        parts.append("gone back")
    return ", ".join([*parts, f"{k + 1} of {len(item.visits)}", f"{clock(start)} to {clock(stop)}"])


def _spelled(name: str) -> str:
    return name.replace("*", " star")
