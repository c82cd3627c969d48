"""What the Graph view of the page holds: states in their places, paths as curves, and when each was visited.

Conventions
-----------
Lengths are widths of a state, x runs right from the axis of symmetry, y down; times are seconds. What only reflection
made has no visits, and is pictured by the mirror image of its partner.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from leitmotion.body import Body, mirror_role
from leitmotion.discovery import MotionGraph, Path, State, notation
from leitmotion.features import kinematic_chain
from leitmotion.motion import ParameterError
from leitmotion.view.graph_layout import Layout, lay_out
from leitmotion.view.graph_moments import posture_of
from leitmotion.view.graph_names import arrow_of, pieces_of, times
from leitmotion.view.graph_places import CARD
from leitmotion.view.graph_visited import most_visited, shown_of
from leitmotion.view.graph_words import NO_STATES, graph_title, said, visit_name


def graph_payload(body: Body, graph: MotionGraph) -> dict[str, Any]:
    """Turn a motion graph into what the page holds.

    Parameters
    ----------
    body : Body
        The person, with both sides, at the recording's own rate.
    graph : MotionGraph
        Of this recording alone, as it was performed or racemized.

    Returns
    -------
    dict
        The page's ``graph``; its fields are described in ``docs/page.md``.

    Raises
    ------
    ParameterError
        When the graph is of several recordings, or of a longer one.
    """
    if len(graph.recordings) != 1:
        raise ParameterError(
            f"The page shows the graph of one recording, got one of {len(graph.recordings)}."
        )
    items: tuple[State | Path, ...] = (*graph.states, *graph.paths)
    last = max((visit.stop for item in items for visit in item.visits), default=0)
    seconds, covered = last / graph.rates[0], len(body) / body.rate
    if seconds > covered + 1 / body.rate:
        raise ParameterError(f"The graph reaches to {seconds:.2f} s, the recording to {covered:.2f} s.")
    if not any(state.visits for state in graph.states):
        return {"none": NO_STATES}
    layout = lay_out(graph)
    first = most_visited(graph)
    sentence = shown_of(first, graph, ("postures", "ways"))
    chains = [kinematic_chain(body)]
    partners = [mirror_role(role) for role in body.roles]
    return {
        "title": graph_title(graph),
        "lead": [notation(_performed(graph))],
        "box": _rounded(layout.box),
        "most": _places(lay_out(first)) | {"said": sentence} if sentence else None,
        "card": list(CARD),
        "partner": [body.roles.index(role) if role in body.roles else -1 for role in partners],
        "states": [
            _item(state, graph)
            | _pictured(state, graph, chains)
            | {"at": _rounded(layout.places[state.name])}
            for state in graph.states
        ],
        "paths": [
            _item(path, graph)
            | {
                "source": path.source,
                "target": path.target,
                "reversible": path.reversible,
                "arrow": arrow_of(path),
                "curve": [_rounded(point) for point in layout.curves[path.name]],
                "at": _rounded(layout.labels[path.name]),
            }
            for path in graph.paths
        ],
    }


def _performed(graph: MotionGraph) -> MotionGraph:
    """Leave out what only reflection made."""
    return graph.replace(
        states=tuple(state for state in graph.states if state.visits),
        paths=tuple(path for path in graph.paths if not path.reflected),
    )


def _places(layout: Layout) -> dict[str, Any]:
    """Give the places of the states and paths that are shown at first."""
    return {
        "box": _rounded(layout.box),
        "states": {name: {"at": _rounded(place)} for name, place in layout.places.items()},
        "paths": {
            name: {"curve": [_rounded(point) for point in curve], "at": _rounded(layout.labels[name])}
            for name, curve in layout.curves.items()
        },
    }


def _item(item: State | Path, graph: MotionGraph) -> dict[str, Any]:
    rate = graph.rates[0]
    return {
        "name": item.name,
        "pieces": [list(piece) for piece in pieces_of(item)],
        "symmetric": item.symmetric,
        "mirror": item.mirror if item.mirror != item.name else "",
        "said": said(item),
        "times": times(len(item.visits)),
        "visits": [
            {
                "start": visit.start / rate,
                "stop": visit.stop / rate,
                "back": visit.reversed,
                "name": visit_name(item, k, visit.start / rate, visit.stop / rate),
            }
            for k, visit in enumerate(item.visits)
        ],
    }


def _pictured(state: State, graph: MotionGraph, chains: list[Any]) -> dict[str, Any]:
    moment = posture_of(state, graph, chains)
    key = None if moment is None else moment.frame / graph.rates[0]
    return {"key": key, "mirrored": moment is not None and moment.mirrored}


def _rounded(numbers: Any) -> list[float]:
    return [round(float(number), 3) + 0.0 for number in np.ravel(numbers)]
